#include "core/motion/motion_noise.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "core/math/periodogram.h"
#include "core/math/statistics.h"
#include "core/motion/resample.h"

namespace heft {

namespace {

constexpr double kSlowestTold = 99.0;                    // [Hz]
constexpr Eigen::Index kFirstLine = 30, kLastLine = 45;  // A line each hertz
constexpr Eigen::Index kMostWindows = 3;                 // Of a second each, spread over the recording
constexpr int kTimesDifferenced = 3;                     // Slow motion must not leak into the lines

/// Adds white noise; false where it cannot be told how much.
bool addNoise(const UniformGrid& grid, const VectorXd& time, std::mt19937_64& random, MatrixXd& values) {
  if (values.rows() == 0) return true;
  const auto noise = whiteNoiseOf(grid, time, values);
  if (!noise) return false;
  // Evenly spread: only the variance counts.
  const double scale = 2.0 * std::numbers::sqrt3 * 0x1.0p-64;
  for (Eigen::Index c = 0; c < values.cols(); ++c)
    for (Eigen::Index i = 0; i < values.rows(); ++i)
      values(i, c) += (*noise)(c) * (scale * static_cast<double>(random()) - std::numbers::sqrt3);
  return true;
}

}  // namespace

std::optional<VectorXd> whiteNoiseOf(const UniformGrid& grid, const VectorXd& time,
                                     const Eigen::Ref<const MatrixXd>& values) {
  const double rateHz = grid.rateHz;
  const auto length = static_cast<Eigen::Index>(rateHz);
  const Eigen::Index span = length + kTimesDifferenced;
  if (rateHz < kSlowestTold || grid.size < span) return std::nullopt;
  std::vector<std::vector<double>> power(static_cast<std::size_t>(values.cols()));
  const Eigen::Index windows = std::min(kMostWindows, grid.size / span);
  for (Eigen::Index w = 0; w < windows; ++w) {
    const Eigen::Index from = windows > 1 ? w * (grid.size - span) / (windows - 1) : 0;
    Channels x = onGrid(grid, time, values, from, from + span);
    for (int d = 0; d < kTimesDifferenced; ++d) x = Channels(x.bottomRows(x.rows() - 1) - x.topRows(x.rows() - 1));
    const MatrixXd found = taperedPower(x.transpose(), kLastLine);
    for (Eigen::Index k = kFirstLine; k < kLastLine; ++k) {
      const double white =
          std::pow(2.0 * std::sin(std::numbers::pi * static_cast<double>(k + 1) / static_cast<double>(length)),
                   2 * kTimesDifferenced);
      for (Eigen::Index c = 0; c < values.cols(); ++c)
        power[static_cast<std::size_t>(c)].push_back(found(c, k) / white);
    }
  }
  VectorXd out(values.cols());
  // Half of what is spread as a square of two normal numbers is below ln 2 of its mean; knocks do not count.
  for (Eigen::Index c = 0; c < values.cols(); ++c)
    out(c) = std::sqrt(median(std::move(power[static_cast<std::size_t>(c)])) / std::numbers::ln2);
  return out;
}

std::optional<Recording> noisierMotion(const Recording& recording, std::uint64_t seed) {
  const UniformGrid grid = gridFor(recording.time);
  if (grid.size > 20 * recording.rows() + 1000) return std::nullopt;
  std::mt19937_64 random(seed);
  Recording out;
  out.file = recording.file;
  out.meta = recording.meta;
  out.time = recording.time;
  out.q = recording.q;
  out.dq = recording.dq;
  out.position = recording.position;
  out.quaternion = recording.quaternion;
  out.twist = recording.twist;
  for (MatrixXd* values : {&out.q, &out.dq})
    if (!addNoise(grid, recording.time, random, *values)) return std::nullopt;
  const auto add = [&](auto& values) {
    MatrixXd all = values;
    if (!addNoise(grid, recording.time, random, all)) return false;
    values = all;
    return true;
  };
  // The sign of a quaternion may leap.
  for (Eigen::Index i = 1; i < out.quaternion.rows(); ++i)
    if (out.quaternion.row(i).dot(out.quaternion.row(i - 1)) < 0.0) out.quaternion.row(i) *= -1.0;
  if (!add(out.quaternion) || !add(out.position) || !add(out.twist)) return std::nullopt;
  return out;
}

}  // namespace heft
