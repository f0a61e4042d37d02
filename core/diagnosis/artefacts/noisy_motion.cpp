#include "core/diagnosis/artefacts/noisy_motion.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/diagnosis/calibration.h"
#include "core/diagnosis/model/linearisation.h"
#include "core/math/statistics.h"

namespace heft::diagnosis {

namespace {

WrenchRms leftOver(const SmoothingCandidate& candidate) {
  const auto stretches = stretchesOf(candidate.signals.usable);
  return rmsOf(stretches, fitModel(candidate.signals, stretches, Model{}).residual);
}

/// Standard deviation of what changes within `apart` rows of the noisiest column and is no motion: third differences.
template <class CachedJacobian>
double noiseWithin(Eigen::Index apart, const CachedJacobian& columns) {
  const double third = std::sqrt(1.0 + 9.0 + 9.0 + 1.0);
  double out = 0.0;
  const Eigen::Index n = columns.rows() - 3 * apart;
  for (Eigen::Index c = 0; c < columns.cols() && n > 0; ++c) {
    std::vector<double> differences(static_cast<std::size_t>(n));
    for (Eigen::Index i = 0; i < n; ++i)
      differences[static_cast<std::size_t>(i)] = std::abs(columns(i + 3 * apart, c) - 3.0 * columns(i + 2 * apart, c) +
                                                          3.0 * columns(i + apart, c) - columns(i, c));
    out = std::max(out, 1.4826 * median(std::move(differences)) / third);
  }
  return out;
}

/// Of the angles [rad], or of the pose: position [m] and orientation [rad], whichever is greater.
double noiseOfMotion(const Recording& recording) {
  // Coarse steps change little from row to row, and a hand little within this time.
  const auto apart = std::max<Eigen::Index>(1, std::lround(kShortestGap * recording.rateHz()));
  if (recording.q.rows() > 0) return noiseWithin(apart, recording.q);
  return std::max(noiseWithin(apart, recording.position), 2.0 * noiseWithin(apart, recording.quaternion));
}

}  // namespace

std::optional<NoisyMotion> noisyMotion(const Recording& recording, const SmoothingCandidate& usual,
                                       const SmoothingCandidate& smoothed, double evidence) {
  // Of 260 recordings, whatever was wrong with them, noise became 2.4 times smaller at most, and 1.75 times where a
  // robot reports its angles late and unevenly; noisy angles began at 2.7. So did, now and then, motion with the noise
  // that a robot's has, 1e-4 at most and up to 1.5e-4 where poses were worked out from it, under a quiet sensor; where
  // somebody had made it noisy, it had 3e-4 or more.
  const auto judged = static_cast<double>(std::ranges::count(usual.signals.usable, true));
  if (evidence < 12.0 * judged * std::log(kLoudPower)) return {};
  NoisyMotion out{leftOver(usual), leftOver(smoothed), smoothed.cutoffHz, noiseOfMotion(recording) > kFineMotion};
  if (out.usual.force < kLoudPower * out.smoothed.force) return {};
  return out;
}

}  // namespace heft::diagnosis
