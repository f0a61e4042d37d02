#include "core/coach/turn_kinds.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/math/linear_algebra.h"
#include "core/simulation/trajectory.h"

namespace heft {

namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;
constexpr double kStep = 0.02;          // [s] between samples of a proposed motion
constexpr double kMinimumScale = 0.05;  // of a candidate's size; less is not worth proposing
constexpr double kFill = 0.97;          // of the limits
constexpr double kSmaller = 0.6;        // of its size, where the end of a range or an obstacle is in the way

constexpr std::array kKinds{
    TurnKind{"tilt-sideways", "Tilt the tool sideways and back, slowly.", {0.9, 0.0, 0.0}, {0.2, 0.0, 0.0}},
    TurnKind{"tilt-forwards", "Tilt the tool forwards and back, slowly.", {0.0, 0.9, 0.0}, {0.0, 0.2, 0.0}},
    TurnKind{"tilt-round", "Move the tool in a slow circle, as if stirring.", {0.7, 0.7, 0.0}, {0.2, 0.2, 0.0}},
    TurnKind{"turn-slowly",
             "Rotate the tool slowly about its long axis, as far as it goes.",
             {0.0, 0.0, 1.5},
             {0.0, 0.0, 0.2}},
    TurnKind{
        "turn-fast", "Rotate the tool back and forth about its long axis, faster.", {0.0, 0.0, 0.6}, {0.0, 0.0, 1.2}},
    TurnKind{"swing-sideways", "Swing the tool sideways to and fro, once a second.", {0.4, 0.0, 0.0}, {1.0, 0.0, 0.0}},
    TurnKind{"swing-forwards", "Swing the tool forwards and back, once a second.", {0.0, 0.4, 0.0}, {0.0, 1.0, 0.0}},
    TurnKind{"swing-round", "Swing the tool round in a circle, once a second.", {0.3, 0.3, 0.0}, {1.0, 1.0, 0.0}},
    TurnKind{
        "shake-sideways", "Shake the tool sideways, about three times a second.", {0.12, 0.0, 0.0}, {3.0, 0.0, 0.0}},
    TurnKind{"shake-forwards",
             "Shake the tool forwards and back, about three times a second.",
             {0.0, 0.12, 0.0},
             {0.0, 3.0, 0.0}},
    TurnKind{"shake-about",
             "Shake the tool about its long axis, two to three times a second.",
             {0.0, 0.0, 0.2},
             {0.0, 0.0, 2.5}},
    TurnKind{"wobble",
             "Wobble the tool: tilt it in all directions while twisting it, about twice a second.",
             {0.12, 0.12, 0.15},
             {1.8, 2.2, 2.6}},
    TurnKind{"shake-wrist",
             "Shake the tool from the wrist, two to three times a second: tilt it in all directions while twisting it.",
             {0.12, 0.09, 0.09},
             {2.8, 2.4, 2.0},
             true},
    TurnKind{"swing-wrist",
             "Swing the tool from the wrist, once a second: tilt it in all directions while twisting it.",
             {0.4, 0.2, 0.2},
             {1.4, 1.0, 0.8},
             true},
};

/// Angle and rate of one wave that begins and ends at rest at zero.
Jet envelopedWave(double t, double duration, double omega, double phase, double amplitude) {
  const double ramp = std::min(0.4 * duration, 1.0);
  Jet grip{1.0, 0.0, 0.0};
  if (t < ramp) {
    grip = minimumJerk(t / ramp);
  } else if (t > duration - ramp) {
    grip = minimumJerk((duration - t) / ramp);
    grip.rate = -grip.rate;
  }
  grip.rate /= ramp;
  Jet wave;
  addWave({omega, phase, amplitude}, t, wave);
  return {grip.value * wave.value, grip.rate * wave.value + grip.value * wave.rate, 0.0};
}

/// How long it takes, in whole periods of its slowest wave where there is room for that.
double durationOf(const TurnKind& kind, double longest) {
  double hz = INFINITY;
  for (std::size_t i = 0; i < 3; ++i)
    if (kind.amplitude[i] > 0.0) hz = std::min(hz, kind.hz[i]);
  return std::min(longest, std::max(1.0, std::floor(longest * hz)) / hz);
}

/// Rates of the kind's three angles.
Vector3d rates(const TurnKind& kind, double scale, double t, double duration) {
  Vector3d out = Vector3d::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(kind.amplitude[i] > 0.0)) continue;
    const bool quarter = i > 0 && kind.hz[i] == kind.hz[i - 1];
    out(static_cast<Eigen::Index>(i)) = envelopedWave(t, duration, kTwoPi * kind.hz[i],
                                                      quarter ? 0.5 * std::numbers::pi : 0.0, scale * kind.amplitude[i])
                                            .rate;
  }
  return out;
}

