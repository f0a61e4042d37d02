#include "ui/wrench_plots/live_history.h"

#include <algorithm>
#include <cmath>

namespace heft {

void ThinnedSeries::include(Stretch& stretch, const Stretch& other) const {
  stretch.to = other.to;
  for (std::size_t c = 0; c < static_cast<std::size_t>(channels_); ++c) {
    stretch.low[c] = std::min(stretch.low[c], other.low[c]);
    stretch.high[c] = std::max(stretch.high[c], other.high[c]);
  }
}

void ThinnedSeries::add(double time, const double* values) {
  Stretch now{time, time, {}, {}};
  for (std::size_t c = 0; c < static_cast<std::size_t>(channels_); ++c)
    now.low[c] = now.high[c] = static_cast<float>(values[c]);
  if (!fine_.empty() && time - fine_.back().from < fineStep_) {
    include(fine_.back(), now);
    return;
  }
  fine_.push_back(now);
  age();
}

void ThinnedSeries::age() {
  while (fine_.back().to - fine_.front().from > kFineSeconds) {
    const Stretch& oldest = fine_.front();
    if (!coarse_.empty() && oldest.to - coarse_.back().from < coarseStep_) {
      include(coarse_.back(), oldest);
    } else {
      coarse_.push_back(oldest);
    }
    fine_.pop_front();
  }
  if (coarse_.size() <= kMostCoarse) return;
  std::deque<Stretch> halved;
  for (std::size_t i = 0; i < coarse_.size(); ++i) {
    if (i % 2 == 0) {
      halved.push_back(coarse_[i]);
    } else {
      include(halved.back(), coarse_[i]);
    }
  }
  coarse_ = std::move(halved);
  coarseStep_ *= 2.0;
}

std::size_t ThinnedSeries::points(std::vector<double>& time, const std::vector<std::vector<double>*>& values) const {
  const std::size_t count = 2 * stretches();
  time.reserve(count);
  for (auto* channel : values) channel->reserve(count);
  for (const auto* part : {&coarse_, &fine_}) {
    for (const Stretch& stretch : *part) {
      time.push_back(stretch.from);
      time.push_back(stretch.to);
      for (std::size_t c = 0; c < values.size(); ++c) {
        values[c]->push_back(stretch.low[c]);
        values[c]->push_back(stretch.high[c]);
      }
    }
  }
  return count;
}

void LiveHistory::addSimulated(double time, const Vector6d& simulated, const Vector6d& difference) {
  double values[12];
  std::copy(simulated.data(), simulated.data() + 6, values);
  std::copy(difference.data(), difference.data() + 6, values + 6);
  simulated_.add(time, values);
}

std::shared_ptr<const WrenchTraces> LiveHistory::traces() const {
  TraceData data;
  std::vector<std::vector<double>*> measured, simulated;
  for (auto& channel : data.measured) measured.push_back(&channel);
  for (auto& channel : data.simulated) simulated.push_back(&channel);
  for (auto& channel : data.difference) simulated.push_back(&channel);
  measured_.points(data.measuredTime, measured);
  simulated_.points(data.simulatedTime, simulated);
  data.noise = noise_;
  for (std::size_t lane = 0; lane < 2; ++lane) {
    std::vector<double> sizes;
    for (std::size_t c = 3 * lane; c < 3 * lane + 3; ++c)
      for (const double x : data.difference[c]) sizes.push_back(std::abs(x));
    if (sizes.empty()) continue;
    // Contact takes a small share of a demonstration: what most of it needs decides the scale.
    const auto most = sizes.begin() + static_cast<std::ptrdiff_t>(0.85 * static_cast<double>(sizes.size() - 1));
    std::nth_element(sizes.begin(), most, sizes.end());
    data.differenceLimit[lane] = std::max({2.0 * *most, 1.8 * noise_[lane], lane == 0 ? 0.1 : 0.005});
  }
  return std::make_shared<const WrenchTraces>(std::move(data));
}

}  // namespace heft
