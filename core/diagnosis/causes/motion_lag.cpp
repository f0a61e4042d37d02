// Velocities and accelerations come late while gravity is in time: the robot smooths its velocities.
#include "core/base/say.h"
#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/common.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/model/found_values.h"

namespace heft::diagnosis {
namespace {

class MotionLag final : public Cause {
 public:
  const CauseInfo& info() const override {
    static constexpr CauseInfo kInfo{
        .id = ids::motionLag,
        .family = Family::timing,
        .title = heft::toSay("Accelerations late (motion lag)"),
        .check = heft::toSay("Record the raw joint angles at the full rate, without smoothing."),
        .decides = heft::toSay(
            "Turn the tool slowly through large angles: late readings still show then, late accelerations do not."),
        .looks = heft::toSay("Slow turning fits well; only starts and stops leave a difference."),
        .decidingMotion = "turn-slowly",
        .effect = "motion_lag"};
    return kInfo;
  }
  std::string sentence(const FoundValues& v) const override {
    return v.direct ? heft::say("The reported velocities come {} ms late; Heft can use the positions instead.",
                                v.size("lag"))
                    : heft::say("The accelerations lag by {} ms; the angles do not.", v.size("lag"));
  }
  std::vector<std::string> lookAlikes() const override { return {"time_offset", "derivative_noise"}; }
  std::vector<Form> forms(const Signals&) const override {
    std::vector<Form> out;
    for (const int kind : {kSmoothed, kDelayed, kInSensor}) {
      const char* name = kind == kSmoothed ? "" : kind == kDelayed ? "pure delay" : "in the sensor's axes";
      out.push_back(formOf(this, name, {{"lag", "ms", kMilli, 0.01, kind == kDelayed ? -0.3 : 0.0, 0.3}}));
      out.back().choice = {kind};
    }
    return out;
  }
  int order() const override { return 12; }
  bool bendsGeometry() const override { return true; }
  void geometry(const Form& form, const VectorXd& v, const Signals& signals, Kinematics& kinematics) const override {
    if (std::abs(v(0)) < 1e-7) return;
    const auto late = [&](const Eigen::Matrix3Xd& value) -> Eigen::Matrix3Xd {
      return form.choice[0] == kDelayed ? delayed(value, v(0), signals.rateHz) : onePole(value, v(0), signals.rateHz);
    };
    if (form.choice[0] == kInSensor)
      changeMotionInSensor(signals, kinematics, late);
    else
      changeMotion(signals, kinematics, late);
  }
  double overOwnErrors(const Form&, const VectorXd& v, const Signals&) const override { return overOwnTimes(v(0)); }
  bool mayBeAlignment(const Form&, const VectorXd& v, const Signals& signals) const override {
    return withinAlignment(v(0), signals);
  }

 private:
  /// Form::choice. What was smoothed in the sensor's axes is what inertia adds to the readings, not the robot's motion.
  enum Kind { kSmoothed, kDelayed, kInSensor };
};

}  // namespace

std::unique_ptr<Cause> makeMotionLag() { return std::make_unique<MotionLag>(); }

}  // namespace heft::diagnosis
