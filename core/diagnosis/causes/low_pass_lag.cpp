// A low-pass filter inside the sensor or its driver: T y' + y = w, once or twice.
#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/common.h"

namespace heft::diagnosis {
namespace {

class LowPassLag final : public Cause {
 public:
  std::string_view id() const override { return "low_pass_lag"; }
  std::vector<std::string> lookAlikes() const override { return {"time_offset", "motion_lag"}; }
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
