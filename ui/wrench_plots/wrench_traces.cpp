#include "ui/wrench_plots/wrench_traces.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

namespace heft {
namespace {

std::vector<double> toVector(const Eigen::Ref<const VectorXd>& values) {
  return {values.data(), values.data() + values.size()};
}

std::vector<double> counted(Eigen::Index n) {
  std::vector<double> values(static_cast<std::size_t>(n));
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<double>(i + 1);
  return values;
}

bool isPoses(const Recording& recording) { return recording.meta.kind == RecordingKind::poses; }

}  // namespace

std::vector<double> timesOf(const Recording& recording) {
  return isPoses(recording) ? counted(recording.rows()) : toVector(recording.time);
}

double longestJoined(const Recording& recording, const std::vector<double>& time) {
  if (isPoses(recording) || time.size() < 2) return std::numeric_limits<double>::infinity();
  std::vector<double> steps;
  const std::size_t every = std::max<std::size_t>(1, time.size() / 5000);
  for (std::size_t i = 1; i < time.size(); i += every) steps.push_back(time[i] - time[i - 1]);
  std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2), steps.end());
  return std::max(0.2, 20.0 * steps[steps.size() / 2]);
}

namespace {

/// Absolute differences of three channels inside the free parts, at most some thousands of them.
std::vector<double> freeDifferences(const WrenchSeries& series, const std::vector<Segment>& segments,
                                    int firstChannel) {
  std::vector<double> sizes;
  const Eigen::Index rows = series.simulated.rows();
  const Eigen::Index step = std::max<Eigen::Index>(1, rows / 4000);
  std::size_t segment = 0;
  for (Eigen::Index k = 0; k < rows; k += step) {
    const double t = series.time(k);
    while (segment < segments.size() && segments[segment].to < t) ++segment;
    const bool inside = segment < segments.size() && segments[segment].from <= t;
    if (!segments.empty() && !(inside && segments[segment].label == MarkLabel::free)) continue;
    for (int c = firstChannel; c < firstChannel + 3; ++c) {
      const double size = std::abs(series.measured(k, c) - series.simulated(k, c));
      if (std::isfinite(size)) sizes.push_back(size);
    }
  }
  return sizes;
}

}  // namespace

WrenchTraces::WrenchTraces(TraceData data)
    : measuredTime_(std::move(data.measuredTime)),
      simulatedTime_(std::move(data.simulatedTime)),
      limit_(data.differenceLimit),
      noise_(data.noise) {
  for (std::size_t c = 0; c < 6; ++c) {
    curves_[0][c] = MinMaxPyramid(std::exchange(data.measured[c], {}));
    curves_[1][c] = MinMaxPyramid(std::exchange(data.simulated[c], {}));
    curves_[2][c] = MinMaxPyramid(std::exchange(data.difference[c], {}));
  }
}

WrenchTraces::WrenchTraces(const Recording& recording, const EstimateReport* report) : poses_(isPoses(recording)) {
  const Eigen::Index rows = std::min(recording.rows(), recording.wrench.rows());
  measuredTime_ = poses_ ? counted(rows) : toVector(recording.time.head(rows));
  for (int c = 0; c < 6; ++c) curves_[0][c] = MinMaxPyramid(toVector(recording.wrench.col(c).head(rows)));
  gap_ = longestJoined(recording, measuredTime_);
  if (report == nullptr) return;

  const WrenchSeries& series = report->series;
  const Eigen::Index simulated = std::min({series.time.size(), series.simulated.rows(), series.measured.rows()});
  if (simulated == 0) return;
  simulatedTime_ = poses_ ? counted(simulated) : toVector(series.time.head(simulated));
  for (int c = 0; c < 6; ++c) {
    curves_[1][c] = MinMaxPyramid(toVector(series.simulated.col(c).head(simulated)));
    const VectorXd difference = series.measured.col(c).head(simulated) - series.simulated.col(c).head(simulated);
    curves_[2][c] = MinMaxPyramid(toVector(difference));
  }
  for (int lane = 0; lane < 2; ++lane) {
    noise_[lane] = 2.0 * report->noiseStd.segment<3>(Eigen::Index{3} * lane).maxCoeff();
    if (!std::isfinite(noise_[lane])) noise_[lane] = 0.0;
    std::vector<double> sizes = freeDifferences(series, report->segments, 3 * lane);
    if (sizes.empty()) sizes = freeDifferences(series, {}, 3 * lane);
    if (sizes.empty()) continue;
    const auto most = sizes.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(sizes.size() - 1));
    std::nth_element(sizes.begin(), most, sizes.end());
    limit_[lane] = std::max({1.6 * *most, 1.8 * noise_[lane], lane == 0 ? 1e-3 : 1e-5});
  }
}

