// Physics decides whether an estimate may be relied on: conventions that are not as stated, and what follows.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/estimation/joint.h"
#include "core/exporters/flange.h"
#include "tests/support/as_driver.h"
#include "tests/support/estimation_fixtures.h"

namespace heft::test {
namespace {

Recording guidedFor12s(const Payload& payload, std::uint64_t seed) {
  SimulateOptions options;
  options.motion = MotionKind::free;
  options.seed = seed;
  options.duration = 12.0;
  options.rateHz = 250.0;
  options.speed = 0.8;
  options.sensor.forceRange.setConstant(1e3);
  options.sensor.torqueRange = 100.0;
  return std::move(simulate(RobotModel::panda(), payload, options)->recording);
}

bool anyMeasured(const EstimateReport& report) {
  bool any = report.identifiability.mass == Source::data;
  for (const Source source : report.identifiability.com) any = any || source == Source::data;
  for (const auto& row : report.identifiability.inertia)
    for (const Source source : row) any = any || source == Source::data;
  return any;
}

Payload someTool(std::uint64_t seed) {
  std::mt19937 random(static_cast<std::mt19937::result_type>(seed));
  return randomTool(random).payload;
}

void expectRefused(const EstimateReport& report, const std::string& name) {
  EXPECT_EQ(report.trust, Trust::none) << name;
  EXPECT_FALSE(anyMeasured(report)) << name;
  const std::string text = toText(report);
  EXPECT_EQ(text.find(" kg "), std::string::npos) << text;
  EXPECT_EQ(text.find("Tilt the tool"), std::string::npos) << text;
  EXPECT_FALSE(report.whatToDo.empty()) << name;
  const auto json = toJson(report);
  EXPECT_EQ(json["trust"], "none") << name;
  EXPECT_FALSE(toFlange(json, "result.json", {})) << name;
  FlangeOptions force;
  force.force = true;
  // A payload that cannot exist stays refused; what matters here is the reason.
  const auto forced = toFlange(json, "result.json", force);
  const std::string reason = forced ? std::string() : forced.error().message;
  EXPECT_EQ(reason.find("not reliable"), std::string::npos) << reason;
}

TEST(Trust, PlainRecordingsAreTrusted) {
  const Payload payload = someTool(21);
  const EstimateReport report = reportOf(guidedFor12s(payload, 21));
  EXPECT_EQ(report.trust, Trust::good);
  const auto json = toJson(report);
  EXPECT_EQ(json["trust"], "good");
  EXPECT_TRUE(json["conventions"]["suggested"].is_null());
  EXPECT_TRUE(json["conventions"]["meta"].is_null());
  EXPECT_EQ(reportOf(standingRecording(payload, 24, {0.0, 0.0, -9.81}, 1.0, 3)).trust, Trust::good);
}

TEST(Trust, MotionsInOtherConventionsAreRefusedAndReadRightly) {
  const Payload payload = someTool(22);
  const Recording plain = guidedFor12s(payload, 22);
  for (const char* name : {"base_axes", "torque_first", "torque_sign", "wrench_sign", "mirror_x", "N_mm", "lbf_in",
                           "turned_any", "pose_inverted", "w_first"}) {
    Recording recording = plain;
    rewriteAs(name, RobotModel::panda(), 22, recording);
    const EstimateReport asStated = reportOf(recording);
    expectRefused(asStated, name);
    EXPECT_TRUE(toJson(asStated)["conventions"]["meta"].is_object()) << name;
    EstimateOptions options;
    options.conventions = ConventionChoice::suggested;
    const EstimateReport suggested = reportOf(recording, options);
    EXPECT_NE(suggested.trust, Trust::none) << name;
    EXPECT_TRUE(has(suggested, "read_as_suggested")) << name;
    EXPECT_EQ(toJson(suggested)["conventions"]["used"], "suggested") << name;
    EXPECT_NEAR(suggested.payload.mass, payload.mass, 0.02 * payload.mass) << name;
    EXPECT_LT((suggested.payload.com - payload.com).norm(), 0.002) << name;
  }
}

TEST(Trust, PosesInOtherConventionsAreRefusedAndReadRightly) {
  const Payload payload = someTool(23);
  for (const char* name : {"base_axes", "torque_first", "wrench_sign", "mirror_y", "turned_45", "pose_inverted"}) {
    Recording recording = standingRecording(payload, 24, {0.0, 0.0, -9.81}, 1.0, 23);
    rewriteAs(name, RobotModel::panda(), 23, recording);
    expectRefused(reportOf(recording), name);
    EstimateOptions options;
    options.conventions = ConventionChoice::suggested;
    const EstimateReport suggested = reportOf(recording, options);
    EXPECT_NE(suggested.trust, Trust::none) << name;
    EXPECT_NEAR(suggested.payload.mass, payload.mass, 0.02 * payload.mass) << name;
    EXPECT_LT((suggested.payload.com - payload.com).norm(), 0.002) << name;
  }
}

TEST(Trust, NoDriverMakesItConfidentlyWrong) {
  const auto wrong = [](const EstimateReport& report, const Payload& truth) {
    return report.trust == Trust::good && (std::abs(report.payload.mass - truth.mass) > 0.02 * truth.mass ||
                                           (report.payload.com - truth.com).norm() > 0.003);
  };
  for (const std::uint64_t seed : {27, 28}) {
    const Payload payload = someTool(seed);
    const Recording plain = guidedFor12s(payload, seed);
    for (const std::string& name : driverNames()) {
      for (const int count : {0, 24, 100}) {
        Recording recording = count == 0 ? plain : standingRecording(payload, count, {0.0, 0.0, -9.81}, 1.0, seed);
        rewriteAs(name, RobotModel::panda(), seed, recording);
        for (const ConventionChoice choice : {ConventionChoice::asStated, ConventionChoice::suggested}) {
          EstimateOptions options;
          options.conventions = choice;
          const EstimateReport report = reportOf(recording, options);
          EXPECT_FALSE(wrong(report, payload))
              << name << " " << count << " poses, " << toString(choice) << ": " << report.payload.mass << " kg for "
              << payload.mass << ", centre " << report.payload.com.transpose() << " for " << payload.com.transpose();
        }
      }
    }
  }
}

TEST(Trust, NumbersThatNoConventionExplainsAreRefused) {
  Recording recording = guidedFor12s(someTool(24), 24);
  const MatrixXd wrench = recording.wrench;
  recording.wrench = wrench.colwise().reverse();  // the wrench of another time
  expectRefused(reportOf(recording), "reversed");
}

TEST(Trust, ARecordingThatIsNotUnderstoodIsLeftOutOfAJointEstimate) {
  const Payload payload = someTool(25);
  const Recording right = guidedFor12s(payload, 25);
  Recording wrong = guidedFor12s(payload, 26);
  rewriteAs("torque_sign", RobotModel::panda(), 26, wrong);
  const RobotModel& robot = RobotModel::panda();
  for (const bool wrongFirst : {false, true}) {
    std::vector<JointInput> inputs{{&right, &robot}, {&wrong, &robot}};
    if (wrongFirst) std::swap(inputs[0], inputs[1]);
    const auto joint = estimateJointly(inputs, {});
    ASSERT_TRUE(joint.ok());
    EXPECT_EQ(joint->first, wrongFirst ? 1U : 0U);
    EXPECT_EQ(joint->report().trust, Trust::good);
    EXPECT_TRUE(has(joint->report(), "recording_not_understood"));
    EXPECT_NEAR(joint->report().payload.mass, payload.mass, 0.02 * payload.mass);
  }
  const std::vector<JointInput> both{{&wrong, &robot}, {&wrong, &robot}};
  const auto joint = estimateJointly(both, {});
  ASSERT_TRUE(joint.ok());
  expectRefused(joint->report(), "both");
}

}  // namespace
}  // namespace heft::test
