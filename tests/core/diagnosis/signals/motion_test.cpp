// Motions: joints that are turned further, and corners that no smoothing follows.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/diagnosis/signals/joint_turns.h"
#include "core/simulation/random.h"
#include "tests/core/diagnosis/fixture.h"

namespace heft::test {
namespace {

using namespace diagnosis;

TEST(JointTurns, AreWhatTheArmDoesWithOtherAngles) {
  const Recording recording = aRecording(MotionKind::excitation, 281);
  const auto motion = motionOf(recording, &RobotModel::panda(), {}).value();
  const Signals signals = signalsOf(recording, motion, &RobotModel::panda());
  for (int joint = 0; joint < 7; ++joint)
    for (const JointTurn& turn :
         {JointTurn{joint, 0.1}, JointTurn{joint, 0.0, 0.05, -0.03}, JointTurn{joint, -0.02, 0.0, 0.04}}) {
      ASSERT_TRUE(signals.joints->turnsAlone(joint));
      MatrixXd q = signals.q(), dq = signals.dq(), ddq = signals.ddq();
      for (Eigen::Index k = 0; k < signals.size(); ++k) {
        const double s = std::sin(q(joint, k)), c = std::cos(q(joint, k)), off = turn.sine * s + turn.cosine * c,
                     slope = turn.sine * c - turn.cosine * s;
        ddq(joint, k) += slope * ddq(joint, k) - off * dq(joint, k) * dq(joint, k);
        dq(joint, k) += slope * dq(joint, k);
        q(joint, k) += turn.constant + off;
      }
      const Kinematics expected = kinematicsOf(signals, q, dq, ddq);
      const auto found = signals.joints->with(turn, signals.gravity);
      EXPECT_LT((found->specificForce - expected.specificForce).cwiseAbs().maxCoeff(), 1e-9) << joint;
      EXPECT_LT((found->omega - expected.omega).cwiseAbs().maxCoeff(), 1e-9) << joint;
      EXPECT_LT((found->alpha - expected.alpha).cwiseAbs().maxCoeff(), 1e-9) << joint;
      for (std::size_t k = 0; k < expected.turned->size(); k += 100)
        EXPECT_TRUE((*found->turned)[k].isApprox((*expected.turned)[k], 1e-9)) << joint;
      EXPECT_EQ(found, signals.joints->with(turn, signals.gravity)) << "kept";
    }
}

/// Noise that is three times as loud where the motion may be wrong: how much is learned at a price, and made even.
TEST(Noise, IsLouderWhereTheMotionIsLessWellKnown) {
  constexpr Eigen::Index kBlocks = 1000;
  Wrenches loud = Wrenches::Zero(6, kBlocks), plain(6, kBlocks);
  RandomStream random(7, RandomPurpose::effect);
  for (Eigen::Index n = 0; n < kBlocks; ++n)
    for (Eigen::Index c = 0; c < 6; ++c) {
      if (n % 100 < 10) loud(c, n) = 32.0;
      plain(c, n) = 0.02 * random.normal();
    }
  const auto noiseScale = std::make_shared<const NoiseScale>(loud);
  const std::vector<Stretch> stretches{{0, kBlocks}};
  EXPECT_EQ(fitNoise(plain, stretches, noiseScale).level, nullptr);
  const Wrenches uneven = plain.cwiseProduct((1.0 + 0.25 * loud.array()).sqrt().matrix());
  const Noise noise = fitNoise(uneven, stretches, noiseScale);
  ASSERT_NE(noise.level, nullptr);
  EXPECT_EQ(noise.level->share, 0.25);
  EXPECT_GT(noise.evidence, fitNoise(uneven, stretches, nullptr).evidence + 500.0);
  EXPECT_LT((evenWrench(uneven, noise) - plain).cwiseAbs().maxCoeff(), 1e-12);
  const MatrixXd e = whitened(flat(uneven), noise, stretches);
  EXPECT_NEAR(e.squaredNorm() / static_cast<double>(e.size()), 1.0, 0.02);
  EXPECT_LT(e.cwiseAbs().maxCoeff(), 5.0);
}

/// Columns that act for a while only: their innovations there are all of them, across the edges of stretches, too.
TEST(Noise, IsTheSameOfAShortEventAlone) {
  constexpr Eigen::Index kBlocks = 300;
  Wrenches loud = Wrenches::Zero(6, kBlocks), residual(6, kBlocks);
  RandomStream random(8, RandomPurpose::effect);
  Vector6d last = Vector6d::Zero();
  for (Eigen::Index n = 0; n < kBlocks; ++n)
    for (Eigen::Index c = 0; c < 6; ++c) {
      if (n % 50 < 10) loud(c, n) = 64.0;
      last(c) = 0.6 * last(c) + std::sqrt(1.0 + 0.25 * loud(c, n)) * random.normal();
      residual(c, n) = last(c);
    }
  const std::vector<Stretch> stretches{{0, 90}, {100, 180}, {195, kBlocks}};
  const Noise noise = fitNoise(residual, stretches, std::make_shared<const NoiseScale>(loud));
  ASSERT_NE(noise.level, nullptr);
  for (const Stretch acts : {Stretch{2, 12}, Stretch{85, 110}, Stretch{182, 190}, Stretch{120, kBlocks}, Stretch{}}) {
    MatrixXd columns = MatrixXd::Zero(6 * kBlocks, 2);
    for (Eigen::Index i = 6 * acts.from; i < 6 * acts.to; ++i)
      for (Eigen::Index j = 0; j < 2; ++j) columns(i, j) = random.normal();
    const Stretch reach = reachOf(acts, kBlocks);
    const MatrixXd whole = whitened(columns, noise, stretches);
    const MatrixXd rows = columns.middleRows(6 * reach.from, 6 * (reach.to - reach.from));
    const MatrixXd alone = whitened(rows, noise, stretches, reach.from);
    MatrixXd put = MatrixXd::Zero(6 * kBlocks, 2);
    put.middleRows(6 * reach.from, alone.rows()) = alone;
    EXPECT_LT((put - whole).cwiseAbs().maxCoeff(), 1e-12) << acts.from;
  }
}

/// A robot that goes from place to place along quintics, whose third derivative jumps at either end, with a heavy tool
/// and a quiet sensor. What no smoothing of 100 readings a second follows there was a loop of the sensor, 0.06 % of its
/// load, and a delay of nothing.
TEST(Diagnose, CornersOfTheMotionAreNoCause) {
  const RobotModel& robot = RobotModel::panda();
  Payload tool = aTool();
  tool.mass = 2.2;
  tool.com = {-0.02, 0.0, 0.13};
  tool.inertiaCom = Vector3d(3.5e-3, 3.8e-3, 4.8e-3).asDiagonal();
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    RandomStream random(seed, RandomPurpose::effect);
    constexpr double kMove = 0.75, kRest = 0.5;
    VectorXd from = robot.homePosture(), to = from;
    double starts = -kMove - kRest;
    const auto path = [&](double t) {
      if (t >= starts + kMove + kRest) {
        starts += kMove + kRest;
        from = to;
        for (Eigen::Index j = 0; j < 7; ++j) to(j) = robot.homePosture()(j) + random.uniform(-0.4, 0.4);
      }
      const double u = std::clamp((t - starts) / kMove, 0.0, 1.0);
      const VectorXd way = to - from;
      return JointMotion{from + u * u * u * (10.0 + u * (6.0 * u - 15.0)) * way,
                         30.0 * u * u * (1.0 - u) * (1.0 - u) / kMove * way,
                         60.0 * u * (1.0 - u) * (1.0 - 2.0 * u) / (kMove * kMove) * way};
    };
    const auto report = diagnosed(along(path, tool, {100.0, 1e-5, 3e-4, 0.03, 0.001}, random));
    EXPECT_EQ(report.verdict, Verdict::clean) << seed << ": " << said(report);
  }
}

struct Swing {
  double size, rate, phase;  ///< [rad], [rad/s], [rad]
};

/// Seven joints that swing about the home posture, each in six slow ways, as where a hand guides.
std::vector<std::vector<Swing>> guided(RandomStream& random) {
  std::vector<std::vector<Swing>> joints(7);
  for (auto& swings : joints)
    for (int i = 0; i < 6; ++i)
      swings.push_back({random.uniform(0.03, 0.15), random.uniform(0.5, 6.0), random.uniform(0.0, 6.0)});
  return joints;
}

JointMotion swinging(const std::vector<std::vector<Swing>>& joints, double t) {
  JointMotion out{RobotModel::panda().homePosture(), VectorXd::Zero(7), VectorXd::Zero(7)};
  for (Eigen::Index j = 0; j < 7; ++j)
    for (const auto& [size, rate, phase] : joints[static_cast<std::size_t>(j)]) {
      out.q(j) += size * std::sin(rate * t + phase);
      out.dq(j) += size * rate * std::cos(rate * t + phase);
      out.ddq(j) -= size * rate * rate * std::sin(rate * t + phase);
    }
  return out;
}

/// Of a hand that trembles from 18 to 34 Hz, too.
auto aFastTremble(RandomStream& random) {
  auto joints = guided(random);
  for (auto& swings : joints)
    for (int i = 0; i < 40; ++i) swings.push_back({2e-6, random.uniform(110.0, 215.0), random.uniform(0.0, 6.0)});
  return [joints](double t) { return swinging(joints, t); };
}

/// Clocks that differ make all accelerations too large by one share; our own smoothing makes them too small. Where a
/// quiet sensor shows 0.3 %, it is named; a tenth of a per cent is not, but "nothing is left but noise" is not all that
/// can be said.
TEST(Diagnose, WhatOurOwnSmoothingMayLeaveIsTold) {
  Payload tool = aTool();
  tool.mass = 2.2;
  const auto with = [&](double loss) {
    RandomStream random(3, RandomPurpose::effect);
    const auto joints = guided(random);
    const auto path = [&](double t) {
      JointMotion at = swinging(joints, t);
      at.dq *= std::sqrt(1.0 - loss);
      at.ddq *= 1.0 - loss;
      return at;
    };
    return diagnosed(along(path, tool, {1000.0, 1e-7, 0.0, 0.005, 0.0002}, random));
  };
  for (const double loss : {0.0, 0.0008}) {
    const auto report = with(loss);
    EXPECT_EQ(report.verdict, Verdict::clean) << loss << ": " << said(report);
    EXPECT_EQ(finds(report, "too_small_to_name"), loss > 0.0) << loss << ": " << said(report);
    EXPECT_FALSE(finds(report, "motion_smoothed")) << loss << ": " << said(report);
  }
  const auto report = with(0.003);
  ASSERT_EQ(report.causes.size(), 1u) << said(report);
  EXPECT_EQ(report.causes.front().id, "derivative_noise") << said(report);
  const CauseParameter* loss = findParameter(report.causes.front().parameters, "loss");
  ASSERT_NE(loss, nullptr) << said(report);
  EXPECT_NEAR(loss->value, 0.3, 3.0 * loss->std);
}

/// Angles that are fine show a tremble above the usual corner, and smoothed away it was accelerations that are off.
TEST(Diagnose, ATrembleFasterThanTheUsualCornerIsNoCause) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    RandomStream random(seed, RandomPurpose::effect);
    const auto path = aFastTremble(random);
    const auto report = diagnosed(along(path, aTool(), {1000.0, 1e-7, 0.0, 0.03, 0.001}, random));
    EXPECT_EQ(report.verdict, Verdict::clean) << seed << ": " << said(report);
  }
}

