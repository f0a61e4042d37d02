#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/recording/checks.h"

#include "core/base/remedy.h"
#include "core/base/say.h"
#include "core/math/statistics.h"
#include "core/recording/frozen.h"
#include "core/recording/leaps.h"
#include "core/recording/unwrap.h"

namespace heft {

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kLargestReach = 10.0;  ///< [m] From the base; larger positions are millimetres.
constexpr double kLeastOfGravity = 6.0,
                 kMostOfGravity = 16.0;  ///< [m/s2] An accelerometer reads between, in the median.
constexpr double kDegrees = 180.0 / std::numbers::pi;

/// How a column of rates relates to the changes of what it should be the rate of.
struct RateFit {
  double factor = 0.0;       ///< rate = factor * derivative, by least squares
  double correlation = 0.0;  ///< -1..1
  bool moves = false;        ///< Enough motion to say anything.
};

/// Compares changes over about 20 ms with the integral of the rates, so that neither quantisation nor noise of single
/// steps matters. `change(k, n)` is the increment from row k to row n, `rate(k)` the stated rate, of the same
/// dimension. What lies across a gap says nothing: it lasts more than twice as long. `broken`: rows to which the motion
/// did not lead from the row before.
template <class Change, class Rate>
RateFit fitRates(const VectorXd& time, double stepSize, double smallest, Change change, Rate rate,
                 const std::vector<bool>& broken = {}) {
  const auto stride = std::max<Eigen::Index>(1, std::lround(0.02 / stepSize));
  double aa = 0.0;
  double ab = 0.0;
  double bb = 0.0;
  Eigen::Index count = 0;
  for (Eigen::Index k = 0; k + stride < time.size(); k += stride) {
    if (time(k + stride) - time(k) > 2.0 * static_cast<double>(stride) * stepSize) continue;
    if (!broken.empty() &&
        std::find(broken.begin() + k + 1, broken.begin() + k + stride + 1, true) != broken.begin() + k + stride + 1)
      continue;
    ++count;
    const VectorXd a = change(k, k + stride);
    VectorXd b = VectorXd::Zero(a.size());
    for (Eigen::Index i = k; i < k + stride; ++i) b += 0.5 * (time(i + 1) - time(i)) * (rate(i) + rate(i + 1));
    aa += a.squaredNorm();
    ab += a.dot(b);
    bb += b.squaredNorm();
  }
  RateFit fit;
  fit.moves = count >= 20 && aa > static_cast<double>(count) * smallest * smallest;
  if (!fit.moves || bb == 0.0) return fit;
  fit.factor = ab / aa;
  fit.correlation = ab / std::sqrt(aa * bb);
  return fit;
}

/// The rows of a posture that hung, that at which it went on, and those at which it leaps.
std::vector<bool> brokenRows(const VectorXd& time, const Eigen::Ref<const MatrixXd>& postures,
                             const std::vector<Eigen::Index>& leaps) {
  std::vector<bool> out(static_cast<std::size_t>(time.size()), false);
  for (const auto& hung : hungPostures(time, postures))
    std::fill(out.begin() + hung.from, out.begin() + std::min(hung.to + 1, time.size()), true);
  for (const Eigen::Index row : leaps) out[static_cast<std::size_t>(row)] = true;
  return out;
}

bool near(double value, double target) { return value > 0.7 * target && value < 1.4 * target; }

/// Whether rates fit that are rough or late, as velocities of many controllers are.
bool fits(const RateFit& fit) {
  return !fit.moves || fit.factor == 0.0 || (fit.correlation > 0.6 && fit.factor > 0.5 && fit.factor < 2.0);
}

/// What a factor between rates and derivatives gives away; `angle`: rad, otherwise m.
std::optional<Error> judgeRates(const Examined& examined, const RateFit& fit, const std::string& columns, long field,
                                bool angle, const std::string& axes) {
  if (fits(fit)) return std::nullopt;
  const auto where = examined.column(field);
  if (fit.correlation > 0.8) {
    const auto text = [&](const std::string& what) {
      return heft::say("{} {} ({:.4g} times the change of the positions).", columns, what, fit.factor);
    };
    if (angle && near(fit.factor, kDegrees))
      return errorAt(where, text(heft::say("are in degrees per second")), heft::say("Convert them to rad/s."));
    if (angle && near(fit.factor, 1.0 / kDegrees))
      return errorAt(where, text(heft::say("do not fit: the angles are in degrees")),
                     heft::say("Convert the angles to rad."));
    if (near(fit.factor, 1000.0))
      return errorAt(where,
                     text(angle ? heft::say("do not fit: time is in milliseconds")
                                : heft::say("are in mm/s, or time is in milliseconds")),
                     heft::say("Convert all columns to SI units."));
    if (!angle && near(fit.factor, 1e-3))
      return errorAt(where, text(heft::say("do not fit: the positions are in millimetres")),
                     heft::say("Convert all columns to SI units."));
  }
  examined.note(Severity::warning, "velocity_disagrees", where,
                heft::say("{} do not fit the positions: factor {:.3g}, correlation {:.2f}.", columns, fit.factor,
                          fit.correlation),
                heft::say("Check their unit, order and axes{}.", axes));
  return std::nullopt;
}

std::optional<Error> checkAngleSize(const Examined& examined) {
  const auto& q = examined.recording.q;
  if (q.rows() == 0) return std::nullopt;
  // Arms without stops exist, but none of the Panda's joints passes 3.8 rad.
  const bool ownArm = !examined.recording.meta.robot || examined.recording.meta.robot == "panda";
  Eigen::Index row = 0;
  Eigen::Index joint = 0;
  const double largest = q.cwiseAbs().maxCoeff(&row, &joint);
  if (largest <= kTurn + 0.1) return std::nullopt;
  const auto field = examined.map.joints[static_cast<std::size_t>(joint)];
  if (ownArm || largest > 4.0 * kTurn)
    return errorAt(examined.at(row, field),
                   heft::say("{} is {:.6g}, more than a turn in radians: degrees?",
                             columnName(Role::joint, static_cast<int>(joint)), q(row, joint)),
                   remedy(Remedy::stateConvention, "\"angle_unit\": \"deg\""));
  examined.note(Severity::warning, "joint_angle_large", examined.at(row, field),
                heft::say("{} reaches {:.6g} rad, more than a turn.", columnName(Role::joint, static_cast<int>(joint)),
                          q(row, joint)),
                heft::say("Check that joints are in radians."));
  return std::nullopt;
}

std::optional<Error> checkPositions(const Examined& examined) {
  const auto& position = examined.recording.position;
  if (position.rows() == 0) return std::nullopt;
  Eigen::Index row = 0;
  Eigen::Index axis = 0;
  const double largest = position.cwiseAbs().maxCoeff(&row, &axis);
  if (largest <= kLargestReach) return std::nullopt;
  return errorAt(examined.at(row, examined.map.position[static_cast<std::size_t>(axis)]),
                 heft::say("{} is {:.6g}: no arm reaches that many metres from its base. Millimetres?",
                           columnName(Role::position, static_cast<int>(axis)), position(row, axis)),
                 remedy(Remedy::stateConvention, "\"length_unit\": \"mm\""));
}

/// What it reads is about gravity most of the time: 9.81 in m/s2, 1 in g.
void checkAccelerometer(const Examined& examined) {
  auto& readings = examined.recording.accelerometer;
  if (readings.rows() == 0) return;
  std::vector<double> sizes(static_cast<std::size_t>(readings.rows()));
  for (Eigen::Index k = 0; k < readings.rows(); ++k) sizes[static_cast<std::size_t>(k)] = readings.row(k).norm();
  const double size = median(std::move(sizes));
  const auto column = examined.column(examined.map.accelerometer[0]);
  if (size > kLeastOfGravity && size < kMostOfGravity) return;
  if (const double inG = size * kStandardGravity; inG > kLeastOfGravity && inG < kMostOfGravity) {
    readings *= kStandardGravity;
    examined.note(Severity::info, "accelerometer_in_g", column,
                  heft::say("The accelerometer reads {:.3g} most of the time, so it is in g.", size),
                  remedy(Remedy::stateConvention, "\"acceleration_unit\": \"g\""));
    return;
  }
  readings.resize(0, 3);
  examined.recording.gyroscope.resize(0, 3);
  examined.note(Severity::info, "columns_set_aside", column,
                heft::say("The accelerometer reads {:.3g} most of the time, neither 9.81 m/s2 nor 1 g, and is not "
                          "used: gravity was removed from it, or it is not an accelerometer.",
                          size));
}

Quaterniond quaternionAt(const Recording& recording, Eigen::Index row) {
  const auto& q = recording.quaternion;
  return {q(row, 3), q(row, 0), q(row, 1), q(row, 2)};
}

std::optional<Error> checkRates(const Examined& examined) {
  const auto& recording = examined.recording;
  const VectorXd& time = recording.time;
  const double rate = recording.rateHz();
  if (rate <= 0.0 || recording.meta.kind == RecordingKind::poses) return std::nullopt;
  // Leaps are looked for only where something is wrong: in wrong units, fast motion looks like one.
  const auto fitOf = [&](double smallest, const auto& change, const auto& rates, const auto& broken) {
    const RateFit all = fitRates(time, 1.0 / rate, smallest, change, rates);
    if (fits(all)) return all;
    const RateFit whole = fitRates(time, 1.0 / rate, smallest, change, rates, broken());
    return whole.moves ? whole : all;
  };
  if (recording.dq.rows() > 0) {
    const auto fit = fitOf(
        1e-4,
        [&](Eigen::Index k, Eigen::Index n) -> VectorXd {
          return (recording.q.row(n) - recording.q.row(k)).transpose();
        },
        [&](Eigen::Index k) { return recording.dq.row(k).transpose(); },
        [&] { return brokenRows(time, recording.q, jointLeaps(time, recording.q)); });
    if (auto failure =
            judgeRates(examined, fit, heft::say("the joint velocities"), examined.map.velocities.front(), true, {}))
      return failure;
  }
  if (recording.twist.rows() == 0) return std::nullopt;
  if (recording.position.rows() > 0) {
    const auto fit = fitOf(
        1e-4,
        [&](Eigen::Index k, Eigen::Index n) -> VectorXd {
          return (recording.position.row(n) - recording.position.row(k)).transpose();
        },
        [&](Eigen::Index k) { return recording.twist.row(k).head<3>().transpose(); },
        [&] { return brokenRows(time, recording.position, positionLeaps(time, recording.position)); });
    if (auto failure = judgeRates(examined, fit, "vx, vy, vz", examined.map.twist[0], false,
                                  heft::say(" (base axes, at the sensor's origin)")))
      return failure;
  }
  const auto fit = fitOf(
      1e-3,
      [&](Eigen::Index k, Eigen::Index n) -> VectorXd {
        const Eigen::AngleAxisd turn(quaternionAt(recording, n) * quaternionAt(recording, k).conjugate());
        return turn.angle() * turn.axis();
      },
      [&](Eigen::Index k) { return recording.twist.row(k).tail<3>().transpose(); },
      [&] { return brokenRows(time, recording.quaternion, orientationLeaps(time, recording.quaternion)); });
  return judgeRates(examined, fit, "wx, wy, wz", examined.map.twist[3], true, heft::say(" (base axes)"));
}

}  // namespace

