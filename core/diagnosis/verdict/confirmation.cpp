#include "core/diagnosis/verdict/confirmation.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/diagnosis/artefacts/own_errors.h"
#include "core/diagnosis/artefacts/sharp_motion.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/causes/catalogue.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/search/alternatives.h"
#include "core/diagnosis/search/cross_validation.h"
#include "core/diagnosis/search/evidence.h"
#include "core/diagnosis/verdict/description.h"
#include "core/diagnosis/verdict/unknown.h"

namespace heft::diagnosis {

namespace {

/// Where our own smoothing leaves a faint cause that does what another one does nearly alone, the other is judged
/// without it: beside it, either would be needless. The two are then rivals.
void keepOneOfTwo(Hypothesis& hypothesis) {
  Search& search = hypothesis.search;
  const auto changesFast = [](const Found& f) { return lags(f.cause) || enlarges(f.cause); };
  for (std::size_t own = 0; own < search.found.size(); ++own) {
    if (!changesFast(search.found[own]) || search.found[own].gain > 2.0 * kFaint ||
        !ownErrors(hypothesis, search.found[own]))
      continue;
    const Fit alone =
        fitModel(hypothesis.signals, hypothesis.stretches, without(search.final.model, search.found[own].cause));
    if (!believable(alone)) continue;
    for (Found& other : search.found) {
      if (&other == &search.found[own] || !changesFast(other)) continue;
      const Fit neither = fitModel(hypothesis.signals, hypothesis.stretches, without(alone.model, other.cause)),
                instead = fitModel(hypothesis.signals, hypothesis.stretches, without(search.final.model, other.cause));
      const double gain = alone.evidence - neither.evidence;
      if (gain < kStandsOut * other.gain) continue;
      other.gain = gain;
      const Rival rival{search.found[own].cause,   alone.evidence - instead.evidence, 0.0, 0, false,
                        instead.model.x.tail<10>()};
      if (believable(instead) && tied(other, rival)) other.rivals.push_back(rival);
      search.final = alone;
      search.found.erase(search.found.begin() + static_cast<std::ptrdiff_t>(own));
      return;
    }
  }
}

/// Whether any amplitude of `cause` is known to differ from none, or all of them together where it has several terms.
bool standsOut(const Fit& fit, std::string_view cause) {
  const Amplitudes all = amplitudesOf(fit, [&](const Term& t) { return causeOf(t) == cause; });
  const auto count = static_cast<double>(all.sizes.size());
  if (all.sizes.size() == 0) return true;  // It has a shape, no size.
  return (all.sizes.array().square() > kDeviations * kDeviations * all.covariance.diagonal().array()).any() ||
         (count > 1.0 && all.squaredDeviations() > kDeviations * kDeviations * count);
}

/// Whether a cause of one number is nothing, as far as that is known.
bool isNothing(const Fit& fit, const Found& found) {
  std::vector<IndexedTerm> own = indexedTerms(fit.model);
  std::erase_if(own, [&](const IndexedTerm& p) { return causeOf(*p.term) != found.cause; });
  if (own.size() != 1 || own[0].term->v.size() != 1) return false;
  const auto [only, at] = own[0];
  double variance = fit.covariance(at, at);
  for (const VectorXd& more : {only->form->cause->modelStd(*only->form, only->v), found.spread})
    if (more.size() == 1) variance += more(0) * more(0);
  return std::pow(only->v(0) - only->form->start(0), 2) < variance;
}

/// How long a term with a place in time acts [s].
double lasts(const Term& term, const Signals& signals) {
  double out = 0.0;
  for (const auto& [from, to] : term.form->cause->when(*term.form, term.v, signals)) out += to - from;
  return out;
}

/// What is asked of a cause.
struct Needed {
  double always = 0.0;  ///< Share of the unseen misfit that it must explain
  /// Whether more is asked where little evidence speaks for it: not where without such ones something unknown is left.
  bool moreOfFaint = true;
};

/// Whether a cause holds that gains `gain` on unseen stretches. `strongest`: evidence of the strongest one.
bool holds(const Found& found, const Gain& gain, const Hypothesis& hypothesis, double strongest, const Needed& needed) {
  const Fit& final = hypothesis.search.final;
  const auto anyTerm = [&](const auto& is) {
    return std::ranges::any_of(final.model.terms, [&](const Term& t) { return causeOf(t) == found.cause && is(t); });
  };
  if (isNothing(final, found)) return false;
  if (found.gain < (found.cause == ids::biasDrift && takesAnyCourse(final.model) ? kOverwhelming
                    : needed.moreOfFaint                                         ? kNamed
                                                                                 : 0.0))
    return false;
  // Beside something unknown, what may as well be nothing is a part of that; so is an event that may be, and one size
  // that was sought with further numbers, such as a loose mass with its frequency.
  const auto sought = [](const Term& t) {
    Eigen::Index sizes = 0;
    for (Eigen::Index p = 0; p < t.v.size(); ++p) sizes += isAmplitude(*t.form, p) ? 1 : 0;
    return t.form->local || (sizes == 1 && t.v.size() > 1);
  };
  if ((needed.always > 0.0 || anyTerm(sought)) && !standsOut(final, found.cause)) return false;
  const bool faint = found.gain < kFaint, mostly = 2 * gain.blocksBetter >= gain.blocks;
  // Faint beside a strong one, it may be no more than what that one's form does not quite have.
  const bool leftover = needed.moreOfFaint && found.gain < std::min(2.0 * kFaint, kEventError * strongest);
  // Where nearly all parts are better, one of them is not like the others, such as the first of a drift that settles.
  // Eight of ten are by chance once in twenty (sign test), nine in a hundred: beside something unknown, which may be
  // the others, the latter is asked, or that all of it is better for certain.
  const auto blocks = static_cast<double>(gain.blocks), better = static_cast<double>(gain.blocksBetter);
  const bool byChance = needed.always > 0.0 && gain.lower <= 0.0 && better < kNearlyAll * blocks;
  if (!leftover && !faint && !byChance && better >= kLargeShare * blocks) return true;
  if (gain.explainedFraction < -kSmallShare) return false;
  // What has its place in time can hardly be seen elsewhere. What begins and stays is seen on all later blocks.
  const bool helps = !faint && gain.explainedFraction > 0.0;
  if (anyTerm([&](const Term& t) { return t.form->local && (helps || lasts(t, hypothesis.signals) < kBriefly); }))
    return true;
  const double least = leftover                    ? kFormError
                       : found.gain < 2.0 * kFaint ? std::max(needed.always, kHardlyAny)
                                                   : needed.always;
  // Better on six blocks of ten is chance: beside something unknown that is not enough.
  if (needed.always > 0.0) return gain.explainedFraction > least && gain.lower > 0.0;
  if (gain.explainedFraction > least) return mostly;
  // What has chosen from many frequencies or speeds explains a little of any noise.
  const bool chose = anyTerm([](const Term& t) { return t.form->scan.size() < t.form->parameters.size(); });
  return !leftover && !chose && gain.explainedFraction > needed.always && gain.lower > 0.0 && mostly;
}

/// Whether little speaks for a cause, and more for knocks at the arm that the smoothing of the motion took. Of 137
/// recordings in which little spoke for something, right causes of less than 150 had a fifth of that there at most, but
/// for one that was a smoothing of the motion itself.
bool mayBeSharpMotion(const Hypothesis& hypothesis, const Fit& without, const Found& found) {
  return found.gain < 2.0 * kFaint && gainOfSharpMotion(hypothesis.signals, hypothesis.stretches, without) > found.gain;
}

/// The fit with a zero that walks instead of a drift that takes any course, where that is more than nothing.
Fit withWalkInstead(const Hypothesis& hypothesis, const Fit& rest) {
  const Cause& walk = *findCause(kRandomWalk);
  Model model = rest.model;
  for (Form& form : walk.forms(hypothesis.signals)) {
    const VectorXd start = form.start;
    model.terms.push_back({std::make_shared<const Form>(std::move(form)), start, {}});
  }
  Fit with = fitModel(hypothesis.signals, hypothesis.stretches, std::move(model));
  return believable(with) && with.evidence > rest.evidence + kThreshold ? with : rest;
}

/// Readings in coarse steps, and no noise that would wipe these out: what a step hides goes with the load, as causes
/// do.
class Steps {
 public:
  /// `steps`: as of CoarseReadings. A channel that never leaves one has those of the others of its kind.
  Steps(const Hypothesis& hypothesis, const Vector6d& steps) : size_(steps) {
    constexpr double kAlike = 2.0;  // What is left, and what steps leave, at most times the other
    for (const Eigen::Index kind : {0, 3}) {
      auto of = size_.segment<3>(kind);
      of = (of.array() > 0.0).select(of, of.maxCoeff()).eval();
    }
    if (!(size_.minCoeff() > 0.0)) return;
    const Vector6d left = usualPower(hypothesis.signals, hypothesis.search.final, {}).cwiseSqrt();
    const Vector6d times = std::sqrt(12.0) * left.cwiseQuotient(size_);
    coarse_ = times.maxCoeff() < kAlike && times.maxCoeff() > 1.0 / kAlike;
  }

