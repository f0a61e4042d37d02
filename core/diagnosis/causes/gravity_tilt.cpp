// Gravity points elsewhere than the meta file says: the robot's base is tilted.
#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/common.h"

namespace heft::diagnosis {
namespace {

class GravityTilt final : public Cause {
 public:
  std::string_view id() const override { return "gravity_tilt"; }
  std::vector<std::string> lookAlikes() const override { return {"constant_pull", "joint_offset"}; }
  std::vector<Form> forms(const Signals&) const override {
    const double size = 1.0 / kDegrees;
    // acrossGravity()'s second axis points against the base's y where gravity points down.
    return {formOf(this, "",
                   {{"tilt_x", "deg", kDegrees, size, -3.0, 3.0}, {"tilt_y", "deg", -kDegrees, size, -3.0, 3.0}})};
  }
  int order() const override { return 10; }
  bool bendsGeometry() const override { return true; }
  void geometry(const Form&, const VectorXd& v, const Signals& signals, Kinematics& kinematics) const override {
    const auto [x, y] = acrossGravity(signals.gravity);
    const Vector3d change = rotationFromVector(v(0) * x + v(1) * y) * signals.gravity - signals.gravity;
    const std::vector<Matrix3d>& R_BS = axesOf(signals, kinematics);
    for (Eigen::Index k = 0; k < signals.size(); ++k)
      kinematics.specificForce.col(k) -= R_BS[static_cast<std::size_t>(k)].transpose() * change;
  }
};

}  // namespace

std::unique_ptr<Cause> makeGravityTilt() { return std::make_unique<GravityTilt>(); }

}  // namespace heft::diagnosis
