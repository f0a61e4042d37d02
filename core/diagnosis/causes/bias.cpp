// The sensor's zero moves: slowly, or at once.
#include <algorithm>
#include <iterator>
#include <memory>
#include <mutex>
#include <utility>

#include "core/base/say.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/causes/catalogue.h"
#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/common.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/model/found_values.h"
#include "core/math/linear_algebra.h"

namespace heft::diagnosis {
namespace {

double sizeOf(int channel) { return channel < 3 ? 0.1 : 0.005; }
const char* unitOf(int channel) { return channel < 3 ? "N" : "N m"; }

constexpr int kHalfWaves = 10;
using Waves = Eigen::Matrix<double, kHalfWaves, Eigen::Dynamic, Eigen::RowMajor>;

/// k half waves over so many instants, k = 1 .. kHalfWaves. Those of the last number asked for are kept: a fit needs
/// the same ones all the time.
std::shared_ptr<const Waves> wavesOver(Eigen::Index instants) {
  static std::mutex mutex;
  static std::shared_ptr<const Waves> latest;
  const std::lock_guard lock(mutex);
  if (latest && latest->cols() == instants) return latest;
  Waves waves(kHalfWaves, instants);
  for (Eigen::Index i = 0; i < instants; ++i)
    for (int k = 0; k < kHalfWaves; ++k)
      waves(k, i) =
          std::cos(std::numbers::pi * (k + 1) * (static_cast<double>(i) + 0.5) / static_cast<double>(instants));
  latest = std::make_shared<const Waves>(std::move(waves));
  return latest;
}

class BiasDrift final : public Cause {
  enum Course { kSteady, kSettling, kCurved, kRamp, kBoth, kSetsIn, kAnyCourse };  // form.choice

