#pragma once
// Recordings as files in other conventions hold them, written out from the contract's words alone: a witness against
// core/recording/plain_form.h, of which nothing is used here.
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "core/recording/recording.h"
#include "core/robot/robot_model.h"

namespace heft::testing_support {

enum class MotionForm { joints, poses };

/// A moving Panda with the sensor's pose in each row, in the plain form: joints, their rates, poses and a wrench.
struct PlainMotion {
  Recording recording;
  std::vector<Isometry3d> X_BS;

  /// Of a recording with a Panda's joints and their rates.
  explicit PlainMotion(Recording joints) : recording(std::move(joints)) { fillPoses(); }

  explicit PlainMotion(Eigen::Index rows = 150, double rateHz = 100.0) {
    recording.file = "rec.csv";
    recording.meta.robot = "panda";
    recording.meta.mount = {"panda_link8", {0.01, -0.02, 0.05}, {0.2, -0.3, 0.4}};
    recording.time.resize(rows);
    recording.q.resize(rows, 7);
    recording.dq.resize(rows, 7);
    recording.wrench.resize(rows, 6);
    for (Eigen::Index k = 0; k < rows; ++k) {
      const double t = static_cast<double>(k) / rateHz;
      recording.time(k) = t;
      for (int j = 0; j < 7; ++j) {
        recording.q(k, j) = RobotModel::panda().homePosture()(j) + 0.3 * std::sin((1.0 + 0.3 * j) * t + j);
        recording.dq(k, j) = 0.3 * (1.0 + 0.3 * j) * std::cos((1.0 + 0.3 * j) * t + j);
      }
      for (int c = 0; c < 6; ++c)
        recording.wrench(k, c) = (c < 3 ? 8.0 : 0.6) * std::sin(1.7 * t + 1.3 * c) + (c < 3 ? 2.0 : -0.1);
    }
    fillPoses();
  }

