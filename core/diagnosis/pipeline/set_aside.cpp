#include "core/diagnosis/pipeline/set_aside.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "core/base/say.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/change_detection/segment_correlates.h"
#include "core/diagnosis/pipeline/hypothesis.h"
#include "core/diagnosis/pipeline/smoothing_candidate.h"
#include "core/math/statistics.h"

namespace heft::diagnosis {

namespace {

/// All contacts are something else, which goes with `correlate`.
void setAllAside(Hypothesis& hypothesis, Correlate correlate) {
  hypothesis.unexplained = std::move(hypothesis.contacts);
  hypothesis.contacts.clear();
  hypothesis.unexplainedCorrelate = correlate;
}

/// How many times its usual power the noise has near a touch, but not in it; 1 where it is quieter. `e`: innovations, 6
/// x N.
double loudnessBeside(const Contact& touch, const Hypothesis& hypothesis, const Eigen::Map<const Wrenches>& e) {
  constexpr double kWindow = 1.0;  // [s]
  const auto length = static_cast<Eigen::Index>(kWindow * hypothesis.signals.blockRate());
  std::vector<double> usual;
  double near = 0.0, count = 0.0;
  for (const auto& s : hypothesis.stretches) {
    for (Eigen::Index n = s.from; n + length <= s.to; n += length)
      usual.push_back(e.middleCols(n, length).squaredNorm() / static_cast<double>(length));
    for (Eigen::Index n = s.from; n < s.to; ++n) {
      const double t = hypothesis.signals.blockTime(n);
      if (t < touch.from - kBriefly || t > touch.to + kBriefly || (t > touch.from - kMoment && t < touch.to + kMoment))
        continue;
      near += e.col(n).squaredNorm();
      count += 1.0;
    }
  }
  return count > 0.0 && !usual.empty() ? std::max(1.0, near / count / std::max(1e-12, median(usual))) : 1.0;
}

/// Whether so much speaks for touches with the greatest force of `peak` [N], beside what else the search found, that
/// something was touched. What other causes leave when their form is not quite right looks like a touch now and then,
/// often one of a torque without a force.
bool wereTouches(double peak, double evidence, double longest, const Hypothesis& hypothesis) {
  // Of 30 faint ones in 560 recordings, real touches had 32 or more, and more than 1.3 times the noise below 100.
  // Nobody touches with a torque and no force: one of 408 others, over 1.2 s, had 433 and 0.4 times the noise.
  constexpr double kOfNoise = 0.7;
  // What lasts has more room for what others leave.
  double others = 0.0;
  for (const Found& found : hypothesis.search.found)
    if (found.cause != ids::contact) others += found.gain;
  if (evidence < kClearEvidence + (longest > kBriefly ? kBroadError : kFormError) * others) return false;
  return peak > (evidence > 2.0 * kFaint ? kOfNoise : 1.0) *
                    rmsOf(hypothesis.stretches, hypothesis.search.final.residual).force;
}

/// Contacts that follow each other within `apart` [s], or that overlap, as one. Rising in time.
std::vector<Contact> joined(std::vector<Contact> contacts, double apart) {
  std::ranges::sort(contacts, {}, &Contact::from);
  std::vector<Contact> out;
  for (Contact& contact : contacts) {
    if (out.empty() || contact.from > out.back().to + apart) {
      out.push_back(std::move(contact));
      continue;
    }
    Contact& same = out.back();
    same.to = std::max(same.to, contact.to);
    same.blocks.to = std::max(same.blocks.to, contact.blocks.to);
    same.evidence += contact.evidence;
  }
  return out;
}

/// The blocks from one moment to another [s]; none: as no stretch has them.
Stretch blocksBetween(const Signals& signals, double from, double to) {
  Stretch out{signals.blocks(), 0};
  for (Eigen::Index n = 0; n < signals.blocks(); ++n)
    if (signals.blockTime(n) >= from && signals.blockTime(n) <= to) out = {std::min(out.from, n), n + 1};
  return out;
}

/// Where the fit has touches, as far as they go: what is left beside them stands out from what is left elsewhere.
std::vector<Stretch> touchesIn(const Signals& signals, const Fit& fit) {
  Vector6d usual;
  for (Eigen::Index c = 0; c < 6; ++c) {
    std::vector<double> left;
    for (Eigen::Index n = 0; n < signals.blocks(); ++n)
      if (signals.usable[static_cast<std::size_t>(n)]) left.push_back(fit.residual(c, n));
    usual(c) = std::max(1e-12, robustStd(left));
  }
  const auto loud = [&](Eigen::Index n) {
    return (fit.residual.col(n).array().abs() / usual.array()).maxCoeff() > kStandsOut;
  };
  std::vector<Stretch> out;
  for (const Term& term : fit.model.terms) {
    if (causeOf(term) != ids::contact) continue;
    for (const auto& [from, to] : term.form->cause->when(*term.form, term.v, signals)) {
      Stretch at = blocksBetween(signals, from, to);
      if (at.from >= at.to) continue;
      for (Eigen::Index n = at.from - 1; n >= std::max<Eigen::Index>(0, at.from - kMomentBlocks); --n)
        if (loud(n)) at.from = n;
      for (Eigen::Index n = at.to; n < std::min(signals.blocks(), at.to + kMomentBlocks); ++n)
        if (loud(n)) at.to = n + 1;
      out.push_back(at);
    }
  }
  return out;
}

/// Whether all of them touch contact that is known: more of the same.
bool goOn(const std::vector<Stretch>& touches, const std::vector<Stretch>& holes) {
  return std::ranges::all_of(touches, [&](const Stretch& touch) {
    return std::ranges::any_of(holes, [&](const Stretch& hole) {
      return touch.from < hole.to + kMomentBlocks && touch.to > hole.from - kMomentBlocks;
    });
  });
}

/// What is asked of contacts before they are told.
struct Question {
  void (*set)(Hypothesis& hypothesis, const Signals& whole, const std::vector<std::string>& hidden);
  bool onlyIfSought;  ///< There is nothing to ask where contact was not looked for
};

/// The order is the meaning: each question is about the contacts that those before it left.
constexpr std::array kSettingAside{
    // Before light touches come in: a law is told from strong contact, and light touches would blur it. On the whole
    // signals, since the others have the contacts left out.
    Question{
        [](Hypothesis& h, const Signals& whole, const std::vector<std::string>&) { setUnexplainedAside(h, whole); },
        true},
    // Then touches are contact like any other, so that what follows is asked of all of them together.
    Question{[](Hypothesis& h, const Signals&, const std::vector<std::string>&) { setTouchesAside(h); }, false},
    // Needs their number and lengths only; knocks weigh nothing, so before the load.
    Question{[](Hypothesis& h, const Signals&, const std::vector<std::string>&) { setKnocksAside(h); }, false},
    // One load that accounts for all contacts; if there is one, none is left for what follows.
    Question{
        [](Hypothesis& h, const Signals&, const std::vector<std::string>& hidden) { setCarriedLoadAside(h, hidden); },
        false},
    // Single contacts that the model's own jumps account for: last, since it takes some of them only.
    Question{[](Hypothesis& h, const Signals&, const std::vector<std::string>&) { setRecurrencesAside(h); }, false}};

}  // namespace

void setAside(Hypothesis& hypothesis, const Signals& whole, bool sought, const std::vector<std::string>& hidden) {
  for (const Question& question : kSettingAside)
    if (sought || !question.onlyIfSought) question.set(hypothesis, whole, hidden);
}

std::vector<Stretch> holesWithTouches(const Signals& signals, const SearchStatus& standing,
                                      const std::vector<Stretch>& holes) {
  if (standing.last != ids::contact) return {};
  const auto touches = touchesIn(signals, standing.fit);
  if (touches.empty()) return {};
  const bool plain = standing.gain > std::max(kSeenDirectly, kEventError * standing.explained);
  if (!plain && !(standing.gain > kOverwhelming && goOn(touches, holes))) return {};
  auto out = together(holes, touches);
  const double judged = blocksIn(stretchesOf(signals.usable));
  return blocksIn(out) - blocksIn(holes) < kTouched * judged ? out : std::vector<Stretch>{};
}

void setUnexplainedAside(Hypothesis& hypothesis, const Signals& whole) {
  std::ranges::copy_if(hypothesis.contacts, std::back_inserter(hypothesis.smoothed), &Contact::smoothed);
  std::erase_if(hypothesis.contacts, [](const Contact& c) { return c.smoothed; });
  std::vector<Contact> pushes;
  for (const Contact& contact : hypothesis.contacts)
    (contact.instead.empty() ? pushes : hypothesis.unexplained).push_back(contact);
  if (!hypothesis.unexplained.empty())
    hypothesis.unexplainedCorrelate = std::ranges::max_element(hypothesis.unexplained, {}, &Contact::evidence)->instead;
  // What is something else again and again is so each time.
  if (hypothesis.unexplained.size() > 2 && 3.0 * evidenceOf(hypothesis.unexplained) > evidenceOf(hypothesis.contacts)) {
    hypothesis.unexplained = std::move(hypothesis.contacts);
    pushes.clear();
  }
  if (const Correlate law = correlateOf(whole, hypothesis.search.final, pushes); !law.empty()) {
    setAllAside(hypothesis, law);
    pushes.clear();
  }
  hypothesis.contacts = std::move(pushes);
}

void setTouchesAside(Hypothesis& hypothesis) {
  Search& search = hypothesis.search;
  const auto found =
      std::find_if(search.found.begin(), search.found.end(), [](const Found& f) { return f.cause == ids::contact; });
  if (found == search.found.end()) return;
  Signals& signals = hypothesis.signals;
  std::vector<Contact> touches;
  double longest = 0.0, peak = 0.0;
  for (const auto& term : search.final.model.terms) {
    if (causeOf(term) != ids::contact) continue;
    for (const auto& [from, to] : term.form->cause->when(*term.form, term.v, signals)) {
      touches.push_back({from, to, 0.0, blocksBetween(signals, from, to), {}});
      peak = std::max(peak, term.v.segment<3>(1).norm());
    }
  }
  // One touch may have taken several terms.
  touches = joined(std::move(touches), 0.3);
  for (const Contact& touch : touches) longest = std::max(longest, touch.to - touch.from);
  for (auto& touch : touches) touch.evidence = found->gain / static_cast<double>(touches.size());
  // Where the noise is louder for a while, something of it looks like a touch.
  const Wrenches& residual = search.final.residual;
  const VectorXd innovations = whitened(flat(residual), search.final.noise, hypothesis.stretches);
  double evidence = 0.0;
  for (const auto& touch : touches)
    evidence += touch.evidence / loudnessBeside(touch, hypothesis, {innovations.data(), 6, residual.cols()});
  const bool touched = wereTouches(peak, evidence, longest, hypothesis);
  search.found.erase(found);
  Model model = without(search.final.model, ids::contact);
  if (durationOf(touches) < kTouched * signals.duration() && std::ssize(touches) <= kOverfitted && touched) {
    Signals less = signals;
    leaveOut(less, blocksOf(touches));
    if (auto stretches = stretchesOf(less.usable); !stretches.empty()) {
      signals = std::move(less);
      hypothesis.stretches = std::move(stretches);
      // Where something else than contact comes and goes, a little more of it is no touch either.
      auto& known = hypothesis.unexplained.empty() ? hypothesis.contacts : hypothesis.unexplained;
      known.insert(known.end(), touches.begin(), touches.end());
      known = joined(std::move(known), 0.0);
      search.null = fitModel(signals, hypothesis.stretches, Model{});
    }
  }
  search.final = fitModel(signals, hypothesis.stretches, std::move(model));
  if (const Correlate law = correlateOf(signals, search.final, hypothesis.contacts); !law.empty())
    setAllAside(hypothesis, law);
}

void setKnocksAside(Hypothesis& hypothesis) {
  // Of five recordings with two or more, and nothing longer, none had been touched.
  if (hypothesis.contacts.size() < kAgainAndAgain ||
      std::ranges::any_of(hypothesis.contacts, [](const Contact& c) { return c.to - c.from > kEvent; }))
    return;
  setAllAside(hypothesis, heft::toSay("short knocks"));
}

void setCarriedLoadAside(Hypothesis& hypothesis, const std::vector<std::string>& hidden) {
  constexpr std::string_view kCause = ids::payloadChange;
  if (std::ranges::find(hidden, kCause) != hidden.end() || contains(hypothesis.search.final.model, kCause)) return;
  hypothesis.carriedLoad = carriedLoadIn(hypothesis.signals, hypothesis.search.final, hypothesis.contacts);
  if (hypothesis.carriedLoad) hypothesis.contacts.clear();
}

void setRecurrencesAside(Hypothesis& hypothesis) {
  const Model& model = hypothesis.search.final.model;
  const bool jumps = contains(model, ids::sensorBias), changes = contains(model, ids::payloadChange);
  if (hypothesis.contacts.empty() || (!jumps && !changes)) return;
  hypothesis.recurrences =
      recurrencesIn(hypothesis.signals, hypothesis.search.final, hypothesis.contacts, jumps, changes);
  std::erase_if(hypothesis.contacts, [&](const Contact& contact) {
    return std::ranges::any_of(hypothesis.recurrences,
                               [&](const Contact& again) { return again.from == contact.from; });
  });
}

void setRingingAside(Hypothesis& hypothesis, const SmoothingCandidate& candidate) {
  std::vector<Contact> all = hypothesis.contacts;
  for (const auto* more : {&hypothesis.unexplained, &hypothesis.smoothed})
    all.insert(all.end(), more->begin(), more->end());
  if (all.empty()) return;
  const auto signals = asIn(hypothesis, candidate);
  if (!signals) return;
  std::ranges::sort(all, {}, &Contact::from);
  // One that the blocks show a little of is the same mount. What else swings may make noise of a motion that is
  // smoothed less than the one in which it was found.
  const Model found = without(hypothesis.search.final.model, ids::flexibleMount),
              bare = found.terms.empty() ? found : fitModel(*signals, hypothesis.stretches, Model{}).model;
  const auto loudness = [&](const Model& model) {
    return usualSpread(*signals, signals->readings - predicted(*signals, model), all).array().log().sum();
  };
  hypothesis.ringing =
      ringingIn(*signals, !found.terms.empty() && loudness(bare) < loudness(found) ? bare : found, all);
  if (!hypothesis.ringing) return;
  const auto rings = [&](const Contact& contact) {
    return std::ranges::any_of(hypothesis.ringing->when, [&](const auto& when) { return when.first == contact.from; });
  };
  std::erase_if(hypothesis.contacts, rings);
  std::erase_if(hypothesis.unexplained, rings);
  // Where it rings less, that is odd, too.
  if (evidenceOf(hypothesis.unexplained) < hypothesis.ringing->evidence) hypothesis.unexplained.clear();
}

}  // namespace heft::diagnosis
