#include "core/diagnosis/search/rival_comparison.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/base/say.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/causes/catalogue.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/search/evidence.h"
#include "core/diagnosis/search/random_walk.h"

namespace heft::diagnosis {

namespace {

/// The trial with up to `terms` terms, those after the first of any of the `causes`, as long as each of them adds to it
/// and together they may still reach `goal`.
CandidateFit grown(const Signals& signals, const std::vector<Stretch>& stretches, SignatureBank& bank,
                   CandidateFit trial, std::span<const std::string_view> causes, std::size_t terms, double goal) {
  // Times what a first look promises, and a tie more: no fit in a hundred has gained that.
  for (std::size_t i = 1; i < terms; ++i) {
    const auto ranked = promises(signals, stretches, bank, trial.fit, causes);
    if (ranked.empty()) break;
    const double most = 2.0 * std::max(0.0, ranked.front().score) + kTie;
    if (trial.gain + static_cast<double>(terms - i) * most < goal) break;
    auto more = fitsOf(signals, stretches, trial.fit, chosenOf(ranked, kRivals, ranked.front().score));
    if (more.empty() || more.front().gain < kThreshold) break;
    more.front().cause = trial.cause;
    more.front().gain += trial.gain;
    more.front().penalty += trial.penalty;
    trial = std::move(more.front());
  }
  return trial;
}

/// A walk has waves for anything that is slow: two or three causes together may explain clearly more, unless they are
/// too many beside the `rest` of the model. `walk`: its gain; a faint one is left to be one.
void outgrowWalk(const Signals& signals, const std::vector<Stretch>& stretches, SignatureBank& bank, double walk,
                 const Model& rest, std::vector<CandidateFit>& all) {
  constexpr std::size_t kTop = 3, kTerms = 3;
  if (walk < 2.0 * kFaint || causesIn(rest) + 1 >= kOverfitted) return;
  std::vector<std::string_view> others, done;
  for (const auto& cause : catalogue())
    if (cause->id() != kRandomWalk) others.push_back(cause->id());
  for (CandidateFit& trial : all) {
    const auto id = causeOf(trial.fit.model.terms.back());
    if (done.size() == kTop || trial.gain < kMinorShare * walk) break;
    if (id == kRandomWalk || std::ranges::find(done, id) != done.end()) continue;
    done.push_back(id);
    CandidateFit more = grown(signals, stretches, bank, trial, others, kTerms, walk + kClearEvidence);
    if (more.gain > walk + kClearEvidence) trial = std::move(more);
  }
  sortByGain(all);
}

/// What took several terms of `cause` is compared with as many of others that come near with one.
void growRivals(const Signals& signals, const std::vector<Stretch>& stretches, SignatureBank& bank, const Model& model,
                std::string_view cause, std::vector<CandidateFit>& all) {
  const auto terms =
      static_cast<std::size_t>(std::ranges::count_if(model.terms, [&](const Term& t) { return causeOf(t) == cause; }));
  if (terms < 2 || all.empty()) return;
  const double best = all.front().gain;
  std::vector<std::string_view> done{cause};
  for (CandidateFit& trial : all) {
    const Form& form = *trial.fit.model.terms.back().form;
    const std::array<std::string_view, 1> same{form.cause->id()};
    if (trial.gain < kMajority * best || form.local || form.walk || std::ranges::find(done, same[0]) != done.end())
      continue;
    done.push_back(same[0]);
    trial = grown(signals, stretches, bank, std::move(trial), same, terms, 0.0);
  }
  sortByGain(all);
}

/// What was accepted has come to rest on a long way; where its own cause does not reach as much again, others that came
/// as near are fitted as long.
void settleRivals(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& base, const Found& found,
                  std::vector<CandidateFit>& all) {
  const auto own = std::ranges::find_if(all, [&](const CandidateFit& t) { return t.cause == found.cause; });
  if (own == all.end() || own->gain > found.gain - 0.5 * kTie) return;
  const double near = own->gain - 2.0 * kTie;
  std::vector<CandidateFit*> others;
  for (CandidateFit& trial : all)
    if (trial.gain > near && trial.cause != found.cause && others.size() < kFinished) others.push_back(&trial);
  settleAll(signals, stretches, base, others);
  sortByGain(all);
}

Rival rivalOf(const Found& found, const CandidateFit& trial, const Fit& accepted) {
  const double behind = found.gain - trial.gain;
  return {trial.cause,
          behind,
          behind - (trial.fit.complexity - accepted.complexity) - trial.penalty,
          trial.fit.dimensions - accepted.dimensions,
          takesAnyCourse(trial),
          trial.fit.model.x.tail<10>()};
}

/// The best trial of each cause that is neither `cause` nor in the `rest` of the model. A drift of any course that is
/// too faint for a name leaves its place to one of a simpler course that explains about as much.
std::map<std::string, const CandidateFit*> bestOfEach(const std::vector<CandidateFit>& all, std::string_view cause,
                                                      const Model& rest) {
  std::map<std::string, const CandidateFit*> out;
  for (const CandidateFit& trial : all) {  // The best first
    if (trial.gain < -1e299 || trial.cause == cause || contains(rest, trial.cause)) continue;
    const CandidateFit*& best = out.try_emplace(trial.cause, &trial).first->second;
    if (takesAnyCourse(*best) && best->gain < kOverwhelming && !takesAnyCourse(trial) && trial.gain > best->gain - kTie)
      best = &trial;
  }
  return out;
}

/// How far from the only term of `cause` in `model` the parameters of other trials of it lie that explain about as
/// much: what a deviation, which looks around one answer, does not see. Empty if there are several terms.
VectorXd spreadOf(const Model& model, std::string_view cause, const std::vector<CandidateFit>& all) {
  const auto own = [&](const Term& t) { return causeOf(t) == cause; };
  const auto& terms = model.terms;
  if (std::ranges::count_if(terms, own) != 1) return {};
  const Term& term = *std::ranges::find_if(terms, own);
  VectorXd out = VectorXd::Zero(term.v.size());
  double best = -1e300;
  for (const CandidateFit& trial : all) {  // The best first
    const Term& other = trial.fit.model.terms.back();
    if (!own(other) || other.form->choice != term.form->choice || other.v.size() != term.v.size()) continue;
    best = std::max(best, trial.gain);
    if (trial.gain > best - kTie) out = out.cwiseMax((other.v - term.v).cwiseAbs());
  }
  return out;
}

/// Both smooth or delay fast forces, and so does whatever was done to the recorded motion; or both make them larger
/// than the motion says, what swings below its resonance like motion that was smoothed; or something begins to pull
/// where, as far as the tool turns, the zero may have jumped; or all gains grow like a load: how well either fits is
/// not known better than to a share of what both explain.
double slackBetween(std::string_view a, std::string_view b, double gain) {
  const CauseInfo &one = infoOf(a), &other = infoOf(b);
  if (one.begins && other.begins) return kEventError * gain;
  if (one.scalesWithLoad && other.scalesWithLoad) return kHardlyAny * gain;
  return lags(a) && lags(b) ? kFormError * gain : enlarges(a) && enlarges(b) ? kFormError * gain : 0.0;
}

/// By how much a rival must be better to take a cause's place. A faint drift may well be a walk: that one is no alarm.
/// Of a walk that is plain to see, a drift never explains as much (it was at least 14 behind in 60 simulated ones;
/// where there was a drift, at most 9). Nor does a course that all channels take (10 behind or more in 60 others; where
/// there was one, 10 ahead or more).
/// `oneCourse`: whether a walk whose place is in question is one course of all channels.
double leadFor(const Found& found, const Rival& rival, bool oneCourse) {
  const bool walkGoes = found.cause == kRandomWalk, walkComes = rival.cause == kRandomWalk;
  if (!walkGoes && !walkComes) return kSameLikelihood;
  if (oneCourse && walkGoes && rival.cause == ids::biasDrift) return -kMajority * found.gain;
  if (walkGoes && rival.cause == ids::sensorBias) return kJump;
  if (walkGoes && isMoreThanWalk(rival.cause, found.gain - rival.behind, found.gain)) return -found.gain;
  if (walkComes && isMoreThanWalk(found.cause, found.gain, found.gain - rival.behind)) return found.gain;
  if (walkGoes && rival.anyCourse) return kSameLikelihood;
  if ((walkGoes ? rival.cause : found.cause) != ids::biasDrift) return walkGoes ? kJump : kSameLikelihood;
  const double drift = walkGoes ? found.gain - rival.behind : found.gain;
  const double ahead = drift < kFaint ? kJump : -kTie;  // Of the walk, for the drift to be named
  return walkGoes ? ahead : -ahead;
}

/// The model fitted without `cause`; where others make no sense without it, without those, too, the last accepted
/// first.
Fit restWithout(const Signals& signals, const std::vector<Stretch>& stretches, const Model& model,
                std::string_view cause, std::span<const std::string> order) {
  Model less = without(model, cause);
  Fit out = settled(signals, stretches, fitModel(signals, stretches, less));
  for (std::size_t i = order.size(); i-- > 0 && !believable(out);) {
    if (!contains(less, order[i])) continue;
    less = without(less, order[i]);
    out = settled(signals, stretches, fitModel(signals, stretches, less));
  }
  return out;
}

/// Whether `cause` is easily taken for `other`.
bool isTakenFor(std::string_view cause, std::string_view other) {
  const auto alike = findCause(cause)->lookAlikes();
  return std::ranges::find(alike, other) != alike.end();
}

/// A fit with one term of either `cause` or a named one that it is easily taken for, instead of all terms of both,
/// where that explains about as well: such as a pull at the tip that was told as a tilt and a pull at the sensor.
/// `asked`: causes of which the same was asked before.
std::optional<Fit> oneForTwo(const Signals& signals, const std::vector<Stretch>& stretches, SignatureBank& bank,
                             const Fit& final, std::string_view cause, std::span<const std::string> asked) {
  for (const auto& other : findCause(cause)->lookAlikes()) {
    if (!contains(final.model, other)) continue;
    if (std::ranges::find(asked, other) != asked.end() && isTakenFor(other, cause)) continue;
    const std::array<std::string_view, 2> both{cause, other};
    const Fit rest = fitModel(signals, stretches, without(without(final.model, cause), other));
    auto one = withOneOf(signals, stretches, bank, rest, both);
    if (one && believable(*one) && one->evidence > final.evidence - 2.0 * kTie) return one;
  }
  return std::nullopt;
}

bool sameForms(const Model& a, const Model& b) {
  return std::equal(a.terms.begin(), a.terms.end(), b.terms.begin(), b.terms.end(), [](const Term& s, const Term& t) {
    return s.form->cause == t.form->cause && s.form->name == t.form->name;
  });
}

}  // namespace

bool tied(const Found& found, const Rival& rival) {
  const double slack = slackBetween(found.cause, rival.cause, found.gain);
  if (rival.behind < kTie + slack || (slack > 0.0 && rival.worse < slack)) return true;
  const bool explains = rival.behind < found.gain;
  if (explains && rival.worse + kSameLikelihood * rival.extra < 0.0) return true;
  if (rival.worse > kSameLikelihood) return false;
  const bool faint = found.gain < kFaint;
  return isTakenFor(found.cause, rival.cause) ? faint || explains : faint && explains;
}

namespace {

/// Asks of each cause of a model what could stand in its place; a model that is better becomes the search's.
class RivalComparison {
 public:
  RivalComparison(const Signals& signals, const std::vector<Stretch>& stretches, SignatureBank& bank,
                  const SearchOptions& options, Search& search)
      : signals_(signals), stretches_(stretches), bank_(bank), options_(options), search_(search) {
    if (!search.accepted.all.empty()) tried_.push_back(std::move(search.accepted));
  }

