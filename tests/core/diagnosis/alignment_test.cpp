// Clocks that Heft itself brought together: what is left of a delay is not put down to the rig.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>

#include "core/import/import.h"
#include "tests/core/diagnosis/fixture.h"

namespace heft::test {

namespace {

bool has(const DiagnosisReport& report, std::string_view code) {
  return std::ranges::find(report.findings, code, &Finding::code) != report.findings.end();
}

Recording late(double milliseconds, std::uint64_t seed, MotionKind motion = MotionKind::excitation) {
  return aRecording(motion, seed, {{"time_offset", "", milliseconds}});
}

std::filesystem::path folder() {
  auto out = std::filesystem::temp_directory_path() / "heft_alignment_test";
  std::filesystem::create_directories(out);
  return out;
}

/// Joints and wrench of `recording` in two files, the wrench on a clock that began 40 s earlier, joined again.
ReadRecording splitAndJoined(const Recording& recording) {
  const auto joints = folder() / "arm.csv", wrench = folder() / "force.csv";
  std::ofstream arm(joints), force(wrench);
  arm << "time,q1,q2,q3,q4,q5,q6,q7\n";
  force << "time,fx,fy,fz,tx,ty,tz\n";
  for (Eigen::Index k = 0; k < recording.rows(); ++k) {
    arm << fmt::format("{:.4f}", recording.time(k));
    for (Eigen::Index j = 0; j < 7; ++j) arm << fmt::format(",{:.8f}", recording.q(k, j));
    arm << '\n';
    force << fmt::format("{:.4f}", recording.time(k) + 40.0);
    for (Eigen::Index c = 0; c < 6; ++c) force << fmt::format(",{:.6f}", recording.wrench(k, c));
    force << '\n';
  }
  arm.close();
  force.close();
  EXPECT_TRUE(writeMeta(recording.meta, folder() / "arm.meta.json").ok());
  ImportOptions options;
  options.join = {wrench};
  return openRecording(joints, options).value();
}

/// Named, or as good as what is named.
bool lagIsFound(const DiagnosisReport& report) {
  const auto lags = [](std::string_view id) {
    return id == "time_offset" || id == "motion_lag" || id == "low_pass_lag";
  };
  return std::ranges::any_of(report.causes, [&](const DiagnosedCause& c) { return lags(c.id); });
}

TEST(Alignment, LeavesNoDelayOfTheRig) {
  for (const double delay : {0.0, 15.0})
    for (const auto motion : {MotionKind::free, MotionKind::excitation}) {
      const Recording recording = late(delay, 9105, motion);
      EXPECT_EQ(lagIsFound(diagnosed(recording)), delay > 0.0) << "on one clock";
      const auto joined = splitAndJoined(recording);
      ASSERT_TRUE(joined.recording.meta.clockAlignmentStd.has_value());
      EXPECT_GT(*joined.recording.meta.clockAlignmentStd, 0.0);
      EXPECT_LT(*joined.recording.meta.clockAlignmentStd, 0.02);
      const auto report = diagnosed(joined.recording);
      EXPECT_FALSE(lagIsFound(report)) << delay << ": " << said(report);
      // No delay would have been seen, however large.
      EXPECT_EQ(std::ranges::find(report.smallest, "time_offset", &Smallest::cause), report.smallest.end());
    }
}

TEST(Alignment, OnOneClockADelayIsNamed) {
  const auto report = diagnosed(late(15.0, 9106, MotionKind::free));
  const auto* delay = named(report, "time_offset");
  ASSERT_NE(delay, nullptr) << said(report);
  EXPECT_NEAR(findParameter(delay->parameters, "delay")->value, 15.0, 1.0);
  EXPECT_FALSE(has(report, "clocks_aligned"));
}

TEST(Alignment, IsToldWhereItIsOff) {
  Recording recording = late(4.0, 9107);
  recording.meta.clockAlignmentStd = 0.003;
  const auto report = diagnosed(recording);
  EXPECT_EQ(named(report, "time_offset"), nullptr) << said(report);
  EXPECT_TRUE(has(report, "clocks_aligned")) << said(report);
}

/// Readings that are smoothed are so whatever the clocks.
TEST(Alignment, HidesNoOtherCause) {
  Recording recording = aRecording(MotionKind::excitation, 9108, {{"low_pass_lag", "", 30.0}});
  recording.meta.clockAlignmentStd = 0.001;
  EXPECT_NE(named(diagnosed(recording), "low_pass_lag"), nullptr);
}

/// What was joined and written keeps it, so that it holds for the file, too.
TEST(Alignment, IsWrittenAndReadBack) {
  RecordingMeta meta;
  meta.clockAlignmentStd = 0.0025;
  const auto file = folder() / "back.meta.json";
  ASSERT_TRUE(writeMeta(meta, file).ok());
  Findings findings;
  const auto back = readMeta(file, findings);
  ASSERT_TRUE(back.ok());
  EXPECT_EQ(back->clockAlignmentStd, 0.0025);
  EXPECT_TRUE(findings.empty());
  EXPECT_FALSE(parseMeta(R"({"clock_alignment_std_s": -1})", "x", {}, findings).ok());
}

}  // namespace
}  // namespace heft::test
