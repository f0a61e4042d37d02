// Short contact, payload changes, rest, sensor trouble, and a first estimate at hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <numbers>

#include "core/segmentation/segmentation.h"
#include "core/simulation/simulate.h"
#include "tests/support/random_tool.h"

namespace heft {
namespace {

struct LabelledEvents {
  Recording recording;
  Payload payload;
  WrenchRows rows() const { return rowsOf(*motionOf(recording, &RobotModel::panda(), {}), 50.0); }
};

LabelledEvents simulatedEvents(MotionKind kind, std::uint64_t seed) {
  std::mt19937 random(static_cast<unsigned>(seed));
  SimulateOptions options;
  options.motion = kind;
  options.seed = seed;
  options.rateHz = 500.0;
  const Payload payload = test::randomTool(random).payload;
  auto result = simulate(RobotModel::panda(), payload, options);
  return {std::move(result->recording), payload};
}

/// Adds the wrench of more payload from t on.
void pickUp(WrenchRows& rows, double t, const Payload& extra) {
  for (Eigen::Index k = 0; k < rows.size(); ++k)
    if (rows.time(k) > t) rows.wrench.col(k) += rows.Y[static_cast<std::size_t>(k)] * toParameters(extra);
}

/// Seconds labelled free before and after t.
std::pair<double, double> freeAround(const Segmentation& segmentation, const WrenchRows& rows, double t) {
  std::pair<double, double> seconds{0.0, 0.0};
  for (Eigen::Index k = 0; k < rows.size(); ++k)
    if (segmentation.labels[static_cast<std::size_t>(k)] == MarkLabel::free)
      (rows.time(k) < t ? seconds.first : seconds.second) += 1.0 / rows.rateHz;
  return seconds;
}

const Segment* firstOf(const Segmentation& segmentation, SegmentKind kind) {
  for (const auto& segment : segmentation.segments)
    if (segment.kind == kind) return &segment;
  return nullptr;
}

TEST(SegmentEvents, ContactOfThreeTenthsOfASecondAndOneNewtonIsFound) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    LabelledEvents data = simulatedEvents(seed % 2 == 0 ? MotionKind::free : MotionKind::excitation, 700 + seed);
    const std::array starts{3.1, 7.3, 11.2, 15.7};
    const Vector3d force = Vector3d(0.3 * static_cast<double>(seed), -0.5, 0.6).normalized();
    Vector6d push;
    push << force, Vector3d(0.02, 0.01, 0.12).cross(force);
    for (Eigen::Index i = 0; i < data.recording.rows(); ++i)
      for (const double start : starts)
        if (const double u = (data.recording.time(i) - start) / 0.3; u > 0.0 && u < 1.0)
          data.recording.wrench.row(i) += std::sin(std::numbers::pi * u) * push.transpose();
    const WrenchRows rows = data.rows();
    const auto labels = segmentRows(data.recording, rows, SegmentMode::automatic).labels;
    double outside = 0.0;
    for (Eigen::Index k = 0; k < rows.size(); ++k) {
      double distance = 1e9;
      for (const double start : starts) distance = std::min(distance, std::abs(rows.time(k) - start - 0.15));
      const bool contact = labels[static_cast<std::size_t>(k)] == MarkLabel::contact;
      if (distance < 0.05) {
        EXPECT_TRUE(contact) << "seed " << seed << " at " << rows.time(k);
      }
      if (distance > 0.3 && contact) outside += 1.0 / rows.rateHz;
    }
    EXPECT_EQ(outside, 0.0);
  }
}

