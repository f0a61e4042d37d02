// Readings of another moment, the same way off for as long as a segment lasts, such as where a clock is set.
#include <algorithm>

#include "core/base/say.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/change_detection/hypotheses/segment_hypothesis.h"

namespace heft::diagnosis {

std::optional<SegmentAnswer> otherMoment(const SegmentData& data) {
  constexpr double kStep = 0.25;  // [blocks]
  const auto most = static_cast<int>(kEvent * data.signals.blockRate() / kStep);
  double all = 1e-300, left = 0.0, leftWithin = 0.0;
  for (const Contact& contact : data.contacts) {
    double least = 1e300, leastWithin = 0.0, asItIs = 0.0;
    for (int i = -most; i <= most; ++i) {
      double here = 0.0, within = 0.0;  // It begins and ends somewhere in the segment
      for (Eigen::Index n = contact.blocks.from; n < contact.blocks.to; ++n) {
        const double at =
            std::clamp(static_cast<double>(n) + kStep * i, 0.0, static_cast<double>(data.signals.blocks() - 2));
        const auto before = static_cast<Eigen::Index>(at);
        const double share = at - static_cast<double>(before);
        const Vector6d should = (1.0 - share) * data.should.col(before) + share * data.should.col(before + 1);
        double shifted = 0.0, asRead = 0.0;
        for (Eigen::Index c = 0; c < 6; ++c) {
          shifted += data.excess(data.signals.measured(c, n) - should(c), c);
          asRead += data.excess(data.fit.residual(c, n), c);
        }
        here += shifted;
        within += std::min(shifted, asRead);
      }
      if (here < least) {
        least = here;
        leastWithin = within;
      }
      if (i == 0) asItIs = here;
    }
    all += asItIs;
    left += least;
    leftWithin += leastWithin;
  }
  // In 46 recordings that were touched or seemed so, another moment left 0.27 and less, all others 0.6 and more,
  // touches 0.8.
  return SegmentAnswer{heft::toSay("readings of another moment"), leftWithin / all,
                       static_cast<double>(data.contacts.size()), left < (1.0 - kMajority) * all};
}

}  // namespace heft::diagnosis
