#include "core/recording/unwrap.h"

#include <cmath>
#include <numbers>

#include "tests/core/recording/sample.h"

namespace heft {
namespace {

using namespace testing_support;
using ::testing::HasSubstr;

constexpr double kTurn = 2.0 * std::numbers::pi;

/// Into [low, low + turn).
double keptWithin(double angle, double low, double turn) { return angle - turn * std::floor((angle - low) / turn); }

/// Joint 3 makes some turns and comes back, joint 5 swings across pi; the others stay within.
double turning(int joint, double t) {
  if (joint == 2) return 7.0 * std::sin(0.4 * t);
  if (joint == 4) return 3.0 + 0.5 * std::sin(2.0 * t);
  return 0.8 * std::sin(1.3 * t + joint);
}

TEST(Unwrap, TurnsAreTakenOutAtEveryRate) {
  for (const double rate : {10.0, 30.0, 100.0, 1000.0}) {
    for (const double low : {-std::numbers::pi, 0.0}) {
      const auto rows = static_cast<Eigen::Index>(20.0 * rate);
      VectorXd time(rows);
      MatrixXd q(rows, 7);
      MatrixXd expected(rows, 7);
      for (Eigen::Index k = 0; k < rows; ++k) {
        time(k) = static_cast<double>(k) / rate;
        for (int j = 0; j < 7; ++j) {
          expected(k, j) = turning(j, time(k));
          q(k, j) = keptWithin(expected(k, j), low, kTurn);
        }
      }
      const auto joints = unwrapJoints(time, q);
      EXPECT_THAT(joints, testing::IsSupersetOf({2}));
      for (const int j : joints) EXPECT_LT((q.col(j) - expected.col(j)).cwiseAbs().maxCoeff(), 1e-12) << j;
    }
  }
}

TEST(Unwrap, WhatIsNoWholeTurnStaysAJump) {
  VectorXd time = VectorXd::LinSpaced(100, 0.0, 0.99);
  for (const double jump : {0.8, 2.0, 3.3, 5.5, 7.2}) {
    MatrixXd q = MatrixXd::Zero(100, 1);
    q.bottomRows(50).setConstant(jump);
    EXPECT_TRUE(unwrapJoints(time, q).empty()) << jump;
    EXPECT_EQ(q(99, 0), jump);
  }
  // A glitch of one whole turn in one sample is none.
  MatrixXd q = MatrixXd::Constant(100, 1, 0.5);
  q(40, 0) += kTurn;
  EXPECT_EQ(unwrapJoints(time, q), std::vector<int>{0});
  EXPECT_LT((q.array() - 0.5).abs().maxCoeff(), 1e-12);
}

TEST(Unwrap, AcrossAGapAnArmMayReallyHaveMoved) {
  Unwrapper angle;
  EXPECT_EQ(angle.next(-2.4, 0.0), -2.4);
  EXPECT_EQ(angle.next(2.3, 5.0), 2.3);
  EXPECT_FALSE(angle.jumped());
  EXPECT_TRUE(std::isnan(angle.next(std::nan(""), 0.01)));
  EXPECT_NEAR(angle.next(2.3 - kTurn, 0.01), 2.3, 1e-12);
}

TEST(Unwrap, ReadersSayIt) {
  auto table = goodTable(Form::joints, 400);
  const auto plain = parse(table.text());
  for (std::size_t r = 80; r < 200; ++r) table.cell(r, "q7") = fmt::format("{}", table.number(r, "q7") - kTurn);
  RecordingMeta meta;
  meta.robot = "/arm.urdf";
  const auto read = parse(table.text(), meta);
  ASSERT_TRUE(read) << read.error().message;
  const auto* finding = findCode(read->findings, "angles_unwrapped");
  ASSERT_NE(finding, nullptr);
  EXPECT_EQ(finding->severity, Severity::info);
  EXPECT_THAT(finding->text, HasSubstr("removed from q7."));
  EXPECT_EQ(findCode(read->findings, "motion_jump"), nullptr);
  EXPECT_LT((read->recording.q - plain->recording.q).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Unwrap, DegreesFrom0To360) {
  auto table = goodTable(Form::joints, 400);
  const auto plain = parse(table.text());
  for (int j = 1; j <= 7; ++j)
    for (std::size_t r = 0; r < 400; ++r) {
      auto& cell = table.cell(r, fmt::format("q{}", j));
      cell = fmt::format("{}", keptWithin(std::stod(cell) * 360.0 / kTurn, 0.0, 360.0));
    }
  RecordingMeta meta = pandaMeta();
  meta.conventions.radPerAngle = std::numbers::pi / 180.0;
  const auto read = parse(table.text(), meta);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_THAT(findCode(read->findings, "angles_unwrapped")->text, HasSubstr("q1, q2, q3, q4, q5, q6 and q7"));
  EXPECT_LT((read->recording.q - plain->recording.q).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Unwrap, ManyTurnsAreNoDegrees) {
  // Within one turn in the file, so plainly radians, however often the joint goes round.
  auto table = goodTable(Form::joints, 3000);
  for (std::size_t r = 0; r < 3000; ++r)
    table.cell(r, "q7") = fmt::format("{}", keptWithin(0.02 * static_cast<double>(r), -kTurn / 2, kTurn));
  RecordingMeta meta;
  meta.robot = "/arm.urdf";
  const auto read = parse(table.text(), meta);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_NEAR(read->recording.q(2999, 6) - read->recording.q(0, 6), 0.02 * 2999, 1e-9);
}

}  // namespace
}  // namespace heft
