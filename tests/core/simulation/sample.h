#pragma once
#include "core/simulation/simulate.h"

namespace heft {

/// A physical tool of 0.2 to 1.5 kg: box-like, hanging along z.
inline Payload sampleTool(double mass = 0.75) {
  Payload payload;
  payload.mass = mass;
  payload.com = {0.01, -0.02, 0.08};
  const Vector3d size{0.06, 0.09, 0.18};
  const Vector3d squares = size.cwiseAbs2();
  payload.inertiaCom =
      (mass / 12.0 * Vector3d(squares.y() + squares.z(), squares.x() + squares.z(), squares.x() + squares.y()))
          .asDiagonal();
  const Matrix3d R = rotationFromRpy({0.3, -0.2, 0.5});
  const Matrix3d I = R * payload.inertiaCom * R.transpose();
  payload.inertiaCom = 0.5 * (I + I.transpose());
  return payload;
}

inline SimulateOptions optionsFor(MotionKind motion, std::uint64_t seed, double duration = 20.0) {
  SimulateOptions options;
  options.motion = motion;
  options.seed = seed;
  options.duration = duration;
  return options;
}

inline constexpr MotionKind kKinds[] = {MotionKind::excitation, MotionKind::pickAndPlace, MotionKind::free};

}  // namespace heft
