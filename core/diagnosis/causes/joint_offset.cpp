// One joint's angle is off by a constant.
#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/common.h"

namespace heft::diagnosis {
namespace {

class JointOffset final : public Cause {
 public:
  std::string_view id() const override { return "joint_offset"; }
  Words words() const override {
    return {"Joint angle off",
            "Check the calibration of that joint, or the robot description used for this recording.",
            "Visit poses in which the other joints stand very differently, elbow high and low.",
            {"gravity_tilt", "sensor_rotation"}};
  }
  std::string sentence(const Form& form, const VectorXd& v, const VectorXd& std) const override {
    return fmt::format("Joint {} is really {} degrees from what was recorded.", form.choice[0] + 1,
                       plusMinus(v(0) * kDegrees, std(0) * kDegrees));
  }
  std::vector<Form> forms(const Signals& signals) const override {
    std::vector<Form> out;
    for (int joint = 0; signals.robot != nullptr && joint < signals.q.rows(); ++joint) {
      out.push_back(formOf(this, fmt::format("joint {}", joint + 1),
                           {{fmt::format("q{}_offset", joint + 1), "deg", kDegrees, 1.0 / kDegrees, -0.6, 0.6}}));
      out.back().choice = {joint};
    }
    return out;
  }
  bool bendsGeometry() const override { return true; }
  void geometry(const Form& form, const VectorXd& v, const Signals& signals, Kinematics& kin) const override {
    if (v(0) == 0.0) return;
    const Kinematics moved = withJointOffset(signals, form.choice[0], v(0));
    kin.specificForce += moved.specificForce - signals.kinematics.specificForce;
    kin.omega += moved.omega - signals.kinematics.omega;
    kin.alpha += moved.alpha - signals.kinematics.alpha;
  }
};

}  // namespace

std::unique_ptr<Cause> makeJointOffset() { return std::make_unique<JointOffset>(); }

}  // namespace heft::diagnosis