  /// Goes through all causes once. `changes`: whether a better model may be taken; then the rest of the causes waits.
  /// Whether one was.
  bool look(bool changes, const Progress& progress) {
    search_.found.clear();
    for (const auto& cause : std::vector<std::string>(search_.order)) {
      if (!contains(search_.final.model, cause) || progress.cancelled()) continue;
      progress(0.8, heft::say("Comparing alternatives"));
      const CandidateFits& around = triedWithout(cause);
      Found found;
      found.cause = cause;
      found.gain = search_.final.evidence - around.base.evidence;
      const std::vector<CandidateFit> all = inPlaceOf(found, around);
      found.spread = spreadOf(search_.final.model, cause, all);
      if (changes && (takeRicher(found, all) || takeOther(found, all, around.base.model) || takeOneForTwo(cause)))
        return true;
      const auto best = bestOfEach(all, cause, around.base.model);
      for (const auto& [id, trial] : best) found.rivals.push_back(rivalOf(found, *trial, search_.final));
      std::stable_sort(found.rivals.begin(), found.rivals.end(),
                       [](const Rival& a, const Rival& b) { return a.behind < b.behind; });
      std::erase_if(found.rivals, [&](const Rival& r) {
        return cause == ids::biasDrift && r.cause == kRandomWalk && isOneCourse(best.at(r.cause)->fit.model);
      });
      if (changes && takeBetter(found, best)) return true;
      std::erase_if(found.rivals, [&](const Rival& r) { return !tied(found, r); });
      search_.found.push_back(std::move(found));
    }
    return false;
  }