/// Joint motion that turns S with the kind's angular velocity about the place's point of the tool, which stays where it
/// is as far as the arm can do both; or that of the wrist's joints alone.
JointMotion motionFor(const TurnKind& kind, double scale, const TurnPlace& place, double longest) {
  const GuidedTool& tool = *place.tool;
  const VectorXd& start = place.start;
  const double duration = durationOf(kind, longest);
  const auto n = static_cast<Eigen::Index>(std::lround(duration / kStep)) + 1;
  const Eigen::Index dof = start.size();
  JointMotion motion;
  motion.time = VectorXd::LinSpaced(n, 0.0, kStep * static_cast<double>(n - 1));
  motion.q.resize(n, dof);
  motion.dq.resize(n, dof);
  const Isometry3d X_LP = tool.X_LS * Eigen::Translation3d(place.pivot);
  const auto velocity = [&](double t, const VectorXd& q) -> VectorXd {
    const Vector3d rate = rates(kind, scale, t, duration);
    if (kind.wrist) {
      VectorXd dq = VectorXd::Zero(dof);
      for (Eigen::Index i = 0; i < std::min<Eigen::Index>(3, dof); ++i) dq(dof - 1 - i) = rate(i);
      return dq;
    }
    const MatrixXd J = tool.robot->jacobian(tool.link, X_LP, q);
    const Matrix3d R = (tool.robot->linkPose(q, tool.link) * X_LP).linear();
    Vector6d twist;
    twist << Vector3d::Zero(), R * place.axes * rate;
    // Damped: near a singular posture the arm turns less instead of jumping.
    const Matrix6d JJ = J * J.transpose() + 1e-4 * Matrix6d::Identity();
    return J.transpose() * solveSymmetric(JJ, twist);
  };
  // Simpson's rule along midpoint steps: positions, speeds and accelerations have to agree well enough for quintics.
  VectorXd q = start, dq = velocity(0.0, q);
  for (Eigen::Index k = 0; k < n; ++k) {
    motion.q.row(k) = q.transpose();
    motion.dq.row(k) = dq.transpose();
    const double t = motion.time(k);
    const VectorXd middle = velocity(t + 0.5 * kStep, q + 0.5 * kStep * dq);
    const VectorXd end = velocity(t + kStep, q + kStep * middle);
    q += kStep / 6.0 * (dq + 4.0 * middle + end);
    dq = end;
  }
  // It begins and ends at rest; next to the ends the second-order difference does.
  motion.ddq = MatrixXd::Zero(n, dof);
  for (Eigen::Index k = 1; k + 1 < n; ++k) {
    motion.ddq.row(k) = (motion.dq.row(k + 1) - motion.dq.row(k - 1)) / (2.0 * kStep);
    if (k > 1 && k + 2 < n)
      motion.ddq.row(k) =
          (8.0 * (motion.dq.row(k + 1) - motion.dq.row(k - 1)) - (motion.dq.row(k + 2) - motion.dq.row(k - 2))) /
          (12.0 * kStep);
  }
  return motion;
}

}  // namespace

std::span<const TurnKind> turnKinds() { return kKinds; }

