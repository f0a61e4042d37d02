// One joint's angle is off by a constant.
#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/common.h"

namespace heft::diagnosis {
namespace {

class JointOffset final : public Cause {
 public:
  std::string_view id() const override { return "joint_offset"; }
  std::vector<std::string> lookAlikes() const override { return {"gravity_tilt", "sensor_rotation"}; }
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
    MatrixXd q = signals.q;
    q.row(form.choice[0]).array() += v(0);
    changeJoints(signals, kin, q, signals.dq, signals.ddq);
  }
};

}  // namespace

std::unique_ptr<Cause> makeJointOffset() { return std::make_unique<JointOffset>(); }

}  // namespace heft::diagnosis
