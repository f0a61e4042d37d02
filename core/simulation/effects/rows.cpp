// What goes wrong with single rows: slow polling, lost packets, spikes, uneven time stamps.
#include <algorithm>
#include <cmath>

#include "core/simulation/effects/kinds.h"

namespace heft {
namespace {

/// The logger is faster than the sensor and writes the last reading again.
class Repeats final : public Effect {
 public:
  explicit Repeats(const EffectSetup& setup)
      : share_(0.01 * setup.size), polling_(setup.form == "polling"), random_(setup.random) {
    note("share", share_);
  }
  void log(Recording& recording) override {
    double phase = random_.uniform();
    for (Eigen::Index k = 1; k < recording.wrench.rows(); ++k) {
      bool fresh = !random_.chance(share_);
      if (polling_) {
        phase += 1.0 - share_;
        fresh = phase >= 1.0;
        if (fresh) phase -= 1.0;
      }
      if (!fresh) recording.wrench.row(k) = recording.wrench.row(k - 1);
    }
  }

 private:
  double share_;
  bool polling_;
  RandomStream random_;
};

/// Packets get lost, a few in a row.
class Dropouts final : public Effect {
 public:
  explicit Dropouts(const EffectSetup& setup) : share_(0.01 * setup.size), form_(setup.form), random_(setup.random) {
    note("share", share_);
  }
  void log(Recording& recording) override {
    constexpr double kStay = 0.8;  // five rows on average
    const Eigen::Index n = recording.rows();
    bool lost = false;
    std::vector<Eigen::Index> kept{0};
    for (Eigen::Index k = 1; k < n; ++k) {
      lost = random_.chance(lost ? kStay : share_ * (1.0 - kStay) / std::max(1e-9, 1.0 - share_));
      if (!lost || k == n - 1) {
        kept.push_back(k);
      } else if (form_ == "zeros") {
        recording.wrench.row(k).setZero();
      } else if (form_ == "held") {
        recording.wrench.row(k) = recording.wrench.row(k - 1);
      }
    }
    if (form_ == "missing") keep(recording, kept);
  }

 private:
  static void keep(Recording& recording, const std::vector<Eigen::Index>& rows) {
    const auto pick = [&rows](auto& series) {
      if (series.rows() == 0) return;
      auto all = series;
      series.resize(static_cast<Eigen::Index>(rows.size()), all.cols());
      for (std::size_t i = 0; i < rows.size(); ++i) series.row(static_cast<Eigen::Index>(i)) = all.row(rows[i]);
    };
    pick(recording.time);
    pick(recording.q);
    pick(recording.dq);
    pick(recording.position);
    pick(recording.quaternion);
    pick(recording.twist);
    pick(recording.accelerometer);
    pick(recording.gyroscope);
    pick(recording.wrench);
    const auto pickFrom = [&rows](auto& list) {
      if (list.empty()) return;
      auto all = std::move(list);
      list.clear();
      for (const Eigen::Index row : rows) list.push_back(all[static_cast<std::size_t>(row)]);
    };
    pickFrom(recording.labels);
    for (ExtraColumn& column : recording.extra) pickFrom(column.cells);
  }
  double share_;
  std::string form_;
  RandomStream random_;
};

class Spikes final : public Effect {
 public:
  explicit Spikes(const EffectSetup& setup)
      : share_(0.01 * setup.size), all_(setup.form == "all-axes"), random_(setup.random) {
    note("share", share_);
  }
  void log(Recording& recording) override {
    for (Eigen::Index k = 0; k < recording.wrench.rows(); ++k) {
      if (!random_.chance(share_)) continue;
      const auto one = static_cast<Eigen::Index>(random_.uniform() * 6.0);
      for (Eigen::Index c = 0; c < 6; ++c) {
        if (!all_ && c != one) continue;
        const double size = random_.uniform(3.0, 20.0) * (c < 3 ? 1.0 : kTorqueArm);
        recording.wrench(k, c) += random_.chance(0.5) ? size : -size;
      }
    }
  }

 private:
  double share_;
  bool all_;
  RandomStream random_;
};

/// The log's time stamps are those of a busy computer: late by up to SIZE, never out of order.
class Jitter final : public Effect {
 public:
  explicit Jitter(const EffectSetup& setup) : late_(1e-3 * setup.size), random_(setup.random) { note("late_s", late_); }
  void log(Recording& recording) override {
    VectorXd& time = recording.time;
    if (time.size() < 2) return;
    const double least = 0.02 / recording.rateHz();
    for (Eigen::Index k = 0; k < time.size(); ++k) {
      time(k) += late_ * random_.uniform();
      if (k > 0) time(k) = std::max(time(k), time(k - 1) + least);
    }
  }

 private:
  double late_;
  RandomStream random_;
};

}  // namespace

void addRowKinds(std::vector<EffectKind>& kinds) {
  kinds.push_back(
      {"spikes", "%", "rows with a spike of 3 to 20 N", 0.5, 20.0, false, {"one-axis", "all-axes"}, making<Spikes>()});
  kinds.push_back({"dropouts",
                   "%",
                   "rows whose wrench packet is lost, five in a row",
                   5.0,
                   60.0,
                   false,
                   {"held", "zeros", "missing"},
                   making<Dropouts>()});
  kinds.push_back({"repeats",
                   "%",
                   "rows that repeat the last wrench",
                   30.0,
                   90.0,
                   false,
                   {"polling", "random"},
                   making<Repeats>()});
  kinds.push_back(
      {"jitter", "ms", "how late the time stamps are at most", 0.8, 100.0, false, {"late-stamps"}, making<Jitter>()});
}

}  // namespace heft
