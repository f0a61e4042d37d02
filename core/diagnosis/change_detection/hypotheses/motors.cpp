// What a joint's motor disturbs: whether the joint turns, and how hard it speeds up or slows down.
#include <algorithm>

#include "core/base/say.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/change_detection/hypotheses/law_of_motion.h"

namespace heft::diagnosis {

std::optional<SegmentAnswer> motors(const SegmentData& data) {
  const Signals& signals = data.signals;
  if (data.contacts.size() < 2 || signals.dq().cols() != signals.size()) return std::nullopt;
  const Eigen::Index blocks = signals.blocks(), m = signals.samplesPerBlock;
  const std::vector<bool> known = everywhere(data);
  SegmentAnswer best;
  for (Eigen::Index j = 0; j < signals.dq().rows(); ++j) {
    const double still = kStillSpeed * signals.dq().row(j).cwiseAbs().maxCoeff(),
                 most = std::max(1e-9, signals.ddq().row(j).cwiseAbs().maxCoeff());
    MatrixXd motor(2, blocks);
    for (Eigen::Index n = 0; n < blocks; ++n) {
      motor(0, n) = signals.dq().row(j).segment(n * m, m).cwiseAbs().mean() > still ? 1.0 : 0.0;
      motor(1, n) = signals.ddq().row(j).segment(n * m, m).cwiseAbs().mean() / most;
    }
    const double left = leftByLaw(motor, data, known);
    if (left < best.left)
      best = {Correlate(heft::toSay("the motor of joint {:.0f}"), static_cast<double>(j + 1)), left, 0.0,
              left < 1.0 - kMajority};
  }
  return best.correlate.empty() ? std::nullopt : std::optional(best);
}

}  // namespace heft::diagnosis
