// Recordings with the causes that a diagnosis found.
#include "core/twin/twin.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/diagnosis/diagnose.h"
#include "core/diagnosis/report/report.h"

namespace heft {
namespace {

using nlohmann::json;

const Payload kTwinTool{0.9, {0.01, -0.005, 0.07}, Vector3d(0.002, 0.0024, 0.0011).asDiagonal().toDenseMatrix()};

SimulateOptions rigMotion(std::uint64_t seed, MotionKind motion = MotionKind::free) {
  SimulateOptions options;
  options.motion = motion;
  options.seed = seed;
  options.duration = 15.0;
  options.rateHz = 250.0;
  return options;
}

json diagnosed(const Recording& recording) {
  DiagnoseOptions options;
  options.surrogates = 0;  // a fixed threshold: the effects here are plain
  const auto report = diagnose(recording, &RobotModel::panda(), options);
  if (!report) throw std::runtime_error(report.error().message);
  return toJson(*report);
}

json diagnosedWith(const EffectRequest& effect, std::uint64_t seed) {
  SimulateOptions options = rigMotion(seed);
  options.effects = {effect};
  return diagnosed(simulate(RobotModel::panda(), kTwinTool, options)->recording);
}

const json& late() {
  static const json found = diagnosedWith({"time_offset", "", 15.0}, 31);
  return found;
}

Twin twinOf(const json& found, const TwinOptions& options) {
  auto twin = simulateTwin(found, "found.json", RobotModel::panda(), options);
  if (!twin) throw std::runtime_error(twin.error().message);
  return std::move(*twin);
}

double delayOf(const json& found) { return found["causes"][0]["parameters"]["delay"]["value"].get<double>(); }

/// Diagnose, simulate the twin, diagnose the twin: the same cause, its size within both intervals.
TEST(Twin, IsDiagnosedAsItsRig) {
  for (const EffectRequest& effect :
       {EffectRequest{"time_offset", "", 15.0}, EffectRequest{"gain_error", "forces", 8.0}}) {
    const json found = diagnosedWith(effect, 31);
    ASSERT_EQ(found["causes"].size(), 1u) << effect.id;
    TwinOptions options;
    options.simulate = rigMotion(77);
    options.fixed = true;
    const json again = diagnosed(twinOf(found, options).simulated.recording);
    ASSERT_EQ(again["causes"].size(), 1u) << effect.id;
    EXPECT_EQ(again["causes"][0]["cause"], found["causes"][0]["cause"]);
    for (const auto& [name, parameter] : again["causes"][0]["parameters"].items()) {
      const json& before = found["causes"][0]["parameters"][name];
      const double std = std::hypot(parameter["std"].get<double>(), before["std"].get<double>());
      EXPECT_NEAR(parameter["value"].get<double>(), before["value"].get<double>(), 3.0 * std)
          << effect.id << " " << name;
    }
  }
}

TEST(Twin, HasTheSizesFoundOrDrawsThemFromTheirIntervals) {
  ASSERT_EQ(late()["causes"][0]["cause"], "time_offset");
  TwinOptions options;
  options.simulate = rigMotion(5);
  options.simulate.duration = 2.0;
  options.fixed = true;
  const Twin fixed = twinOf(late(), options);
  ASSERT_EQ(fixed.simulated.truth.effects.size(), 1u);
  EXPECT_EQ(fixed.simulated.truth.effects[0].parameters[0].name, "delay");
  EXPECT_NEAR(fixed.simulated.truth.effects[0].parameters[0].values[0], delayOf(late()), 1e-9);
  options.fixed = false;
  const double std = late()["causes"][0]["parameters"]["delay"]["std"].get<double>();
  double sum = 0.0;
  constexpr int kDraws = 30;
  for (int draw = 0; draw < kDraws; ++draw) {
    options.simulate.seed = static_cast<std::uint64_t>(100 + draw);
    const double delay = twinOf(late(), options).simulated.truth.effects[0].parameters[0].values[0];
    sum += std::pow((delay - delayOf(late())) / std, 2);
  }
  EXPECT_GT(sum / kDraws, 0.4);  // chi-squared with 30 degrees of freedom: 1 in 1000 on either side
  EXPECT_LT(sum / kDraws, 2.0);
}

TEST(Twin, WithoutTheCauseIsThePlainSimulation) {
  TwinOptions options;
  options.simulate = rigMotion(6);
  options.simulate.duration = 3.0;
  options.without = {"time_offset"};
  const Twin plain = twinOf(late(), options);
  EXPECT_TRUE(plain.simulated.truth.effects.empty());
  ASSERT_EQ(plain.causes.size(), 1u);
  EXPECT_FALSE(plain.causes[0].simulated);
  const Payload payload = *payloadFromJson(late()["payload_after"], "found.json");
  const json& x = late()["model"]["bias_and_parameters"];
  const Vector3d bias(x[0].get<double>(), x[1].get<double>(), x[2].get<double>());
  EXPECT_LT((plain.simulated.truth.forceBias - bias).norm(), 1e-12);
  SimulateOptions same = options.simulate;
  same.sensor.forceBias = same.sensor.torqueBias = 0.0;
  const auto direct = simulate(RobotModel::panda(), payload, same);
  const auto& got = plain.simulated.recording.wrench;
  const auto& wanted = direct->recording.wrench;
  ASSERT_EQ(got.rows(), wanted.rows());
  for (int c = 0; c < 3; ++c)
    EXPECT_LT((got.col(c).array() - wanted.col(c).array() - bias(c)).abs().maxCoeff(), 0.02)
        << "two steps of its converter";
  options.without.clear();
  options.fixed = true;
  EXPECT_GT((twinOf(late(), options).simulated.recording.wrench - got).cwiseAbs().maxCoeff(), 0.1);
}

TEST(Twin, SaysWhatItCannotDo) {
  json found = late();
  found["causes"].push_back({{"cause", "spikes"}, {"parameters", json::object()}});
  TwinOptions options;
  options.simulate = rigMotion(7);
  options.simulate.duration = 2.0;
  const Twin twin = twinOf(found, options);
  ASSERT_EQ(twin.causes.size(), 2u);
  EXPECT_TRUE(twin.causes[0].simulated);
  EXPECT_FALSE(twin.causes[1].simulated);
  EXPECT_THAT(twin.causes[1].why, testing::HasSubstr("no model"));
  options.without = {"cable_pull"};
  const auto unknown = simulateTwin(late(), "found.json", RobotModel::panda(), options);
  ASSERT_FALSE(unknown);
  EXPECT_THAT(unknown.error().message, testing::HasSubstr("it found time_offset"));
  EXPECT_FALSE(simulateTwin({{"schema", "heft.estimate/1"}}, "found.json", RobotModel::panda(), {}));
  for (const json& broken : {json(3), json::array(), json("heft.diagnose/1")}) {
    json other = late();
    other["causes"] = json::array({broken});
    EXPECT_FALSE(simulateTwin(other, "found.json", RobotModel::panda(), {})) << broken;
    other = late();
    other["causes"][0]["parameters"] = json{{"delay", broken}};
    EXPECT_FALSE(simulateTwin(other, "found.json", RobotModel::panda(), {})) << broken;
    other = late();
    other["model"] = broken;
    EXPECT_FALSE(simulateTwin(other, "found.json", RobotModel::panda(), {})) << broken;
    EXPECT_FALSE(simulateTwin(broken, "found.json", RobotModel::panda(), {})) << broken;
  }
}

}  // namespace
}  // namespace heft
