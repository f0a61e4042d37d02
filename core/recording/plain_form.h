#pragma once
// From the conventions that a file states to the plain form, number by number: for recordings, streams before they are
// joined, and live samples.
#include "core/recording/recording.h"

namespace heft {

/// Undoes Conventions and the wrench's sign. Rows are samples, columns as in Recording; what is plain stays bit by bit.
class PlainForm {
 public:
  explicit PlainForm(const RecordingMeta& meta);

  /// To forces first, N and N m, sensorOnPayload, torque's sign as the force's; where no pose is needed, to S axes
  /// about S's origin, too. Works in place.
  void undoWrench(Eigen::Ref<MatrixXd> wrench) const;
  /// The rest where Conventions::needPose(): to S axes about S's origin. `X_BS`: the sensor's pose then.
  Vector6d inSensorAxes(const Vector6d& wrench, const Isometry3d& X_BS) const;
  /// To x, y, z, w.
  void undoQuaternionOrder(Eigen::Ref<MatrixXd> quaternion) const;
  /// From R_SB to R_BS where the pose is the base's in the sensor; columns x, y, z, w.
  void undoDirection(Eigen::Ref<MatrixXd> quaternion) const;
  /// From p_SBo_S to p_BSo_B, in m, given R_BS (columns x, y, z, w of unit length) in the same rows.
  void undoPosition(Eigen::Ref<MatrixXd> position, const Eigen::Ref<const MatrixXd>& quaternion) const;
  /// To rad or rad/s.
  void undoAngles(Eigen::Ref<MatrixXd> angles) const;
  /// To m/s2.
  void undoAcceleration(Eigen::Ref<MatrixXd> acceleration) const;
  /// v to m/s, w to rad/s. A twist beside a pose of the base in the sensor cannot be told and has to be left out.
  void undoTwist(Eigen::Ref<MatrixXd> twist) const;
  bool twistIsLost() const { return conventions_.pose == Conventions::PoseDirection::baseInSensor; }

 private:
  Conventions conventions_;
  double sign_;
};

}  // namespace heft
