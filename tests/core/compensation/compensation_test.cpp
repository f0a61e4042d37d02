// What is left of the wrench without the payload, and the phases of a demonstration.
#include "core/compensation/compensation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "core/estimation/estimate.h"
#include "core/simulation/simulate.h"
#include "tests/support/random_tool.h"

namespace heft {
namespace {

const Payload kTool = test::boxPayload(0.8, {0.08, 0.10, 0.12}, {0.01, -0.005, 0.06});

Simulated simulated(MotionKind kind, unsigned seed) {
  SimulateOptions options;
  options.motion = kind;
  options.seed = seed;
  options.rateHz = 500.0;
  return std::move(*simulate(RobotModel::panda(), kTool, options));
}

CompensateOptions byTruth(const SimulationTruth& truth) {
  CompensateOptions options;
  options.payload.payload = truth.payload;
  options.bias << truth.forceBias, truth.torqueBias;
  return options;
}

/// Standard deviation of the simulated sensor: white, coloured and rounding.
constexpr double kForceNoise = 0.0583 * 1.03, kTorqueNoise = 0.00224 * 1.03;

TEST(Compensation, FreeMotionIsLeftAtTheNoiseFloor) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const Simulated simulation = simulated(MotionKind::free, seed);
    const auto out = compensate(simulation.recording, &RobotModel::panda(), byTruth(simulation.truth));
    ASSERT_TRUE(out);
    EXPECT_LT(out->freeForceRms, 1.1 * kForceNoise);
    EXPECT_LT(out->freeTorqueRms, 1.15 * kTorqueNoise);
    EXPECT_GT(out->freeForceRms, 0.8 * kForceNoise) << "the raw wrench, not a smoothed one";
    EXPECT_NEAR(out->noiseForce, 0.054, 0.006);
    EXPECT_TRUE(out->ownBias);
    EXPECT_EQ(out->wrench.rows(), simulation.recording.rows());
  }
}

TEST(Compensation, AnEstimateOfTheRecordingServesAsWell) {
  const Simulated simulation = simulated(MotionKind::pickAndPlace, 4);
  const auto report = estimate(simulation.recording, &RobotModel::panda(), {});
  ASSERT_TRUE(report);
  const auto options = compensateOptionsFromJson(toJson(*report), "result.json");
  ASSERT_TRUE(options);
  const auto out = compensate(simulation.recording, &RobotModel::panda(), *options);
  ASSERT_TRUE(out);
  EXPECT_LT(out->freeForceRms, 1.15 * kForceNoise);
  EXPECT_LT(out->freeTorqueRms, 1.2 * kTorqueNoise);
}

TEST(Compensation, ContactForcesComeBack) {
  const Simulated simulation = simulated(MotionKind::pickAndPlace, 5);
  const auto out = compensate(simulation.recording, &RobotModel::panda(), byTruth(simulation.truth));
  ASSERT_TRUE(out);
  const WrenchSamples error = out->wrench - simulation.contactWrench;
  EXPECT_LT(std::sqrt(error.leftCols<3>().squaredNorm() / (3.0 * static_cast<double>(error.rows()))),
            1.15 * kForceNoise);
  int contacts = 0;
  for (std::size_t i = 0; i < out->segments.size(); ++i) {
    const auto& segment = out->segments[i];
    if (i > 0) {
      EXPECT_NEAR(segment.from, out->segments[i - 1].to, 1e-9);
    }
    if (segment.phase != Phase::contact) continue;
    ++contacts;
    Vector3d mean = Vector3d::Zero();
    double count = 0.0, peak = 0.0;
    for (Eigen::Index k = 0; k < error.rows(); ++k)
      if (out->time(k) >= segment.from && out->time(k) < segment.to) {
        mean -= simulation.contactWrench.row(k).head<3>().transpose();
        peak = std::max(peak, simulation.contactWrench.row(k).head<3>().norm());
        count += 1.0;
      }
    EXPECT_LT((segment.meanForce - mean / count).norm(), 0.05);
    EXPECT_NEAR(segment.peakForce, peak, 0.3);
    // The table is reached from above: what comes before moves down.
    ASSERT_GT(i, 0u);
    EXPECT_EQ(out->segments[i - 1].phase, Phase::approach) << segment.from;
    EXPECT_LT(out->segments[i - 1].direction_B.z(), -0.5) << segment.from;
    EXPECT_GT(out->segments[i - 1].distance, 0.005);
    EXPECT_LE(out->segments[i - 1].to - out->segments[i - 1].from, 1.6);
  }
  EXPECT_GE(contacts, 1);
}

