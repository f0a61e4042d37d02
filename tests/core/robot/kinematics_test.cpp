#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <random>

#include "core/robot/robot_model.h"

namespace heft {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// A row of the manufacturer's table, Craig's convention: [m] and [rad].
struct DhRow {
  double a, d, alpha;
};

constexpr std::array<DhRow, 7> kPandaTable{{{0, .333, 0},
                                            {0, 0, -kPi / 2},
                                            {0, .316, kPi / 2},
                                            {.0825, 0, kPi / 2},
                                            {-.0825, .384, -kPi / 2},
                                            {0, 0, kPi / 2},
                                            {.088, 0, kPi / 2}}};
constexpr double kFlange = .107;

/// Rx(alpha) Tx(a) Rz(theta) Tz(d), written out in elements so that it shares nothing with the code under test.
Matrix4d dhMatrix(const DhRow& row, double theta) {
  const double ct = std::cos(theta), st = std::sin(theta), ca = std::cos(row.alpha), sa = std::sin(row.alpha);
  Matrix4d T;
  T << ct, -st, 0, row.a,                  //
      st * ca, ct * ca, -sa, -row.d * sa,  //
      st * sa, ct * sa, ca, row.d * ca, 0, 0, 0, 1;
  return T;
}

/// Poses of link0 to link8 by the table.
std::vector<Matrix4d> tablePoses(const VectorXd& q) {
  std::vector<Matrix4d> poses{Matrix4d::Identity()};
  for (int k = 0; k < 7; ++k) poses.push_back(poses.back() * dhMatrix(kPandaTable[k], q[k]));
  Matrix4d flange = Matrix4d::Identity();
  flange(2, 3) = kFlange;
  poses.push_back(poses.back() * flange);
  return poses;
}

VectorXd randomPosture(const RobotModel& robot, std::mt19937_64& random) {
  VectorXd q(robot.dof());
  for (int k = 0; k < robot.dof(); ++k) {
    const double low = std::max(robot.limits(k).lower, -3.0), high = std::min(robot.limits(k).upper, 3.0);
    q[k] = std::uniform_real_distribution<double>(low, high)(random);
  }
  return q;
}

VectorXd randomVector(int size, double scale, std::mt19937_64& random) {
  VectorXd v(size);
  for (double& x : v) x = scale * std::normal_distribution<double>()(random);
  return v;
}

Isometry3d someMount() { return poseFromXyzRpy({0.03, -0.02, 0.05}, {0.4, -0.7, 1.1}); }

std::filesystem::path sharedFolder() {
  if (const char* given = std::getenv("HEFT_SHARED")) return given;
  return std::filesystem::path(HEFT_SOURCE_DIR) / ".." / "shared";
}

/// Turning about skewed axes, a slide in the middle, a mimic and a reversed axis: all that a Panda does not have.
const char* const kOddArm = R"(<robot name="odd">
  <link name="b"/><link name="l1"/><link name="l2"/><link name="l3"/><link name="l4"/><link name="l5"/>
  <joint name="j1" type="revolute"><parent link="b"/><child link="l1"/><origin xyz="0.1 0.2 0.3" rpy="0.3 -0.2 0.5"/>
    <axis xyz="0.6 0 0.8"/><limit lower="-2" upper="2" velocity="1" effort="1"/></joint>
  <joint name="j2" type="prismatic"><parent link="l1"/><child link="l2"/><origin xyz="0 0.1 0.4" rpy="1 0.2 -0.4"/>
    <axis xyz="0 -1 0"/><limit lower="-0.5" upper="0.7" velocity="1" effort="1"/></joint>
  <joint name="j3" type="continuous"><parent link="l2"/><child link="l3"/><origin xyz="0.2 0 0"/>
    <axis xyz="0 0 -1"/></joint>
  <joint name="j4" type="revolute"><parent link="l3"/><child link="l4"/><origin xyz="0.2 0.1 0" rpy="0 1.2 0"/>
    <axis xyz="1 0 0"/><mimic joint="j1" multiplier="-1.5" offset="0.3"/>
    <limit lower="-6" upper="6" velocity="1" effort="1"/></joint>
  <joint name="j5" type="revolute"><parent link="l4"/><child link="l5"/><origin xyz="0 0.1 0.2" rpy="0.1 0.2 0.3"/>
    <axis xyz="0 1 0"/><limit lower="-1" upper="3" velocity="1" effort="1"/></joint>
</robot>)";

