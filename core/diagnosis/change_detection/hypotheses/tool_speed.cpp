// What goes with how fast the tool moves or turns, one way or either way, everywhere or in a zone.
#include <algorithm>
#include <array>

#include "core/base/say.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/change_detection/hypotheses/law_of_motion.h"

namespace heft::diagnosis {

namespace {

/// Velocity and turning of each block, S axes.
Wrenches velocities(const Signals& signals) {
  const Eigen::Index blocks = signals.blocks(), m = signals.samplesPerBlock;
  Wrenches out = Wrenches::Zero(6, blocks);
  for (Eigen::Index k = 0; k < blocks * m; ++k) {
    out.col(k / m).head<3>() +=
        signals.R_BS[static_cast<std::size_t>(k)].transpose() * signals.velocity.col(k) / static_cast<double>(m);
    out.col(k / m).tail<3>() += signals.kinematics.omega.col(k) / static_cast<double>(m);
  }
  return out;
}

/// Whichever way, as what shakes or cools a sensor; bias and payload take the mean.
MatrixXd squareOf(const MatrixXd& velocity) {
  MatrixXd out = MatrixXd::Ones(2, velocity.cols());
  out.row(1) = velocity.colwise().squaredNorm();
  out.row(1) /= std::max(1e-12, out.row(1).maxCoeff());
  return out;
}

}  // namespace

std::optional<SegmentAnswer> toolSpeed(const SegmentData& data) {
  if (data.contacts.size() < 2) return std::nullopt;
  const std::vector<bool> all = everywhere(data), inside = inSegments(data);
  const Wrenches velocity = velocities(data.signals);
  SegmentAnswer best;
  const auto ask = [&](const char* correlate, const MatrixXd& motion, const std::vector<bool>& known, double explains) {
    const double left = leftByLaw(motion, data, known);
    const bool unlike = left <= 1.0 - explains;
    if (unlike > best.unlikeAPush || (unlike == best.unlikeAPush && left < best.left))
      best = {correlate, left, 0.0, unlike};
  };
  for (const auto& [correlate, part] : std::array<std::pair<const char*, MatrixXd>, 2>{
           {{heft::toSay("how fast the tool moves"), velocity.topRows<3>()},
            {heft::toSay("how fast the tool turns"), velocity.bottomRows<3>()}}}) {
    // Of pushes 0.2 at most went with a law that is told from elsewhere.
    ask(correlate, part, all, kThird);
    if (data.contacts.size() >= kPattern) ask(correlate, part, inside, kMajority);
    ask(correlate, squareOf(part), all, kMajority);
  }
  return best.correlate.empty() ? std::nullopt : std::optional(best);
}

}  // namespace heft::diagnosis
