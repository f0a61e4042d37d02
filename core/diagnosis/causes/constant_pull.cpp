// A force that keeps its direction in the world, whatever the tool weighs: a spring balancer, a hose over a pulley.
#include <algorithm>

#include "core/base/say.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/common.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/model/found_values.h"
#include "core/math/linear_algebra.h"

namespace heft::diagnosis {
namespace {

class ConstantPull final : public Cause {
 public:
  const CauseInfo& info() const override {
    static constexpr CauseInfo kInfo{
        .id = ids::constantPull,
        .family = Family::externalForce,
        .title = heft::toSay("Steady pull from outside (constant force)"),
        .check = heft::toSay("Is there a balancer, a hose or a weight that pulls in one direction?"),
        .decides = heft::toSay("Record once more with a heavier tool: a tilt grows with the weight, a pull does not."),
        .looks = heft::toSay("A difference that keeps its direction in the room, whatever the tool weighs."),
        .effect = "constant_pull",
        .begins = true};
    return kInfo;
  }
  std::string sentence(const FoundValues& v) const override {
    const std::string size = v.norm({"force_x", "force_y", "force_z"});
    return v.find("time")
               ? heft::say("From {} s on, something pulls on the tool with {} N, always in the same direction.",
                           numberWords(v.value("time"), 1), size)
               : heft::say("Something pulls on the tool with {} N, always in the same direction.", size);
  }
  /// Straight up all the time: a weight that is taken off the readings does exactly the same.
  std::string check(const FoundValues& v, const Vector3d& gravity) const override {
    const Vector3d force(v.value("force_x"), v.value("force_y"), v.value("force_z"));
    const bool pullsUp = !v.find("time") && force.dot(gravity) < 0.0 &&
                         force.cross(gravity).norm() < kFormError * force.norm() * gravity.norm();
    return pullsUp ? heft::say(
                         "It acts straight up: does the robot or the sensor's driver already subtract a tool's weight? "
                         "If not: does a balancer or a hose carry part of it?")
                   : Cause::check(v, gravity);
  }
  std::vector<std::string> lookAlikes() const override { return {"gravity_tilt", "cable_pull"}; }
  std::vector<Form> forms(const Signals& signals) const override {
    const std::vector<Parameter> pull{{"force_x", "N", 1.0, 0.3, -60.0, 60.0},
                                      {"force_y", "N", 1.0, 0.3, -60.0, 60.0},
                                      {"force_z", "N", 1.0, 0.3, -60.0, 60.0}};
    std::vector<Form> out{formOf(this, "", pull)};
    // Where it acts shows only with a force there. What each component of the force does at each component of the place
    // is linear, and shows both.
    out.push_back(formOf(this, "away from the sensor", withPlace(pull)));
    out.back().scan = {0, 1, 2};
    out.back().later = true;
    std::vector<Parameter> anywhere = pull;
    for (const char at : {'x', 'y', 'z'})
      for (const char along : {'x', 'y', 'z'})
        anywhere.push_back({fmt::format("force_{}_at_{}", along, at), "N m", 1.0, 0.02, -30.0, 30.0, false, false});
    out.push_back(formOf(this, "anywhere", std::move(anywhere)));
    out.back().choice = {kAnywhere};
    out.back().guide = true;
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
      form.choice = {kFromThen};
      form.local = form.atOnce = true;
      out.push_back(std::move(form));
    }
    return out;
  }
  /// A force at one place, from what it seems to do at all of them: as strong as it is seen, or as what it turns says
  /// of one at the middle of a tool.
  std::vector<std::pair<Form, VectorXd>> grown(const Form& form, const VectorXd& v,
                                               const Signals& signals) const override {
    if (!form.guide) return {};
    const Eigen::Map<const Matrix3d> turns(v.data() + 3);  // Force along each axis, at each place
    const ThinSvd svd = thinSvd(turns);
    const double most = svd.values(0);
    if (!(most > 0.0)) return {};
    const Vector3d seen = v.head<3>();
    Vector3d along = svd.U.col(0);
    if (along.dot(seen) < 0.0) along = -along;
    const std::vector<Form> all = forms(signals);
    const Form& away = *std::ranges::find_if(all, [](const Form& f) { return f.later; });
    std::vector<std::pair<Form, VectorXd>> out;
    for (const Vector3d& force : {seen, Vector3d(most / kGrip * along)}) {
      VectorXd start(6);
      const Vector3d place = turns.transpose() * force / std::max(1e-9, force.squaredNorm());
      start << force, place.cwiseMax(-kToolReach).cwiseMin(kToolReach);
      out.emplace_back(away, std::move(start));
    }
    return out;
  }
  bool feelsMotion() const override { return false; }
  void force(const Form& form, const VectorXd& v, const Signals& signals, const Kinematics& kin,
             Wrenches& w) const override {
    if (form.guide) {
      const std::vector<Matrix3d>& R_BS = axesOf(signals, kin);
      const Eigen::Map<const Matrix3d> turns(v.data() + 3);
      for (Eigen::Index k = 0; k < w.cols(); ++k) {
        const Matrix3d R_SB = R_BS[static_cast<std::size_t>(k)].transpose();
        w.col(k).head<3>() -= R_SB * v.head<3>();
        const Matrix3d forces = R_SB * turns;  // At each place, S axes
        w.col(k).tail<3>() -=
            Vector3d(forces(2, 1) - forces(1, 2), forces(0, 2) - forces(2, 0), forces(1, 0) - forces(0, 1));
      }
      return;
    }
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
    if (!form.local) return 0.0;
    const Vector3d force = v.segment<3>(1);
    return force.cross(signals.gravity).norm() < kMinorShare * force.norm() * signals.gravity.norm() ? kNever : kFaint;
  }
  /// What pulls has hold of the tool. Of 70 that did, the farthest was at 0.22 m; a torque without a force was at 0.6.
  bool plausible(const Form& form, const VectorXd& v, const VectorXd& std) const override {
    const Eigen::Index at = form.local ? 4 : 3;
    return form.guide || v.size() < at + 3 ||
           v.segment<3>(at).norm() - kDeviations * std.segment<3>(at).norm() < kToolReach;
  }
  std::vector<std::pair<double, double>> when(const Form& form, const VectorXd& v,
                                              const Signals& signals) const override {
    if (!form.local) return {};
    return {wholeAfter(v(0) - 0.5 * v(7), signals)};
  }

 private:
  static constexpr int kFromThen = 1, kAnywhere = 2;  ///< form.choice
};

}  // namespace

std::unique_ptr<Cause> makeConstantPull() { return std::make_unique<ConstantPull>(); }

}  // namespace heft::diagnosis