TEST(SegmentEvents, TwoPayloadsAreNotMixed) {
  for (const double mass : {0.1, 0.3, 0.8}) {
    const LabelledEvents data = simulatedEvents(MotionKind::free, 21);
    WrenchRows rows = data.rows();
    pickUp(rows, 8.0, {mass, {0.01, 0.02, 0.15}, 1e-3 * mass * Matrix3d::Identity()});
    const auto found = segmentRows(data.recording, rows, SegmentMode::automatic);
    const auto [before, after] = freeAround(found, rows, 8.0);
    EXPECT_EQ(std::min(before, after), 0.0) << mass;
    EXPECT_GT(std::max(before, after), 9.0) << mass;
    ASSERT_NE(firstOf(found, SegmentKind::otherPayload), nullptr) << mass;
    const Segment* change = firstOf(found, SegmentKind::pickUp);
    ASSERT_NE(change, nullptr) << mass;
    EXPECT_LT(change->from, 8.0);
    EXPECT_GT(change->to, 8.0);
    EXPECT_LT(change->to - change->from, 1.0);
    ASSERT_EQ(found.findings.size(), 1u);
    EXPECT_EQ(found.findings[0].code, "payload_change");
    EXPECT_THAT(found.findings[0].text, testing::HasSubstr("is used"));
  }
}

TEST(SegmentEvents, PickedUpAndPutDownAgain) {
  const LabelledEvents data = simulatedEvents(MotionKind::free, 22);
  WrenchRows rows = data.rows();
  pickUp(rows, 6.0, {0.3, {0, 0, 0.15}, 1e-4 * Matrix3d::Identity()});
  pickUp(rows, 11.0, {-0.3, {0, 0, 0.15}, -1e-4 * Matrix3d::Identity()});
  const auto found = segmentRows(data.recording, rows, SegmentMode::automatic);
  EXPECT_NE(firstOf(found, SegmentKind::pickUp), nullptr);
  EXPECT_NE(firstOf(found, SegmentKind::putDown), nullptr);
  for (Eigen::Index k = 0; k < rows.size(); ++k) {
    const double t = rows.time(k);
    if (std::abs(t - 6.0) < 0.4 || std::abs(t - 11.0) < 0.4) continue;
    EXPECT_EQ(found.labels[static_cast<std::size_t>(k)] == MarkLabel::free, t < 6.0 || t > 11.0) << t;
  }
}

TEST(SegmentEvents, AFirstEstimateSaysWhichPayloadIsMeant) {
  const LabelledEvents data = simulatedEvents(MotionKind::free, 23);
  WrenchRows rows = data.rows();
  const Payload extra{0.3, {0, 0, 0.15}, 1e-4 * Matrix3d::Identity()};
  pickUp(rows, 7.0, extra);
  const auto alone = segmentRows(data.recording, rows, SegmentMode::automatic, PayloadGuess{data.payload, {}});
  EXPECT_GT(freeAround(alone, rows, 7.0).first, 6.0);
  EXPECT_EQ(freeAround(alone, rows, 7.0).second, 0.0);
  const auto both =
      segmentRows(data.recording, rows, SegmentMode::automatic, PayloadGuess{composed(data.payload, extra), {}});
  EXPECT_EQ(freeAround(both, rows, 7.0).first, 0.0);
  EXPECT_GT(freeAround(both, rows, 7.0).second, 12.0);
}

TEST(SegmentEvents, RestIsStandingStill) {
  LabelledEvents data = simulatedEvents(MotionKind::free, 25);
  Recording& r = data.recording;
  // The arm is held for 2 s and goes on from there: rows repeat their posture and the wrench only their noise. A
  // posture without any noise, from which it leaps, would be a robot that sent nothing new.
  const auto held = static_cast<Eigen::Index>(9.0 * 500.0), later = held + 1000;
  const Eigen::Index after = r.rows() - later;
  r.q.bottomRows(after) = r.q.middleRows(held, after).eval();
  r.dq.bottomRows(after) = r.dq.middleRows(held, after).eval();
  r.wrench.bottomRows(after) = r.wrench.middleRows(held, after).eval();
  for (Eigen::Index i = held; i < later; ++i) {
    r.q.row(i) = r.q.row(held).array() + (i % 2 == 0 ? 1e-6 : -1e-6);
    r.dq.row(i).setZero();
    r.wrench.row(i) = r.wrench.row(held - 1 - (i - held) % 5);
  }
  const WrenchRows rows = data.rows();
  const auto found = segmentRows(r, rows, SegmentMode::automatic);
  double standing = 0.0;
  for (const auto& s : found.segments)
    if (s.kind == SegmentKind::standing || s.label == MarkLabel::contact)
      standing += std::max(0.0, std::min(s.to, 10.8) - std::max(s.from, 9.2));
  EXPECT_GT(standing, 1.4) << "at rest, or contact where the wrench belongs to a motion that was cut out";
}

