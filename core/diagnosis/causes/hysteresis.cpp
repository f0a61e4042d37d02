// The sensor remembers its load: reading a little behind on the way up and on the way down.
#include <algorithm>
#include <cmath>

#include "core/base/say.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/common.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/model/found_values.h"

namespace heft::diagnosis {
namespace {

class Hysteresis final : public Cause {
 public:
  const CauseInfo& info() const override {
    static constexpr CauseInfo kInfo{
        .id = ids::hysteresis,
        .family = Family::sensor,
        .title = heft::toSay("Sensor remembers its load (hysteresis)"),
        .check = heft::toSay("Was the sensor overloaded, glued or pinched? Check its screws."),
        .decides = heft::toSay("Load the sensor slowly up and down in one direction, in small and large steps."),
        .looks = heft::toSay(
            "The difference lags behind the load itself: one value on the way up, another on the way down."),
        .decidingMotion = "tilt-sideways",
        .effect = "hysteresis"};
    return kInfo;
  }
  std::string sentence(const FoundValues& v) const override {
    const CauseParameter* p = v.strongest();
    if (!p) return {};
    const std::string much = plusMinus(std::abs(p->value), p->std);
    if (p->name.starts_with("loop"))
      return heft::say("The sensor remembers its load: loading and unloading differ by {} % of the load's range.",
                       much);
    return heft::say("The sensor remembers {} of its load: it reads differently while it is loaded and unloaded.",
                     p->name.starts_with("memory") ? fmt::format("{} %", much) : parameterWords(*p));
  }
  std::vector<std::string> lookAlikes() const override { return {"coulomb_friction", "low_pass_lag"}; }
  std::vector<Form> forms(const Signals&) const override {
    std::vector<Form> out;
    std::vector<Parameter> each;
    for (int c = 0; c < 6; ++c) each.push_back({channelName(c), "%", 100.0, 0.01, -0.3, 0.3});
    const auto add = [&](const std::string& name, int percent, Kind kind) {
      out.push_back(formOf(this, fmt::format(fmt::runtime(name), percent), each));
      out.back().subset = true;
      out.back().choice = kind == kPlay ? std::vector<int>{percent} : std::vector<int>{percent, kind};
      // The same gauges, so often the same share on all channels.
      out.push_back(formOf(this, out.back().name + ", alike on all channels",
                           {{"memory", "%", 100.0, 0.01, -0.3, 0.3}, {"turning_way", "%", 100.0, 0.05, 0.01, 3.0}}));
      out.back().start(1) = 0.01 * percent;
      out.back().scan = {0};
      out.back().choice = {percent, kind, kAlike};
    };
    for (const int percent : {5, 20, 60}) add("play of {} % of the range", percent, kPlay);
    // A loop of one height that turns at once, such as friction inside the sensor makes.
    Form loop =
        formOf(this, "loop", {{"loop", "%", 100.0, 0.003, -0.1, 0.1}, {"turning_way", "%", 100.0, 0.005, 0.0005, 0.3}});
    loop.start(1) = 0.01;
    loop.scan = {0};
    loop.choice = {1, kPlay, kLoop};
    out.push_back(std::move(loop));
    // What remembers through many small plays: bristles that bend over a way of the load.
    for (const int percent : {15, 40}) add("bristles over {} % of the range", percent, kBristles);
    return out;
  }
  int order() const override { return 50; }
  /// No sensor remembers more: channels that are late, each by another time, look like one that does. Of 22 that were
  /// one, the largest was 7.5 %; of 15 unknown effects that looked like one, eleven had more than this.
  bool plausible(const Form& form, const VectorXd& v, const VectorXd&) const override {
    return v.head(form.subset ? v.size() : 1).cwiseAbs().maxCoeff() < kSmallShare;
  }
  bool changesSensor(const Form&) const override { return true; }
  bool linear(const Form&) const override { return false; }
  void sensor(const Form& form, const VectorXd& v, const Signals& signals, Wrenches& w) const override {
    sensors(form, {&v, 1}, signals, {&w, 1});
  }
  /// What is remembered is worked out once for all that remember as far back.
  void sensors(const Form& form, std::span<const VectorXd> each, const Signals&,
               std::span<Wrenches> wrenches) const override {
    if (each.empty()) return;
    const Wrenches load = wrenches[0];
    Vector6d range = load.rowwise().maxCoeff() - load.rowwise().minCoeff();
    const bool apart = form.choice.size() < 3, loop = !apart && form.choice[2] == kLoop;
    if (!apart && !loop)
      for (const int first : {0, 3}) range.segment<3>(first).setConstant(range.segment<3>(first).maxCoeff());
    const bool bends = form.choice.size() > 1 && form.choice[1] == kBristles;
    Wrenches lag;
    double worked = -1.0;  // Of the range: what `lag` is of
    for (std::size_t i = 0; i < each.size(); ++i) {
      const VectorXd& v = each[i];
      const double way = apart ? 0.01 * form.choice[0] : v(1);
      if (way != worked) lag = bends ? bristles((way * range).cwiseMax(1e-9), load) : play(0.5 * way * range, load);
      worked = way;
      const Vector6d share = apart ? Vector6d(v.head<6>()) : Vector6d(Vector6d::Constant(loop ? v(0) / way : v(0)));
      wrenches[i] = load - share.asDiagonal() * lag;
    }
  }
  /// A loop of a thousandth of the range is what corners of the motion leave, and less than a sensor is known by.
  double overOwnErrors(const Form& form, const VectorXd& v, const Signals&) const override {
    constexpr double kOwn = 0.0012;  // Clean recordings had 0.0002 to 0.0011
    const bool each = form.choice.size() < 3, loop = !each && form.choice[2] == kLoop;
    const double height = each ? 0.01 * form.choice[0] * v.cwiseAbs().maxCoeff() : std::abs(loop ? v(0) : v(0) * v(1));
    return height / kOwn;
  }
  /// 136 clean recordings of five simulators had no memory that much speaks for.
  double enoughIfPlain(const Form&) const override { return 0.05; }

