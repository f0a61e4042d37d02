// One channel of the sensor reads too much or too little.
#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/common.h"

namespace heft::diagnosis {
namespace {

class GainError final : public Cause {
 public:
  std::string_view id() const override { return "gain_error"; }
  Words words() const override {
    return {"Sensor reads too much or too little",
            "Hang a known weight from each side of the sensor and check its calibration file.",
            "Tilt the tool so that its weight lies on each axis of the sensor in turn. A gain that is the same on all axes "
            "cannot be told from a heavier tool by any motion: weigh the tool.",
            {"crosstalk", "lever_arm"}};
  }
  std::string sentence(const Form& form, const VectorXd& v, const VectorXd& std) const override {
    return fmt::format("The sensor's channel {} reads {} % {} than it should, against the others.",
                       channelName(form.choice[0]), plusMinus(std::abs(v(0)) * 100.0, std(0) * 100.0),
                       v(0) > 0.0 ? "more" : "less");
  }
  std::vector<Form> forms(const Signals&) const override {
    std::vector<Form> out;
    for (int c = 0; c < 6; ++c) {
      out.push_back(formOf(this, channelName(c), {{fmt::format("gain_{}", channelName(c)), "%", 100.0, 0.02, -0.7, 0.7}}));
      out.back().choice = {c};
    }
    return out;
  }
  int order() const override { return 30; }
  bool changesSensor() const override { return true; }
  void sensor(const Form& form, const VectorXd& v, const Signals&, Wrenches& w) const override {
    w.row(form.choice[0]) *= 1.0 + v(0);
  }
};

}  // namespace

std::unique_ptr<Cause> makeGainError() { return std::make_unique<GainError>(); }

}  // namespace heft::diagnosis
