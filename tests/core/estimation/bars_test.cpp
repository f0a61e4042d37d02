// How good estimates from free and from slow guiding are in the middle, with and without a shape.
#include <gtest/gtest.h>

#include "core/estimation/estimate.h"
#include "core/estimation/uncertainty.h"
#include "core/math/statistics.h"
#include "core/simulation/simulate.h"
#include "tests/support/random_tool.h"

namespace heft {
namespace {

/// Dimensions and places of a shape picked by eye: each is off by up to a tenth.
Shape roughlyRight(const test::RandomTool& tool, std::mt19937& random) {
  const auto off = [&random] { return 1.0 + (random() % 2 == 0 ? 0.1 : -0.1); };
  Shape shape = tool.shape;
  shape.certainty = Certainty::rough;
  for (auto& body : shape.bodies) {
    for (double& dim : body.dims) dim *= off();
    body.X_SB.translation().z() *= off();
  }
  return shape;
}

/// A user who takes one cylinder about the z axis for two turned boxes; it spans as much and is as wide on average.
Shape wrongKind(const test::RandomTool& tool) {
  double low = 1.0, high = -1.0, width = 0.0;
  for (const auto& body : tool.shape.bodies) {
    const double z = body.X_SB.translation().z();
    low = std::min(low, z - 0.5 * body.dims[2]);
    high = std::max(high, z + 0.5 * body.dims[2]);
    width += 0.25 * (body.dims[0] + body.dims[1]);
  }
  Shape shape;
  ShapeBody body;
  body.kind = BodyKind::cylinder;
  body.dims = {0.5 * width, high - low};
  body.X_SB.translation().z() = 0.5 * (low + high);
  shape.bodies = {body};
  shape.certainty = Certainty::rough;
  return shape;
}

enum class Given { nothing, roughlyRight, wrongKind };

struct Medians {
  double mass = 0, com = 0, inertiaOrigin = 0, inertiaCom = 0;
  double inside = 0;  ///< Share of the ten numbers' 95 % intervals that hold the truth
  int unphysical = 0, count = 0;
};

Medians mediansOver(int recordings, double speed, double duration, Given given) {
  std::vector<double> mass, com, origin, inertia;
  Medians out;
  double inside = 0.0;
  for (int i = 0; i < recordings; ++i) {
    std::mt19937 random(4000u + static_cast<unsigned>(i));
    const test::RandomTool tool = test::randomTool(random);
    SimulateOptions simulation;
    simulation.motion = MotionKind::free;
    simulation.speed = speed;
    simulation.duration = duration;
    simulation.seed = random();
    auto simulated = simulate(RobotModel::panda(), tool.payload, simulation);
    EXPECT_TRUE(simulated.ok());
    simulated->recording.meta.knownPayload = {tool.payload.mass, tool.payload.com, tool.payload.inertiaCom};
    EstimateOptions options;
    if (given == Given::roughlyRight) options.shape = roughlyRight(tool, random);
    if (given == Given::wrongKind) options.shape = wrongKind(tool);
    const auto report = estimate(simulated->recording, &RobotModel::panda(), options);
    EXPECT_TRUE(report.ok());
    if (!report.ok()) continue;
    mass.push_back(report->relativeError->mass);
    com.push_back(report->relativeError->com);
    origin.push_back(report->relativeError->inertiaOrigin);
    inertia.push_back(report->relativeError->inertiaCom);
    out.unphysical += report->physicallyConsistent ? 0 : 1;
    const Vector10d truth = componentsOf(tool.payload);
    const auto& x = report->interval95;
    const auto& I = x.inertiaCom;
    const Interval all[10] = {x.mass,  x.com[0], x.com[1], x.com[2], I[0][0],
                              I[0][1], I[0][2],  I[1][1],  I[1][2],  I[2][2]};
    for (int k = 0; k < 10; ++k) inside += truth(k) >= all[k].lower && truth(k) <= all[k].upper ? 0.1 : 0.0;
    ++out.count;
  }
  out.mass = median(mass);
  out.com = median(com);
  out.inertiaOrigin = median(origin);
  out.inertiaCom = median(inertia);
  out.inside = inside / std::max(1, out.count);
  return out;
}

TEST(Bars, FreeGuidingNeedsNoShape) {
  const Medians m = mediansOver(16, 1.0, 20.0, Given::nothing);
  EXPECT_LT(m.mass, 0.002);
  EXPECT_LT(m.com, 0.005);
  EXPECT_LT(m.inertiaOrigin, 0.10);
  EXPECT_LT(m.inertiaCom, 0.10);
  EXPECT_EQ(m.unphysical, 0);
}

TEST(Bars, SlowGuidingWithAShapeTenPercentOff) {
  const Medians m = mediansOver(16, 0.3, 20.0, Given::roughlyRight);
  EXPECT_LT(m.mass, 0.005);
  EXPECT_LT(m.com, 0.01);
  EXPECT_LT(m.inertiaOrigin, 0.20);
  EXPECT_LT(m.inertiaCom, 0.20);
  EXPECT_EQ(m.unphysical, 0);
  EXPECT_GT(m.inside, 0.88);
}

TEST(Bars, SlowGuidingWithAShapeOfTheWrongKind) {
  const Medians m = mediansOver(16, 0.3, 20.0, Given::wrongKind);
  EXPECT_LT(m.mass, 0.005);
  EXPECT_LT(m.com, 0.01);
  EXPECT_LT(m.inertiaOrigin, 0.40);
  EXPECT_LT(m.inertiaCom, 0.40);
  EXPECT_EQ(m.unphysical, 0);
  EXPECT_GT(m.inside, 0.88);
}

}  // namespace
}  // namespace heft