/// An arm that is knocked at four times while it is guided, for some hundredths of a second: what the smoothing of the
/// motion took there was noise that comes and goes, or a touch of the tool.
TEST(Diagnose, KnocksAtTheArmAreNoTouch) {
  for (const double wide : {0.008, 0.015}) {  // [s]
    RandomStream random(5, RandomPurpose::effect);
    const auto joints = guided(random);
    const auto path = [&](double t) {
      JointMotion at = swinging(joints, t);
      for (const double when : {4.1, 8.3, 12.35, 16.2})
        for (Eigen::Index j = 0; j < 7; ++j) {
          const double u = (t - when) / wide, fast = (j % 2 == 0 ? 6.0 : -9.0) * std::exp(-u * u);  // [rad/s^2]
          at.q(j) += 0.5 * wide * wide * fast;
          at.dq(j) -= wide * u * fast;
          at.ddq(j) += (2.0 * u * u - 1.0) * fast;
        }
      return at;
    };
    const auto report = diagnosed(along(path, aTool(), {500.0, 1e-6, 0.0, 0.05, 0.002}, random));
    EXPECT_EQ(report.verdict, Verdict::clean) << wide << ": " << said(report);
  }
}

/// It rings in so narrow a band that a search from afar does not come there: the spectrum of the readings tells where.
TEST(Diagnose, AMountThatRingsFarAboveTheHandIsFoundByItsPitch) {
  RandomStream random(4, RandomPurpose::effect);
  const auto path = aFastTremble(random);
  const auto report = diagnosed(along(path, aTool(), {1000.0, 1e-7, 0.0, 0.03, 0.001}, random, {36.0, 0.012}));
  const DiagnosedCause* mount = named(report, "flexible_mount");
  ASSERT_NE(mount, nullptr) << said(report);
  EXPECT_EQ(report.causes.front().id, "flexible_mount") << said(report);
  EXPECT_NEAR(findParameter(mount->parameters, "frequency")->value, 36.0, 1.0);
}

