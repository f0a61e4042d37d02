// The sensor's origin is elsewhere than the meta file says: s += alpha x d + omega x (omega x d).
#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/common.h"

namespace heft::diagnosis {
namespace {

class LeverArm final : public Cause {
 public:
  std::string_view id() const override { return "lever_arm"; }
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
