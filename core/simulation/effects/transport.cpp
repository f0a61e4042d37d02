// The way from the gauges to the log: filters, and packets that arrive late.
#include <algorithm>
#include <cmath>

#include "core/simulation/effects/kinds.h"

namespace heft {
namespace {

/// Exact answer of T y' + y = u to a signal that runs straight from sample to sample, from its settled state.
void onePole(double T, SampledWrench& series, double rateHz) {
  if (series.rows() == 0) return;
  const double h = 1.0 / rateHz, decay = std::exp(-h / T);
  Vector6d y = series.row(0).transpose(), before = y;
  for (Eigen::Index k = 1; k < series.rows(); ++k) {
    const Vector6d u = series.row(k).transpose();
    const Vector6d lag = (T / h) * (u - before);
    y = u - lag + decay * (y - before + lag);
    before = u;
    series.row(k) = y.transpose();
  }
}

/// Mean over the last `length` seconds of a signal that runs straight from sample to sample.
void runningMean(double length, SampledWrench& series, double rateHz) {
  const Eigen::Index n = series.rows();
  if (n == 0) return;
  const double span = length * rateHz;  // in samples
  SampledWrench integral(n, 6);
  integral.row(0).setZero();
  for (Eigen::Index k = 1; k < n; ++k)
    integral.row(k) = integral.row(k - 1) + 0.5 * (series.row(k - 1) + series.row(k));
  const SampledWrench original = series;
  for (Eigen::Index k = 0; k < n; ++k) {
    const double at = static_cast<double>(k) - span;
    if (span < 1.0) {
      // Within one step; the difference of two integrals would be all rounding.
      if (k > 0) series.row(k) += 0.5 * span * (original.row(k - 1) - original.row(k));
      continue;
    }
    Eigen::Matrix<double, 1, 6> start;
    if (at <= 0.0) {
      start = at * original.row(0);  // it stood still before
    } else {
      const auto i = static_cast<Eigen::Index>(at);
      const double u = at - static_cast<double>(i);
      const auto next = original.row(std::min(i + 1, n - 1));
      start = integral.row(i) + u * (original.row(i) + 0.5 * u * (next - original.row(i)));
    }
    series.row(k) = (integral.row(k) - start) / span;
  }
}

class LowPassLag final : public Effect {
 public:
  explicit LowPassLag(const EffectSetup& setup) : lag_(1e-3 * setup.size), form_(setup.form) { note("lag_s", lag_); }
  void filter(SampledWrench& series, double rateHz) override {
    if (form_ == "average") {
      runningMean(2.0 * lag_, series, rateHz);
    } else if (form_ == "second-order") {
      onePole(0.5 * lag_, series, rateHz);
      onePole(0.5 * lag_, series, rateHz);
    } else {
      onePole(lag_, series, rateHz);
    }
  }

 private:
  double lag_;
  std::string form_;
};

class TimeOffset final : public Effect {
 public:
  explicit TimeOffset(const EffectSetup& setup)
      : delay_(1e-3 * setup.size),
        form_(setup.form),
        random_(setup.random),
        from_(setup.scene.from),
        length_(std::max(1e-9, setup.scene.to - setup.scene.from)) {
    note("delay_s", delay_);
  }
  double age(double time) override {
    if (form_ == "creeping") return delay_ * 2.0 * (time - from_) / length_;  // two clocks that run apart
    if (form_ == "uneven") return delay_ * random_.uniform(0.5, 1.5);
    return delay_;
  }

 private:
  double delay_;
  std::string form_;
  RandomStream random_;
  double from_, length_;
};

}  // namespace

void addTransportKinds(std::vector<EffectKind>& kinds) {
  kinds.push_back({"low_pass_lag",
                   "ms",
                   "lag of a filter on the wrench",
                   15.0,
                   400.0,
                   false,
                   {"one-pole", "second-order", "average"},
                   making<LowPassLag>()});
  kinds.push_back({"time_offset",
                   "ms",
                   "delay of the wrench (negative: the motion is late)",
                   15.0,
                   400.0,
                   true,
                   {"constant", "creeping", "uneven"},
                   making<TimeOffset>()});
}

}  // namespace heft
