// A motor that spins inside the tool resists being turned: torque omega x h on the payload. Not in Heft's catalogue;
// the example of core/diagnosis/causes/README.md.
#include "tests/core/diagnosis/own_cause/spinning_rotor.h"

#include "core/base/say.h"
#include "core/diagnosis/causes/common.h"
#include "core/diagnosis/model/found_values.h"

namespace heft::diagnosis {
namespace {

class SpinningRotor final : public Cause {
 public:
  const CauseInfo& info() const override {
    static constexpr CauseInfo kInfo{
        .id = "spinning_rotor",
        .family = Family::externalForce,
        .title = heft::toSay("Something spins in the tool"),
        .check = heft::toSay("Switch off the tool's motor and record once more."),
        .decides = heft::toSay("Turn the tool about each axis, with the motor on and off."),
        .looks = heft::toSay("A torque across the axis that the tool turns about, and across the motor's.")};
    return kInfo;
  }
  std::string sentence(const FoundValues& v) const override {
    return heft::say("Something spins in the tool, with {} N m s.", v.norm({"h_x", "h_y", "h_z"}));
  }
  std::vector<Form> forms(const Signals&) const override {
    // Name, unit, reported value over SI value, a realistic size, bounds.
    return {formOf(this, "",
                   {{"h_x", "N m s", 1.0, 0.02, -2.0, 2.0},
                    {"h_y", "N m s", 1.0, 0.02, -2.0, 2.0},
                    {"h_z", "N m s", 1.0, 0.02, -2.0, 2.0}})};
  }
  /// What the sensor has to hold: h turns with the tool, S axes.
  void force(const Form&, const VectorXd& v, const Signals&, const Kinematics& kin, Wrenches& w) const override {
    const Vector3d h = v.head<3>();
    for (Eigen::Index k = 0; k < w.cols(); ++k) w.col(k).tail<3>() += Vector3d(kin.omega.col(k)).cross(h);
  }
};

}  // namespace

std::unique_ptr<Cause> makeSpinningRotor() { return std::make_unique<SpinningRotor>(); }

}  // namespace heft::diagnosis
