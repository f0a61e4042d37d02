// The sensor's origin is elsewhere than the setup file says: s += alpha x d + omega x (omega x d).
#include "core/base/say.h"
#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/common.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/model/found_values.h"

namespace heft::diagnosis {
namespace {

class LeverArm final : public Cause {
 public:
  const CauseInfo& info() const override {
    static constexpr CauseInfo kInfo{
        .id = ids::leverArm,
        .family = Family::geometry,
        .title = heft::toSay("Sensor position wrong (lever arm)"),
        .check = heft::toSay("Measure from the flange to the sensor's origin and compare with the setup file. If that "
                             "is right, the torque refers to another point: state wrench_point."),
        .decides = heft::toSay("Rotate the tool fast back and forth about all three axes."),
        .looks =
            heft::toSay("Slow motion fits; fast turning leaves a difference that grows with the square of its speed."),
        .decidingMotion = "wobble",
        .effect = "lever_arm",
        .placesSensor = true};
    return kInfo;
  }
  std::string sentence(const FoundValues& v) const override {
    return heft::say("The sensor's origin is {} mm from where the setup file puts it.", v.norm({"dx", "dy", "dz"}));
  }
  std::vector<std::string> lookAlikes() const override { return {"gain_error", "derivative_noise"}; }
  std::vector<Form> forms(const Signals& signals) const override {
    if (!signals.positionKnown) return {};
    Form form = formOf(this, "",
                       {{"dx", "mm", kMilli, 0.01, -0.5, 0.5},
                        {"dy", "mm", kMilli, 0.01, -0.5, 0.5},
                        {"dz", "mm", kMilli, 0.01, -0.5, 0.5}});
    form.subset = true;
    return {form};
  }
  int order() const override { return 16; }
  bool bendsGeometry() const override { return true; }
  void geometry(const Form&, const VectorXd& v, const Signals&, Kinematics& kin) const override {
    const Vector3d d = v;
    for (Eigen::Index k = 0; k < kin.omega.cols(); ++k) {
      const Vector3d o = kin.omega.col(k), a = kin.alpha.col(k);
      kin.specificForce.col(k) += a.cross(d) + o.cross(o.cross(d));
    }
  }
};

}  // namespace

std::unique_ptr<Cause> makeLeverArm() { return std::make_unique<LeverArm>(); }

}  // namespace heft::diagnosis
