#include "core/diagnosis/model/hum.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/parallel.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/model/noise.h"
#include "core/math/periodogram.h"
#include "core/math/statistics.h"

namespace heft::diagnosis {

namespace {

constexpr double kLowestHz = 22.0, kOfRate = 0.45;
constexpr Eigen::Index kBeside = 10, kNear = 2;  ///< Lines, a hertz apart; noise reaches 3.5 times the power of these
constexpr std::size_t kMostSeconds = 16;         ///< Windows of a second

/// First rows of windows that lie in usable blocks, spread over the recording.
std::vector<Eigen::Index> windowsOf(const Recording& recording, const Signals& signals, Eigen::Index length) {
  const Eigen::Index n = recording.rows();
  std::vector<Eigen::Index> usableUpTo(static_cast<std::size_t>(n) + 1, 0);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double block = (recording.time(i) - signals.startTime) * signals.blockRate();
    const bool usable = block >= 0.0 && block < static_cast<double>(signals.blocks()) &&
                        signals.usable[static_cast<std::size_t>(block)] && recording.wrench.row(i).allFinite();
    usableUpTo[static_cast<std::size_t>(i) + 1] = usableUpTo[static_cast<std::size_t>(i)] + (usable ? 1 : 0);
  }
  std::vector<Eigen::Index> all;
  for (Eigen::Index from = 0; from + length <= n; from += length / 2)
    if (usableUpTo[static_cast<std::size_t>(from + length)] - usableUpTo[static_cast<std::size_t>(from)] == length)
      all.push_back(from);
  std::vector<Eigen::Index> out;
  const std::size_t step = std::max<std::size_t>(1, (all.size() + kMostSeconds - 1) / kMostSeconds);
  for (std::size_t i = 0; i < all.size(); i += step) out.push_back(all[i]);
  return out;
}

}  // namespace

std::optional<Hum> humIn(const Recording& recording, const Signals& signals) {
  const double rate = recording.rateHz();
  const auto length = static_cast<Eigen::Index>(std::lround(rate));
  const auto last = static_cast<Eigen::Index>(kOfRate * rate), first = static_cast<Eigen::Index>(kLowestHz);
  if (last < first + kBeside) return std::nullopt;
  const auto windows = windowsOf(recording, signals, length);
  if (windows.size() < kPattern) return std::nullopt;
  std::vector<MatrixXd> powers(windows.size());
  parallelFor(windows.size(), [&](std::size_t i) {
    powers[i] = taperedPower(recording.wrench.middleRows(windows[i], length).transpose(), last);
  });
  // The median over the windows: a knock is no line.
  MatrixXd power(6, last);
  std::vector<double> each(windows.size());
  for (Eigen::Index c = 0; c < 6; ++c)
    for (Eigen::Index k = 0; k < last; ++k) {
      for (std::size_t i = 0; i < windows.size(); ++i) each[i] = powers[i](c, k);
      power(c, k) = median(each);
    }
  std::optional<Hum> out;
  double most = kLoud;
  for (Eigen::Index k = first; k < last - 1; ++k) {
    Vector6d line;
    double stands = 0.0, share = 0.0;
    for (Eigen::Index c = 0; c < 6; ++c) {
      std::vector<double> beside;
      for (Eigen::Index j = std::max(first - 1, k - kBeside); j <= std::min(last - 1, k + kBeside); ++j)
        if (std::abs(j - k) > kNear) beside.push_back(power(c, j));
      const double floor = median(beside);
      line(c) = std::max(0.0, power.row(c).segment(k - 1, 3).sum() - 3.0 * floor);
      // What rings between knocks is broader than what turns, of which a taper leaves 0.1 two hertz to either side.
      const bool narrow = power(c, k - 2) + power(c, std::min(last - 1, k + 2)) < kMinorShare * power(c, k);
      if (!narrow || power(c, k) <= stands * floor) continue;
      stands = power(c, k) / std::max(floor, 1e-300);
      share = line(c) / power.row(c).tail(last - first + 1).sum();
    }
    if (stands <= most) continue;
    most = stands;
    // A wave of amplitude A has the power A^2 L / 4 in all lines of a taper together.
    const double scale = 4.0 / static_cast<double>(length);
    out = Hum{static_cast<double>(k + 1) * rate / static_cast<double>(length), std::sqrt(scale * line.head<3>().sum()),
              std::sqrt(scale * line.tail<3>().sum()), share, false};
  }
  if (out)
    out->mains = std::ranges::any_of(std::array{50.0, 60.0, 100.0, 120.0},
                                     [&](double f) { return std::abs(out->frequencyHz - f) < 1.5; });
  return out;
}

std::optional<double> pitchIn(const Signals& signals) {
  const auto length = static_cast<Eigen::Index>(std::lround(signals.rateHz)),
             last = static_cast<Eigen::Index>(kOfRate * signals.rateHz), first = static_cast<Eigen::Index>(kLowestHz);
  const Eigen::Index m = signals.samplesPerBlock;
  MatrixXd power = MatrixXd::Zero(6, std::max<Eigen::Index>(1, last));
  std::size_t windows = 0;
  for (const Stretch& s : stretchesOf(signals.usable))
    for (Eigen::Index from = s.from * m; from + length <= s.to * m; from += length / 2, ++windows)
      power += taperedPower(signals.readings.middleCols(from, length), last);
  std::optional<double> out;
  double most = kLoud;
  for (Eigen::Index k = first; windows >= kPattern && k < last; ++k)
    for (Eigen::Index c = 0; c < 6; ++c) {
      std::vector<double> beside;
      for (Eigen::Index j = std::max(first, k - kBeside); j <= std::min(last - 1, k + kBeside); ++j)
        if (std::abs(j - k) > kNear) beside.push_back(power(c, j));
      const double stands = power(c, k) / std::max(median(std::move(beside)), 1e-300);
      if (stands <= most) continue;
      most = stands;
      out = static_cast<double>(k + 1) * signals.rateHz / static_cast<double>(length);
    }
  return out;
}

}  // namespace heft::diagnosis
