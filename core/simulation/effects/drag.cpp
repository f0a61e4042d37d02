// What brakes the tool: a hose through water, a cable in its sheath.
#include <cmath>

#include "core/simulation/effects/kinds.h"

namespace heft {
namespace {

class ViscousDrag final : public Effect {
 public:
  explicit ViscousDrag(const EffectSetup& setup)
      : drag_(setup.size), form_(setup.form), point_(drawToolPoint(setup.random, setup.scene.payload, 0.04)) {
    note("point_s_m", point_);
    if (form_ == "turning") note("drag_nm_s_rad", kTurning * drag_);
    if (form_ == "quadratic") note("drag_n_s2_m2", drag_ / kUsualSpeed);
  }
  Vector6d force(const Instant& now, double) override {
    if (form_ == "turning") {
      Vector6d wrench = Vector6d::Zero();
      wrench.tail<3>() = kTurning * drag_ * now.state.omega;
      return wrench;
    }
    const Vector3d v = pointVelocity(now.motion, point_);
    const double factor = form_ == "quadratic" ? v.norm() / kUsualSpeed : 1.0;
    return against(now, -drag_ * factor * v, point_);
  }

 private:
  static constexpr double kTurning = 0.02;    ///< [m2]
  static constexpr double kUsualSpeed = 0.3;  ///< [m/s]
  double drag_;
  std::string form_;
  Vector3d point_;
};

/// Dry friction of a cable that slides in a guide fixed to the base.
class CoulombFriction final : public Effect {
 public:
  explicit CoulombFriction(const EffectSetup& setup)
      : level_(setup.size), form_(setup.form), point_(drawToolPoint(setup.random, setup.scene.payload, 0.04)) {
    note("point_s_m", point_);
    reach_ = setup.random.uniform(0.004, 0.02);
    if (form_ == "dahl") note("presliding_m", reach_);
  }
  Vector6d force(const Instant& now, double step) override {
    const Vector3d v = pointVelocity(now.motion, point_);
    const double speed = v.norm();
    if (form_ == "dahl") {
      // Bristles of length `reach_` bend before they slip: z' = v - |v| z / reach (Dahl 1968), exact for a constant v.
      if (speed > 0.0) {
        const Vector3d end = reach_ / speed * v;
        bend_ = end + (bend_ - end) * std::exp(-speed * step / reach_);
      }
      return against(now, -level_ / reach_ * bend_, point_);
    }
    double level = level_;
    if (form_ == "stribeck") level *= 1.0 + 0.6 * std::exp(-speed * speed / (0.05 * 0.05));
    // Below 2 mm/s the direction of motion is the hand's tremor: friction hands over smoothly, as a real guide does.
    constexpr double kCreep = 0.002;
    return against(now, -level / std::hypot(speed, kCreep) * v, point_);
  }

 private:
  double level_, reach_ = 0.01;
  std::string form_;
  Vector3d point_, bend_ = Vector3d::Zero();
};

}  // namespace

void addDragKinds(std::vector<EffectKind>& kinds) {
  kinds.push_back({"viscous_drag",
                   "N s/m",
                   "force against the tool's velocity",
                   1.0,
                   1000.0,
                   false,
                   {"linear", "quadratic", "turning"},
                   making<ViscousDrag>()});
  kinds.push_back({"coulomb_friction",
                   "N",
                   "dry friction against the tool's direction of motion",
                   0.3,
                   100.0,
                   false,
                   {"dry", "dahl", "stribeck"},
                   making<CoulombFriction>()});
}

}  // namespace heft
