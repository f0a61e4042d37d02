#include "core/segmentation/segmentation.h"

#include <gtest/gtest.h>

#include "core/simulation/simulate.h"
#include "tests/support/random_tool.h"

namespace heft {
namespace {

struct Labelled {
  Simulated simulated;
  WrenchRows rows;
};

Labelled simulated(MotionKind kind, std::uint64_t seed) {
  std::mt19937 random(static_cast<unsigned>(seed));
  SimulateOptions options;
  options.motion = kind;
  options.seed = seed;
  auto result = simulate(RobotModel::panda(), test::randomTool(random).payload, options);
  const auto motion = motionOf(result->recording, &RobotModel::panda(), {});
  return {std::move(*result), rowsOf(*motion, 50.0)};
}

bool inContact(const std::vector<Mark>& marks, double t) {
  for (const auto& mark : marks)
    if (mark.label == MarkLabel::contact && t >= mark.from && t <= mark.to) return true;
  return false;
}

TEST(Segmentation, FindsTheContactsOfPickAndPlace) {
  double right = 0.0, total = 0.0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Labelled data = simulated(MotionKind::pickAndPlace, seed);
    const auto labels = segmentRows(data.simulated.recording, data.rows, SegmentMode::automatic).labels;
    for (Eigen::Index k = 0; k < data.rows.size(); ++k) {
      const bool truth = inContact(data.simulated.truth.marks, data.rows.time(k));
      right += (labels[static_cast<std::size_t>(k)] == MarkLabel::contact) == truth ? 1.0 : 0.0;
      total += 1.0;
    }
    // Every true contact is found somewhere in its middle.
    for (const auto& mark : data.simulated.truth.marks) {
      if (mark.label != MarkLabel::contact) continue;
      const auto k = static_cast<Eigen::Index>((0.5 * (mark.from + mark.to) - data.rows.startTime) * data.rows.rateHz);
      EXPECT_EQ(labels[static_cast<std::size_t>(k)], MarkLabel::contact)
          << "seed " << seed << " at " << data.rows.time(k);
    }
  }
  EXPECT_GT(right / total, 0.95);
}

TEST(Segmentation, FreeMotionIsFree) {
  for (const auto kind : {MotionKind::free, MotionKind::excitation})
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const Labelled data = simulated(kind, seed);
      const auto labels = segmentRows(data.simulated.recording, data.rows, SegmentMode::automatic).labels;
      EXPECT_LT(std::count(labels.begin(), labels.end(), MarkLabel::contact),
                0.005 * static_cast<double>(labels.size()));
    }
}

TEST(Segmentation, FindsContactThatFillsHalfOfTheRecording) {
  Labelled data = simulated(MotionKind::free, 5);
  for (Eigen::Index k = 0; k < data.rows.size(); ++k)
    if (const double t = data.rows.time(k); t > 5.0 && t < 14.0)
      data.rows.wrench.col(k) += (Vector6d() << 6, -3, 2, 0.2, 0.3, 0).finished();
  const auto labels = segmentRows(data.simulated.recording, data.rows, SegmentMode::automatic).labels;
  for (Eigen::Index k = 0; k < data.rows.size(); ++k) {
    const double t = data.rows.time(k);
    if (t > 4.7 && t < 5.3) continue;
    if (t > 13.7 && t < 14.3) continue;
    const MarkLabel truth = t > 5.0 && t < 14.0 ? MarkLabel::contact : MarkLabel::free;
    EXPECT_EQ(labels[static_cast<std::size_t>(k)], truth) << t;
  }
}

TEST(Segmentation, MarksWin) {
  Labelled data = simulated(MotionKind::free, 6);
  Recording& recording = data.simulated.recording;
  EXPECT_EQ(defaultSegmentMode(recording), SegmentMode::automatic);
  recording.meta.marks = {{2.0, 4.0, MarkLabel::contact}, {6.0, 7.0, MarkLabel::ignore}};
  EXPECT_EQ(defaultSegmentMode(recording), SegmentMode::marks);
  const auto labelAt = [&](const std::vector<MarkLabel>& labels, double t) {
    return labels[static_cast<std::size_t>((t - data.rows.startTime) * data.rows.rateHz)];
  };
  for (const auto mode : {SegmentMode::marks, SegmentMode::automatic}) {
    const auto labels = segmentRows(recording, data.rows, mode).labels;
    EXPECT_EQ(labelAt(labels, 3.0), MarkLabel::contact);
    EXPECT_EQ(labelAt(labels, 6.5), MarkLabel::ignore);
    EXPECT_EQ(labelAt(labels, 10.0), MarkLabel::free) << "only contacts are marked, so the rest is free";
  }
  recording.meta.marks = {{2.0, 4.0, MarkLabel::free}};
  EXPECT_EQ(labelAt(segmentRows(recording, data.rows, SegmentMode::marks).labels, 10.0), MarkLabel::ignore)
      << "free parts are marked, so the rest is not free";
  EXPECT_EQ(labelAt(segmentRows(recording, data.rows, SegmentMode::all).labels, 10.0), MarkLabel::free);
}

TEST(Segmentation, TheLabelColumnCountsAndMarksOverrideIt) {
  Labelled data = simulated(MotionKind::free, 7);
  Recording& recording = data.simulated.recording;
  recording.labels.assign(static_cast<std::size_t>(recording.rows()), MarkLabel::contact);
  recording.meta.marks = {{3.0, 5.0, MarkLabel::free}};
  const auto labels = segmentRows(recording, data.rows, SegmentMode::marks).labels;
  EXPECT_EQ(labels[50], MarkLabel::contact);
  EXPECT_EQ(labels[200], MarkLabel::free);
}

TEST(Segmentation, SegmentsCoverTheRecordingWithoutOverlap) {
  const Labelled data = simulated(MotionKind::pickAndPlace, 8);
  const auto segments = segmentRows(data.simulated.recording, data.rows, SegmentMode::automatic).segments;
  ASSERT_GT(segments.size(), 2u);
  for (std::size_t i = 1; i < segments.size(); ++i) {
    EXPECT_NEAR(segments[i].from, segments[i - 1].to, 1e-9);
    EXPECT_TRUE(segments[i].label != segments[i - 1].label || segments[i].kind != segments[i - 1].kind);
    EXPECT_FALSE(segments[i].reason.empty());
  }
}

}  // namespace
}  // namespace heft