  /// Whether steps alone may have made what a cause explains: a reading is half a step off at most, and `without` the
  /// cause hardly any is, or as many are with it. Of 60 recordings with steps and another effect, that one took 0.98 or
  /// more of what was off farther than that, or where this was a lot, most of it; of 31 causes that were steps alone,
  /// two did.
  bool mayExplain(const Hypothesis& hypothesis, const Fit& without) const {
    if (!coarse_) return false;
    const double before = beyond(hypothesis, without.residual),
                 after = beyond(hypothesis, hypothesis.search.final.residual);
    return !(after < kTinyShare * before || before - after > kSmallShare);
  }

 private:
  /// Mean over the judged blocks of the square of what is left beyond half a step, in steps.
  double beyond(const Hypothesis& hypothesis, const Wrenches& left) const {
    double sum = 0.0, blocks = 1e-300;
    for (const Stretch& s : hypothesis.stretches)
      for (Eigen::Index n = s.from; n < s.to; ++n) {
        sum += (left.col(n).cwiseAbs().cwiseQuotient(size_).array() - 0.5).max(0.0).square().sum();
        blocks += 1.0;
      }
    return sum / blocks;
  }

  Vector6d size_;
  bool coarse_ = false;
};

struct Round {
  std::vector<DiagnosedCause> causes;
  Wrenches last;                        ///< As of Confirmed
  std::vector<DiagnosedCause> aligned;  ///< The same
  std::vector<Found> own;               ///< The same
  bool dropped = false;                 ///< Whether any did not hold
};

Round judged(Hypothesis& hypothesis, const Needed& needed, const Surrogates& chance, const Steps& steps, bool held) {
  Round out;
  Search& search = hypothesis.search;
  out.last = heldOutResidual(hypothesis.signals, hypothesis.stretches, search.final);
  // The weakest first: what it takes with it must not be counted against the others.
  std::vector<const Found*> order;
  for (const Found& found : search.found) order.push_back(&found);
  std::ranges::stable_sort(order, {}, &Found::gain);
  std::map<const Found*, DiagnosedCause> kept;
  for (const Found* found : order) {
    // Part of the model, but no cause that somebody could mend.
    const bool turned = hypothesis.mountTurnReported && found->cause == ids::sensorRotation;
    if (found->cause == kRandomWalk || turned) continue;
    if (madeByAlignment(hypothesis, *found)) {
      DiagnosedCause& aligned = out.aligned.emplace_back();
      aligned.id = found->cause;
      describe(aligned, search.final, found->spread, hypothesis.signals, hypothesis.stretches);
      continue;
    }
    if (ownErrors(hypothesis, *found)) {
      out.own.push_back(*found);
      continue;
    }
    const Model less = without(search.final.model, found->cause);
    Fit rest = fitModel(hypothesis.signals, hypothesis.stretches, less);
    Wrenches before = heldOutResidual(hypothesis.signals, hypothesis.stretches, rest);
    const Gain gain = gainOf(hypothesis.stretches, search.final.noise, before, out.last);
    if (steps.mayExplain(hypothesis, rest) || mayBeSharpMotion(hypothesis, rest, *found) ||
        !holds(*found, gain, hypothesis, order.back()->gain, needed)) {
      if (found->cause == ids::biasDrift && takesAnyCourse(search.final.model) && !hasRandomWalk(less)) {
        rest = withWalkInstead(hypothesis, std::move(rest));
        before = heldOutResidual(hypothesis.signals, hypothesis.stretches, rest);
      }
      search.final = std::move(rest);
      out.last = std::move(before);
      out.dropped = true;
      continue;
    }
    DiagnosedCause& cause = kept[found];
    cause.id = found->cause;
    cause.deltaBic = found->gain;
    cause.pValue = chance.best.empty() ? std::exp(-0.5 * found->gain) : chance.pValue(found->gain);
    cause.gain = gain;
    cause.alternatives = alternativesOf(*found, search.final, held, hypothesis.signals.gravity);
    cause.before = std::move(before);
    cause.after = out.last;
  }
  // What only made up for another one that did not hold.
  if (out.dropped)
    std::erase_if(kept, [&](const auto& each) {
      if (!isNothing(search.final, *each.first)) return false;
      search.final = fitModel(hypothesis.signals, hypothesis.stretches, without(search.final.model, each.first->cause));
      out.last = heldOutResidual(hypothesis.signals, hypothesis.stretches, search.final);
      return true;
    });
  for (const Found& found : search.found) {
    const auto cause = kept.find(&found);
    if (cause == kept.end()) continue;
    describe(cause->second, search.final, found.spread, hypothesis.signals, hypothesis.stretches);
    out.causes.push_back(std::move(cause->second));
  }
  return out;
}

}  // namespace

Confirmed confirmed(Hypothesis& hypothesis, const Surrogates& chance, const Vector6d& steps, bool held) {
  keepOneOfTwo(hypothesis);
  const Structure beside = structureIn(hypothesis.signals, hypothesis.stretches, hypothesis.search.final);
  const Search before = hypothesis.search;
  // Where something unknown remains, a small gain may be that in disguise: then more is asked of a cause.
  Needed needed{beside.gain > kUnexplained ? kFormError : 0.0};
  const Steps coarse(hypothesis, steps);
  Confirmed out;
  out.first = heldOutResidual(hypothesis.signals, hypothesis.stretches, hypothesis.search.null);
  const auto judge = [&] {
    Round round = judged(hypothesis, needed, chance, coarse, held);
    out.causes = std::move(round.causes);
    out.last = std::move(round.last);
    out.aligned = std::move(round.aligned);
    out.own = std::move(round.own);
    out.remaining =
        round.dropped ? structureIn(hypothesis.signals, hypothesis.stretches, hypothesis.search.final) : beside;
  };
  judge();
  if (beside.gain <= kUnexplained && out.remaining.gain > kUnexplained) {
    // Without what explains little, something unknown is left: then it does explain that.
    hypothesis.search = before;
    needed.moreOfFaint = false;
    judge();
  }
  return out;
}

}  // namespace heft::diagnosis
