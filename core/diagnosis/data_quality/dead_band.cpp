#include "core/diagnosis/data_quality/dead_band.h"

#include <algorithm>
#include <cmath>

#include "core/diagnosis/calibration.h"
#include "core/recording/frozen.h"

namespace heft::diagnosis {

namespace {

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
  const Eigen::Index rows = recording.rows();
  std::vector<DeadBand> out;
  for (Eigen::Index c = 0; c < 6; ++c) {
    const auto y = recording.wrench.col(c);
    std::ptrdiff_t repeats = 0;
    for (Eigen::Index i = 1; i < rows; ++i) repeats += y(i) == y(i - 1) ? 1 : 0;
    if (repeats < kFewestSamples) continue;
    std::vector<double> readings;
    for (Eigen::Index i = 0; i < rows; ++i)
      if (!recording.wrench.row(i).isZero(0.0)) readings.push_back(y(i));
    std::ranges::sort(readings);
    DeadBand band{c, commonest(readings), 0.0, 0.0, {}};
    const auto count = std::ranges::count(readings, band.reads);
    band.share = static_cast<double>(count) / static_cast<double>(rows);
    if (count < kFewestSamples || band.share < kHardlyAny) continue;
    // A gap to either side, and readings as close to one another as ever just beyond it.
    readings.erase(std::unique(readings.begin(), readings.end()), readings.end());
    const auto at = std::ranges::lower_bound(readings, band.reads);
    if (at == readings.begin() || at + 1 == readings.end()) continue;
    band.width = std::min(*at - *(at - 1), *(at + 1) - *at);
    const auto beyond = std::ranges::count_if(
        readings, [&](double r) { return r != band.reads && std::abs(r - band.reads) < 2.0 * band.width; });
    if (beyond < kFewestSamples) continue;
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

std::optional<FrozenChannel> frozenChannel(const Recording& recording, const std::vector<FlatTop>& tops,
                                           const Vector6d& steps) {
  std::optional<FrozenChannel> out;
  const std::vector<Changes> each = changesOfEach(recording.wrench);
  const Changes rows = ofAny(each);
  for (Eigen::Index c = 0; c < 6; ++c) {
    if (steps.segment<3>(c < 3 ? 0 : 3).maxCoeff() > 0.0) continue;
    for (const FrozenStretch& still : frozenStretches(recording.time, each[static_cast<std::size_t>(c)], kEvent)) {
      const double value = recording.wrench(still.from, c), from = recording.time(still.from),
                   to = recording.time(still.to - 1);
      const bool atEnd = std::ranges::any_of(
          tops, [&](const FlatTop& top) { return top.channel == static_cast<int>(c) && top.level == value; });
      // Rows that repeat as a whole were lost.
      if (value == 0.0 || atEnd || countIn(rows, still.from + 1, still.to) == 0) continue;
      if (!out || to - from > out->to - out->from) out = {c, from, to};
    }
  }
  return out;
}

}  // namespace heft::diagnosis
