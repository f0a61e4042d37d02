// What strain gauges and their amplifiers make of a load.
#include <cmath>

#include "core/simulation/effects/kinds.h"

namespace heft {
namespace {

/// Amplifiers that are set wrongly.
class GainError final : public Effect {
 public:
  explicit GainError(const EffectSetup& setup) : gain_(Vector6d::Ones()) {
    const double error = 0.01 * setup.size;
    if (setup.form == "axis") {
      gain_(static_cast<Eigen::Index>(setup.random.uniform() * 6.0)) += error;
    } else if (setup.form == "forces") {
      gain_.head<3>().array() += error;
    } else {
      for (int c = 0; c < 6; ++c) gain_(c) += error * setup.random.normal();
    }
    note("gain", gain_);
  }
  Vector6d gauge(const Vector6d& load) override { return gain_.cwiseProduct(load); }

 private:
  Vector6d gain_;
};

/// One axis sees part of another's load.
class Crosstalk final : public Effect {
 public:
  explicit Crosstalk(const EffectSetup& setup) : mix_(Matrix6d::Zero()) {
    RandomStream& random = setup.random;
    const double share = 0.01 * setup.size;
    if (setup.form == "pair") {
      const auto to = static_cast<Eigen::Index>(random.uniform() * 6.0);
      const auto from = (to + 1 + static_cast<Eigen::Index>(random.uniform() * 5.0)) % 6;
      mix_(to, from) = (random.chance(0.5) ? share : -share) * scale(to) / scale(from);
    } else {
      for (Eigen::Index to = 0; to < 6; ++to)
        for (Eigen::Index from = 0; from < 6; ++from)
          if (to != from) mix_(to, from) = 0.5 * share * random.normal() * scale(to) / scale(from);
    }
    note("matrix_rows", Eigen::Map<const VectorXd>(Matrix6d(mix_.transpose()).data(), 36));
  }
  Vector6d gauge(const Vector6d& load) override { return load + mix_ * load; }

 private:
  /// A torque axis is full at about 8 cm times a force axis's range.
  static double scale(Eigen::Index channel) { return channel < 3 ? 1.0 : 0.08; }
  Matrix6d mix_;
};

/// The gauges remember: a part of the reading follows the load only after it has turned round by some way. Bristles in
/// the load instead of in the position (Dahl 1968, with the load as coordinate).
class Hysteresis final : public Effect {
 public:
  explicit Hysteresis(const EffectSetup& setup) : share_(0.01 * setup.size) {
    const double weight = setup.scene.payload.mass * std::max(1.0, setup.scene.gravity.norm());
    const double arm = std::max(kTorqueArm, setup.scene.payload.com.norm());
    const double turn = setup.random.uniform(0.3, 0.8);
    reach_ << Vector3d::Constant(turn * weight), Vector3d::Constant(turn * weight * arm);
    note("share", share_);
    note("turning_way", reach_);
  }
  Vector6d gauge(const Vector6d& load) override {
    if (!started_) last_ = load;
    started_ = true;
    for (int c = 0; c < 6; ++c) {
      const double way = load(c) - last_(c);
      const double end = way < 0.0 ? -reach_(c) : reach_(c);
      memory_(c) = end + (memory_(c) - end) * std::exp(-std::abs(way) / reach_(c));
    }
    last_ = load;
    return load + share_ * memory_;
  }

 private:
  double share_;
  Vector6d reach_, memory_ = Vector6d::Zero(), last_ = Vector6d::Zero();
  bool started_ = false;
};

}  // namespace

void addGaugeKinds(std::vector<EffectKind>& kinds) {
  kinds.push_back({"gain_error",
                   "%",
                   "wrong gain of one axis (or the spread over all)",
                   10.0,
                   100.0,
                   true,
                   {"axis", "forces", "each"},
                   making<GainError>()});
  kinds.push_back({"crosstalk",
                   "%",
                   "share of one axis's load that another sees",
                   6.0,
                   100.0,
                   false,
                   {"pair", "full"},
                   making<Crosstalk>()});
  kinds.push_back({"hysteresis",
                   "%",
                   "share of a load that the gauges remember",
                   5.0,
                   50.0,
                   false,
                   {"memory"},
                   making<Hysteresis>()});
}

}  // namespace heft
