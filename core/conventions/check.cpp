#include "core/conventions/check.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/conventions/search.h"
#include "core/math/linear_algebra.h"

namespace heft::conventions {

namespace {

/// What is less than this behind the best is not out: odds of 80 to 1, as much as can be asked: below the price of a
/// change, so that the simpler of two that fit alike is told.
const double kTie = 2.0 * std::log(80.0);
/// A convention overthrows the stated ones only if nobody could doubt it, and causes could not feign it: the prototype
/// saw 370 and more in 24 poses, 6,500 and more in motions, and never more than that by chance.
constexpr double kOverwhelming = 60.0;
/// The best leaves at most this share of the load, and clearly less than the stated conventions: a torque's sign or
/// unit shows in the small part of the force that turning makes, beside contact and causes that stay.
constexpr double kExplains = 0.3, kBetter = 0.85;
/// Of the evidence that a cause has, a convention must have as much.
constexpr double kShareOfCause = 0.9;
/// A sensor is not farther from where the setup file has it [m]; the catalogue of causes looks no farther.
constexpr double kFarthestOrigin = 0.5;
/// Beyond this share of the load the model does not describe the readings.
constexpr double kDescribes = 0.5;
/// Two payloads are the same thing: relative mass, and distance of centres [m].
constexpr double kSameMass = 0.02, kSameCentre = 0.003;

bool has(const std::vector<Change>& changes, Change change) {
  return std::find(changes.begin(), changes.end(), change) != changes.end();
}

/// A sensor that sits `point` beside its place and a torque about that point are the same readings and the same payload
/// in space: only where the sensor's origin is meant to be differs. Where the centre would lie in the arm behind that
/// origin, and does not behind the stated one, it is the torque's point.
bool isAboutAnotherPoint(const Candidate& c) {
  return c.payload.com.z() > -kBehind && (c.payload.com - c.fit.place.point).z() < -kBehind;
}

/// Its free part is too small for a convention, or a place of the sensor: the business of causes.
bool isSmall(const Candidate& c, const Reading& stated) {
  if (c.free == Free::mount) return vectorFromRotation(stated.turn.transpose() * c.fit.place.turn).norm() < kLeastTurn;
  if (c.free == Free::gravity) {
    const Vector3d &from = stated.gravity, &to = c.fit.place.gravity;
    const double turn = std::atan2(from.cross(to).norm(), from.dot(to));
    // Nearly the other way is that and a tilt; without the tilt it is a hypothesis of its own.
    return turn < kLeastTurn || turn > std::numbers::pi - kLeastTurn;
  }
  return c.free == Free::origin || (c.free == Free::point && !isAboutAnotherPoint(c));
}

/// It is small, and all the rest is as stated.
bool isCause(const Candidate& c, const Reading& stated) {
  if (c.fit.place.point.norm() > kFarthestOrigin) return false;
  constexpr Change kPlace[] = {Change::turned, Change::gravityTurned, Change::point};
  return isSmall(c, stated) && std::all_of(c.differs.begin(), c.differs.end(), [&](Change change) {
           return std::find(std::begin(kPlace), std::end(kPlace), change) != std::end(kPlace);
         });
}

bool isNegative(const Candidate& stated) {
  constexpr double kClearlyNegative = 5.0;  // Standard deviations
  return stated.fit.x(0) < -kClearlyNegative * std::sqrt(std::max(0.0, stated.fit.covariance(0, 0)));
}

/// The same changes with nearly the same payload.
bool isTold(const Candidate& c, const Candidate& first, const std::vector<Alternative>& ties) {
  const auto alike = [&](const std::vector<Change>& differs, const Payload& payload) {
    return differs == c.differs && std::abs(payload.mass - c.payload.mass) < kSameMass * std::abs(c.payload.mass) &&
           (payload.com - c.payload.com).norm() < kSameCentre;
  };
  return alike(first.differs, first.payload) ||
         std::any_of(ties.begin(), ties.end(), [&](const Alternative& tie) { return alike(tie.changes, tie.payload); });
}

Alternative alternativeOf(const Candidate& c, const Candidate& stated, const Reading& as) {
  return {c.reading, c.differs, c.score - stated.score, c.payload, c.misfit, sentence(as, c.reading)};
}

}  // namespace

bool Check::same(const Candidate& a, const Candidate& b) const {
  return std::abs(a.payload.mass - b.payload.mass) <= kSameMass * std::abs(a.payload.mass) &&
         (a.payload.com - b.payload.com).norm() <= kSameCentre;
}

Report Check::run() {
  Report report;
  report.stated = q_.stated;
  constexpr Eigen::Index kLeastPoses = 6, kLeastBlocks = 20;
  if (forms_.front().blocks.size() < (standing_ ? kLeastPoses : kLeastBlocks)) {
    report.enough = false;
    return report;
  }
  const Candidate stated = candidate(statedWay(), 0, Free::nothing, place_);
  report.statedMisfit = stated.misfit;
  report.statedPayload = stated.payload;
  if (std::ranges::find(q_.silent, true) != q_.silent.end()) {
    // Of axes that are turned, swapped or mirrored each needs all three readings.
    std::vector<Candidate> none;
    decide(stated, none, report);
    putIntoWords(q_, report);
    return report;
  }
  std::vector<Candidate> all;
  // Where somebody pushes shows under the stated conventions, too, unless they are far off: then they are out anyway.
  scanAll(stated.fit.weights, false, 4, all);
  std::sort(all.begin(), all.end(), byScore);
  // An acceleration that is not known looks like a disagreement.
  std::optional<Agreement> agreement;
  if (!isNegative(stated) && (standing_ || q_.motion->originAccelerationKnown))
    agreement = agreementOf(forms_.front().blocks, statedWay(), stated.fit);
  const bool doubtful = stated.misfit.worst() > kFits || stated.reach > 0.0 || isNegative(stated) ||
                        (agreement && agreement->ratioDisagrees()) ||
                        (!all.empty() && all.front().score - stated.score > kOverwhelming);
  if (doubtful) {
    addForms();
    scanAll({}, true, 10, all);
    std::sort(all.begin(), all.end(), byScore);
    // Whoever fits best knows best where somebody pushes.
    constexpr int kRescans = 3;
    for (int round = 0; round < kRescans && !all.empty(); ++round) {
      const double before = all.front().score;
      scanAll(all.front().fit.weights, true, 4, all);
      std::sort(all.begin(), all.end(), byScore);
      if (all.front().score <= before) break;
    }
    const std::size_t discrete = std::min<std::size_t>(2, all.size());
    addTurned(all.empty() ? stated.fit.weights : all.front().fit.weights, all);
    for (std::size_t i = 0; i < discrete; ++i)
      all.push_back(candidate(all[i].way, all[i].form, Free::gravity, all[i].fit.place));
    addCauses(all);
    std::sort(all.begin(), all.end(), byScore);
    // Of what can be suggested: small turns beside it are causes.
    const auto likeliest =
        std::find_if(all.begin(), all.end(), [&](const Candidate& c) { return !isSmall(c, q_.stated); });
    if (standing_ && likeliest != all.end()) {
      addOtherScales(Candidate(*likeliest), all);
      std::sort(all.begin(), all.end(), byScore);
    }
  }
  decide(stated, all, report);
  if (report.verdict == Verdict::asStated) report.agreement = agreement;
  putIntoWords(q_, report);
  return report;
}

void Check::decide(const Candidate& stated, std::vector<Candidate>& all, Report& report) const {
  // What a cause explains better is no convention, unless that explains nearly as much: causes bend more easily.
  double byCause = 0.0;
  for (const Candidate& c : all)
    if (isCause(c, q_.stated)) byCause = std::max(byCause, c.score - stated.score);
  // Half of that is worth telling, if not worth suggesting.
  const double standard = stated.score + 0.5 * byCause;
  std::erase_if(all, [&](const Candidate& c) { return isSmall(c, q_.stated); });
  const Candidate* first = all.empty() ? nullptr : &all.front();
  // A ratio of units shows in the first moment of force and torque alone, as another place of the sensor does: it has
  // to explain more.
  const auto shareOf = [](const Candidate& c) { return has(c.differs, Change::unit) ? 1.0 : kShareOfCause; };
  const bool cause = first != nullptr && first->score - stated.score < shareOf(*first) * byCause;
  report.misfit = stated.misfit;
  report.payload = stated.payload;
  report.covariance = stated.fit.covariance.topLeftCorner<10, 10>();
  if (first == nullptr) {
    if (isNegative(stated) || stated.misfit.worst() > kDescribes) report.verdict = Verdict::none;
    return;
  }
  report.overStated = first->score - stated.score;
  const bool impossible = isNegative(stated) || stated.reach > 0.0;
  const bool explains = !cause && report.overStated > kOverwhelming && first->misfit.worst() < kExplains &&
                        (impossible || first->misfit.worst() < kBetter * stated.misfit.worst());
  if (!explains) {
    report.evidence = -report.overStated;
    if (stated.misfit.worst() > kDescribes) {
      report.verdict = Verdict::none;
      return;
    }
    // The price of a change is for choosing; whether a motion can tell is another question. A unit's ratio is known to
    // people, and hardly any motion shows it: it is named only where it clearly fits better.
    for (const Candidate& c : all) {
      const bool scaled = has(c.differs, Change::unit);
      const double free = scaled ? 0.0 : priceOf(c.differs);
      if (standard - c.score - free < (scaled ? -kOverwhelming : kTie) && c.misfit.worst() < kExplains &&
          !same(stated, c))
        report.ties.push_back(alternativeOf(c, stated, q_.stated));
    }
    return;
  }
  // In standing poses nothing but the reach of the tool speaks for one ratio of units.
  report.verdict = standing_ && has(first->differs, Change::unit) ? Verdict::ambiguous : Verdict::suggested;
  report.suggested = first->reading;
  report.misfit = first->misfit;
  report.payload = first->payload;
  report.covariance = first->fit.covariance.topLeftCorner<10, 10>();
  // A base that stands, hangs or is bolted to a wall does so exactly.
  if (first->free != Free::gravity || first->reading.gravity == first->fit.place.gravity) {
    report.turnStd = std::sqrt(std::max(0.0, symmetricEigen(first->fit.turnCovariance).values(2)));
    report.fromFree = first->fit.fromFree;
  }
  report.evidence = report.overStated;
  for (std::size_t i = 1; i < all.size(); ++i) {
    const Candidate& c = all[i];
    const double priced = first->score - c.score, behind = std::min(priced, priced + first->prior - c.prior);
    if (!same(*first, c)) {
      if (behind < report.evidence || !report.next) report.next = alternativeOf(c, stated, q_.stated);
      report.evidence = std::min(report.evidence, behind);
    }
    if (behind >= kTie || isTold(c, *first, report.ties)) continue;
    if (!same(*first, c)) report.verdict = Verdict::ambiguous;
    report.ties.push_back(alternativeOf(c, stated, q_.stated));
  }
}

Report check(const Question& question) { return Check(question).run(); }

}  // namespace heft::conventions
