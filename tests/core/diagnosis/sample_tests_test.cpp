// What single readings show.
#include "core/diagnosis/sample_tests.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/core/diagnosis/fixture.h"

namespace heft::test {
namespace {

std::vector<std::string> directCauses(const Recording& recording) {
  MotionOptions options;
  options.cutoffHz = 25.0;
  const auto motion = motionOf(recording, &RobotModel::panda(), options);
  std::vector<std::string> out;
  for (const auto& direct : diagnosis::sampleTests(recording, *motion)) out.push_back(direct.cause);
  return out;
}

TEST(SampleTests, SilentOnCleanRecordings) {
  for (const auto motion : {MotionKind::free, MotionKind::excitation, MotionKind::pickAndPlace})
    EXPECT_TRUE(directCauses(aRecording(motion, 11)).empty()) << toString(motion);
}

TEST(SampleTests, EachNamesItsOwn) {
  for (const auto& [effect, cause] : std::vector<std::pair<EffectRequest, std::string>>{
           {{"saturation", "", 6.0}, "saturation"},
           {{"spikes", "", 0.5}, "spikes"},
           {{"dropouts", "", 6.0}, "dropouts"},
           {{"dropouts", "zeros", 4.0}, "dropouts"},
           {{"motion_lag", "", 30.0}, "motion_lag"}}) {
    const auto found = directCauses(aRecording(MotionKind::free, 12, {effect}));
    EXPECT_NE(std::find(found.begin(), found.end(), cause), found.end()) << effect.id << "/" << effect.form;
  }
}

}  // namespace
}  // namespace heft::test
