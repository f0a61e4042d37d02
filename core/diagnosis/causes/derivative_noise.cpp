// Noise in the accelerations makes everything inertial look smaller than it is: inertial part x (1 - loss).
#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/common.h"

namespace heft::diagnosis {
namespace {

class DerivativeNoise final : public Cause {
 public:
  std::string_view id() const override { return "derivative_noise"; }
  Words words() const override {
    return {"Accelerations too noisy or too smooth",
            "Record joint angles at the full rate and resolution; check the size of gravity in the meta file.",
            "Record once more and compare with stronger smoothing (--cutoff): noise loses more then, a wrong gravity does not.",
            {"motion_lag"}};
  }
  std::string sentence(const Form&, const VectorXd& v, const VectorXd& std) const override {
    return fmt::format("The forces of acceleration differ from what the motion says by {} %.",
                       plusMinus(-v(0) * 100.0, std(0) * 100.0));
  }
  std::vector<Form> forms(const Signals& signals) const override {
    if (!signals.positionKnown) return {};
    return {formOf(this, "", {{"loss", "%", 100.0, 0.05, -0.5, 0.5}})};
  }
  int order() const override { return 14; }
  bool bendsGeometry() const override { return true; }
  void geometry(const Form&, const VectorXd& v, const Signals& signals, Kinematics& kinematics) const override {
    for (Eigen::Index k = 0; k < signals.size(); ++k) {
      const Vector3d g = signals.R_BS[static_cast<std::size_t>(k)].transpose() * signals.gravity;
      kinematics.specificForce.col(k) -= v(0) * (kinematics.specificForce.col(k) + g);
    }
    kinematics.alpha *= 1.0 - v(0);
    kinematics.omega *= std::sqrt(std::max(0.0, 1.0 - v(0)));
  }
};

}  // namespace

std::unique_ptr<Cause> makeDerivativeNoise() { return std::make_unique<DerivativeNoise>(); }

}  // namespace heft::diagnosis
