#pragma once
// One factory a cause.
#include <memory>

#include "core/diagnosis/model/cause.h"

namespace heft::diagnosis {

std::unique_ptr<Cause> makeBiasDrift();
std::unique_ptr<Cause> makeCablePull();
std::unique_ptr<Cause> makeConstantPull();
std::unique_ptr<Cause> makeCoulombFriction();
std::unique_ptr<Cause> makeCrosstalk();
std::unique_ptr<Cause> makeDerivativeNoise();
std::unique_ptr<Cause> makeFlexibleMount();
std::unique_ptr<Cause> makeGainError();
std::unique_ptr<Cause> makeGravityTilt();
std::unique_ptr<Cause> makeHysteresis();
std::unique_ptr<Cause> makeJointOffset();
std::unique_ptr<Cause> makeLeverArm();
std::unique_ptr<Cause> makeLooseMass();
std::unique_ptr<Cause> makeLowPassLag();
std::unique_ptr<Cause> makeMotionLag();
std::unique_ptr<Cause> makePayloadChange();
std::unique_ptr<Cause> makeSaturation();
std::unique_ptr<Cause> makeSensorBias();
std::unique_ptr<Cause> makeSensorRotation();
std::unique_ptr<Cause> makeTimeOffset();
std::unique_ptr<Cause> makeTouch();
std::unique_ptr<Cause> makeViscousDrag();
std::unique_ptr<Cause> makeRandomWalk();

std::unique_ptr<Cause> makeSpikes();
std::unique_ptr<Cause> makeDropouts();
std::unique_ptr<Cause> makeJitter();
std::unique_ptr<Cause> makeQuantisation();
std::unique_ptr<Cause> makeFrameError();

}  // namespace heft::diagnosis
