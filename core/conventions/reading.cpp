#include "core/conventions/reading.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "core/base/say.h"
#include "core/math/degrees.h"
#include "core/recording/meta_file.h"

namespace heft::conventions {

using nlohmann::json;
using Axes = Conventions::WrenchAxes;
using Point = Conventions::WrenchPoint;
using Order = Conventions::WrenchOrder;
using Sign = Conventions::TorqueSign;
using Pose = Conventions::PoseDirection;
using Quaternion = Conventions::QuaternionOrder;

namespace {

constexpr const char* kAxisName[] = {"x", "y", "z"};

constexpr double kSameAngle = 1e-6;  ///< [rad] Rounding

double angleOf(const Matrix3d& R) { return vectorFromRotation(R).norm(); }
double angleBetween(const Vector3d& a, const Vector3d& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

Matrix3d mirrorOf(const Conventions& c) {
  Matrix3d M = Matrix3d::Identity();
  if (c.mirroredAxis) M(*c.mirroredAxis, *c.mirroredAxis) = -1.0;
  return M;
}

/// From S's origin to the point that torques are taken about, in the axes in which the wrench is told [m].
Vector3d pointOf(const Conventions& c, const Matrix3d& R_BS, const Vector3d& p_BSo_B) {
  const bool base = c.wrenchAxes == Axes::base;
  switch (c.wrenchPoint.kind) {
    case Point::Kind::base:
      return base ? Vector3d(-p_BSo_B) : Vector3d(-(R_BS.transpose() * p_BSo_B));
    case Point::Kind::offset:
      return base ? Vector3d(R_BS * c.wrenchPoint.offset) : c.wrenchPoint.offset;
    case Point::Kind::sensor:
      break;
  }
  return Vector3d::Zero();
}

/// Numbers as in the file from a wrench in plain form, and back.
Vector6d toFile(const Vector6d& plain, const Conventions& c, const Matrix3d& R_BS, const Vector3d& p_BSo_B) {
  const Matrix3d M = mirrorOf(c);
  Vector3d f = M * plain.head<3>(), t = M * plain.tail<3>();
  if (c.wrenchAxes == Axes::base) {
    f = R_BS * f;
    t = R_BS * t;
  }
  t -= pointOf(c, R_BS, p_BSo_B).cross(f);
  if (c.torqueSign == Sign::opposite) t = -t;
  f /= c.force.si;
  t /= c.torque.si;
  Vector6d out;
  if (c.wrenchOrder == Order::torqueFirst)
    out << t, f;
  else
    out << f, t;
  return out;
}

Vector6d fromFile(const Vector6d& file, const Conventions& c, const Matrix3d& R_BS, const Vector3d& p_BSo_B) {
  const bool swapped = c.wrenchOrder == Order::torqueFirst;
  Vector3d f = c.force.si * (swapped ? file.tail<3>() : file.head<3>());
  Vector3d t = c.torque.si * (swapped ? file.head<3>() : file.tail<3>());
  if (c.torqueSign == Sign::opposite) t = -t;
  t += pointOf(c, R_BS, p_BSo_B).cross(f);
  if (c.wrenchAxes == Axes::base) {
    f = R_BS.transpose() * f;
    t = R_BS.transpose() * t;
  }
  const Matrix3d M = mirrorOf(c);
  Vector6d out;
  out << M * f, M * t;
  return out;
}

/// The pose whose numbers a file holds, from the pose in plain form.
Isometry3d poseInFile(const Isometry3d& X_BS, const Conventions& c) {
  return c.pose == Pose::baseInSensor ? X_BS.inverse() : X_BS;
}

/// The pose in plain form that file numbers mean which `stated` takes for X_BS.
Isometry3d reread(const Isometry3d& X_BS, const Conventions& stated, const Conventions& reading) {
  Isometry3d X = poseInFile(X_BS, stated);
  if (stated.quaternionOrder != reading.quaternionOrder) {
    const Quaterniond q(X.linear());
    X.linear() = (reading.quaternionOrder == Quaternion::wxyz ? Quaterniond(q.x(), q.y(), q.z(), q.w())
                                                              : Quaterniond(q.z(), q.w(), q.x(), q.y()))
                     .toRotationMatrix();
  }
  return poseInFile(X, reading);
}

}  // namespace

std::string_view toString(Change change) {
  constexpr std::string_view kNames[] = {"wrench_sign",  "torque_sign",    "torque_first",  "base_axes",
                                         "wrench_point", "mirrored",       "turned",        "unit",
                                         "gravity_sign", "gravity_turned", "pose_inverted", "quaternion_order"};
  return kNames[static_cast<std::size_t>(change)];
}

std::vector<Change> changes(const Reading& from, const Reading& to) {
  const Conventions &a = from.conventions, &b = to.conventions;
  std::vector<Change> out;
  const auto add = [&out](bool differs, Change change) {
    if (differs) out.push_back(change);
  };
  add(a.wrenchAxes != b.wrenchAxes, Change::axes);
  add(!(a.wrenchPoint == b.wrenchPoint), Change::point);
  add(a.wrenchOrder != b.wrenchOrder, Change::torqueFirst);
  add(a.mirroredAxis != b.mirroredAxis, Change::mirrored);
  add(from.sign != to.sign, Change::wrenchSign);
  add(a.torqueSign != b.torqueSign, Change::torqueSign);
  add(a.force.si != b.force.si || a.torque.si != b.torque.si, Change::unit);
  add(angleOf(from.turn.transpose() * to.turn) > kSameAngle, Change::turned);
  const double turned = angleBetween(from.gravity, to.gravity);
  add(turned > std::numbers::pi - kSameAngle, Change::gravitySign);
  add(turned > kSameAngle && turned <= std::numbers::pi - kSameAngle, Change::gravityTurned);
  add(a.pose != b.pose, Change::poseInverted);
  add(a.quaternionOrder != b.quaternionOrder, Change::quaternionOrder);
  return out;
}

namespace {

std::string unitsSaid(const Conventions& c) {
  const auto name = [](const Conventions::Unit& unit, const char* plain) {
    if (!unit.name.empty()) return unit.name;
    return unit.si == 1.0 ? std::string(plain) : fmt::format("{:.6g} {}", unit.si, plain);
  };
  return heft::say("Forces are in {}, torques in {}.", name(c.force, "N"), name(c.torque, "N m"));
}

std::string changeSaid(Change change, const Reading& stated, const Reading& reading) {
  const Conventions& c = reading.conventions;
  switch (change) {
    case Change::wrenchSign:
      return reading.sign == WrenchSign::payloadOnSensor
                 ? heft::say("The signs are those of the load on the sensor, not of the sensor on the load.")
                 : heft::say("The signs are those of the sensor on the load, not of the load on the sensor.");
    case Change::torqueSign:
      return c.torqueSign == Sign::opposite ? heft::say("The torque has the opposite sign to the force.")
                                            : heft::say("The torque has the same sign as the force.");
    case Change::torqueFirst:
      return c.wrenchOrder == Order::torqueFirst ? heft::say("The torque comes first, then the force.")
                                                 : heft::say("The force comes first, then the torque.");
    case Change::axes:
      return c.wrenchAxes == Axes::base
                 ? heft::say("The force is given in the robot's base axes, not the sensor's.")
                 : heft::say("The force is given in the sensor's axes, not the robot's base axes.");
    case Change::point:
      if (c.wrenchPoint.kind == Point::Kind::base)
        return heft::say("The torque is taken about the origin of the robot's base.");
      if (c.wrenchPoint.kind == Point::Kind::sensor) return heft::say("The torque is taken about the sensor's origin.");
      return heft::say("The torque is taken about a point {:.0f} mm from the sensor's origin.",
                       1e3 * c.wrenchPoint.offset.norm());
    case Change::mirrored:
      if (!c.mirroredAxis) return heft::say("No axis has the wrong sign.");
      return heft::say("Force and torque along {} have the wrong sign.", kAxisName[*c.mirroredAxis]);
    case Change::turned:
      return heft::say("The sensor is mounted {:.0f} degrees away from where the setup file has it.",
                       angleOf(stated.turn.transpose() * reading.turn) / kRadPerDegree);
    case Change::unit:
      return unitsSaid(c);
    case Change::gravitySign:
      return heft::say(
          "Gravity points the other way in the robot's base: it hangs from the ceiling, or stands upright.");
    case Change::gravityTurned:
      return heft::say(
          "Gravity points {:.0f} degrees away from what the setup file says: the base is mounted differently.",
          angleBetween(stated.gravity, reading.gravity) / kRadPerDegree);
    case Change::poseInverted:
      return c.pose == Pose::baseInSensor ? heft::say("The poses are those of the base in the sensor's frame.")
                                          : heft::say("The poses are those of the sensor in the base frame.");
    case Change::quaternionOrder:
      break;
  }
  return c.quaternionOrder == Quaternion::wxyz ? heft::say("The quaternions have w first.")
                                               : heft::say("The quaternions have w last.");
}

std::string checkSaid(Change change) {
  switch (change) {
    case Change::wrenchSign:
      return heft::say(
          "Check which sign the driver reports at rest: the weight of the load, or the force that carries it.");
    case Change::torqueSign:
      return heft::say("Check whether the driver or your own code turns the sign of forces or torques alone.");
    case Change::torqueFirst:
      return heft::say("Check the order of the columns: spatial vectors often have the torque first.");
    case Change::axes:
      return heft::say(
          "Check in which frame the controller reports the wrench (UR: actual_TCP_force is in base axes).");
    case Change::point:
      return heft::say("Check which point the controller takes torques about (sensor, TCP, flange or base).");
    case Change::mirrored:
      return heft::say("Check whether the driver uses a left-handed frame or changes the sign of one axis.");
    case Change::turned:
      return heft::say("Check the mounting angle of the sensor, and the frame that its driver reports in.");
    case Change::unit:
      return heft::say("Check the units on the sensor's configuration page or in its calibration file.");
    case Change::gravitySign:
    case Change::gravityTurned:
      return heft::say("Check how the base is mounted (floor, wall, ceiling) and the direction of gravity.");
    case Change::poseInverted:
      return heft::say("Check whether the logged transform is sensor to base or base to sensor.");
    case Change::quaternionOrder:
      break;
  }
  return heft::say(
      "Check the order of the quaternion's components (Eigen's constructor and MuJoCo: w first; ROS: w last).");
}

template <class Said>
std::string inTurn(const Reading& stated, const Reading& reading, const Said& said) {
  std::string out;
  for (const Change change : changes(stated, reading)) {
    const std::string next = said(change);
    if (out.find(next) != std::string::npos) continue;
    if (!out.empty()) out += ' ';
    out += next;
  }
  return out;
}

json signJson(WrenchSign sign) {
  return sign == WrenchSign::sensorOnPayload ? "sensor_on_payload" : "payload_on_sensor";
}
}  // namespace

Reading statedIn(const RecordingMeta& meta) {
  Reading out;
  out.conventions = meta.conventions;
  out.sign = meta.wrenchSign;
  out.gravity = meta.gravity;
  return out;
}

std::string sentence(const Reading& stated, const Reading& reading) {
  return inTurn(stated, reading, [&](Change change) { return changeSaid(change, stated, reading); });
}

std::string tiedSentence(const Reading& stated, const Reading& likeliest) {
  return heft::say("The stated conventions do not fit, and this recording cannot show which ones do. Likeliest: {}",
                   sentence(stated, likeliest));
}

std::string whatToCheck(const Reading& stated, const Reading& reading) { return inTurn(stated, reading, checkSaid); }

RecordingMeta metaSo(RecordingMeta meta, const Reading& stated, const Reading& reading, bool fromJoints) {
  meta.conventions = reading.conventions;
  meta.wrenchSign = reading.sign;
  meta.gravity = reading.gravity;
  if (const Matrix3d turn = stated.turn.transpose() * reading.turn; fromJoints && angleOf(turn) > kSameAngle)
    meta.mount.rpy = rpyFromRotation(rotationFromRpy(meta.mount.rpy) * turn);
  return meta;
}

json metaPatch(const Reading& stated, const Reading& reading, const SensorMount& mount, bool fromJoints) {
  const auto vector = [](const Vector3d& v) { return json{v.x(), v.y(), v.z()}; };
  RecordingMeta meta;
  meta.mount = mount;
  meta = metaSo(std::move(meta), stated, reading, fromJoints);
  // In words even where it is the default: a person is to read it.
  StatedConventions said{reading.conventions, {}};
  const json differs = heft::metaPatch(stated.conventions, reading.conventions);
  for (const auto& [key, value] : differs.items())
    if (key != "sensor") said.keys.insert(key);
  if (differs.contains("sensor"))
    for (const auto& [key, value] : differs["sensor"].items()) said.keys.insert(key);
  json out = heft::metaPatch(said);
  if (stated.sign != reading.sign) out["sensor"]["wrench_sign"] = signJson(reading.sign);
  if (meta.mount.rpy != mount.rpy)
    out["sensor"]["mount"] = heft::toJson(SensorMount{mount.parent, mount.xyz, meta.mount.rpy});
  if (angleBetween(stated.gravity, reading.gravity) > kSameAngle) out["gravity_m_s2"] = vector(reading.gravity);
  return out.empty() ? json(nullptr) : out;
}

json toJson(const Reading& reading) {
  json out = heft::toJson(reading.conventions);
  out["wrench_sign"] = signJson(reading.sign);
  if (angleOf(reading.turn) > kSameAngle) {
    const Vector3d rpy = rpyFromRotation(reading.turn);
    out["mount_turn_rpy_rad"] = {rpy.x(), rpy.y(), rpy.z()};
  }
  return out;
}

void readPosesSo(const Reading& stated, const Reading& reading, Motion& motion) {
  const Conventions &a = stated.conventions, &b = reading.conventions;
  if (a.pose == b.pose && a.quaternionOrder == b.quaternionOrder) return;
  const Eigen::Index K = motion.size();
  const auto at = [K](Eigen::Index k) { return static_cast<std::size_t>(std::clamp<Eigen::Index>(k, 0, K - 1)); };
  for (Eigen::Index k = 0; k < K; ++k) {
    Isometry3d X = Isometry3d::Identity();
    X.linear() = motion.R_BS[at(k)];
    X.translation() = motion.position.col(k);
    X = reread(X, a, b);
    motion.R_BS[at(k)] = X.linear();
    motion.position.col(k) = X.translation();
  }
  // Derivatives as differences between neighbours; the ends repeat what is beside them.
  const auto rate = [&](const Eigen::Matrix3Xd& x) {
    Eigen::Matrix3Xd out = Eigen::Matrix3Xd::Zero(3, K);
    for (Eigen::Index k = 1; k + 1 < K; ++k) out.col(k) = 0.5 * motion.rateHz * (x.col(k + 1) - x.col(k - 1));
    if (K > 2) {
      out.col(0) = out.col(1);
      out.col(K - 1) = out.col(K - 2);
    }
    return out;
  };
  Eigen::Matrix3Xd acceleration = Eigen::Matrix3Xd::Zero(3, K);
  const bool moves = motion.omega.squaredNorm() > 0.0;  // Not in standing poses
  if (moves) {
    for (Eigen::Index k = 0; k < K; ++k)
      motion.omega.col(k) =
          0.5 * motion.rateHz * vectorFromRotation(motion.R_BS[at(k - 1)].transpose() * motion.R_BS[at(k + 1)]);
    motion.alpha = rate(motion.omega);
    if (motion.originAccelerationKnown) {
      motion.velocity = rate(motion.position);
      acceleration = rate(motion.velocity);
    }
  }
  for (Eigen::Index k = 0; k < K; ++k)
    motion.specificForce.col(k) = motion.R_BS[at(k)].transpose() * (acceleration.col(k) - stated.gravity);
}

MatrixXd asInFile(const Motion& motion, const Conventions& conventions) {
  if (conventions.plain()) return motion.wrench;
  MatrixXd out(6, motion.size());
  for (Eigen::Index k = 0; k < motion.size(); ++k)
    out.col(k) =
        toFile(motion.wrench.col(k), conventions, motion.R_BS[static_cast<std::size_t>(k)], motion.position.col(k));
  return out;
}

namespace {

/// `file`: 6 x K as asInFile() yields it.
void setWrenchAndGravity(const MatrixXd& file, const Reading& stated, const Reading& reading, Motion& motion) {
  const double flip = stated.sign == reading.sign ? 1.0 : -1.0;
  const Matrix3d turn = flip * reading.turn;
  motion.wrench.resize(6, motion.size());
  for (Eigen::Index k = 0; k < motion.size(); ++k) {
    const Matrix3d& R = motion.R_BS[static_cast<std::size_t>(k)];
    const Vector6d w = fromFile(file.col(k), reading.conventions, R, motion.position.col(k));
    motion.wrench.col(k) << turn * w.head<3>(), turn * w.tail<3>();
    motion.specificForce.col(k) += R.transpose() * (stated.gravity - reading.gravity);
  }
}

MatrixXd numbersOf(const Motion& motion, const Reading& stated) {
  if (angleOf(stated.turn) < 1e-9) return asInFile(motion, stated.conventions);
  Motion unturned = motion;
  unturned.wrench.topRows(3) = stated.turn.transpose() * motion.wrench.topRows(3);
  unturned.wrench.bottomRows(3) = stated.turn.transpose() * motion.wrench.bottomRows(3);
  return asInFile(unturned, stated.conventions);
}

}  // namespace

void readWrenchSo(const Reading& stated, const Reading& reading, Motion& motion) {
  setWrenchAndGravity(numbersOf(motion, stated), stated, reading, motion);
}

Motion readSo(Motion motion, const Reading& stated, const Reading& reading, bool posesInFile) {
  const MatrixXd file = numbersOf(motion, stated);
  if (posesInFile) readPosesSo(stated, reading, motion);
  setWrenchAndGravity(file, stated, reading, motion);
  return motion;
}

}  // namespace heft::conventions
