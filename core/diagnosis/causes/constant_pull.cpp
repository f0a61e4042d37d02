// A force that keeps its direction in the world, whatever the tool weighs: a spring balancer, a hose over a pulley.
#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/common.h"

namespace heft::diagnosis {
namespace {

class ConstantPull final : public Cause {
 public:
  std::string_view id() const override { return "constant_pull"; }
  std::vector<std::string> lookAlikes() const override { return {"gravity_tilt", "cable_pull"}; }
  std::vector<Form> forms(const Signals&) const override {
    const std::vector<Parameter> pull{{"force_x", "N", 1.0, 0.3, -60.0, 60.0},
                                {"force_y", "N", 1.0, 0.3, -60.0, 60.0},
                                {"force_z", "N", 1.0, 0.3, -60.0, 60.0}};
    std::vector<Form> out{formOf(this, "", pull)};
    out.push_back(formOf(this, "away from the sensor", withPlace(pull)));
    out.back().scan = {0, 1, 2};
    return out;
  }
  void force(const Form&, const VectorXd& v, const Signals& signals, const Kinematics& kin, Wrenches& w) const override {
    // The tool is pulled by F, so the sensor holds it with -F.
    addWorldForce(axesOf(signals, kin), -v.head<3>().replicate(1, signals.size()),
                  v.size() > 3 ? Vector3d(v.segment<3>(3)) : Vector3d(Vector3d::Zero()), w);
  }
};

}  // namespace

std::unique_ptr<Cause> makeConstantPull() { return std::make_unique<ConstantPull>(); }

}  // namespace heft::diagnosis
