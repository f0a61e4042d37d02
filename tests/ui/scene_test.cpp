#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "tests/ui/fixtures.h"
#include "ui/robot_look/robot_look.h"
#include "ui/robot_view/orbit_camera.h"
#include "ui/robot_view/posed_arm.h"
#include "ui/robot_view/robot_view.h"
#include "ui/robot_view/scene_state.h"
#include "ui/robot_view/scene_track.h"
#include "ui/robot_view/soft_shadow.h"

namespace heft {
namespace {

TEST(OrbitCamera, AxesAreOrthogonalAndUpright) {
  OrbitCamera camera;
  for (const double azimuth : {-3.0, -0.4, 0.0, 1.2, 2.9}) {
    for (const double elevation : {-0.3, 0.0, 0.7, 1.5}) {
      camera.azimuth = azimuth;
      camera.elevation = elevation;
      const Vector3d forward = (camera.target - camera.position()).normalized();
      EXPECT_NEAR(camera.right().dot(forward), 0, 1e-12);
      EXPECT_NEAR(camera.right().dot(camera.pictureUp()), 0, 1e-12);
      EXPECT_NEAR((camera.right().cross(camera.pictureUp()) + forward).norm(), 0, 1e-12);
      EXPECT_GT(camera.pictureUp().z(), 0);
      EXPECT_NEAR((camera.position() - camera.target).norm(), camera.distance, 1e-12);
    }
  }
}

TEST(OrbitCamera, DraggingNeverTurnsOverThePole) {
  OrbitCamera camera;
  for (int i = 0; i < 1000; ++i) camera.orbit(7, 13);
  EXPECT_LT(camera.elevation, M_PI / 2);
  for (int i = 0; i < 1000; ++i) camera.orbit(7, -13);
  EXPECT_GT(camera.elevation, -M_PI / 2);
  for (int i = 0; i < 1000; ++i) camera.dolly(0.5);
  EXPECT_GT(camera.distance, 0);
}

TEST(OrbitCamera, PanningMovesThePointUnderThePointerWithIt) {
  OrbitCamera camera;
  const Vector3d before = camera.target;
  camera.pan(100, 0, 500);
  const double metres = 100 * 2 * camera.distance * std::tan(camera.viewAngle / 2) / 500;
  EXPECT_NEAR((camera.target - (before - metres * camera.right())).norm(), 0, 1e-12);
}

/// A centre that nobody knows and one that is known too well to draw its region both have none.
TEST(PayloadLook, TellsAnUnknownCentreFromOneThatIsKnownWell) {
  EstimateReport report;
  report.payload.mass = 0.8;
  const auto lookWith = [&](double std) {
    report.std.com.setConstant(std);
    return payloadLook(report);
  };
  EXPECT_FALSE(lookWith(0.1).centreKnown);
  EXPECT_EQ(lookWith(0.1).region, Vector3d::Zero());
  EXPECT_TRUE(lookWith(1e-5).centreKnown);
  EXPECT_EQ(lookWith(1e-5).region, Vector3d::Zero());
  EXPECT_TRUE(lookWith(3e-3).centreKnown);
  EXPECT_GT(lookWith(3e-3).region.minCoeff(), 0.0);
}

TEST(SceneTrack, PosesAreInterpolated) {
  auto recording = std::make_shared<const Recording>(test::sineRecording(1001, 100));
  const SceneTrack track(recording, nullptr);
  EXPECT_FALSE(track.hasJoints());
  EXPECT_TRUE(track.positionKnown());
  for (const double t : {0.0, 1.234, 5.005, 10.0}) {
    const Isometry3d X = track.sensorAt(t);
    EXPECT_NEAR((X.translation() - Vector3d(t, 2 * t, 0.5)).norm(), 0, 1e-9);
    EXPECT_NEAR((X.linear() - rotationFromRpy({0, 0, t})).norm(), 0, 1e-9);
  }
  // Outside the recording its ends hold.
  EXPECT_NEAR(track.sensorAt(99).translation().x(), 10.0, 1e-9);
  EXPECT_NEAR(track.sensorAt(-99).translation().x(), 0.0, 1e-9);
  const auto path = track.path(-1e9, 1e9, 11);
  ASSERT_EQ(path.size(), 11u);
  EXPECT_NEAR(path[5].p_BSo_B.x(), 5.0, 1e-9);
  EXPECT_NEAR(path.back().time, 10.0, 1e-9);
  // A part of it: of a long recording that is what one can look at.
  const auto part = track.path(2.5, 7.2, 1000);
  ASSERT_GT(part.size(), 2u);
  EXPECT_GE(part.front().time, 2.5);
  EXPECT_LT(part.front().time, 3.6);
  EXPECT_LE(part.back().time, 7.2);
  EXPECT_GT(part.back().time, 6.1);
  EXPECT_TRUE(track.path(20.0, 30.0, 100).empty());
}

TEST(SceneTrack, JointsGiveTheSamePoseAsTheRobot) {
  const RobotModel& panda = RobotModel::panda();
  auto recording = std::make_shared<Recording>();
  recording->time = VectorXd::LinSpaced(3, 0, 2);
  recording->q.resize(3, 7);
  for (int i = 0; i < 3; ++i) recording->q.row(i) = panda.homePosture().transpose().array() + 0.1 * i;
  recording->wrench.setZero(3, 6);
  recording->meta.mount.xyz = {0, 0, 0.04};
  const SceneTrack track(recording, std::make_shared<const RobotModel>(panda));
  ASSERT_TRUE(track.hasJoints());
  const VectorXd q = panda.homePosture().array() + 0.05;
  const Isometry3d wanted =
      panda.linkPose(q, *panda.findLink("panda_link8")) * poseFromXyzRpy(Vector3d(0, 0, 0.04), Vector3d::Zero());
  EXPECT_NEAR((track.sensorAt(0.5).matrix() - wanted.matrix()).norm(), 0, 1e-12);
}

TEST(PosedArm, ReachesThePosesOfARecordingOrStaysAway) {
  const RobotModel& panda = RobotModel::panda();
  const std::shared_ptr<const RobotModel> robot(std::shared_ptr<void>(), &panda);
  const int flange = *panda.findLink("panda_link8");
  Recording recording;
  constexpr int kRows = 300;
  recording.time = VectorXd::LinSpaced(kRows, 0.0, 6.0);
  recording.position.resize(kRows, 3);
  recording.quaternion.resize(kRows, 4);
  recording.meta.mount.xyz = {0.0, 0.02, 0.05};
  const Isometry3d X_FS = poseFromXyzRpy(recording.meta.mount.xyz, recording.meta.mount.rpy);
  for (int n = 0; n < kRows; ++n) {
    VectorXd q = panda.homePosture();
    for (int j = 0; j < q.size(); ++j) q(j) += 0.35 * std::sin(0.5 * (j + 1) * recording.time(n));
    const Isometry3d X_BS = panda.linkPose(panda.clampToLimits(q), flange) * X_FS;
    const Quaterniond turned(X_BS.linear());
    recording.position.row(n) = X_BS.translation().transpose();
    recording.quaternion.row(n) << turned.x(), turned.y(), turned.z(), turned.w();
  }
  const SceneTrack track(std::make_shared<const Recording>(recording), nullptr);
  const auto arm = PosedArm::follow(track, recording.meta.mount, 0.0, 6.0, robot);
  ASSERT_TRUE(arm.has_value());
  for (const double time : {0.0, 1.234, 3.0, 5.9}) {
    const Isometry3d X_BS = panda.linkPose(arm->jointsAt(time), flange) * X_FS;
    EXPECT_LT((X_BS.translation() - track.sensorAt(time).translation()).norm(), 0.003) << time;
  }
  // Of an arm that stood elsewhere no picture is invented.
  recording.position.col(0).array() += 2.0;
  const SceneTrack away(std::make_shared<const Recording>(recording), nullptr);
  EXPECT_FALSE(PosedArm::follow(away, recording.meta.mount, 0.0, 6.0, robot));
}

TEST(SceneTrack, OrientationOnlyTurnsInPlace) {
  auto recording = std::make_shared<Recording>(test::sineRecording(101, 100));
  recording->position.resize(0, 3);
  const SceneTrack track(recording, nullptr);
  EXPECT_FALSE(track.positionKnown());
  EXPECT_TRUE(track.path(-1e9, 1e9, 100).empty());
  EXPECT_EQ(track.sensorAt(0).translation(), track.sensorAt(1).translation());
  EXPECT_GT((track.sensorAt(0).linear() - track.sensorAt(1).linear()).norm(), 0.1);
}

TEST(SceneTrack, StandingPosesSnapToTheNearest) {
  auto recording = std::make_shared<Recording>(test::sineRecording(5, 1));
  recording->meta.kind = RecordingKind::poses;
  const SceneTrack track(recording, nullptr);
  EXPECT_NEAR(track.sensorAt(2.4).translation().x(), 1.0, 1e-12);
  EXPECT_NEAR(track.sensorAt(2.6).translation().x(), 2.0, 1e-12);
  EXPECT_NEAR(track.wrenchAt(5.0)(2), -1.0, 1e-12);
}

TEST(SoftShadow, LiesUnderTheBodyAndFadesWithHeight) {
  const auto darkest = [](double height) {
    SoftShadow shadow;
    shadow.clear();
    for (double x = -0.1; x <= 0.1; x += 0.01) {
      for (double y = -0.1; y <= 0.1; y += 0.01) shadow.add({x, y, height});
    }
    const auto& cells = shadow.finish();
    return *std::max_element(cells.begin(), cells.end());
  };
  EXPECT_GT(darkest(0.0), darkest(0.4));
  EXPECT_GT(darkest(0.4), darkest(1.0));
  EXPECT_GT(darkest(1.0), 0);
  SoftShadow empty;
  empty.clear();
  const auto& cells = empty.finish();
  EXPECT_EQ(std::accumulate(cells.begin(), cells.end(), 0), 0);
}

TEST(SoftShadow, PointsOutsideThePatchAreLeftOut) {
  SoftShadow shadow;
  shadow.clear();
  shadow.add({50, -50, 0});
  shadow.add({-50, 1e6, 3});
  const auto& cells = shadow.finish();
  EXPECT_EQ(std::accumulate(cells.begin(), cells.end(), 0), 0);
}

TEST(RobotLook, AMissingMeshIsAFindingAndNotTheEnd) {
  Findings findings;
  const auto robot = RobotModel::fromUrdfText(R"(<robot name="one"><link name="base"><visual><geometry>
      <mesh filename="nowhere.stl"/></geometry></visual><visual><geometry><box size="1 2 3"/></geometry></visual></link>
      <link name="tip"/><joint name="j" type="revolute"><parent link="base"/><child link="tip"/><axis xyz="0 0 1"/>
      <limit lower="-1" upper="1" effort="1" velocity="1"/></joint></robot>)",
                                              "/", findings);
  ASSERT_TRUE(robot.ok()) << robot.error().message;
  findings.clear();
  const RobotLook look = loadLook(*robot, findings);
  ASSERT_EQ(look.parts.size(), 1u);
  EXPECT_EQ(look.parts[0].visual.kind, Visual::Kind::box);
}

}  // namespace
}  // namespace heft