 public:
  const CauseInfo& info() const override {
    static constexpr CauseInfo kInfo{
        .id = ids::biasDrift,
        .family = Family::sensorZero,
        .title = heft::toSay("Sensor zero drifts (bias drift)"),
        .check = heft::toSay("Let the sensor warm up for half an hour, avoid draughts and re-zero often."),
        .decides = heft::toSay("Come back to the same pose three times: a drift reads differently each time."),
        .looks = heft::toSay("The difference rises or falls slowly over the whole recording, whatever the motion."),
        .decidingMotion = "tilt-round",
        .effect = "bias_drift",
        .zeroMoves = true};
    return kInfo;
  }
  std::string sentence(const FoundValues& v) const override {
    const CauseParameter* p = v.strongest();
    if (!p) return {};
    const std::string channel = channelWords(channelOf(p->name)), size = plusMinus(p->value, p->std);
    if (const auto per = p->unit.find("/pose"); per != std::string::npos)
      return heft::say("The sensor's zero drifts: {} by {} {} from each pose to the next.", channel, size,
                       p->unit.substr(0, per));
    if (p->unit.ends_with("/s"))
      return heft::say("The sensor's zero drifts: {} by {} {} per second.", channel, size,
                       p->unit.substr(0, p->unit.size() - 2));
    if (v.find("time_constant") && v.find("time"))
      return heft::say("From {} s on, the sensor's zero drifts until it settles: {} by {} {}.",
                       numberWords(v.value("time"), 1), channel, size, p->unit);
    if (v.find("course_w4") || v.find("course_w5"))
      return heft::say("The sensor's zero drifts back and forth: {} by {} {} in total.", channel,
                       plusMinus(std::abs(p->value), p->std), p->unit);
    return heft::say("The sensor's zero drifts until it settles: {} by {} {}.", channel, size, p->unit);
  }
  std::vector<std::string> lookAlikes() const override { return {"payload_change", "sensor_bias"}; }
  std::vector<Form> forms(const Signals& signals) const override {
    std::vector<Form> out;
    const double T = std::max(1.0, signals.duration());
    const auto drift = [&](const char* suffix, double factor) {
      std::vector<Parameter> parameters;
      for (int c = 0; c < 6; ++c)
        parameters.push_back({fmt::format("{}{}", channelName(c), suffix), fmt::format("{}/s", unitOf(c)), 1.0,
                              sizeOf(c) * factor / T, -200.0 * sizeOf(c) / T, 200.0 * sizeOf(c) / T});
      return parameters;
    };
    out.push_back(formOf(this, "", drift("", 1.0)));
    out.back().subset = true;
    out.back().choice = {kSteady};
    std::vector<Parameter> levels;  // How far it goes in all
    for (int c = 0; c < 6; ++c)
      levels.push_back({channelName(c), unitOf(c), 1.0, sizeOf(c), -200.0 * sizeOf(c), 200.0 * sizeOf(c)});
    // `beside` stand behind the levels: what bends them, with where its search starts, and then what scales them, too.
    const auto add = [&](const char* name, Course course, std::vector<Parameter> beside,
                         const std::vector<double>& starts) {
      std::vector<Parameter> parameters = levels;
      std::ranges::move(beside, std::back_inserter(parameters));
      Form form = formOf(this, name, parameters);
      form.scan = {0, 1, 2, 3, 4, 5};
      for (std::size_t i = 6; i < parameters.size(); ++i) {
        if (i < 6 + starts.size())
          form.start(static_cast<Eigen::Index>(i)) = starts[i - 6];
        else
          form.scan.push_back(static_cast<int>(i));
      }
      form.subset = true;
      form.choice = {course};
      out.push_back(std::move(form));
    };
    for (const double part : {0.12, 0.35})
      add("settling", kSettling, {{"time_constant", "s", 1.0, 0.1 * T, 0.01 * T, 3.0 * T}}, {part * T});
    // Fast at first and slowly for the rest of the time, as where both a gauge and the tool around it warm up.
    for (const double part : {0.05, 0.15}) {
      std::vector<Parameter> beside{{"time_constant", "s", 1.0, 0.1 * T, 0.01 * T, 0.5 * T}};
      std::ranges::move(drift("_slope", 1.0), std::back_inserter(beside));
      add("settling and steady", kBoth, std::move(beside), {part * T});
    }
    // From one level to another, such as that of a sensor that warms up for a while.
    for (const auto& [from, lasts] : {std::pair{0.0, 0.3}, {0.0, 0.6}, {0.3, 0.3}, {0.3, 0.6}, {0.6, 0.3}})
      add("from one level to another", kRamp,
          {{"duration", "s", 1.0, 0.1 * T, 0.03 * T, T, false, false},
           {"time", "s", 1.0, 0.1 * T, 0.0, 0.95 * T, true, false}},
          {lasts * T, from * T});
    // From a moment on, such as that at which something was switched on that warms the sensor.
    for (const double from : {0.2, 0.4, 0.6})
      add("from a moment on", kSetsIn,
          {{"time_constant", "s", 1.0, 0.1 * T, 0.03 * T, 0.5 * T}, {"time", "s", 1.0, 0.1 * T, 0.05 * T, 0.9 * T}},
          {0.15 * T, from * T});
    auto curved = drift("", 1.0);
    for (const auto& p : drift("_bend", 1.0)) curved.push_back(p);
    out.push_back(formOf(this, "curved", curved));
    out.back().subset = true;
    out.back().choice = {kCurved};
    for (int strongest = 1; strongest <= kCourseWaves; ++strongest) out.push_back(anyCourse(levels, strongest));
    return out;
  }
  int order() const override { return 80; }
  bool addsToReadings() const override { return true; }
  void readings(const Form& form, const VectorXd& v, const Signals& signals, Wrenches& w) const override {
    const double T = signals.duration();
    if (form.choice[0] == kAnyCourse) {
      const Eigen::RowVectorXd course = courseOf(form, v, signals);
      if (const double range = course.maxCoeff() - course.minCoeff(); range > 0.0) w += v.head<6>() / range * course;
      return;
    }
    for (Eigen::Index k = 0; k < w.cols(); ++k) {
      const double t = static_cast<double>(k) / signals.rateHz;
      if (form.choice[0] == kSettling || form.choice[0] == kBoth) {
        w.col(k) -= std::expm1(-t / v(6)) * v.head<6>();
        if (form.choice[0] == kBoth) w.col(k) += t * v.tail<6>();
        continue;
      }
      if (form.choice[0] == kSetsIn) {
        w.col(k) -= std::expm1(-std::max(0.0, t - v(7)) / v(6)) * v.head<6>();
        continue;
      }
      if (form.choice[0] == kRamp) {
        w.col(k) += std::clamp((t - v(7)) / v(6), 0.0, 1.0) * v.head<6>();
        continue;
      }
      w.col(k) += t * v.head<6>();
      // The bend has neither mean nor slope over the recording.
      if (form.choice[0] == kCurved) w.col(k) += (t * t / T - t + T / 6.0) * v.tail<6>();
    }
  }

