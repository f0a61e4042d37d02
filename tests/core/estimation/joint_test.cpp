// Several recordings of one tool.
#include "core/estimation/joint.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/simulation/simulate.h"
#include "tests/support/random_tool.h"

namespace heft {
namespace {

const Payload kTool = test::boxPayload(0.8, {0.08, 0.10, 0.12}, {0.01, -0.005, 0.06});

Recording recordingToJoin(MotionKind kind, const Payload& payload, unsigned seed, double duration = 10.0,
                          double speed = 1.0) {
  SimulateOptions options;
  options.speed = speed;
  options.motion = kind;
  options.seed = seed;
  options.duration = duration;
  options.rateHz = 500.0;
  auto simulated = simulate(RobotModel::panda(), payload, options);
  simulated->recording.file = "recording " + std::to_string(seed);
  return std::move(simulated->recording);
}

/// Hardly any motion: nothing is learned beyond one direction of gravity.
Recording heldStill(unsigned seed) { return recordingToJoin(MotionKind::excitation, kTool, seed, 6.0, 0.01); }

JointReport joined(const std::vector<Recording>& recordings, const EstimateOptions& options = {}) {
  std::vector<JointInput> inputs;
  for (const auto& recording : recordings) inputs.push_back({&recording, &RobotModel::panda()});
  auto joint = estimateJointly(inputs, options);
  if (!joint) throw std::runtime_error(joint.error().message);
  return *joint;
}

TEST(Joint, TwoRecordingsWithTheirOwnBiasesNarrowTheIntervals) {
  const std::vector recordings{recordingToJoin(MotionKind::free, kTool, 1),
                               recordingToJoin(MotionKind::free, kTool, 2)};
  const auto joint = joined(recordings);
  ASSERT_EQ(joint.pieces.size(), 2u);
  const auto& first = joint.pieces[0].report;
  const auto& second = joint.pieces[1].report;
  EXPECT_LT((toParameters(first.payload) - toParameters(second.payload)).norm(), 1e-6) << "one payload";
  EXPECT_GT((first.forceBias - second.forceBias).norm(), 0.1) << "two biases";
  for (std::size_t i = 0; i < 2; ++i) {
    const auto single = estimate(recordings[i], &RobotModel::panda(), {});
    EXPECT_LT(joint.report().std.mass, single->std.mass);
    EXPECT_LT(joint.report().std.com.norm(), single->std.com.norm());
    EXPECT_NEAR(joint.pieces[i].alone.mass, single->payload.mass, 1e-5);
    EXPECT_GT(joint.pieces[i].adds.mass, 1.05);
    EXPECT_LT((joint.pieces[i].report.forceBias - single->forceBias).norm(), 0.05);
  }
  EXPECT_NEAR(first.payload.mass, kTool.mass, 4.0 * first.std.mass);
  EXPECT_EQ(joint.proposalText, "Use all of them.");
}

TEST(Joint, ARecordingWithoutMotionAddsNothing) {
  const auto joint = joined({heldStill(3), recordingToJoin(MotionKind::excitation, kTool, 4),
                             recordingToJoin(MotionKind::excitation, kTool, 5)});
  EXPECT_EQ(joint.proposalText, "Use 2 and 3; 1 adds nothing.");
  EXPECT_THAT(joint.proposal, testing::ElementsAre(1u, 2u));
  EXPECT_LT(joint.pieces[0].adds.mass, 1.1);
  EXPECT_THAT(joint.pieces[0].words, testing::HasSubstr("next to nothing"));
}

TEST(Joint, AnotherToolIsLeftOutAndSaid) {
  Payload other = kTool;
  other.mass = 0.7;
  const auto joint = joined({recordingToJoin(MotionKind::free, kTool, 6), recordingToJoin(MotionKind::free, other, 7),
                             recordingToJoin(MotionKind::free, kTool, 8)});
  EXPECT_TRUE(joint.pieces[0].used);
  EXPECT_FALSE(joint.pieces[1].used);
  EXPECT_TRUE(joint.pieces[2].used);
  EXPECT_NEAR(joint.report().payload.mass, 0.8, 0.005);
  EXPECT_NEAR(joint.pieces[1].report.payload.mass, 0.7, 0.005) << "its own report stays its own";
  EXPECT_EQ(joint.proposalText, "Use 1 and 3; 2 is of another tool.");
  const auto& findings = joint.report().findings;
  EXPECT_TRUE(std::any_of(findings.begin(), findings.end(),
                          [](const Finding& finding) { return finding.code == "different_tool"; }));
}

TEST(Joint, TheSameToolIsNotTakenForAnother) {
  for (unsigned seed = 10; seed < 16; seed += 2) {
    const auto joint = joined({recordingToJoin(MotionKind::free, kTool, seed, 6.0),
                               recordingToJoin(MotionKind::pickAndPlace, kTool, seed + 1, 12.0)});
    EXPECT_TRUE(joint.pieces[0].used && joint.pieces[1].used) << seed;
  }
}

TEST(Joint, TheResultNamesEveryRecording) {
  const auto joint =
      joined({recordingToJoin(MotionKind::free, kTool, 17), recordingToJoin(MotionKind::free, kTool, 18)});
  const auto result = toJson(joint);
  EXPECT_EQ(result["schema"], "heft.estimate/1");
  EXPECT_EQ(result["recording"]["file"], "recording 17");
  ASSERT_EQ(result["recordings"].size(), 2u);
  for (const auto& entry : result["recordings"])
    for (const char* key : {"file", "used_s", "used", "alone", "adds", "bias", "residual", "segments", "text"})
      EXPECT_TRUE(entry.contains(key)) << key;
  EXPECT_EQ(result["selection"]["use"], nlohmann::json({1, 2}));
  EXPECT_THAT(toText(joint), testing::HasSubstr("2 recordings. Use all of them."));
}

TEST(Joint, FailsInOneSentence) {
  EXPECT_FALSE(estimateJointly({}, {}));
  const Recording good = recordingToJoin(MotionKind::free, kTool, 19, 6.0);
  Recording bad = good;
  bad.file = "bad.csv";
  bad.meta.marks = {{-1.0, 1e3, MarkLabel::ignore}};
  const std::array inputs{JointInput{&good, &RobotModel::panda()}, JointInput{&bad, &RobotModel::panda()}};
  const auto failed = estimateJointly(inputs, {});
  ASSERT_FALSE(failed);
  EXPECT_THAT(failed.error().message, testing::StartsWith("bad.csv: "));
  EstimateOptions options;
  options.method = Method::ls;
  EXPECT_FALSE(estimateJointly(inputs, options));
}

}  // namespace
}  // namespace heft
