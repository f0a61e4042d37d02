#include "core/diagnosis/signals/sensor_range.h"

#include <gtest/gtest.h>

#include "core/diagnosis/causes/catalogue.h"
#include "core/diagnosis/causes/ids.h"
#include "tests/core/diagnosis/fixture.h"

namespace heft::test {
namespace {

using namespace diagnosis;

/// The range of ATI's data sheet, however the model's name is written.
TEST(SensorRange, IsKnownByTheModelsName) {
  for (const char* name : {"Schunk FT Gamma SI-32-2.5", "ATI gamma si_32_2.5", "GAMMA (SI 32-2.5)"}) {
    const auto range = sensorRange(name);
    ASSERT_TRUE(range) << name;
    EXPECT_EQ(*range, (Vector6d() << 32.0, 32.0, 100.0, 2.5, 2.5, 2.5).finished()) << name;
  }
  EXPECT_EQ((*sensorRange("ATI Mini45"))(2), 1160.0) << "the largest that it is sold with";
  EXPECT_EQ((*sensorRange("Axia80-M20"))(0), 500.0);
  EXPECT_EQ((*sensorRange("Robotiq FT 300-S"))(3), 30.0);
  EXPECT_FALSE(sensorRange("")) << "not stated";
  EXPECT_FALSE(sensorRange("a sensor of our own"));
}

/// A sensor that stays far from the end of its range is not at its limit.
TEST(SensorRange, BoundsWhatIsCalledALimit) {
  Recording recording = aRecording(MotionKind::excitation, 811);
  recording.wrench.col(0) *= 11.0 / recording.wrench.col(0).maxCoeff();  // [N] at most
  const Cause& saturation = *findCause(ids::saturation);
  const auto doubtOf = [&](const char* model) {
    recording.meta.sensorModel = model;
    const auto motion = motionOf(recording, &RobotModel::panda(), {}).value();
    const Signals signals = signalsOf(recording, motion, &RobotModel::panda());
    const Form form = saturation.forms(signals).front();
    return saturation.doubt(form, form.start, signals);
  };
  EXPECT_GT(doubtOf("ATI Gamma SI-130-10"), 1e6);
  EXPECT_EQ(doubtOf("ATI Nano17 SI-12-0.12"), 0.0);
  EXPECT_EQ(doubtOf(""), 0.0);
}

}  // namespace
}  // namespace heft::test
