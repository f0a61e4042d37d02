// Something loose in the tool: it swings slowly, or rolls to its place.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/base/say.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/causes/oscillator.h"
#include "core/diagnosis/model/found_values.h"

namespace heft::diagnosis {
namespace {

class LooseMass final : public Oscillator {
 public:
  const CauseInfo& info() const override {
    static constexpr CauseInfo kInfo{
        .id = ids::looseMass,
        .family = Family::dynamicGain,
        .title = heft::toSay("Something is loose in the tool"),
        .check = heft::toSay("Shake the tool by hand and listen: a loose part, a liquid, a hanging hose?"),
        .decides =
            heft::toSay("Move and stop abruptly a few times in different directions: a loose part keeps swinging."),
        .looks = heft::toSay("After each stop the difference keeps oscillating for a while, at a few hertz."),
        .decidingMotion = "shake-forwards",
        .effect = "loose_mass"};
    return kInfo;
  }
  std::string sentence(const FoundValues& v) const override {
    if (v.find("mass") && v.value("damping") > 0.5)
      return heft::say("About {} g of the tool is loose and rolls to another place as the tool turns.", v.size("mass"));
    return heft::say("About {} g of the tool is loose and swings {} times a second.", v.size("mass"),
                     numberWords(v.value("frequency"), 1));
  }
  std::vector<std::string> lookAlikes() const override { return {"flexible_mount", "low_pass_lag"}; }
  /// A part has a mass. Of 77 that were loose each was known to a sixth of it; of nine other things that swing, five to
  /// a third and worse.
  bool plausible(const Form& form, const VectorXd& v, const VectorXd& std) const override {
    return form.choice[0] == kFromStart || v(0) > kDeviations * std(0);
  }
  std::vector<Form> forms(const Signals&) const override {
    auto out = at({0.8, 1.2, 1.7, 2.3, 3.0, 4.0, 5.5, 7.5, 10.0}, 0.4, 13.0);
    // A part that lies in a hollow, or a liquid: it rolls to its new place as the tool turns, and does not swing.
    for (const double damping : {1.3, 3.0})
      for (const double frequency : {3.0, 5.0}) {
        Form form = formOf(this, fmt::format("rolls, {:.0f} Hz, {:.1f}", frequency, damping), parameters(1.0, 13.0));
        form.parameters[5] = {"damping", "", 1.0, 0.5, 0.8, 12.0};
        form.start(4) = frequency;
        form.start(5) = damping;
        form.scan = {0, 1, 2, 3};
        form.choice = {kRolls};
        out.push_back(std::move(form));
      }
    out.push_back(inPlace(out.front()));
    // It swung already when the recording began: in the other forms it starts in balance.
    for (const double frequency : {1.2, 1.7, 2.3, 3.0, 4.0, 5.5, 7.5}) {
      std::vector<Parameter> own;
      for (const char* phase : {"start", "quarter"})
        for (const char axis : {'x', 'y', 'z'})
          own.push_back({fmt::format("{}_{}", phase, axis), "N", 1.0, 0.2, -50.0, 50.0});
      own.push_back({"frequency", "Hz", 1.0, 0.3, 0.4, 13.0});
      // What hardly dies away is a rhythm of something that runs.
      own.push_back({"damping", "", 1.0, 0.05, 0.03, kMostDamped});
      Form form = formOf(this, fmt::format("swinging from the start, {:.1f} Hz", frequency), withPlace(std::move(own)));
      form.start(6) = frequency;
      form.start(7) = 0.06;
      form.scan = {0, 1, 2, 3, 4, 5};
      form.choice = {kFromStart};
      out.push_back(std::move(form));
    }
    return out;
  }
  std::vector<std::pair<Form, VectorXd>> grown(const Form& form, const VectorXd& v, const Signals&) const override {
    if (form.choice != std::vector<int>{kAllWays}) return {};
    return {{inPlace(form), v}};
  }
  void force(const Form& form, const VectorXd& v, const Signals& signals, const Kinematics& kin,
             Wrenches& w) const override {
    if (form.choice[0] != kFromStart) {
      Oscillator::force(form, v, signals, kin, w);
      return;
    }
    // Dies away in the tool's axes; what turning does to it is left out.
    const double omega = 2.0 * std::numbers::pi * v(6), fast = omega * std::sqrt(1.0 - v(7) * v(7));
    for (Eigen::Index k = 0; k < w.cols(); ++k) {
      const double t = signals.time(k) - signals.startTime, left = std::exp(-v(7) * omega * t);
      if (left < 1e-4) break;
      const Vector3d f = left * (std::cos(fast * t) * v.head<3>() + std::sin(fast * t) * v.segment<3>(3));
      w.col(k).head<3>() += f;
      w.col(k).tail<3>() += Vector3d(v.tail<3>()).cross(f);
    }
  }
  /// No part hangs on a spring that is the same however far it goes, with a damper that is the same however fast.
  VectorXd modelStd(const Form& form, const VectorXd& v) const override {
    if (form.choice[0] == kFromStart) return {};
    VectorXd out = VectorXd::Zero(v.size());
    out.head<4>() = kTinyShare * v.head<4>().cwiseAbs();
    out(4) = kFrequencyError * v(4);
    out(5) = kEventError * v(5);
    return out;
  }
  double doubt(const Form& form, const VectorXd& v, const Signals& signals) const override {
    return form.choice[0] == kFromStart ? kNamed : Oscillator::doubt(form, v, signals);
  }

 private:
  static constexpr int kFromStart = kElse;

  /// Of what goes to and fro without taking its weight along, such as a part of two halves that swing against each
  /// other; begins where `allWays` was found.
  static Form inPlace(const Form& allWays) {
    Form form = allWays;
    form.name = "its weight stays in place";
    form.choice = {kAllWays, 1};
    form.later = true;
    return form;
  }
};

}  // namespace

std::unique_ptr<Cause> makeLooseMass() { return std::make_unique<LooseMass>(); }

}  // namespace heft::diagnosis
