#include "tests/support/as_driver.h"

#include <cmath>
#include <numbers>
#include <random>
#include <sstream>
#include <stdexcept>

#include "core/wrench/regressor.h"

namespace heft::test {

namespace {

std::vector<Isometry3d> posesOf(const RobotModel& robot, const Recording& recording) {
  std::vector<Isometry3d> out;
  const auto link = robot.findLink(recording.meta.mount.parent);
  if (recording.hasJoints() && !link) throw std::runtime_error("no link " + recording.meta.mount.parent);
  const Isometry3d X_LS = poseFromXyzRpy(recording.meta.mount.xyz, recording.meta.mount.rpy);
  for (Eigen::Index k = 0; k < recording.rows(); ++k) {
    if (recording.hasJoints()) {
      out.push_back(robot.linkPose(recording.q.row(k).transpose(), *link) * X_LS);
    } else {
      Isometry3d X = Isometry3d::Identity();
      const auto q = recording.quaternion.row(k);
      X.linear() = Quaterniond(q(3), q(0), q(1), q(2)).toRotationMatrix();
      if (recording.hasPosition()) X.translation() = recording.position.row(k).transpose();
      out.push_back(X);
    }
  }
  return out;
}

double uniform(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random() >> 11) / 9007199254740992.0);
}

double normal(std::mt19937_64& random) {
  const double u = uniform(random, 1e-12, 1.0), v = uniform(random, 0.0, 2.0 * std::numbers::pi);
  return std::sqrt(-2.0 * std::log(u)) * std::cos(v);
}

Vector3d direction(std::mt19937_64& random) {
  return Vector3d{normal(random), normal(random), normal(random)}.normalized();
}

template <class Each>
void eachWrench(Recording& recording, const Each& each) {
  for (Eigen::Index k = 0; k < recording.rows(); ++k) {
    Vector3d f = recording.wrench.row(k).head<3>().transpose(), t = recording.wrench.row(k).tail<3>().transpose();
    each(static_cast<std::size_t>(k), f, t);
    recording.wrench.row(k) << f.transpose(), t.transpose();
  }
}

void rewriteOne(const std::string& name, const RobotModel& robot, std::mt19937_64& random, Recording& r) {
  const double degree = std::numbers::pi / 180.0;
  if (name == "plain") return;
  if (name == "base_axes" || name == "base_point") {
    const auto X = posesOf(robot, r);
    eachWrench(r, [&](std::size_t k, Vector3d& f, Vector3d& t) {
      f = X[k].linear() * f;
      t = X[k].linear() * t;
      // The lever from the base's origin to the sensor.
      if (name == "base_point") t += X[k].translation().cross(f);
    });
  } else if (name == "tip_point") {
    // The controller tells torques about the tool's tip.
    const Vector3d tip{uniform(random, -0.05, 0.05), uniform(random, -0.05, 0.05), uniform(random, 0.2, 0.3)};
    eachWrench(r, [&](std::size_t, const Vector3d& f, Vector3d& t) { t -= tip.cross(f); });
  } else if (name == "torque_first") {
    eachWrench(r, [](std::size_t, Vector3d& f, Vector3d& t) { std::swap(f, t); });
  } else if (name == "torque_sign") {
    r.wrench.rightCols<3>() *= -1.0;
  } else if (name == "wrench_sign") {
    r.wrench *= -1.0;
  } else if (name == "mirror_x" || name == "mirror_y" || name == "mirror_z") {
    const int axis = name.back() - 'x';
    r.wrench.col(axis) *= -1.0;
    r.wrench.col(3 + axis) *= -1.0;
  } else if (name == "swapped_xy") {
    r.wrench.col(0).swap(r.wrench.col(1));
    r.wrench.col(3).swap(r.wrench.col(4));
  } else if (name == "N_mm") {
    r.wrench.rightCols<3>() *= 1000.0;
  } else if (name == "N_cm") {
    r.wrench.rightCols<3>() *= 100.0;
  } else if (name == "lbf_in") {
    r.wrench.leftCols<3>() *= 0.2248089431;
    r.wrench.rightCols<3>() *= 8.850745767;
  } else if (name == "lbf_ft") {
    r.wrench.leftCols<3>() *= 0.2248089431;
    r.wrench.rightCols<3>() *= 0.7375621493;
  } else if (name == "kgf_cm") {
    r.wrench.leftCols<3>() *= 0.1019716213;
    r.wrench.rightCols<3>() *= 10.19716213;
  } else if (name == "turned_45" || name == "turned_any") {
    // The sensor's axes are turned about its own z by 45 degrees, or anyhow by 30 to 180 degrees.
    const Matrix3d Q =
        name == "turned_45"
            ? rotationFromVector((uniform(random, 0, 1) < 0.5 ? 45.0 : -45.0) * degree * Vector3d::UnitZ())
            : rotationFromVector(uniform(random, 30.0, 180.0) * degree * direction(random));
    eachWrench(r, [&](std::size_t, Vector3d& f, Vector3d& t) {
      f = Q * f;
      t = Q * t;
    });
  } else if (name == "pose_inverted") {
    logPoses(robot, r);
    for (Eigen::Index k = 0; k < r.rows(); ++k) {
      const Eigen::RowVector4d q = r.quaternion.row(k);
      const Matrix3d R = Quaterniond(q(3), q(0), q(1), q(2)).toRotationMatrix();
      const Quaterniond inverse(Matrix3d(R.transpose()));
      r.quaternion.row(k) = inverse.coeffs().transpose();
      if (r.hasPosition()) r.position.row(k) = -(R.transpose() * r.position.row(k).transpose()).transpose();
    }
  } else if (name == "w_first") {
    logPoses(robot, r);
    for (Eigen::Index k = 0; k < r.rows(); ++k) {
      const Eigen::RowVector4d q = r.quaternion.row(k);
      r.quaternion.row(k) << q(3), q(0), q(1), q(2);
    }
  } else if (name == "poses") {
    logPoses(robot, r);
  } else if (name == "gravity_sign") {
    r.meta.gravity *= -1.0;
  } else {
    throw std::runtime_error("no driver " + name);
  }
}

}  // namespace

