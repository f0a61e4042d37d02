#include "core/diagnosis/search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>

#include "core/base/say.h"
#include "core/diagnosis/two_threads.h"
#include "core/diagnosis/wandering.h"

namespace heft::diagnosis {

namespace {

constexpr std::size_t kTried = 8;    ///< Causes that get a fit in a step
constexpr std::size_t kRivals = 5;   ///< Causes that get one in the place of another
constexpr double kHopeful = 0.25;    ///< Of the evidence to beat: what a first look must promise
constexpr double kSame = 4.0;        ///< Twice the log-likelihood that sets no two causes apart
constexpr double kBesideWandering = 30.0;  ///< More evidence: what a few slow waves leave of a wandering zero is no cause
constexpr double kJump = 20.0;             ///< By how much a jump must be more than a walk of the zero: one that walks makes steps, too
constexpr double kShareOfWandering = 0.2;  ///< And of what they explain: the further it wanders, the more they leave
constexpr double kChance = 3.0;      ///< Twice the log-likelihood that an idle parameter hardly ever gains
constexpr double kLeastOnMount = 0.02;  ///< Share of the payload below which nobody would speak of its mount
constexpr std::size_t kFinished = 4;  ///< Of these, how many are fitted to the end

std::string_view causeOf(const Term& term) { return term.form->cause->id(); }

bool contains(const Model& model, std::string_view cause) {
  return std::any_of(model.terms.begin(), model.terms.end(), [&](const Term& t) { return causeOf(t) == cause; });
}

struct Trial {
  std::string cause;
  Fit fit;
  double choicePenalty = 0.0, penalty = 0.0;  ///< See Candidate; with the cause's own doubt
  double promised = 0.0;  ///< By the first look
  double gain = -1e300;
};

/// What the trial's fit adds to `base`, for its price.
void weigh(Trial& trial, const Fit& base, const Signals& signals) {
  const Term& term = trial.fit.model.terms.back();
  trial.penalty = trial.choicePenalty + term.form->cause->doubt(*term.form, term.v, signals);
  trial.gain = believable(trial.fit) ? trial.fit.evidence - base.evidence - trial.penalty : -1e300;
}

/// Better first; forms of one cause keep their order among themselves.
void sortByGain(std::vector<Trial>& all) {
  std::stable_sort(all.begin(), all.end(), [](const Trial& a, const Trial& b) { return a.gain > b.gain; });
}

Trial tried(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& base, const Candidate& candidate) {
  Trial out;
  out.cause = candidate.form.cause->id();
  const Candidate& placed = candidate.form.atOnce && candidate.score > 0.0 ? retimed(signals, stretches, base, candidate) : candidate;
  Model model = base.model;
  model.terms.push_back({std::make_shared<const Form>(placed.form), placed.v, placed.active});
  out.choicePenalty = candidate.choicePenalty;
  out.promised = candidate.score;
  out.fit = fitModel(signals, stretches, std::move(model), 3);
  // A walk makes steps of its own, too: where the zero is known to walk, a jump of it or of the load is more.
  const bool maybeWalk = (out.cause == "sensor_bias" || out.cause == "payload_change") && contains(base.model, kWandering);
  if (maybeWalk && !jumpStandsOut(signals, stretches, base, out.fit)) return out;
  weigh(out, base, signals);
  return out;
}

/// The most promising causes' candidates, several forms of the first few, since what sets them apart may show only when
/// everything moves. `toBeat`: evidence of the strongest, or of the cause whose place is in question.
std::vector<const Candidate*> chosenOf(const std::vector<Candidate>& ranked, std::size_t causes, double toBeat) {
  std::vector<const Candidate*> chosen;
  // A first look at all of a form's parameters promises about what the fit will reach; one at some of them, less: the two
  // do not compete for places.
  std::array<std::map<std::string_view, std::vector<const Candidate*>>, 2> forms;
  for (const auto& candidate : ranked) {
    const bool whole = candidate.form.scan.size() == candidate.form.parameters.size();
    // A first look at a walk promises too little: how far it goes is learned only in a fit.
    if (candidate.form.walk) {
      chosen.push_back(&candidate);
      continue;
    }
    // In 134 recordings, one in 200 that promised less than kLeast gained enough, and next to nothing.
    constexpr double kLeast = -12.0;
    if (candidate.score < std::max(whole ? 0.0 : kLeast, (whole ? 0.0 : -30.0) + kHopeful * std::max(0.0, toBeat - 2.0 * kTie))) continue;
    auto& known = forms[whole ? 0 : 1];
    const auto id = candidate.form.cause->id();
    if (known.size() >= causes && !known.contains(id)) continue;
    const std::size_t most = known.size() > 3 ? 2 : whole ? 4 : 8;
    std::vector<const Candidate*>& same = known[id];
    // Neighbours in frequency or time are the same thing.
    const auto alike = std::count_if(same.begin(), same.end(),
                                     [&](const Candidate* other) { return other->form.choice == candidate.form.choice; });
    if (same.size() >= most || (alike >= 2 && !whole)) continue;
    same.push_back(&candidate);
    chosen.push_back(&candidate);
  }
  return chosen;
}

/// Full fits of the chosen ones, best first.
std::vector<Trial> trialsOf(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& base,
                            const std::vector<const Candidate*>& chosen) {
  std::vector<Trial> all(chosen.size());
  onTwoThreads(chosen.size(), [&](std::size_t i) { all[i] = tried(signals, stretches, base, *chosen[i]); });
  sortByGain(all);
  // The best are fitted to the end: a few steps rank them, but what is compared must have come to rest. So are those that
  // promised to be the best and are not there yet: a large misfit takes more steps, since the noise is learned alongside.
  std::vector<Trial*> resting;
  for (std::size_t i = 0; i < all.size() && resting.size() < 2 * kFinished; ++i) {
    const bool hopeful = all[i].promised > std::max(all[i].gain, all.front().gain - 2.0 * kTie) + kTie;
    if (all[i].gain > -1e299 && (i < kFinished || hopeful)) resting.push_back(&all[i]);
  }
  onTwoThreads(resting.size(), [&](std::size_t i) {
    Trial& trial = *resting[i];
    trial.fit = fitModel(signals, stretches, trial.fit.model);
    weigh(trial, base, signals);
    if (trial.gain > trial.promised - kTie) return;
    trial.fit = settled(signals, stretches, std::move(trial.fit));
    weigh(trial, base, signals);
  });
  sortByGain(all);
  return all;
}

/// Trials of what promises most. What did may come to nothing, such as a step at an impossible place: then everything gets
/// its chance.
std::vector<Trial> trials(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& base,
                          const std::vector<Candidate>& ranked) {
  const double promised = ranked.front().score;
  auto chosen = chosenOf(ranked, kTried, promised);
  auto all = trialsOf(signals, stretches, base, chosen);
  if (!all.empty() && all.front().gain >= kHopeful * promised) return all;
  auto others = chosenOf(ranked, kTried, 0.0);
  std::erase_if(others, [&](const Candidate* c) { return std::find(chosen.begin(), chosen.end(), c) != chosen.end(); });
  auto more = trialsOf(signals, stretches, base, others);
  std::move(more.begin(), more.end(), std::back_inserter(all));
  sortByGain(all);
  return all;
}

/// The model with all parameters of one term, of which the first look had freed only some: what the others of the same cause
/// explain needs no second name. Added to `all`, best first.
void addCompletions(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& base, std::vector<Trial>& all) {
  const std::size_t before = all.size();
  for (std::size_t i = 0; i < base.model.terms.size(); ++i) {
    const Term& term = base.model.terms[i];
    if (!term.form->subset || std::ranges::all_of(term.form->scan, [&](int p) { return term.moves(p); })) continue;
    Trial whole;
    whole.cause = causeOf(term);
    Model model = base.model;
    model.terms[i].active.clear();
    whole.fit = fitModel(signals, stretches, std::move(model));
    if (!believable(whole.fit)) continue;
    whole.gain = whole.fit.evidence - base.evidence;
    all.push_back(std::move(whole));
  }
  if (all.size() > before) sortByGain(all);
}

/// Whether another term of the form can add to the model: one with a place of its own may come again, any other that is
/// already in can not. Beside a drift a walk is none: what a straight line leaves has richer forms of drift.
bool mayAdd(const Form& form, const Model& model) {
  if (form.walk && contains(model, "bias_drift")) return false;
  return form.local || std::none_of(model.terms.begin(), model.terms.end(), [&](const Term& t) {
           return t.form->cause == form.cause && (t.form->name == form.name || t.form->alone || form.alone);
         });
}

/// What each form that may still come promises around `base`, best first. `causes`: of these only, or of all if empty.
std::vector<Candidate> promises(const Signals& signals, const std::vector<Stretch>& stretches, SignatureBank& bank, const Fit& base,
                                std::span<const std::string_view> causes = {}) {
  return scan(stretches, base, bank.around(signals, base.model, [&](const Form& form) {
    return mayAdd(form, base.model) && (causes.empty() || std::ranges::find(causes, form.cause->id()) != causes.end());
  }));
}

/// Squared deviations by which term `at` of the fit stands out, as far as its amplitudes are known beside everything else.
double standsOut(const Fit& fit, std::size_t at) {
  Eigen::Index from = kLinear;
  for (std::size_t i = 0; i < at; ++i) from += fit.model.terms[i].v.size();
  const Term& term = fit.model.terms[at];
  std::vector<Eigen::Index> own;
  for (const int p : term.form->scan)
    if (term.moves(p)) own.push_back(from + p);
  if (own.empty() || term.form->walk) return 0.0;
  VectorXd size(std::ssize(own));
  for (Eigen::Index i = 0; i < size.size(); ++i) {
    const Eigen::Index p = own[static_cast<std::size_t>(i)] - from;
    size(i) = term.v(p) - term.form->start(p);
  }
  const MatrixXd covariance = fit.covariance(own, own);
  return size.dot(covariance.ldlt().solve(size));
}

/// Takes out again what the others have made needless.
Fit prunedOf(const Signals& signals, const std::vector<Stretch>& stretches, Fit fit, double threshold) {
  constexpr double kNeeded = 10.0;  // Times the threshold: what stands out like that is not fitted without, to be sure.
  for (std::size_t i = 0; fit.model.terms.size() > 1 && i < fit.model.terms.size();) {
    if (standsOut(fit, i) > kNeeded * threshold) {
      ++i;
      continue;
    }
    Model less = fit.model;
    less.terms.erase(less.terms.begin() + static_cast<std::ptrdiff_t>(i));
    Fit refit = fitModel(signals, stretches, std::move(less));
    if (believable(refit) && fit.evidence - refit.evidence < threshold) {
      fit = std::move(refit);
      i = 0;
    } else {
      ++i;
    }
  }
  return fit;
}

}  // namespace

bool believable(const Fit& fit) {
  if (fit.atBound) return false;
  const double mass = fit.model.x(6), sd = std::sqrt(std::max(0.0, fit.covariance(6, 6)));
  if (mass < -3.0 * sd || mass > 60.0) return false;
  if (!fit.model.packed().allFinite()) return false;
  // What swings is a part of the payload, or all of it.
  Eigen::Index at = kLinear;
  for (const auto& term : fit.model.terms) {
    const bool mount = causeOf(term) == "flexible_mount" && term.v.size() > 2, swings = mount || causeOf(term) == "loose_mass";
    if (mount && term.v(0) < kLeastOnMount * mass) return false;
    if (swings && term.v(0) > 1.1 * mass + 3.0 * (sd + std::sqrt(std::max(0.0, fit.covariance(at, at))))) return false;
    at += term.v.size();
  }
  const Vector3d com = Vector3d(fit.model.x.segment<3>(7)) / std::max(mass, 0.02);
  return com.norm() < 1.5;
}

Model without(const Model& model, std::string_view cause) {
  Model out = model;
  std::erase_if(out.terms, [&](const Term& t) { return causeOf(t) == cause; });
  return out;
}

namespace {

/// Whether a cause that goes on all the time and is no drift explains so much of what a walk of the zero does that it is named
/// instead. In 98 recordings whose zero walked, none came to half of it.
bool isMoreThanWalk(std::string_view cause, double gain, double walk) {
  constexpr double kMost = 0.75;
  constexpr std::array<std::string_view, 5> kLikeAWalk{"bias_drift", "sensor_bias", "payload_change", "contact", kWandering};
  return std::ranges::find(kLikeAWalk, cause) == kLikeAWalk.end() && gain > std::max(kFaint, kMost * walk);
}

/// The trial with up to `terms` terms, those after the first of any of the `causes`, as long as each of them adds to it and
/// together they may still reach `goal`.
Trial grown(const Signals& signals, const std::vector<Stretch>& stretches, SignatureBank& bank, Trial trial,
            std::span<const std::string_view> causes, std::size_t terms, double goal) {
  constexpr double kMore = 1.5;  ///< Times what a first look promises, and a tie more: no fit in a hundred has gained that
  for (std::size_t i = 1; i < terms; ++i) {
    const auto ranked = promises(signals, stretches, bank, trial.fit, causes);
    if (ranked.empty()) break;
    const double most = kMore * std::max(0.0, ranked.front().score) + kTie;
    if (trial.gain + static_cast<double>(terms - i) * most < goal) break;
    auto more = trialsOf(signals, stretches, trial.fit, chosenOf(ranked, kRivals, ranked.front().score));
    if (more.empty() || more.front().gain < kThreshold) break;
    more.front().cause = trial.cause;
    more.front().gain += trial.gain;
    more.front().penalty += trial.penalty;
    trial = std::move(more.front());
  }
  return trial;
}

/// A walk has waves for anything that is slow: two or three causes together may explain clearly more. `walk`: its gain; a faint
/// one is left to be one.
void outgrowWalk(const Signals& signals, const std::vector<Stretch>& stretches, SignatureBank& bank, double walk, std::vector<Trial>& all) {
  constexpr std::size_t kTop = 2, kTerms = 3;
  constexpr double kNear = 0.25;  ///< Share of what the walk explains
  if (walk < 2.0 * kFaint) return;
  std::vector<std::string_view> others, done;
  for (const auto& cause : catalogue())
    if (cause->id() != kWandering) others.push_back(cause->id());
  for (Trial& trial : all) {
    const auto id = causeOf(trial.fit.model.terms.back());
    if (done.size() == kTop || trial.gain < kNear * walk) break;
    if (id == kWandering || std::ranges::find(done, id) != done.end()) continue;
    done.push_back(id);
    Trial more = grown(signals, stretches, bank, trial, others, kTerms, walk + kBesideWandering);
    if (more.gain > walk + kBesideWandering) trial = std::move(more);
  }
  sortByGain(all);
}

/// What took several terms of `cause` is compared with as many of others that come near with one.
void growRivals(const Signals& signals, const std::vector<Stretch>& stretches, SignatureBank& bank, const Model& model,
                std::string_view cause, std::vector<Trial>& all) {
  constexpr double kNear = 0.6;  ///< Share of the best
  const auto terms = static_cast<std::size_t>(std::ranges::count_if(model.terms, [&](const Term& t) { return causeOf(t) == cause; }));
  if (terms < 2 || all.empty()) return;
  const double best = all.front().gain;
  std::vector<std::string_view> done{cause};
  for (Trial& trial : all) {
    const Form& form = *trial.fit.model.terms.back().form;
    const std::array<std::string_view, 1> same{form.cause->id()};
    if (trial.gain < kNear * best || form.local || form.walk || std::ranges::find(done, same[0]) != done.end()) continue;
    done.push_back(same[0]);
    trial = grown(signals, stretches, bank, std::move(trial), same, terms, 0.0);
  }
  sortByGain(all);
}

/// What was accepted has come to rest on a long way; where its own cause does not reach as much again, others that came as near
/// are fitted as long.
void settleRivals(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& base, const Found& found, std::vector<Trial>& all) {
  const auto own = std::ranges::find_if(all, [&](const Trial& t) { return t.cause == found.cause; });
  if (own == all.end() || own->gain > found.gain - 0.5 * kTie) return;
  const double near = own->gain - 2.0 * kTie;
  std::vector<Trial*> others;
  for (Trial& trial : all)
    if (trial.gain > near && trial.cause != found.cause && others.size() < kFinished) others.push_back(&trial);
  onTwoThreads(others.size(), [&](std::size_t i) {
    others[i]->fit = settled(signals, stretches, std::move(others[i]->fit));
    weigh(*others[i], base, signals);
  });
  sortByGain(all);
}

Rival rivalOf(const Found& found, const Trial& trial, const Fit& accepted) {
  const double behind = found.gain - trial.gain;
  return {trial.cause, behind, behind - (trial.fit.price - accepted.price) - trial.penalty,
          trial.fit.dimensions - accepted.dimensions, trial.fit.model.x.tail<10>()};
}

/// How far from the only term of `cause` in `model` the parameters of other trials of it lie that explain about as much: what a
/// deviation, which looks around one answer, does not see. Empty if there are several terms.
VectorXd spreadOf(const Model& model, std::string_view cause, const std::vector<Trial>& all) {
  const auto own = [&](const Term& t) { return causeOf(t) == cause; };
  const auto& terms = model.terms;
  if (std::ranges::count_if(terms, own) != 1) return {};
  const Term& term = *std::ranges::find_if(terms, own);
  VectorXd out = VectorXd::Zero(term.v.size());
  double best = -1e300;
  for (const Trial& trial : all) {  // The best first
    const Term& other = trial.fit.model.terms.back();
    if (!own(other) || other.form->choice != term.form->choice || other.v.size() != term.v.size()) continue;
    best = std::max(best, trial.gain);
    if (trial.gain > best - kTie) out = out.cwiseMax((other.v - term.v).cwiseAbs());
  }
  return out;
}

bool lags(std::string_view id) { return id == "time_offset" || id == "low_pass_lag" || id == "motion_lag"; }

/// Makes fast forces larger than the motion says.
bool enlarges(std::string_view id) { return id == "flexible_mount" || id == "loose_mass" || id == "derivative_noise"; }

/// Both smooth or delay fast forces, and so does whatever was done to the recorded motion; or both make them larger than the
/// motion says, what swings below its resonance like motion that was smoothed: how well either fits is not known better than to a
/// share of what both explain.
double slackBetween(std::string_view a, std::string_view b, double gain) {
  constexpr double kShare = 0.05;
  return (lags(a) && lags(b)) || (enlarges(a) && enlarges(b)) ? kShare * gain : 0.0;
}

/// What a trial must gain beyond the threshold around a model that explains `explained`. `wanders`: of that, by a zero that walks.
double neededBeside(const Model& model, double explained, double wanders, std::string_view cause) {
  constexpr double kShareOfFast = 0.02;  ///< What the form of one thing that changes fast forces leaves, another of them takes
  double out = contains(model, kWandering) ? kBesideWandering + kShareOfWandering * wanders : 0.0;
  const auto fast = [](std::string_view id) { return (lags(id) || enlarges(id)) && id != "loose_mass"; };
  const bool another = std::ranges::any_of(model.terms, [&](const Term& t) { return causeOf(t) != cause && fast(causeOf(t)); });
  if (fast(cause) && another) out += kShareOfFast * explained;
  return out;
}

/// By how much a rival must be better to take a cause's place. A faint drift may well be a walk: that one is no alarm. Of a
/// walk that is plain to see, a drift never explains as much (it was at least 14 behind in 60 simulated ones; where there was
/// a drift, at most 9).
double leadFor(const Found& found, const Rival& rival) {
  constexpr double kUsual = 2.0, kFaintDrift = 5.0, kPlainWalk = 12.0;
  const bool walkGoes = found.cause == kWandering, walkComes = rival.cause == kWandering;
  if (!walkGoes && !walkComes) return kUsual;
  if (walkGoes && rival.cause == "sensor_bias") return kJump;
  if (walkGoes && isMoreThanWalk(rival.cause, found.gain - rival.behind, found.gain)) return -found.gain;
  if (walkComes && isMoreThanWalk(found.cause, found.gain, found.gain - rival.behind)) return found.gain;
  if ((walkGoes ? rival.cause : found.cause) != "bias_drift") return walkGoes ? kFaintDrift : kUsual;
  const double drift = walkGoes ? found.gain - rival.behind : found.gain;
  const double ahead = drift < kFaint ? kFaintDrift : -kPlainWalk;  // Of the walk, for the drift to be named
  return walkGoes ? ahead : -ahead;
}

}  // namespace

bool tied(const Found& found, const Rival& rival) {
  const double slack = slackBetween(found.cause, rival.cause, found.gain);
  if (rival.behind < kTie + slack || (slack > 0.0 && rival.worse < slack)) return true;
  const bool explains = rival.behind < found.gain;
  if (explains && rival.worse + kChance * rival.extra < 0.0) return true;
  if (rival.worse > kSame) return false;
  const auto alike = findCause(found.cause)->lookAlikes();
  const bool faint = found.gain < kFaint;
  return std::find(alike.begin(), alike.end(), rival.cause) != alike.end() ? faint || explains : faint && explains;
}

/// The trials around one model, kept since the look back may need them again.
struct Tried {
  Fit base;
  std::vector<Trial> all;
};

/// The model fitted without `cause`; where others make no sense without it, without those, too, the last accepted first.
Fit restWithout(const Signals& signals, const std::vector<Stretch>& stretches, const Model& model, std::string_view cause,
                std::span<const std::string> order) {
  Model less = without(model, cause);
  Fit out = settled(signals, stretches, fitModel(signals, stretches, less));
  for (std::size_t i = order.size(); i-- > 0 && !believable(out);) {
    if (!contains(less, order[i])) continue;
    less = without(less, order[i]);
    out = settled(signals, stretches, fitModel(signals, stretches, less));
  }
  return out;
}

bool sameForms(const Model& a, const Model& b) {
  return std::equal(a.terms.begin(), a.terms.end(), b.terms.begin(), b.terms.end(), [](const Term& s, const Term& t) {
    return s.form->cause == t.form->cause && s.form->name == t.form->name;
  });
}

std::optional<Fit> withOneOf(const Signals& signals, const std::vector<Stretch>& stretches, SignatureBank& bank, const Fit& base,
                             std::span<const std::string_view> causes) {
  const auto ranked = promises(signals, stretches, bank, base, causes);
  auto all = trialsOf(signals, stretches, base, chosenOf(ranked, kRivals, 0.0));
  if (all.empty() || all.front().gain < kThreshold) return std::nullopt;
  return std::move(all.front().fit);
}

Search search(const Signals& signals, const std::vector<Stretch>& stretches, SignatureBank& bank, const SearchOptions& options,
              const Progress& progress) {
  Search out;
  out.null = settled(signals, stretches, fitModel(signals, stretches, Model{}));
  out.final = out.null;
  std::vector<std::string> order;
  if (!options.start.terms.empty()) {
    out.final = prunedOf(signals, stretches, fitModel(signals, stretches, options.start), options.threshold);
    if (!believable(out.final)) out.final = out.null;
    for (const Term& term : out.final.model.terms)
      if (std::find(order.begin(), order.end(), causeOf(term)) == order.end()) order.emplace_back(causeOf(term));
  }
  double wanders = 0.0;  // What a wandering zero explains, once accepted
  if (contains(out.final.model, kWandering))
    wanders = out.final.evidence - fitModel(signals, stretches, without(out.final.model, kWandering)).evidence;
  Tried latest, accepted;
  for (int step = static_cast<int>(out.final.model.terms.size()); step < options.maxTerms && !progress.cancelled(); ++step) {
    progress(0.1 + 0.1 * step, heft::say("Trying causes"));
    const auto ranked = promises(signals, stretches, bank, out.final);
    if (ranked.empty()) break;
    latest = {out.final, trials(signals, stretches, out.final, ranked)};
    addCompletions(signals, stretches, out.final, latest.all);
    const auto& all = latest.all;
    const auto enough = [&](const Trial& trial) {
      const double explained = out.final.evidence - out.null.evidence;
      return trial.gain >= options.threshold + neededBeside(out.final.model, explained, wanders, trial.cause);
    };
    const auto best = std::ranges::find_if(all, enough);
    if (best == all.end()) break;
    // A richer form of what is already named comes before a second name, unless that one explains clearly more.
    const Trial* chosen = &*best;
    for (const auto& trial : all)
      if (contains(out.final.model, trial.cause) && enough(trial) && trial.gain > 0.7 * best->gain) {
        chosen = &trial;
        break;
      }
    // What a zero that wanders explains about as well is no drift: most of a walk's way is one. Nor is it a jump.
    if (chosen->cause == "bias_drift" || chosen->cause == "sensor_bias")
      for (const auto& trial : all)
        if (trial.cause == kWandering && trial.gain > chosen->gain - (chosen->cause == "bias_drift" ? kBesideWandering : kJump)) {
          chosen = &trial;
          break;
        }
    if (chosen->cause == kWandering)
      for (const auto& trial : all)
        if (isMoreThanWalk(trial.cause, trial.gain, chosen->gain)) {
          chosen = &trial;
          break;
        }
    if (chosen->cause == kWandering) wanders = chosen->gain;
    if (std::find(order.begin(), order.end(), chosen->cause) == order.end()) order.push_back(chosen->cause);
    out.final = settled(signals, stretches, prunedOf(signals, stretches, chosen->fit, options.threshold));
    accepted = std::move(latest);
    if (step == 0 && options.givesUp && options.givesUp(out.final)) {
      out.givenUp = true;
      return out;
    }
  }
  // Each cause once more, against everything that could stand in its place now. The last look changes nothing any more: what
  // was found must be told whole.
  constexpr int kLooks = 3;
  bool changed = true;
  for (int look = 0; look < kLooks && changed && !progress.cancelled(); ++look) {
    changed = false;
    out.found.clear();
    for (const auto& cause : std::vector<std::string>(order)) {
      if (!contains(out.final.model, cause) || progress.cancelled()) continue;
      progress(0.8, heft::say("Comparing what could stand in its place"));
      Found found;
      found.cause = cause;
      // What was tried before the last cause was accepted is what stands against it now.
      Tried now;
      if (!accepted.all.empty() && sameForms(without(out.final.model, cause), accepted.base.model))
        now = accepted;
      else
        now.base = restWithout(signals, stretches, out.final.model, cause, order);
      const Fit& rest = now.base;
      found.gain = out.final.evidence - rest.evidence;
      if (now.all.empty()) {
        const auto ranked = promises(signals, stretches, bank, rest);
        now.all = trialsOf(signals, stretches, rest, chosenOf(ranked, kRivals, found.gain));
        addCompletions(signals, stretches, rest, now.all);
      }
      if (cause == kWandering)
        outgrowWalk(signals, stretches, bank, found.gain, now.all);
      else
        growRivals(signals, stretches, bank, out.final.model, cause, now.all);
      settleRivals(signals, stretches, rest, found, now.all);
      const auto& all = now.all;
      found.spread = spreadOf(out.final.model, cause, all);
      // A richer form of it that promised little around what else was wrong by then.
      const auto own = std::ranges::find_if(all, [&](const Trial& t) { return t.cause == cause; });
      if (own != all.end() && own->gain > found.gain + kTie && look + 1 < kLooks) {
        out.final = settled(signals, stretches, prunedOf(signals, stretches, own->fit, options.threshold));
        changed = true;
        break;
      }
      // What another of the named causes explains about as well needs no name of its own.
      const auto other = std::ranges::find_if(all, [&](const Trial& t) {
        const Form& form = *t.fit.model.terms.back().form;
        return t.gain > found.gain - kTie && t.cause != cause && contains(rest.model, t.cause) && !form.local && !form.walk;
      });
      if (other != all.end() && look + 1 < kLooks) {
        out.final = settled(signals, stretches, prunedOf(signals, stretches, other->fit, options.threshold));
        std::erase(order, cause);
        changed = true;
        break;
      }
      std::map<std::string, const Trial*> best;
      for (const auto& trial : all)
        if (trial.gain > -1e299 && trial.cause != cause && !contains(rest.model, trial.cause) && best.try_emplace(trial.cause, &trial).second)
          found.rivals.push_back(rivalOf(found, trial, out.final));
      std::stable_sort(found.rivals.begin(), found.rivals.end(),
                       [](const Rival& a, const Rival& b) { return a.behind < b.behind; });
      const auto better = std::find_if(found.rivals.begin(), found.rivals.end(),
                                       [&](const Rival& r) { return r.behind < -leadFor(found, r); });
      if (better != found.rivals.end() && look + 1 < kLooks) {
        out.final = settled(signals, stretches, prunedOf(signals, stretches, best.at(better->cause)->fit, options.threshold));
        *std::find(order.begin(), order.end(), cause) = better->cause;
        for (const Term& term : out.final.model.terms)
          if (std::find(order.begin(), order.end(), causeOf(term)) == order.end()) order.emplace_back(causeOf(term));
        changed = true;
        break;
      }
      std::erase_if(found.rivals, [&](const Rival& r) { return !tied(found, r); });
      out.found.push_back(std::move(found));
    }
  }
  return out;
}

}  // namespace heft::diagnosis
