// A low-pass filter inside the sensor or its driver: T y' + y = w, once or twice.
#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/common.h"

namespace heft::diagnosis {
namespace {

class LowPassLag final : public Cause {
 public:
  std::string_view id() const override { return "low_pass_lag"; }
  Words words() const override {
    return {"Filter in the force sensor",
            "Look for a low-pass or averaging setting in the sensor's amplifier or driver, and switch it off or raise its "
            "frequency.",
            "Shake the tool quickly for a few seconds, two to four times a second: a filter also makes fast forces smaller, a "
            "delay does not.",
            {"time_offset", "motion_lag"}};
  }
  std::string sentence(const Form& form, const VectorXd& v, const VectorXd& std) const override {
    return fmt::format("The force readings pass a {}filter with a time constant of {} ms.",
                       form.choice[0] == 2 ? "two-stage " : "", plusMinus(v(0) * kMilli, std(0) * kMilli));
  }
  std::vector<Form> forms(const Signals&) const override {
    std::vector<Form> out;
    for (const int stages : {1, 2}) {
      out.push_back(formOf(this, stages == 1 ? "" : "two stages",
                           {{"time_constant", "ms", kMilli, 0.005, 0.0, 0.8}}));
      out.back().choice = {stages};
    }
    return out;
  }
  int order() const override { return 60; }
  bool changesSensor() const override { return true; }
  void sensor(const Form& form, const VectorXd& v, const Signals& signals, Wrenches& w) const override {
    for (int stage = 0; v(0) > 1e-6 && stage < form.choice[0]; ++stage) w = onePole(w, v(0), signals.rateHz);
  }
};

}  // namespace

std::unique_ptr<Cause> makeLowPassLag() { return std::make_unique<LowPassLag>(); }

}  // namespace heft::diagnosis
