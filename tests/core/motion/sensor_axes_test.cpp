// Recordings in every convention read as the plain one.
#include "core/motion/sensor_axes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/motion/motion.h"
#include "core/recording/csv_reader.h"
#include "tests/support/in_conventions.h"

namespace heft {
namespace {

using namespace testing_support;
using ::testing::HasSubstr;

Result<ReadRecording> readIn(const nlohmann::json& meta, const PlainMotion& motion, MotionForm form) {
  Findings findings;
  auto stated = parseMeta(withRig(meta, motion.recording.meta).dump(), "rec.meta.json", ".", findings);
  if (!stated) return stated.error();
  return parseRecording(numbersIn(meta, motion, form).csv(), "rec.csv", std::move(*stated));
}

TEST(SensorAxes, EveryConventionReadsAsThePlainForm) {
  const PlainMotion motion;
  for (const auto& meta : conventionsToTry()) {
    for (const auto form : {MotionForm::joints, MotionForm::poses}) {
      SCOPED_TRACE(meta.dump() + (form == MotionForm::joints ? " joints" : " poses"));
      auto read = readIn(meta, motion, form);
      ASSERT_TRUE(read) << read.error().message;
      const auto done = toSensorAxes(read->recording, &RobotModel::panda());
      ASSERT_TRUE(done) << done.error().message;
      EXPECT_LT(differenceFrom(motion, read->recording), 1e-12);
      // Once is enough.
      ASSERT_TRUE(toSensorAxes(read->recording, &RobotModel::panda()));
      EXPECT_LT(differenceFrom(motion, read->recording), 1e-12);
      EXPECT_EQ(toJson(read->recording.meta.conventions).empty(),
                meta.empty() || (meta.size() == 1 && meta.contains("sensor") && meta["sensor"].size() == 1 &&
                                 meta["sensor"].contains("wrench_sign")))
          << "what the file said is kept";
    }
  }
}

TEST(SensorAxes, TheRobotOfTheMetaIsFoundWhereItIsNeeded) {
  const PlainMotion motion;
  auto read = readIn({{"sensor", {{"wrench_axes", "base"}}}}, motion, MotionForm::joints);
  ASSERT_TRUE(read);
  EXPECT_TRUE(read->recording.wrenchNeedsPose);
  EXPECT_THROW((void)motionOf(read->recording, &RobotModel::panda(), {}), std::logic_error) << "nobody may forget it";
  ASSERT_TRUE(toSensorAxes(read->recording));
  EXPECT_LT(differenceFrom(motion, read->recording), 1e-12);
}

TEST(SensorAxes, WithoutTheSensorsPoseItSaysWhatIsMissing) {
  const PlainMotion motion;
  auto joints = readIn({{"sensor", {{"wrench_axes", "base"}}}}, motion, MotionForm::joints);
  ASSERT_TRUE(joints);
  const auto noRobot = toSensorAxes(joints->recording, nullptr);
  ASSERT_FALSE(noRobot);
  EXPECT_THAT(noRobot.error().message, HasSubstr("there is no robot to show where the sensor was"));

  auto orientation = readIn({{"sensor", {{"wrench_point", "base"}}}}, motion, MotionForm::poses);
  ASSERT_TRUE(orientation);
  orientation->recording.position.resize(0, 3);
  const auto nowhere = toSensorAxes(orientation->recording, nullptr);
  ASSERT_FALSE(nowhere);
  EXPECT_THAT(nowhere.error().message, HasSubstr("Record px, py, pz"));
}

TEST(SensorAxes, AZeroThatTurnsWithTheSensorIsConstantAfterwards) {
  // A sensor that measures its zero alone, shown in base axes: what is read is R_BS b.
  PlainMotion motion;
  motion.recording.wrench.rowwise() = (Vector6d() << 1.0, -2.0, 3.0, 0.1, 0.2, -0.3).finished().transpose();
  auto read = readIn({{"sensor", {{"wrench_axes", "base"}, {"wrench_point", "base"}}}}, motion, MotionForm::joints);
  ASSERT_TRUE(read);
  ASSERT_TRUE(toSensorAxes(read->recording));
  EXPECT_LT(differenceFrom(motion, read->recording), 1e-12);
}

}  // namespace
}  // namespace heft