RobotModel oddArm() {
  Findings findings;
  return RobotModel::fromUrdfText(kOddArm, ".", findings).value();
}

TEST(Panda, forwardKinematicsEqualTheTable) {
  const RobotModel& panda = RobotModel::panda();
  ASSERT_EQ(panda.dof(), 7);
  std::mt19937_64 random(1);
  std::vector<Isometry3d> poses;
  for (int trial = 0; trial < 500; ++trial) {
    const VectorXd q = randomPosture(panda, random);
    const std::vector<Matrix4d> expected = tablePoses(q);
    panda.linkPoses(q, poses);
    for (int k = 0; k <= 8; ++k) {
      const std::optional<int> link = panda.findLink("panda_link" + std::to_string(k));
      ASSERT_TRUE(link);
      EXPECT_LT((poses[*link].matrix() - expected[k]).cwiseAbs().maxCoeff(), 1e-12) << "link " << k;
      EXPECT_LT((panda.linkPose(q, *link).matrix() - expected[k]).cwiseAbs().maxCoeff(), 1e-12) << "link " << k;
    }
  }
}

TEST(Panda, handSitsTurnedOnTheFlange) {
  const RobotModel& panda = RobotModel::panda();
  const VectorXd q = panda.homePosture();
  const Isometry3d X_FH =
      panda.linkPose(q, *panda.findLink("panda_link8")).inverse() * panda.linkPose(q, *panda.findLink("panda_hand"));
  EXPECT_LT((X_FH.linear() - rotationFromRpy({0, 0, -kPi / 4})).norm(), 1e-12);
  EXPECT_LT(X_FH.translation().norm(), 1e-12);
}

TEST(Panda, limitsAreTheTables) {
  const RobotModel& panda = RobotModel::panda();
  const std::array<double, 7> lower{-2.8973, -1.7628, -2.8973, -3.0718, -2.8973, -.0175, -2.8973};
  const std::array<double, 7> upper{2.8973, 1.7628, 2.8973, -.0698, 2.8973, 3.7525, 2.8973};
  const std::array<double, 7> velocity{2.175, 2.175, 2.175, 2.175, 2.61, 2.61, 2.61};
  const std::array<double, 7> acceleration{15, 7.5, 10, 12.5, 15, 20, 20};
  for (int k = 0; k < 7; ++k) {
    EXPECT_EQ(panda.limits(k).lower, lower[k]);
    EXPECT_EQ(panda.limits(k).upper, upper[k]);
    EXPECT_EQ(panda.limits(k).velocity, velocity[k]);
    EXPECT_EQ(panda.limits(k).acceleration, acceleration[k]);
    EXPECT_EQ(panda.joints()[panda.movingJoints()[k]].name, "panda_joint" + std::to_string(k + 1));
  }
}

TEST(Panda, homeIsTheReadyPose) {
  VectorXd ready(7);
  ready << 0, -kPi / 4, 0, -3 * kPi / 4, 0, kPi / 2, kPi / 4;
  EXPECT_LT((RobotModel::panda().homePosture() - ready).norm(), 1e-15);
}

TEST(Panda, equalsTheManufacturersDescription) {
  const auto file = sharedFolder() / "franka_description" / "urdf" / "panda.urdf";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no franka_description beside the project";
  Findings findings;
  const Result<RobotModel> other = RobotModel::fromUrdfFile(file, findings);
  ASSERT_TRUE(other) << other.error().message;
  for (const Finding& finding : findings) ADD_FAILURE() << toLine(finding);
  const RobotModel& panda = RobotModel::panda();
  ASSERT_EQ(other->dof(), 7);
  EXPECT_EQ(other->homePosture(), panda.homePosture());
  std::mt19937_64 random(2);
  for (int trial = 0; trial < 100; ++trial) {
    const VectorXd q = randomPosture(panda, random);
    for (const Link& link : other->links()) {
      const auto ours = panda.findLink(link.name);
      ASSERT_TRUE(ours) << link.name;
      const Matrix4d difference =
          panda.linkPose(q, *ours).matrix() - other->linkPose(q, *other->findLink(link.name)).matrix();
      EXPECT_LT(difference.cwiseAbs().maxCoeff(), 1e-12) << link.name;
    }
  }
  for (const Link& link : other->links()) {
    for (const Visual& visual : link.visuals) EXPECT_TRUE(std::filesystem::exists(visual.file)) << visual.file;
  }
  for (int k = 0; k < 7; ++k) {
    EXPECT_EQ(other->limits(k).lower, panda.limits(k).lower);
    EXPECT_EQ(other->limits(k).velocity, panda.limits(k).velocity);
  }
}

