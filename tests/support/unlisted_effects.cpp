#include "tests/support/unlisted_effects.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace heft::test {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;

Vector3d drawUnit(RandomStream& random) {
  const double z = random.uniform(-1.0, 1.0);
  const double angle = random.uniform(0.0, kTwoPi);
  const double r = std::sqrt(1.0 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

class Magnet final : public Effect {
 public:
  explicit Magnet(const EffectSetup& setup) : strength_(setup.size), point_(1.5 * setup.scene.payload.com) {
    // A hand's breadth off a place that the tool passes.
    if (!setup.scene.path.empty()) {
      const double share = setup.random.uniform(0.2, 0.8);
      const auto i = static_cast<std::size_t>(share * static_cast<double>(setup.scene.path.size() - 1));
      pole_ = setup.scene.path[i].X_BS * point_ + 0.08 * drawUnit(setup.random);
    }
    note("pole_b_m", pole_);
  }
  Vector6d force(const Instant& now, double) override {
    constexpr double kUsual = 0.1, kCore = 0.03;  // [m]: SIZE is the force at kUsual; the pole has a size
    const Vector3d way = pole_ - now.motion.X_BS * point_;
    const double distance = std::hypot(way.norm(), kCore);
    const Vector3d F_S =
        now.motion.X_BS.linear().transpose() * (strength_ * std::pow(kUsual / distance, 3.0) / distance * way);
    Vector6d wrench;
    wrench << -F_S, -point_.cross(F_S);
    return wrench;
  }

 private:
  double strength_;
  Vector3d point_, pole_ = Vector3d::Zero();
};

class TemperatureWave final : public Effect {
 public:
  explicit TemperatureWave(const EffectSetup& setup)
      : omega_(kTwoPi / setup.random.uniform(2.5, 5.0)), phase_(setup.random.uniform(0.0, kTwoPi)) {
    direction_.head<3>() = setup.size * drawUnit(setup.random);
    direction_.tail<3>() = 0.01 * setup.size * drawUnit(setup.random);
    note("period_s", kTwoPi / omega_);
  }
  void shiftZero(const VectorXd& time, SampledWrench& rows) override {
    for (Eigen::Index k = 0; k < time.size(); ++k)
      rows.row(k) += std::sin(omega_ * time(k) + phase_) * direction_.transpose();
  }

 private:
  double omega_, phase_;
  Vector6d direction_;
};

/// Torque about an axis of the tool that depends on a wrist joint's angle.
class JointTorque : public Effect {
 public:
  Vector6d force(const Instant& now, double) override {
    Vector6d wrench = Vector6d::Zero();
    if (now.q.size() == 0) return wrench;
    wrench.tail<3>() = size_ * level(now.q(std::min<Eigen::Index>(joint_, now.q.size() - 1))) * axis_;
    return wrench;
  }

 protected:
  explicit JointTorque(const EffectSetup& setup)
      : size_(setup.size), joint_(setup.random.chance(0.5) ? 4 : 5), axis_(drawUnit(setup.random)) {
    note("joint", static_cast<double>(joint_ + 1));
    note("axis_s", axis_);
  }
  virtual double level(double angle) = 0;

 private:
  double size_;
  Eigen::Index joint_;
  Vector3d axis_;
};

class BacklashTorque final : public JointTorque {
 public:
  explicit BacklashTorque(const EffectSetup& setup) : JointTorque(setup), gap_(setup.random.uniform(0.05, 0.15)) {}

 private:
  double level(double angle) override {
    if (!started_) middle_ = angle;
    started_ = true;
    middle_ = std::clamp(middle_, angle - gap_, angle + gap_);
    return (angle - middle_) / gap_;
  }
  double gap_;  ///< [rad]
  double middle_ = 0.0;
  bool started_ = false;
};

class AngleRipple final : public JointTorque {
 public:
  explicit AngleRipple(const EffectSetup& setup)
      : JointTorque(setup), teeth_(setup.random.uniform(9.0, 18.0)), phase_(setup.random.uniform(0.0, kTwoPi)) {}

 private:
  double level(double angle) override { return std::sin(teeth_ * angle + phase_); }
  double teeth_, phase_;
};

class SquaredLoad final : public Effect {
 public:
  explicit SquaredLoad(const EffectSetup& setup)
      : size_(setup.size),
        to_(static_cast<Eigen::Index>(3.0 * setup.random.uniform())),
        full_(std::max(1.0, 9.81 * setup.scene.payload.mass)) {}
  Vector6d gauge(const Vector6d& load) override {
    Vector6d out = load;
    out(to_) += size_ * load((to_ + 1) % 3) * load((to_ + 2) % 3) / (full_ * full_);
    return out;
  }

 private:
  double size_;
  Eigen::Index to_;
  double full_;
};

template <class T>
std::function<std::unique_ptr<Effect>(const EffectSetup&)> making() {
  return [](const EffectSetup& setup) { return std::make_unique<T>(setup); };
}

}  // namespace

const std::vector<UnlistedKind>& unlistedKinds() {
  static const std::vector<UnlistedKind> kinds{
      {"magnet", 1.0, {"constant_pull", "cable_pull", "contact"}, making<Magnet>()},
      {"temperature_wave", 0.5, {"bias_drift"}, making<TemperatureWave>()},
      {"backlash_torque", 0.05, {"coulomb_friction", "hysteresis"}, making<BacklashTorque>()},
      {"angle_ripple", 0.05, {"coulomb_friction", "cable_pull"}, making<AngleRipple>()},
      {"squared_load", 0.5, {"crosstalk", "gain_error", "hysteresis"}, making<SquaredLoad>()},
  };
  return kinds;
}

std::unique_ptr<Effect> makeUnlisted(const UnlistedKind& kind, double size, std::uint64_t seed,
                                     const EffectScene& scene) {
  RandomStream random(seed, RandomPurpose::effect, 1u << 20);
  auto effect = kind.make({scene, size, "", random});
  effect->truth().id = kind.id;
  effect->truth().size = size;
  return effect;
}

}  // namespace heft::test
