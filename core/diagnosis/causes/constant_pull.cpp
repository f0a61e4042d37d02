// A force that keeps its direction in the world, whatever the tool weighs: a spring balancer, a hose over a pulley.
#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/common.h"

namespace heft::diagnosis {
namespace {

class ConstantPull final : public Cause {
 public:
  std::string_view id() const override { return "constant_pull"; }
  std::vector<std::string> lookAlikes() const override { return {"gravity_tilt", "cable_pull"}; }
  std::vector<Form> forms(const Signals& signals) const override {
    const std::vector<Parameter> pull{{"force_x", "N", 1.0, 0.3, -60.0, 60.0},
                                      {"force_y", "N", 1.0, 0.3, -60.0, 60.0},
                                      {"force_z", "N", 1.0, 0.3, -60.0, 60.0}};
    std::vector<Form> out{formOf(this, "", pull)};
    // Where it acts shows only with a force there: a first look from the sensor and from the middle of a tool, to
    // either side.
    for (const double z : {0.0, 0.08, -0.08}) {
      out.push_back(formOf(this, "away from the sensor", withPlace(pull)));
      out.back().scan = {0, 1, 2};
      out.back().start(5) = z;
    }
    // From some moment on, such as when a hose is switched on or caught.
    const auto [from, to] = timesForChange(signals);
    for (const double t : momentsForChange(signals)) {
      std::vector<Parameter> parameters{{"time", "s", 1.0, 0.1, from, to}};
      parameters.insert(parameters.end(), pull.begin(), pull.end());
      parameters = withPlace(std::move(parameters));
      parameters.push_back({"duration", "s", 1.0, 0.1, 0.0, 2.0, true});
      Form form = formOf(this, "from some moment on", std::move(parameters));
      form.start(0) = t;
      form.start(7) = 0.05;
      form.scan = {1, 2, 3};
      form.choice = {1};
      form.local = form.atOnce = true;
      out.push_back(std::move(form));
    }
    return out;
  }
  void force(const Form& form, const VectorXd& v, const Signals& signals, const Kinematics& kin,
             Wrenches& w) const override {
    // The tool is pulled by F, so the sensor holds it with -F.
    const Eigen::Index first = form.local ? 1 : 0;
    const Vector3d r = v.size() > 3 ? Vector3d(v.segment<3>(first + 3)) : Vector3d(Vector3d::Zero());
    Eigen::Matrix3Xd held(3, signals.size());
    for (Eigen::Index k = 0; k < held.cols(); ++k)
      held.col(k) = -v.segment<3>(first) * (form.local ? stepAt(signals.time(k), v(0), v(7)) : 1.0);
    addWorldForce(axesOf(signals, kin), held, r, w);
  }
  /// A step in six channels takes a little of anything that is left. Of four that had begun, the faintest was 1,300.
  /// What begins to pull straight up or down is a load that changed.
  double doubt(const Form& form, const VectorXd& v, const Signals& signals) const override {
    constexpr double kStep = 80.0, kNever = 1e9, kAside = 0.2;
    if (!form.local) return 0.0;
    const Vector3d force = v.segment<3>(1);
    return force.cross(signals.gravity).norm() < kAside * force.norm() * signals.gravity.norm() ? kNever : kStep;
  }
  std::vector<std::pair<double, double>> when(const Form& form, const VectorXd& v,
                                              const Signals& signals) const override {
    if (!form.local) return {};
    return {wholeAfter(v(0) - 0.5 * v(7), signals)};
  }
};

}  // namespace

std::unique_ptr<Cause> makeConstantPull() { return std::make_unique<ConstantPull>(); }

}  // namespace heft::diagnosis
