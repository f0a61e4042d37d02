// A load on one axis of the sensor shows on another.
#include "core/base/say.h"
#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/common.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/model/found_values.h"

namespace heft::diagnosis {
namespace {

class Crosstalk final : public Cause {
 public:
  const CauseInfo& info() const override {
    static constexpr CauseInfo kInfo{
        .id = ids::crosstalk,
        .family = Family::sensor,
        .title = heft::toSay("One channel leaks into another (crosstalk)"),
        .check = heft::toSay("Is the sensor's own calibration matrix loaded (serial number)?"),
        .decides = heft::toSay("Tilt the tool so that its weight lies on each axis of the sensor in turn."),
        .looks = heft::toSay("The difference on one channel is a small copy of another channel."),
        .decidingMotion = "tilt-round",
        .effect = "crosstalk"};
    return kInfo;
  }
  std::string sentence(const FoundValues& v) const override {
    const CauseParameter* p = v.strongest();
    if (!p) return {};
    const auto to = p->name.find("_to_");
    return heft::say("{} of {} shows up in {}.", parameterWords(*p), channelWords(channelOf(p->name)),
                     channelWords(to == std::string::npos ? 0 : channelOf(std::string_view(p->name).substr(to + 4))));
  }
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
