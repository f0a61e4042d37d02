#include "core/coach/deciding_pose.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/motion/motion.h"
#include "tests/core/coach/perform.h"
#include "tests/support/as_driver.h"

namespace heft {
namespace {

const Vector3d kDown(0.0, 0.0, -9.81);

GuidedTool pandaTool(const Recording& recording) {
  auto tool = guidedTool(RobotModel::panda(), recording.meta.mount);
  EXPECT_TRUE(tool.ok());
  return *tool;
}

/// The poses of `all` in which gravity has hardly a part along the sensor's x.
Recording withoutX(const Recording& all) {
  const auto motion = standingPoses(all, &RobotModel::panda());
  EXPECT_TRUE(motion.ok());
  std::vector<Eigen::Index> rows;
  for (Eigen::Index k = 0; k < all.rows(); ++k)
    if (std::abs((motion->R_BS[static_cast<std::size_t>(k)].transpose() * kDown.normalized()).x()) < 0.12)
      rows.push_back(k);
  Recording out = all;
  out.time = all.time(rows).eval();
  out.q = all.q(rows, Eigen::all).eval();
  out.wrench = all.wrench(rows, Eigen::all).eval();
  return out;
}

// A mirrored axis along which gravity never pulled: one pose that turns it down decides.
TEST(DecidingPose, TurnsDownWhatWasNeverDown) {
  const Recording poses = withoutX(test::standingRecording(test::onlineTool(), 160, kDown, 1.0, 3));
  ASSERT_GT(poses.rows(), 8);
  const conventions::Reading stated = conventions::statedIn(poses.meta);
  conventions::Reading mirrored = stated;
  mirrored.conventions.mirroredAxis = 0;
  const VectorXd from = poses.q.row(poses.rows() - 1).transpose();
  const auto pose = decidingPose(poses, pandaTool(poses), {stated, mirrored, "", ""}, from);
  ASSERT_TRUE(pose);
  EXPECT_GT(pose->apart, 4.0);
  const int link = *RobotModel::panda().findLink(poses.meta.mount.parent);
  const Matrix3d R = RobotModel::panda().linkPose(pose->q, link).linear() * rotationFromRpy(poses.meta.mount.rpy);
  EXPECT_GT(std::abs((R.transpose() * kDown.normalized()).x()), 0.5);
}

// The torque's sign and a centre on the other side are the same in every pose.
TEST(DecidingPose, NoneForAnExactTie) {
  const Recording poses = test::standingRecording(test::onlineTool(), 24, kDown, 1.0, 4);
  const conventions::Reading stated = conventions::statedIn(poses.meta);
  conventions::Reading opposite = stated;
  opposite.conventions.torqueSign = Conventions::TorqueSign::opposite;
  const VectorXd from = poses.q.row(poses.rows() - 1).transpose();
  EXPECT_FALSE(decidingPose(poses, pandaTool(poses), {stated, opposite, "", ""}, from));
}

}  // namespace
}  // namespace heft
