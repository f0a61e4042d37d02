// What a controller reports as velocity: late, smoothed, scaled or noisy; or a whole motion smoothed before it was
// written.
#include <algorithm>
#include <cmath>

#include "core/simulation/effects/kinds.h"

namespace heft {
namespace {

/// One column of reported velocities at a time; uniform rows.
template <class Change>
void eachVelocity(Recording& recording, const Change& change) {
  for (Eigen::Index c = 0; c < recording.dq.cols() && recording.dq.rows() > 1; ++c) {
    VectorXd column = recording.dq.col(c);
    change(column);
    recording.dq.col(c) = column;
  }
  for (Eigen::Index c = 0; c < 6 && recording.twist.rows() > 1; ++c) {
    VectorXd column = recording.twist.col(c);
    change(column);
    recording.twist.col(c) = column;
  }
}

/// Value of a column at a fractional row, straight between rows, constant beyond the ends.
double valueAt(const VectorXd& column, double row) {
  const double at = std::clamp(row, 0.0, static_cast<double>(column.size() - 1));
  const auto i = std::min(static_cast<Eigen::Index>(at), column.size() - 2);
  return column(i) + (at - static_cast<double>(i)) * (column(i + 1) - column(i));
}

/// The mean of `column` over rows [k - back, k + ahead].
VectorXd averaged(const VectorXd& column, Eigen::Index back, Eigen::Index ahead) {
  const Eigen::Index n = column.size();
  VectorXd sum(n + 1);
  sum(0) = 0.0;
  for (Eigen::Index k = 0; k < n; ++k) sum(k + 1) = sum(k) + column(k);
  VectorXd out(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const Eigen::Index from = std::max<Eigen::Index>(0, k - back), to = std::min(n - 1, k + ahead);
    out(k) = (sum(to + 1) - sum(from)) / static_cast<double>(to + 1 - from);
  }
  return out;
}

class MotionLag final : public Effect {
 public:
  explicit MotionLag(const EffectSetup& setup) : lag_(1e-3 * setup.size), form_(setup.form) { note("lag_s", lag_); }
  void log(Recording& recording) override {
    const double rate = recording.rateHz();
    eachVelocity(recording, [&](VectorXd& column) {
      if (form_ == "late") {
        const VectorXd original = column;
        for (Eigen::Index k = 0; k < column.size(); ++k)
          column(k) = valueAt(original, static_cast<double>(k) - lag_ * rate);
      } else if (form_ == "average") {
        column = averaged(column, static_cast<Eigen::Index>(std::llround(2.0 * lag_ * rate)), 0);
      } else {
        const double share = 1.0 - std::exp(-1.0 / (lag_ * rate));
        double y = column(0);
        for (Eigen::Index k = 0; k < column.size(); ++k) column(k) = y += share * (column(k) - y);
      }
    });
  }

 private:
  double lag_;
  std::string form_;
};

class DerivativeNoise final : public Effect {
 public:
  explicit DerivativeNoise(const EffectSetup& setup)
      : share_(0.01 * setup.size), form_(setup.form), random_(setup.random) {
    note("share", share_);
  }
  void log(Recording& recording) override {
    const double rate = recording.rateHz();
    if (form_ == "recorded") {
      // Twice a mean over 2 half + 1 rows: (width w)^2 / 2 is lost at the angular frequency w; stated for 5 Hz.
      constexpr double kStatedAt = 2.0 * 3.14159265358979 * 5.0;  // [rad/s]
      const auto half = static_cast<Eigen::Index>(std::llround(0.5 * rate * std::sqrt(12.0 * share_) / kStatedAt));
      note("width_s", std::sqrt(static_cast<double>(2 * half * (half + 1)) / 3.0) / rate);
      const auto smooth = [&](auto& columns) {
        for (Eigen::Index c = 0; c < columns.cols() && columns.rows() > 0; ++c)
          columns.col(c) = averaged(averaged(columns.col(c), half, half), half, half);
      };
      smooth(recording.q);
      smooth(recording.dq);
      smooth(recording.position);
      smooth(recording.twist);
      for (Eigen::Index k = 1; k < recording.quaternion.rows(); ++k)
        if (recording.quaternion.row(k).dot(recording.quaternion.row(k - 1)) < 0.0) recording.quaternion.row(k) *= -1.0;
      smooth(recording.quaternion);
      recording.quaternion.rowwise().normalize();
      return;
    }
    eachVelocity(recording, [&](VectorXd& column) {
      if (form_ == "noisy") {
        const double size = share_ * std::sqrt(column.squaredNorm() / static_cast<double>(column.size()));
        for (double& x : column) x += size * random_.normal();
      } else if (form_ == "smoothed") {
        // Symmetric, so not late: (W w)^2 / 24 is lost at the angular frequency w; stated for 1.5 Hz.
        constexpr double kStatedAt = 2.0 * 3.14159265358979 * 1.5;  // [rad/s]
        const auto half = static_cast<Eigen::Index>(std::llround(0.5 * rate * std::sqrt(24.0 * share_) / kStatedAt));
        column = averaged(column, half, half);
      } else {
        column *= 1.0 - share_;
      }
    });
  }

 private:
  double share_;
  std::string form_;
  RandomStream random_;
};

}  // namespace

void addVelocityKinds(std::vector<EffectKind>& kinds) {
  kinds.push_back({"motion_lag",
                   "ms",
                   "lag of the reported joint velocities",
                   30.0,
                   400.0,
                   false,
                   {"filter", "average", "late"},
                   making<MotionLag>()});
  kinds.push_back({"derivative_noise",
                   "%",
                   "reported joint velocities too small, or their noise; or the recorded motion smoothed",
                   20.0,
                   90.0,
                   false,
                   {"scaled", "smoothed", "noisy", "recorded"},
                   making<DerivativeNoise>()});
}

}  // namespace heft