  /// What one channel alone does may as well be a walk.
  bool possible(const Form& form, const VectorXd& v, const VectorXd& std) const override {
    return form.choice[0] != kAnyCourse || (v.head<6>().array().abs() > kStandsOut * std.head<6>().array()).count() > 1;
  }

  /// Where all channels of a walk go one way, and what they do is what one of them does.
  std::vector<std::pair<Form, VectorXd>> followedBy(const Eigen::Matrix<double, 6, kHalfWaves>& walk,
                                                    const Signals& signals) const {
    Vector6d usual;
    for (int c = 0; c < 6; ++c) usual(c) = sizeOf(c);
    const ThinSvd svd = thinSvd(usual.cwiseInverse().asDiagonal() * walk.leftCols<kCourseWaves>());
    const VectorXd course = svd.V.col(0);
    Eigen::Index strongest = 0;
    course.cwiseAbs().maxCoeff(&strongest);
    if (!(svd.values(0) > 0.0)) return {};
    std::vector<Form> all = forms(signals);
    const std::vector<int> choice{kAnyCourse, static_cast<int>(strongest) + 1};
    const auto form = std::ranges::find(all, choice, &Form::choice);
    VectorXd v(6 + kCourseWaves - 1);
    for (Eigen::Index k = 0, at = 6; k < kCourseWaves; ++k)
      if (k != strongest) v(at++) = course(k) / course(strongest);
    const Eigen::RowVectorXd whole = courseOf(*form, v, signals);
    v.head<6>() =
        usual.cwiseProduct(svd.U.col(0)) * (svd.values(0) * course(strongest) * (whole.maxCoeff() - whole.minCoeff()));
    return {{std::move(*form), std::move(v)}};
  }

 private:
  static constexpr int kCourseWaves = 5;  ///< Half waves: what goes to and fro faster is no drift

  /// Any course that all channels take together, from its lowest to its highest so far in each: waves of which the
  /// strongest is one, the others a share of it.
  Form anyCourse(std::vector<Parameter> parameters, int strongest) const {
    for (int k = 1; k <= kCourseWaves; ++k)
      if (k != strongest) parameters.push_back({fmt::format("course_w{}", k), "", 1.0, 0.3, -20.0, 20.0});
    Form form = formOf(this, "to and fro", std::move(parameters));
    form.scan = {0, 1, 2, 3, 4, 5};
    form.choice = {kAnyCourse, strongest};
    form.later = true;
    return form;
  }

