#include "core/simulation/guided_arm.h"

#include <algorithm>
#include <cmath>

namespace heft {

namespace {

constexpr double kPull = 4.0;                      ///< [1/s] Speed for each metre or radian that the hand is ahead
constexpr double kYield = 10.0;                    ///< [1/s] How fast the arm takes a speed up
constexpr double kSoft = 50.0;                     ///< [1/s] How fast it takes an acceleration up
constexpr double kJointShare = 0.7;                ///< Of a joint's speed
constexpr double kBraking = 0.25;                  ///< Of a joint's acceleration, for stopping before its end
constexpr double kLength = 0.3;                    ///< [m] that counts like a radian
constexpr double kDamping = 0.06;                  ///< Of the inverse at a singularity
constexpr double kSingular = 0.02;                 ///< Manipulability below which it is damped
constexpr double kHomewards = 0.4;                 ///< [1/s] Where the elbow is free it goes towards the home posture
constexpr double kJointSpeed = 0.6;                ///< [rad/s] On the way to a path's beginning
constexpr double kHandLinearAcceleration = 10.0;   ///< [m/s2] Below what cartesianLoad allows
constexpr double kHandAngularAcceleration = 20.0;  ///< [rad/s2]

using Jacobian = Eigen::Matrix<double, 6, Eigen::Dynamic>;

/// Scales a joint vector down until the tool's linear and angular part keep their caps.
void scaleToCaps(const Jacobian& J, double linear, double angular, VectorXd& rates) {
  const Vector6d twist = J * rates;
  const double load = std::max(twist.head<3>().norm() / linear, twist.tail<3>().norm() / angular);
  if (load > 1.0) rates /= load;
}

}  // namespace

GuidedArm::GuidedArm(const RobotModel& robot, const ToolFrame& tool)
    : robot_(&robot),
      tool_(tool),
      rooms_(jointRooms(robot, robot.homePosture())),
      home_(robot.homePosture()),
      q_(home_) {
  dq_.setZero(q_.size());
  ddq_.setZero(q_.size());
  target_ = pose();
}

Isometry3d GuidedArm::pose() const { return robot_->linkPose(q_, tool_.link) * tool_.X_LS; }

void GuidedArm::pullTo(const Isometry3d& X_BS) {
  target_ = X_BS;
  mode_ = Mode::pulled;
}

Isometry3d GuidedArm::pulledTo() const { return mode_ == Mode::pulled ? target_ : pose(); }

void GuidedArm::letGo() { mode_ = Mode::resting; }

void GuidedArm::wander() {
  if (mode_ == Mode::wandering) return;
  target_ = pose();
  clock_ = 0.0;
  mode_ = Mode::wandering;
}

void GuidedArm::follow(GuidedPath path) {
  path_ = std::move(path);
  VectorXd dq(q_.size()), ddq(q_.size());
  pathStart_.resize(q_.size());
  path_.at(0.0, pathStart_, dq, ddq);
  mode_ = Mode::approaching;
  clock_ = 0.0;
}

void GuidedArm::goTo(const VectorXd& q) {
  path_ = {};
  pathStart_ = q;
  mode_ = Mode::approaching;
  clock_ = 0.0;
}

bool GuidedArm::atRest() const {
  return mode_ == Mode::resting && dq_.cwiseAbs().maxCoeff() < 1e-3 && ddq_.cwiseAbs().maxCoeff() < 1e-2;
}

double GuidedArm::followed() const {
  return mode_ == Mode::following && path_.duration > 0.0 ? std::min(1.0, clock_ / path_.duration) : 0.0;
}

Isometry3d GuidedArm::wanderedTo() const {
  // Frequencies without common periods: the motion does not repeat for minutes.
  const double t = clock_, fade = minimumJerk(t / 1.5).value;
  const auto wave = [t](double hz, double phase) { return std::sin(2.0 * 3.14159265358979323846 * hz * t + phase); };
  const Vector3d turn(0.40 * wave(0.23, 0.0) + 0.25 * wave(0.71, 1.0), 0.40 * wave(0.19, 2.0) + 0.25 * wave(0.61, 0.5),
                      0.50 * wave(0.29, 1.5) + 0.30 * wave(0.83, 0.0));
  const Vector3d shift(0.05 * wave(0.17, 0.3), 0.06 * wave(0.13, 1.1), 0.05 * wave(0.31, 2.2));
  Isometry3d X = target_;
  X.translation() += fade * shift;
  X.linear() = target_.linear() * rotationFromVector(fade * turn);
  return X;
}

VectorXd GuidedArm::velocityTowards(const Isometry3d& X_BS) const {
  const Isometry3d X_now = pose();
  Vector3d v = kPull * (X_BS.translation() - X_now.translation());
  Vector3d w = kPull * (X_now.linear() * vectorFromRotation(X_now.linear().transpose() * X_BS.linear()));
  if (v.norm() > kGuidedSpeed) v *= kGuidedSpeed / v.norm();
  if (w.norm() > kGuidedTurningRate) w *= kGuidedTurningRate / w.norm();
  Jacobian J = robot_->jacobian(tool_.link, tool_.X_LS, q_);
  Vector6d twist;
  twist << v, kLength * w;
  J.bottomRows<3>() *= kLength;
  // Damped least squares: near a singularity the arm gives way instead of running.
  Eigen::Matrix<double, 6, 6> A = J * J.transpose();
  const double manipulability = std::sqrt(std::max(0.0, A.determinant()));
  if (manipulability < kSingular) {
    const double share = 1.0 - manipulability / kSingular;
    A.diagonal().array() += kDamping * kDamping * share * share + 1e-9;
  }
  const Eigen::LDLT<Eigen::Matrix<double, 6, 6>> solver(A);
  VectorXd dq = J.transpose() * solver.solve(twist);
  const VectorXd homewards = kHomewards * (home_ - q_);
  dq += homewards - J.transpose() * solver.solve(J * homewards);
  return dq;
}

VectorXd GuidedArm::wantedVelocity() {
  switch (mode_) {
    case Mode::pulled:
      return velocityTowards(target_);
    case Mode::wandering:
      return velocityTowards(wanderedTo());
    case Mode::approaching: {
      VectorXd dq = kPull * (pathStart_ - q_);
      const double fastest = dq.cwiseAbs().maxCoeff();
      if (fastest > kJointSpeed) dq *= kJointSpeed / fastest;
      return dq;
    }
    case Mode::resting:
    case Mode::following:
      break;
  }
  return VectorXd::Zero(q_.size());
}

void GuidedArm::limitVelocity(VectorXd& dq) const {
  for (Eigen::Index j = 0; j < dq.size(); ++j) {
    const JointRoom& room = rooms_[static_cast<std::size_t>(j)];
    const double fastest = kJointShare * room.velocity, braking = kBraking * room.acceleration;
    // A speed from which the joint stops before its end; 30 ms pass until it begins to brake.
    const auto allowed = [&](double left) {
      const double way = std::max(0.0, left - 0.03 * std::abs(dq_(j)));
      return std::min(fastest, std::sqrt(2.0 * braking * way));
    };
    dq(j) = std::clamp(dq(j), -allowed(q_(j) - room.lower), allowed(room.upper - q_(j)));
  }
  scaleToCaps(robot_->jacobian(tool_.link, tool_.X_LS, q_), kGuidedSpeed, kGuidedTurningRate, dq);
}

void GuidedArm::limitAcceleration(VectorXd& ddq) const {
  double load = 1.0;
  for (Eigen::Index j = 0; j < ddq.size(); ++j)
    load = std::max(load, std::abs(ddq(j)) / (0.9 * rooms_[static_cast<std::size_t>(j)].acceleration));
  ddq /= load;
  scaleToCaps(robot_->jacobian(tool_.link, tool_.X_LS, q_), kHandLinearAcceleration, kHandAngularAcceleration, ddq);
}

void GuidedArm::brakeBeforeEnds(VectorXd& ddq) const {
  // Scaling all accelerations alike may have taken from a joint what it needs to stop in time.
  for (Eigen::Index j = 0; j < ddq.size(); ++j) {
    const JointRoom& room = rooms_[static_cast<std::size_t>(j)];
    const double left = dq_(j) > 0.0 ? room.upper - q_(j) : q_(j) - room.lower;
    const double way = std::max(1e-4, left - 0.03 * std::abs(dq_(j)));
    const double needed = dq_(j) * dq_(j) / (2.0 * way);
    if (needed < kBraking * room.acceleration) continue;
    const double braking = std::min(0.9 * room.acceleration, 1.3 * needed);
    ddq(j) = dq_(j) > 0.0 ? std::min(ddq(j), -braking) : std::max(ddq(j), braking);
  }
}

void GuidedArm::step(double dt) {
  if (mode_ == Mode::following) {
    clock_ += dt;
    path_.at(std::min(clock_, path_.duration), q_, dq_, ddq_);
    q_ += pathOffset_;
    if (clock_ < path_.duration) return;
    dq_.setZero();
    ddq_.setZero();
    mode_ = Mode::resting;
    return;
  }
  if (mode_ == Mode::wandering) clock_ += dt;
  VectorXd dq = wantedVelocity();
  limitVelocity(dq);
  VectorXd ddq = kYield * (dq - dq_);
  limitAcceleration(ddq);
  brakeBeforeEnds(ddq);
  const VectorXd jerk = (ddq - ddq_) * std::min(kSoft, 1.0 / dt);
  q_ += dt * dq_ + (0.5 * dt * dt) * ddq_ + (dt * dt * dt / 6.0) * jerk;
  dq_ += dt * ddq_ + (0.5 * dt * dt) * jerk;
  ddq_ += dt * jerk;
  if (mode_ != Mode::approaching || (q_ - pathStart_).cwiseAbs().maxCoeff() > 2e-4 ||
      dq_.cwiseAbs().maxCoeff() > 5e-4 || ddq_.cwiseAbs().maxCoeff() > 5e-3)
    return;
  pathOffset_ = q_ - pathStart_;
  mode_ = path_.at ? Mode::following : Mode::resting;
}

}  // namespace heft
