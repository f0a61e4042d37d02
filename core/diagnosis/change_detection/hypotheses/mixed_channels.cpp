// Channels that are mixed up for a while, as by a cable or a parser out of step: in each segment two of them, or two
// axes, read what the model says for each other, or one has the other sign.
#include <algorithm>

#include "core/base/say.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/change_detection/hypotheses/segment_hypothesis.h"

namespace heft::diagnosis {

namespace {

/// What two channels that are mixed up change of the excess power in block `n`; one and the same: its sign is wrong.
double changeBy(const SegmentData& data, Eigen::Index n, Eigen::Index a, Eigen::Index b) {
  const auto readsAs = [&](Eigen::Index channel, Eigen::Index other, double value) {
    return data.excess(data.signals.measured(channel, n) - value, other) -
           data.excess(data.fit.residual(channel, n), channel);
  };
  return a == b ? readsAs(a, a, -data.should(a, n))
                : readsAs(a, b, data.should(b, n)) + readsAs(b, a, data.should(a, n));
}

/// Excess power in blocks [from, to): as it is, and the least that mixed channels leave of it.
std::pair<double, double> excessIn(const SegmentData& data, const Stretch& blocks) {
  const auto [from, to] = blocks;
  VectorXd asTheyAre = VectorXd::Zero(to - from);
  for (Eigen::Index n = from; n < to; ++n)
    for (Eigen::Index c = 0; c < 6; ++c) asTheyAre(n - from) += data.excess(data.fit.residual(c, n), c);
  double least = asTheyAre.sum();
  const auto tryOut = [&, from = from, to = to](const auto& changeAt) {
    double mixed = 0.0;
    for (Eigen::Index n = from; n < to; ++n)
      mixed += std::min(0.0, changeAt(n)) + asTheyAre(n - from);  // It begins and ends somewhere in the segment
    least = std::min(least, mixed);
  };
  for (Eigen::Index a = 0; a < 6; ++a)
    for (Eigen::Index b = a; b < 6; ++b) {
      tryOut([&](Eigen::Index n) { return changeBy(data, n, a, b); });
      if (b < 3) tryOut([&](Eigen::Index n) { return changeBy(data, n, a, b) + changeBy(data, n, a + 3, b + 3); });
    }
  return {asTheyAre.sum(), least};
}

}  // namespace

std::optional<SegmentAnswer> mixedChannels(const SegmentData& data) {
  double all = 1e-300, left = 0.0;
  for (const Contact& contact : data.contacts) {
    const auto [asItIs, least] = excessIn(data, contact.blocks);
    all += asItIs;
    left += least;
  }
  return SegmentAnswer{heft::toSay("channels that are mixed up for a while"), left / all,
                       static_cast<double>(data.contacts.size()), left < (1.0 - kNearlyAll) * all};
}

}  // namespace heft::diagnosis
