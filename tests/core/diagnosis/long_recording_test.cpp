// Minutes of recording: what was done is found as in a demonstration, and stopping ends it at any stage.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <stop_token>
#include <string>
#include <vector>

#include "tests/core/diagnosis/fixture.h"

namespace heft::test {
namespace {

Recording minutes(double duration, std::uint64_t seed, std::vector<EffectRequest> effects = {}) {
  SimulateOptions options;
  options.motion = MotionKind::free;
  options.seed = seed;
  options.duration = duration;
  options.rateHz = 100.0;
  options.effects = std::move(effects);
  return simulate(RobotModel::panda(), aTool(), options).value().recording;
}

std::vector<std::string> idsOf(const DiagnosisReport& report) {
  std::vector<std::string> out;
  for (const DiagnosedCause& cause : report.causes) out.push_back(cause.id);
  return out;
}

TEST(LongRecording, NothingIsFoundWhereNothingIs) {
  const DiagnosisReport report = diagnosed(minutes(200.0, 71));
  EXPECT_TRUE(idsOf(report).empty());
  EXPECT_EQ(report.verdict, Verdict::clean);
  const auto part = std::ranges::find(report.findings, "searched_in_part", &Finding::code);
  ASSERT_NE(part, report.findings.end());
  EXPECT_THAT(part->text, testing::MatchesRegex("All causes were searched for from [0-9]+ to [0-9]+ s; .*"));
}

TEST(LongRecording, ACauseOfAllTheTimeIsFound) {
  const DiagnosisReport report = diagnosed(minutes(200.0, 72, {{"sensor_rotation", "", 4.0}}));
  EXPECT_EQ(idsOf(report), std::vector<std::string>{"sensor_rotation"});
}

/// Whichever part is looked at in fine steps, the load changes only once.
TEST(LongRecording, WhatHappensOnceIsFound) {
  const Recording recording = minutes(200.0, 73, {{"payload_change", "", 150.0}});
  const DiagnosisReport report = diagnosed(recording);
  ASSERT_EQ(idsOf(report), std::vector<std::string>{"payload_change"});
  const CauseParameter* mass = findParameter(report.causes.front().parameters, "mass");
  ASSERT_NE(mass, nullptr);
  EXPECT_NEAR(std::abs(mass->value), 150.0, 3.0 * std::max(1.0, mass->std));
  EXPECT_EQ(report.series.judged.size(), static_cast<std::size_t>(report.series.time.size()));
  EXPECT_GT(report.series.time(report.series.time.size() - 1), 195.0);
}

TEST(LongRecording, StoppingAtAnyStageBeginsNoOther) {
  const Recording recording = minutes(160.0, 74, {{"time_offset", "", 12.0}});
  DiagnoseOptions options;
  options.surrogates = 20;
  std::vector<std::string> stages;
  const Progress watched{{}, [&](double, std::string_view what) { stages.emplace_back(what); }};
  ASSERT_TRUE(diagnose(recording, &RobotModel::panda(), options, watched).ok());
  ASSERT_GT(stages.size(), 8U);
  EXPECT_EQ(stages.back(), "Done");
  for (std::size_t last = 0; last + 1 < stages.size(); ++last) {
    if (last > 0 && stages[last] == stages[last - 1]) continue;
    std::stop_source stop;
    std::size_t calls = 0;
    const Progress progress{stop.get_token(), [&](double, std::string_view) {
                              if (calls++ == last) stop.request_stop();
                            }};
    const auto result = diagnose(recording, &RobotModel::panda(), options, progress);
    ASSERT_FALSE(result.ok()) << stages[last];
    EXPECT_TRUE(result.error().cancelled);
    EXPECT_EQ(calls, last + 1) << "after " << stages[last];
  }
}

/// A bar that stands looks broken: of all that a long recording is asked, each stage tells how far it is.
TEST(LongRecording, TheBarNeverRunsBack) {
  double most = 0.0;
  const Progress watched{{}, [&](double fraction, std::string_view what) {
                           EXPECT_GE(fraction, most - 1e-12) << what;
                           most = std::max(most, fraction);
                         }};
  ASSERT_TRUE(diagnose(minutes(160.0, 75, {{"sensor_rotation", "", 4.0}}), &RobotModel::panda(), {}, watched).ok());
  EXPECT_EQ(most, 1.0);
}

}  // namespace
}  // namespace heft::test