std::optional<Error> checkQuaternions(const Examined& examined) {
  auto& quaternions = examined.recording.quaternion;
  constexpr double kRounding = 8.0 * std::numeric_limits<double>::epsilon();
  constexpr double kFew = 1e-4;  // written with four or more decimals
  constexpr double kFar = 0.05;  // beyond it, something else than rounding is wrong
  double worst = 0.0;
  Eigen::Index worstRow = 0;
  Eigen::Index odd = 0;
  for (Eigen::Index k = 0; k < quaternions.rows(); ++k) {
    const double squared = quaternions.row(k).squaredNorm();
    if (std::abs(squared - 1.0) <= kRounding) continue;  // scaling it again would only change its last bits
    const double norm = std::sqrt(squared);
    const double off = std::abs(norm - 1.0);
    if (!(off <= kFar))
      return errorAt(examined.at(k, examined.map.quaternion[0]),
                     heft::say("the quaternion ({:.4g}, {:.4g}, {:.4g}, {:.4g}) has length {:.4g} instead of 1.",
                               quaternions(k, 0), quaternions(k, 1), quaternions(k, 2), quaternions(k, 3), norm),
                     norm < 1e-6 ? heft::say("Delete the rows in which the robot sent no pose yet.")
                                 : heft::say("Check that the columns qx, qy, qz, qw hold a unit quaternion."));
    if (off > kFew) ++odd;
    if (off > worst) {
      worst = off;
      worstRow = k;
    }
    quaternions.row(k) /= norm;
  }
  if (odd > 0)
    examined.note(worst > 0.01 ? Severity::warning : Severity::info, "quaternion_not_unit",
                  examined.at(worstRow, examined.map.quaternion[0]),
                  odd == 1 ? heft::say("One quaternion is not of length 1, by {:.2g}; it was normalised.", worst)
                           : heft::say("{} quaternions are not of length 1, at worst by {:.2g}; all were normalised.",
                                       odd, worst));
  if (examined.recording.meta.kind == RecordingKind::poses) return std::nullopt;
  for (Eigen::Index k = 1; k < quaternions.rows(); ++k)
    if (quaternions.row(k).dot(quaternions.row(k - 1)) < 0.0) quaternions.row(k) *= -1.0;
  return std::nullopt;
}

std::optional<Error> checkAngles(const Examined& examined) {
  // Before the turns are taken out: a joint without stops may make as many as it likes.
  if (auto failure = checkAngleSize(examined)) return failure;
  auto& recording = examined.recording;
  if (recording.q.rows() == 0 || recording.meta.kind == RecordingKind::poses) return std::nullopt;
  if (const auto joints = unwrapJoints(recording.time, recording.q); !joints.empty())
    examined.note(Severity::info, "angles_unwrapped",
                  examined.column(examined.map.joints[static_cast<std::size_t>(joints[0])]), unwrapped(joints));
  return std::nullopt;
}

std::optional<Error> checkUnits(const Examined& examined) {
  checkAccelerometer(examined);
  if (auto failure = checkPositions(examined)) return failure;
  return checkRates(examined);
}

}  // namespace heft