Matrix3d toolAxes(const std::optional<OnlineInformation>& information) {
  Vector3d along = Vector3d::UnitZ();
  if (information) {
    const Payload payload = fromParameters(information->solution.phi);
    const auto [values, vectors] = symmetricEigen(payload.inertiaCom);
    const Vector3d moments = values;
    if (uncertaintyOf(*information).inertia < 0.2 && moments(0) < 0.7 * moments(1))
      along = vectors.col(0);
    else if (payload.com.norm() > 0.02)
      along = payload.com.normalized();
  }
  const Vector3d other = std::abs(along.x()) < 0.9 ? Vector3d::UnitX() : Vector3d::UnitY();
  const Vector3d sideways = (other - other.dot(along) * along).normalized();
  Matrix3d axes;
  axes << sideways, along.cross(sideways), along;
  return axes;
}

namespace {

TurnKind sized(TurnKind kind, double scale) {
  for (double& amplitude : kind.amplitude) amplitude *= scale;
  return kind;
}

/// What is met by the kind at this size; the use of the limits is in `advice`.
struct Trial {
  bool fits = false;
  bool atOnce = false;    ///< Already where it begins: smaller does not help.
  double shrink = kFill;  ///< What it has to be made smaller by
};

Trial tryAt(const TurnPlace& place, const CoachOptions& options, Advice& advice, TurnRefusal& refusal) {
  advice.use = limitUse(*place.tool, advice.motion, options.limits);
  const LimitUse& u = advice.use;
  if (!u.kept()) {
    if (u.torque.share > 1.0) refusal.tooHeavy = u.torque;
    // Rates go with the size; a range's use does not start at zero, nor does what a weight takes.
    const double rates = std::max({u.velocity, u.acceleration, u.tcpSpeed, u.cartesian});
    return {false, u.torque.share > 1.0 && u.torque.time <= 0.0,
            std::min(rates > 1.0 ? kFill / rates : 1.0, u.position > 1.0 || u.torque.share > 1.0 ? kSmaller : 1.0)};
  }
  const auto conflict =
      options.limits.clearance ? options.limits.clearance->firstConflict(advice.motion) : std::nullopt;
  if (!conflict) return {true};
  refusal.inTheWay = conflict;
  return {false, conflict->time <= 0.0, kSmaller};
}

}  // namespace

double largestOf(const TurnKind& kind) {
  constexpr double kMostTilt = 1.5;  // [rad] More is no tilt but turning the tool over.
  constexpr double kMost = 2.0;
  return std::clamp(kMostTilt / *std::ranges::max_element(kind.amplitude), 1.0, kMost);
}

bool isStill(const TurnKind& listed, const TurnKind& kind) {
  constexpr double kSlow = 0.45;  // [Hz] What is told to be slow takes two seconds and more.
  for (std::size_t i = 0; i < kind.hz.size(); ++i)
    if (listed.hz[i] < kSlow ? kind.hz[i] > kSlow : std::abs(std::log(kind.hz[i] / listed.hz[i])) > std::log(1.3))
      return false;
  return true;
}

std::optional<FittedTurn> fitted(const TurnKind& kind, const TurnPlace& place, const CoachOptions& options,
                                 double largest, TurnRefusal& refusal) {
  constexpr int kTries = 6, kGrowths = 3;
  constexpr double kWorthwhile = 1.08;  // Of growing
  std::optional<FittedTurn> best;
  double scale = 1.0, fits = 0.0, fails = INFINITY;
  for (int attempt = 0, grown = 0; attempt < kTries && grown <= kGrowths; ++attempt) {
    Advice advice;
    advice.motion = motionFor(kind, scale, place, options.duration);
    const Trial trial = tryAt(place, options, advice, refusal);
    if (trial.fits) {
      advice.id = kind.id;
      advice.sentence = kind.sentence;
      fits = scale;
      const LimitUse& u = advice.use;
      const double rates = std::max({u.velocity, u.acceleration, u.tcpSpeed, u.cartesian, 1e-3});
      scale = std::min({scale * kFill / rates, largest, fails < INFINITY ? 0.5 * (fits + fails) : INFINITY});
      best = FittedTurn{sized(kind, fits), std::move(advice)};
    } else {
      fails = scale;
      if (trial.atOnce) break;
      scale = std::max(scale * trial.shrink, best ? 0.5 * (fits + fails) : 0.0);
    }
    if (best && scale < kWorthwhile * fits) break;
    if (scale < kMinimumScale) break;
    if (best) ++grown;
  }
  return best;
}

}  // namespace heft
