#include "core/diagnosis/search/search.h"

#include <algorithm>
#include <functional>
#include <iterator>

#include "core/base/say.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/causes/catalogue.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/search/random_walk.h"

namespace heft::diagnosis {

namespace {

/// What a trial must gain beyond the threshold around a model that explains `explained`. `wanders`: of that, by a zero
/// that walks.
double neededBeside(const Model& model, double explained, double wanders, const CandidateFit& trial) {
  const std::string_view cause = trial.cause;
  double out = contains(model, kRandomWalk) ? kClearEvidence + kBroadError * wanders : 0.0;
  const auto fast = [](std::string_view id) { return (lags(id) || enlarges(id)) && id != ids::looseMass; };
  const bool another =
      std::ranges::any_of(model.terms, [&](const Term& t) { return causeOf(t) != cause && fast(causeOf(t)); });
  if (fast(cause) && another) out += kFormError * explained;
  const Term& added = trial.fit.model.terms.back();
  const bool beside =
      std::ranges::any_of(model.terms, [&](const Term& t) { return causeOf(t) != cause && !t.form->walk; });
  if (added.form->atOnce && causeOf(added) == cause && beside) out += kNamed + kFormError * explained;
  return out;
}

/// The best drift in place of a walk whose channels all take one course; null where they do not, or no drift is much of
/// it. Fits of drifts may hang on a noise that was learned with a long memory: those that promised as much are settled.
const CandidateFit* driftOfOneCourse(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& base,
                                     const CandidateFit& walk, std::vector<CandidateFit>& all) {
  if (!isOneCourse(walk.fit.model)) return nullptr;
  const double least = kMajority * walk.gain;
  std::vector<CandidateFit*> drifts;
  for (CandidateFit& trial : all)
    if (trial.cause == ids::biasDrift && std::max(trial.gain, trial.promised) >= least) drifts.push_back(&trial);
  if (drifts.empty()) return nullptr;
  settleAll(signals, stretches, base, drifts);
  const CandidateFit* best = *std::ranges::max_element(drifts, {}, &CandidateFit::gain);
  return best->gain > least ? best : nullptr;
}

/// The accepted trial's fit with those of `all` besides that are of its cause, explain a lot, and act at other times:
/// touches are many now and then. Its own where that is no better.
Fit withOthersLikeIt(const Signals& signals, const std::vector<Stretch>& stretches, const CandidateFit& accepted,
                     const std::vector<CandidateFit>& all, std::size_t most) {
  const auto when = [&](const Term& t) { return t.form->cause->when(*t.form, t.v, signals); };
  const Term& term = accepted.fit.model.terms.back();
  auto taken = when(term);
  if (!term.form->local || term.form->atOnce || taken.empty()) return accepted.fit;
  Model model = accepted.fit.model;
  for (const CandidateFit& trial : all) {
    const Term& other = trial.fit.model.terms.back();
    if (model.terms.size() >= most || trial.gain < kFaint) break;
    if (other.form->cause != term.form->cause || !other.form->local || other.form->atOnce) continue;
    const auto there = when(other);
    const bool apart = !there.empty() && std::ranges::all_of(there, [&](const auto& a) {
      return std::ranges::all_of(
          taken, [&](const auto& b) { return a.first > b.second + kEvent || a.second < b.first - kEvent; });
    });
    if (!apart) continue;
    model.terms.push_back(other);
    taken.insert(taken.end(), there.begin(), there.end());
  }
  if (model.terms.size() == accepted.fit.model.terms.size()) return accepted.fit;
  Fit out = fitModel(signals, stretches, std::move(model));
  return believable(out) && out.evidence > accepted.fit.evidence ? out : accepted.fit;
}

/// The trial that is accepted beside `base`, of `all`, the best first. `best`: the first that gains `enough`. `drifts`:
/// set where a drift takes the place of a walk whose channels all take one course.
const CandidateFit* acceptedOf(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& base,
                               std::vector<CandidateFit>& all, const CandidateFit& best,
                               const std::function<bool(const CandidateFit&)>& enough, bool& drifts) {
  // A richer form of what is already named comes before a second name, unless that one explains clearly more.
  const CandidateFit* chosen = &best;
  for (const auto& trial : all)
    if (contains(base.model, trial.cause) && enough(trial) && trial.gain > 0.7 * best.gain) {
      chosen = &trial;
      break;
    }
  // A drift of any course that is too faint for a name leaves its place to what explains about as much and has one.
  if (takesAnyCourse(*chosen) && chosen->gain < kOverwhelming)
    for (const auto& trial : all)
      if (enough(trial) && trial.gain > chosen->gain - kTie && trial.cause != kRandomWalk && !takesAnyCourse(trial)) {
        chosen = &trial;
        break;
      }
  // What a zero that wanders explains about as well is no drift: most of a walk's way is one. Nor is it a jump.
  // A course that all channels take is a drift where a walk explains less.
  const double ahead = takesAnyCourse(*chosen) ? 0.0 : chosen->cause == ids::biasDrift ? kClearEvidence : kJump;
  if (chosen->cause == ids::biasDrift || chosen->cause == ids::sensorBias)
    for (const auto& trial : all)
      if (trial.cause == kRandomWalk && trial.gain > chosen->gain - ahead) {
        chosen = &trial;
        break;
      }
  if (chosen->cause == kRandomWalk)
    for (const auto& trial : all)
      if (isMoreThanWalk(trial.cause, trial.gain, chosen->gain)) {
        chosen = &trial;
        break;
      }
  if (chosen->cause == kRandomWalk)
    if (const CandidateFit* drift = driftOfOneCourse(signals, stretches, base, *chosen, all)) {
      chosen = drift;
      drifts = true;
    }
  // Of forms that explain as much, the simplest; a richer one may still take its place when the others are in theirs.
  const double good = chosen->gain - kSameLikelihood;
  for (const auto& trial : all)
    if (trial.cause == chosen->cause && trial.gain > good && trial.fit.dimensions < chosen->fit.dimensions)
      chosen = &trial;
  return chosen;
}

/// Whether there are as many causes, or masses that swing, as there never were at once: crutches for something unknown,
/// and more of them tell no more of it.
bool areTooMany(const Model& model) { return causesIn(model) >= kOverfitted || massesIn(model) > kMasses; }

}  // namespace

std::optional<Fit> withOneOf(const Signals& signals, const std::vector<Stretch>& stretches, SignatureBank& bank,
                             const Fit& base, std::span<const std::string_view> causes, std::size_t most) {
  const auto ranked = promises(signals, stretches, bank, base, causes);
  auto chosen = chosenOf(ranked, kRivals, 0.0);
  if (chosen.size() > most) chosen.resize(most);
  // Where none of those that promise most can be believed, it is what they are added to that cannot.
  constexpr std::size_t kFirst = 8;
  const auto rest = chosen.begin() + static_cast<std::ptrdiff_t>(std::min(kFirst, chosen.size()));
  auto all = fitsOf(signals, stretches, base, {chosen.begin(), rest});
  if (all.empty() || all.front().gain < -1e299) return std::nullopt;
  auto more = fitsOf(signals, stretches, base, {rest, chosen.end()});
  if (!more.empty() && more.front().gain > all.front().gain) all = std::move(more);
  if (all.front().gain < kThreshold) return std::nullopt;
  return std::move(all.front().fit);
}

Search search(const Signals& signals, const std::vector<Stretch>& stretches, SignatureBank& bank,
              const SearchOptions& options, const Progress& progress) {
  Search out;
  out.null = settled(signals, stretches, fitModel(signals, stretches, Model{}));
  out.final = out.null;
  std::vector<std::string>& order = out.order;
  if (!options.start.terms.empty()) {
    const Fit begun = fitModel(signals, stretches, options.start);
    out.final = settled(signals, stretches, prunedOf(signals, stretches, begun, options.threshold));
    if (!believable(out.final)) out.final = out.null;
    for (const Term& term : out.final.model.terms)
      if (std::find(order.begin(), order.end(), causeOf(term)) == order.end()) order.emplace_back(causeOf(term));
  }
  double wanders = 0.0;  // What a wandering zero explains, once accepted
  if (contains(out.final.model, kRandomWalk))
    wanders = out.final.evidence - fitModel(signals, stretches, without(out.final.model, kRandomWalk)).evidence;
  bool drifts = false;  // All channels take one course
  std::vector<Sibling> siblings;
  for (int step = static_cast<int>(out.final.model.terms.size());
       step < options.maxTerms && !areTooMany(out.final.model) && !progress.cancelled(); ++step) {
    progress(0.1 + 0.1 * step, heft::say("Testing causes"));
    const auto ranked = promises(signals, stretches, bank, out.final);
    if (ranked.empty()) break;
    CandidateFits latest{out.final, candidateFits(signals, stretches, out.final, ranked)};
    std::erase_if(latest.all, [&](const CandidateFit& trial) {
      // Noise that is slow beside a drift is noise.
      return !bank.knows(trial.cause) || (drifts && trial.cause == kRandomWalk);
    });
    addAtThatMoment(signals, stretches, out.final, ranked, latest.all);
    addCompletions(signals, stretches, out.final, latest.all);
    addSiblings(signals, stretches, out.final, siblings, latest.all);
    const auto& all = latest.all;
    const auto enough = [&](const CandidateFit& trial) {
      const double explained = out.final.evidence - out.null.evidence;
      return trial.gain >= options.threshold + neededBeside(out.final.model, explained, wanders, trial);
    };
    const auto best = std::ranges::find_if(all, enough);
    if (best == all.end()) break;
    const CandidateFit* chosen = acceptedOf(signals, stretches, out.final, latest.all, *best, enough, drifts);
    if (chosen->cause == kRandomWalk) wanders = chosen->gain;
    if (std::find(order.begin(), order.end(), chosen->cause) == order.end()) order.push_back(chosen->cause);
    std::ranges::move(siblingsOf(*chosen, latest.all), std::back_inserter(siblings));
    Fit accepted =
        withOthersLikeIt(signals, stretches, *chosen, all, static_cast<std::size_t>(std::max(0, options.maxTerms)));
    const bool isFirst = step == 0;
    const std::string last = chosen->cause;
    const double gain = chosen->gain;
    step += static_cast<int>(accepted.model.terms.size() - chosen->fit.model.terms.size());
    out.final = settled(signals, stretches, prunedOf(signals, stretches, std::move(accepted), options.threshold));
    out.accepted = std::move(latest);
    if (options.stopsEarly &&
        options.stopsEarly({out.final, isFirst, last, gain, out.final.evidence - out.null.evidence})) {
      out.givenUp = true;
      return out;
    }
  }
  return out;
}

}  // namespace heft::diagnosis
