// Measured recordings that lie beside the project on the developers' machines and nowhere else.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "core/estimation/estimate.h"
#include "core/recording/csv_reader.h"

namespace heft {
namespace {

namespace fs = std::filesystem;

fs::path folder() {
  const char* shared = std::getenv("HEFT_SHARED");
  return (shared ? fs::path(shared) : fs::path(HEFT_SOURCE_DIR) / ".." / "shared") / "realdata";
}

class RealData : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(folder())) GTEST_SKIP() << "no measured recordings at " << folder();
  }
  static EstimateReport run(const char* name) {
    auto read = readRecording(folder() / name);
    if (!read) throw std::runtime_error(read.error().message);
    auto report = estimate(read->recording, nullptr, {});
    if (!report) throw std::runtime_error(report.error().message);
    EXPECT_TRUE(report->physicallyConsistent);
    return *report;
  }
  static bool has(const EstimateReport& report, std::string_view code) {
    return std::any_of(report.findings.begin(), report.findings.end(),
                       [&](const Finding& f) { return f.code == code; });
  }
};

TEST_F(RealData, KukaStandingPoses) {
  const auto report = run("kuka_gamma_calibration_24_poses.csv");
  EXPECT_NEAR(report.payload.mass, 0.9323, 0.005);
  EXPECT_LT((report.payload.com - Vector3d(0.0003, 0.0001, 0.0439)).norm(), 0.002);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(report.identifiability.inertia[i][i], Source::none);
}

TEST_F(RealData, KukaTurnWithoutPosition) {
  const auto report = run("kuka_gamma_baseline.csv");
  EXPECT_NEAR(report.payload.mass, 0.94, 0.04);
  EXPECT_TRUE(has(report, "origin_acceleration_unknown"));
}

TEST_F(RealData, KukaContactIsFoundAndDoesNotPull) {
  const auto report = run("kuka_gamma_vibrations_contact.csv");
  EXPECT_NEAR(report.payload.mass, 0.9323, 0.03 * 0.9323);
  EXPECT_LT((report.payload.com - Vector3d(0.0003, 0.0001, 0.0439)).norm(), 0.005);
  EXPECT_TRUE(has(report, "contact_left_out"));
  EXPECT_TRUE(has(report, "trim_lifted"));
  double contact = 0.0;
  for (const auto& segment : report.segments)
    if (segment.label == MarkLabel::contact) contact += segment.to - segment.from;
  EXPECT_GT(contact, 3.2);
  EXPECT_LT(contact, 4.2) << "it lasts from about 0.6 to 4.1 s";
}

TEST_F(RealData, PandaWithPolledSensor) {
  const auto report = run("panda_optoforce_14-23-21.csv");
  EXPECT_NEAR(report.payload.mass, 1.13, 0.07) << "not weighed; its own interval is +- 0.07 kg";
  EXPECT_NEAR(report.payload.com.z(), 0.110, 0.012);
  EXPECT_TRUE(has(report, "misfit"));
}

TEST_F(RealData, IcubFootIsNotTrusted) {
  const auto report = run("icub_right_foot.csv");
  EXPECT_NEAR(report.payload.mass, 0.305, 0.01) << "what this sensor's gain makes of 0.382 kg";
  EXPECT_TRUE(has(report, "known_disagrees"));
  EXPECT_TRUE(has(report, "contact_left_out"));
  ASSERT_GT(report.segments.size(), 2u);
  EXPECT_EQ(report.segments.front().label, MarkLabel::contact);
  EXPECT_EQ(report.segments.back().label, MarkLabel::contact);
  double free = 0.0, onFloor = 0.0;
  for (const auto& segment : report.segments) {
    const double middle = std::max(0.0, std::min(segment.to, 60.0) - std::max(segment.from, 16.0));
    const double floor =
        segment.to - segment.from - std::max(0.0, std::min(segment.to, 62.0) - std::max(segment.from, 14.0));
    if (segment.label == MarkLabel::free) free += middle;
    if (segment.label == MarkLabel::contact) onFloor += floor;
  }
  EXPECT_GT(free, 0.85 * 44.0) << "free from 16 to 60 s";
  EXPECT_GT(onFloor, 0.97 * 26.7) << "on the floor before 14 s and after 62 s";
}

}  // namespace
}  // namespace heft
