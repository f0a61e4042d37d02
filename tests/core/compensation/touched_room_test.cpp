// A tool is guided against a table and a wall; what presses back is the world's, not the module's own inverse.
#include "core/compensation/touched_room.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/simulation/simulate.h"

namespace heft {
namespace {

const Payload kHammer{0.6, {0.0, 0.01, 0.05}, Vector3d(0.0012, 0.0013, 0.0006).asDiagonal().toDenseMatrix()};
const Vector3d kTip(0.0, 0.0, 0.15);  ///< Of a pin, S axes [m]

Shape pin() { return parseShape("cylinder:0.001,0.15@0,0,0.075").value(); }

/// A free motion in which whatever of the pin's tip is behind a plane is pressed back, with friction across it.
Recording pressedAgainst(const std::vector<RoomPlane>& planes, double friction, std::uint64_t seed) {
  SimulateOptions options;
  options.motion = MotionKind::free;
  options.seed = seed;
  options.duration = 40.0;
  options.rateHz = 200.0;
  options.speed = 0.4;
  auto simulated = simulate(RobotModel::panda(), kHammer, options);
  if (!simulated) throw std::runtime_error(simulated.error().message);
  Recording recording = std::move(simulated->recording);
  const RobotModel& panda = RobotModel::panda();
  const int flange = *panda.findLink("panda_link8");
  const Isometry3d X_LS = poseFromXyzRpy(recording.meta.mount.xyz, recording.meta.mount.rpy);
  Vector3d last = Vector3d::Zero();
  for (Eigen::Index i = 0; i < recording.rows(); ++i) {
    const Isometry3d X_BS = panda.linkPose(recording.q.row(i).transpose(), flange) * X_LS;
    const Vector3d tip = X_BS * kTip;
    for (const RoomPlane& plane : planes) {
      const double depth = plane.normal.dot(plane.point - tip);
      if (depth <= 0.0) continue;
      Vector3d force = 10000.0 * depth * plane.normal;
      const Vector3d along = (tip - last) - plane.normal.dot(tip - last) * plane.normal;
      if (along.norm() > 1e-6) force -= friction * force.norm() * along.normalized();
      const Vector3d f_S = X_BS.linear().transpose() * force;
      // What the sensor exerts on the payload is less by what the world does.
      recording.wrench.row(i).head<3>() -= f_S.transpose();
      recording.wrench.row(i).tail<3>() -= kTip.cross(f_S).transpose();
    }
    last = tip;
  }
  return recording;
}

/// A plane that the tip of the free motion comes behind by `depth` at most.
RoomPlane planeAcross(const Recording& recording, const Vector3d& normal, double depth) {
  const RobotModel& panda = RobotModel::panda();
  const Isometry3d X_LS = poseFromXyzRpy(recording.meta.mount.xyz, recording.meta.mount.rpy);
  std::vector<double> heights;
  for (Eigen::Index i = 0; i < recording.rows(); ++i)
    heights.push_back(
        normal.dot(panda.linkPose(recording.q.row(i).transpose(), *panda.findLink("panda_link8")) * X_LS * kTip));
  return {(*std::ranges::min_element(heights) + depth) * normal, normal};
}

TouchedRoom touchedIn(const Recording& recording) {
  CompensateOptions options;
  options.payload = {kHammer, {}};
  const auto compensated = compensate(recording, &RobotModel::panda(), options);
  if (!compensated) throw std::runtime_error(compensated.error().message);
  auto room = touchedRoom(recording, &RobotModel::panda(), *compensated, pin());
  if (!room) throw std::runtime_error(room.error().message);
  return std::move(*room);
}

TEST(TouchedRoom, TableAndWallAreFoundWhereTheyAre) {
  const Recording free = pressedAgainst({}, 0.0, 4);
  const RoomPlane table = planeAcross(free, Vector3d::UnitZ(), 0.003);
  const RoomPlane wall = planeAcross(free, Vector3d(-0.8, 0.6, 0.0), 0.003);
  for (const double friction : {0.0, 0.3})
    for (const auto& [name, truth] : {std::pair{"table", table}, std::pair{"wall", wall}}) {
      const TouchedRoom touched = touchedIn(pressedAgainst({truth}, friction, 4));
      const Room room = roomOf(touched, 0.03);
      EXPECT_EQ(room.margin, 0.03);
      ASSERT_EQ(room.obstacles.size(), 1u) << name << ", friction " << friction;
      EXPECT_EQ(room.obstacles[0].name, name);
      const auto& plane = std::get<RoomPlane>(room.obstacles[0].body);
      EXPECT_GT(plane.normal.dot(truth.normal), std::cos(0.1)) << name << ", friction " << friction;
      // It gives way by up to 3 mm, and the pin is 1 mm thick at its axis.
      EXPECT_NEAR(truth.normal.dot(plane.point - truth.point), 0.0, 0.005) << name;
    }
}

TEST(TouchedRoom, OnlyWhatMayBeLevelIsTakenAsLevel) {
  const Recording free = pressedAgainst({}, 0.0, 4);
  for (const double tilt : {0.0, 25.0}) {
    const Vector3d normal(0.0, std::sin(tilt * std::numbers::pi / 180.0), std::cos(tilt * std::numbers::pi / 180.0));
    const TouchedRoom touched = touchedIn(pressedAgainst({planeAcross(free, normal, 0.003)}, 0.3, 4));
    ASSERT_EQ(touched.planes.size(), 1u) << tilt;
    EXPECT_EQ(touched.planes[0].plumb, tilt == 0.0) << tilt;
    EXPECT_GT(touched.planes[0].plane.normal.dot(normal), std::cos(tilt == 0.0 ? 1e-6 : 0.15)) << tilt;
  }
}

TEST(TouchedRoom, WithoutATouchThereIsNone) { EXPECT_TRUE(touchedIn(pressedAgainst({}, 0.0, 5)).planes.empty()); }

}  // namespace
}  // namespace heft