TEST(SegmentEvents, SensorTroubleIsLeftOut) {
  LabelledEvents data = simulatedEvents(MotionKind::free, 26);
  Recording& r = data.recording;
  for (Eigen::Index i = 1; i < r.rows(); ++i)
    if (r.time(i) > 5.0 && r.time(i) < 5.4) r.wrench.row(i) = r.wrench.row(i - 1);
  const double top = r.wrench.col(0).maxCoeff() + 1.0;
  for (Eigen::Index i = 0; i < r.rows(); ++i)
    if (r.time(i) > 12.0 && r.time(i) < 12.3) r.wrench(i, 0) = top;
  const WrenchRows rows = data.rows();
  const auto found = segmentRows(r, rows, SegmentMode::automatic);
  int troubles = 0;
  for (const auto& s : found.segments) {
    if (s.kind != SegmentKind::sensorTrouble) continue;
    ++troubles;
    EXPECT_EQ(s.label, MarkLabel::ignore);
    EXPECT_TRUE((std::abs(s.from - 5.0) < 0.05 && std::abs(s.to - 5.4) < 0.05) ||
                (std::abs(s.from - 12.0) < 0.05 && std::abs(s.to - 12.3) < 0.05))
        << s.from << " to " << s.to << " " << s.reason;
  }
  EXPECT_EQ(troubles, 2);
  const LabelledEvents clean = simulatedEvents(MotionKind::free, 26);
  EXPECT_EQ(firstOf(segmentRows(clean.recording, clean.rows(), SegmentMode::automatic), SegmentKind::sensorTrouble),
            nullptr);
}

TEST(SegmentEvents, ConfidenceIsHigherWhereTheLabelIsRight) {
  double right = 0.0, wrong = 0.0, rights = 0.0, wrongs = 0.0;
  for (std::uint64_t seed = 31; seed <= 36; ++seed) {
    std::mt19937 random(static_cast<unsigned>(seed));
    SimulateOptions options;
    options.motion = MotionKind::pickAndPlace;
    options.seed = seed;
    const auto simulation = simulate(RobotModel::panda(), test::randomTool(random).payload, options);
    const WrenchRows rows = rowsOf(*motionOf(simulation->recording, &RobotModel::panda(), {}), 50.0);
    const auto found = segmentRows(simulation->recording, rows, SegmentMode::automatic);
    for (const auto& segment : found.segments) {
      EXPECT_GE(segment.confidence, 0.0);
      EXPECT_LE(segment.confidence, 1.0);
      for (double t = segment.from; t < segment.to; t += 0.02) {
        bool contact = false;
        for (const auto& mark : simulation->truth.marks)
          contact = contact || (mark.label == MarkLabel::contact && t >= mark.from && t <= mark.to);
        const bool isRight = contact == (segment.label == MarkLabel::contact);
        (isRight ? right : wrong) += segment.confidence;
        (isRight ? rights : wrongs) += 1.0;
      }
    }
  }
  EXPECT_GT(right / rights, 0.85);
  EXPECT_GT(rights / (rights + wrongs), 0.97);
}

TEST(SegmentEvents, MarksOfTheUserAreCertain) {
  LabelledEvents data = simulatedEvents(MotionKind::free, 27);
  data.recording.meta.marks = {{4.0, 6.0, MarkLabel::contact}};
  const auto found = segmentRows(data.recording, data.rows(), SegmentMode::automatic);
  const Segment* marked = firstOf(found, SegmentKind::contact);
  ASSERT_NE(marked, nullptr);
  EXPECT_NEAR(marked->from, 4.0, 0.03);
  EXPECT_NEAR(marked->to, 6.0, 0.03);
  EXPECT_EQ(marked->confidence, 1.0);
  EXPECT_EQ(marked->reason, "Marked by you.");
  const auto list = toJson(found.segments);
  for (const char* key : {"from_s", "to_s", "label", "kind", "reason", "confidence"})
    EXPECT_TRUE(list[0].contains(key)) << key;
}

}  // namespace
}  // namespace heft
