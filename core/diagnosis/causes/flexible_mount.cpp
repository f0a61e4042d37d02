// The mount gives: the tool rings fast.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "core/base/say.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/causes/oscillator.h"
#include "core/diagnosis/model/found_values.h"
#include "core/diagnosis/model/hum.h"

namespace heft::diagnosis {
namespace {

class FlexibleMount final : public Oscillator {
 public:
  const CauseInfo& info() const override {
    static constexpr CauseInfo kInfo{
        .id = ids::flexibleMount,
        .family = Family::dynamicGain,
        .title = heft::toSay("The tool's mount flexes (flexible mount)"),
        .check = heft::toSay("Tighten the screws between arm, sensor and tool; look for rubber or thin adapters."),
        .decides = heft::toSay("Tap the tool with a finger while the arm holds still."),
        .looks = heft::toSay("A small, fast ringing after every jerk, always at the same frequency."),
        .effect = "flexible_mount"};
    return kInfo;
  }
  std::string sentence(const FoundValues& v) const override {
    if (v.find("strikes"))
      return heft::say(
          "Something that carries the tool is flexible and rings at {} Hz when it is struck: its mount, or the robot's "
          "pedestal.",
          numberWords(v.value("frequency"), 0));
    return heft::say("The tool's mount is flexible and rings at {} Hz.", numberWords(v.value("frequency"), 0));
  }
  std::string check(const FoundValues& v, const Vector3d& gravity) const override {
    return v.find("strikes") ? heft::say(
                                   "Tap the tool, then the robot's pedestal: which of them rings at this frequency? "
                                   "Tighten its screws.")
                             : Cause::check(v, gravity);
  }
  std::vector<std::string> lookAlikes() const override { return {"loose_mass", "derivative_noise"}; }
  std::vector<Form> forms(const Signals& signals) const override {
    if (signals.rateHz < 100.0) return {};
    auto out = at({13.0, 15.0, 17.5, 20.0, 23.0}, kSoftestMountHz, kStiffestMountHz);
    if (const auto pitch = pitchIn(signals); pitch && *pitch < kStiffestMountHz)
      std::ranges::move(at({*pitch}, kSoftestMountHz, kStiffestMountHz), std::back_inserter(out));
    // The whole tool gives, by as much per newton to all sides: how far tells the frequency, whether or not it rings.
    for (const double damping : {0.05, 0.2}) {
      Form form =
          formOf(this, fmt::format("whole tool, damped {:.2f}", damping),
                 {{"frequency", "Hz", 1.0, giveAt(25.0), 0.0, giveAt(kSoftestMountHz), false, false, frequencyAt},
                  {"damping", "", 1.0, 0.05, 0.001, kMostDamped}});
      form.start(1) = damping;
      form.scan = {0};
      form.choice = {kWhole};
      out.push_back(std::move(form));
    }
    return out;
  }
  bool changesSensor(const Form& form) const override { return form.choice[0] == kWhole; }
  /// What comes through the mount before it reaches the gauges.
  void sensor(const Form& form, const VectorXd& v, const Signals& signals, Wrenches& w) const override {
    if (form.choice[0] == kWhole && v(0) > 0.0) w = throughSpring(w, frequencyAt(v(0)), v(1), signals.rateHz);
  }
  double doubt(const Form& form, const VectorXd& v, const Signals& signals) const override {
    return form.choice[0] == kWhole ? doubtAt(frequencyAt(v(0)), signals) : Oscillator::doubt(form, v, signals);
  }
  /// A hand hardly shakes a tool that fast: what shows is how far the mount gives, which is mass over frequency
  /// squared, and how that splits is guessed from the little that is left of the resonance below the smoothing's
  /// corner.
  VectorXd modelStd(const Form&, const VectorXd& v) const override {
    constexpr double kGuessed = 20.0;  // [Hz]
    // That the tool gives alike to all sides, and how it turns, are guessed, too.
    if (v.size() == 2) return Eigen::Vector2d(kTinyShare * v(0), 0.0);
    const double share = kEventError * std::min(1.0, std::pow(v(4) / kGuessed, 2));
    VectorXd out = VectorXd::Zero(v.size());
    out.head<4>() = 2.0 * share * v.head<4>().cwiseAbs();
    out(4) = share * v(4);
    return out;
  }

 private:
  static constexpr int kWhole = kElse;

  /// How far a mass goes per unit of acceleration [s2], by the frequency at which it rings on the mount [Hz].
  static double giveAt(double frequency) { return std::pow(2.0 * std::numbers::pi * frequency, -2); }
  static double frequencyAt(double give) { return 1.0 / (2.0 * std::numbers::pi * std::sqrt(std::max(give, 1e-12))); }
};

}  // namespace

std::unique_ptr<Cause> makeFlexibleMount() { return std::make_unique<FlexibleMount>(); }

}  // namespace heft::diagnosis
