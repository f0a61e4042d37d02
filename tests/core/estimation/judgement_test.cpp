#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/estimation/estimate.h"
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