const std::vector<std::string>& driverNames() {
  static const std::vector<std::string> names{
      "base_axes", "base_point", "tip_point",  "torque_first",  "torque_sign", "wrench_sign", "mirror_x",
      "mirror_y",  "mirror_z",   "swapped_xy", "N_mm",          "N_cm",        "lbf_in",      "lbf_ft",
      "kgf_cm",    "turned_45",  "turned_any", "pose_inverted", "w_first",     "gravity_sign"};
  return names;
}

void logPoses(const RobotModel& robot, Recording& r) {
  if (!r.hasJoints()) return;
  const auto X = posesOf(robot, r);
  r.position.resize(r.rows(), 3);
  r.quaternion.resize(r.rows(), 4);
  for (Eigen::Index k = 0; k < r.rows(); ++k) {
    const Isometry3d& pose = X[static_cast<std::size_t>(k)];
    r.position.row(k) = pose.translation().transpose();
    r.quaternion.row(k) = Quaterniond(pose.linear()).coeffs().transpose();
    if (k > 0 && r.quaternion.row(k).dot(r.quaternion.row(k - 1)) < 0.0) r.quaternion.row(k) *= -1.0;
  }
  r.q.resize(0, 0);
  r.dq.resize(0, 0);
}

void rewriteAs(const std::string& name, const RobotModel& robot, std::uint64_t seed, Recording& recording) {
  std::mt19937_64 random(seed * 977 + 5);
  std::stringstream parts(name);
  for (std::string part; std::getline(parts, part, '+');) rewriteOne(part, robot, random, recording);
}

Recording standingRecording(const Payload& payload, int count, const Vector3d& gravity, double bias,
                            std::uint64_t seed) {
  const RobotModel& robot = RobotModel::panda();
  std::mt19937_64 random(seed * 31 + 7);
  Recording out;
  out.meta.robot = "panda";
  out.meta.kind = RecordingKind::poses;
  out.meta.mount.xyz = {0.0, 0.0, 0.04};
  out.meta.gravity = gravity;
  out.time = VectorXd::LinSpaced(count, 0.0, count - 1.0);
  out.q.resize(count, 7);
  out.wrench.resize(count, 6);
  const Vector3d forceBias = bias * 3.0 * Vector3d{normal(random), normal(random), normal(random)};
  const Vector3d torqueBias = bias * 0.1 * Vector3d{normal(random), normal(random), normal(random)};
  const double home[] = {0.0, -0.6, 0.0, -2.2, 0.0, 1.7, 0.8};
  const double reach[] = {1.5, 0.5, 0.8, 0.6, 1.6, 1.4, 2.0};
  for (int k = 0; k < count; ++k) {
    for (int j = 0; j < 7; ++j) out.q(k, j) = home[j] + reach[j] * uniform(random, -1.0, 1.0);
  }
  const auto X = posesOf(robot, out);
  for (int k = 0; k < count; ++k) {
    WrenchState state;
    state.specificForce = -(X[static_cast<std::size_t>(k)].linear().transpose() * gravity);
    const Vector6d w = predictWrench(payload, state);
    for (int c = 0; c < 3; ++c) {
      out.wrench(k, c) = w(c) + forceBias(c) + 0.02 * normal(random);
      out.wrench(k, 3 + c) = w(3 + c) + torqueBias(c) + 0.001 * normal(random);
    }
  }
  return out;
}

}  // namespace heft::test
