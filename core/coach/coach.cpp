#include "core/coach/coach.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/base/say.h"
#include "core/coach/turn_kinds.h"

namespace heft {

namespace {

constexpr std::array kAll{CoachGoal::mass, CoachGoal::com, CoachGoal::inertia};
// Standard deviations with which nothing more need be done.
constexpr Uncertainty kEnough{0.002, 0.0005, 0.02};

struct Candidate {
  FittedTurn turn;
  Triangle rows;  ///< What it would add
};

/// How much less is unknown: of what is wanted, and of the rest to decide between equals.
double score(const Uncertainty& before, const Uncertainty& after, CoachGoal want) {
  double out = 0.0;
  for (const CoachGoal quantity : kAll)
    out += (quantity == want ? 1.0 : 0.1) * std::log(before.of(quantity) / after.of(quantity));
  return out;
}

/// What it is chosen for, and from what.
struct Question {
  const GuidedTool& tool;
  const OnlineInformation& information;
  const CoachOptions& options;
  Uncertainty before;
  CoachGoal want;
  double scoreOf(const OnlineInformation& known) const { return score(before, uncertaintyOf(known), want); }
};

Candidate candidateOf(FittedTurn turn, const Question& question) {
  const Triangle rows =
      rowsOfMotion(question.information, question.tool, question.options.limits.gravity, turn.advice.motion);
  turn.advice.after = uncertaintyOf(informationWith(question.information, rows));
  return {std::move(turn), rows};
}

/// Indices of the candidate to begin with and of the one to go on with. Looks two motions ahead: turns about one axis
/// tell nothing of the others, so that the worst known moment may take two of them; the one that alone does more comes
/// first.
std::pair<std::size_t, std::size_t> mostUseful(const std::vector<Candidate>& candidates, const Question& question) {
  const auto alone = [&](std::size_t i) {
    return score(question.before, candidates[i].turn.advice.after, question.want);
  };
  std::pair<std::size_t, std::size_t> best{0, 0};
  double most = -INFINITY;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const OnlineInformation first = informationWith(question.information, candidates[i].rows);
    for (std::size_t j = 0; j <= i; ++j) {
      const double both = question.scoreOf(informationWith(first, candidates[j].rows));
      if (both <= most) continue;
      most = both;
      best = alone(j) > alone(i) ? std::pair{j, i} : std::pair{i, j};
    }
  }
  return best;
}

/// The same kind with sizes and frequencies of its waves that tell more before `next` is made: a search along one
/// coordinate after the other, whose every step keeps the limits.
Candidate refined(Candidate best, const Triangle& next, const TurnPlace& place, const Question& question) {
  constexpr int kRounds = 2;
  constexpr double kLarger = 1.5, kHigher = 1.25;  // Ratios
  constexpr double kGain = 0.01;                   // Of the score; less is not worth the time
  const OnlineInformation then = informationWith(question.information, next);
  const auto scoreOf = [&](const Candidate& c) { return question.scoreOf(informationWith(then, c.rows)); };
  const TurnKind listed = *std::ranges::find(turnKinds(), std::string_view(best.turn.kind.id),
                                             [](const TurnKind& kind) { return std::string_view(kind.id); });
  double most = scoreOf(best);
  const auto improves = [&](const TurnKind& kind) {
    TurnRefusal ignored;
    auto turn = fitted(kind, place, question.options, largestOf(kind), ignored);
    if (!turn) return false;
    Candidate other = candidateOf(std::move(*turn), question);
    const double reached = scoreOf(other);
    if (reached < most + kGain) return false;
    most = reached;
    best = std::move(other);
    return true;
  };
  const int waves = static_cast<int>(std::ranges::count_if(listed.amplitude, [](double a) { return a > 0.0; }));
  for (int round = 0; round < kRounds; ++round) {
    bool better = false;
    for (std::size_t i = 0; i < 3 && waves > 1; ++i)
      for (const double ratio : {kLarger, 1.0 / kLarger}) {
        TurnKind kind = best.turn.kind;
        if (!(kind.amplitude[i] > 0.0)) continue;
        kind.amplitude[i] *= ratio;
        better = improves(kind) || better;
      }
    for (const double ratio : {kHigher, 1.0 / kHigher}) {
      TurnKind kind = best.turn.kind;
      for (double& hz : kind.hz) hz *= ratio;
      if (isStill(listed, kind)) better = improves(kind) || better;
    }
    if (!better) break;
  }
  return best;
}

std::string noRoom(const Conflict& conflict) {
  return heft::say(
      "No motion from this posture stays clear of everything: {} Move the arm to where there is more room.",
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

Error whyNot(const TurnRefusal& refusal, const std::string& otherwise) {
  if (refusal.inTheWay) return Error{noRoom(*refusal.inTheWay)};
  if (refusal.tooHeavy)
    return Error{
        heft::say("The arm is not strong enough for a motion from this posture: {}", refusal.tooHeavy->sentence())};
  return Error{otherwise};
}

/// With nothing to compare by: the first slow tilt that the arm can make.
std::optional<Advice> firstOf(const TurnPlace& place, const CoachOptions& options, TurnRefusal& refusal) {
  for (const TurnKind& kind : turnKinds())
    if (auto turn = fitted(kind, place, options, 1.0, refusal)) return std::move(turn->advice);
  return std::nullopt;
}

std::optional<Advice> bestOf(const Question& question, const TurnPlace& place, TurnRefusal& refusal) {
  std::vector<Candidate> candidates;
  for (const TurnKind& kind : turnKinds())
    if (auto turn = fitted(kind, place, question.options, largestOf(kind), refusal))
      candidates.push_back(candidateOf(std::move(*turn), question));
  if (candidates.empty()) return std::nullopt;
  const auto [first, next] = mostUseful(candidates, question);
  return refined(candidates[first], candidates[next].rows, place, question).turn.advice;
}

}  // namespace

Result<Advice> advise(const std::optional<OnlineInformation>& information, const GuidedTool& given,
                      const Vector3d& gravity, const VectorXd& q, const CoachOptions& wanted) {
  if (!(wanted.limits.tcpSpeed > 0.0) || !(wanted.duration >= 1.0))
    return Error{heft::say("A proposed motion needs a speed above zero and at least one second.")};
  const RobotModel& robot = *given.robot;
  if (robot.clampToLimits(q) != q)
    return Error{heft::say("The posture is outside the joints' ranges: no motion can start there.")};
  GuidedTool tool = given;
  CoachOptions options = wanted;
  options.limits.gravity = gravity;
  Vector3d pivot = Vector3d::Zero();
  Uncertainty before;
  if (information) {
    before = uncertaintyOf(*information);
    options.limits.payload = fromParameters(information->solution.phi);
    const Vector3d com = options.limits.payload->com;
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

  const TurnPlace place{&tool, toolAxes(information), pivot, q};
  TurnRefusal refusal;
  std::optional<Advice> best = information ? bestOf({tool, *information, options, before, want}, place, refusal)
                                           : firstOf(place, options, refusal);
  if (!best)
    return whyNot(
        refusal,
        heft::say("No motion from this posture stays within all limits. Bring the joints to mid-range first."));
  best->about = want;
  best->before = before;
  if (information) best->gain = gainWords(want, before, best->after);
  best->target = furthest(tool, best->motion);
  return std::move(*best);
}

Result<Advice> namedMotion(std::string_view id, const GuidedTool& tool, const VectorXd& q,
                           const CoachOptions& options) {
  const auto kind = std::ranges::find(turnKinds(), id, [](const TurnKind& each) { return std::string_view(each.id); });
  if (kind == turnKinds().end()) return Error{heft::say("The coach has no motion called \"{}\".", id)};
  if (tool.robot->clampToLimits(q) != q)
    return Error{heft::say("The posture is outside the joints' ranges: no motion can start there.")};
  TurnRefusal refusal;
  auto turn = fitted(*kind, {&tool, toolAxes(std::nullopt), Vector3d::Zero(), q}, options, 1.0, refusal);
  if (!turn)
    return whyNot(refusal, heft::say("This motion exceeds the limits from here. Bring the joints to mid-range first."));
  Advice advice = std::move(turn->advice);
  advice.target = furthest(tool, advice.motion);
  return advice;
}

}  // namespace heft