 private:
  void take(const Fit& fit) {
    search_.final = settled(signals_, stretches_, prunedOf(signals_, stretches_, fit, options_.threshold));
  }

  /// What was tried around the same model before, such as before the last cause was accepted, is what stands against
  /// `cause` now.
  const CandidateFits& triedWithout(const std::string& cause) {
    const Model bare = without(search_.final.model, cause);
    const auto known =
        std::ranges::find_if(tried_, [&](const CandidateFits& t) { return sameForms(bare, t.base.model); });
    if (known != tried_.end()) return *known;
    CandidateFits fresh{restWithout(signals_, stretches_, search_.final.model, cause, search_.order), {}};
    const auto ranked = promises(signals_, stretches_, bank_, fresh.base);
    fresh.all = fitsOf(signals_, stretches_, fresh.base,
                       chosenOf(ranked, kRivals, search_.final.evidence - fresh.base.evidence));
    std::erase_if(fresh.all, [&](const CandidateFit& trial) { return !bank_.knows(trial.cause); });
    addAtThatMoment(signals_, stretches_, fresh.base, ranked, fresh.all);
    addCompletions(signals_, stretches_, fresh.base, fresh.all);
    return *tried_.insert(tried_.end(), std::move(fresh));
  }

  std::vector<CandidateFit> inPlaceOf(const Found& found, const CandidateFits& around) {
    std::vector<CandidateFit> all = around.all;
    if (found.cause == kRandomWalk)
      outgrowWalk(signals_, stretches_, bank_, found.gain, around.base.model, all);
    else
      growRivals(signals_, stretches_, bank_, search_.final.model, found.cause, all);
    settleRivals(signals_, stretches_, around.base, found, all);
    return all;
  }

