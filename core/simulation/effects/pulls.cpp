// What pulls at the tool: a hung weight, a hose, a cable.
#include <algorithm>
#include <cmath>

#include "core/simulation/effects/kinds.h"

namespace heft {
namespace {

/// A steady force of the world at one point of the tool, as of a balancer with a long cord.
class ConstantPull final : public Effect {
 public:
  explicit ConstantPull(const EffectSetup& setup)
      : force_(setup.size * drawSideways(setup.random, setup.scene.gravity)),
        point_(drawToolPoint(setup.random, setup.scene.payload, 0.06)) {
    note("force_b_n", force_);
    note("point_s_m", point_);
  }
  Vector6d force(const Instant& now, double) override { return against(now, force_, point_); }

 private:
  Vector3d force_, point_;
};

/// Some way off the tool's usual place.
Vector3d drawAnchor(const EffectSetup& setup) {
  const double distance = setup.random.uniform(0.3, 0.8);
  return middleOf(setup.scene) + distance * drawDirection(setup.random);
}

/// A spring from an anchor in the base to a point of the tool.
class CablePull final : public Effect {
 public:
  explicit CablePull(const EffectSetup& setup)
      : anchor_(drawAnchor(setup)),
        point_(drawToolPoint(setup.random, setup.scene.payload, 0.06)),
        stiffness_(setup.size * Matrix3d::Identity()) {
    note("anchor_b_m", anchor_);
    note("point_s_m", point_);
    RandomStream& random = setup.random;
    if (setup.form == "anisotropic") {
      // A hose is stiff along one direction and soft across it.
      const Matrix3d Q = rotationFromVector(3.0 * drawDirection(random));
      const Vector3d share{1.0, random.uniform(0.2, 0.6), random.uniform(0.05, 0.3)};
      stiffness_ = setup.size * Q * share.asDiagonal() * Q.transpose();
      note("stiffness_b_n_m", Eigen::Map<const VectorXd>(stiffness_.data(), 9));
    } else if (setup.form == "slack") {
      // A rope that hangs for part of the way.
      std::vector<double> distances;
      for (const auto& pose : setup.scene.path) distances.push_back((anchor_ - pose.X_BS * point_).norm());
      std::sort(distances.begin(), distances.end());
      const double quantile = random.uniform(0.2, 0.5);
      if (!distances.empty())
        slackLength_ = distances[static_cast<std::size_t>(quantile * static_cast<double>(distances.size() - 1))];
      note("free_length_m", slackLength_);
    } else if (setup.form == "torsion") {
      torsion_ = 0.03 * setup.size;
      stiffness_.setZero();
      if (!setup.scene.path.empty()) restPose_ = setup.scene.path[setup.scene.path.size() / 2].X_BS.linear();
      note("torsion_nm_rad", torsion_);
    }
  }

  Vector6d force(const Instant& now, double) override {
    if (torsion_ != 0.0) {
      const Matrix3d R = now.motion.X_BS.linear();
      Vector6d wrench = Vector6d::Zero();
      wrench.tail<3>() = torsion_ * (R.transpose() * vectorFromRotation(R * restPose_.transpose()));
      return wrench;
    }
    const Vector3d way = anchor_ - pointPosition(now.motion, point_);
    if (slackLength_ > 0.0) {
      const double length = way.norm();
      if (length <= slackLength_) return Vector6d::Zero();
      return against(now, stiffness_ * (way * (1.0 - slackLength_ / length)), point_);
    }
    return against(now, stiffness_ * way, point_);
  }

 private:
  Vector3d anchor_, point_;
  Matrix3d stiffness_;
  double slackLength_ = 0.0, torsion_ = 0.0;
  Matrix3d restPose_ = Matrix3d::Identity();
};

}  // namespace

void addPullKinds(std::vector<EffectKind>& kinds) {
  kinds.push_back({"constant_pull",
                   "N",
                   "steady force of the world on the tool",
                   0.5,
                   100.0,
                   false,
                   {"fixed"},
                   making<ConstantPull>()});
  kinds.push_back({"cable_pull",
                   "N/m",
                   "stiffness of a spring from an anchor in the base to the tool",
                   3.0,
                   1000.0,
                   false,
                   {"linear", "anisotropic", "slack", "torsion"},
                   making<CablePull>()});
}

}  // namespace heft