TEST(Compensation, TheBiasIsThatOfTheDay) {
  const Simulated simulation = simulated(MotionKind::free, 6);
  CompensateOptions options = byTruth(simulation.truth);
  options.bias.setConstant(5.0);
  const auto own = compensate(simulation.recording, &RobotModel::panda(), options);
  ASSERT_TRUE(own);
  EXPECT_TRUE(own->ownBias);
  EXPECT_LT((own->bias.head<3>() - simulation.truth.forceBias).norm(), 0.02);
  Recording pressed = simulation.recording;
  pressed.meta.marks = {{-1.0, 1e3, MarkLabel::contact}};
  const auto given = compensate(pressed, &RobotModel::panda(), byTruth(simulation.truth));
  ASSERT_TRUE(given);
  EXPECT_FALSE(given->ownBias);
  EXPECT_LT((given->bias.head<3>() - simulation.truth.forceBias).norm(), 1e-12);
  EXPECT_TRUE(std::any_of(given->findings.begin(), given->findings.end(),
                          [](const Finding& finding) { return finding.code == "bias_of_result"; }));
}

TEST(Compensation, AWrongPayloadIsSaid) {
  const Simulated simulation = simulated(MotionKind::free, 7);
  CompensateOptions options = byTruth(simulation.truth);
  options.payload.payload.mass = 1.2;
  options.payload.std.mass = 0.01;
  const auto out = compensate(simulation.recording, &RobotModel::panda(), options);
  ASSERT_TRUE(out);
  EXPECT_TRUE(std::any_of(out->findings.begin(), out->findings.end(),
                          [](const Finding& finding) { return finding.code == "above_noise"; }));
}

TEST(Compensation, CsvHasARowASampleAndJsonThePhases) {
  const Simulated simulation = simulated(MotionKind::pickAndPlace, 9);
  const auto out = compensate(simulation.recording, &RobotModel::panda(), byTruth(simulation.truth));
  ASSERT_TRUE(out);
  std::istringstream csv(toCsv(*out, simulation.recording));
  std::string line;
  std::getline(csv, line);
  EXPECT_EQ(line, "time,q1,q2,q3,q4,q5,q6,q7,fx,fy,fz,tx,ty,tz,phase");
  Eigen::Index rows = 0;
  std::array<int, 3> seen{};
  while (std::getline(csv, line)) {
    ++rows;
    seen[0] += line.ends_with(",free") ? 1 : 0;
    seen[1] += line.ends_with(",approach") ? 1 : 0;
    seen[2] += line.ends_with(",contact") ? 1 : 0;
  }
  EXPECT_EQ(rows, simulation.recording.rows());
  for (const int count : seen) EXPECT_GT(count, 100);
  const auto json = toJson(*out, simulation.recording);
  EXPECT_EQ(json["schema"], "heft.compensate/1");
  for (const auto& phase : json["phases"]) {
    EXPECT_TRUE(phase["from_s"].is_number() && phase["to_s"].is_number());
    if (phase["phase"] == "contact") {
      EXPECT_TRUE(phase["on_tool"]["mean_force_n"].is_array());
    }
  }
  EXPECT_EQ(json["bias"]["from"], "recording");
  EXPECT_THAT(toText(*out, simulation.recording), testing::HasSubstr("remain in free motion"));
}

TEST(Compensation, ReadsResultsAndSaysWhatIsWrong) {
  nlohmann::json result{{"payload", toJson(kTool)}, {"bias", {{"force_n", {1, 2, 3}}, {"torque_nm", {0.1, 0.2, 0.3}}}}};
  const auto good = compensateOptionsFromJson(result, "r.json");
  ASSERT_TRUE(good);
  EXPECT_EQ(good->bias(5), 0.3);
  for (const auto& bad :
       {nlohmann::json(3), nlohmann::json{{"force_n", {1, 2}}}, nlohmann::json{{"force_n", {1, 2, "x"}}}}) {
    result["bias"] = bad;
    const auto failed = compensateOptionsFromJson(result, "r.json");
    ASSERT_FALSE(failed);
    EXPECT_THAT(failed.error().message, testing::StartsWith("r.json: "));
  }
  EXPECT_FALSE(compensateOptionsFromJson(nlohmann::json::array(), "r.json"));
  Recording poses;
  poses.meta.kind = RecordingKind::poses;
  EXPECT_FALSE(compensate(poses, nullptr, *good));
}

}  // namespace
}  // namespace heft
