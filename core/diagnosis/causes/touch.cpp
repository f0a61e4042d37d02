// Something pushed for a moment, or held on to the tool for some seconds. Strong contact is set aside before anything
// is fitted; this finds the light one.
#include "core/base/say.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/common.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/model/found_values.h"

namespace heft::diagnosis {
namespace {

class Touch final : public Cause {
 public:
  const CauseInfo& info() const override {
    static constexpr CauseInfo kInfo{
        .id = ids::contact,
        .family = Family::contact,
        .title = heft::toSay("The tool touched something (contact)"),
        .check = heft::toSay("Was the tool set down, bumped or held?"),
        .decides = heft::toSay("Repeat the motion without touching anything."),
        .looks = heft::toSay("Short, large differences at a few moments; between them everything fits."),
        .effect = "contact"};
    return kInfo;
  }
  std::string sentence(const FoundValues& v) const override {
    if (!v.parameters.empty() && v.parameters.front().name.starts_with("pose")) {
      std::string poses;
      for (const CauseParameter& p : v.parameters)
        if (p.name.starts_with("pose")) poses += (poses.empty() ? "" : ", ") + numberWords(p.value, 0);
      return heft::say("These poses do not fit the others, by up to {} N: {}. The tool touched something, or moved.",
                       numberWords(v.value("peak_force"), 2), poses);
    }
    const double most = v.value("peak_force");
    const std::string peak = numberWords(most, most < 0.95 ? 2 : 1);
    return v.when.size() == 1 ? heft::say("The tool touched something from {} to {} s, with up to {} N.",
                                          numberWords(v.when[0].first, 1), numberWords(v.when[0].second, 1), peak)
                              : heft::say("The tool touched something {} times, with up to {} N.", v.when.size(), peak);
  }
  std::vector<std::string> lookAlikes() const override { return {"payload_change", "sensor_bias"}; }
  std::vector<Form> forms(const Signals& signals) const override {
    std::vector<Form> out;
    const double from = signals.startTime + 0.5, to = signals.startTime + signals.duration() - 0.5;
    const auto add = [&](double lasts, double longest, bool held) {
      for (double t = from + 0.5 * lasts; t < to - 0.5 * lasts; t += (held ? 0.25 : 0.5) * lasts) {
        std::vector<Parameter> parameters{{"time", "s", 1.0, 0.1, from, to}};
        for (const char* axis : {"force_x", "force_y", "force_z"})
          parameters.push_back({axis, "N", 1.0, 0.3, -100.0, 100.0});
        for (const char* axis : {"torque_x", "torque_y", "torque_z"})
          parameters.push_back({axis, "N m", 1.0, 0.02, -20.0, 20.0});
        parameters.push_back({"duration", "s", 1.0, 0.1, kMoment, longest});
        if (held) parameters.push_back({"flank", "%", 100.0, 0.1, 0.02, 1.0, true, false});
        Form form = formOf(this, held ? "held" : "", std::move(parameters));
        form.start(0) = t;
        form.start(7) = lasts;
        if (held) form.start(8) = 0.2;
        form.scan = {1, 2, 3, 4, 5, 6};
        form.choice = {held ? kHeld : kBump};
        form.local = true;
        out.push_back(form);
      }
    };
    for (const double lasts : {0.5, 1.2}) add(lasts, kBriefly, false);
    add(2.2, kBriefly, true);
    return out;
  }
  bool feelsMotion() const override { return false; }
  void force(const Form& form, const VectorXd& v, const Signals& signals, const Kinematics& kin,
             Wrenches& w) const override {
    const std::vector<Matrix3d>& R_BS = axesOf(signals, kin);
    const auto [from, to] = stretch(v);
    const auto first =
        std::max<Eigen::Index>(0, static_cast<Eigen::Index>((from - signals.startTime) * signals.rateHz));
    for (Eigen::Index k = first; k < w.cols() && signals.time(k) < to; ++k) {
      if (signals.time(k) < from) continue;
      // Of the way to its middle so far, and the share of it in which a push grows: a bump is all flank.
      const double way = 2.0 * std::min(signals.time(k) - from, to - signals.time(k)) / (to - from),
                   flank = form.choice[0] == kHeld ? v(8) : 1.0;
      const double level = std::pow(std::sin(0.5 * std::numbers::pi * std::min(1.0, way / flank)), 2);
      const Matrix3d& R = R_BS[static_cast<std::size_t>(k)];
      // The tool is pushed by F (base axes), so the sensor holds it with -F; its torque turns with the tool.
      w.col(k).head<3>() -= level * (R.transpose() * v.segment<3>(1));
      w.col(k).tail<3>() += level * v.segment<3>(4);
    }
  }
  std::vector<std::pair<double, double>> when(const Form&, const VectorXd& v, const Signals&) const override {
    return {stretch(v)};
  }

 private:
  enum { kBump, kHeld };  ///< form.choice

  static std::pair<double, double> stretch(const VectorXd& v) { return {v(0) - 0.5 * v(7), v(0) + 0.5 * v(7)}; }
};

}  // namespace

std::unique_ptr<Cause> makeTouch() { return std::make_unique<Touch>(); }

}  // namespace heft::diagnosis
