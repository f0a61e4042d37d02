// A low-pass filter inside the sensor or its driver: T y' + y = w, the same with T / 2 twice, or the mean over the
// last 2 T. Each makes slow readings late by T.
#include "core/base/say.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/common.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/model/found_values.h"

namespace heft::diagnosis {
namespace {

class LowPassLag final : public Cause {
 public:
  const CauseInfo& info() const override {
    static constexpr CauseInfo kInfo{
        .id = ids::lowPassLag,
        .family = Family::timing,
        .title = heft::toSay("Force readings smoothed (low-pass filter)"),
        .check = heft::toSay("Is a filter or averaging switched on in the sensor's amplifier or driver?"),
        .decides = heft::toSay(
            "Shake the tool quickly for ten seconds: smoothing makes fast forces smaller, a delay does not."),
        .looks = heft::toSay("Late like a delay, but peaks are also cut down, and the noise looks soft."),
        .decidingMotion = "shake-sideways",
        .effect = "low_pass_lag"};
    return kInfo;
  }
  std::string sentence(const FoundValues& v) const override {
    return heft::say("The force readings are smoothed over {} ms.", v.size("time_constant"));
  }
  std::vector<std::string> lookAlikes() const override { return {"time_offset", "motion_lag"}; }
  std::vector<Form> forms(const Signals&) const override {
    std::vector<Form> out;
    for (const int filter : {kOne, kTwo, kMean}) {
      out.push_back(formOf(this,
                           filter == kOne   ? ""
                           : filter == kTwo ? "two stages"
                                            : "mean",
                           {{"time_constant", "ms", kMilli, 0.005, 0.0, 0.8}}));
      out.back().choice = {filter};
    }
    return out;
  }
  int order() const override { return 60; }
  bool changesSensor(const Form&) const override { return true; }
  void sensor(const Form& form, const VectorXd& v, const Signals& signals, Wrenches& w) const override {
    if (v(0) <= 1e-6) return;
    const int stages = form.choice[0] == kTwo ? 2 : 1;
    if (form.choice[0] == kMean)
      w = meanSince(w, 2.0 * v(0), signals.rateHz);
    else
      for (int stage = 0; stage < stages; ++stage) w = onePole(w, v(0) / stages, signals.rateHz);
  }
  /// Of a filter that is none of these: how late it makes readings of a motion that is neither slow nor fast.
  VectorXd modelStd(const Form&, const VectorXd& v) const override { return kFormError * v; }
  double overOwnErrors(const Form&, const VectorXd& v, const Signals&) const override { return overOwnTimes(v(0)); }
  bool mayBeAlignment(const Form&, const VectorXd& v, const Signals& signals) const override {
    return withinAlignment(v(0), signals);
  }

 private:
  enum Filter { kMean = 0, kOne = 1, kTwo = 3 };  // 2, in older files, had the time of each of two stages
};

}  // namespace

std::unique_ptr<Cause> makeLowPassLag() { return std::make_unique<LowPassLag>(); }

}  // namespace heft::diagnosis
