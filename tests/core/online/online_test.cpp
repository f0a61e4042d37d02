#include "core/online/online_estimator.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "core/estimation/estimate.h"
#include "core/estimation/prepare.h"
#include "core/estimation/triangle.h"
#include "core/estimation/uncertainty.h"
#include "core/online/block_learner.h"
#include "tests/core/online/feed.h"

namespace heft {
namespace {

using test::estimatorFor;
using test::feed;
using test::onlineTool;
using test::simulated;

EstimateOptions batchOptions(double cutoff) {
  EstimateOptions options;
  options.trim = 0.0;
  options.segments = SegmentMode::automatic;
  options.motion.cutoffHz = cutoff;
  return options;
}

/// Largest difference of the ten reported numbers, in the batch's standard deviations.
double difference(const OnlineState& state, const EstimateReport& batch) {
  const Vector10d d = componentsOf(state.payload) - componentsOf(batch.payload);
  return d.cwiseQuotient(componentsOf(batch.std)).cwiseAbs().maxCoeff();
}

/// Largest difference of the standard deviations, relative.
double stdDifference(const OnlineState& state, const EstimateReport& batch) {
  const Vector10d a = componentsOf(state.std), b = componentsOf(batch.std);
  return (a - b).cwiseQuotient(b).cwiseAbs().maxCoeff();
}

OnlineOptions at25Hz(std::optional<Shape> shape = std::nullopt) {
  OnlineOptions options;
  options.cutoffHz = 25.0;
  options.shape = std::move(shape);
  return options;
}

TEST(Online, LinearPartIsThatOfTheBatchToRounding) {
  const Recording recording = simulated(MotionKind::free, onlineTool(), 4, 12.0);
  OnlineEstimator online = estimatorFor(recording, at25Hz());
  feed(online, recording);
  online.finish();
  const auto prepared = prepare(recording, &RobotModel::panda(), batchOptions(25.0), {});
  ASSERT_TRUE(prepared.ok());
  TriangleBuilder builder;
  for (const auto& run : prepared->runs)
    for (Eigen::Index k = run.from; k < run.to; ++k) builder.add(blockRows(prepared->blocks, k));
  const Triangle batch = builder.finish(), live = online.rows();
  const Triangle a = batch.transpose() * batch, b = live.transpose() * live;
  EXPECT_LT((a - b).norm(), 1e-9 * a.norm());
  const auto solve = [](const Triangle& R) {
    return VectorXd(R.leftCols<kColumns>().colPivHouseholderQr().solve(R.col(kColumns)));
  };
  EXPECT_LT((solve(batch) - solve(live)).norm(), 1e-6 * solve(batch).norm());
}

TEST(Online, BlocksAndLabelsAreThoseOfTheBatch) {
  const Recording recording = simulated(MotionKind::pickAndPlace, onlineTool(), 5);
  SampleStream stream(recording.meta, 7);
  Lane lane(25.0);
  for (Eigen::Index k = 0; k < recording.rows(); ++k) {
    stream.add(sampleOf(recording, k));
    if (k % 40 == 0) {
      stream.removeSpikes();
      lane.advance(stream, &RobotModel::panda(), true, false);
      stream.forget(lane.needed());
    }
  }
  stream.removeSpikes();
  lane.advance(stream, &RobotModel::panda(), true, true);
  const auto prepared = prepare(recording, &RobotModel::panda(), batchOptions(25.0), {});
  ASSERT_EQ(lane.blocks.size(), prepared->blocks.size());
  const Prepared learned = learnedFrom(lane.blocks);
  for (Eigen::Index k = 0; k < lane.blocks.size(); ++k) {
    const auto i = static_cast<std::size_t>(k);
    EXPECT_NEAR(lane.blocks.time[i], prepared->blocks.time(k), 1e-9);
    if (!lane.blocks.usable[i]) continue;
    EXPECT_LT((lane.blocks.Y[i] - prepared->blocks.Y[i]).norm(), 1e-7) << k;
    EXPECT_LT((lane.blocks.wrench[i] - prepared->blocks.wrench.col(k)).norm(), 1e-9) << k;
    EXPECT_EQ(learned.labels[i], prepared->labels[i]) << k;
  }
}

TEST(Online, EqualsTheBatchWithinATenthOfAStandardDeviation) {
  for (const auto kind : {MotionKind::free, MotionKind::pickAndPlace, MotionKind::excitation}) {
    const Recording recording = simulated(kind, onlineTool(), 5, 14.0);
    OnlineEstimator online = estimatorFor(recording, at25Hz());
    feed(online, recording);
    online.finish();
    const auto batch = estimate(recording, &RobotModel::panda(), batchOptions(25.0));
    ASSERT_TRUE(batch.ok());
    EXPECT_LT(difference(online.state(), *batch), 0.1) << toString(kind);
    EXPECT_LT(stdDifference(online.state(), *batch), 0.05) << toString(kind);
    EXPECT_NEAR(online.state().usedDuration, batch->usedDuration, 0.1) << toString(kind);
    EXPECT_EQ(online.state().identifiability.mass, batch->identifiability.mass);
  }
}

TEST(Online, ChoosesTheSmoothingAsTheBatchDoes) {
  Recording recording = simulated(MotionKind::free, onlineTool(), 6, 10.0);
  recording.dq.resize(0, 7);
  OnlineEstimator online = estimatorFor(recording);
  feed(online, recording);
  online.finish();
  const auto prepared = prepare(recording, &RobotModel::panda(), batchOptions(0.0), {});
  const auto batch = estimate(recording, &RobotModel::panda(), batchOptions(0.0));
  EXPECT_EQ(online.state().cutoffHz, prepared->cutoffHz);
  EXPECT_LT(difference(online.state(), *batch), 0.15);
}

TEST(Online, MotionAndWrenchPassTheSameFilterAsInTheBatch) {
  // Angles by 0.3 mrad: accelerations above a few hertz are noise, and the tremor is there.
  for (const unsigned seed : {21u, 22u}) {
    Recording recording = simulated(MotionKind::free, onlineTool(), seed, 14.0, 1.0, 250.0);
    recording.dq.resize(0, 7);
    recording.q = ((recording.q.array() / 3e-4).round() * 3e-4).matrix().eval();
    OnlineEstimator online = estimatorFor(recording);
    feed(online, recording);
    online.finish();
    ASSERT_LT(online.state().cutoffHz, 25.0) << seed;
    const auto batch = estimate(recording, &RobotModel::panda(), batchOptions(online.state().cutoffHz));
    // With the motion alone smoothed 1.5 and 0.15; what is left is that the batch takes off what the noise has done.
    EXPECT_LT(difference(online.state(), *batch), 0.6) << seed;
    EXPECT_LT(stdDifference(online.state(), *batch), 0.05) << seed;
  }
}

TEST(Online, UnevenStampsAreToldAndNoNumber) {
  const Recording even = simulated(MotionKind::free, onlineTool(), 14, 8.0, 1.0, 250.0);
  struct Stamps {
    const char* name;
    std::function<double(Eigen::Index, double)> of;
  };
  std::mt19937 random(3);
  std::normal_distribution<double> normal(0.0, 3e-3);
  for (const Stamps& stamps :
       {Stamps{"jitter", [&](Eigen::Index, double t) { return t + normal(random); }},
        Stamps{"wandering",
               [](Eigen::Index, double t) { return t + 0.01 * std::sin(2.0 * std::numbers::pi * 3.0 * t); }},
        Stamps{"bursts of 5", [](Eigen::Index k, double) { return 0.02 * static_cast<double>(k / 5); }},
        Stamps{"bursts of 20", [](Eigen::Index k, double) { return 0.08 * static_cast<double>(k / 20); }}}) {
    OnlineEstimator online = estimatorFor(even);
    double last = -1.0;
    for (Eigen::Index k = 0; k < even.rows(); ++k) {
      OnlineSample sample = sampleOf(even, k);
      sample.time = last = std::max(stamps.of(k, sample.time), last + 1e-6);
      online.add(sample);
      // Before there are enough stamps to tell, there is no number either.
      if (k % 50 == 0) {
        EXPECT_FALSE(online.state().estimated) << stamps.name << " " << sample.time;
      }
    }
    EXPECT_THAT(online.state().findings, testing::Contains(testing::Field(&Finding::code, "stamps_jitter")))
        << stamps.name;
  }
  // Lost and late ones now and then do no harm.
  OnlineEstimator online = estimatorFor(even);
  for (Eigen::Index k = 0; k < even.rows(); ++k) {
    OnlineSample sample = sampleOf(even, k);
    if (k % 40 == 7) sample.time += 0.002;
    if (k % 30 != 4) online.add(sample);
  }
  const OnlineState& state = online.state();
  EXPECT_TRUE(state.estimated);
  EXPECT_NEAR(state.payload.mass, onlineTool().mass, 4.0 * state.std.mass);
  EXPECT_THAT(state.findings, testing::Not(testing::Contains(testing::Field(&Finding::code, "stamps_jitter"))));
}

/// Forces in other axes than are stated: the best tool misses them by far more than the sensor scatters.
TEST(Online, NoNumberBeforeTheFitsScatterAgreesWithTheSensors) {
  const Recording right = simulated(MotionKind::free, onlineTool(), 15, 8.0, 1.0, 250.0);
  for (const auto& [first, second] : {std::pair{0, 2}, {1, 2}}) {
    Recording wrong = right;
    for (const int kind : {0, 3}) wrong.wrench.col(kind + first).swap(wrong.wrench.col(kind + second));
    OnlineEstimator online = estimatorFor(wrong);
    for (Eigen::Index k = 0; k < wrong.rows(); ++k) {
      online.add(sampleOf(wrong, k));
      // Before the arm has turned enough, other axes miss less than the share that is let pass.
      if (k % 50 == 0 && wrong.time(k) > 3.0) {
        EXPECT_FALSE(online.state().estimated) << first << second << " " << wrong.time(k);
      }
    }
    EXPECT_THAT(online.state().findings, testing::Contains(testing::Field(&Finding::code, "no_agreement")))
        << first << second;
  }
  OnlineEstimator online = estimatorFor(right);
  feed(online, right);
  EXPECT_TRUE(online.state().estimated);
  EXPECT_THAT(online.state().findings, testing::Not(testing::Contains(testing::Field(&Finding::code, "no_agreement"))));
}

TEST(Online, InBetweenItIsNearlyTheBatchOfWhatCame) {
  const Recording recording = simulated(MotionKind::free, onlineTool(), 7, 10.0);
  OnlineEstimator online = estimatorFor(recording, at25Hz());
  Eigen::Index fed = 0;
  double before = INFINITY;
  for (const double t : {4.3, 9.7}) {
    const auto to = static_cast<Eigen::Index>(1000 * t);
    feed(online, recording, fed, to);
    fed = to;
    const OnlineState& state = online.state();
    ASSERT_TRUE(state.estimated);
    // What came up to the smoothing's delay.
    Recording part = recording;
    const Eigen::Index rows = to - 500;
    part.time = recording.time.head(rows);
    part.q = recording.q.topRows(rows);
    part.dq = recording.dq.topRows(rows);
    part.wrench = recording.wrench.topRows(rows);
    const auto batch = estimate(part, &RobotModel::panda(), batchOptions(25.0));
    EXPECT_LT(difference(state, *batch), 1.0) << t;
    EXPECT_LT(stdDifference(state, *batch), 0.35) << t;
    EXPECT_LT(state.std.mass, before);
    before = state.std.mass;
    EXPECT_EQ(state.touch, Touch::free);
  }
}

TEST(Online, ShapeCountsAsInTheBatch) {
  std::mt19937 random(3);
  const test::RandomTool tool = test::randomTool(random);
  const Recording recording = simulated(MotionKind::free, tool.payload, 8, 10.0, 0.3);
  OnlineEstimator online = estimatorFor(recording, at25Hz(tool.shape));
  feed(online, recording);
  online.finish();
  EstimateOptions options = batchOptions(25.0);
  options.shape = tool.shape;
  const auto batch = estimate(recording, &RobotModel::panda(), options);
  EXPECT_LT(difference(online.state(), *batch), 0.1);
  EXPECT_LT(stdDifference(online.state(), *batch), 0.05);
  EXPECT_EQ(online.state().identifiability.inertia[2][2], batch->identifiability.inertia[2][2]);
}

TEST(Online, ContactIsNoticedAndLeftOut) {
  const Payload tool = onlineTool();
  Recording recording = simulated(MotionKind::free, tool, 9, 14.0);
  // A push of 4 N, half a second, outside the motion's model.
  for (Eigen::Index k = 9000; k < 9600; ++k) recording.wrench(k, 1) += 4.0;
  OnlineEstimator online = estimatorFor(recording);
  feed(online, recording, 0, 9000);
  EXPECT_EQ(online.state().touch, Touch::free);
  feed(online, recording, 9000, 9350);
  EXPECT_EQ(online.state().touch, Touch::contact);
  feed(online, recording, 9350);
  EXPECT_EQ(online.state().touch, Touch::free);
  EXPECT_NEAR(online.state().payload.mass, tool.mass, 4.0 * online.state().std.mass);
  EXPECT_LT(std::abs(online.state().payload.mass - tool.mass), 0.005);
  EXPECT_GT(online.state().contactDuration, 0.5);
  EXPECT_LT(online.state().contactDuration, 1.2);
}

TEST(Online, LongDataStayBoundedAndKeepWhatWasSaid) {
  const Payload tool = onlineTool();
  const Recording recording = simulated(MotionKind::free, tool, 10, 60.0, 1.0, 100.0);
  OnlineEstimator online = estimatorFor(recording);
  feed(online, recording);
  online.finish();
  const OnlineState& state = online.state();
  EXPECT_NEAR(state.usedDuration, 60.0, 2.0);
  const auto batch = estimate(recording, &RobotModel::panda(), batchOptions(0.0));
  EXPECT_LT(difference(state, *batch), 0.5);
  EXPECT_LT(stdDifference(state, *batch), 0.2);
}

TEST(Online, LightsTellWhatTheMotionTells) {
  // No motion at all: mass and centre cannot be told from the bias.
  Recording still = simulated(MotionKind::excitation, onlineTool(), 11, 5.0);
  const Eigen::RowVectorXd q = still.q.row(0), wrench = still.wrench.row(0);
  for (Eigen::Index k = 0; k < still.rows(); ++k) {
    still.q.row(k) = q;
    still.dq.row(k).setZero();
    for (int c = 0; c < 6; ++c)
      still.wrench(k, c) = wrench(c) + (c < 3 ? 0.05 : 0.002) * std::sin(37.0 * static_cast<double>(k * k % 1009 + c));
  }
  OnlineEstimator a = estimatorFor(still);
  EXPECT_EQ(a.state().mass.light, ExcitationLight::none);
  EXPECT_FALSE(a.state().estimated);
  feed(a, still);
  EXPECT_TRUE(a.state().estimated);
  EXPECT_EQ(a.state().mass.light, ExcitationLight::none);
  EXPECT_EQ(a.state().com.light, ExcitationLight::none);
  EXPECT_EQ(a.state().inertia.light, ExcitationLight::none);
  const Recording brisk = simulated(MotionKind::excitation, onlineTool(), 11, 10.0);
  OnlineEstimator b = estimatorFor(brisk);
  feed(b, brisk);
  EXPECT_EQ(b.state().mass.light, ExcitationLight::good);
  EXPECT_EQ(b.state().com.light, ExcitationLight::good);
  EXPECT_NE(b.state().inertia.light, ExcitationLight::none);
  EXPECT_THAT(b.state().mass.words, testing::HasSubstr("measured"));
}

TEST(Online, PosesAreAsGoodAsJoints) {
  const Payload tool = onlineTool();
  Recording recording = simulated(MotionKind::excitation, tool, 12, 10.0);
  const auto link = *RobotModel::panda().findLink(recording.meta.mount.parent);
  const Isometry3d X_LS = poseFromXyzRpy(recording.meta.mount.xyz, recording.meta.mount.rpy);
  OnlineEstimator online = estimatorFor(recording);
  for (Eigen::Index k = 0; k < recording.rows(); ++k) {
    OnlineSample sample = sampleOf(recording, k);
    const Isometry3d X = RobotModel::panda().linkPose(recording.q.row(k).transpose(), link) * X_LS;
    // The sign of a quaternion means nothing.
    Quaterniond q(X.linear());
    if (k % 3 == 0) q.coeffs() *= -1.0;
    sample.pose = OnlineSample::Pose{X.translation(), q};
    online.add(sample);
  }
  EXPECT_EQ(online.state().dropped, 0u);
  EXPECT_NEAR(online.state().payload.mass, tool.mass, 0.01);
}

TEST(Online, BadSamplesAreCountedAndLeftOut) {
  const Payload tool = onlineTool();
  const Recording recording = simulated(MotionKind::excitation, tool, 13, 8.0);
  OnlineEstimator online = estimatorFor(recording);
  for (Eigen::Index k = 0; k < recording.rows(); ++k) {
    if (k > 4000 && k < 4400) continue;  // a gap
    OnlineSample sample = sampleOf(recording, k);
    if (k == 1000) sample.time = 0.5;
    if (k == 1100) sample.wrench(2) = NAN;
    if (k == 1200) sample.q.reset();
    if (k == 1300) (*sample.q)[3] = INFINITY;
    if (k == 1400) sample.time = NAN;
    online.add(sample);
  }
  online.finish();
  const OnlineState& state = online.state();
  EXPECT_EQ(state.dropped, 5u);
  EXPECT_TRUE(
      std::any_of(state.findings.begin(), state.findings.end(), [](const Finding& f) { return f.code == "gaps"; }));
  EXPECT_NEAR(state.payload.mass, tool.mass, 0.01);
  online.restart();
  EXPECT_EQ(online.state().samples, 0u);
  EXPECT_FALSE(online.state().estimated);
}

TEST(Online, SaysWhyItCannotStart) {
  RecordingMeta meta;
  meta.mount.parent = "no_such_link";
  const auto created = OnlineEstimator::create(meta, &RobotModel::panda());
  ASSERT_FALSE(created.ok());
  EXPECT_THAT(created.error().message, testing::HasSubstr("no_such_link"));
  // Joints without a robot: every sample is dropped, nothing crashes.
  auto blind = OnlineEstimator::create(RecordingMeta(), nullptr);
  ASSERT_TRUE(blind.ok());
  const Recording recording = simulated(MotionKind::free, onlineTool(), 1, 1.0);
  feed(*blind, recording);
  EXPECT_EQ(blind->state().dropped, static_cast<std::uint64_t>(recording.rows()));
}

}  // namespace
}  // namespace heft
