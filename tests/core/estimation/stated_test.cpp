// Soft information about the payload: its derivatives, and what it does to an estimate.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/estimation/estimate.h"
#include "core/estimation/map.h"
#include "tests/support/estimation_fixtures.h"
#include "tests/support/random_payload.h"

namespace heft {
namespace {

using test::has;
using test::recordingOf;
using test::reportOf;
using test::standingStill;

Payload tool() { return test::boxPayload(0.8, {0.08, 0.10, 0.20}, {0.01, -0.005, 0.06}); }

StatedPayload stated(const Payload& payload, double mass, double centre, double shape) {
  StatedPayload out;
  out.mass = payload.mass;
  out.com = payload.com;
  out.spread = (0.5 * payload.inertiaCom.trace() * Matrix3d::Identity() - payload.inertiaCom) / payload.mass;
  out.massStd = mass;
  out.centreStd = centre;
  out.shapeStd = shape;
  out.source = "cad.json";
  return out;
}

TEST(Stated, DerivativesAreThoseOfFiniteDifferences) {
  std::mt19937 random(3);
  MapPrior prior = vaguePrior(0.7, {0.0, 0.02, 0.05});
  prior.stated = {termFrom(stated(test::randomPayload(random), 0.1, 0.2, 0.3)), termFrom(*parseScaleMass("0.9+-0.01"))};
  for (int trial = 0; trial < 5; ++trial) {
    const Vector10d v = 0.3 * Vector10d::Random();
    const Vector10d slope = 2.0 * prior.halfGradient(v);
    for (int i = 0; i < 10; ++i) {
      const Vector10d step = 1e-5 * Vector10d::Unit(i);
      const double difference = (prior.cost(v + step) - prior.cost(v - step)) / 2e-5;
      EXPECT_NEAR(slope(i), difference, 1e-5 * std::max(1.0, std::abs(difference))) << i;
    }
  }
}

TEST(Stated, EqualWeightsAreTheEntropicDivergenceAtEqualMass) {
  // 2 D = tr(P0^-1 P) - ln(|P| / |P0|) - 4 with weights 1 for all squares; here with masses equal.
  std::mt19937 random(4);
  for (int trial = 0; trial < 10; ++trial) {
    const Payload a = test::randomPayload(random);
    Payload b = test::randomPayload(random);
    b.inertiaCom *= a.mass / b.mass;
    b.mass = a.mass;
    MapPrior prior = vaguePrior(0.7, {0.0, 0.02, 0.05});
    prior.information.setZero();
    StatedTerm term = termFrom(stated(a, 1.0, 1.0, 1.0));
    term.weight << std::sqrt(2.0) * Vector3d::Ones(), Vector6d::Ones(), 0.0;
    prior.stated = {term};
    const Matrix4d Pa = pseudoInertia(toParameters(a)), Pb = pseudoInertia(toParameters(b));
    const double divergence = (Pa.inverse() * Pb).trace() - std::log(Pb.determinant() / Pa.determinant()) - 4.0;
    EXPECT_NEAR(prior.cost(vFromParameters(prior, toParameters(b))), divergence, 1e-6 * divergence);
  }
}

TEST(Stated, MassCentreAndShapeAreToldApart) {
  // A scale's mass moves neither the centre nor the radii of gyration.
  MapPrior prior = vaguePrior(0.7, {0.0, 0.02, 0.05});
  prior.stated = {termFrom(*parseScaleMass("1.4"))};
  const MapSolution map = solveMap(Triangle::Zero(), prior, true, Vector10d::Zero());
  const Payload payload = fromParameters(map.phi);
  EXPECT_NEAR(payload.mass, 1.4, 0.002);
  EXPECT_LT((payload.com - Vector3d(0.0, 0.02, 0.05)).norm(), 0.03);
  // Another mass with the shape of a CAD model: the inertia grows with the mass.
  StatedPayload cad = stated(tool(), 0.1, 0.01, 0.01);
  cad.mass.reset();
  prior = vaguePrior(0.8, tool().com, *cad.spread);
  prior.stated = {termFrom(cad), termFrom(*parseScaleMass("1.6"))};
  const Payload heavy = fromParameters(solveMap(Triangle::Zero(), prior, true, Vector10d::Zero()).phi);
  EXPECT_NEAR(heavy.inertiaCom(0, 0), 2.0 * tool().inertiaCom(0, 0), 0.02 * tool().inertiaCom(0, 0));
}

TEST(Stated, RowsInPhiAreTheSameQuadraticForm) {
  std::mt19937 random(5);
  MapPrior prior = vaguePrior(0.7, {0.0, 0.02, 0.05});
  prior.stated = {termFrom(stated(tool(), 0.1, 0.2, 0.3))};
  const Vector10d v = 0.1 * Vector10d::Random();
  const Triangle R = priorRows(prior, v);
  const auto cost = [&](const Vector10d& w) {
    Eigen::Matrix<double, kColumns + 1, 1> x = Eigen::Matrix<double, kColumns + 1, 1>::Zero();
    x.segment<10>(kBiasColumns) = parametersFromV(prior, w);
    x(kColumns) = -1.0;
    return (R * x).squaredNorm();
  };
  const Vector10d step = 1e-3 * Vector10d::Random();
  EXPECT_NEAR(cost(v + step) - cost(v), prior.cost(v + step) - prior.cost(v),
              1e-2 * std::abs(prior.cost(v + step) - prior.cost(v)) + 1e-5);
}

TEST(Stated, AScaleSharpensTheMassThatTheMotionHardlyTells) {
  Recording recording = recordingOf(MotionKind::free, tool(), 31, 0.3);
  EstimateOptions options;
  options.stated = {*parseScaleMass("0.8+-0.0002")};
  const auto plain = reportOf(recording), weighed = reportOf(recording, options);
  EXPECT_LT(weighed.std.mass, 0.4 * plain.std.mass);
  EXPECT_NEAR(weighed.payload.mass, 0.8, 0.0006);
  EXPECT_EQ(weighed.identifiability.mass, Source::prior);
  EXPECT_EQ(weighed.identifiability.com[0], Source::data);
  EXPECT_TRUE(weighed.evidence.hasPrior);
  EXPECT_NEAR(weighed.evidence.prior(0), 0.8, 1e-4);
  EXPECT_TRUE(std::isnan(weighed.evidence.prior(1))) << "nobody told the centre";
  EXPECT_NEAR(weighed.evidence.data(0), plain.payload.mass, 0.2 * plain.std.mass);
  EXPECT_NEAR(weighed.evidence.shift(0),
              (weighed.payload.mass - weighed.evidence.data(0)) / weighed.evidence.dataStd(0), 1e-9);
  EXPECT_FALSE(plain.evidence.hasPrior);
  EXPECT_THAT(toText(weighed), testing::HasSubstr("your input"));
}

TEST(Stated, StandingStillReturnsTheCadValuesAndSaysSo) {
  const Recording recording = standingStill(recordingOf(MotionKind::free, tool(), 32));
  EstimateOptions options;
  options.stated = {stated(tool(), 0.03, 0.1, 0.05)};
  const auto report = reportOf(recording, options);
  EXPECT_NEAR(report.payload.mass, 0.8, 0.002);
  EXPECT_LT((report.payload.com - tool().com).norm(), 1e-3);
  EXPECT_LT((report.payload.inertiaCom - tool().inertiaCom).norm(), 0.02 * tool().inertiaCom.norm());
  EXPECT_EQ(report.identifiability.mass, Source::prior);
  EXPECT_EQ(report.identifiability.inertia[2][2], Source::prior);
  EXPECT_TRUE(has(report, "from_what_you_gave"));
  EXPECT_FALSE(has(report, "mass_not_known"));
  EXPECT_THAT(toText(report),
              testing::StartsWith("This motion does not determine the mass of your tool; 0.80 kg is your "
                                  "own value."));
  EXPECT_TRUE(std::isnan(report.evidence.data(0))) << "the motion alone knows nothing";
}

TEST(Stated, AScaleWithoutMotionLeavesTheRestUnknown) {
  EstimateOptions options;
  options.stated = {*parseScaleMass("0.8")};
  const auto report = reportOf(standingStill(recordingOf(MotionKind::free, tool(), 33)), options);
  EXPECT_EQ(report.identifiability.mass, Source::prior);
  EXPECT_EQ(report.identifiability.com[0], Source::none);
  EXPECT_EQ(report.identifiability.inertia[0][0], Source::none);
}

TEST(Stated, ContradictionIsPointedOut) {
  EstimateOptions options;
  options.stated = {*parseScaleMass("0.9")};
  EXPECT_TRUE(has(reportOf(recordingOf(MotionKind::free, tool(), 34), options), "prior_contradicts_data"));
  options.stated = {*parseScaleMass("0.802")};
  EXPECT_FALSE(has(reportOf(recordingOf(MotionKind::free, tool(), 34), options), "prior_contradicts_data"));
}

TEST(Stated, AShapeAndAScaleTellTheInertiaTogether) {
  const Recording recording = standingStill(recordingOf(MotionKind::free, tool(), 35));
  EstimateOptions options;
  options.shape = *parseShape("box:0.08,0.10,0.20@0.01,-0.005,0.06");
  const auto shapeOnly = reportOf(recording, options);
  EXPECT_EQ(shapeOnly.identifiability.mass, Source::none) << "nobody told the density";
  EXPECT_EQ(shapeOnly.identifiability.inertia[0][0], Source::none);
  options.stated = {*parseScaleMass("0.8")};
  const auto both = reportOf(recording, options);
  EXPECT_NEAR(both.payload.mass, 0.8, 0.008);
  EXPECT_EQ(both.identifiability.inertia[0][0], Source::prior);
  EXPECT_NEAR(both.payload.inertiaCom(0, 0), tool().inertiaCom(0, 0), 0.25 * tool().inertiaCom(0, 0));
}

TEST(Stated, FewerParametersAreWeighedToo) {
  Recording recording = recordingOf(MotionKind::free, tool(), 36, 0.3);
  EstimateOptions options;
  options.parameters = ParameterSet::massCom;
  const auto plain = reportOf(recording, options);
  options.stated = {*parseScaleMass("0.8+-0.0002")};
  const auto weighed = reportOf(recording, options);
  EXPECT_LT(weighed.std.mass, 0.4 * plain.std.mass);
  EXPECT_NEAR(weighed.payload.mass, 0.8, 0.0006);
}

TEST(Stated, PrecisionAtBestIsThatOfTheDataAlone) {
  const Recording recording = recordingOf(MotionKind::excitation, tool(), 37);
  const auto report = reportOf(recording);
  EXPECT_NEAR(report.evidence.best(0), report.std.mass, 0.05 * report.std.mass);
  EXPECT_NEAR(report.evidence.best(4), report.std.inertiaCom(0, 0), 0.1 * report.std.inertiaCom(0, 0));
  ASSERT_EQ(report.identifiability.directions.size(), 10u);
  EXPECT_GT(report.identifiability.directions.back().dataShare, 0.5);
  const auto still = reportOf(standingStill(recording));
  EXPECT_LT(still.identifiability.directions.back().dataShare, 0.01);
  EXPECT_TRUE(std::isnan(still.evidence.best(4)));
}

TEST(Stated, WeakDirectionsSpeakOfTheToolsOwnAxes) {
  EstimateOptions options;
  options.stated = {stated(tool(), 0.03, 0.1, 0.05)};
  const auto report = reportOf(standingStill(recordingOf(MotionKind::free, tool(), 38)), options);
  EXPECT_THAT(report.identifiability.weakDirections,
              testing::Contains(
                  testing::HasSubstr("never rotated fast enough about the tool's long axis (near the sensor's z)")));
}

}  // namespace
}  // namespace heft
