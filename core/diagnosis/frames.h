#pragma once
// Mistakes with frames and signs: they are too large to be small corrections, so they are tried out one by one.
#include <optional>

#include "core/diagnosis/fit.h"

namespace heft::diagnosis {

struct FrameMistake {
  /// Readings in true sensor axes = turn * readings as stated; or gravity = turn * gravity as stated
  Matrix3d turn = Matrix3d::Identity();
  Vector3d turnStd = Vector3d::Zero();  ///< Of a turned mount [rad]
  double rmsBefore = 0;                 ///< Force [N]
  double angle = 0;                     ///< Of a turned mount or gravity [rad]; 0 for other mistakes
  enum class Kind {
    none,
    gravitySign,
    gravityTurned,
    wrenchSign,
    transposed,
    quaternionOrder,
    turned,
    mirrored
  } kind = Kind::none;

  /// What was told about the sensor's orientation: velocities and accelerations are made of it.
  bool ofOrientation() const { return kind == Kind::transposed || kind == Kind::quaternionOrder; }
  bool ofGravity() const { return kind == Kind::gravitySign || kind == Kind::gravityTurned; }
  /// What takes forces and torques as read, each by itself, to what they are: a turn, proper or not.
  Matrix3d ofReadings() const;
  /// Gravity [m/s2] as it is where it was told as `stated`, base axes.
  Vector3d gravity(const Vector3d& stated) const;
};

/// The mistake that, undone, leaves at most two fifths of the force that is left in a usual block of `stretches`,
/// whatever pushes in fewer than half of them; nothing if the recording is understood as stated. `null`: the fit of
/// bias and payload to all of them.
std::optional<FrameMistake> frameMistake(const Signals& signals, const std::vector<Stretch>& stretches,
                                         const Fit& null);

/// The signals as they would be without it.
Signals corrected(const Signals& signals, const FrameMistake& mistake);
/// The same of what a sensor sees of a motion, for any mistake but one of the orientation. `gravity` as stated.
Motion corrected(Motion motion, const Vector3d& gravity, const FrameMistake& mistake);

}  // namespace heft::diagnosis