ThinnedCurve WrenchTraces::thinned(Kind kind, int channel, double from, double to, int pixels) const {
  return heft::thinned(timeOf(kind), curves_[static_cast<int>(kind)][channel], gap_, from, to, pixels);
}

ThinnedCurve thinned(const std::vector<double>& time, const MinMaxPyramid& values, double gap, double from, double to,
                     int pixels) {
  ThinnedCurve curve;
  if (time.empty() || values.size() != time.size() || pixels < 1 || !(to > from)) return curve;
  auto first = std::lower_bound(time.begin(), time.end(), from);
  auto last = std::upper_bound(first, time.end(), to);
  if (first != time.begin()) --first;
  if (last != time.end()) ++last;
  const auto begin = static_cast<std::size_t>(first - time.begin());
  const auto end = static_cast<std::size_t>(last - time.begin());
  const auto add = [&curve](double x, const MinMax& extremes) {
    curve.x.push_back(x);
    curve.low.push_back(extremes.lowest);
    curve.high.push_back(extremes.highest);
  };
  constexpr MinMax kNothing{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  curve.crowded = end - begin > static_cast<std::size_t>(pixels);
  if (!curve.crowded) {
    for (std::size_t i = begin; i < end; ++i) {
      if (i > begin && time[i] - time[i - 1] > gap) add(0.5 * (time[i - 1] + time[i]), kNothing);
      add(time[i], {values[i], values[i]});
    }
    return curve;
  }
  const double step = curve.step = (to - from) / pixels;
  // Where a column holds many samples its border may be a few of them off, for blocks whose extremes are known already.
  const std::size_t usual = (end - begin) / static_cast<std::size_t>(pixels);
  const std::size_t block = usual >= 8 * MinMaxPyramid::kBase ? MinMaxPyramid::kBase : 1;
  std::size_t next = begin;
  for (int column = 0; column < pixels && next < end; ++column) {
    const double border = from + (column + 1) * step;
    const std::size_t start = next;
    std::size_t far = std::min(end, start + 2 * usual + 16);
    if (far < end && time[far] < border) far = end;
    next = static_cast<std::size_t>(std::lower_bound(time.begin() + static_cast<std::ptrdiff_t>(start),
                                                     time.begin() + static_cast<std::ptrdiff_t>(far), border) -
                                    time.begin());
    if (next < end) next = std::max(start, next / block * block);
    if (next == start) continue;
    // With the sample before, so that neighbouring columns touch as the line between them does.
    const bool apart = start > begin && time[start] - time[start - 1] > gap;
    if (apart) add(border - step, kNothing);
    const MinMax extremes = values.range(start > 0 && !apart ? start - 1 : start, next);
    if (std::isfinite(extremes.lowest)) add(border - 0.5 * step, extremes);
  }
  return curve;
}

MinMax WrenchTraces::visibleRange(int firstChannel, double from, double to) const {
  MinMax extremes{std::nan(""), std::nan("")};
  for (const Kind kind : {Kind::measured, Kind::simulated}) {
    const std::vector<double>& time = timeOf(kind);
    const auto begin = std::lower_bound(time.begin(), time.end(), from) - time.begin();
    const auto end = std::upper_bound(time.begin(), time.end(), to) - time.begin();
    for (int c = firstChannel; c < firstChannel + 3; ++c) {
      const MinMax other = curves_[static_cast<int>(kind)][c].range(begin, end);
      extremes.lowest = std::fmin(extremes.lowest, other.lowest);
      extremes.highest = std::fmax(extremes.highest, other.highest);
    }
  }
  return extremes;
}

double WrenchTraces::valueAt(Kind kind, int channel, double at) const {
  const std::vector<double>& time = timeOf(kind);
  const MinMaxPyramid& values = curves_[static_cast<int>(kind)][channel];
  if (time.empty() || values.size() != time.size() || !(at >= time.front()) || !(at <= time.back()))
    return std::nan("");
  const auto after = static_cast<std::size_t>(std::upper_bound(time.begin(), time.end(), at) - time.begin());
  const std::size_t before = after - 1;
  if (after == time.size() || time[before] == at) return values[before];
  const double share = (at - time[before]) / (time[after] - time[before]);
  return values[before] + share * (values[after] - values[before]);
}

std::vector<double> WrenchTraces::timesWithin(double from, double to) const {
  return {std::lower_bound(measuredTime_.begin(), measuredTime_.end(), from),
          std::upper_bound(measuredTime_.begin(), measuredTime_.end(), to)};
}

double WrenchTraces::differenceLimit(int firstChannel) const { return limit_[firstChannel / 3]; }
double WrenchTraces::noiseBand(int firstChannel) const { return noise_[firstChannel / 3]; }

}  // namespace heft
