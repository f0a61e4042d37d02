// A load on one axis of the sensor shows on another.
#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/common.h"

namespace heft::diagnosis {
namespace {

class Crosstalk final : public Cause {
 public:
  std::string_view id() const override { return "crosstalk"; }
  std::vector<std::string> lookAlikes() const override { return {"sensor_rotation", "gain_error"}; }
  std::vector<Form> forms(const Signals&) const override {
    std::vector<Form> out;
    for (int to = 0; to < 6; ++to)
      for (int from = 0; from < 6; ++from) {
        if (to == from) continue;
        const bool same = (to < 3) == (from < 3);
        Parameter p{fmt::format("{}_to_{}", channelName(from), channelName(to)), "%", 100.0, 0.02, -0.5, 0.5};
        if (!same && to >= 3) p = {p.name, "mm", kMilli, 0.001, -0.05, 0.05};
        if (!same && to < 3) p = {p.name, "1/m", 1.0, 0.3, -10.0, 10.0};
        out.push_back(formOf(this, p.name, {p}));
        out.back().choice = {to, from};
      }
    return out;
  }
  int order() const override { return 40; }
  bool changesSensor(const Form&) const override { return true; }
  bool isMatrix(const Form&) const override { return true; }
  void sensor(const Form& form, const VectorXd& v, const Signals&, Wrenches& w) const override {
    w.row(form.choice[0]) += v(0) * w.row(form.choice[1]);
  }
};

}  // namespace

std::unique_ptr<Cause> makeCrosstalk() { return std::make_unique<Crosstalk>(); }

}  // namespace heft::diagnosis
