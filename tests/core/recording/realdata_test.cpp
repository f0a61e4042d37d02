// Measured recordings, where they are at hand: all are read, and what is known to be wrong with them is found.
#include <cstdlib>
#include <filesystem>

#include "tests/core/recording/sample.h"

namespace heft {
namespace {

using namespace testing_support;

class RealData : public testing::Test {
 protected:
  void SetUp() override {
    const char* shared = std::getenv("HEFT_SHARED");
    folder_ = std::filesystem::path(shared != nullptr ? shared : HEFT_SOURCE_DIR "/../shared") / "realdata";
    if (!std::filesystem::is_directory(folder_)) GTEST_SKIP() << "No measured recordings at " << folder_ << ".";
  }
  ReadRecording read(const std::string& name) const {
    auto result = readRecording(folder_ / name);
    if (!result) throw std::runtime_error(result.error().message);
    return std::move(result).value();
  }
  std::filesystem::path folder_;
};

TEST_F(RealData, EveryRecordingIsRead) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
    if (entry.path().extension() != ".csv") continue;
    const auto result = readRecording(entry.path());
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_FALSE(hasErrors(result->findings)) << allLines(result->findings);
    EXPECT_TRUE(result->recording.wrench.allFinite());
    EXPECT_TRUE(result->recording.quaternion.allFinite());
    ++count;
  }
  EXPECT_GE(count, 6);
}

TEST_F(RealData, StandingPosesOfTheKuka) {
  const auto [recording, findings] = read("kuka_gamma_calibration_24_poses.csv");
  EXPECT_EQ(recording.rows(), 24);
  EXPECT_EQ(recording.meta.kind, RecordingKind::poses);
  EXPECT_EQ(recording.meta.gravity.z(), -9.82085);
  EXPECT_FALSE(recording.hasPosition());
  EXPECT_EQ(recording.wrench(0, 0), -9.32155) << "the file states the payload's wrench on the sensor";
  EXPECT_EQ(allLines(findings), "");
}

TEST_F(RealData, MotionOfTheKukaIsClean) {
  const auto [recording, findings] = read("kuka_gamma_baseline.csv");
  EXPECT_EQ(recording.rows(), 4370);
  EXPECT_NEAR(recording.rateHz(), 698.0, 1.0);
  EXPECT_EQ(allLines(findings), "");
}

TEST_F(RealData, PolledPandaRepeatsAThirdOfItsRows) {
  const auto [recording, findings] = read("panda_optoforce_14-23-21.csv");
  EXPECT_EQ(recording.rows(), 18465);
  EXPECT_TRUE(recording.hasPosition());
  const auto* repeats = findCode(findings, "wrench_repeated");
  ASSERT_NE(repeats, nullptr);
  EXPECT_THAT(repeats->text, testing::HasSubstr("34 %"));
}

TEST_F(RealData, IcubFootHasItsCadValues) {
  const auto [recording, findings] = read("icub_right_foot.csv");
  EXPECT_EQ(recording.rows(), 7470);
  EXPECT_NEAR(recording.rateHz(), 100.0, 1e-3);
  EXPECT_EQ(recording.meta.knownPayload.mass, 0.38227);
  EXPECT_EQ(recording.wrench(0, 0), -278.813);
}

}  // namespace
}  // namespace heft
