// Readings that come late, such as where a logger stalls or an output cannot follow: who pushes makes a sensor read
// what it should not have read a moment before.
#include <algorithm>
#include <cmath>

#include "core/base/say.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/change_detection/hypotheses/segment_hypothesis.h"

namespace heft::diagnosis {

namespace {

/// Share of the excess power that is left where each channel may read what the model says for any moment up to a tenth
/// of a second before, or after where `later`.
double leftIfReadAt(bool later, const SegmentData& data) {
  const Eigen::Index blocks = data.signals.blocks(), reach = std::lround(kMoment * data.signals.blockRate());
  double all = 1e-300, left = 0.0;
  for (const Contact& contact : data.contacts)
    for (Eigen::Index n = contact.blocks.from; n < contact.blocks.to; ++n)
      for (Eigen::Index c = 0; c < 6; ++c) {
        const Eigen::Index from = later ? n : std::max<Eigen::Index>(0, n - reach),
                           to = later ? std::min(blocks - 1, n + reach) : n;
        const auto may = data.should.row(c).segment(from, to - from + 1);
        const double is = data.signals.measured(c, n);
        all += data.excess(data.fit.residual(c, n), c);
        left += data.excess(is - std::clamp(is, may.minCoeff(), may.maxCoeff()), c);
      }
  return left / all;
}

}  // namespace

std::optional<SegmentAnswer> lateReadings(const SegmentData& data) {
  // In 370 recordings that were touched or seemed so, late readings left 0.06 and less; one touch left 0.15, all others
  // more. Readings of the future would explain a push as well.
  const double left = leftIfReadAt(false, data);
  const bool late = left < 1.0 - kNearlyAll && left < leftIfReadAt(true, data) - kMajority;
  return SegmentAnswer{heft::toSay("what the channels read before"), left, 0.0, late};
}

}  // namespace heft::diagnosis
