#include "core/coach/coach.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/base/say.h"
#include "core/math/linear_algebra.h"
#include "core/simulation/trajectory.h"

namespace heft {

namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;
constexpr double kStep = 0.02;          // [s] between samples of a proposed motion
constexpr double kMinimumScale = 0.05;  // of a candidate's size; less is not worth proposing
constexpr double kFill = 0.97;          // of the limits
constexpr double kSmaller = 0.6;        // of its size, where the end of a range or an obstacle is in the way
constexpr std::array kAll{CoachGoal::mass, CoachGoal::com, CoachGoal::inertia};
// Standard deviations with which nothing more need be done.
constexpr Uncertainty kEnough{0.002, 0.0005, 0.02};

/// A turn about axes of the tool, 0 sideways, 1 forwards, 2 long axis, or of the last three joints, counted from the
/// one next to the tool. Where two of the frequencies are the same, the second wave is a quarter behind: a circle.
struct Kind {
  const char* id;
  const char* sentence;
  std::array<double, 3> amplitude;  // [rad]
  std::array<double, 3> hz;
  bool wrist = false;  // joints; the point that stays where it is is then the wrist, and not the centre of mass
};
constexpr std::array kKinds{
    Kind{"tilt-sideways", "Tilt the tool sideways and back, slowly.", {0.9, 0.0, 0.0}, {0.2, 0.0, 0.0}},
    Kind{"tilt-forwards", "Tilt the tool forwards and back, slowly.", {0.0, 0.9, 0.0}, {0.0, 0.2, 0.0}},
    Kind{"tilt-round", "Move the tool in a slow circle, as if stirring.", {0.7, 0.7, 0.0}, {0.2, 0.2, 0.0}},
    Kind{"turn-slowly",
         "Rotate the tool slowly about its long axis, as far as it goes.",
         {0.0, 0.0, 1.5},
         {0.0, 0.0, 0.2}},
    Kind{"turn-fast", "Rotate the tool back and forth about its long axis, faster.", {0.0, 0.0, 0.6}, {0.0, 0.0, 1.2}},
    Kind{"swing-sideways", "Swing the tool sideways to and fro, once a second.", {0.4, 0.0, 0.0}, {1.0, 0.0, 0.0}},
    Kind{"swing-forwards", "Swing the tool forwards and back, once a second.", {0.0, 0.4, 0.0}, {0.0, 1.0, 0.0}},
    Kind{"swing-round", "Swing the tool round in a circle, once a second.", {0.3, 0.3, 0.0}, {1.0, 1.0, 0.0}},
    Kind{"shake-sideways", "Shake the tool sideways, about three times a second.", {0.12, 0.0, 0.0}, {3.0, 0.0, 0.0}},
    Kind{"shake-forwards",
         "Shake the tool forwards and back, about three times a second.",
         {0.0, 0.12, 0.0},
         {0.0, 3.0, 0.0}},
    Kind{"shake-about",
         "Shake the tool about its long axis, two to three times a second.",
         {0.0, 0.0, 0.2},
         {0.0, 0.0, 2.5}},
    Kind{"wobble",
         "Wobble the tool: tilt it in all directions while twisting it, about twice a second.",
         {0.12, 0.12, 0.15},
         {1.8, 2.2, 2.6}},
    Kind{"shake-wrist",
         "Shake the tool from the wrist, two to three times a second: tilt it in all directions while twisting it.",
         {0.12, 0.09, 0.09},
         {2.8, 2.4, 2.0},
         true},
    Kind{"swing-wrist",
         "Swing the tool from the wrist, once a second: tilt it in all directions while twisting it.",
         {0.4, 0.2, 0.2},
         {1.4, 1.0, 0.8},
         true},
};

/// The tool's axes in S: sideways, forwards, long. The long axis is that of the least moment of inertia where the body
/// clearly is long, else the way from the sensor to the centre of mass.
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
double durationOf(const Kind& kind, double longest) {
  double hz = INFINITY;
  for (std::size_t i = 0; i < 3; ++i)
    if (kind.amplitude[i] > 0.0) hz = std::min(hz, kind.hz[i]);
  return std::min(longest, std::max(1.0, std::floor(longest * hz)) / hz);
}

/// Rates of the kind's three angles.
Vector3d rates(const Kind& kind, double scale, double t, double duration) {
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

/// Joint motion that turns S with the kind's angular velocity about the point `pivot` of the tool, which stays where it
/// is as far as the arm can do both; or that of the wrist's joints alone.
JointMotion motionFor(const Kind& kind, double scale, const GuidedTool& tool, const Matrix3d& axes,
                      const Vector3d& pivot, const VectorXd& start, double longest) {
  const double duration = durationOf(kind, longest);
  const auto n = static_cast<Eigen::Index>(std::lround(duration / kStep)) + 1;
  const Eigen::Index dof = start.size();
  JointMotion motion;
  motion.time = VectorXd::LinSpaced(n, 0.0, kStep * static_cast<double>(n - 1));
  motion.q.resize(n, dof);
  motion.dq.resize(n, dof);
  const Isometry3d X_LP = tool.X_LS * Eigen::Translation3d(pivot);
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
    twist << Vector3d::Zero(), R * axes * rate;
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

/// The kind as large as the limits allow and as arm and room leave it, or nothing. `inTheWay` gets what was met on it.
std::optional<Advice> fitted(const Kind& kind, const GuidedTool& tool, const Matrix3d& axes, const Vector3d& pivot,
                             const VectorXd& q, const CoachOptions& options, std::optional<Conflict>& inTheWay) {
  double scale = 1.0;
  for (int attempt = 0; attempt < 6; ++attempt) {
    Advice advice;
    advice.motion = motionFor(kind, scale, tool, axes, pivot, q, options.duration);
    advice.use = limitUse(tool, advice.motion, options.limits);
    if (advice.use.kept()) {
      const auto conflict =
          options.limits.clearance ? options.limits.clearance->firstConflict(advice.motion) : std::nullopt;
      if (!conflict) {
        advice.id = kind.id;
        advice.sentence = kind.sentence;
        return advice;
      }
      inTheWay = conflict;
      scale *= kSmaller;
      if (scale < kMinimumScale || conflict->time <= 0.0) break;
      continue;
    }
    const LimitUse& u = advice.use;
    // Rates go with the size; a range's use does not start at zero.
    const double rates = std::max({u.velocity, u.acceleration, u.tcpSpeed, u.cartesian});
    scale *= std::min(rates > 1.0 ? kFill / rates : 1.0, u.position > 1.0 ? kSmaller : 1.0);
    if (scale < kMinimumScale) break;
  }
  return std::nullopt;
}

struct Candidate {
  Advice advice;
  Triangle rows;  ///< What it would add
};

/// How much less is unknown: of what is wanted, and of the rest to decide between equals.
double score(const Uncertainty& before, const Uncertainty& after, CoachGoal want) {
  double out = 0.0;
  for (const CoachGoal quantity : kAll)
    out += (quantity == want ? 1.0 : 0.1) * std::log(before.of(quantity) / after.of(quantity));
  return out;
}

/// The candidate to begin with. Looks two motions ahead: turns about one axis tell nothing of the others, so that the
/// worst known moment may take two of them; the one that alone does more comes first.
std::size_t mostUseful(const std::vector<Candidate>& candidates, const OnlineInformation& information,
                       const Uncertainty& before, CoachGoal want) {
  const auto alone = [&](std::size_t i) { return score(before, candidates[i].advice.after, want); };
  std::size_t best = 0;
  double most = -INFINITY;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const OnlineInformation first = informationWith(information, candidates[i].rows);
    for (std::size_t j = 0; j <= i; ++j) {
      const double both = score(before, uncertaintyOf(informationWith(first, candidates[j].rows)), want);
      if (both <= most) continue;
      most = both;
      best = alone(j) > alone(i) ? j : i;
    }
  }
  return best;
}

std::string noRoom(const Conflict& conflict) {
  return heft::say(
      "No motion from this posture stays clear of everything: {} Bring the arm to where there is more room.",
      conflict.sentence());
}

VectorXd furthest(const GuidedTool& tool, const JointMotion& motion) {
  const Matrix3d start = tool.robot->linkPose(motion.q.row(0).transpose(), tool.link).linear();
  Eigen::Index best = 0;
  double most = -1.0;
  for (Eigen::Index k = 0; k < motion.size(); k += 5) {
    const Matrix3d R = tool.robot->linkPose(motion.q.row(k).transpose(), tool.link).linear();
    const double angle = vectorFromRotation(start.transpose() * R).norm();
    if (angle > most) {
      most = angle;
      best = k;
    }
  }
  return motion.q.row(best).transpose();
}

}  // namespace

Result<Advice> advise(const std::optional<OnlineInformation>& information, const GuidedTool& given,
                      const Vector3d& gravity, const VectorXd& q, const CoachOptions& options) {
  if (!(options.limits.tcpSpeed > 0.0) || !(options.duration >= 1.0))
    return Error{heft::say("A proposed motion needs a speed above zero and at least one second.")};
  const RobotModel& robot = *given.robot;
  if (robot.clampToLimits(q) != q)
    return Error{heft::say("The posture is outside the joints' ranges: no motion can start there.")};
  GuidedTool tool = given;
  Vector3d pivot = Vector3d::Zero();
  Uncertainty before;
  if (information) {
    before = uncertaintyOf(*information);
    const Vector3d com = fromParameters(information->solution.phi).com;
    if (before.com < 0.05 && com.norm() < 0.5) {
      pivot = com;
      tool.points.push_back(com);
    }
  }
  const auto lack = [&](CoachGoal quantity) { return before.of(quantity) / kEnough.of(quantity); };
  CoachGoal want = options.want.value_or(CoachGoal::com);
  if (information && !options.want)
    want = *std::max_element(kAll.begin(), kAll.end(), [&](CoachGoal a, CoachGoal b) { return lack(a) < lack(b); });
  if (information && lack(want) <= 1.0) {
    Advice done;
    done.needed = false;
    done.about = want;
    done.sentence = "Nothing more is needed: this is known well.";
    done.before = done.after = before;
    return done;
  }

  const Matrix3d axes = toolAxes(information);
  std::vector<Candidate> candidates;
  std::optional<Conflict> inTheWay;
  for (const Kind& kind : kKinds) {
    auto advice = fitted(kind, tool, axes, pivot, q, options, inTheWay);
    if (!advice) continue;
    Triangle rows = Triangle::Zero();
    if (information) {
      rows = rowsOfMotion(*information, tool, gravity, advice->motion);
      advice->after = uncertaintyOf(informationWith(*information, rows));
    }
    candidates.push_back({std::move(*advice), rows});
    // Nothing to compare by: the first slow tilt that the arm can make.
    if (!information) break;
  }
  std::optional<Advice> best;
  if (!candidates.empty())
    best = std::move(candidates[information ? mostUseful(candidates, *information, before, want) : 0].advice);
  if (!best && inTheWay) return Error{noRoom(*inTheWay)};
  if (!best)
    return Error{heft::say(
        "No motion from this posture keeps all limits. Bring the arm into the middle of its joints' ranges first.")};
  best->about = want;
  best->before = before;
  if (information) best->gain = gainWords(want, before, best->after);
  best->target = furthest(tool, best->motion);
  return std::move(*best);
}

Result<Advice> namedMotion(std::string_view id, const GuidedTool& tool, const VectorXd& q,
                           const CoachOptions& options) {
  const auto kind = std::find_if(kKinds.begin(), kKinds.end(), [&](const Kind& each) { return id == each.id; });
  if (kind == kKinds.end()) return Error{heft::say("The coach has no motion called \"{}\".", id)};
  if (tool.robot->clampToLimits(q) != q)
    return Error{heft::say("The posture is outside the joints' ranges: no motion can start there.")};
  std::optional<Conflict> inTheWay;
  auto advice = fitted(*kind, tool, toolAxes(std::nullopt), Vector3d::Zero(), q, options, inTheWay);
  if (!advice && inTheWay) return Error{noRoom(*inTheWay)};
  if (!advice)
    return Error{heft::say(
        "This motion does not keep the limits from here. Bring the arm into the middle of its joints' ranges.")};
  advice->target = furthest(tool, advice->motion);
  return std::move(*advice);
}

}  // namespace heft
