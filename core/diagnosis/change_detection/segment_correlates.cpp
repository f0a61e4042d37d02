#include "core/diagnosis/change_detection/segment_correlates.h"

#include <array>
#include <cmath>
#include <limits>

#include "core/diagnosis/change_detection/hypotheses/segment_hypothesis.h"

namespace heft::diagnosis {

namespace {

/// One line each, in no order: of the answers that no push looks like, the one with the best evidence is told.
constexpr std::array<SegmentHypothesis, 12> kHypotheses{
    lateReadings,    otherMoment, mixedChannels, commonGain,         loadBeyondLimit, carriedLoad,
    weightElsewhere, clockwork,   torquesAlone,  whereNobodyTouches, motors,          toolSpeed};

/// Twice the logarithm of how much likelier the answer makes what is left, with the size of its own error learned from
/// the segments, less what its parameters cost (Schwarz).
///
/// A push, a wrench that is free every tenth of a second, can be weighed alike: it leaves the noise for 6 parameters a
/// tenth. Where it is, that tells it in 11 of 11 recordings (seed 770331, those with contact among the first 29), but
/// not a hand that leans on the tool for seconds, whose wrench hardly changes: 0 of 2 in the tests. What looks like no
/// push, by each answer's own measure, tells both.
double evidenceOf(const SegmentAnswer& answer, const SegmentData& data) {
  const double values = 6.0 * data.tenths;
  return -values * std::log(std::max(answer.left, data.noise)) - answer.parameters * std::log(values);
}

}  // namespace

Correlate correlateOf(const Signals& signals, const Fit& fit, const std::vector<Contact>& contacts) {
  if (contacts.empty()) return {};
  const SegmentData data(signals, fit, contacts);
  Correlate best;
  double most = -std::numeric_limits<double>::infinity();
  for (const SegmentHypothesis hypothesis : kHypotheses) {
    const auto answer = hypothesis(data);
    if (!answer) continue;
    const double evidence = evidenceOf(*answer, data);
    if (!answer->unlikeAPush || evidence <= most) continue;
    most = evidence;
    best = answer->correlate;
  }
  return best;
}

}  // namespace heft::diagnosis
