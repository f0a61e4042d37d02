#include "core/diagnosis/data_quality/coarse_readings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "core/base/stop.h"
#include "core/diagnosis/calibration.h"
#include "core/math/statistics.h"
#include "core/recording/frozen.h"
#include "core/recording/steps.h"

namespace heft::diagnosis {

namespace {

bool sameRow(const Recording& recording, Eigen::Index i) {
  return (recording.wrench.row(i).array() == recording.wrench.row(i - 1).array()).all();
}

/// Variance of readings about straight lines through a twentieth of a second each, at the middle of all.
double scatterOf(const Eigen::Ref<const VectorXd>& readings, double rateHz) {
  const auto length = std::max<Eigen::Index>(4, std::lround(0.05 * rateHz));
  const VectorXd t = VectorXd::LinSpaced(length, -1.0, 1.0);
  std::vector<double> out;
  for (Eigen::Index from = 0; from + length <= readings.size(); from += length) {
    const VectorXd part = readings.segment(from, length).array() - readings.segment(from, length).mean();
    const double slope = t.dot(part) / t.squaredNorm();
    out.push_back((part - slope * t).squaredNorm() / static_cast<double>(length - 2));
  }
  return out.empty() ? 0.0 : median(out);
}

/// By what a channel's own readings say; zero where they are fine.
double ownStep(const Recording& recording, Eigen::Index channel) {
  const auto y = recording.wrench.col(channel);
  Eigen::Index fresh = 0, still = 0;
  for (Eigen::Index i = 1; i < recording.rows(); ++i) {
    if (sameRow(recording, i)) continue;
    ++fresh;
    still += y(i) == y(i - 1) ? 1 : 0;
  }
  if (static_cast<double>(still) < kMajority * static_cast<double>(fresh)) return 0.0;
  const auto step = stepOf({y.begin(), y.end()});
  return step && *step * *step / 12.0 > kMinorShare * scatterOf(y, recording.rateHz()) ? *step : 0.0;
}

}  // namespace

CoarseReadings coarseReadings(const Recording& recording) {
  CoarseReadings out{Vector6d::Zero(), silentChannels(recording.wrench)};
  Vector6d& steps = out.steps;
  for (Eigen::Index c = 0; c < 6; ++c) steps(c) = ownStep(recording, c);
  const std::array<double, 2> coarsest{steps.head<3>().maxCoeff(), steps.tail<3>().maxCoeff()};
  for (Eigen::Index c = 0; c < 6; ++c) {
    stopPoint();
    const double step = coarsest[static_cast<std::size_t>(c / 3)];
    if (steps(c) > 0.0 || step <= 0.0 || !out.silent[static_cast<std::size_t>(c)]) continue;
    const auto y = recording.wrench.col(c);
    const double farthest = (y.array() - median({y.begin(), y.end()})).abs().maxCoeff();
    if (farthest < (1.0 + kSmallShare) * step) steps(c) = step;  // The file's digits make it a little more
  }
  return out;
}

std::optional<Eigen::Index> stuckChannel(const CoarseReadings& coarse) {
  for (Eigen::Index c = 0; c < 6; ++c)
    if (coarse.steps(c) <= 0.0 && coarse.silent[static_cast<std::size_t>(c)]) return c;
  return std::nullopt;
}

void spreadWithinSteps(const Recording& recording, const CoarseReadings& coarse,
                       Eigen::Ref<Eigen::Matrix<double, Eigen::Dynamic, 6>> wrench) {
  for (Eigen::Index c = 0; c < 6; ++c) {
    const double step = coarse.steps(c);
    if (step <= 0.0 || !coarse.silent[static_cast<std::size_t>(c)]) continue;
    std::mt19937_64 random(static_cast<std::uint64_t>(c));
    const auto anywhere = [&] { return step * (static_cast<double>(random() >> 11) * 0x1.0p-53 - 0.5); };
    double from = anywhere(), to = anywhere(), start = recording.time(0);
    for (Eigen::Index i = 0; i < recording.rows(); ++i) {
      if (recording.time(i) - start > kMoment) {
        from = std::exchange(to, anywhere());
        start = recording.time(i);
      }
      wrench(i, c) += from + (to - from) * (recording.time(i) - start) / kMoment;
    }
  }
}

}  // namespace heft::diagnosis
