// From some moment on the tool is heavier or lighter.
#include "core/base/say.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/common.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/model/forward_model.h"
#include "core/diagnosis/model/found_values.h"

namespace heft::diagnosis {
namespace {

class PayloadChange final : public Cause {
 public:
  const CauseInfo& info() const override {
    static constexpr CauseInfo kInfo{
        .id = ids::payloadChange,
        .family = Family::load,
        .title = heft::toSay("Load changed during the recording"),
        .check = heft::toSay("Was a part picked up or put down? Mark only the segment that you mean."),
        .decides =
            heft::toSay("Turn the tool to another pose after the change: a load turns with gravity, a jump does not."),
        .looks = heft::toSay("From some point on there is a residual that rotates with the tool, like a weight."),
        .decidingMotion = "tilt-sideways",
        .effect = "payload_change",
        .scalesWithLoad = true};
    return kInfo;
  }
  std::string sentence(const FoundValues& v) const override {
    if (const CauseParameter* last = v.find("after_pose")) {
      const std::string pose = numberWords(last->value, 0);
      return v.value("mass") > 0.0 ? heft::say("After pose {} the load was {} g heavier.", pose, v.size("mass"))
                                   : heft::say("After pose {} the load was {} g lighter.", pose, v.size("mass"));
    }
    if (v.direct)
      return v.when.size() == 1
                 ? heft::say("From {} to {} s the tool carried {} g more.", numberWords(v.when[0].first, 1),
                             numberWords(v.when[0].second, 1), v.size("mass"))
                 : heft::say("The tool carried {} g more {} times, first from {} to {} s.", v.size("mass"),
                             v.when.size(), numberWords(v.when[0].first, 1), numberWords(v.when[0].second, 1));
    if (v.value("duration") > 1.0) {
      const std::string from = numberWords(v.value("time") - 0.5 * v.value("duration"), 1),
                        to = numberWords(v.value("time") + 0.5 * v.value("duration"), 1);
      return v.value("mass") > 0.0
                 ? heft::say("From {} to {} s the load became {} g heavier.", from, to, v.size("mass"))
                 : heft::say("From {} to {} s the load became {} g lighter.", from, to, v.size("mass"));
    }
    if (v.find("mass") && std::abs(v.value("mass")) < 2.0 * v.find("mass")->std)
      return heft::say("At {} s the load moved on the tool; its weight hardly changed ({} g).",
                       numberWords(v.value("time"), 1), plusMinus(v.value("mass"), v.find("mass")->std));
    return v.value("mass") > 0.0
               ? heft::say("At {} s the load became {} g heavier.", numberWords(v.value("time"), 1), v.size("mass"))
               : heft::say("At {} s the load became {} g lighter.", numberWords(v.value("time"), 1), v.size("mass"));
  }
  std::vector<std::string> lookAlikes() const override { return {"sensor_bias", "contact", "gain_error"}; }
  std::vector<Form> forms(const Signals& signals) const override {
    std::vector<Form> out;
    const auto [from, to] = timesForChange(signals);
    const double T = signals.duration();
    const auto change = [&, from = from, to = to](const char* name, double t, double duration, double longest) {
      Form form = formOf(this, name,
                         {{"time", "s", 1.0, 0.1, from, to},
                          {"mass", "g", kMilli, 0.03, -20.0, 20.0},
                          {"moment_x", "kg m", 1.0, 0.003, -5.0, 5.0},
                          {"moment_y", "kg m", 1.0, 0.003, -5.0, 5.0},
                          {"moment_z", "kg m", 1.0, 0.003, -5.0, 5.0},
                          {"duration", "s", 1.0, 0.1, 0.0, longest, true}});
      form.start(0) = t;
      form.start(5) = duration;
      form.scan = {1, 2, 3, 4};
      return form;
    };
    for (const double t : momentsForChange(signals)) {
      out.push_back(change("", t, 0.05, 2.0));
      out.back().local = out.back().atOnce = true;
    }
    // As in pouring: its middle and how long it takes move with the rest.
    for (const double part : {0.15, 0.35, 0.7})
      for (const double middle : {0.3, 0.5, 0.7})
        out.push_back(change("by and by", signals.startTime + middle * T, part * T, 2.0 * T));
    return out;
  }
  void force(const Form& form, const VectorXd& v, const Signals& signals, const Kinematics& kin,
             Wrenches& w) const override {
    const double m = v(1);
    const Vector3d h = v.segment<3>(2);
    const double size = m * m + h.squaredNorm() / (kToolReach * kToolReach);
    const Vector3d place = size > 0.0 ? Vector3d(m / size * h) : Vector3d(Vector3d::Zero());
    for (Eigen::Index k = 0; k < w.cols(); ++k) {
      const double gone = stepAt(signals.time(k), v(0), v(5)),
                   share = form.atOnce ? gone * gone * (3.0 - 2.0 * gone) : gone;
      if (share <= 0.0) continue;
      const Vector3d s = kin.specificForce.col(k), o = kin.omega.col(k), a = kin.alpha.col(k);
      w.col(k).head<3>() += share * (m * s + a.cross(h) + o.cross(o.cross(h)));
      w.col(k).tail<3>() += share * h.cross(s);
      w.col(k).tail<3>() += share * place.cross(a.cross(h) + o.cross(o.cross(h)));
    }
  }
  /// What came or went lies where the tool is. Of 87 that did, the farthest was at 0.5 m; of 26 other things that
  /// looked like it, such as a weight that slides, eight acted at 2 m and more.
  bool plausible(const Form&, const VectorXd& v, const VectorXd& std) const override {
    return v.segment<3>(2).norm() - std.segment<3>(2).norm() <
           2.0 * kToolReach * (std::abs(v(1)) + kDeviations * std(1));
  }
  std::vector<std::pair<double, double>> when(const Form&, const VectorXd& v, const Signals& signals) const override {
    return {wholeAfter(v(0) - 0.5 * v(5), signals)};
  }
};

}  // namespace

std::unique_ptr<Cause> makePayloadChange() { return std::make_unique<PayloadChange>(); }

}  // namespace heft::diagnosis
