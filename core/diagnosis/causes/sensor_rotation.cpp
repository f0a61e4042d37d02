// The sensor is mounted turned against what the meta file says.
#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/common.h"

namespace heft::diagnosis {
namespace {

class SensorRotation final : public Cause {
 public:
  std::string_view id() const override { return "sensor_rotation"; }
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
