#include "core/diagnosis/dead_band.h"

#include <algorithm>
#include <cmath>

#include "core/math/statistics.h"

namespace heft::diagnosis {

namespace {

constexpr std::ptrdiff_t kFewest = 10;  ///< Equal readings; readings just beyond the band; different ones among these

/// The value that comes most often, of readings in order.
double commonest(const std::vector<double>& ordered) {
  double out = 0.0;
  std::ptrdiff_t most = 0;
  for (auto from = ordered.begin(); from != ordered.end();) {
    const auto to = std::upper_bound(from, ordered.end(), *from);
    if (to - from > most) {
      most = to - from;
      out = *from;
    }
    from = to;
  }
  return out;
}

}  // namespace

std::vector<DeadBand> deadBands(const Recording& recording) {
  constexpr double kLeastShare = 0.005;
  const Eigen::Index rows = recording.rows();
  std::vector<DeadBand> out;
  for (Eigen::Index c = 0; c < 6; ++c) {
    const auto y = recording.wrench.col(c);
    std::ptrdiff_t repeats = 0;
    for (Eigen::Index i = 1; i < rows; ++i) repeats += y(i) == y(i - 1) ? 1 : 0;
    if (repeats < kFewest) continue;
    std::vector<double> readings;
    for (Eigen::Index i = 0; i < rows; ++i)
      if (!recording.wrench.row(i).isZero(0.0)) readings.push_back(y(i));
    std::ranges::sort(readings);
    DeadBand band{c, commonest(readings), 0.0, 0.0, {}};
    const auto count = std::ranges::count(readings, band.reads);
    band.share = static_cast<double>(count) / static_cast<double>(rows);
    if (count < kFewest || band.share < kLeastShare) continue;
    // A gap to either side, and readings as close to one another as ever just beyond it.
    readings.erase(std::ranges::unique(readings).begin(), readings.end());
    const auto at = std::ranges::lower_bound(readings, band.reads);
    if (at == readings.begin() || at + 1 == readings.end()) continue;
    band.width = std::min(*at - *(at - 1), *(at + 1) - *at);
    const auto beyond = std::ranges::count_if(
        readings, [&](double r) { return r != band.reads && std::abs(r - band.reads) < 2.0 * band.width; });
    if (beyond < kFewest) continue;
    for (Eigen::Index i = 0; i < rows; ++i) {
      if (y(i) != band.reads) continue;
      if (band.runs.empty() || band.runs.back().second < i) band.runs.emplace_back(i, i);
      band.runs.back().second = i + 1;
    }
    out.push_back(std::move(band));
  }
  return out;
}

Eigen::Matrix<double, Eigen::Dynamic, 6> withoutZeros(const Recording& recording, const std::vector<DeadBand>& bands) {
  Eigen::Matrix<double, Eigen::Dynamic, 6> out = recording.wrench;
  straightOver(zeroRuns(recording), recording.time, out);
  for (const DeadBand& band : bands) straightOver(band.runs, recording.time, out.col(band.channel));
  return out;
}

std::optional<Eigen::Index> stuckChannel(const Recording& recording) {
  constexpr double kHardlyElse = 0.9;
  for (Eigen::Index c = 0; c < 6; ++c) {
    const VectorXd y = recording.wrench.col(c);
    const double middle = median({y.begin(), y.end()});
    if (static_cast<double>((y.array() == middle).count()) > kHardlyElse * static_cast<double>(y.size())) return c;
  }
  return std::nullopt;
}

std::optional<FrozenChannel> frozenChannel(const Recording& recording, const std::vector<FlatTop>& tops) {
  constexpr double kShortest = 0.3, kLonger = 20.0;  // [s]; times the usual
  std::optional<FrozenChannel> out;
  const Eigen::Index n = recording.rows();
  for (Eigen::Index c = 0; c < 6; ++c) {
    const auto y = recording.wrench.col(c);
    Eigen::Index runs = 0, longest = 0, first = 0;
    for (Eigen::Index from = 0, i = 1; i <= n; ++i) {
      if (i < n && y(i) == y(from)) continue;
      ++runs;
      const bool known = y(from) == 0.0 || std::ranges::any_of(tops, [&](const FlatTop& top) {
                           return top.channel == static_cast<int>(c) && top.level == y(from);
                         });
      // Rows that repeat as a whole were lost.
      bool alone = false;
      for (Eigen::Index k = from + 1; k < i && !alone; ++k)
        alone = recording.wrench.row(k) != recording.wrench.row(k - 1);
      if (!known && alone && i - from > longest) {
        longest = i - from;
        first = from;
      }
      from = i;
    }
    if (longest < 2 || recording.time(first + longest - 1) - recording.time(first) < kShortest) continue;
    const double usual = static_cast<double>(n - longest) / std::max(1.0, static_cast<double>(runs - 1));
    const double lasts = recording.time(first + longest - 1) - recording.time(first);
    if (static_cast<double>(longest) < kLonger * usual || (out && out->to - out->from > lasts)) continue;
    out = {c, recording.time(first), recording.time(first) + lasts};
  }
  return out;
}

}  // namespace heft::diagnosis
