#include "core/collision/course.h"

#include <algorithm>
#include <cmath>

namespace heft {

namespace {

/// Joints from the root to `link`, outermost first.
std::vector<int> jointsTo(const RobotModel& robot, int link) {
  std::vector<int> out;
  for (int joint = robot.links()[static_cast<std::size_t>(link)].parentJoint; joint >= 0;
       joint = robot.links()[static_cast<std::size_t>(robot.joints()[static_cast<std::size_t>(joint)].parentLink)]
                   .parentJoint)
    out.push_back(joint);
  return out;
}

}  // namespace

Course::Course(const JointMotion& motion)
    : motion_(motion), travelled_(MatrixXd::Zero(motion.size(), motion.q.cols())) {
  for (Eigen::Index k = 0; k + 1 < motion.size(); ++k) {
    const double h = motion.time(k + 1) - motion.time(k);
    for (Eigen::Index j = 0; j < motion.q.cols(); ++j) {
      // The quintic's speed is a polynomial of fourth degree: it stays within its Bernstein coefficients. These are the
      // differences of the position's own, times 5 / h.
      const double p0 = motion.q(k, j), p5 = motion.q(k + 1, j);
      const double p1 = p0 + h * motion.dq(k, j) / 5.0, p4 = p5 - h * motion.dq(k + 1, j) / 5.0;
      const double p2 = 2.0 * p1 - p0 + h * h * motion.ddq(k, j) / 20.0;
      const double p3 = 2.0 * p4 - p5 + h * h * motion.ddq(k + 1, j) / 20.0;
      const double fastest =
          std::max({std::abs(p1 - p0), std::abs(p2 - p1), std::abs(p3 - p2), std::abs(p4 - p3), std::abs(p5 - p4)});
      travelled_(k + 1, j) = travelled_(k, j) + 5.0 * fastest;
    }
  }
}

void Course::at(double t, VectorXd& q) const {
  if (motion_.size() == 1) {
    q = motion_.q.row(0).transpose();
    return;
  }
  VectorXd dq, ddq;
  motion_.at(t, q, dq, ddq);
}

VectorXd Course::movedBy(const VectorXd& reach) const { return travelled_ * reach; }

double Course::untilMoved(const VectorXd& moved, double t, double distance) const {
  const double beyond = motion_.time(motion_.size() - 1) + 1.0;
  if (motion_.size() < 2) return beyond;
  const double* times = motion_.time.data();
  const auto next =
      std::clamp<Eigen::Index>(std::upper_bound(times, times + motion_.size(), t) - times, 1, motion_.size() - 1);
  const auto within = [&](Eigen::Index k, double fraction) { return moved(k) + fraction * (moved(k + 1) - moved(k)); };
  const Eigen::Index k = next - 1;
  const double h = motion_.time(next) - motion_.time(k);
  const double target = within(k, std::clamp((t - motion_.time(k)) / h, 0.0, 1.0)) + distance;
  if (target >= moved(moved.size() - 1)) return beyond;
  const auto after = std::upper_bound(moved.data() + k, moved.data() + moved.size(), target) - moved.data();
  const double share = (target - moved(after - 1)) / (moved(after) - moved(after - 1));
  return motion_.time(after - 1) + share * (motion_.time(after) - motion_.time(after - 1));
}

VectorXd jointReach(const RobotModel& robot, int link, const Eigen::Matrix3Xd& points) {
  VectorXd out = VectorXd::Zero(robot.dof());
  // Farthest that a point is from the origin of the frame that is looked at; outwards frames come first.
  double reach = points.cols() > 0 ? points.colwise().norm().maxCoeff() : 0.0;
  for (const int index : jointsTo(robot, link)) {
    const Joint& joint = robot.joints()[static_cast<std::size_t>(index)];
    if (joint.index >= 0 && joint.type != JointType::fixed) {
      const double per = joint.type == JointType::revolute ? reach : 1.0;
      out(joint.index) = std::max(out(joint.index), std::abs(joint.ratio) * per);
      if (joint.type == JointType::prismatic)
        reach += std::max(std::abs(joint.limits.lower), std::abs(joint.limits.upper));
    }
    reach += joint.X_PJ.translation().norm();
  }
  return out;
}

std::vector<bool> sharedJoints(const RobotModel& robot, int first, int second) {
  const std::vector<int> a = jointsTo(robot, first), b = jointsTo(robot, second);
  std::vector<bool> out(static_cast<std::size_t>(robot.dof()), false);
  for (const int joint : a) {
    const int index = robot.joints()[static_cast<std::size_t>(joint)].index;
    if (index >= 0 && std::ranges::count(b, joint) > 0) out[static_cast<std::size_t>(index)] = true;
  }
  return out;
}

bool changesHeight(const RobotModel& robot, int link, const Vector3d& normal) {
  constexpr double kParallel = 1e-9;  // Of sine or cosine
  // Turns about parallel axes leave these axes where they point, so that one posture tells for all.
  std::vector<Isometry3d> X_BL;
  robot.linkPoses(robot.homePosture(), X_BL);
  for (const int index : jointsTo(robot, link)) {
    const Joint& joint = robot.joints()[static_cast<std::size_t>(index)];
    if (joint.index < 0) continue;
    const Vector3d axis = X_BL[static_cast<std::size_t>(joint.parentLink)].linear() * joint.X_PJ.linear() * joint.axis;
    const double off = joint.type == JointType::prismatic ? std::abs(axis.dot(normal)) : axis.cross(normal).norm();
    if (off > kParallel) return true;
  }
  return false;
}

}  // namespace heft