/// The Panda and an arm of all other kinds of joints, with one test body each.
class Kinematics : public ::testing::TestWithParam<bool> {
 protected:
  Kinematics() : robot_(GetParam() ? RobotModel::panda() : oddArm()) {}
  int tip() const { return static_cast<int>(robot_.links().size()) - 1; }
  RobotModel robot_;
};

TEST_P(Kinematics, frameMotionEqualsFiniteDifferences) {
  std::mt19937_64 random(3);
  const Isometry3d X_LS = someMount();
  for (int trial = 0; trial < 50; ++trial) {
    const VectorXd q = randomPosture(robot_, random), dq = randomVector(robot_.dof(), 1.0, random),
                   ddq = randomVector(robot_.dof(), 3.0, random);
    const VectorXd none = VectorXd::Zero(robot_.dof());
    const auto at = [&](double t) {
      return robot_.frameMotion(tip(), X_LS, q + t * dq + 0.5 * t * t * ddq, dq + t * ddq, ddq);
    };
    const double h = 1e-5;
    const FrameMotion before = at(-h), now = at(0), after = at(h);
    const Vector3d v = (after.X_BS.translation() - before.X_BS.translation()) / (2 * h);
    const Vector3d w = vectorFromRotation(after.X_BS.linear() * before.X_BS.linear().transpose()) / (2 * h);
    const Vector3d a = (after.v_BSo_B - before.v_BSo_B) / (2 * h);
    const Vector3d alpha = (after.w_BS_B - before.w_BS_B) / (2 * h);
    EXPECT_LT((now.v_BSo_B - v).norm(), 1e-7 * (1 + v.norm()));
    EXPECT_LT((now.w_BS_B - w).norm(), 1e-7 * (1 + w.norm()));
    EXPECT_LT((now.a_BSo_B - a).norm(), 1e-7 * (1 + a.norm()));
    EXPECT_LT((now.alpha_BS_B - alpha).norm(), 1e-7 * (1 + alpha.norm()));
    EXPECT_GT(now.a_BSo_B.norm(), 1e-3);
    // A standing arm neither moves nor accelerates.
    const FrameMotion still = robot_.frameMotion(tip(), X_LS, q, none, none);
    EXPECT_EQ(still.a_BSo_B.norm() + still.v_BSo_B.norm() + still.w_BS_B.norm() + still.alpha_BS_B.norm(), 0.0);
    EXPECT_TRUE(still.X_BS.isApprox(robot_.linkPose(q, tip()) * X_LS, 1e-12));
  }
}

TEST_P(Kinematics, jacobianTimesSpeedIsTheVelocity) {
  std::mt19937_64 random(4);
  const Isometry3d X_LS = someMount();
  for (int trial = 0; trial < 50; ++trial) {
    for (int link = 0; link <= tip(); ++link) {
      const VectorXd q = randomPosture(robot_, random), dq = randomVector(robot_.dof(), 1.0, random);
      const MatrixXd J = robot_.jacobian(link, X_LS, q);
      ASSERT_EQ(J.rows(), 6);
      ASSERT_EQ(J.cols(), robot_.dof());
      const FrameMotion motion = robot_.frameMotion(link, X_LS, q, dq, VectorXd::Zero(robot_.dof()));
      const Vector6d twist = J * dq;
      EXPECT_LT((twist.head<3>() - motion.v_BSo_B).norm(), 1e-12);
      EXPECT_LT((twist.tail<3>() - motion.w_BS_B).norm(), 1e-12);
    }
  }
}

TEST_P(Kinematics, linkPosesAgreeWithTheChains) {
  std::mt19937_64 random(5);
  std::vector<Isometry3d> poses;
  for (int trial = 0; trial < 50; ++trial) {
    const VectorXd q = randomPosture(robot_, random);
    robot_.linkPoses(q, poses);
    ASSERT_EQ(poses.size(), robot_.links().size());
    for (int link = 0; link <= tip(); ++link) {
      EXPECT_LT((poses[link].matrix() - robot_.linkPose(q, link).matrix()).cwiseAbs().maxCoeff(), 1e-12);
    }
  }
}

