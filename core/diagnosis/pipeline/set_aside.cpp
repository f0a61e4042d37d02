#include "core/diagnosis/pipeline/set_aside.h"

#include <algorithm>
#include <iterator>

#include "core/base/say.h"
#include "core/diagnosis/change_detection/segment_correlates.h"
#include "core/diagnosis/pipeline/hypothesis.h"
#include "core/diagnosis/pipeline/smoothing_candidate.h"
#include "core/math/statistics.h"

namespace heft::diagnosis {

namespace {

constexpr double kMostOfTime = 0.25;  ///< For light touches; what takes longer is none

/// All contacts are something else, which `goesWith` that. Not translated.
void setAllAside(Work& work, std::string goesWith) {
  work.odd = std::move(work.contacts);
  work.contacts.clear();
  work.oddGoesWith = std::move(goesWith);
}

/// How many times its usual power the noise has near a touch, but not in it; 1 where it is quieter. `e`: innovations, 6
/// x N.
double loudnessBeside(const Contact& touch, const Work& work, const Eigen::Map<const Wrenches>& e) {
  constexpr double kNear = 2.0, kApart = 0.1, kWindow = 1.0;  // [s]
  const auto length = static_cast<Eigen::Index>(kWindow * work.signals.blockRate());
  std::vector<double> usual;
  double near = 0.0, count = 0.0;
  for (const auto& s : work.stretches) {
    for (Eigen::Index n = s.from; n + length <= s.to; n += length)
      usual.push_back(e.middleCols(n, length).squaredNorm() / static_cast<double>(length));
    for (Eigen::Index n = s.from; n < s.to; ++n) {
      const double t = work.signals.blockTime(n);
      if (t < touch.from - kNear || t > touch.to + kNear || (t > touch.from - kApart && t < touch.to + kApart))
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
bool wereTouches(double peak, double evidence, double longest, const Work& work) {
  // Of 30 faint ones in 560 recordings, real touches had 32 or more, and more than 1.3 times the noise below 100.
  // Nobody touches with a torque and no force: one of 408 others, over 1.2 s, had 433 and 0.4 times the noise.
  constexpr double kLeast = 30.0, kShareOfOthers = 0.03, kLittle = 100.0, kOfNoise = 0.7;
  // What lasts has more room for what others leave.
  constexpr double kLasts = 1.5, kShareIfItLasts = 0.2;  // [s]
  double others = 0.0;
  for (const Found& found : work.search.found)
    if (found.cause != "contact") others += found.gain;
  if (evidence < kLeast + (longest > kLasts ? kShareIfItLasts : kShareOfOthers) * others) return false;
  return peak > (evidence > kLittle ? kOfNoise : 1.0) * rmsOf(work.stretches, work.search.final.residual).force;
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
  constexpr double kStandsOut = 5.0;  // Times the usual
  constexpr Eigen::Index kQuiet = 5;  // Blocks in a row end it
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
    if (causeOf(term) != "contact") continue;
    for (const auto& [from, to] : term.form->cause->when(*term.form, term.v, signals)) {
      Stretch at = blocksBetween(signals, from, to);
      if (at.from >= at.to) continue;
      for (Eigen::Index n = at.from - 1; n >= std::max<Eigen::Index>(0, at.from - kQuiet); --n)
        if (loud(n)) at.from = n;
      for (Eigen::Index n = at.to; n < std::min(signals.blocks(), at.to + kQuiet); ++n)
        if (loud(n)) at.to = n + 1;
      out.push_back(at);
    }
  }
  return out;
}

/// Whether all of them touch contact that is known: more of the same.
bool goOn(const std::vector<Stretch>& touches, const std::vector<Stretch>& holes) {
  constexpr Eigen::Index kApart = 5;  // Blocks
  return std::ranges::all_of(touches, [&](const Stretch& touch) {
    return std::ranges::any_of(
        holes, [&](const Stretch& hole) { return touch.from < hole.to + kApart && touch.to > hole.from - kApart; });
  });
}

}  // namespace

std::vector<Stretch> holesWithTouches(const Signals& signals, const Standing& standing,
                                      const std::vector<Stretch>& holes) {
  // Evidence for a touch, its share of that for everything, and the evidence for more of one that is known. A drift
  // that begins looks like contact at its bend, and like a touch of 110 that goes on from it.
  constexpr double kPlain = 1000.0, kShare = 0.1, kMoreOfIt = 300.0;
  if (standing.last != "contact") return {};
  const auto touches = touchesIn(signals, standing.fit);
  if (touches.empty()) return {};
  const bool plain = standing.gain > std::max(kPlain, kShare * standing.explained);
  if (!plain && !(standing.gain > kMoreOfIt && goOn(touches, holes))) return {};
  auto out = together(holes, touches);
  const double judged = blocksIn(stretchesOf(signals.usable));
  return blocksIn(out) - blocksIn(holes) < kMostOfTime * judged ? out : std::vector<Stretch>{};
}

void setOddAside(Work& work, const Signals& whole) {
  std::ranges::copy_if(work.contacts, std::back_inserter(work.smoothed), &Contact::smoothed);
  std::erase_if(work.contacts, [](const Contact& c) { return c.smoothed; });
  std::vector<Contact> pushes;
  for (const Contact& contact : work.contacts) (contact.instead.empty() ? pushes : work.odd).push_back(contact);
  if (!work.odd.empty()) work.oddGoesWith = std::ranges::max_element(work.odd, {}, &Contact::evidence)->instead;
  // What is something else again and again is so each time.
  if (work.odd.size() > 2 && 3.0 * evidenceOf(work.odd) > evidenceOf(work.contacts)) {
    work.odd = std::move(work.contacts);
    pushes.clear();
  }
  if (const std::string law = lawOf(whole, work.search.final, pushes); !law.empty()) {
    setAllAside(work, law);
    pushes.clear();
  }
  work.contacts = std::move(pushes);
}

void setTouchesAside(Work& work) {
  constexpr std::ptrdiff_t kMost = 4;
  Search& search = work.search;
  const auto found =
      std::find_if(search.found.begin(), search.found.end(), [](const Found& f) { return f.cause == "contact"; });
  if (found == search.found.end()) return;
  Signals& signals = work.signals;
  std::vector<Contact> touches;
  double longest = 0.0, peak = 0.0;
  for (const auto& term : search.final.model.terms) {
    if (causeOf(term) != "contact") continue;
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
  const VectorXd innovations = whitened(flat(residual), search.final.noise, work.stretches);
  double evidence = 0.0;
  for (const auto& touch : touches)
    evidence += touch.evidence / loudnessBeside(touch, work, {innovations.data(), 6, residual.cols()});
  const bool touched = wereTouches(peak, evidence, longest, work);
  search.found.erase(found);
  Model model = without(search.final.model, "contact");
  if (durationOf(touches) < kMostOfTime * signals.duration() && std::ssize(touches) <= kMost && touched) {
    Signals less = signals;
    leaveOut(less, blocksOf(touches));
    if (auto stretches = stretchesOf(less.usable); !stretches.empty()) {
      signals = std::move(less);
      work.stretches = std::move(stretches);
      // Where something else than contact comes and goes, a little more of it is no touch either.
      auto& known = work.odd.empty() ? work.contacts : work.odd;
      known.insert(known.end(), touches.begin(), touches.end());
      known = joined(std::move(known), 0.0);
      search.null = fitModel(signals, work.stretches, Model{});
    }
  }
  search.final = fitModel(signals, work.stretches, std::move(model));
  if (const std::string law = lawOf(signals, search.final, work.contacts); !law.empty()) setAllAside(work, law);
}

void setKnocksAside(Work& work) {
  constexpr double kKnock = 0.25;  ///< [s]
  /// Of five recordings with two or more, and nothing longer, none had been touched
  constexpr std::ptrdiff_t kKnocks = 3;
  if (std::ssize(work.contacts) < kKnocks ||
      std::ranges::any_of(work.contacts, [](const Contact& c) { return c.to - c.from > kKnock; }))
    return;
  setAllAside(work, heft::toSay("short knocks"));
}

void setCarriedAside(Work& work, const std::vector<std::string>& hidden) {
  constexpr std::string_view kCause = "payload_change";
  if (std::ranges::find(hidden, kCause) != hidden.end() || contains(work.search.final.model, kCause)) return;
  work.carried = carriedIn(work.signals, work.search.final, work.contacts);
  if (work.carried) work.contacts.clear();
}

void setAgainAside(Work& work) {
  const Model& model = work.search.final.model;
  const bool jumps = contains(model, "sensor_bias"), changes = contains(model, "payload_change");
  if (work.contacts.empty() || (!jumps && !changes)) return;
  work.again = recurrencesIn(work.signals, work.search.final, work.contacts, jumps, changes);
  std::erase_if(work.contacts, [&](const Contact& contact) {
    return std::ranges::any_of(work.again, [&](const Contact& again) { return again.from == contact.from; });
  });
}

void setRingingAside(Work& work, const Way& way) {
  std::vector<Contact> all = work.contacts;
  for (const auto* more : {&work.odd, &work.smoothed}) all.insert(all.end(), more->begin(), more->end());
  if (all.empty()) return;
  const auto signals = asIn(work, way);
  if (!signals) return;
  std::ranges::sort(all, {}, &Contact::from);
  // One that the blocks show a little of is the same mount. What else swings may make noise of a motion that is
  // smoothed less than the one in which it was found.
  const Model found = without(work.search.final.model, "flexible_mount"),
              bare = found.terms.empty() ? found : fitModel(*signals, work.stretches, Model{}).model;
  const auto loudness = [&](const Model& model) {
    return usualSpread(*signals, signals->readings - predicted(*signals, model), all).array().log().sum();
  };
  work.ringing = ringingIn(*signals, !found.terms.empty() && loudness(bare) < loudness(found) ? bare : found, all);
  if (!work.ringing) return;
  const auto rings = [&](const Contact& contact) {
    return std::ranges::any_of(work.ringing->when, [&](const auto& when) { return when.first == contact.from; });
  };
  std::erase_if(work.contacts, rings);
  std::erase_if(work.odd, rings);
  // Where it rings less, that is odd, too.
  if (evidenceOf(work.odd) < work.ringing->evidence) work.odd.clear();
}

}  // namespace heft::diagnosis
