#include "core/diagnosis/search/candidate_fits.h"
#include "core/diagnosis/model/linearisation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <set>

#include "core/base/parallel.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/causes/catalogue.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/model/step_candidates.h"
#include "core/diagnosis/search/evidence.h"
#include "core/diagnosis/search/random_walk.h"
#include "core/math/linear_algebra.h"

namespace heft::diagnosis {

namespace {

constexpr std::size_t kTried = 8;       ///< Causes that get a fit in a step
constexpr std::size_t kTriedLater = 5;  ///< The same once there are several terms, which make each fit dear

/// Whether the first look found only roughly where the candidate gains most.
bool wantsPlace(const Candidate& candidate) { return candidate.form.atOnce && candidate.score > 0.0; }

/// A time in a gap between the stretches, or at an edge of one, at its middle: anywhere in it is as good, but what is
/// fitted from the edge moves away from it.
double awayFromEdges(const Signals& signals, const std::vector<Stretch>& stretches, double time) {
  const double block = 1.0 / signals.blockRate();
  for (std::size_t i = 1; i < stretches.size(); ++i) {
    const double from = signals.blockTime(stretches[i - 1].to - 1), to = signals.blockTime(stretches[i].from);
    if (to - from > 4.0 * block && time > from - 2.0 * block && time < to + 2.0 * block) return 0.5 * (from + to);
  }
  return time;
}

/// `columns`: of `base`. `placing`: around it; null where the candidate wants no place.
CandidateFit tried(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& base,
                   const CachedJacobian& columns, const OnsetRefinement* placing, const Candidate& candidate) {
  CandidateFit out;
  out.cause = candidate.form.cause->id();
  Candidate placed = candidate;
  if (wantsPlace(candidate)) {
    placed = placing->refined(candidate);
    placed.v(0) = std::clamp(awayFromEdges(signals, stretches, placed.v(0)), placed.form.parameters[0].lower,
                             placed.form.parameters[0].upper);
  }
  Model model = base.model;
  model.terms.push_back({std::make_shared<const Form>(placed.form), placed.v, placed.active});
  out.choicePenalty = candidate.choicePenalty;
  out.promised = candidate.score;
  out.fit = fitModel(signals, stretches, std::move(model), 3, &columns);
  // A walk makes steps of its own, too: where the zero is known to walk, a jump of it or of the load is more.
  const bool maybeWalk =
      (out.cause == ids::sensorBias || out.cause == ids::payloadChange) && contains(base.model, kRandomWalk);
  if (maybeWalk && !jumpStandsOut(signals, stretches, base, out.fit)) return out;
  weigh(out, base, signals);
  return out;
}

/// Whether another term of the form can add to the model: one with a place of its own may come again, any other that is
/// already in can not. Beside a drift a walk is none: what a straight line leaves has richer forms of drift.
bool mayAdd(const Form& form, const Model& model) {
  if (form.walk && contains(model, ids::biasDrift)) return false;
  return form.local || std::none_of(model.terms.begin(), model.terms.end(), [&](const Term& t) {
           return t.form->cause == form.cause && (t.form->name == form.name || t.form->alone || form.alone);
         });
}

/// Adds to `all` what guides grow into, which are no trials themselves, and what the channels of a zero that walks do
/// together, where nothing else is named: beside other causes any course would be a crutch for what these leave.
void growGuides(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& base,
                const CachedJacobian& columns, std::vector<CandidateFit>& all) {
  struct Start {
    std::pair<Form, VectorXd> at;
    const CandidateFit* guide;
    double choice;
  };
  std::vector<Start> starts;
  for (const CandidateFit& trial : all) {
    const Term& term = trial.fit.model.terms.back();
    if (!term.form->guide && (!term.form->walk || !base.model.terms.empty())) continue;
    auto grown = term.form->cause->grown(*term.form, term.v, signals);
    const double choice =
        trial.choicePenalty + 2.0 * std::log(static_cast<double>(std::max<std::size_t>(1, grown.size())));
    for (auto& at : grown) starts.push_back({std::move(at), &trial, choice});
  }
  std::vector<CandidateFit> more(starts.size());
  parallelFor(starts.size(), [&](std::size_t i) {
    Model model = base.model;
    model.terms.push_back({std::make_shared<const Form>(std::move(starts[i].at.first)), starts[i].at.second, {}});
    CandidateFit& trial = more[i];
    trial.cause = causeOf(model.terms.back());
    trial.choicePenalty = starts[i].choice;
    trial.promised = starts[i].guide->promised;
    trial.fit = fitModel(signals, stretches, std::move(model), 3, &columns);
    weigh(trial, base, signals);
  });
  std::erase_if(all, [](const CandidateFit& trial) { return trial.fit.model.terms.back().form->guide; });
  std::ranges::move(more, std::back_inserter(all));
}

/// Of each event that is looked for, one at each of several moments at which what is left leaps: beside others, one
/// that is a little off explains next to nothing.
void addAtLeaps(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& base,
                std::vector<Signature>& signatures) {
  constexpr std::size_t kMostEvents = 8;  // More are no events of the rig but what it does all the time
  const auto leaps = stepCandidatesIn(signals, stretches, base.residual);
  if (leaps.size() < 2 || leaps.size() > kMostEvents) return;
  std::vector<const Form*> kinds;
  for (const Signature& signature : signatures)
    if (signature.form.atOnce && std::ranges::none_of(kinds, [&](const Form* kind) {
          return kind->cause == signature.form.cause && kind->choice == signature.form.choice;
        }))
      kinds.push_back(&signature.form);
  std::vector<Signature> more(kinds.size() * leaps.size());
  const LinearisationPoint surroundings(signals, base.model);
  parallelFor(more.size(), [&](std::size_t i) {
    more[i] = signatureAt(leaps[i % leaps.size()].time, *kinds[i / leaps.size()], surroundings);
  });
  std::ranges::move(more, std::back_inserter(signatures));
}

/// A model with another term of `cause` in the place of one.
struct Replaced {
  Model model;
  std::string_view cause;
  double penalty = 0.0;
};

/// Fits of them to the end, as far as these can be believed. Added to `all`, best first.
void addReplaced(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& base,
                 std::vector<Replaced> models, std::vector<CandidateFit>& all) {
  std::vector<CandidateFit> more(models.size());
  parallelFor(models.size(), [&](std::size_t i) {
    more[i].cause = models[i].cause;
    more[i].penalty = models[i].penalty;
    more[i].fit = fitModel(signals, stretches, std::move(models[i].model));
    more[i].gain = more[i].fit.evidence - base.evidence - more[i].penalty;
  });
  std::erase_if(more, [](const CandidateFit& trial) { return !believable(trial.fit); });
  std::ranges::move(more, std::back_inserter(all));
  sortByGain(all);
}

}  // namespace

void weigh(CandidateFit& trial, const Fit& base, const Signals& signals) {
  const Term& term = trial.fit.model.terms.back();
  trial.penalty = trial.choicePenalty + term.form->cause->doubt(*term.form, term.v, signals);
  trial.gain = believable(trial.fit) ? trial.fit.evidence - base.evidence - trial.penalty : -1e300;
}

void settleAll(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& base,
               std::span<CandidateFit* const> which) {
  parallelFor(which.size(), [&](std::size_t i) {
    which[i]->fit = settled(signals, stretches, std::move(which[i]->fit));
    weigh(*which[i], base, signals);
  });
}

void sortByGain(std::vector<CandidateFit>& all) {
  std::stable_sort(all.begin(), all.end(),
                   [](const CandidateFit& a, const CandidateFit& b) { return a.gain > b.gain; });
}

std::vector<const Candidate*> chosenOf(const std::vector<Candidate>& ranked, std::size_t causes, double toBeat) {
  std::vector<const Candidate*> chosen;
  // A first look at all of a form's parameters promises about what the fit will reach; one at some of them, less: the
  // two do not compete for places.
  std::array<std::map<std::string_view, std::vector<const Candidate*>>, 2> forms;
  std::set<std::string_view> rare;
  for (const auto& candidate : ranked) {
    const bool whole = candidate.form.scan.size() == candidate.form.parameters.size();
    // A first look at a walk promises too little: how far it goes is learned only in a fit.
    if (candidate.form.walk) {
      chosen.push_back(&candidate);
      continue;
    }
    // What promises less hardly ever wins: trying down to a fifth changed numbers of 3 in 320 recordings, and no cause.
    if (candidate.score <
        std::max(whole ? 0.0 : -kTie, (whole ? 0.0 : -30.0) + kMajority * std::max(0.0, toBeat - 2.0 * kTie)))
      continue;
    auto& known = forms[whole ? 0 : 1];
    const auto id = candidate.form.cause->id();
    if (candidate.form.rare) {
      if (rare.insert(id).second) chosen.push_back(&candidate);
      continue;
    }
    if (known.size() >= causes && !known.contains(id)) continue;
    const std::size_t most = known.size() > 3 ? (whole ? 2 : 3) : whole ? 4 : 8;
    std::vector<const Candidate*>& same = known[id];
    // Neighbours in frequency or time are the same thing.
    const auto alike = std::count_if(
        same.begin(), same.end(), [&](const Candidate* other) { return other->form.choice == candidate.form.choice; });
    if (same.size() >= most || (alike >= 2 && !whole)) continue;
    same.push_back(&candidate);
    chosen.push_back(&candidate);
  }
  return chosen;
}

std::vector<CandidateFit> fitsOf(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& base,
                                 const std::vector<const Candidate*>& chosen) {
  std::vector<CandidateFit> all(chosen.size());
  if (chosen.empty()) return all;
  const CachedJacobian columns(signals, base.model);
  std::unique_ptr<const OnsetRefinement> placing;
  if (std::ranges::any_of(chosen, [](const Candidate* c) { return wantsPlace(*c); }))
    placing = std::make_unique<const OnsetRefinement>(signals, stretches, base, columns);
  parallelFor(chosen.size(),
              [&](std::size_t i) { all[i] = tried(signals, stretches, base, columns, placing.get(), *chosen[i]); });
  growGuides(signals, stretches, base, columns, all);
  sortByGain(all);
  // The best are fitted to the end: a few steps rank them, but what is compared must have come to rest. So are those
  // that promised to be the best and are not there yet: a large misfit takes more steps, since the noise is learned
  // alongside. Of 609 that promised and gained less than half the threshold so far, 8 came near it.
  std::vector<CandidateFit*> resting;
  for (std::size_t i = 0; i < all.size() && resting.size() < 2 * kFinished; ++i) {
    const bool hopeful = all[i].promised > std::max(all[i].gain, all.front().gain - 2.0 * kTie) + kTie,
               mayCount = all[i].gain > -1e299 && std::max(all[i].promised, all[i].gain) > kThreshold;
    if (mayCount && (i < kFinished || hopeful)) resting.push_back(&all[i]);
  }
  parallelFor(resting.size(), [&](std::size_t i) {
    CandidateFit& trial = *resting[i];
    trial.fit = fitModel(signals, stretches, trial.fit.model, 8, &columns);
    weigh(trial, base, signals);
    if (trial.gain > trial.promised - kTie) return;
    trial.fit = settled(signals, stretches, std::move(trial.fit), &columns);
    weigh(trial, base, signals);
  });
  sortByGain(all);
  return all;
}

std::vector<CandidateFit> candidateFits(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& base,
                                        const std::vector<Candidate>& ranked) {
  // What waves promise says nothing of what a cause must.
  const auto first = std::ranges::find_if(ranked, [](const Candidate& c) { return !c.form.walk; });
  const double promised = first == ranked.end() ? 0.0 : first->score;
  const std::size_t tries = base.model.terms.size() < 2 ? kTried : kTriedLater;
  auto chosen = chosenOf(ranked, tries, promised);
  auto all = fitsOf(signals, stretches, base, chosen);
  if (!all.empty() && all.front().gain >= kMinorShare * promised) return all;
  auto others = chosenOf(ranked, tries, 0.0);
  std::erase_if(others, [&](const Candidate* c) { return std::find(chosen.begin(), chosen.end(), c) != chosen.end(); });
  auto more = fitsOf(signals, stretches, base, others);
  std::move(more.begin(), more.end(), std::back_inserter(all));
  sortByGain(all);
  return all;
}

void addCompletions(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& base,
                    std::vector<CandidateFit>& all) {
  std::vector<Replaced> wholes;
  for (std::size_t i = 0; i < base.model.terms.size(); ++i) {
    const Term& term = base.model.terms[i];
    for (auto& [form, v] : term.form->cause->grown(*term.form, term.v, signals)) {
      if (form.cause != term.form->cause) continue;
      Model model = base.model;
      model.terms[i] = {std::make_shared<const Form>(std::move(form)), std::move(v), {}};
      wholes.push_back({std::move(model), causeOf(term)});
    }
    if (!term.form->subset || std::ranges::all_of(term.form->scan, [&](int p) { return term.moves(p); })) continue;
    Model model = base.model;
    model.terms[i].active.clear();
    wholes.push_back({std::move(model), causeOf(term)});
  }
  addReplaced(signals, stretches, base, std::move(wholes), all);
}

std::vector<Sibling> siblingsOf(const CandidateFit& accepted, const std::vector<CandidateFit>& all) {
  constexpr std::size_t kMostSiblings = 3;
  const Form& form = *accepted.fit.model.terms.back().form;
  const double least = accepted.gain - std::max(2.0 * kTie, kFormError * accepted.gain);
  std::vector<Sibling> out;
  for (const CandidateFit& trial : all) {
    const Term& term = trial.fit.model.terms.back();
    if (trial.cause != accepted.cause || trial.gain < least || out.size() == kMostSiblings || term.form->atOnce ||
        term.form->name == form.name || trial.fit.model.terms.size() != accepted.fit.model.terms.size() ||
        std::ranges::any_of(out, [&](const Sibling& s) { return s.term.form->name == term.form->name; }))
      continue;
    out.push_back({term, trial.penalty - accepted.penalty});
  }
  return out;
}

void addSiblings(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& base,
                 const std::vector<Sibling>& siblings, std::vector<CandidateFit>& all) {
  std::vector<Replaced> fitting;
  for (const Sibling& sibling : siblings) {
    const auto own = [&](const Term& t) { return t.form->cause == sibling.term.form->cause; };
    const auto& terms = base.model.terms;
    if (std::ranges::count_if(terms, own) != 1 ||
        std::ranges::find_if(terms, own)->form->name == sibling.term.form->name)
      continue;
    const std::string_view cause = causeOf(sibling.term);
    Model model = without(base.model, cause);
    model.terms.push_back(sibling.term);
    fitting.push_back({std::move(model), cause, sibling.penalty});
  }
  addReplaced(signals, stretches, base, std::move(fitting), all);
}

void addAtThatMoment(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& base,
                     const std::vector<Candidate>& ranked, std::vector<CandidateFit>& all) {
  if (all.empty() || !all.front().fit.model.terms.back().form->atOnce) return;
  const double moment = awayFromEdges(signals, stretches, all.front().fit.model.terms.back().v(0));
  const auto off = [&](const Candidate& c) { return std::abs(c.v(0) - moment); };
  std::map<std::string_view, const Candidate*> nearest;
  for (const Candidate& candidate : ranked) {
    if (!candidate.form.atOnce || candidate.form.cause->id() == all.front().cause) continue;
    const Candidate*& known = nearest[candidate.form.cause->id()];
    if (known == nullptr || off(candidate) < off(*known)) known = &candidate;
  }
  std::vector<Candidate> there;
  for (const auto& [cause, candidate] : nearest) {
    there.push_back(*candidate);
    Candidate& moved = there.back();
    moved.form.start(0) = moved.v(0) =
        std::clamp(moment, moved.form.parameters[0].lower, moved.form.parameters[0].upper);
    moved.score = 0.0;  // Placed already
  }
  std::vector<const Candidate*> chosen;
  for (const Candidate& candidate : there) chosen.push_back(&candidate);
  auto more = fitsOf(signals, stretches, base, chosen);
  std::move(more.begin(), more.end(), std::back_inserter(all));
  sortByGain(all);
}

std::vector<Candidate> promises(const Signals& signals, const std::vector<Stretch>& stretches, SignatureBank& bank,
                                const Fit& base, std::span<const std::string_view> causes) {
  auto signatures = bank.around(signals, base.model, [&](const Form& form) {
    return mayAdd(form, base.model) && (causes.empty() || std::ranges::find(causes, form.cause->id()) != causes.end());
  });
  if (causes.empty()) addAtLeaps(signals, stretches, base, signatures);
  return scan(signals, stretches, base, signatures);
}

Fit prunedOf(const Signals& signals, const std::vector<Stretch>& stretches, Fit fit, double threshold) {
  constexpr double kNeeded = 10.0;  // Times the threshold: what stands out like that is not fitted without, to be sure.
  const auto needless = [&](const Fit& without) {
    return believable(without) && fit.evidence - without.evidence < threshold;
  };
  for (bool changed = true; changed && fit.model.terms.size() > 1;) {
    changed = false;
    std::vector<std::size_t> doubtful;
    for (std::size_t i = 0; i < fit.model.terms.size(); ++i)
      if (standsOut(fit, i) <= kNeeded * threshold) doubtful.push_back(i);
    // Two at a time: the first one that is needless goes.
    for (std::size_t at = 0; at < doubtful.size() && !changed; at += 2) {
      std::vector<Fit> less(std::min<std::size_t>(2, doubtful.size() - at));
      parallelFor(less.size(), [&](std::size_t i) {
        Model model = fit.model;
        model.terms.erase(model.terms.begin() + static_cast<std::ptrdiff_t>(doubtful[at + i]));
        less[i] = fitModel(signals, stretches, std::move(model));
      });
      const auto first = std::ranges::find_if(less, needless);
      changed = first != less.end();
      if (changed) fit = std::move(*first);
    }
  }
  return fit;
}

bool believable(const Fit& fit) {
  if (fit.atBound) return false;
  const double mass = fit.model.x(6), sd = std::sqrt(std::max(0.0, fit.covariance(6, 6)));
  if (mass < -3.0 * sd || mass > 60.0) return false;
  if (!fit.model.packed().allFinite()) return false;
  for (const Term& a : fit.model.terms)
    for (const Term& b : fit.model.terms)
      if (&a < &b && a.form->atOnce && b.form->atOnce && a.form->cause == b.form->cause &&
          std::abs(a.v(0) - b.v(0)) < kMoment)
        return false;
  // What swings is a part of the payload, or all of it.
  const VectorXd std = fit.std();
  for (const auto& [term, at] : indexedTerms(fit.model)) {
    if (!term->form->cause->possible(*term->form, term->v, std.segment(at, term->v.size()))) return false;
    const bool mount = causeOf(*term) == ids::flexibleMount && term->v.size() > 2,
               swings = mount || causeOf(*term) == ids::looseMass;
    if (mount && term->v(0) < kHardlyAny * mass) return false;
    if (swings && term->v(0) > 1.1 * mass + 3.0 * (sd + std(at))) return false;
  }
  const Vector3d com = Vector3d(fit.model.x.segment<3>(7)) / std::max(mass, 0.02);
  return com.norm() < 1.5;
}

}  // namespace heft::diagnosis
