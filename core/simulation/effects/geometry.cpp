// Where things are, against what the setup file says: a turned or displaced sensor, a tilted base, a joint's zero.
#include <charconv>
#include <cmath>
#include <numbers>

#include "core/math/degrees.h"
#include "core/simulation/effects/kinds.h"

namespace heft {
namespace {

/// The sensor is bolted on with a turn: it reports the same load in its own axes.
class SensorRotation final : public Effect {
 public:
  explicit SensorRotation(const EffectSetup& setup) {
    Vector3d axis = drawDirection(setup.random);
    if (setup.form == "about-z") axis = Vector3d::UnitZ();
    R_ = rotationFromVector(setup.size * kRadPerDegree * axis);
    note("axis_s", axis);
    note("angle_rad", setup.size * kRadPerDegree);
  }
  Vector6d gauge(const Vector6d& load) override {
    Vector6d turned;
    turned << R_.transpose() * load.head<3>(), R_.transpose() * load.tail<3>();
    return turned;
  }

 private:
  Matrix3d R_;
};

/// S is beside where it was measured to be; the payload's numbers hold for where it truly is.
class LeverArm final : public Effect {
 public:
  explicit LeverArm(const EffectSetup& setup) : offset_(1e-3 * setup.size * drawDirection(setup.random)) {
    note("offset_s_m", offset_);
  }
  void alterGeometry(Geometry& geometry) override { geometry.X_LS.translate(offset_); }

 private:
  Vector3d offset_;
};

/// The robot stands on a floor that is not level, or hangs otherwise than stated.
class GravityTilt final : public Effect {
 public:
  explicit GravityTilt(const EffectSetup& setup) {
    const Vector3d up = setup.scene.gravity.norm() > 1e-6 ? setup.scene.gravity.normalized() : Vector3d::UnitZ();
    Vector3d axis;
    do {
      axis = drawDirection(setup.random);
      axis -= axis.dot(up) * up;
    } while (axis.norm() < 0.1);
    axis.normalize();
    R_ = rotationFromVector(setup.size * kRadPerDegree * axis);
    note("axis_b", axis);
    note("angle_rad", setup.size * kRadPerDegree);
  }
  void alterGeometry(Geometry& geometry) override { geometry.gravity = R_ * geometry.gravity; }

 private:
  Matrix3d R_;
};

/// A joint's encoder counts from the wrong zero. The first joint turns about gravity and would show nothing.
class JointOffset final : public Effect {
 public:
  explicit JointOffset(const EffectSetup& setup) {
    const int dof = setup.scene.robot != nullptr ? setup.scene.robot->dof() : 0;
    offsets_ = VectorXd::Zero(dof);
    if (setup.form == "all") {
      for (int j = 0; j < dof; ++j) offsets_(j) = setup.size * kRadPerDegree * setup.random.uniform(-1.0, 1.0);
    } else if (dof > 0) {
      int joint = 0;
      if (setup.form == "one") {
        joint = dof > 1 ? 1 + static_cast<int>(setup.random.uniform() * (dof - 1)) : 0;
      } else {
        std::from_chars(setup.form.data(), setup.form.data() + setup.form.size(), joint);
        joint = std::min(joint, dof) - 1;
      }
      offsets_(joint) = setup.size * kRadPerDegree;
    }
    note("offset_rad", offsets_);
  }
  void log(Recording& recording) override {
    if (recording.hasJoints() && recording.q.cols() == offsets_.size()) recording.q.rowwise() += offsets_.transpose();
  }

 private:
  VectorXd offsets_;
};

}  // namespace

void addGeometryKinds(std::vector<EffectKind>& kinds) {
  kinds.push_back({"gravity_tilt",
                   "deg",
                   "tilt of the robot's base against the stated gravity",
                   2.0,
                   180.0,
                   true,
                   {"tilt"},
                   making<GravityTilt>()});
  kinds.push_back({"lever_arm",
                   "mm",
                   "sensor origin beside where the setup file has it",
                   20.0,
                   1000.0,
                   false,
                   {"offset"},
                   making<LeverArm>()});
  kinds.push_back({"joint_offset",
                   "deg",
                   "wrong zero of a joint's encoder",
                   2.0,
                   90.0,
                   true,
                   {"one", "2", "3", "4", "5", "6", "7", "all"},
                   making<JointOffset>()});
  kinds.push_back({"sensor_rotation",
                   "deg",
                   "sensor turned against what the setup file says",
                   2.0,
                   180.0,
                   true,
                   {"any-axis", "about-z"},
                   making<SensorRotation>()});
}

}  // namespace heft