  /// That course, in units of its strongest wave.
  static Eigen::RowVectorXd courseOf(const Form& form, const VectorXd& v, const Signals& signals) {
    Eigen::RowVectorXd shares = Eigen::RowVectorXd::Zero(kHalfWaves);
    Eigen::Index at = 6;
    for (int k = 0; k < kCourseWaves; ++k) shares(k) = k + 1 == form.choice[1] ? 1.0 : v(at++);
    return shares * *wavesOver(signals.size());
  }
};

class SensorBias final : public Cause {
 public:
  const CauseInfo& info() const override {
    static constexpr CauseInfo kInfo{
        .id = ids::sensorBias,
        .family = Family::sensorZero,
        .title = heft::toSay("Sensor zero jumped (bias step)"),
        .check = heft::toSay("Was there a knock, a loose plug, or a program that zeroed the sensor while recording?"),
        .decides = heft::toSay(
            "Turn the tool to another pose after the jump and hold: a jump stays, a load turns with gravity."),
        .looks = heft::toSay("The difference is flat, steps once, and is flat again, however the tool is held."),
        .decidingMotion = "tilt-sideways",
        .effect = "sensor_bias",
        .begins = true};
    return kInfo;
  }
  std::string sentence(const FoundValues& v) const override {
    if (const CauseParameter* last = v.find("after_pose"))
      return heft::say("After pose {} the sensor's zero jumped by {} N and {} N m.", numberWords(last->value, 0),
                       v.norm({"fx", "fy", "fz"}), v.norm({"tx", "ty", "tz"}));
    return v.find("fx") || v.find("fy") || v.find("fz")
               ? heft::say("At {} s the sensor's zero jumped by {} N.", numberWords(v.value("time"), 1),
                           v.norm({"fx", "fy", "fz"}))
               : heft::say("At {} s the sensor's zero jumped by {} N m.", numberWords(v.value("time"), 1),
                           v.norm({"tx", "ty", "tz"}));
  }
  std::vector<std::string> lookAlikes() const override { return {"payload_change", "bias_drift"}; }
  std::vector<Form> forms(const Signals& signals) const override {
    std::vector<Form> out;
    const auto [from, to] = timesForChange(signals);
    for (const double t : momentsForChange(signals)) {
      std::vector<Parameter> parameters{{"time", "s", 1.0, 0.1, from, to}};
      for (int c = 0; c < 6; ++c)
        parameters.push_back({channelName(c), unitOf(c), 1.0, sizeOf(c), -400.0 * sizeOf(c), 400.0 * sizeOf(c)});
      Form form = formOf(this, "", parameters);
      form.start(0) = t;
      form.scan = {1, 2, 3, 4, 5, 6};
      form.subset = true;
      form.local = form.atOnce = true;
      out.push_back(form);
    }
    return out;
  }
  int order() const override { return 82; }
  bool addsToReadings() const override { return true; }
  void readings(const Form&, const VectorXd& v, const Signals& signals, Wrenches& w) const override {
    for (Eigen::Index k = 0; k < w.cols(); ++k) w.col(k) += stepAt(signals.time(k), v(0), 0.02) * v.tail<6>();
  }
  std::vector<std::pair<double, double>> when(const Form&, const VectorXd& v, const Signals& signals) const override {
    return {wholeAfter(v(0), signals)};
  }
};

class RandomWalk final : public Cause {
 public:
  const CauseInfo& info() const override {
    static constexpr CauseInfo kInfo{.id = ids::wandering, .family = Family::sensorZero, .zeroMoves = true};
    return kInfo;
  }
  std::vector<std::string> lookAlikes() const override { return {"bias_drift"}; }
  std::vector<Form> forms(const Signals&) const override {
    std::vector<Parameter> parameters;
    for (int k = 1; k <= kHalfWaves; ++k)
      for (int c = 0; c < 6; ++c)
        parameters.push_back({fmt::format("{}_wave_{}", channelName(c), k), unitOf(c), 1.0, sizeOf(c),
                              -200.0 * sizeOf(c), 200.0 * sizeOf(c)});
    Form form = formOf(this, "", std::move(parameters));
    form.walk = true;
    return {form};
  }
  int order() const override { return 84; }
  bool addsToReadings() const override { return true; }
  std::vector<std::pair<Form, VectorXd>> grown(const Form&, const VectorXd& v, const Signals& signals) const override {
    const auto* drift = dynamic_cast<const BiasDrift*>(findCause("bias_drift"));
    return drift == nullptr
               ? std::vector<std::pair<Form, VectorXd>>{}
               : drift->followedBy(Eigen::Map<const Eigen::Matrix<double, 6, kHalfWaves>>(v.data()), signals);
  }
  void readings(const Form&, const VectorXd& v, const Signals& signals, Wrenches& w) const override {
    const Eigen::Map<const Eigen::Matrix<double, 6, kHalfWaves>> amplitudes(v.data());
    if (amplitudes.isZero(0.0)) return;
    const auto waves = wavesOver(signals.size());
    for (int k = 0; k < kHalfWaves; ++k)
      if (!amplitudes.col(k).isZero(0.0)) w += amplitudes.col(k) * waves->row(k).head(w.cols());
  }
};

}  // namespace

std::unique_ptr<Cause> makeRandomWalk() { return std::make_unique<RandomWalk>(); }
std::unique_ptr<Cause> makeBiasDrift() { return std::make_unique<BiasDrift>(); }
std::unique_ptr<Cause> makeSensorBias() { return std::make_unique<SensorBias>(); }

}  // namespace heft::diagnosis
