// The sensor is mounted turned against what the setup file says.
#include "core/base/say.h"
#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/common.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/model/found_values.h"

namespace heft::diagnosis {
namespace {

class SensorRotation final : public Cause {
 public:
  const CauseInfo& info() const override {
    static constexpr CauseInfo kInfo{
        .id = ids::sensorRotation,
        .family = Family::geometry,
        .title = heft::toSay("Sensor rotated on its mount"),
        .check = heft::toSay("Compare the arrows printed on the sensor with the mount in the setup file."),
        .decides =
            heft::toSay("Turn the last joint by half a turn and hold, then tilt the tool. No motion distinguishes a "
                        "sensor rotated about the last joint's axis from a wrong zero of that joint: check the robot."),
        .looks = heft::toSay("The weight shows up on the wrong axis of the sensor, always the same one."),
        .decidingMotion = "tilt-forwards",
        .effect = "sensor_rotation",
        .placesSensor = true};
    return kInfo;
  }
  std::string sentence(const FoundValues& v) const override {
    return heft::say("The sensor is rotated by {} degrees.", v.norm({"rx", "ry", "rz"}));
  }
  std::vector<std::string> lookAlikes() const override { return {"joint_offset", "crosstalk"}; }
  std::vector<Form> forms(const Signals&) const override {
    const double size = 1.0 / kDegrees;
    Form form = formOf(this, "",
                       {{"rx", "deg", kDegrees, size, -3.2, 3.2},
                        {"ry", "deg", kDegrees, size, -3.2, 3.2},
                        {"rz", "deg", kDegrees, size, -3.2, 3.2}});
    form.subset = true;
    return {form};
  }
  int order() const override { return 20; }
  bool changesSensor(const Form&) const override { return true; }
  bool isMatrix(const Form&) const override { return true; }
  void sensor(const Form&, const VectorXd& v, const Signals&, Wrenches& w) const override {
    const Matrix3d R = rotationFromVector(v).transpose();
    w.topRows<3>() = (R * w.topRows<3>()).eval();
    w.bottomRows<3>() = (R * w.bottomRows<3>()).eval();
  }
};

}  // namespace

std::unique_ptr<Cause> makeSensorRotation() { return std::make_unique<SensorRotation>(); }

}  // namespace heft::diagnosis