 private:
  enum Kind { kPlay, kBristles, kAlike, kLoop };

  /// How far each is bent: they bend with the load and slip as soon as they are bent all the way, which takes `reach`.
  static Wrenches bristles(const Vector6d& reach, const Wrenches& load) {
    using Channels = Eigen::Array<double, 6, 1>;
    const Channels per = reach.cwiseInverse();
    Wrenches out(6, load.cols());
    Channels bend = Channels::Zero(), last = load.col(0);
    for (Eigen::Index k = 0; k < load.cols(); ++k) {
      // All channels at once: one at a time, each instant would wait for the one before.
      const Channels u = load.col(k), way = (u - last) * per, x = way.abs();
      // exp(-x), but for 0.4 % where a load goes all the way between two instants.
      const Channels left = 1.0 / (1.0 + x * (1.0 + x * (1.0 / 2.0 + x * (1.0 / 6.0 + x / 24.0))));
      const Channels end = (way > 0.0).template cast<double>() - (way < 0.0).template cast<double>();
      bend = end + (bend - end) * left;
      last = u;
      out.col(k) = bend * reach.array();
    }
    return out;
  }
  /// How far the middle of a play of `half` to either side is behind its input: what a dead band remembers.
  static Wrenches play(const Vector6d& half, const Wrenches& load) {
    Wrenches out(6, load.cols());
    Vector6d middle = load.col(0);
    for (Eigen::Index k = 0; k < load.cols(); ++k) {
      const Vector6d u = load.col(k);
      middle = middle.cwiseMax(u - half).cwiseMin(u + half);
      out.col(k) = u - middle;
    }
    return out;
  }
};

}  // namespace

std::unique_ptr<Cause> makeHysteresis() { return std::make_unique<Hysteresis>(); }

}  // namespace heft::diagnosis
