// The wrench arrives later (or earlier) than the motion: y(t) = w(t - delay).
#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/common.h"

namespace heft::diagnosis {
namespace {

class TimeOffset final : public Cause {
 public:
  std::string_view id() const override { return "time_offset"; }
  std::vector<std::string> lookAlikes() const override { return {"low_pass_lag", "motion_lag"}; }
  std::vector<Form> forms(const Signals&) const override {
    return {formOf(this, "", {{"delay", "ms", kMilli, 0.005, -0.3, 0.3}})};
  }
  int order() const override { return 70; }
  bool changesSensor(const Form&) const override { return true; }
  void sensor(const Form&, const VectorXd& v, const Signals& signals, Wrenches& w) const override {
    if (v(0) != 0.0) w = delayed(w, v(0), signals.rateHz);
  }
};

}  // namespace

std::unique_ptr<Cause> makeTimeOffset() { return std::make_unique<TimeOffset>(); }

}  // namespace heft::diagnosis
