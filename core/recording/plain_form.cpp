#include "core/recording/plain_form.h"

namespace heft {

namespace {

/// Turns the mirror of one axis back, on force and torque.
void unmirror(const Conventions& conventions, Vector6d& wrench) {
  if (!conventions.mirroredAxis) return;
  const int axis = *conventions.mirroredAxis;
  wrench(axis) = -wrench(axis);
  wrench(3 + axis) = -wrench(3 + axis);
}

}  // namespace

PlainForm::PlainForm(const RecordingMeta& meta)
    : conventions_(meta.conventions), sign_(meta.wrenchSign == WrenchSign::payloadOnSensor ? -1.0 : 1.0) {}

void PlainForm::undoWrench(Eigen::Ref<MatrixXd> wrench) const {
  if (sign_ == 1.0 && conventions_.plain()) return;
  const bool torqueFirst = conventions_.wrenchOrder == Conventions::WrenchOrder::torqueFirst;
  const double torqueSign = conventions_.torqueSign == Conventions::TorqueSign::opposite ? -1.0 : 1.0;
  for (Eigen::Index k = 0; k < wrench.rows(); ++k) {
    const Vector6d read = wrench.row(k).transpose();
    Vector6d plain;
    plain << sign_ * conventions_.force.si * (torqueFirst ? read.tail<3>() : read.head<3>()),
        sign_ * torqueSign * conventions_.torque.si * (torqueFirst ? read.head<3>() : read.tail<3>());
    if (!conventions_.needPose()) {
      // tau' = tau - d x f about a point d from S's origin
      if (conventions_.wrenchPoint.kind == Conventions::WrenchPoint::Kind::offset)
        plain.tail<3>() += conventions_.wrenchPoint.offset.cross(plain.head<3>());
      unmirror(conventions_, plain);
    }
    wrench.row(k) = plain.transpose();
  }
}

Vector6d PlainForm::inSensorAxes(const Vector6d& wrench, const Isometry3d& X_BS) const {
  using Kind = Conventions::WrenchPoint::Kind;
  if (!conventions_.needPose()) return wrench;
  Vector6d plain = wrench;
  // All in S axes first; moving the point and turning the axes change places freely.
  if (conventions_.wrenchAxes == Conventions::WrenchAxes::base)
    plain << X_BS.linear().transpose() * wrench.head<3>(), X_BS.linear().transpose() * wrench.tail<3>();
  const Vector3d force = plain.head<3>();
  if (conventions_.wrenchPoint.kind == Kind::base)
    plain.tail<3>() -= (X_BS.linear().transpose() * X_BS.translation()).cross(force);
  if (conventions_.wrenchPoint.kind == Kind::offset) plain.tail<3>() += conventions_.wrenchPoint.offset.cross(force);
  unmirror(conventions_, plain);
  return plain;
}

void PlainForm::undoQuaternionOrder(Eigen::Ref<MatrixXd> quaternion) const {
  if (conventions_.quaternionOrder == Conventions::QuaternionOrder::xyzw) return;
  const VectorXd w = quaternion.col(0);
  for (int c = 0; c < 3; ++c) quaternion.col(c) = quaternion.col(c + 1);
  quaternion.col(3) = w;
}

void PlainForm::undoDirection(Eigen::Ref<MatrixXd> quaternion) const {
  if (conventions_.pose == Conventions::PoseDirection::baseInSensor)
    quaternion.leftCols<3>() = -quaternion.leftCols<3>();
}

void PlainForm::undoPosition(Eigen::Ref<MatrixXd> position, const Eigen::Ref<const MatrixXd>& quaternion) const {
  if (conventions_.mPerLength != 1.0) position *= conventions_.mPerLength;
  if (conventions_.pose != Conventions::PoseDirection::baseInSensor) return;
  for (Eigen::Index k = 0; k < position.rows(); ++k) {
    const Quaterniond R_BS(quaternion(k, 3), quaternion(k, 0), quaternion(k, 1), quaternion(k, 2));
    position.row(k) = -(R_BS * Vector3d(position.row(k).transpose())).transpose();
  }
}

void PlainForm::undoAngles(Eigen::Ref<MatrixXd> angles) const {
  if (conventions_.radPerAngle != 1.0) angles *= conventions_.radPerAngle;
}

void PlainForm::undoAcceleration(Eigen::Ref<MatrixXd> acceleration) const {
  if (conventions_.mPerS2PerAcceleration != 1.0) acceleration *= conventions_.mPerS2PerAcceleration;
}

void PlainForm::undoTwist(Eigen::Ref<MatrixXd> twist) const {
  if (conventions_.mPerLength != 1.0) twist.leftCols<3>() *= conventions_.mPerLength;
  if (conventions_.radPerAngle != 1.0) twist.rightCols<3>() *= conventions_.radPerAngle;
}

}  // namespace heft
