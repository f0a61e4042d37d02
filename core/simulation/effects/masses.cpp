// Masses that are not where a rigid payload has them: loose parts, a soft mount, a part picked up on the way.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/simulation/effects/kinds.h"
#include "core/simulation/trajectory.h"

namespace heft {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;

/// A point mass that is part of the payload, on a damped spring about its seat in the tool. The recording differs from
/// the rigid payload's by what the moving mass needs more than the seated one.
class SprungMass : public Effect {
 public:
  Vector6d force(const Instant& now, double step) override {
    if (!started_) {
      // At rest the spring already carries the mass.
      x_ = limited(-pull(now.state, seat_) / (omega_ * omega_));
      started_ = true;
    } else {
      advance(now.state, step);
    }
    before_ = now.state;
    if (rigid_) return Vector6d::Zero();
    const Vector3d relative = acceleration(now.state, x_, v_);
    const Vector3d& w = now.state.omega;
    const Vector3d moving = mass_ * (pull(now.state, seat_ + x_) + 2.0 * w.cross(v_) + relative);
    const Vector3d seated = mass_ * pull(now.state, seat_);
    Vector6d wrench;
    wrench << moving - seated, (seat_ + x_).cross(moving) - seat_.cross(seated);
    return wrench;
  }

 protected:
  SprungMass(double mass, const Vector3d& seat, double hz, double damping)
      : mass_(mass), seat_(seat), omega_(kTwoPi * hz), damping_(damping) {}

  double mass_;  ///< [kg]
  Vector3d seat_, rail_ = Vector3d::Zero();
  double omega_, damping_;
  double gap_ = 0.0;  ///< Where the part hits a stop [m]; 0: none

 private:
  /// Acceleration minus gravity of a point fixed in S: what a mass there needs per kilogram [N/kg].
  static Vector3d pull(const WrenchState& now, const Vector3d& r) {
    return now.specificForce + now.alpha.cross(r) + now.omega.cross(now.omega.cross(r));
  }
  Vector3d limited(const Vector3d& v) const { return rail_.isZero() ? v : Vector3d(rail_ * rail_.dot(v)); }
  /// x'' = -2 z w x' - w^2 x - pull - Coriolis, along the rail where there is one.
  Vector3d acceleration(const WrenchState& now, const Vector3d& x, const Vector3d& v) const {
    Vector3d a = -2.0 * damping_ * omega_ * v - omega_ * omega_ * x - pull(now, seat_ + x) - 2.0 * now.omega.cross(v);
    const double travel = x.norm();
    if (gap_ > 0.0 && travel > gap_) {
      // A stop thirty times as stiff as the spring.
      a -= 900.0 * omega_ * omega_ * (1.0 - gap_ / travel) * x + 10.0 * omega_ * v;
    }
    return limited(a);
  }
  /// Classic Runge-Kutta with the motion taken as linear in time between two instants; a stiff spring gets shorter
  /// steps. One of several kilohertz moves nothing that a sensor could show.
  void advance(const WrenchState& now, double step) {
    const double count = std::ceil(omega_ * step / (gap_ > 0.0 ? 0.02 : 0.5));
    rigid_ = count > 50.0;
    if (rigid_) return;
    const double h = step / count;
    for (double i = 0.0; i < count; i += 1.0) {
      const WrenchState from = between(now, i / count), half = between(now, (i + 0.5) / count),
                        to = between(now, (i + 1.0) / count);
      const Vector3d v1 = v_, a1 = acceleration(from, x_, v1);
      const Vector3d v2 = v_ + 0.5 * h * a1, a2 = acceleration(half, x_ + 0.5 * h * v1, v2);
      const Vector3d v3 = v_ + 0.5 * h * a2, a3 = acceleration(half, x_ + 0.5 * h * v2, v3);
      const Vector3d v4 = v_ + h * a3, a4 = acceleration(to, x_ + h * v3, v4);
      x_ += h / 6.0 * (v1 + 2.0 * v2 + 2.0 * v3 + v4);
      v_ += h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
    }
  }
  WrenchState between(const WrenchState& now, double u) const {
    return {before_.specificForce + u * (now.specificForce - before_.specificForce),
            before_.omega + u * (now.omega - before_.omega), before_.alpha + u * (now.alpha - before_.alpha)};
  }

