// What the user painted decides, also where contact is looked for.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/core/diagnosis/fixture.h"

namespace heft::test {
namespace {

constexpr double kFrom = 5.0, kTo = 7.0;  ///< [s] of a slow push of 4 N

Recording pushed() {
  Recording recording = aRecording(MotionKind::excitation, 4);
  for (Eigen::Index k = 0; k < recording.rows(); ++k) {
    const double t = recording.time(k);
    if (t > kFrom && t < kTo)
      recording.wrench(k, 1) += 4.0 * std::pow(std::sin(std::numbers::pi * (t - kFrom) / (kTo - kFrom)), 2);
  }
  return recording;
}

DiagnosisReport automatic(const Recording& recording) {
  DiagnoseOptions options;
  options.surrogates = 0;
  options.segments = SegmentMode::automatic;  // as the window does where marks were painted over suggestions
  return diagnose(recording, &RobotModel::panda(), options).value();
}

TEST(PaintedMarks, WhatIsPaintedAsTouchedOrToBeIgnoredIsNotJudged) {
  const DiagnosisReport unmarked = automatic(pushed());
  EXPECT_NE(unmarked.verdict, Verdict::clean) << "else this test shows nothing";
  for (const MarkLabel label : {MarkLabel::contact, MarkLabel::ignore}) {
    Recording recording = pushed();
    recording.meta.marks.push_back({kFrom - 0.1, kTo + 0.1, label});
    const DiagnosisReport report = automatic(recording);
    EXPECT_EQ(report.verdict, Verdict::clean) << toString(label);
    EXPECT_TRUE(report.causes.empty()) << report.causes.front().id;
    int outside = 0;
    for (Eigen::Index n = 0; n < report.series.time.size(); ++n) {
      const double t = report.series.time(n);
      const bool judged = report.series.judged[static_cast<std::size_t>(n)];
      if (t > kFrom && t < kTo) {
        EXPECT_FALSE(judged) << t;
      }
      if (t < kFrom - 0.5 || t > kTo + 0.5) outside += judged;
    }
    EXPECT_GT(outside, 200) << "the rest of the recording is judged as before";
  }
}

TEST(PaintedMarks, WhatIsPaintedFreeIsNoContact) {
  Recording recording = pushed();
  recording.meta.marks.push_back({kFrom - 0.5, kTo + 0.5, MarkLabel::free});
  const DiagnosisReport report = automatic(recording);
  EXPECT_NE(report.verdict, Verdict::clean);
  for (const auto& cause : report.causes) {
    if (cause.id != "contact") continue;
    for (const auto& [from, to] : cause.when) EXPECT_TRUE(to < kFrom || from > kTo) << from << " to " << to;
  }
}

}  // namespace
}  // namespace heft::test