 private:
  void fillPoses() {
    const RobotModel& panda = RobotModel::panda();
    const Isometry3d X_LS = poseFromXyzRpy(recording.meta.mount.xyz, recording.meta.mount.rpy);
    const int link = *panda.findLink(recording.meta.mount.parent);
    recording.position.resize(recording.rows(), 3);
    recording.quaternion.resize(recording.rows(), 4);
    for (Eigen::Index k = 0; k < recording.rows(); ++k) {
      X_BS.push_back(panda.linkPose(recording.q.row(k).transpose(), link) * X_LS);
      recording.position.row(k) = X_BS.back().translation().transpose();
      Quaterniond q(X_BS.back().linear());
      if (k > 0 && q.coeffs().dot(recording.quaternion.row(k - 1).transpose()) < 0.0) q.coeffs() *= -1.0;
      recording.quaternion.row(k) = q.coeffs().transpose();
    }
  }
};

/// SI for one of the unit.
inline double unitBy(const nlohmann::json& unit) {
  if (unit.is_number()) return unit;
  if (unit == "kN") return 1000.0;
  if (unit == "kgf") return 9.80665;
  if (unit == "lbf") return 4.4482216152605;
  if (unit == "gf") return 0.00980665;
  if (unit == "N mm") return 0.001;
  if (unit == "N cm") return 0.01;
  if (unit == "kgf cm") return 0.0980665;
  if (unit == "kgf m") return 9.80665;
  if (unit == "lbf in") return 4.4482216152605 * 0.0254;
  if (unit == "lbf ft") return 4.4482216152605 * 0.3048;
  return 1.0;
}

/// A wrench in S axes about S's origin as a file with this meta holds it.
inline Vector6d wrenchIn(const nlohmann::json& meta, const Vector6d& plain, const Isometry3d& X_BS) {
  const nlohmann::json sensor = meta.value("sensor", nlohmann::json::object());
  Vector3d f = plain.head<3>(), t = plain.tail<3>();
  if (const auto axis = sensor.find("mirrored_axis"); axis != sensor.end() && !axis->is_null()) {
    const int a = axis->get<std::string>()[0] - 'x';
    f(a) *= -1.0;
    t(a) *= -1.0;
  }
  const bool inBase = sensor.value("wrench_axes", "sensor") == "base";
  const Matrix3d R = inBase ? Matrix3d(X_BS.linear()) : Matrix3d::Identity();
  f = R * f;
  t = R * t;
  if (const auto point = sensor.find("wrench_point"); point != sensor.end()) {
    if (point->is_array()) {
      const Vector3d d((*point)[0], (*point)[1], (*point)[2]);
      t -= (R * d).cross(f);  // the lever from there to S's origin is -d
    } else if (*point == "base") {
      const Vector3d p = inBase ? X_BS.translation() : Vector3d(X_BS.linear().transpose() * X_BS.translation());
      t += p.cross(f);
    }
  }
  if (sensor.value("torque_sign", "as_force") == "opposite") t = -t;
  if (sensor.value("wrench_sign", "sensor_on_payload") == "payload_on_sensor") {
    f = -f;
    t = -t;
  }
  f /= unitBy(sensor.value("force_unit", nlohmann::json()));
  t /= unitBy(sensor.value("torque_unit", nlohmann::json()));
  Vector6d out;
  if (sensor.value("wrench_order", "force_first") == "torque_first")
    out << t, f;
  else
    out << f, t;
  return out;
}

/// Position and x, y, z, w as a file with this meta holds them.
struct PoseNumbers {
  Vector3d position;
  Eigen::Vector4d quaternion;
};
inline PoseNumbers poseIn(const nlohmann::json& meta, const Vector3d& position, const Eigen::Vector4d& quaternion) {
  Vector3d p = position;
  Quaterniond q(quaternion(3), quaternion(0), quaternion(1), quaternion(2));
  if (meta.value("pose", "sensor_in_base") == "base_in_sensor") {
    p = -(q.toRotationMatrix().transpose() * p);
    q = q.conjugate();
  }
  if (meta.value("length_unit", "m") == "mm") p *= 1000.0;
  if (meta.value("quaternion_order", "xyzw") == "wxyz") return {p, {q.w(), q.x(), q.y(), q.z()}};
  return {p, {q.x(), q.y(), q.z(), q.w()}};
}

inline double anglesPerRad(const nlohmann::json& meta) {
  return meta.value("angle_unit", "rad") == "deg" ? 180.0 / std::numbers::pi : 1.0;
}

/// The file's names and rows.
struct FileNumbers {
  std::vector<std::string> names;
  std::vector<std::vector<double>> rows;

