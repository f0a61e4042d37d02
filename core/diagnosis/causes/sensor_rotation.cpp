// The sensor is mounted turned against what the meta file says.
#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/common.h"

namespace heft::diagnosis {
namespace {

class SensorRotation final : public Cause {
 public:
  std::string_view id() const override { return "sensor_rotation"; }
  Words words() const override {
    return {"Sensor mounted turned",
            "Compare the arrows printed on the sensor with the mount in the meta file (sensor.mount.rpy_rad).",
            "Turn the last joint by half a turn and hold, then tilt the tool.",
            {"joint_offset", "crosstalk"}};
  }
  std::string sentence(const Form&, const VectorXd& v, const VectorXd& std) const override {
    return fmt::format("The sensor sits turned by {} degrees (about x, y, z: {:.1f}, {:.1f}, {:.1f}).",
                       plusMinus(v.norm() * kDegrees, std.maxCoeff() * kDegrees), v(0) * kDegrees, v(1) * kDegrees,
                       v(2) * kDegrees);
  }
  std::vector<Form> forms(const Signals&) const override {
    const double size = 1.0 / kDegrees;
    Form form = formOf(this, "", {{"rx", "deg", kDegrees, size, -3.2, 3.2},
                                  {"ry", "deg", kDegrees, size, -3.2, 3.2},
                                  {"rz", "deg", kDegrees, size, -3.2, 3.2}});
    form.subset = true;
    return {form};
  }
  int order() const override { return 20; }
  bool changesSensor() const override { return true; }
  void sensor(const Form&, const VectorXd& v, const Signals&, Wrenches& w) const override {
    const Matrix3d R = rotationFromVector(v).transpose();
    w.topRows<3>() = (R * w.topRows<3>()).eval();
    w.bottomRows<3>() = (R * w.bottomRows<3>()).eval();
  }
};

}  // namespace

std::unique_ptr<Cause> makeSensorRotation() { return std::make_unique<SensorRotation>(); }

}  // namespace heft::diagnosis
