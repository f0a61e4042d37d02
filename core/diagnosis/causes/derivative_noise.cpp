// Noise in the accelerations makes everything inertial look smaller than it is: inertial part x (1 - loss).
#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/common.h"

namespace heft::diagnosis {
namespace {

class DerivativeNoise final : public Cause {
 public:
  std::string_view id() const override { return "derivative_noise"; }
  std::vector<std::string> lookAlikes() const override { return {"motion_lag"}; }
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
