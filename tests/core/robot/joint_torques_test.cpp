#include "core/robot/joint_torques.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace heft {
namespace {

constexpr double kG = 9.81;
const Vector3d kGravity(0.0, 0.0, -kG);

RobotModel robotOf(const std::string& links, const std::string& joints) {
  Findings findings;
  auto model = RobotModel::fromUrdfText("<robot name=\"r\">" + links + joints + "</robot>", {}, findings);
  if (!model) throw std::runtime_error(model.error().message);
  return std::move(*model);
}

const char* const kJoint =
    R"(<joint name="j" type="revolute"><parent link="a"/><child link="b"/><axis xyz="0 1 0"/>
       <limit lower="-3" upper="3" velocity="1" effort="5"/></joint>)";

TEST(JointTorques, OfAPendulumAreThoseOfItsFormula) {
  const RobotModel pendulum =
      robotOf(R"(<link name="a"/><link name="b"><inertial><origin xyz="0.3 0 0" rpy="0 0 1.5707963267948966"/>
                 <mass value="2"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.02" iyz="0" izz="0.025"/></inertial></link>)",
              kJoint);
  EXPECT_EQ(pendulum.limits(0).effort, 5.0);
  EXPECT_TRUE(statesTorques(pendulum));
  // Its own axes are turned by a quarter about z, so that what it has about x is the pendulum's about y.
  const double about = 0.01 + 2.0 * 0.3 * 0.3;
  for (const double q : {0.0, 0.7, -1.9}) {
    const VectorXd torque = jointTorques(pendulum, kGravity, std::nullopt, VectorXd::Constant(1, q),
                                         VectorXd::Constant(1, 1.3), VectorXd::Constant(1, -2.5));
    EXPECT_NEAR(torque(0), about * -2.5 - 2.0 * kG * 0.3 * std::cos(q), 1e-12) << q;
    const CarriedBody load{1, {0.5, {0.6, 0.0, 0.0}, Matrix3d::Zero()}};
    const VectorXd loaded = jointTorques(pendulum, kGravity, load, VectorXd::Constant(1, q), VectorXd::Constant(1, 1.3),
                                         VectorXd::Constant(1, -2.5));
    EXPECT_NEAR(loaded(0) - torque(0), 0.5 * 0.36 * -2.5 - 0.5 * kG * 0.6 * std::cos(q), 1e-12) << q;
  }
}

/// Kinetic and potential energy of the masses that the robot states and of a load.
double energyOf(const RobotModel& robot, const CarriedBody& load, const VectorXd& q, const VectorXd& dq) {
  double energy = 0.0;
  const auto add = [&](int link, const BodyInertia& body) {
    Isometry3d X_LC = Isometry3d::Identity();
    X_LC.translation() = body.com;
    const FrameMotion m = robot.frameMotion(link, X_LC, q, dq, VectorXd::Zero(q.size()));
    const Vector3d w = m.X_BS.linear().transpose() * m.w_BS_B;
    energy += 0.5 * body.mass * m.v_BSo_B.squaredNorm() + 0.5 * w.dot(body.inertiaCom * w) +
              body.mass * kG * m.X_BS.translation().z();
  };
  for (int i = 0; i < static_cast<int>(robot.links().size()); ++i)
    if (robot.links()[static_cast<std::size_t>(i)].inertia) add(i, *robot.links()[static_cast<std::size_t>(i)].inertia);
  add(load.link, load.body);
  return energy;
}

TEST(JointTorques, OfThePandaGiveAsMuchPowerAsItsEnergyGains) {
  const RobotModel& panda = RobotModel::panda();
  ASSERT_TRUE(statesTorques(panda));
  EXPECT_EQ(panda.limits(0).effort, 87.0);
  EXPECT_EQ(panda.limits(6).effort, 12.0);
  const CarriedBody load{*panda.findLink("panda_link8"),
                         {1.4, {0.01, -0.02, 0.09}, Vector3d(0.004, 0.005, 0.002).asDiagonal()}};
  std::mt19937 random(7);
  std::uniform_real_distribution<double> u(-1.0, 1.0);
  const auto vector = [&](double size) {
    VectorXd out(7);
    for (auto& x : out) x = size * u(random);
    return out;
  };
  for (int trial = 0; trial < 20; ++trial) {
    const VectorXd q = panda.homePosture() + vector(0.6), dq = vector(1.5), ddq = vector(4.0);
    const double power = jointTorques(panda, kGravity, load, q, dq, ddq).dot(dq);
    constexpr double h = 1e-5;
    const double after = energyOf(panda, load, q + h * dq + 0.5 * h * h * ddq, dq + h * ddq);
    const double before = energyOf(panda, load, q - h * dq + 0.5 * h * h * ddq, dq - h * ddq);
    EXPECT_NEAR(power, (after - before) / (2.0 * h), 1e-4 * (1.0 + std::abs(power))) << trial;
  }
}

TEST(JointTorques, WithoutMassesOrLimitsNothingIsStated) {
  EXPECT_FALSE(statesTorques(robotOf(R"(<link name="a"/><link name="b"/>)", kJoint)));
  // A heavy pedestal is moved by nobody.
  EXPECT_FALSE(statesTorques(
      robotOf(R"(<link name="a"><inertial><mass value="50"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>
                 </inertial></link><link name="b"/>)",
              kJoint)));
  EXPECT_FALSE(statesTorques(robotOf(
      R"(<link name="a"/><link name="b"><inertial><mass value="2"/>
         <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
         )",
      R"(<joint name="j" type="continuous"><parent link="a"/><child link="b"/><axis xyz="0 1 0"/></joint>)")));
}

}  // namespace
}  // namespace heft
