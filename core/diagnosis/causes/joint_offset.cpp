// One joint's angle is off by a constant, or once to and fro in a turn, as where a ring sits off its axis.
#include "core/base/say.h"
#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/common.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/model/found_values.h"

namespace heft::diagnosis {
namespace {

class JointOffset final : public Cause {
 public:
  const CauseInfo& info() const override {
    static constexpr CauseInfo kInfo{
        .id = ids::jointOffset,
        .family = Family::geometry,
        .title = heft::toSay("Joint angle off (encoder offset)"),
        .check = heft::toSay("Check that joint's calibration and the robot description of this recording."),
        .decides = heft::toSay(
            "Visit poses with very different angles of the other joints, elbow high and low. No motion distinguishes a "
            "wrong zero of the last joint from a sensor rotated about its axis: check the robot."),
        .looks = heft::toSay("A difference that depends on the pose: a tilt that is not the same everywhere."),
        .effect = "joint_offset"};
    return kInfo;
  }
  std::string sentence(const FoundValues& v) const override {
    const CauseParameter* p = v.strongest();
    if (!p) return {};
    if (const auto once = p->name.find("_once_"); once != std::string::npos) {
      const std::string both = p->name.substr(0, once + 6);
      return heft::say("The angle of joint {} is off by up to {} degrees, varying once per turn.",
                       p->name.substr(1, once - 1), v.norm({both + "sine", both + "cosine"}));
    }
    return heft::say("The angle of joint {} is {} degrees off.", p->name.substr(1, 1),
                     plusMinus(std::abs(p->value), p->std));
  }
  std::vector<std::string> lookAlikes() const override { return {"gravity_tilt", "sensor_rotation"}; }
  std::vector<Form> forms(const Signals& signals) const override {
    std::vector<Form> out;
    std::vector<int> joints;
    for (int joint = 0; signals.robot != nullptr && joint < signals.q().rows(); ++joint)
      if (signals.joints->turnsAlone(joint)) joints.push_back(joint);
    for (const int joint : joints) {
      out.push_back(formOf(this, fmt::format("joint {}", joint + 1),
                           {{fmt::format("q{}_offset", joint + 1), "deg", kDegrees, 1.0 / kDegrees, -0.6, 0.6}}));
      out.back().choice = {joint};
    }
    for (const int joint : joints) {
      const std::string name = fmt::format("q{}_once", joint + 1);
      out.push_back(formOf(this, fmt::format("joint {} once a turn", joint + 1),
                           {{name + "_sine", "deg", kDegrees, 1.0 / kDegrees, -0.2, 0.2},
                            {name + "_cosine", "deg", kDegrees, 1.0 / kDegrees, -0.2, 0.2}}));
      out.back().choice = {joint, kOnceATurn};
      out.back().rare = true;
    }
    return out;
  }
  bool bendsGeometry() const override { return true; }
  /// Somebody sets a joint's zero wrong more often than a ring is mounted off its axis.
  double doubt(const Form& form, const VectorXd&, const Signals&) const override {
    return onceATurn(form) ? 20.0 : 0.0;
  }
  void geometry(const Form& form, const VectorXd& v, const Signals& signals, Kinematics& kin) const override {
    if (v.isZero(0.0)) return;
    JointTurn turn{form.choice[0]};
    (onceATurn(form) ? turn.sine : turn.constant) = v(0);
    if (onceATurn(form)) turn.cosine = v(1);
    addMove(signals, kin, *signals.joints->with(turn, signals.gravity));
  }

 private:
  static constexpr int kOnceATurn = 1;  ///< Second in form.choice, after the joint
  static bool onceATurn(const Form& form) { return form.choice.size() > 1; }
};

}  // namespace

std::unique_ptr<Cause> makeJointOffset() { return std::make_unique<JointOffset>(); }

}  // namespace heft::diagnosis
