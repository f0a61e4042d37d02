#pragma once
// Curves that grow while data comes in, in bounded memory: the newest minute finely, what is older as extremes over
// segments that double whenever they become too many. Free of Qt widgets; not safe for several threads at once.
#include <deque>
#include <memory>

#include "core/math/rigid.h"
#include "ui/wrench_plots/wrench_traces.h"

namespace heft {

/// Lowest and highest of some channels over segments of time.
class ThinnedSeries {
 public:
  static constexpr double kFineSeconds = 60.0;
  static constexpr std::size_t kMostCoarse = 2048;

  ThinnedSeries(int channels, double fineStep) : channels_(channels), fineStep_(fineStep) {}
  /// `values` has as many entries as there are channels; times rise.
  void add(double time, const double* values);
  /// Appends two points a segment; returns how many there are.
  std::size_t points(std::vector<double>& time, const std::vector<std::vector<double>*>& values) const;
  std::size_t stretches() const { return coarse_.size() + fine_.size(); }

 private:
  struct Stretch {
    double from, to;
    std::array<float, 12> low, high;
  };
  void include(Stretch& stretch, const Stretch& other) const;
  void age();

  int channels_;
  double fineStep_;
  double coarseStep_ = 0.2;
  std::deque<Stretch> fine_, coarse_;
};

class LiveHistory {
 public:
  void addMeasured(double time, const Vector6d& wrench) { measured_.add(time, wrench.data()); }
  /// Also what is missing between both; at the times of the simulation, which lag behind.
  void addSimulated(double time, const Vector6d& simulated, const Vector6d& difference);
  /// Two standard deviations of the loudest force and torque channel; 0 if unknown.
  void setNoise(double force, double torque) { noise_ = {force, torque}; }
  std::shared_ptr<const WrenchTraces> traces() const;
  /// Bounded, whatever came: for the test of that.
  std::size_t stretches() const { return measured_.stretches() + simulated_.stretches(); }

 private:
  ThinnedSeries measured_{6, 0.01}, simulated_{12, 0.02};
  std::array<double, 2> noise_{0.0, 0.0};
};

}  // namespace heft
