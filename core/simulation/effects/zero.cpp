// The sensor's zero point and how it wanders.
#include <cmath>
#include <numbers>

#include "core/simulation/effects/kinds.h"

namespace heft {
namespace {

/// The zero moves by up to SIZE [N] along a direction in the six channels.
class ZeroShift : public Effect {
 public:
  void shiftZero(const VectorXd& time, SampledWrench& rows) override {
    for (Eigen::Index k = 0; k < time.size(); ++k) rows.row(k) += course(time(k)) * direction_.transpose();
  }

 protected:
  explicit ZeroShift(const EffectSetup& setup) : from_(setup.scene.from), to_(setup.scene.to) {
    direction_.head<3>() = setup.size * drawDirection(setup.random);
    const double torque = setup.size * kTorqueArm * setup.random.uniform(0.3, 1.0);
    direction_.tail<3>() = torque * drawDirection(setup.random);
    note("shift_n_nm", direction_);
  }
  virtual double course(double time) const = 0;
  double from_, to_;

 private:
  Vector6d direction_;
};

class SensorBias final : public ZeroShift {
 public:
  explicit SensorBias(const EffectSetup& setup) : ZeroShift(setup) {}

 private:
  double course(double) const override { return 1.0; }
};

class BiasDrift final : public ZeroShift {
 public:
  explicit BiasDrift(const EffectSetup& setup) : ZeroShift(setup), form_(setup.form) {
    RandomStream& random = setup.random;
    const double length = to_ - from_;
    if (form_ == "warm-up") {
      tau_ = length * random.uniform(0.15, 0.5);
      note("warm_up_s", tau_);
    } else if (form_ == "jump") {
      tau_ = from_ + length * random.uniform(0.3, 0.7);
      truth().when = {{tau_, to_}};
    } else if (form_ == "walk") {
      // A random walk that ends about SIZE away; one step each 10 ms.
      for (double t = 0.0; t <= length; t += kWalkStep)
        walk_.push_back((walk_.empty() ? 0.0 : walk_.back()) + std::sqrt(kWalkStep / length) * random.normal());
    }
  }

 private:
  static constexpr double kWalkStep = 0.01;  // [s]
  double course(double time) const override {
    const double t = time - from_, u = t / (to_ - from_);
    if (form_ == "warm-up") return (1.0 - std::exp(-t / tau_)) / (1.0 - std::exp(-(to_ - from_) / tau_));
    if (form_ == "curved") return u * u * (3.0 - 2.0 * u) + 0.6 * u * (1.0 - u);
    if (form_ == "jump") return time < tau_ ? 0.0 : 1.0;
    if (form_ == "walk") {
      const double at = std::min(std::max(t / kWalkStep, 0.0), static_cast<double>(walk_.size() - 1));
      const auto i = static_cast<std::size_t>(at);
      const double next = walk_[std::min(i + 1, walk_.size() - 1)];
      return walk_[i] + (at - static_cast<double>(i)) * (next - walk_[i]);
    }
    return u;
  }
  std::string form_;
  double tau_ = 1.0;  ///< [s]
  std::vector<double> walk_;
};

}  // namespace

void addZeroKinds(std::vector<EffectKind>& kinds) {
  kinds.push_back({"sensor_bias",
                   "N",
                   "offset of the zero, added to the sensor's own",
                   2.0,
                   1000.0,
                   false,
                   {"constant"},
                   making<SensorBias>()});
  kinds.push_back({"bias_drift",
                   "N",
                   "how far the zero moves from the start to the end",
                   0.5,
                   1000.0,
                   false,
                   {"linear", "warm-up", "curved", "jump", "walk"},
                   making<BiasDrift>()});
}

}  // namespace heft
