#include "core/diagnosis/causes/catalogue.h"

#include "core/diagnosis/causes/causes.h"

namespace heft::diagnosis {

const std::vector<std::unique_ptr<Cause>>& catalogue() {
  static const std::vector<std::unique_ptr<Cause>> kAll = [] {
    std::vector<std::unique_ptr<Cause>> all;
    for (const auto make :
         {makeSensorBias,      makeBiasDrift,  makeTimeOffset,    makeLowPassLag,    makeSensorRotation,
          makeGravityTilt,     makeGainError,  makeCrosstalk,     makeCablePull,     makeViscousDrag,
          makeCoulombFriction, makeLooseMass,  makePayloadChange, makeTouch,         makeJointOffset,
          makeMotionLag,       makeLeverArm,   makeConstantPull,  makeFlexibleMount, makeDerivativeNoise,
          makeHysteresis,      makeSaturation, makeWandering})
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

}  // namespace heft::diagnosis
