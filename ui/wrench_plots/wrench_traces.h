#pragma once
// What the plots draw: measured, simulated and difference of six channels, ready to be thinned to the pixels there are.
#include <QVector>
#include <array>
#include <limits>
#include <vector>

#include "core/estimation/estimate.h"
#include "core/recording/recording.h"
#include "ui/wrench_plots/min_max_pyramid.h"

namespace heft {

/// One curve thinned for a screen. Crowded: one entry a pixel, the extremes of what falls into it. Otherwise every
/// sample, low = high. An entry without a number (NaN) stands where nothing was measured.
struct ThinnedCurve {
  QVector<double> x, low, high;
  bool crowded = false;
  double step = 0.0;  ///< Width of an entry where they are crowded, in the unit of x
};

/// What `pixels` columns over [from, to] show of `values` at rising `time`; two samples further apart than `gap` [s]
/// are not joined. Where there are fewer samples than columns every sample in the segment, and one neighbour on each
/// side.
ThinnedCurve thinned(const std::vector<double>& time, const MinMaxPyramid& values, double gap, double from, double to,
                     int pixels);

/// When the rows were recorded [s]; standing poses are counted 1, 2, 3.
std::vector<double> timesOf(const Recording& recording);
/// Samples further apart than this [s] are not joined by a line: twenty may be lost before it shows. Poses always are.
double longestJoined(const Recording& recording, const std::vector<double>& time);

/// Curves that are already there. A kind may be empty; within one all channels are as long as its time.
struct TraceData {
  std::vector<double> measuredTime, simulatedTime;  ///< [s], not falling
  std::array<std::vector<double>, 6> measured, simulated, difference;
  std::array<double, 2> differenceLimit{1.0, 0.1}, noise{0.0, 0.0};  ///< Of force [N] and torque [N m]
};

class WrenchTraces {
 public:
  /// Nothing to draw.
  WrenchTraces() = default;
  explicit WrenchTraces(TraceData data);
  /// `report` may be null: then there is no simulated wrench and no difference. Standing poses are counted 1, 2, 3.
  WrenchTraces(const Recording& recording, const EstimateReport* report);

  enum class Kind { measured, simulated, difference };
  static constexpr int kKinds = 3;

  bool empty() const { return measuredTime_.empty(); }
  bool hasSimulated() const { return !simulatedTime_.empty(); }
  bool poses() const { return poses_; }
  double firstTime() const { return measuredTime_.empty() ? 0.0 : measuredTime_.front(); }
  double lastTime() const { return measuredTime_.empty() ? 1.0 : measuredTime_.back(); }

  /// Of a channel, see above.
  ThinnedCurve thinned(Kind kind, int channel, double from, double to, int pixels) const;

  /// Extremes over the three channels beginning at `firstChannel` (0 force, 3 torque) within [from, to], over measured
  /// and simulated.
  MinMax visibleRange(int firstChannel, double from, double to) const;

  /// Linear between the samples; NaN outside them, and where there is nothing of that kind.
  double valueAt(Kind kind, int channel, double time) const;
  /// Times of the measured samples within [from, to].
  std::vector<double> timesWithin(double from, double to) const;

  /// Symmetric limit of a difference lane: 99 % of the free parts fit, and the noise band does.
  double differenceLimit(int firstChannel) const;
  /// Half height of the noise band [N] or [N m]: two standard deviations of the loudest channel; 0 if unknown.
  double noiseBand(int firstChannel) const;

 private:
  const std::vector<double>& timeOf(Kind kind) const { return kind == Kind::measured ? measuredTime_ : simulatedTime_; }

  bool poses_ = false;
  double gap_ = std::numeric_limits<double>::infinity();  ///< [s] Longer without a sample is not joined by a line.
  std::vector<double> measuredTime_, simulatedTime_;
  std::array<std::array<MinMaxPyramid, 6>, kKinds> curves_;
  std::array<double, 2> limit_{1.0, 0.1}, noise_{0.0, 0.0};
};

}  // namespace heft
