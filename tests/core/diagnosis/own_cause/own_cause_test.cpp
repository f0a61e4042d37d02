// The guide core/diagnosis/causes/README.md, followed: a cause in one file, registered by one line, is found.
#include <gtest/gtest.h>

#include "core/diagnosis/causes/catalogue.h"
#include "core/diagnosis/wording/words.h"
#include "tests/core/diagnosis/fixture.h"
#include "tests/core/diagnosis/own_cause/spinning_rotor.h"

namespace heft::test {
namespace {

/// A tool with a rotor of that angular momentum [N m s, S axes].
Recording withRotor(const Vector3d& h) {
  Recording recording = aRecording(MotionKind::pickAndPlace, 303);
  const auto motion = motionOf(recording, &RobotModel::panda(), {}).value();
  for (Eigen::Index i = 0; i < recording.rows(); ++i) {
    const Eigen::Index k = sampleAt(motion, recording.time(i));
    recording.wrench.row(i).tail<3>() += Vector3d(motion.omega.col(k)).cross(h).transpose();
  }
  return recording;
}

TEST(OwnCause, IsUnknownUntilItIsInTheCatalogueAndThenFound) {
  const Vector3d h(-0.03, 0.02, 0.05);
  const Recording recording = withRotor(h);
  EXPECT_EQ(diagnosed(recording).verdict, Verdict::unexplained);

  diagnosis::registerCause(diagnosis::makeSpinningRotor());

  const auto report = diagnosed(recording);
  EXPECT_EQ(report.verdict, Verdict::explained) << said(report);
  const auto* rotor = named(report, "spinning_rotor");
  ASSERT_NE(rotor, nullptr) << said(report);
  EXPECT_EQ(rotor->title, "Something spins in the tool");
  EXPECT_TRUE(rotor->sentence.starts_with("Something spins in the tool, with 0.06")) << rotor->sentence;
  ASSERT_EQ(rotor->parameters.size(), 3u);
  for (Eigen::Index i = 0; i < 3; ++i)
    EXPECT_NEAR(rotor->parameters[static_cast<std::size_t>(i)].value, h(i), 0.002) << i;

  // And it takes nothing from a recording without it.
  const auto without = diagnosed(aRecording(MotionKind::pickAndPlace, 303));
  EXPECT_EQ(named(without, "spinning_rotor"), nullptr) << said(without);
}

}  // namespace
}  // namespace heft::test
