// The wrench arrives later (or earlier) than the motion: y(t) = w(t - delay), by more and more where two clocks run
// apart.
#include "core/base/say.h"
#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/common.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/model/found_values.h"

namespace heft::diagnosis {
namespace {

class TimeOffset final : public Cause {
 public:
  const CauseInfo& info() const override {
    static constexpr CauseInfo kInfo{
        .id = ids::timeOffset,
        .family = Family::timing,
        .title = heft::toSay("Force readings late (delay)"),
        .check = heft::toSay("Are force and joint data timestamped by the same clock?"),
        .decides = heft::toSay("Shake the tool quickly for ten seconds, two to four times per second."),
        .looks = heft::toSay("The difference is large where the force changes fast and zero where it is constant; "
                             "peaks keep their full height."),
        .decidingMotion = "shake-sideways",
        .effect = "time_offset"};
    return kInfo;
  }
  std::string sentence(const FoundValues& v) const override {
    if (v.find("clock_drift"))
      return heft::say("The clocks of the force readings and of the motion drift apart by {} ms per second.",
                       v.size("clock_drift"));
    return v.value("delay") > 0.0 ? heft::say("The force readings arrive {} ms late.", v.size("delay"))
                                  : heft::say("The motion arrives {} ms after the force readings.", v.size("delay"));
  }
  std::vector<std::string> lookAlikes() const override { return {"low_pass_lag", "motion_lag"}; }
  std::vector<Form> forms(const Signals&) const override {
    const Parameter delay{"delay", "ms", kMilli, 0.005, -0.3, 0.3};
    Form apart = formOf(this, "clocks that run apart", {delay, {"clock_drift", "ms/s", kMilli, 1e-4, -0.01, 0.01}});
    apart.choice = {kApart};
    return {formOf(this, "", {delay}), apart};
  }
  int order() const override { return 70; }
  bool changesSensor(const Form&) const override { return true; }
  void sensor(const Form& form, const VectorXd& v, const Signals& signals, Wrenches& w) const override {
    if (v.isZero(0.0)) return;
    if (form.choice.empty()) {
      w = delayed(w, v(0), signals.rateHz);
      return;
    }
    // The delay is that at the middle of the recording: there it does not depend on how fast the clocks part.
    const auto n = w.cols();
    const double apart = 0.5 * static_cast<double>(n) / signals.rateHz * v(1);
    w = delayed(w, VectorXd::LinSpaced(n, v(0) - apart, v(0) + apart), signals.rateHz);
  }
  double overOwnErrors(const Form& form, const VectorXd& v, const Signals& signals) const override {
    const double apart = form.choice.empty() ? 0.0 : 0.5 * signals.duration() * v(1);
    return overOwnTimes(std::abs(v(0)) + std::abs(apart));
  }
  /// A delay is taken out, whatever made it, where the readings are shifted until they follow the motion. What is left
  /// is the shift's error, or makes up for what else lags and was taken for a delay.
  bool mayBeAlignment(const Form& form, const VectorXd& v, const Signals& signals) const override {
    if (form.choice.empty()) return signals.clockAlignmentStd.has_value();
    return withinAlignment(0.5 * signals.duration() * v(1), signals);
  }

 private:
  static constexpr int kApart = 1;  ///< form.choice
};

}  // namespace

std::unique_ptr<Cause> makeTimeOffset() { return std::make_unique<TimeOffset>(); }

}  // namespace heft::diagnosis
