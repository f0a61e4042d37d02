// Measured recordings, as they are and with effects put into them. Skipped where they are not at hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "core/diagnosis/diagnose.h"
#include "core/motion/motion.h"
#include "core/recording/csv_reader.h"
#include "tests/core/diagnosis/fixture.h"
#include "tests/support/injection.h"

namespace heft::test {
namespace {

namespace fs = std::filesystem;

class Measured : public testing::Test {
 protected:
  void SetUp() override {
    const char* given = std::getenv("HEFT_SHARED");
    folder_ = (given ? fs::path(given) : fs::path(HEFT_SOURCE_DIR) / ".." / "shared") / "realdata";
    if (!fs::exists(folder_)) GTEST_SKIP() << "no measured recordings at " << folder_;
  }

  Recording read(const char* name) {
    auto file = readRecording(folder_ / name);
    Findings findings;
    if (auto robot = robotFor(file.value().recording.meta, findings)) robot_ = *robot;
    return file.value().recording;
  }

  const RobotModel* robot() const { return robot_ ? &*robot_ : nullptr; }

  DiagnosisReport diagnosed(const Recording& recording) const {
    DiagnoseOptions options;
    options.surrogates = 0;
    return diagnose(recording, robot(), options).value();
  }

  fs::path folder_;
  std::optional<RobotModel> robot_;
};

const DiagnosedCause* causeIn(const DiagnosisReport& report, const std::string& id) {
  const auto found = std::find_if(report.causes.begin(), report.causes.end(), [&](const auto& c) {
    return c.id == id || std::find(c.alternatives.begin(), c.alternatives.end(), id) != c.alternatives.end();
  });
  return found == report.causes.end() ? nullptr : &*found;
}

TEST_F(Measured, ContactIsNamedAndThePayloadIsThatOfTheReference) {
  const auto report = diagnosed(read("kuka_gamma_vibrations_contact.csv"));
  EXPECT_NE(causeIn(report, "contact"), nullptr) << said(report);
  EXPECT_NEAR(report.after.payload.mass, 0.9323, 0.03 * 0.9323);
  EXPECT_LT((report.after.payload.com - Vector3d(0.3e-3, 0.1e-3, 43.9e-3)).norm(), 5e-3);
}

/// A foot stands on the floor before and after: its posture goes with the load there, and it is contact all the same.
TEST_F(Measured, AFootOnTheFloorIsContact) {
  const auto report = diagnosed(read("icub_right_foot.csv"));
  const auto* contact = causeIn(report, "contact");
  ASSERT_NE(contact, nullptr) << said(report);
  EXPECT_GE(contact->when.size(), 2u);
  EXPECT_EQ(report.verdict, Verdict::unexplained) << said(report);
  EXPECT_EQ(causeIn(report, "constant_pull"), nullptr)
      << "nothing pulls there; the sensor's gain is poor: " << said(report);
}

/// The accelerations are unknown there: nothing but that, and what is plain to see, is told.
TEST_F(Measured, WithoutAPositionNoCauseIsMadeUp) {
  for (const char* name : {"kuka_gamma_baseline.csv", "kuka_gamma_vibrations.csv"}) {
    const auto report = diagnosed(read(name));
    EXPECT_EQ(report.verdict, Verdict::unexplained) << name << ": " << said(report);
    EXPECT_TRUE(report.causes.empty()) << name << ": " << said(report);
    EXPECT_NE(report.sentence.find("first suspect"), std::string::npos) << report.sentence;
  }
}

TEST_F(Measured, AsynchronousPollingIsSeenAndNothingIsMadeWorse) {
  const auto report = diagnosed(read("panda_optoforce_14-23-21.csv"));
  EXPECT_NE(causeIn(report, "dropouts"), nullptr) << said(report);
  EXPECT_NE(causeIn(report, "time_offset"), nullptr) << said(report);
  EXPECT_NE(report.verdict, Verdict::explained) << "the zero creeps, too";
  // Four runs of the same tool.
  EXPECT_GT(report.after.payload.mass, 1.08);
  EXPECT_LT(report.after.payload.mass, 1.18);
  EXPECT_NEAR(report.after.payload.com.z(), 0.11, 0.01);
}

TEST_F(Measured, WhatIsPutInIsFoundOrLeftOpen) {
  const Recording recording = read("panda_optoforce_14-23-21.csv");
  Payload payload;
  payload.mass = 1.12;
  payload.com = {0.001, 0.003, 0.107};
  payload.inertiaCom = Vector3d(5e-3, 5e-3, 2e-3).asDiagonal();
  const Vector6d bias = Vector6d::Zero();
  for (const EffectRequest& request :
       {EffectRequest{"sensor_rotation", "", 12.0}, EffectRequest{"payload_change", "", 400.0}}) {
    const auto injected = inject(recording, robot(), payload, bias, {request}, 4);
    ASSERT_TRUE(injected.ok()) << injected.error().message;
    const auto report = diagnosed(injected->recording);
    EXPECT_NE(report.verdict, Verdict::clean);
    EXPECT_TRUE(causeIn(report, request.id) != nullptr || report.verdict == Verdict::unexplained)
        << request.id << ": " << said(report);
    EXPECT_GT(report.after.payload.mass, 0.7) << request.id;
    EXPECT_LT(report.after.payload.mass, 1.7) << request.id;
    std::printf("%s: %s, %.3f kg\n", request.id.c_str(), said(report).c_str(), report.after.payload.mass);
  }
}

}  // namespace
}  // namespace heft::test