TEST_P(Kinematics, clampingBringsBackInside) {
  std::mt19937_64 random(6);
  const VectorXd q = randomPosture(robot_, random);
  EXPECT_EQ(robot_.clampToLimits(q), q);
  const VectorXd home = robot_.homePosture();
  EXPECT_EQ(robot_.clampToLimits(home), home);
  for (int k = 0; k < robot_.dof(); ++k) {
    const VectorXd far = q + 100.0 * VectorXd::Unit(robot_.dof(), k);
    EXPECT_EQ(robot_.clampToLimits(far)[k], std::min(far[k], robot_.limits(k).upper));
    EXPECT_EQ(robot_.clampToLimits(-far)[k], std::max(-far[k], robot_.limits(k).lower));
  }
}

TEST_P(Kinematics, wrongSizesAreRefused) {
  const VectorXd shorter = VectorXd::Zero(robot_.dof() - 1), right = VectorXd::Zero(robot_.dof());
  const Isometry3d X_LS = Isometry3d::Identity();
  std::vector<Isometry3d> poses;
  EXPECT_THROW(robot_.linkPoses(shorter, poses), std::invalid_argument);
  EXPECT_THROW(robot_.linkPose(shorter, 0), std::invalid_argument);
  EXPECT_THROW(robot_.frameMotion(0, X_LS, right, shorter, right), std::invalid_argument);
  EXPECT_THROW(robot_.frameMotion(0, X_LS, right, right, shorter), std::invalid_argument);
  EXPECT_THROW(robot_.frameMotion(tip() + 1, X_LS, right, right, right), std::invalid_argument);
  EXPECT_THROW(robot_.jacobian(-1, X_LS, right), std::invalid_argument);
  EXPECT_THROW(robot_.clampToLimits(shorter), std::invalid_argument);
}

INSTANTIATE_TEST_SUITE_P(Robots, Kinematics, ::testing::Bool(),
                         [](const auto& name) { return name.param ? "panda" : "odd_arm"; });

TEST(OddArm, hasTheExpectedColumnsAndLimits) {
  const RobotModel robot = oddArm();
  ASSERT_EQ(robot.dof(), 4);
  std::vector<std::string> names;
  for (const int joint : robot.movingJoints()) names.push_back(robot.joints()[joint].name);
  EXPECT_EQ(names, (std::vector<std::string>{"j1", "j2", "j3", "j5"}));
  EXPECT_EQ(robot.limits(1).upper, 0.7);
  EXPECT_TRUE(std::isinf(robot.limits(2).lower));
  EXPECT_TRUE(std::isinf(robot.limits(2).velocity));
  EXPECT_TRUE(std::isinf(robot.limits(0).acceleration));
  EXPECT_NEAR(robot.homePosture()[1], 0.1, 1e-15);
  EXPECT_EQ(robot.homePosture()[2], 0.0);
}

TEST(OddArm, posesAreTheProductWrittenOut) {
  const RobotModel robot = oddArm();
  VectorXd q(4);
  q << 0.3, 0.2, -0.7, 1.1;
  using Eigen::AngleAxisd;
  const Isometry3d expected = poseFromXyzRpy({0.1, 0.2, 0.3}, {0.3, -0.2, 0.5}) *
                              AngleAxisd(0.3, Vector3d(0.6, 0, 0.8)) * poseFromXyzRpy({0, 0.1, 0.4}, {1, 0.2, -0.4}) *
                              Eigen::Translation3d(0, -0.2, 0) * poseFromXyzRpy({0.2, 0, 0}, {0, 0, 0}) *
                              AngleAxisd(0.7, Vector3d::UnitZ()) * poseFromXyzRpy({0.2, 0.1, 0}, {0, 1.2, 0}) *
                              AngleAxisd(-1.5 * 0.3 + 0.3, Vector3d::UnitX()) *
                              poseFromXyzRpy({0, 0.1, 0.2}, {0.1, 0.2, 0.3}) * AngleAxisd(1.1, Vector3d::UnitY());
  EXPECT_LT((robot.linkPose(q, 5).matrix() - expected.matrix()).cwiseAbs().maxCoeff(), 1e-13);
}

}  // namespace
}  // namespace heft
