#include "core/diagnosis/change_detection/hypotheses/segment_hypothesis.h"

#include <cmath>

#include "core/diagnosis/calibration.h"

namespace heft::diagnosis {

SegmentData::SegmentData(const Signals& signals_, const Fit& fit_, const std::vector<Contact>& contacts_)
    : signals(signals_),
      fit(fit_),
      contacts(contacts_),
      should(signals_.measured - fit_.residual),
      usual(usualPower(signals_, fit_, blocksOf(contacts_))),
      load(loadIn(signals_, fit_, contacts_)) {
  double all = 1e-300, blocks = 0.0;
  for (const Stretch& s : blocksOf(contacts)) {
    const auto count = static_cast<double>(s.to - s.from);
    all += scaled(fit.residual.middleCols(s.from, s.to - s.from)).squaredNorm();
    tenths += std::ceil(count / (kMoment * signals.blockRate()));
    blocks += count;
  }
  noise = std::min(1.0, 6.0 * blocks / all);
}

}  // namespace heft::diagnosis
