// What loggers do to readings: steps, repeats, missing rows. Numbers that are called measured hold all the same.
#include <gtest/gtest.h>

#include <random>

#include "core/estimation/estimate.h"
#include "core/estimation/spikes.h"
#include "core/estimation/uncertainty.h"
#include "core/recording/held.h"
#include "core/recording/steps.h"
#include "core/simulation/simulate.h"
#include "tests/support/random_tool.h"

namespace heft {
namespace {

Simulated demonstration(std::uint64_t seed, double duration) {
  std::mt19937 random(static_cast<unsigned>(seed));
  SimulateOptions options;
  options.motion = seed % 2 == 0 ? MotionKind::excitation : MotionKind::free;
  options.seed = seed;
  options.duration = duration;
  return *simulate(RobotModel::panda(), test::randomTool(random).payload, options);
}

/// How many numbers that are called measured are more than `limit` standard deviations off.
int beyond(const EstimateReport& report, const Payload& truth, double limit, int& claims) {
  const auto& id = report.identifiability;
  const auto& I = id.inertia;
  const Source sources[10] = {id.mass, id.com[0], id.com[1], id.com[2], I[0][0],
                              I[0][1], I[0][2],   I[1][1],   I[1][2],   I[2][2]};
  const Vector10d off = (componentsOf(report.payload) - componentsOf(truth)).cwiseQuotient(componentsOf(report.std));
  int out = 0;
  for (int k = 0; k < 10; ++k) {
    if (sources[k] != Source::data) continue;
    ++claims;
    out += std::abs(off(k)) > limit ? 1 : 0;
  }
  return out;
}

bool said(const EstimateReport& report, const std::string& code) {
  return std::ranges::any_of(report.findings, [&](const auto& finding) { return finding.code == code; });
}

TEST(HeldReadings, AreFoundWithTheirOwnTimes) {
  const VectorXd time = VectorXd::LinSpaced(1000, 0.0, 0.999);
  Eigen::Matrix<double, Eigen::Dynamic, 6> wrench(1000, 6);
  for (Eigen::Index k = 0; k < 1000; ++k) {
    const Eigen::Index reading = k / 20;
    wrench.row(k).setConstant(std::sin(0.37 * static_cast<double>(reading)));
  }
  const HeldValues held = heldValues(time, wrench);
  EXPECT_NEAR(held.period, 0.02, 1e-9);
  ASSERT_EQ(held.rows.size(), 50u);
  EXPECT_EQ(held.rows[7], 140);
  // One reading that never came: its place is kept.
  wrench.middleRows(400, 20).rowwise() = wrench.row(399).eval();
  EXPECT_EQ(heldValues(time, wrench).rows.size(), 50u);
  wrench.col(2) = time;
  EXPECT_EQ(heldValues(time, wrench).period, 0.0) << "a channel that goes on is a reading of its own";
}

TEST(RoundingNoise, LastsUntilTheLoadPassesTheNextStep) {
  Eigen::Matrix<double, Eigen::Dynamic, 6> wrench = Eigen::Matrix<double, Eigen::Dynamic, 6>::Zero(1000, 6);
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (Eigen::Index k = 0; k < 1000; ++k) {
    const double slow = 4.0 * static_cast<double>(k) / 1000.0;
    wrench.row(k) << std::floor(slow), std::round(5.0 * normal(random)), normal(random),
        std::round(slow + 0.1 * normal(random)), slow < 2.0 ? 0.0 : 0.5, 0.0;
  }
  const ReadingSteps steps = readingSteps(wrench, 1.0);
  const Vector6d noise = steps.roundingNoise(0.02);
  EXPECT_NEAR(steps.crossings(0), 3.0, 1e-9);
  EXPECT_NEAR(noise(0), std::sqrt(50.0 / 3.0 / 12.0), 0.01) << "three independent errors in 50 means";
  EXPECT_NEAR(noise(1), 1.0 / std::sqrt(12.0 * 18.8), 0.01) << "loud noise makes every reading a new one";
  EXPECT_EQ(noise(2), 0.0);
  EXPECT_GT(steps.changes(3), 30.0);
  EXPECT_NEAR(steps.dither(3), 0.1, 0.03);
  EXPECT_GT(noise(3), 0.6 * noise(0)) << "to and fro over one step is nothing new";
  EXPECT_NEAR(steps.step(4), 0.5, 1e-9) << "two values are a step, too";
  EXPECT_NEAR(noise(4), 0.5 * std::sqrt(50.0 / 12.0), 0.01);
  EXPECT_EQ(noise(5), 0.0);
}

/// A converter of 16 bit in so many readings that their values are looked up instead of sorted.
TEST(Loggers, StepsOfManyReadingsAreFound) {
  constexpr Eigen::Index kRows = 400000;
  Eigen::Matrix<double, Eigen::Dynamic, 6> wrench = Eigen::Matrix<double, Eigen::Dynamic, 6>::Zero(kRows, 6);
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (Eigen::Index k = 0; k < kRows; ++k)
    wrench.row(k) << 0.00625 * std::round(200.0 * normal(random)), 0.5 * std::round(1e4 * normal(random)),
        normal(random), k % 2 == 0 ? 0.0 : -0.0, k % 3 == 0 ? -0.0 : 1.0, 1.0;
  const Vector6d steps = readingSteps(wrench, 400.0).step;
  EXPECT_NEAR(steps(0), 0.00625, 1e-12);
  EXPECT_NEAR(steps(1), 0.5, 1e-12);
  EXPECT_EQ(steps(2), 0.0) << "no two alike";
  EXPECT_EQ(steps(3), 0.0) << "zero has two signs and is one value";
  EXPECT_EQ(steps(4), 1.0);
}

/// How noisy the motion is, is told in windows of a recording longer than 5 min.
TEST(Loggers, ALongNoisyMotionIsMeasuredHonestly) {
  int claims = 0;
  for (std::uint64_t seed = 31; seed <= 32; ++seed) {
    SimulateOptions options;
    options.motion = MotionKind::excitation;
    options.seed = seed;
    options.duration = 320.0;
    options.rateHz = 200.0;
    options.positionNoise = 1e-4;
    std::mt19937 random(static_cast<unsigned>(seed));
    Simulated simulated = *simulate(RobotModel::panda(), test::randomTool(random).payload, options);
    simulated.recording.dq.resize(0, 7);
    const auto report = estimate(simulated.recording, &RobotModel::panda(), {});
    ASSERT_TRUE(report.ok()) << report.error().message;
    EXPECT_EQ(beyond(*report, simulated.truth.payload, 4.0, claims), 0) << "seed " << seed;
  }
  EXPECT_EQ(claims, 20);
}

TEST(Loggers, HeldReadingsCountOnceWithTheMotionOfTheirMoment) {
  int claims = 0, far = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Simulated simulated = demonstration(seed, 10.0);
    auto& wrench = simulated.recording.wrench;
    const Eigen::Index rows = seed % 3 == 0 ? 50 : 20;
    for (Eigen::Index k = 0; k < wrench.rows(); ++k) wrench.row(k) = wrench.row(k / rows * rows).eval();
    const auto report = estimate(simulated.recording, &RobotModel::panda(), {});
    ASSERT_TRUE(report.ok()) << report.error().message;
    EXPECT_TRUE(said(*report, "wrench_held"));
    int ignored = 0;
    EXPECT_EQ(beyond(*report, simulated.truth.payload, 5.0, ignored), 0) << "seed " << seed;
    far += beyond(*report, simulated.truth.payload, 4.0, claims);
  }
  EXPECT_GT(claims, 30);
  EXPECT_LE(far, 0.02 * claims);
}

/// What the fit leaves over is asked of the readings' own moments, however often they come.
TEST(Loggers, HeldReadingsAreJudgedAtTheirMoments) {
  for (const Eigen::Index rows : {2, 3, 8, 40}) {
    Simulated simulated = demonstration(21, 12.0);
    auto& wrench = simulated.recording.wrench;
    for (Eigen::Index k = 0; k < wrench.rows(); ++k) wrench.row(k) = wrench.row(k / rows * rows).eval();
    for (const Method method : {Method::map, Method::ls, Method::tlsExact}) {
      EstimateOptions options;
      options.method = method;
      const auto report = estimate(simulated.recording, &RobotModel::panda(), options);
      ASSERT_TRUE(report.ok()) << report.error().message;
      EXPECT_TRUE(said(*report, "wrench_held")) << rows;
      EXPECT_FALSE(method == Method::map && said(*report, "misfit")) << rows;
      EXPECT_LT(report->forceRms, 0.3) << rows;  // [N]
      EXPECT_NEAR(report->payload.mass, simulated.truth.payload.mass, 0.02 * simulated.truth.payload.mass) << rows;
    }
  }
}

TEST(Loggers, RowsOfZerosAreNoReadings) {
  for (std::uint64_t seed = 41; seed <= 44; ++seed) {
    Simulated simulated = demonstration(seed, 8.0);
    Recording& recording = simulated.recording;
    std::mt19937 random(static_cast<unsigned>(seed));
    for (Eigen::Index k = 0; k < recording.rows(); ++k)
      if (random() % 20 == 0) recording.wrench.row(k).setZero();
    const auto report = estimate(recording, &RobotModel::panda(), {});
    ASSERT_TRUE(report.ok()) << report.error().message;
    EXPECT_TRUE(said(*report, "zeros_replaced"));
    EXPECT_LT(report->heldoutForceRms, 0.15) << seed;  // [N]
    int ignored = 0;
    EXPECT_EQ(beyond(*report, simulated.truth.payload, 4.5, ignored), 0) << seed;
    // A coarse channel that passes zero was measured.
    for (Eigen::Index c = 0; c < 6; ++c)
      recording.wrench.col(c) = (recording.wrench.col(c) / (c < 3 ? 5.0 : 1.0)).array().round() * (c < 3 ? 5.0 : 1.0);
    Eigen::Index none = 0;
    recording.wrench = recording.wrench.cwiseMin(5.0).cwiseMax(-5.0).eval();
    recording.wrench.rightCols<3>() = recording.wrench.rightCols<3>().cwiseMin(1.0).cwiseMax(-1.0).eval();
    EXPECT_FALSE(withoutZeros(recording.time, recording.wrench, none));
  }
}

/// Between rows that came at uneven times nothing is made smaller than it was.
TEST(Loggers, RowsLostAtRandomTakeNothingFromTheMass) {
  double sum = 0.0;
  int claims = 0, far = 0;
  for (std::uint64_t seed = 31; seed <= 38; ++seed) {
    const auto simulated = [&] {
      SimulateOptions options;
      options.motion = MotionKind::pickAndPlace;
      options.seed = seed;
      options.duration = 15.0;
      return *simulate(RobotModel::panda(), test::boxPayload(0.8, {0.08, 0.06, 0.16}, {0.005, -0.004, 0.08}), options);
    }();
    std::mt19937 random(static_cast<unsigned>(seed));
    std::vector<Eigen::Index> kept;
    for (Eigen::Index k = 0; k < simulated.recording.rows(); ++k)
      if (random() % 4 == 0) kept.push_back(k);
    Recording thinned = simulated.recording;
    thinned.time = simulated.recording.time(kept).eval();
    thinned.q = simulated.recording.q(kept, Eigen::all).eval();
    thinned.dq = simulated.recording.dq(kept, Eigen::all).eval();
    thinned.wrench = simulated.recording.wrench(kept, Eigen::all).eval();
    const auto report = estimate(thinned, &RobotModel::panda(), {});
    ASSERT_TRUE(report.ok()) << report.error().message;
    sum += (report->payload.mass - simulated.truth.payload.mass) / report->std.mass;
    int ignored = 0;
    EXPECT_EQ(beyond(*report, simulated.truth.payload, 5.0, ignored), 0) << "seed " << seed;
    far += beyond(*report, simulated.truth.payload, 4.0, claims);
  }
  EXPECT_NEAR(sum / 8.0, 0.0, 1.0);
  EXPECT_GT(claims, 60);
  EXPECT_EQ(far, 0);
}

TEST(Loggers, CoarseStepsAreNoExactReadings) {
  int claims = 0;
  for (std::uint64_t seed = 11; seed <= 18; ++seed) {
    Simulated simulated = demonstration(seed, 8.0);
    for (Eigen::Index c = 0; c < 6; ++c) {
      const double step = c < 3 ? 1.0 : 0.05;
      auto y = simulated.recording.wrench.col(c);
      y = ((y.array() / step).round() * step).matrix().eval();
    }
    const auto report = estimate(simulated.recording, &RobotModel::panda(), {});
    if (!report) continue;  // Too coarse for anything
    EXPECT_EQ(beyond(*report, simulated.truth.payload, 5.0, claims), 0) << "seed " << seed;
  }
  EXPECT_GT(claims, 5);
}

TEST(Loggers, WhatLiesInAGapOfAFewRowsIsLeftOut) {
  Simulated simulated = demonstration(3, 10.0);
  Recording& recording = simulated.recording;
  std::vector<Eigen::Index> kept;  // 71 Hz, and three rows of 14 ms are missing now and then
  for (Eigen::Index k = 0, i = 0; k < recording.rows(); k += 14, ++i)
    if (i % 60 < 57) kept.push_back(k);
  recording.time = recording.time(kept).eval();
  recording.q = recording.q(kept, Eigen::all).eval();
  recording.dq = recording.dq(kept, Eigen::all).eval();
  recording.wrench = recording.wrench(kept, Eigen::all).eval();
  const auto report = estimate(recording, &RobotModel::panda(), {});
  ASSERT_TRUE(report.ok()) << report.error().message;
  EXPECT_TRUE(said(*report, "sensor_trouble"));
  int claims = 0;
  EXPECT_EQ(beyond(*report, simulated.truth.payload, 4.0, claims), 0);
}

TEST(SlowRows, MotionAndWrenchAreNarrowedTogether) {
  // At 30 Hz the motion's cut-off is 12 Hz, within what the wrench keeps: tools then had moments that were too large.
  int claims = 0, off = 0;
  for (const std::uint64_t seed : {61u, 62u, 63u, 64u, 65u, 66u, 67u, 68u}) {
    Simulated simulated = demonstration(seed, 12.0);
    Recording& recording = simulated.recording;
    std::vector<Eigen::Index> rows;
    for (Eigen::Index k = 0; k < recording.rows(); k += 33) rows.push_back(k);
    recording.time = recording.time(rows).eval();
    recording.q = recording.q(rows, Eigen::all).eval();
    recording.dq = recording.dq(rows, Eigen::all).eval();
    recording.wrench = recording.wrench(rows, Eigen::all).eval();
    const auto report = estimate(recording, &RobotModel::panda(), {});
    ASSERT_TRUE(report.ok());
    off += beyond(*report, simulated.truth.payload, 3.0, claims);
  }
  EXPECT_GT(claims, 40);
  EXPECT_LE(off, 1);
}

}  // namespace
}  // namespace heft