  /// A richer form of the cause that promised little around what else was wrong by then.
  bool takeRicher(const Found& found, const std::vector<CandidateFit>& all) {
    const auto own = std::ranges::find_if(all, [&](const CandidateFit& t) { return t.cause == found.cause; });
    if (own == all.end() || own->gain <= found.gain + kTie) return false;
    take(own->fit);
    return true;
  }

  /// What another of the named causes explains about as well needs no name of its own.
  bool takeOther(const Found& found, const std::vector<CandidateFit>& all, const Model& rest) {
    const auto other = std::ranges::find_if(all, [&](const CandidateFit& t) {
      const Form& form = *t.fit.model.terms.back().form;
      return t.gain > found.gain - kTie && t.cause != found.cause && contains(rest, t.cause) && !form.local &&
             !form.walk;
    });
    if (other == all.end()) return false;
    take(other->fit);
    std::erase(search_.order, found.cause);
    return true;
  }

  bool takeOneForTwo(const std::string& cause) {
    const std::span order(search_.order);
    const auto before = static_cast<std::size_t>(std::ranges::find(order, cause) - order.begin());
    const auto one = oneForTwo(signals_, stretches_, bank_, search_.final, cause, order.first(before));
    if (!one) return false;
    take(*one);
    std::erase_if(search_.order, [&](const std::string& named) { return !contains(search_.final.model, named); });
    return true;
  }

  /// The first rival that is ahead by enough takes the cause's place.
  bool takeBetter(const Found& found, const std::map<std::string, const CandidateFit*>& best) {
    const bool oneCourse = found.cause == kRandomWalk && isOneCourse(search_.final.model);
    const auto better =
        std::ranges::find_if(found.rivals, [&](const Rival& r) { return r.behind < -leadFor(found, r, oneCourse); });
    if (better == found.rivals.end()) return false;
    take(best.at(better->cause)->fit);
    std::vector<std::string>& order = search_.order;
    *std::find(order.begin(), order.end(), found.cause) = better->cause;
    for (const Term& term : search_.final.model.terms)
      if (std::find(order.begin(), order.end(), causeOf(term)) == order.end()) order.emplace_back(causeOf(term));
    return true;
  }

  const Signals& signals_;
  const std::vector<Stretch>& stretches_;
  SignatureBank& bank_;
  const SearchOptions& options_;
  Search& search_;
  std::vector<CandidateFits> tried_;
};

}  // namespace

bool compareRivals(const Signals& signals, const std::vector<Stretch>& stretches, SignatureBank& bank,
                   const SearchOptions& options, Search& search, const Progress& progress) {
  // The last look changes nothing any more: what was found must be told whole.
  constexpr int kLooks = 3;
  RivalComparison comparison(signals, stretches, bank, options, search);
  bool ever = false;
  for (int look = 0; look < kLooks && !progress.cancelled(); ++look) {
    if (!comparison.look(look + 1 < kLooks, progress)) break;
    ever = true;
  }
  search.accepted = {};
  return ever;
}

}  // namespace heft::diagnosis
