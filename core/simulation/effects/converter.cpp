// What the converter does to a signal that is too large or too fine for it.
#include <algorithm>
#include <cmath>

#include "core/simulation/effects/kinds.h"

namespace heft {
namespace {

/// The axis that is used most clips at the level that cuts SIZE per cent of its samples.
class Saturation final : public Effect {
 public:
  explicit Saturation(const EffectSetup& setup)
      : share_(0.01 * setup.size),
        soft_(setup.form == "soft"),
        axis_(static_cast<Eigen::Index>(setup.random.uniform() * 6.0)) {}
  void convert(SampledWrench& rows) override {
    const auto n = rows.rows();
    const auto cut = static_cast<Eigen::Index>(share_ * static_cast<double>(n));
    if (cut == 0) return;
    std::vector<double> sizes(static_cast<std::size_t>(n));
    for (Eigen::Index k = 0; k < n; ++k) sizes[static_cast<std::size_t>(k)] = std::abs(rows(k, axis_));
    const auto at = sizes.end() - std::min(cut, n);
    std::nth_element(sizes.begin(), at, sizes.end());
    const double level = *at;
    for (Eigen::Index k = 0; k < n; ++k) {
      double& x = rows(k, axis_);
      const double beyond = std::abs(x) - level;
      if (beyond <= 0.0) continue;
      // Soft: an amplifier that gives a fifth of what comes on top.
      x = std::copysign(level + (soft_ ? 0.2 * beyond : 0.0), x);
    }
    truth().parameters.clear();
    note("axis", static_cast<double>(axis_));
    note("level", level);
  }
  /// What gives way in its range is not the sensor that was meant, whose range the model's name tells.
  void log(Recording& recording) override {
    if (soft_) recording.meta.sensorModel.clear();
  }

 private:
  double share_;
  bool soft_;
  Eigen::Index axis_;
};

class Quantisation final : public Effect {
 public:
  explicit Quantisation(const EffectSetup& setup) {
    // Whole multiples of the sensor's own steps, so that rounding to those afterwards changes nothing.
    const auto multiple = [](double step, double own) {
      return own > 0.0 ? own * std::max(1.0, std::nearbyint(step / own)) : step;
    };
    for (int c = 0; c < 3; ++c) {
      steps_(c) = multiple(setup.size, setup.scene.sensor.forceResolution(c));
      steps_(c + 3) = multiple(kTorqueArm * setup.size, setup.scene.sensor.torqueResolution(c));
    }
    note("step_n_nm", steps_);
  }
  void convert(SampledWrench& rows) override {
    for (int c = 0; c < 6; ++c)
      for (Eigen::Index k = 0; k < rows.rows(); ++k) rows(k, c) = std::nearbyint(rows(k, c) / steps_(c)) * steps_(c);
  }

 private:
  Vector6d steps_;
};

}  // namespace

void addConverterKinds(std::vector<EffectKind>& kinds) {
  kinds.push_back({"saturation",
                   "%",
                   "samples of one axis beyond the level at which it clips",
                   4.0,
                   60.0,
                   false,
                   {"hard", "soft"},
                   making<Saturation>()});
  kinds.push_back({"quantisation",
                   "N",
                   "steps of the force (torque: 2 cm times that)",
                   0.5,
                   100.0,
                   false,
                   {"steps"},
                   making<Quantisation>()});
}

}  // namespace heft
