#pragma once
// Small things that the causes share.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/diagnosis/calibration.h"
#include "core/diagnosis/model/cause.h"
#include "core/recording/channels.h"

namespace heft::diagnosis {

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr double kMilli = 1e3;

/// A time over how far resampling and its stamps may put a row from where it belongs. Two of 90 clean recordings had
/// 0.02 and 0.07 ms at a gain next to nothing; of 60 that are late, none had less than 0.14 ms.
inline double overOwnTimes(double time) {
  constexpr double kOwn = 2e-5;  // [s]
  return std::abs(time) / kOwn;
}

/// Whether two clocks that Heft brought together may be off by that time [s].
inline bool withinAlignment(double time, const Signals& signals) {
  return signals.clockAlignmentStd && std::abs(time) < kStandsOut * *signals.clockAlignmentStd;
}

/// A form whose parameters all start at zero and are all looked at.
inline Form formOf(const Cause* cause, std::string name, std::vector<Parameter> parameters) {
  Form form;
  form.cause = cause;
  form.name = std::move(name);
  form.start = VectorXd::Zero(static_cast<Eigen::Index>(parameters.size()));
  for (std::size_t i = 0; i < parameters.size(); ++i) form.scan.push_back(static_cast<int>(i));
  form.parameters = std::move(parameters);
  return form;
}

/// `parameters` and the place at_x, at_y, at_z where a force acts, from S's origin, S axes.
inline std::vector<Parameter> withPlace(std::vector<Parameter> parameters) {
  for (const char* axis : {"at_x", "at_y", "at_z"}) parameters.push_back({axis, "mm", kMilli, 0.03, -1.0, 1.0});
  return parameters;
}

/// Adds world-fixed forces (B axes, a column an instant) that act at r from S's origin (S axes). `R_BS`: axesOf().
inline void addWorldForce(const std::vector<Matrix3d>& R_BS, const Eigen::Matrix3Xd& force_B, const Vector3d& r,
                          Wrenches& w) {
  for (Eigen::Index k = 0; k < w.cols(); ++k) {
    const Vector3d f = R_BS[static_cast<std::size_t>(k)].transpose() * force_B.col(k);
    w.col(k).head<3>() += f;
    w.col(k).tail<3>() += r.cross(f);
  }
}

/// Adds what sets the motion `moved`, by other joint angles, apart from the recorded one.
inline void addMove(const Signals& signals, Kinematics& kinematics, const Kinematics& moved) {
  kinematics.specificForce += moved.specificForce - signals.kinematics.specificForce;
  kinematics.omega += moved.omega - signals.kinematics.omega;
  kinematics.alpha += moved.alpha - signals.kinematics.alpha;
  if (!kinematics.turned) {
    kinematics.turned = moved.turned;
    return;
  }
  auto axes = std::make_shared<std::vector<Matrix3d>>(*kinematics.turned);
  for (std::size_t k = 0; k < axes->size(); ++k) (*axes)[k] *= signals.R_BS[k].transpose() * (*moved.turned)[k];
  kinematics.turned = std::move(axes);
}

/// Changes the acceleration of S's origin by `change`, which takes and returns it in S axes, and leaves gravity as it
/// is.
template <class Change>
void changeAccelerationInSensor(const Signals& signals, Kinematics& kinematics, Change change) {
  Eigen::Matrix3Xd gravity(3, signals.size());
  for (Eigen::Index k = 0; k < signals.size(); ++k)
    gravity.col(k) = signals.R_BS[static_cast<std::size_t>(k)].transpose() * signals.gravity;
  kinematics.specificForce = change(kinematics.specificForce + gravity) - gravity;
}

/// The same of turning, too.
template <class Change>
void changeMotionInSensor(const Signals& signals, Kinematics& kinematics, Change change) {
  changeAccelerationInSensor(signals, kinematics, change);
  kinematics.omega = change(kinematics.omega);
  kinematics.alpha = change(kinematics.alpha);
}

/// `change`, which takes and returns B axes, of what is in S axes.
template <class Change>
auto inBase(const Signals& signals, Change change) {
  return [&signals, change](Eigen::Matrix3Xd value) {
    for (Eigen::Index k = 0; k < value.cols(); ++k)
      value.col(k) = (signals.R_BS[static_cast<std::size_t>(k)] * value.col(k)).eval();
    Eigen::Matrix3Xd out = change(value);
    for (Eigen::Index k = 0; k < out.cols(); ++k)
      out.col(k) = (signals.R_BS[static_cast<std::size_t>(k)].transpose() * out.col(k)).eval();
    return out;
  };
}

/// As changeAccelerationInSensor() where `change` takes and returns B axes.
template <class Change>
void changeAcceleration(const Signals& signals, Kinematics& kinematics, Change change) {
  changeAccelerationInSensor(signals, kinematics, inBase(signals, change));
}

/// The same of turning, too.
template <class Change>
void changeMotion(const Signals& signals, Kinematics& kinematics, Change change) {
  changeMotionInSensor(signals, kinematics, inBase(signals, change));
}

/// Two unit vectors across gravity, B axes.
inline std::pair<Vector3d, Vector3d> acrossGravity(const Vector3d& gravity) {
  const Vector3d g = gravity.norm() > 1e-6 ? Vector3d(gravity.normalized()) : Vector3d(-Vector3d::UnitZ());
  const Vector3d x = std::abs(g.x()) < 0.9 ? Vector3d(Vector3d::UnitX() - g.x() * g).normalized()
                                           : Vector3d(Vector3d::UnitY() - g.y() * g).normalized();
  return {x, g.cross(x)};
}

/// Symmetric, of its elements xx, yy, zz, xy, xz, yz.
inline Matrix3d tensor(const Vector6d& v) {
  Matrix3d out = Vector3d(v.head<3>()).asDiagonal();
  out(0, 1) = out(1, 0) = v(3);
  out(0, 2) = out(2, 0) = v(4);
  out(1, 2) = out(2, 1) = v(5);
  return out;
}

/// How far [0, 1] an event at t0 that takes `duration` has gone at time t.
inline double stepAt(double t, double t0, double duration) {
  constexpr double kShortest = 5e-3;  // [s] A sample: readings are means over one
  return std::clamp(0.5 + (t - t0) / std::max(duration, kShortest), 0.0, 1.0);
}

/// Times [s] between which an event may change the rest of the recording: close to an end there is nothing to compare.
inline std::pair<double, double> timesForChange(const Signals& signals) {
  const double margin = std::max(1.2, 0.08 * signals.duration());
  return {signals.startTime + margin, signals.startTime + signals.duration() - margin};
}

/// Moments [s] between them at which a first look places an event.
inline std::vector<double> momentsForChange(const Signals& signals) {
  const auto [from, to] = timesForChange(signals);
  std::vector<double> out;
  for (double t = from + 0.05; t < to; t += std::max(0.4, signals.duration() / 60.0)) out.push_back(t);
  return out;
}

inline std::pair<double, double> wholeAfter(double t0, const Signals& signals) {
  return {t0, signals.startTime + signals.duration()};
}

}  // namespace heft::diagnosis
