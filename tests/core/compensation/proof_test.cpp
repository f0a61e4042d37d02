// Whether an entered payload is what a recording carries.
#include "core/compensation/proof.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>

#include "core/simulation/simulate.h"
#include "tests/support/estimation_fixtures.h"
#include "tests/support/random_tool.h"

namespace heft {
namespace {

const Payload kProved = test::boxPayload(0.9, {0.08, 0.10, 0.12}, {0.01, -0.005, 0.06});

Recording guided(const Payload& payload, unsigned seed, const std::vector<EffectRequest>& effects = {},
                 double speed = 1.0) {
  SimulateOptions options;
  options.motion = MotionKind::free;
  options.seed = seed;
  options.duration = 10.0;
  options.rateHz = 250.0;
  options.speed = speed;
  options.effects = effects;
  auto simulated = simulate(RobotModel::panda(), payload, options);
  if (!simulated) throw std::runtime_error(simulated.error().message);
  return std::move(simulated->recording);
}

EnteredPayload bare(const Payload& payload) {
  return *enteredPayloadFromJson({{"payload", toJson(payload)}}, "entered.json");
}

Proof proofOf(const EnteredPayload& entered, const Recording& recording) {
  auto proof = prove(entered, recording, &RobotModel::panda(), {});
  if (!proof) throw std::runtime_error(proof.error().message);
  return *proof;
}

TEST(Proof, PassesTheRightPayloadInNinetyNineOfAHundred) {
  int passed = 0;
  std::string failures;
  for (unsigned seed = 0; seed < 40; ++seed) {
    std::mt19937 random(7000 + seed);
    const Payload tool = test::randomTool(random).payload;
    EnteredPayload entered = bare(tool);
    if (seed % 2 == 1) {
      const auto estimated = estimate(guided(tool, 7100 + seed), &RobotModel::panda(), {});
      ASSERT_TRUE(estimated);
      entered = *enteredPayloadFromJson(toJson(*estimated), "result.json");
      EXPECT_GT(entered.std.inertiaCom(0, 0), 0.0);
    }
    const Proof proof = proofOf(entered, guided(tool, 7200 + seed));
    if (proof.verdict == ProofVerdict::pass)
      ++passed;
    else
      failures += std::to_string(seed) + ": " + proof.reasons.front().text + "\n";
  }
  EXPECT_GE(passed, 38) << failures;  // three and more of 40 fail by chance once in 130
}

TEST(Proof, ReadsTheControllersFileInFlangeAxes) {
  const Recording recording = guided(kProved, 7250);
  const Isometry3d X_FS = poseFromXyzRpy(recording.meta.mount.xyz, recording.meta.mount.rpy);
  ASSERT_GT(X_FS.translation().norm(), 0.01) << "the axes must differ";
  const Payload p = transformed(kProved, X_FS);
  const Matrix3d& I = p.inertiaCom;
  const nlohmann::json desk{{"mass", p.mass},
                            {"centerOfMass", {p.com.x(), p.com.y(), p.com.z()}},
                            {"inertia", std::vector<double>(I.data(), I.data() + 9)}};
  const auto entered = enteredPayloadFromJson(desk, "desk.json", recording.meta.mount);
  ASSERT_TRUE(entered) << entered.error().message;
  EXPECT_LT((toParameters(entered->payload) - toParameters(kProved)).norm(), 1e-12);
  EXPECT_EQ(proofOf(*entered, recording).verdict, ProofVerdict::pass);
  SensorMount elsewhere = recording.meta.mount;
  elsewhere.xyz.x() += 0.02;
  EXPECT_EQ(proofOf(*enteredPayloadFromJson(desk, "desk.json", elsewhere), recording).reasons.front().code,
            "other_centre");
}

TEST(Proof, AWrongMassOrCentreFails) {
  for (unsigned seed = 0; seed < 6; ++seed) {
    const Recording recording = guided(kProved, 7300 + seed);
    Payload heavy = kProved;
    heavy.mass *= seed % 2 == 0 ? 1.05 : 0.95;
    const Proof mass = proofOf(bare(heavy), recording);
    ASSERT_EQ(mass.verdict, ProofVerdict::notYet);
    EXPECT_EQ(mass.reasons.front().code, "other_mass");
    EXPECT_NEAR(mass.off(0), heavy.mass - kProved.mass, 0.01);
    Payload shifted = kProved;
    shifted.com(seed % 3) += 0.005;
    const Proof centre = proofOf(bare(shifted), recording);
    ASSERT_EQ(centre.verdict, ProofVerdict::notYet);
    EXPECT_EQ(centre.reasons.front().code, "other_centre");
    EXPECT_NEAR(centre.off(1 + seed % 3), 0.005, 0.001);
  }
}

TEST(Proof, SomethingBesidesThePayloadFailsWithItsReason) {
  for (const EffectRequest& effect : {EffectRequest{"cable_pull", "", 15.0}, EffectRequest{"time_offset", "", 25.0}}) {
    const Proof proof = proofOf(bare(kProved), guided(kProved, 7400, {effect}));
    EXPECT_EQ(proof.verdict, ProofVerdict::notYet) << effect.id;
    ASSERT_FALSE(proof.reasons.empty()) << effect.id;
    EXPECT_FALSE(proof.reasons.front().text.empty());
    EXPECT_NE(proof.own.trust, Trust::good) << effect.id;
  }
}

TEST(Proof, WithoutMotionNothingIsProved) {
  const Proof proof = proofOf(bare(kProved), test::standingStill(test::recordingOf(MotionKind::free, kProved, 7500)));
  EXPECT_EQ(proof.verdict, ProofVerdict::cannotTell) << toText(proof);
  EXPECT_THAT(toText(proof), testing::StartsWith("NOT YET. This recording is not sufficient."));
  EXPECT_THAT(proof.reasons.front().remedy, testing::HasSubstr("tilt it in all directions"));
  // A payload that says of itself that it is not known proves nothing either.
  EnteredPayload vague = bare(kProved);
  vague.std.mass = 0.1;
  const Proof wide = proofOf(vague, guided(kProved, 7501));
  EXPECT_EQ(wide.verdict, ProofVerdict::cannotTell);
  EXPECT_THAT(wide.reasons.front().remedy, testing::HasSubstr("own interval"));
}

TEST(Proof, AMotionThatMakesLittleLoadIsNotTakenForAFault) {
  for (unsigned seed = 7800; seed < 7806; ++seed) {
    const Proof proof = proofOf(bare(kProved), guided(kProved, seed, {}, 0.02));
    EXPECT_NE(proof.verdict, ProofVerdict::notYet) << toText(proof);
  }
}

TEST(Proof, TheIntervalOfThePayloadIsAllowedFor) {
  Payload off = kProved;
  off.mass += 0.03;
  EnteredPayload entered = bare(off);
  const Recording recording = guided(kProved, 7600);
  EXPECT_EQ(proofOf(entered, recording).reasons.front().code, "other_mass");
  entered.std.mass = 0.02;
  EXPECT_EQ(proofOf(entered, recording).reasons.front().code, "cannot_tell");
}

TEST(Proof, ItsJsonHasWhatAProgramNeeds) {
  const auto json = toJson(proofOf(bare(kProved), guided(kProved, 7700)));
  EXPECT_EQ(json["schema"], "heft.prove/1");
  EXPECT_EQ(json["verdict"], "pass");
  EXPECT_EQ(json["left_rms"]["force_n"].size(), 3u);
  EXPECT_LT(json["would_see"]["com_m"].get<double>(), 0.005);
  EXPECT_TRUE(json["reasons"].empty());
}

}  // namespace
}  // namespace heft
