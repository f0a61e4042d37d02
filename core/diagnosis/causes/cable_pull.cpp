// A cable or hose that pulls like a spring towards where it is fixed.
#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/common.h"

namespace heft::diagnosis {
namespace {

Vector3d middle(const Signals& signals) { return signals.position.rowwise().mean(); }

class CablePull final : public Cause {
 public:
  std::string_view id() const override { return "cable_pull"; }
  std::vector<std::string> lookAlikes() const override { return {"constant_pull", "gravity_tilt"}; }
  std::vector<Form> forms(const Signals& signals) const override {
    std::vector<Form> out;
    const Parameter stiffness{"stiffness", "N/m", 1.0, 1.0, 0.0, 400.0};
    const std::vector<Parameter> pull{{"force_x", "N", 1.0, 0.3, -60.0, 60.0},
                                      {"force_y", "N", 1.0, 0.3, -60.0, 60.0},
                                      {"force_z", "N", 1.0, 0.3, -60.0, 60.0}};
    const auto add = [&](int kind, const char* name, std::vector<Parameter> head, std::vector<Parameter> more) {
      head.insert(head.end(), more.begin(), more.end());
      Form form = formOf(this, name, head);
      form.choice = {kind};
      out.push_back(form);
    };
    const std::vector<Parameter> place = withPlace({});
    if (signals.positionKnown) {
      std::vector<Parameter> head{stiffness};
      head.insert(head.end(), pull.begin(), pull.end());
      add(0, "", head, {});
      add(1, "away from the sensor", head, place);
      out.back().scan = {0, 1, 2, 3};
      std::vector<Parameter> three{{"stiffness_x", "N/m", 1.0, 1.0, 0.0, 400.0, true},
                                   {"stiffness_y", "N/m", 1.0, 1.0, 0.0, 400.0, true},
                                   {"stiffness_z", "N/m", 1.0, 1.0, 0.0, 400.0, true}};
      three.insert(three.end(), pull.begin(), pull.end());
      add(2, "different along each axis", three, place);
      out.back().scan = {0, 1, 2, 3, 4, 5};
    }
    add(3, "twist", {{"twist_stiffness", "N m/rad", 1.0, 0.02, 0.0, 20.0}},
        {{"torque_x", "N m", 1.0, 0.02, -5.0, 5.0}, {"torque_y", "N m", 1.0, 0.02, -5.0, 5.0}, {"torque_z", "N m", 1.0, 0.02, -5.0, 5.0}});
    return out;
  }
  void force(const Form& form, const VectorXd& v, const Signals& signals, const Kinematics&, Wrenches& w) const override {
    if (form.choice[0] == 3) {
      const Matrix3d& R0 = signals.R_BS[signals.R_BS.size() / 2];
      for (Eigen::Index k = 0; k < w.cols(); ++k) {
        const Matrix3d& R = signals.R_BS[static_cast<std::size_t>(k)];
        w.col(k).tail<3>() += R.transpose() * (v(0) * vectorFromRotation(R * R0.transpose()) + v.segment<3>(1));
      }
      return;
    }
    const bool perAxis = form.choice[0] == 2;
    const Eigen::Index at = perAxis ? 3 : 1;
    const Vector3d stiffness = perAxis ? Vector3d(v.head<3>()) : Vector3d(Vector3d::Constant(v(0)));
    const Vector3d pull = v.segment<3>(at);
    const Vector3d r = v.size() > at + 3 ? Vector3d(v.segment<3>(at + 3)) : Vector3d(Vector3d::Zero());
    const Vector3d centre = middle(signals);
    Eigen::Matrix3Xd held(3, w.cols());
    for (Eigen::Index k = 0; k < w.cols(); ++k)
      held.col(k) = stiffness.cwiseProduct(Vector3d(signals.position.col(k) + signals.R_BS[static_cast<std::size_t>(k)] * r - centre)) - pull;
    addWorldForce(signals, held, r, w);
  }
};

}  // namespace

std::unique_ptr<Cause> makeCablePull() { return std::make_unique<CablePull>(); }

}  // namespace heft::diagnosis
