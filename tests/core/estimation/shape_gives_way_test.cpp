// A rough shape helps where the motion says little, and gives way where the motion says that it is of another tool.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "core/estimation/estimate.h"
#include "core/estimation/prepare.h"
#include "core/payload/shape_prior.h"
#include "tests/support/estimation_fixtures.h"
#include "tests/support/random_tool.h"

namespace heft {
namespace {

using test::has;
using test::recordingOf;
using test::reportOf;

/// Each dimension and place off by this share, up or down.
Shape offBy(Shape shape, double share, std::mt19937& random) {
  const auto off = [&] { return 1.0 + (random() % 2 == 0 ? share : -share); };
  shape.certainty = Certainty::rough;
  for (ShapeBody& body : shape.bodies) {
    for (double& dim : body.dims) dim *= off();
    body.X_SB.translation() *= off();
  }
  return shape;
}

/// Standard deviations between shape and motion, as the estimate weighs them.
double awayOf(const Recording& recording, const Shape& shape) {
  const auto prepared = prepare(recording, &RobotModel::panda(), {}, {});
  EXPECT_TRUE(prepared.ok());
  Findings findings;
  const auto samples = sampleShape(shape, findings);
  EXPECT_TRUE(samples.ok());
  const ShapePrior prior(shape, *samples);
  const Triangle& R = prepared->whitened;
  const ShapeFit fit = prior.fit(R.block(kBiasColumns, kBiasColumns, kColumns + 1 - kBiasColumns, 10),
                                 R.col(kColumns).tail(kColumns + 1 - kBiasColumns));
  return std::sqrt(fit.conflict);
}

TEST(ShapeGivesWay, HelpfulShapesStayFarBelowTheLimit) {
  double tenth = 0.0, fourTenths = 0.0;
  for (unsigned i = 0; i < 12; ++i) {
    std::mt19937 random(7100u + i);
    const test::RandomTool tool = test::randomTool(random);
    const Recording recording = recordingOf(MotionKind::free, tool.payload, random(), i % 2 == 0 ? 1.0 : 0.3);
    const Shape near = offBy(tool.shape, 0.1, random), far = offBy(tool.shape, 0.4, random);
    tenth = std::max(tenth, awayOf(recording, near));
    fourTenths = std::max(fourTenths, awayOf(recording, far));
    EstimateOptions options;
    options.shape = near;
    EXPECT_FALSE(has(reportOf(recording, options), "shape_left_out")) << i;
  }
  std::printf("largest distance: 10 %% off %.1f, 40 %% off %.1f standard deviations\n", tenth, fourTenths);
  EXPECT_LT(tenth, 8.0);
}

TEST(ShapeGivesWay, AnAbsurdRoughShapeDoesNotMoveTheResult) {
  const Payload truth = test::boxPayload(0.8, {0.08, 0.10, 0.16}, {0.005, -0.01, 0.06});
  const Recording recording = recordingOf(MotionKind::excitation, truth, 73);
  const EstimateReport plain = reportOf(recording);
  EstimateOptions options;
  // A plate of steel's size and two thin fingers beside the tool.
  options.shape = *parseShape("box:0.12,0.08,0.005@0.10,0.08,0.0025");
  options.shape->bodies.push_back(parseShape("box:0.04,0.058,0.003@0.10,0.08,0.006")->bodies.front());
  options.shape->certainty = Certainty::rough;
  const EstimateReport report = reportOf(recording, options);
  ASSERT_TRUE(has(report, "shape_left_out"));
  EXPECT_FALSE(report.evidence.hasPrior) << "nothing was blended that a share could be told of";
  EXPECT_EQ(report.trust, Trust::good) << "the motion knows by itself";
  EXPECT_NEAR(report.payload.mass, plain.payload.mass, 1e-9);
  EXPECT_LT((report.payload.inertiaCom - plain.payload.inertiaCom).norm(), 1e-9);
  EXPECT_NEAR(report.payload.mass, truth.mass, 3.0 * report.std.mass);
  // Who says that it is sure is taken at his word, and the numbers are not trusted.
  options.shape->certainty = Certainty::exact;
  const EstimateReport sure = reportOf(recording, options);
  EXPECT_FALSE(has(sure, "shape_left_out"));
  EXPECT_NE(sure.trust, Trust::good);
}

}  // namespace
}  // namespace heft
