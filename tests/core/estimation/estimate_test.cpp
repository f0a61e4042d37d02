#include "core/estimation/estimate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/estimation/estimate_prepared.h"
#include "core/estimation/uncertainty.h"
#include "tests/support/estimation_fixtures.h"
#include "tests/support/random_payload.h"

namespace heft {
namespace {

using test::has;
using test::recordingOf;
using test::reportOf;
using test::standingStill;

const RobotModel& panda() { return RobotModel::panda(); }

test::RandomTool tool(unsigned seed) {
  std::mt19937 random(seed);
  return test::randomTool(random);
}

Payload defaultPayload() { return test::boxPayload(0.8, {0.08, 0.10, 0.12}, {0.01, -0.005, 0.06}); }

TEST(Estimate, FullExcitationGivesEverything) {
  const auto report = reportOf(recordingOf(MotionKind::excitation, defaultPayload(), 1));
  EXPECT_LT(report.relativeError->mass, 0.002);
  EXPECT_LT(report.relativeError->com, 0.01);
  EXPECT_LT(report.relativeError->inertiaOrigin, 0.10);
  EXPECT_TRUE(report.physicallyConsistent);
  EXPECT_TRUE(report.termination.usable);
  EXPECT_EQ(report.identifiability.mass, Source::data);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(report.identifiability.inertia[i][i], Source::data);
  EXPECT_NEAR(report.usedDuration, 16.0, 0.3);
  EXPECT_FALSE(has(report, "misfit"));
  EXPECT_LT(report.heldoutForceRms, 1.2 * report.forceRms);
}

TEST(Estimate, CorrelationsAreThoseOfTheStatedNumbers) {
  Matrix10d covariance = Matrix10d::Zero();
  covariance.topLeftCorner<2, 2>() << 4.0, -3.0, -3.0, 9.0;
  const Matrix10d correlation = correlationFrom(covariance);
  EXPECT_DOUBLE_EQ(correlation(0, 1), -0.5);
  EXPECT_DOUBLE_EQ(correlation(5, 5), 1.0);
  EXPECT_DOUBLE_EQ(correlation(0, 5), 0.0);
  const auto report = reportOf(recordingOf(MotionKind::excitation, defaultPayload(), 3));
  EXPECT_TRUE(report.correlation.isApprox(report.correlation.transpose()));
  EXPECT_DOUBLE_EQ(report.correlation(3, 3), 1.0);
  EXPECT_LE(report.correlation.cwiseAbs().maxCoeff(), 1.0);
  EXPECT_GT((report.correlation - Matrix10d::Identity()).cwiseAbs().maxCoeff(), 0.01);
  ASSERT_EQ(report.identifiability.singularValues.size(), 10);
  EXPECT_DOUBLE_EQ(report.identifiability.singularValues(0) / report.identifiability.singularValues(9),
                   report.identifiability.conditionNumber);
}

TEST(Estimate, EveryMethodWorksOnARecording) {
  const Payload truth = defaultPayload();
  const Recording recording = recordingOf(MotionKind::excitation, truth, 2);
  for (const auto method : {Method::map, Method::ls, Method::wls, Method::tls, Method::tlsFast, Method::tlsExact,
                            Method::ceres, Method::eigenLm, Method::bruteForce}) {
    EstimateOptions options;
    options.method = method;
    const auto prepared = prepareFor(recording, &panda(), options, {});
    ASSERT_TRUE(prepared.ok()) << prepared.error().message;
    for (const auto set : {ParameterSet::mass, ParameterSet::massCom, ParameterSet::full}) {
      options.parameters = set;
      const auto report = estimatePrepared(recording, *prepared, options, {}, 0.0, {});
      ASSERT_TRUE(report.ok()) << report.error().message;
      EXPECT_LT(report->relativeError->mass, 0.01) << toString(method) << " " << toString(set);
      EXPECT_LT(report->relativeError->com, 0.06) << toString(method) << " " << toString(set);
      EXPECT_TRUE(report->termination.usable) << toString(method) << " " << report->termination.why;
      EXPECT_GT(report->std.mass, 0.0);
      EXPECT_EQ(report->std.inertiaCom(0, 0) > 0.0, set == ParameterSet::full);
    }
  }
}

TEST(Estimate, UncompressedIsTheSameToNineDigits) {
  const Recording recording = recordingOf(MotionKind::free, defaultPayload(), 3);
  for (const auto method : {Method::ls, Method::wls, Method::tlsExact, Method::tlsFast}) {
    EstimateOptions options;
    options.method = method;
    const auto small = reportOf(recording, options);
    options.uncompressed = true;
    const auto large = reportOf(recording, options);
    EXPECT_LT((toParameters(small.payload) - toParameters(large.payload)).norm(), 1e-9) << toString(method);
  }
}

TEST(Estimate, PickAndPlaceIsNotPulledByItsContacts) {
  const Payload truth = defaultPayload();
  const Recording recording = recordingOf(MotionKind::pickAndPlace, truth, 4);
  const auto report = reportOf(recording);
  EXPECT_LT(report.relativeError->mass, 0.005);
  EXPECT_LT(report.relativeError->com, 0.02);
  EXPECT_TRUE(has(report, "contact_left_out"));
  EstimateOptions all;
  all.segments = SegmentMode::all;
  EXPECT_GT(reportOf(recording, all).relativeError->com, 2.0 * report.relativeError->com);
}

TEST(Estimate, StandingStillKnowsNothingAndSaysSo) {
  const Recording recording = standingStill(recordingOf(MotionKind::free, defaultPayload(), 5));
  const auto report = reportOf(recording);
  EXPECT_EQ(report.identifiability.mass, Source::none);
  EXPECT_TRUE(has(report, "mass_not_known"));
  EXPECT_TRUE(has(report, "inertia_not_known"));
  EXPECT_TRUE(report.physicallyConsistent);
  EXPECT_GT(report.payload.mass, 0.05);
  EXPECT_LT(report.payload.mass, 20.0);
  EXPECT_LT(report.interval95.mass.lower, 0.4) << "the interval must not exclude the truth";
  EXPECT_GT(report.interval95.mass.upper, 1.5);
  EXPECT_THAT(toText(report), testing::HasSubstr("does not determine the mass"));
}

TEST(Estimate, StandingStillWithAShapeReturnsTheShape) {
  const Recording recording = standingStill(recordingOf(MotionKind::free, defaultPayload(), 6));
  EstimateOptions options;
  options.shape = Shape{{ShapeBody{}}, Certainty::good, 0.8};
  options.shape->bodies[0].dims = {0.08, 0.10, 0.12};
  options.shape->bodies[0].X_SB.translation() = Vector3d(0.01, -0.005, 0.06);
  const auto report = reportOf(recording, options);
  EXPECT_NEAR(report.payload.mass, 0.8, 0.02) << "weighed on a scale";
  EXPECT_EQ(report.identifiability.mass, Source::prior);
  EXPECT_EQ(report.identifiability.inertia[2][2], Source::prior);
  EXPECT_NEAR(report.payload.com.z(), 0.06, 0.01);
  EXPECT_NEAR(report.payload.inertiaCom(2, 2), defaultPayload().inertiaCom(2, 2),
              0.3 * defaultPayload().inertiaCom(2, 2));
}

TEST(Estimate, NoiseOfStandingJointsIsNoMotion) {
  Recording recording = standingStill(recordingOf(MotionKind::free, defaultPayload(), 4));
  recording.dq.resize(0, 0);
  recording.meta.knownPayload = {};
  std::mt19937 random(11);
  std::normal_distribution<double> noise(0.0, 1e-5);
  for (double& q : recording.q.reshaped()) q += noise(random);

  const auto alone = reportOf(recording);
  EXPECT_TRUE(has(alone, "stood_still"));
  EXPECT_EQ(alone.identifiability.mass, Source::none);
  EXPECT_GT(alone.interval95.mass.upper, 3.0) << "nothing is known, so the interval is wide";
  EXPECT_LT(alone.interval95.mass.lower, 0.2);

  // What was given comes back, and nothing contradicts it.
  EstimateOptions options;
  Shape shape;
  ShapeBody body;
  body.kind = BodyKind::cylinder;
  body.dims = {0.03, 0.15};
  body.X_SB.translation().z() = 0.08;
  shape.bodies = {body};
  shape.certainty = Certainty::rough;
  options.shape = shape;
  StatedPayload scale;
  scale.mass = 0.812;
  scale.massStd = 0.005;
  options.stated = {scale};
  const auto told = reportOf(recording, options);
  EXPECT_NEAR(told.payload.mass, 0.812, 0.01);
  EXPECT_NEAR(told.payload.com.z(), 0.08, 0.01);
  EXPECT_EQ(told.identifiability.mass, Source::prior);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(told.identifiability.inertia[i][i], Source::prior);
  EXPECT_FALSE(has(told, "prior_contradicts_data"));
}

TEST(Estimate, AShapeHelpsWhereSlowMotionCannot) {
  double with = 0.0, without = 0.0;
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const auto t = tool(seed);
    const Recording recording = recordingOf(MotionKind::free, t.payload, seed, 0.3);
    without += reportOf(recording).relativeError->inertiaCom / 5;
    EstimateOptions options;
    options.shape = t.shape;
    with += reportOf(recording, options).relativeError->inertiaCom / 5;
  }
  EXPECT_LT(with, without);
  EXPECT_LT(with, 0.05);
}

TEST(Estimate, SpikesDoNoHarm) {
  const Payload truth = defaultPayload();
  Recording recording = recordingOf(MotionKind::free, truth, 7);
  for (Eigen::Index k = 100; k + 100 < recording.rows(); k += 97)
    recording.wrench(k, k % 6) += (k % 2 ? 8.0 : -8.0) * (k % 6 < 3 ? 1.0 : 0.2);
  const auto report = reportOf(recording);
  EXPECT_TRUE(has(report, "spikes_removed"));
  EXPECT_LT(report.relativeError->mass, 0.003);
  EXPECT_LT(report.relativeError->com, 0.01);
}

TEST(Estimate, StandingPosesGiveMassAndCentreButNoInertia) {
  const Payload truth = defaultPayload();
  Recording recording;
  recording.meta.kind = RecordingKind::poses;
  recording.time = VectorXd::LinSpaced(12, 0, 11);
  recording.quaternion.resize(12, 4);
  recording.wrench.resize(12, 6);
  std::mt19937 random(8);
  std::normal_distribution<double> normal;
  for (int k = 0; k < 12; ++k) {
    const Matrix3d R = test::randomRotation(random);
    recording.quaternion.row(k) = Quaterniond(R).coeffs().transpose();
    const Vector6d F = predictWrench(truth, {R.transpose() * Vector3d(0, 0, 9.81), Vector3d::Zero(), Vector3d::Zero()});
    for (int c = 0; c < 6; ++c) recording.wrench(k, c) = F(c) + normal(random) * (c < 3 ? 0.02 : 0.001);
  }
  const auto report = estimate(recording, nullptr, {});
  ASSERT_TRUE(report.ok());
  EXPECT_NEAR(report->payload.mass, truth.mass, 0.01);
  EXPECT_LT((report->payload.com - truth.com).norm(), 0.003);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(report->identifiability.inertia[i][i], Source::none);
  recording.wrench.conservativeResize(3, 6);
  recording.quaternion.conservativeResize(3, 4);
  recording.time.conservativeResize(3);
  const auto few = estimate(recording, nullptr, {});
  ASSERT_FALSE(few.ok());
  EXPECT_THAT(few.error().message, testing::HasSubstr("at least 6"));
}

TEST(Estimate, AWrongGravitySignIsNotANegativeMassInMap) {
  Recording recording = recordingOf(MotionKind::free, defaultPayload(), 9);
  recording.wrench *= -1.0;  // the other sign convention, not stated
  const auto map = reportOf(recording);
  EXPECT_GT(map.payload.mass, 0.0);
  EXPECT_TRUE(map.physicallyConsistent);
  EstimateOptions options;
  options.method = Method::ls;
  const auto ls = reportOf(recording, options);
  EXPECT_LT(ls.payload.mass, 0.0);
  // One thing is wrong, and it is told once: the sign, not what follows from it.
  for (const EstimateReport* report : {&map, &ls}) {
    EXPECT_EQ(report->trust, Trust::none);
    ASSERT_TRUE(report->conventions.suggested);
    EXPECT_EQ(report->conventions.suggested->sign, WrenchSign::payloadOnSensor);
    EXPECT_TRUE(has(*report, "no_trust"));
    EXPECT_FALSE(has(*report, "not_physical"));
    EXPECT_FALSE(has(*report, "wrench_sign"));
  }
}

TEST(Estimate, AKnownMassThatCannotBeIsPointedOut) {
  Recording recording = recordingOf(MotionKind::free, defaultPayload(), 10);
  recording.meta.knownPayload.mass = 1.2;
  EXPECT_TRUE(has(reportOf(recording), "known_disagrees"));
}

TEST(Estimate, WithoutBiasColumnsAnUnbiasedSensorIsFittedBetter) {
  SimulateOptions simulation;
  simulation.sensor.forceBias = simulation.sensor.torqueBias = 0.0;
  simulation.seed = 11;
  auto simulated = simulate(panda(), defaultPayload(), simulation);
  const auto with = reportOf(simulated->recording);
  EstimateOptions options;
  options.bias = false;
  const auto without = reportOf(simulated->recording, options);
  EXPECT_EQ(without.forceBias.norm(), 0.0);
  EXPECT_LT(without.std.mass, with.std.mass);
  EXPECT_NEAR(without.payload.mass, 0.8, 0.005);
}

TEST(Estimate, KnownInertiaAboutTheCentreOfMassIsHeldThere) {
  const Payload truth = defaultPayload();
  const Recording recording = recordingOf(MotionKind::excitation, truth, 12);
  EstimateOptions options;
  options.parameters = ParameterSet::massCom;
  const auto report = reportOf(recording, options);
  EXPECT_LT((report.payload.inertiaCom - truth.inertiaCom).norm(), 1e-6);
  EXPECT_EQ(report.identifiability.inertia[0][0], Source::prior);
}

/// A torque that was not measured is no torque of zero: with it the centre of mass would be known to lie on the axis.
TEST(Estimate, AChannelThatHardlyChangesIsNotUsed) {
  const Payload truth = defaultPayload();
  Recording recording = recordingOf(MotionKind::excitation, truth, 8);
  recording.wrench.col(5).setConstant(0.01);
  const auto report = reportOf(recording);
  EXPECT_TRUE(has(report, "channel_unused"));
  for (const int i : {0, 1, 2})
    EXPECT_LT(std::abs(report.payload.com(i) - truth.com(i)), 4.0 * report.std.com(i) + 1e-5) << i;
  EXPECT_LT((report.payload.com - truth.com).norm(), 0.002);
  EXPECT_FALSE(has(reportOf(recordingOf(MotionKind::excitation, truth, 8)), "channel_unused"));
}

TEST(Estimate, BadRequestsAreAnsweredWithASentence) {
  const Recording recording = recordingOf(MotionKind::free, defaultPayload(), 13);
  EstimateOptions options;
  options.trim = 0.5;
  EXPECT_THAT(estimate(recording, &panda(), options).error().message, testing::HasSubstr("trim"));
  Recording marked = recording;
  marked.meta.marks = {{0.0, 30.0, MarkLabel::contact}};
  EXPECT_THAT(estimate(marked, &panda(), {}).error().message, testing::HasSubstr("Not enough free motion"));
  EXPECT_THAT(estimate(recording, nullptr, {}).error().message, testing::HasSubstr("robot"));
}

TEST(Estimate, CanBeStopped) {
  std::stop_source source;
  source.request_stop();
  Progress progress{source.get_token(), {}};
  const auto report = estimate(recordingOf(MotionKind::free, defaultPayload(), 14), &panda(), {}, progress);
  ASSERT_FALSE(report.ok());
  EXPECT_TRUE(report.error().cancelled);
}

}  // namespace
}  // namespace heft
