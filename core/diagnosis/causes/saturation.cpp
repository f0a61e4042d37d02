// A channel gives way near the end of its range. One that is cut off flat is seen directly (sample_tests.h).
#include "core/base/say.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/common.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/model/found_values.h"

namespace heft::diagnosis {
namespace {

class Saturation final : public Cause {
 public:
  const CauseInfo& info() const override {
    static constexpr CauseInfo kInfo{
        .id = ids::saturation,
        .family = Family::sensor,
        .title = heft::toSay("Sensor at its limit (saturation)"),
        .check = heft::toSay("Use a range that fits the load, and check the sensor's zero."),
        .decides = heft::toSay("Repeat the motion more slowly, or with a lighter tool."),
        .looks = heft::toSay("The measured curve is cut off flat at the top."),
        .effect = "saturation"};
    return kInfo;
  }
  std::string sentence(const FoundValues& v) const override {
    if (v.direct) return heft::say("The sensor reached the end of its range in {} % of the readings.", v.size("share"));
    const auto loss = std::find_if(v.parameters.begin(), v.parameters.end(),
                                   [](const CauseParameter& p) { return p.name.starts_with("loss_"); });
    return loss == v.parameters.end() ? std::string()
                                      : heft::say("Near the end of its range the channel {} reads {} % too little.",
                                                  channelWords(channelOf(std::string_view(loss->name).substr(5))),
                                                  plusMinus(loss->value, loss->std));
  }
  std::vector<std::string> lookAlikes() const override { return {"gain_error", "contact"}; }
  std::vector<Form> forms(const Signals&) const override {
    std::vector<Form> out;
    for (int c = 0; c < 6; ++c)
      for (const int end : {1, -1}) {
        // Of what goes beyond the knee, and where that is: as a share of the range, from its end.
        out.push_back(formOf(this, fmt::format("{} {}", channelName(c), end > 0 ? "upwards" : "downwards"),
                             {{fmt::format("loss_{}", channelName(c)), "%", 100.0, 0.1, 0.0, 1.05},
                              {fmt::format("knee_{}", channelName(c)), "%", 100.0, 0.05, 0.02, 0.6}}));
        out.back().start(1) = 0.25;
        out.back().scan = {0};
        out.back().choice = {c, end};
      }
    return out;
  }
  int order() const override { return 45; }
  /// A channel that gives way near the end of its range hardly does so: one whose gain is another one for half of its
  /// range looks like that. Of two that were soft at their end each lost more than 90 %, of nine unknown effects that
  /// looked like it six less than this.
  bool plausible(const Form&, const VectorXd& v, const VectorXd&) const override { return v(0) > kMinorShare; }
  bool changesSensor(const Form&) const override { return true; }
  /// A channel that stays far from the end of its range is not at its limit. The zero may have been taken off the
  /// readings, so that the end of the range is not known better than to a part of it.
  double doubt(const Form& form, const VectorXd&, const Signals& signals) const override {
    if (!signals.range || signals.readings.cols() == 0) return 0.0;
    const auto channel = signals.readings.row(form.choice[0]);
    const double most = form.choice[1] > 0 ? channel.maxCoeff() : -channel.minCoeff();
    return most < kMajority * (*signals.range)(form.choice[0]) ? kNever : 0.0;
  }
  bool linear(const Form&) const override { return false; }
  void sensor(const Form& form, const VectorXd& v, const Signals&, Wrenches& w) const override {
    auto channel = w.row(form.choice[0]);
    const double end = form.choice[1], range = channel.maxCoeff() - channel.minCoeff();
    const double knee = (end > 0.0 ? channel.maxCoeff() : -channel.minCoeff()) - v(1) * range;
    channel -= (end * v(0) * (end * channel.array() - knee).max(0.0)).matrix();
  }
};

}  // namespace

std::unique_ptr<Cause> makeSaturation() { return std::make_unique<Saturation>(); }

}  // namespace heft::diagnosis