/// Orientation came as it was.
TEST(Diagnose, PositionsThatWereSmoothedAlone) {
  constexpr double kWidth = 0.03;  // [s]
  Recording recording = asPoses(aRecording(MotionKind::excitation, 363));
  recording.twist.resize(0, 6);
  const MatrixXd sharp = recording.position;
  const auto reach = static_cast<Eigen::Index>(4.0 * kWidth * recording.rateHz());
  for (Eigen::Index i = 0; i < recording.rows(); ++i) {
    Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
    double weights = 0.0;
    for (Eigen::Index k = std::max<Eigen::Index>(0, i - reach); k < std::min(recording.rows(), i + reach + 1); ++k) {
      const double weight = std::exp(-0.5 * std::pow((recording.time(k) - recording.time(i)) / kWidth, 2));
      sum += weight * sharp.row(k);
      weights += weight;
    }
    recording.position.row(i) = sum / weights;
  }
  const auto report = diagnosed(recording);
  ASSERT_FALSE(report.causes.empty()) << said(report);
  ASSERT_EQ(report.causes.front().id, "derivative_noise") << said(report);
  const CauseParameter* width = findParameter(report.causes.front().parameters, "position_smoothing");
  ASSERT_NE(width, nullptr) << said(report);
  EXPECT_NEAR(width->value, 30.0, 3.0 * width->std);
}

/// A hand that trembles, each joint at a frequency of its own, under angles as noisy as they may be. A low-pass with a
/// corner that keeps this noise away takes a tenth of the tremor: that was a shaking, or a mount that gives at 12 Hz.
TEST(Diagnose, ATrembleUnderNoisyAnglesIsNoCause) {
  Payload tool = aTool();
  tool.mass = 2.4;
  tool.com = {0.03, -0.06, 0.07};
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    RandomStream random(seed, RandomPurpose::effect);
    auto joints = guided(random);
    for (auto& swings : joints)
      swings.push_back({random.uniform(1.5e-4, 5e-4), random.uniform(50.0, 75.0), random.uniform(0.0, 6.0)});
    const auto path = [&](double t) { return swinging(joints, t); };
    const auto report = diagnosed(along(path, tool, {1000.0, 7e-5, 0.0, 0.06, 0.0012}, random));
    EXPECT_EQ(report.verdict, Verdict::clean) << seed << ": " << said(report);
    EXPECT_TRUE(finds(report, "motion_smoothed")) << seed << ": what is faster was not judged";
  }
}

}  // namespace
}  // namespace heft::test
