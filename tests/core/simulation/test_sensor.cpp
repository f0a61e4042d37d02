// What the sensor adds: bias, white and coloured noise, clipping, resolution; the controller's quantised velocities.
#include <gtest/gtest.h>

#include <cmath>

#include "core/simulation/random.h"
#include "core/simulation/sensor.h"
#include "tests/core/simulation/sample.h"

namespace heft {
namespace {

double deviation(const VectorXd& x) { return std::sqrt((x.array() - x.mean()).square().mean()); }

TEST(SimulationSensor, NormalDeviatesHaveTheMomentsOfANormal) {
  RandomStream random(7, RandomPurpose::white);
  constexpr int kCount = 200000;
  double m1 = 0, m2 = 0, m3 = 0, m4 = 0;
  int beyondTwo = 0;
  for (int i = 0; i < kCount; ++i) {
    const double x = random.normal();
    m1 += x / kCount;
    m2 += x * x / kCount;
    m3 += x * x * x / kCount;
    m4 += x * x * x * x / kCount;
    beyondTwo += std::abs(x) > 2.0;
  }
  EXPECT_NEAR(m1, 0.0, 0.01);
  EXPECT_NEAR(m2, 1.0, 0.015);
  EXPECT_NEAR(m3, 0.0, 0.04);
  EXPECT_NEAR(m4, 3.0, 0.1);
  EXPECT_NEAR(static_cast<double>(beyondTwo) / kCount, 0.0455, 0.002);
}

TEST(SimulationSensor, StreamsAreIndependent) {
  RandomStream a(7, RandomPurpose::white, 0), b(7, RandomPurpose::white, 1), c(7, RandomPurpose::coloured, 0),
      d(8, RandomPurpose::white, 0), again(7, RandomPurpose::white, 0);
  double ab = 0, ac = 0, ad = 0;
  constexpr int kCount = 20000;
  for (int i = 0; i < kCount; ++i) {
    const double x = a.normal();
    EXPECT_EQ(x, again.normal());
    ab += x * b.normal() / kCount;
    ac += x * c.normal() / kCount;
    ad += x * d.normal() / kCount;
  }
  for (const double correlation : {ab, ac, ad}) EXPECT_NEAR(correlation, 0.0, 0.03);
}

TEST(SimulationSensor, ColouredNoiseIsGaussMarkov) {
  SensorModel sensor;
  sensor.forceNoise = sensor.torqueNoise = 0.0;
  sensor.colouredForce = 0.3;
  sensor.colouredTorque = 0.01;
  sensor.colourTime = 0.02;
  sensor.forceResolution.setZero();
  sensor.torqueResolution.setZero();
  const Eigen::Index n = 200000;
  SampledWrench wrench = SampledWrench::Zero(n, 6);
  measureWrench(sensor, 11, 1000.0, Vector6d::Zero(), wrench);
  for (int c = 0; c < 6; ++c) {
    const double sigma = c < 3 ? 0.3 : 0.01;
    EXPECT_NEAR(deviation(wrench.col(c)) / sigma, 1.0, 0.04);
    for (const Eigen::Index lag : {1, 10, 20, 40}) {
      const double correlation =
          wrench.col(c).head(n - lag).dot(wrench.col(c).tail(n - lag)) / static_cast<double>(n - lag) / (sigma * sigma);
      EXPECT_NEAR(correlation, std::exp(-static_cast<double>(lag) / 20.0), 0.06) << "channel " << c << " lag " << lag;
    }
  }
  // Stationary from the first sample on.
  double first = 0.0;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    SampledWrench start = SampledWrench::Zero(1, 6);
    measureWrench(sensor, seed, 1000.0, Vector6d::Zero(), start);
    first += start(0, 0) * start(0, 0) / 500.0;
  }
  EXPECT_NEAR(std::sqrt(first) / 0.3, 1.0, 0.1);
}

TEST(SimulationSensor, ClipsAndRounds) {
  SensorModel sensor;
  SampledWrench wrench = SampledWrench::Zero(2000, 6);
  for (Eigen::Index k = 0; k < wrench.rows(); ++k)
    wrench.row(k).setConstant(300.0 * std::sin(0.01 * static_cast<double>(k)));
  measureWrench(sensor, 3, 1000.0, Vector6d::Zero(), wrench);
  for (int c = 0; c < 6; ++c) {
    const double range = c < 3 ? sensor.forceRange(c) : sensor.torqueRange;
    const double step = c < 3 ? sensor.forceResolution(c) : sensor.torqueResolution(c - 3);
    EXPECT_EQ(wrench.col(c).maxCoeff(), range);
    EXPECT_EQ(wrench.col(c).minCoeff(), -range);
    for (Eigen::Index k = 0; k < wrench.rows(); ++k) {
      const double steps = wrench(k, c) / step;
      ASSERT_NEAR(steps, std::nearbyint(steps), 1e-9) << "channel " << c << " row " << k;
    }
  }
}

TEST(SimulationSensor, RecordedMinusTrueIsBiasAndNoise) {
  for (const double mass : {0.2, 0.75, 1.5}) {
    for (const MotionKind kind : kKinds) {
      SCOPED_TRACE(testing::Message() << toString(kind) << ", " << mass << " kg");
      SimulateOptions options = optionsFor(kind, 21);
      options.sensor.forceRange.setConstant(1000.0);
      options.sensor.torqueRange = 1000.0;
      const auto simulated = simulate(RobotModel::panda(), sampleTool(mass), options);
      ASSERT_TRUE(simulated.ok()) << simulated.error().message;
      SampledWrench rest = simulated->recording.wrench - simulated->payloadWrench - simulated->contactWrench;
      const SensorModel& s = options.sensor;
      for (int c = 0; c < 6; ++c) {
        const double white = c < 3 ? s.forceNoise : s.torqueNoise;
        const double coloured = c < 3 ? s.colouredForce : s.colouredTorque;
        const double step = c < 3 ? s.forceResolution(c) : s.torqueResolution(c - 3);
        const double expected = std::sqrt(white * white + coloured * coloured + step * step / 12.0);
        const double bias = c < 3 ? simulated->truth.forceBias(c) : simulated->truth.torqueBias(c - 3);
        EXPECT_NEAR(deviation(rest.col(c)) / expected, 1.0, 0.05) << "channel " << c;
        // The mean of coloured noise spreads by sqrt(2 * 0.05 s / 20 s) = 0.07 of its deviation.
        EXPECT_NEAR(rest.col(c).mean(), bias, 0.3 * coloured) << "channel " << c;
      }
    }
  }
}

TEST(SimulationSensor, ControllerVelocitiesAreQuantised) {
  SimulateOptions options = optionsFor(MotionKind::free, 2, 5.0);
  const auto simulated = simulate(RobotModel::panda(), sampleTool(), options);
  ASSERT_TRUE(simulated.ok()) << simulated.error().message;
  const MatrixXd steps = simulated->recording.dq / options.velocityQuantum;
  EXPECT_LT((steps.array() - steps.array().round()).abs().maxCoeff(), 1e-6);
  EXPECT_LE((simulated->recording.dq - simulated->dq).cwiseAbs().maxCoeff(), 0.5 * options.velocityQuantum + 1e-12);
  for (int j = 0; j < 7; ++j)
    EXPECT_NEAR(deviation(simulated->recording.q.col(j) - simulated->q.col(j)), options.positionNoise, 1e-6);
}

}  // namespace
}  // namespace heft
