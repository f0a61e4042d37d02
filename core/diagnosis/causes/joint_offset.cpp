// One joint's angle is off by a constant, or once to and fro in a turn, as where a ring sits off its axis.
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
    for (int joint = 0; signals.robot != nullptr && joint < signals.q.rows(); ++joint) {
      const std::string name = fmt::format("q{}_once", joint + 1);
      out.push_back(formOf(this, fmt::format("joint {} once a turn", joint + 1),
                           {{name + "_sine", "deg", kDegrees, 1.0 / kDegrees, -0.2, 0.2}, {name + "_cosine", "deg", kDegrees, 1.0 / kDegrees, -0.2, 0.2}}));
      out.back().choice = {joint, kOnceATurn};
      out.back().rare = true;
    }
    return out;
  }
  bool bendsGeometry() const override { return true; }
  /// Somebody sets a joint's zero wrong more often than a ring is mounted off its axis.
  double doubt(const Form& form, const VectorXd&, const Signals&) const override { return onceATurn(form) ? 20.0 : 0.0; }
  void geometry(const Form& form, const VectorXd& v, const Signals& signals, Kinematics& kin) const override {
    if (v.isZero(0.0)) return;
    const Eigen::Index joint = form.choice[0];
    MatrixXd q = signals.q;
    if (!onceATurn(form)) {
      q.row(joint).array() += v(0);
      changeJoints(signals, kin, q, signals.dq, signals.ddq);
      return;
    }
    MatrixXd dq = signals.dq, ddq = signals.ddq;
    const Eigen::ArrayXd sine = signals.q.row(joint).array().sin(), cosine = signals.q.row(joint).array().cos();
    const Eigen::ArrayXd off = v(0) * sine + v(1) * cosine, slope = v(0) * cosine - v(1) * sine;
    q.row(joint).array() += off.transpose();
    dq.row(joint).array() *= 1.0 + slope.transpose();
    ddq.row(joint).array() = ddq.row(joint).array() * (1.0 + slope.transpose()) - off.transpose() * signals.dq.row(joint).array().square();
    changeJoints(signals, kin, q, dq, ddq);
  }

 private:
  static constexpr int kOnceATurn = 1;  ///< Second in form.choice, after the joint
  static bool onceATurn(const Form& form) { return form.choice.size() > 1; }
};

}  // namespace

std::unique_ptr<Cause> makeJointOffset() { return std::make_unique<JointOffset>(); }

}  // namespace heft::diagnosis
