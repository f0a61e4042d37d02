// Every cause that is fitted to the residual. What a single sample shows is in sample_tests.h; contact in contact.h.
#include <cmath>

#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/common.h"

namespace heft::diagnosis {

const std::vector<std::unique_ptr<Cause>>& catalogue() {
  static const std::vector<std::unique_ptr<Cause>> kAll = [] {
    std::vector<std::unique_ptr<Cause>> all;
    for (const auto make :
         {makeSensorBias, makeBiasDrift, makeTimeOffset, makeLowPassLag, makeSensorRotation, makeGravityTilt, makeGainError,
          makeCrosstalk, makeCablePull, makeViscousDrag, makeCoulombFriction, makeLooseMass, makePayloadChange, makeJointOffset,
          makeMotionLag, makeLeverArm, makeConstantPull, makeFlexibleMount, makeDerivativeNoise, makeHysteresis, makeWandering})
      all.push_back(make());
    return all;
  }();
  return kAll;
}

const Cause* findCause(std::string_view id) {
  for (const auto& cause : catalogue())
    if (cause->id() == id) return cause.get();
  return nullptr;
}

std::string plusMinus(double value, double std) {
  if (!(std > 0.0) || !std::isfinite(std)) return fmt::format("{:.3g}", value);
  const int digits = std::max(0, static_cast<int>(std::ceil(-std::log10(std))));
  return fmt::format("{:.{}f} ± {:.{}f}", value, digits, std, digits);
}

}  // namespace heft::diagnosis
