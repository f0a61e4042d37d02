#include "core/diagnosis/causes/catalogue.h"

#include <utility>

#include "core/diagnosis/causes/causes.h"

namespace heft::diagnosis {

namespace {

std::vector<std::unique_ptr<Cause>>& fitted() {
  static std::vector<std::unique_ptr<Cause>> causes = [] {
    std::vector<std::unique_ptr<Cause>> all;
    for (const auto make :
         {makeSensorBias,      makeBiasDrift,  makeTimeOffset,    makeLowPassLag,    makeSensorRotation,
          makeGravityTilt,     makeGainError,  makeCrosstalk,     makeCablePull,     makeViscousDrag,
          makeCoulombFriction, makeLooseMass,  makePayloadChange, makeTouch,         makeJointOffset,
          makeMotionLag,       makeLeverArm,   makeConstantPull,  makeFlexibleMount, makeDerivativeNoise,
          makeHysteresis,      makeSaturation, makeRandomWalk})
      all.push_back(make());
    return all;
  }();
  return causes;
}

}  // namespace

const std::vector<std::unique_ptr<Cause>>& catalogue() { return fitted(); }

const std::vector<std::unique_ptr<Cause>>& seenDirectly() {
  static const std::vector<std::unique_ptr<Cause>> kAll = [] {
    std::vector<std::unique_ptr<Cause>> all;
    for (const auto make : {makeSpikes, makeDropouts, makeJitter, makeQuantisation, makeFrameError})
      all.push_back(make());
    return all;
  }();
  return kAll;
}

const Cause* findCause(std::string_view id) {
  for (const auto* list : {&catalogue(), &seenDirectly()})
    for (const auto& cause : *list)
      if (cause->id() == id) return cause.get();
  return nullptr;
}

const CauseInfo& infoOf(std::string_view id) {
  static constexpr CauseInfo kUnknown{};
  const Cause* cause = findCause(id);
  return cause ? cause->info() : kUnknown;
}

void registerCause(std::unique_ptr<Cause> cause) { fitted().push_back(std::move(cause)); }

}  // namespace heft::diagnosis
