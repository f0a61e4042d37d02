#include "core/reproduction/scenario.h"

#include <gtest/gtest.h>

#include "core/payload/inertial_parameters.h"

namespace heft {
namespace {

Simulated simulated(double scale = 0.2) {
  auto scenario = paperScenarios(3, 1, scale, 200.0).front();
  scenario.options.sensor.forceNoise = scenario.options.sensor.torqueNoise = 0.0;
  scenario.options.sensor.colouredForce = scenario.options.sensor.colouredTorque = 0.0;
  scenario.options.sensor.forceResolution.setZero();
  scenario.options.sensor.torqueResolution.setZero();
  auto result = simulate(RobotModel::panda(), scenario.payload, scenario.options);
  EXPECT_TRUE(result.ok());
  return *result;
}

TEST(Scenario, ArePhysicalAndAsThePaperDescribesThem) {
  const auto scenarios = paperScenarios(1, 2, 1.0, 1000.0);
  ASSERT_EQ(scenarios.size(), 10u);
  for (const auto& scenario : scenarios) {
    EXPECT_TRUE(checkPhysical(scenario.payload).physical) << scenario.name;
    EXPECT_EQ(scenario.options.duration, scenario.handGuided ? 10.0 : 20.0);
    if (scenario.handGuided)
      EXPECT_NEAR(scenario.payload.mass, 0.8, 1e-9);
    else
      EXPECT_TRUE(scenario.payload.mass > 0.199 && scenario.payload.mass < 0.501) << scenario.payload.mass;
  }
  for (std::size_t i = 0; i < scenarios.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(scenarios[i].options.seed, scenarios[j].options.seed);
}

TEST(Scenario, EveryFaultDoesWhatItSays) {
  const Simulated exact = simulated();
  const auto wrench = [&](SensorFaults faults) { return measured(exact, faults).wrench; };
  const auto none = wrench({});
  EXPECT_LT((none - exact.payloadWrench).cwiseAbs().maxCoeff(), 1e-9);

  const auto biased = (wrench({true, false, false}) - none).eval();
  EXPECT_LT((biased.rowwise() - biased.row(0)).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_NEAR(biased.row(0).head<3>().norm(), exact.truth.forceBias.norm(), 1e-9);

  const auto late = wrench({false, true, false});  // 10 ms are two samples at 200 Hz
  EXPECT_LT((late.bottomRows(late.rows() - 2) - none.topRows(none.rows() - 2)).cwiseAbs().maxCoeff(), 1e-9);

  const auto tilted = wrench({false, false, true});
  double most = 0.0;
  for (Eigen::Index k = 0; k < none.rows(); ++k) {
    const Vector3d a = none.row(k).head<3>(), b = tilted.row(k).head<3>();
    EXPECT_NEAR(a.norm(), b.norm(), 1e-9);
    most = std::max(most, std::acos(std::min(1.0, a.dot(b) / (a.norm() * b.norm()))));
  }
  EXPECT_LE(most, kMountTilt + 1e-6);
  EXPECT_GT(most, 0.5 * kMountTilt);
}

TEST(Scenario, ValidationDataIsTheEquationsWrench) {
  const Simulated exact = simulated();
  const Recording recording = measured(exact, {true, true, true});
  const auto validation = validationData(recording, RobotModel::panda(), exact.truth.payload);
  ASSERT_TRUE(validation.ok());
  const Eigen::Index n = validation->rows();
  const auto difference = (validation->wrench - exact.payloadWrench).middleRows(n / 10, 8 * n / 10).leftCols<3>();
  // Neither bias nor tilt; what the encoders' noise leaves in the acceleration is far below a bias of newtons.
  EXPECT_LT(difference.rowwise().norm().mean(), 0.1);
}

}  // namespace
}  // namespace heft
