#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/estimation/estimate.h"
#include "core/estimation/judgement.h"
#include "core/simulation/simulate.h"
#include "tests/support/random_tool.h"

namespace heft {
namespace {

Recording heavyTool(std::uint64_t seed) {
  SimulateOptions options;
  options.motion = MotionKind::excitation;
  options.seed = seed;
  options.duration = 10.0;
  const Payload tool = test::boxPayload(2.0, {0.08, 0.1, 0.06}, {0.01, 0.0, 0.05});
  return simulate(RobotModel::panda(), tool, options)->recording;
}

const Finding* found(const EstimateReport& report, const std::string& code) {
  const auto it = std::find_if(report.findings.begin(), report.findings.end(),
                               [&](const Finding& finding) { return finding.code == code; });
  return it == report.findings.end() ? nullptr : &*it;
}

/// A torque that swings by itself, beside a heavy tool whose forces fit: its channel is named, and trust is gone or
/// low.
TEST(Judgement, EveryChannelIsJudgedByItsOwnNoise) {
  const Recording clean = heavyTool(4);
  const auto fine = estimate(clean, &RobotModel::panda(), {});
  ASSERT_TRUE(fine.ok());
  EXPECT_EQ(found(*fine, "misfit"), nullptr);
  EXPECT_EQ(fine->trust, Trust::good);
  Recording swinging = clean;
  for (Eigen::Index i = 0; i < swinging.rows(); ++i) swinging.wrench(i, 4) += 0.05 * std::sin(1.3 * swinging.time(i));
  const auto report = estimate(swinging, &RobotModel::panda(), {});
  ASSERT_TRUE(report.ok());
  ASSERT_NE(found(*report, "misfit"), nullptr);
  EXPECT_NE(found(*report, "misfit")->text.find("ty"), std::string::npos);
  EXPECT_NE(report->trust, Trust::good);
}

/// "data" where it may be called measured: of mass, centre x, Ixx.
std::array<bool, 3> measured(const EstimateReport& report) {
  const nlohmann::json id = toJson(report)["identifiability"];
  return {id["mass"] == "data", id["com"][0] == "data", id["inertia"][0][0] == "data"};
}

/// A finding takes the word from the numbers that it doubts, and from no other.
TEST(Judgement, WhatAWarningDoubtsIsNotCalledMeasured) {
  EstimateReport known;
  known.identifiability.mass = Source::data;
  known.identifiability.com.fill(Source::data);
  for (auto& row : known.identifiability.inertia) row.fill(Source::data);
  struct Case {
    const char* code;
    bool ofForces;
    std::array<bool, 3> left;
  };
  for (const Case& c :
       {Case{"force_and_torque", false, {false, false, false}}, Case{"misfit", true, {false, false, false}},
        Case{"misfit", false, {true, false, false}}, Case{"sensor_turned", false, {true, false, false}},
        Case{"known_disagrees", false, {false, false, false}},
        Case{"known_inertia_disagrees", false, {true, true, false}}, Case{"not_physical", false, {true, true, false}},
        Case{"conventions_tie", false, {false, false, false}}, Case{"stood_still", false, {true, true, true}}}) {
    EstimateReport report = known;
    report.forcesMisfit = c.ofForces;
    addReadingFindings({{Severity::warning, c.code, "A warning.", "", {}}}, report);
    EXPECT_EQ(measured(report), c.left) << c.code;
    EXPECT_EQ(report.trust, c.left[2] ? Trust::good : Trust::low) << c.code;
    const nlohmann::json doubted = toJson(report)["identifiability"]["doubted"];
    EXPECT_EQ(doubted["mass"], !c.left[0]) << c.code;
    EXPECT_EQ(doubted["inertia"][2][2], !c.left[2]) << c.code;
    EXPECT_EQ(toText(report).find("measured") != std::string::npos, c.left[0]) << toText(report);
    EXPECT_EQ(toText(report).find("doubtful") == std::string::npos, c.left[2]) << toText(report);
  }
  EstimateReport told = known;
  addReadingFindings({{Severity::info, "misfit", "A note.", "", {}}}, told);
  EXPECT_EQ(measured(told), (std::array{true, true, true}));
}

/// The torques count half of what they should: mass times lever is two things, and the inertia is whatever fits.
TEST(Judgement, WhereForceAndTorqueDisagreeNothingIsMeasured) {
  for (const std::uint64_t seed : {7u, 8u, 9u}) {
    Recording half = heavyTool(seed);
    const auto whole = estimate(half, &RobotModel::panda(), {});
    ASSERT_TRUE(whole.ok());
    EXPECT_EQ(measured(*whole), (std::array{true, true, true})) << seed;
    half.wrench.rightCols<3>() *= 0.5;
    const auto report = estimate(half, &RobotModel::panda(), {});
    ASSERT_TRUE(report.ok());
    EXPECT_NE(report->trust, Trust::good) << seed;
    EXPECT_EQ(measured(*report), (std::array{false, false, false})) << seed;
  }
}

/// A slow motion causes little, and slow noise of the sensor is a tenth of that: the intervals count it, no misfit.
TEST(Judgement, SlowNoiseBesideASlowMotionIsNoMisfit) {
  const Payload tool = test::boxPayload(0.8, {0.08, 0.1, 0.06}, {0.01, 0.0, 0.05});
  SimulateOptions options;
  options.motion = MotionKind::pickAndPlace;
  options.speed = 0.4;
  options.duration = 8.0;
  for (options.seed = 1; options.seed <= 4; ++options.seed) {
    const auto report = estimate(simulate(RobotModel::panda(), tool, options)->recording, &RobotModel::panda(), {});
    ASSERT_TRUE(report.ok());
    EXPECT_GT(report->unseenForceShare, 0.08) << options.seed;
    EXPECT_EQ(found(*report, "misfit"), nullptr) << options.seed;
    EXPECT_EQ(measured(*report), (std::array{true, true, true})) << options.seed;
    EXPECT_LT(std::abs(report->payload.mass - tool.mass), 4.0 * report->std.mass) << options.seed;
  }
}

TEST(Judgement, KnownValuesThatTheDataContradictAreSaid) {
  const Recording recording = heavyTool(10);
  EstimateOptions options;
  options.known = {2.0, Vector3d(0.01, 0.0, 0.05),
                   test::boxPayload(2.0, {0.08, 0.1, 0.06}, {0.01, 0.0, 0.05}).inertiaCom};
  EXPECT_EQ(measured(*estimate(recording, &RobotModel::panda(), options)), (std::array{true, true, true}));
  const EstimateOptions right = options;
  options.known.inertiaCom = 3.0 * *options.known.inertiaCom;
  const auto inertia = estimate(recording, &RobotModel::panda(), options);
  EXPECT_NE(found(*inertia, "known_inertia_disagrees"), nullptr);
  EXPECT_EQ(measured(*inertia), (std::array{true, true, false}));
  options = right;
  options.known.com = Vector3d(0.01, 0.0, 0.07);
  const auto centre = estimate(recording, &RobotModel::panda(), options);
  EXPECT_NE(found(*centre, "known_centre_disagrees"), nullptr);
  EXPECT_EQ(measured(*centre), (std::array{true, false, false}));
  options = right;
  options.known.mass = 2.2;
  EXPECT_EQ(measured(*estimate(recording, &RobotModel::panda(), options)), (std::array{false, false, false}));
}

/// With two dead torques the third one tells some moments and products by what turning does; what is called measured
/// then holds, and the dead channels are neither counted as fitting nor as a misfit.
TEST(Judgement, DeadTorquesAreNeitherCountedNorTrusted) {
  for (std::uint64_t seed = 50; seed < 56; ++seed) {
    Recording dead = heavyTool(seed);
    dead.wrench.col(3).setZero();
    dead.wrench.col(4).setZero();
    const auto report = estimate(dead, &RobotModel::panda(), {});
    ASSERT_TRUE(report.ok());
    EXPECT_NE(found(*report, "channel_unused"), nullptr);
    EXPECT_EQ(found(*report, "misfit"), nullptr);
    EXPECT_LT(report->heldoutTorqueRms, 0.01);  // [N m]
    EXPECT_TRUE(report->identifiability.weakDirections.empty()) << "no motion makes up for a channel that is dead";
    const Matrix3d truth = test::boxPayload(2.0, {0.08, 0.1, 0.06}, {0.01, 0.0, 0.05}).inertiaCom;
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) {
        if (report->identifiability.inertia[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)] != Source::data)
          continue;
        EXPECT_LT(std::abs(report->payload.inertiaCom(r, c) - truth(r, c)), 4.0 * report->std.inertiaCom(r, c))
            << seed << " " << r << c;
      }
  }
}

/// What is cut off in most rows is not used, and the rest still weighs the tool.
TEST(Judgement, AChannelThatIsMostlyCutOffIsNotUsed) {
  Recording cut = heavyTool(6);
  std::vector<double> values(cut.wrench.col(4).begin(), cut.wrench.col(4).end());
  std::sort(values.begin(), values.end());
  const double low = values[3 * values.size() / 10], high = values[7 * values.size() / 10];
  cut.wrench.col(4) = cut.wrench.col(4).cwiseMax(low).cwiseMin(high).eval();
  const auto report = estimate(cut, &RobotModel::panda(), {});
  ASSERT_TRUE(report.ok()) << report.error().message;
  EXPECT_NE(found(*report, "channel_unused"), nullptr);
  EXPECT_NEAR(report->payload.mass, 2.0, 5.0 * report->std.mass);
}

}  // namespace
}  // namespace heft
