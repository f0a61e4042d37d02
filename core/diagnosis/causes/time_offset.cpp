// The wrench arrives later (or earlier) than the motion: y(t) = w(t - delay).
#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/common.h"

namespace heft::diagnosis {
namespace {

class TimeOffset final : public Cause {
 public:
  std::string_view id() const override { return "time_offset"; }
  Words words() const override {
    return {"Force readings out of step",
            "Look at how force and joint angles get their time stamps: one clock, stamps at the source, no queue between.",
            "Shake the tool quickly for a few seconds, two to four times a second.",
            {"low_pass_lag", "motion_lag"}};
  }
  std::string sentence(const Form&, const VectorXd& v, const VectorXd& std) const override {
    return fmt::format("The force readings arrive {} ms {} than the motion.",
                       plusMinus(std::abs(v(0)) * kMilli, std(0) * kMilli), v(0) > 0.0 ? "later" : "earlier");
  }
  std::vector<Form> forms(const Signals&) const override {
    return {formOf(this, "", {{"delay", "ms", kMilli, 0.005, -0.3, 0.3}})};
  }
  int order() const override { return 70; }
  bool changesSensor() const override { return true; }
  void sensor(const Form&, const VectorXd& v, const Signals& signals, Wrenches& w) const override {
    if (v(0) != 0.0) w = delayed(w, v(0), signals.rateHz);
  }
};

}  // namespace

std::unique_ptr<Cause> makeTimeOffset() { return std::make_unique<TimeOffset>(); }

}  // namespace heft::diagnosis