  bool rigid_ = false;
  bool started_ = false;
  WrenchState before_;
  Vector3d x_ = Vector3d::Zero(), v_ = Vector3d::Zero();
};

class LooseMass final : public SprungMass {
 public:
  explicit LooseMass(const EffectSetup& setup)
      : SprungMass{1e-3 * setup.size, drawToolPoint(setup.random, setup.scene.payload, 0.05),
                   setup.random.uniform(1.0, 4.0), setup.random.uniform(0.02, 0.12)} {  // braces: draws in this order
    if (setup.form == "rail") rail_ = drawDirection(setup.random);
    if (setup.form == "rattling") {
      // Static sag at 3 Hz is 28 mm; the part then rests against its stop and lets go when thrown.
      omega_ = kTwoPi * setup.random.uniform(2.5, 4.0);
      gap_ = setup.random.uniform(0.005, 0.015);
      damping_ = 0.1;
    }
    note("seat_s_m", seat_);
    note("frequency_hz", omega_ / kTwoPi);
    note("damping_ratio", damping_);
    if (!rail_.isZero()) note("rail_s", rail_);
    if (gap_ > 0.0) note("gap_m", gap_);
  }
};

/// The sensor sits on a soft plate: everything beyond it swings against the robot's flange.
class FlexibleMount final : public SprungMass {
 public:
  explicit FlexibleMount(const EffectSetup& setup)
      : SprungMass(setup.scene.payload.mass, setup.scene.payload.com, std::sqrt(9.81 / (1e-3 * setup.size)) / kTwoPi,
                   setup.random.uniform(0.01, 0.06)) {
    if (setup.form == "one-way") rail_ = drawDirection(setup.random);
    note("frequency_hz", omega_ / kTwoPi);
    note("damping_ratio", damping_);
    if (!rail_.isZero()) note("direction_s", rail_);
  }
};

/// A part that is taken up or lost on the way.
class PayloadChange final : public Effect {
 public:
  explicit PayloadChange(const EffectSetup& setup) {
    const EffectScene& scene = setup.scene;
    part_.mass = 1e-3 * setup.size;
    part_.com = drawToolPoint(setup.random, scene.payload, 0.07);
    constexpr double kRadius = 0.02;
    part_.inertiaCom = 0.4 * part_.mass * kRadius * kRadius * Matrix3d::Identity();
    const double length = scene.to - scene.from;
    from_ = scene.from + length * setup.random.uniform(0.3, 0.7);
    duration_ = setup.form == "ramp" ? 0.1 : setup.form == "slow" ? std::min(2.0, 0.15 * length) : 0.0;
    if (setup.form == "pour") {
      from_ = scene.from + 0.25 * length;
      duration_ = 0.5 * length;
    }
    note("mass_kg", part_.mass);
    note("com_s_m", part_.com);
    truth().when = {{from_, from_ + duration_}};
  }
  Vector6d force(const Instant& now, double) override {
    if (now.time < from_) return Vector6d::Zero();
    const double level = duration_ > 0.0 ? minimumJerk((now.time - from_) / duration_).value : 1.0;
    return level * predictWrench(part_, now.state);
  }

 private:
  Payload part_;
  double from_ = 0.0, duration_ = 0.0;
};

}  // namespace

void addMassKinds(std::vector<EffectKind>& kinds) {
  kinds.push_back({"loose_mass",
                   "g",
                   "part of the payload that hangs on a spring of 1 to 4 Hz",
                   60.0,
                   5000.0,
                   false,
                   {"sprung", "rail", "rattling"},
                   making<LooseMass>()});
  kinds.push_back({"flexible_mount",
                   "mm",
                   "how far the tool sags on its mount under its own weight (0.25: 32 Hz)",
                   0.5,
                   20.0,
                   false,
                   {"all-ways", "one-way"},
                   making<FlexibleMount>()});
  kinds.push_back({"payload_change",
                   "g",
                   "part picked up on the way (negative: lost)",
                   60.0,
                   10000.0,
                   true,
                   {"step", "ramp", "slow", "pour"},
                   making<PayloadChange>()});
}

}  // namespace heft
