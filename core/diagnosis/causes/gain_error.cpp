// One channel of the sensor reads too much or too little: either way, or more to one side and less to the other. Or all
// forces do against the torques: with the payload free, that is the sensor's place shifted along the way to the centre
// of mass. Or gains change while the sensor warms up.
#include <limits>

#include "core/base/say.h"
#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/common.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/model/found_values.h"

namespace heft::diagnosis {
namespace {

class GainError final : public Cause {
 public:
  const CauseInfo& info() const override {
    static constexpr CauseInfo kInfo{
        .id = ids::gainError,
        .family = Family::sensor,
        .title = heft::toSay("One channel reads wrong (gain error)"),
        .check = heft::toSay("Hang a known weight from each side of the sensor; check its calibration file."),
        .decides = heft::toSay(
            "Tilt the tool so that its weight lies on each axis in turn. Equal gains on all axes need a scale."),
        .looks = heft::toSay("The difference on one channel is a small copy of that channel itself."),
        .decidingMotion = "tilt-round",
        .effect = "gain_error",
        .scalesWithLoad = true};
    return kInfo;
  }
  std::string sentence(const FoundValues& v) const override {
    const CauseParameter* p = v.strongest();
    if (!p) return {};
    const std::string channel = p->name.substr(p->name.find('_') + 1, 2);
    if (const CauseParameter* asymmetry = v.find("asymmetry_" + channel)) {
      const CauseParameter* gain = v.find("gain_" + channel);
      const double both = gain != nullptr ? gain->value : 0.0;
      return heft::say("The channel {} is {:+.1f} % off in one direction and {:+.1f} % in the other.",
                       channelWords(channelOf(channel)), both + asymmetry->value, both - asymmetry->value);
    }
    const std::string much = plusMinus(std::abs(p->value), p->std);
    if (p->name.starts_with("gain_force"))
      return p->value > 0.0 ? heft::say("All forces read {} % too much compared with the torques.", much)
                            : heft::say("All forces read {} % too little compared with the torques.", much);
    if (p->name == "growth")
      return heft::say("The gain of all channels changes by {:+.1f} % during the recording, as when a sensor warms up.",
                       p->value);
    if (p->name.starts_with("growth_"))
      return heft::say("The gain of {} changes by {:+.1f} % during the recording, as when a sensor warms up.",
                       channelWords(channelOf(std::string_view(p->name).substr(7))), p->value);
    const std::string which = channelWords(channelOf(std::string_view(p->name).substr(5)));
    return p->value > 0.0 ? heft::say("The channel {} reads {} % too much.", which, much)
                          : heft::say("The channel {} reads {} % too little.", which, much);
  }
  std::vector<std::string> lookAlikes() const override { return {"crosstalk", "lever_arm"}; }
  std::vector<Form> forms(const Signals&) const override {
    std::vector<Form> out;
    for (int c = 0; c < 6; ++c) {
      out.push_back(
          formOf(this, channelName(c), {{fmt::format("gain_{}", channelName(c)), "%", 100.0, 0.02, -0.7, 0.7}}));
      out.back().choice = {c};
    }
    for (int c = 0; c < 6; ++c) {
      out.push_back(formOf(this, fmt::format("{} by its sign", channelName(c)),
                           {{fmt::format("gain_{}", channelName(c)), "%", 100.0, 0.02, -0.7, 0.7},
                            {fmt::format("asymmetry_{}", channelName(c)), "%", 100.0, 0.02, -0.7, 0.7, false, false}}));
      out.back().subset = true;  // A load that pushes one way only does not tell the two apart.
      out.back().choice = {c, kBySign};
    }
    out.push_back(formOf(this, "all forces", {{"gain_force", "%", 100.0, 0.02, -0.7, 0.7}}));
    out.back().choice = {kForces};
    // A sensor that warms up.
    for (const double time : {3.0, 8.0, 25.0}) {
      std::vector<Parameter> parameters;
      for (int c = 0; c < 6; ++c)
        parameters.push_back({fmt::format("growth_{}", channelName(c)), "%", 100.0, 0.02, -0.7, 0.7});
      for (const bool alike : {false, true}) {
        if (alike) parameters = {{"growth", "%", 100.0, 0.02, -0.7, 0.7}};
        parameters.push_back({"warm_up", "s", 1.0, 0.3 * time, 1.0, kSteadily, false, false});
        Form form = formOf(this, alike ? "growing alike" : "growing", parameters);
        form.start(form.start.size() - 1) = time;
        form.scan.pop_back();
        form.subset = !alike;
        form.alone = form.rare = true;
        form.choice = {alike ? kGrowingAlike : kGrowing};
        out.push_back(std::move(form));
      }
    }
    return out;
  }
  int order() const override { return 30; }
  bool changesSensor(const Form&) const override { return true; }
  bool isMatrix(const Form& form) const override { return !bySign(form) && form.choice[0] < kGrowing; }
  /// Whoever bolts a sensor on is more often wrong about its place than its maker is about newtons, and loads change
  /// more often than gains.
  double doubt(const Form& form, const VectorXd&, const Signals&) const override {
    return form.choice[0] >= kForces ? 20.0 : 0.0;
  }
  void sensor(const Form& form, const VectorXd& v, const Signals& signals, Wrenches& w) const override {
    if (form.choice[0] >= kGrowing) {
      const Vector6d growth = form.choice[0] == kGrowing ? Vector6d(v.head<6>()) : Vector6d(Vector6d::Constant(v(0)));
      const double T = v(v.size() - 1), all = -std::expm1(-signals.duration() / T),
                   step = std::exp(-1.0 / (signals.rateHz * T));
      double left = 1.0;
      for (Eigen::Index k = 0; k < w.cols(); ++k, left *= step)
        w.col(k) += (1.0 - left) / all * growth.cwiseProduct(w.col(k));
      return;
    }
    if (form.choice[0] == kForces) {
      w.topRows<3>() *= 1.0 + v(0);
      return;
    }
    auto row = w.row(form.choice[0]);
    if (bySign(form))
      row += v(0) * row + v(1) * row.cwiseAbs();
    else
      row *= 1.0 + v(0);
  }
  bool linear(const Form& form) const override { return !bySign(form); }

 private:
  static constexpr int kForces = 6, kGrowing = 7, kGrowingAlike = 8;  ///< form.choice: instead of a channel
  /// [s] A gain may as well grow all the time.
  static constexpr double kSteadily = std::numeric_limits<double>::infinity();
  static constexpr int kBySign = 1;  ///< Second in form.choice, after the channel

  static bool bySign(const Form& form) { return form.choice.size() > 1; }
};

}  // namespace

std::unique_ptr<Cause> makeGainError() { return std::make_unique<GainError>(); }

}  // namespace heft::diagnosis