  std::string csv() const {
    std::string out = fmt::format("{}\n", fmt::join(names, ","));
    for (const auto& row : rows) out += fmt::format("{}\n", fmt::join(row, ","));
    return out;
  }
  /// One object a line.
  std::string jsonLines() const {
    std::string out;
    for (const auto& row : rows) {
      nlohmann::ordered_json line;
      for (std::size_t c = 0; c < names.size(); ++c) line[names[c]] = row[c];
      out += line.dump() + "\n";
    }
    return out;
  }
};

inline FileNumbers numbersIn(const nlohmann::json& meta, const PlainMotion& motion, MotionForm form) {
  FileNumbers out;
  out.names = {"time"};
  if (form == MotionForm::joints) {
    for (int j = 1; j <= 7; ++j) out.names.push_back(fmt::format("q{}", j));
    for (int j = 1; j <= motion.recording.dq.cols(); ++j) out.names.push_back(fmt::format("dq{}", j));
  } else {
    out.names.insert(out.names.end(), {"px", "py", "pz", "qx", "qy", "qz", "qw"});
  }
  out.names.insert(out.names.end(), {"fx", "fy", "fz", "tx", "ty", "tz"});
  const Recording& plain = motion.recording;
  for (Eigen::Index k = 0; k < plain.rows(); ++k) {
    std::vector<double> row = {plain.time(k)};
    if (form == MotionForm::joints) {
      for (int j = 0; j < 7; ++j) row.push_back(plain.q(k, j) * anglesPerRad(meta));
      for (int j = 0; j < plain.dq.cols(); ++j) row.push_back(plain.dq(k, j) * anglesPerRad(meta));
    } else {
      const auto pose = poseIn(meta, plain.position.row(k).transpose(), plain.quaternion.row(k).transpose());
      for (const double value : pose.position) row.push_back(value);
      for (const double value : pose.quaternion) row.push_back(value);
    }
    const Vector6d wrench = wrenchIn(meta, plain.wrench.row(k).transpose(), motion.X_BS[static_cast<std::size_t>(k)]);
    for (const double value : wrench) row.push_back(value);
    out.rows.push_back(std::move(row));
  }
  return out;
}

/// Every convention by itself, and many of them at once.
inline std::vector<nlohmann::json> conventionsToTry() {
  std::vector<nlohmann::json> out = {nlohmann::json::object()};
  const std::vector<std::pair<std::string, std::vector<nlohmann::json>>> sensor = {
      {"wrench_sign", {"payload_on_sensor"}},
      {"wrench_axes", {"base"}},
      {"wrench_point", {"base", {0.03, -0.02, 0.11}}},
      {"torque_sign", {"opposite"}},
      {"wrench_order", {"torque_first"}},
      {"mirrored_axis", {"x", "y", "z"}},
      {"force_unit", {"kN", "kgf", "lbf", "gf", 0.0123}},
      {"torque_unit", {"N mm", "N cm", "kgf cm", "kgf m", "lbf in", "lbf ft", 3.5e-4}}};
  const std::vector<std::pair<std::string, std::vector<nlohmann::json>>> top = {
      {"angle_unit", {"deg"}}, {"length_unit", {"mm"}}, {"pose", {"base_in_sensor"}}, {"quaternion_order", {"wxyz"}}};
  for (const auto& [key, values] : sensor)
    for (const auto& value : values) out.push_back({{"sensor", {{key, value}}}});
  for (const auto& [key, values] : top)
    for (const auto& value : values) out.push_back({{key, value}});
  for (const char* const axes : {"base", "sensor"})
    for (const nlohmann::json& point : {nlohmann::json("base"), nlohmann::json({0.03, -0.02, 0.11})})
      out.push_back({{"sensor", {{"wrench_axes", axes}, {"wrench_point", point}, {"mirrored_axis", "y"}}}});
  std::mt19937 random(11);
  for (int i = 0; i < 40; ++i) {
    nlohmann::json meta = nlohmann::json::object();
    for (const auto& [key, values] : sensor)
      if (random() % 2 == 0) meta["sensor"][key] = values[random() % values.size()];
    for (const auto& [key, values] : top)
      if (random() % 2 == 0) meta[key] = values[random() % values.size()];
    out.push_back(std::move(meta));
  }
  return out;
}

/// `meta` with robot and mount.
inline nlohmann::json withRig(nlohmann::json meta, const RecordingMeta& rig) {
  meta["robot"] = *rig.robot;
  meta["sensor"]["mount"] = {{"parent", rig.mount.parent},
                             {"xyz_m", {rig.mount.xyz.x(), rig.mount.xyz.y(), rig.mount.xyz.z()}},
                             {"rpy_rad", {rig.mount.rpy.x(), rig.mount.rpy.y(), rig.mount.rpy.z()}}};
  return meta;
}

/// The largest difference between what was read and the plain form.
inline double differenceFrom(const PlainMotion& motion, const Recording& read) {
  const Recording& plain = motion.recording;
  if (read.rows() != plain.rows() || read.wrenchNeedsPose) return 1e9;
  double most = (read.wrench - plain.wrench).cwiseAbs().maxCoeff();
  if (read.hasJoints()) most = std::max(most, (read.q - plain.q).cwiseAbs().maxCoeff());
  if (read.dq.rows() > 0) most = std::max(most, (read.dq - plain.dq).cwiseAbs().maxCoeff());
  if (read.hasPosition()) most = std::max(most, (read.position - plain.position).cwiseAbs().maxCoeff());
  if (read.hasOrientation()) most = std::max(most, (read.quaternion - plain.quaternion).cwiseAbs().maxCoeff());
  return most;
}

}  // namespace heft::testing_support
