// A low-pass filter inside the sensor or its driver: T y' + y = w, T / 2 twice, or the mean over the last 2 T: by T late, all.
#include <algorithm>
#include <array>
#include <cmath>

#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/common.h"

namespace heft::diagnosis {
namespace {

/// Mean over the last 2 `lag` seconds of what was constant before it started: Gauss' three points in each part of them.
Wrenches meanSince(const Wrenches& w, double lag, double rateHz) {
  constexpr double kPart = 0.04;  // [s] Faster than 25 Hz nothing moves here
  constexpr std::array<double, 3> kNode{0.1127016653792583, 0.5, 0.8872983346207417}, kWeight{5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
  const int parts = std::max(1, static_cast<int>(std::ceil(2.0 * lag / kPart)));
  const double part = 2.0 * lag / parts;
  Wrenches out = Wrenches::Zero(6, w.cols());
  for (int i = 0; i < parts; ++i)
    for (std::size_t j = 0; j < kNode.size(); ++j) out += (kWeight[j] / parts) * delayed(w, (i + kNode[j]) * part, rateHz);
  return out;
}

class LowPassLag final : public Cause {
 public:
  std::string_view id() const override { return "low_pass_lag"; }
  std::vector<std::string> lookAlikes() const override { return {"time_offset", "motion_lag"}; }
  std::vector<Form> forms(const Signals&) const override {
    std::vector<Form> out;
    for (const int stages : {1, 2, kMean}) {
      out.push_back(formOf(this, stages == 1 ? "" : stages == 2 ? "two stages" : "mean",
                           {{"time_constant", "ms", kMilli, 0.005, 0.0, 0.8}}));
      out.back().choice = {stages};
    }
    return out;
  }
  int order() const override { return 60; }
  bool changesSensor() const override { return true; }
  void sensor(const Form& form, const VectorXd& v, const Signals& signals, Wrenches& w) const override {
    if (form.choice[0] == kMean) {
      if (v(0) > 1e-6) w = meanSince(w, v(0), signals.rateHz);
      return;
    }
    for (int stage = 0; v(0) > 1e-6 && stage < form.choice[0]; ++stage) w = onePole(w, v(0) / form.choice[0], signals.rateHz);
  }

 private:
  static constexpr int kMean = 0;
};

}  // namespace

std::unique_ptr<Cause> makeLowPassLag() { return std::make_unique<LowPassLag>(); }

}  // namespace heft::diagnosis
