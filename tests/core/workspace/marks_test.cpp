#include "core/workspace/marks.h"

#include <gtest/gtest.h>

#include <random>

namespace heft {
namespace {

using enum MarkLabel;

std::string text(const std::vector<Mark>& marks) {
  std::string out;
  for (const Mark& mark : marks)
    out += std::to_string(static_cast<int>(mark.from)) + "-" + std::to_string(static_cast<int>(mark.to)) + ":" +
           std::string(toString(mark.label)) + " ";
  return out;
}

TEST(Painted, SplitsShortensAndJoins) {
  std::vector<Mark> marks = painted({}, 2, 8, contact);
  EXPECT_EQ(text(marks), "2-8:contact ");
  EXPECT_EQ(text(painted(marks, 4, 6, free)), "2-4:contact 4-6:free 6-8:contact ");
  EXPECT_EQ(text(painted(marks, 1, 3, free)), "1-3:free 3-8:contact ");
  EXPECT_EQ(text(painted(marks, 8, 9, contact)), "2-9:contact ");
  EXPECT_EQ(text(painted(marks, 9, 1, ignore)), "1-9:ignore ");
  EXPECT_EQ(text(painted(marks, 3, 4, std::nullopt)), "2-3:contact 4-8:contact ");
  EXPECT_EQ(text(painted(marks, 5, 5, free)), "2-8:contact ");
}

TEST(Painted, EveryInstantHasTheLabelPaintedLast) {
  std::mt19937 random(5);
  std::uniform_int_distribution<int> place(0, 100), kind(0, 3);
  std::vector<Mark> marks;
  std::vector<std::optional<MarkLabel>> truth(100);
  for (int stroke = 0; stroke < 400; ++stroke) {
    int from = place(random), to = place(random);
    if (from > to) std::swap(from, to);
    if (from == to) continue;
    const int k = kind(random);
    const auto label = k == 3 ? std::nullopt : std::optional(static_cast<MarkLabel>(k));
    marks = painted(marks, from, to, label);
    for (int i = from; i < to; ++i) truth[static_cast<std::size_t>(i)] = label;
    double end = -1;
    for (const Mark& mark : marks) {
      ASSERT_LE(end, mark.from);
      ASSERT_LT(mark.from, mark.to);
      end = mark.to;
    }
    for (int i = 0; i < 100; ++i) {
      std::optional<MarkLabel> found;
      for (const Mark& mark : marks)
        if (i + 0.5 > mark.from && i + 0.5 < mark.to) found = mark.label;
      ASSERT_EQ(found, truth[static_cast<std::size_t>(i)]) << "stroke " << stroke << " at " << i;
    }
  }
}

TEST(WithMarks, LaysMarksOverSuggestionsWithoutGaps) {
  Segment a, b;
  a.from = 0, a.to = 6, a.label = free, a.reason = "fits";
  b.from = 6, b.to = 10, b.label = contact, b.reason = "a push";
  const auto laid = withMarks({a, b}, {{5, 7, ignore}, {9.9995, 10, free}}, "by you");
  ASSERT_EQ(laid.size(), 4u);
  EXPECT_EQ(laid[0].to, 5);
  EXPECT_EQ(laid[1].label, ignore);
  EXPECT_EQ(laid[1].reason, "by you");
  EXPECT_EQ(laid[2].reason, "a push");
  for (std::size_t i = 1; i < laid.size(); ++i) EXPECT_DOUBLE_EQ(laid[i].from, laid[i - 1].to);
  EXPECT_EQ(laid.back().to, 10);
}

TEST(WithMarks, NeighbouringFreePartsAreOne) {
  Segment rest, motion, push;
  rest.from = 0, rest.to = 1, rest.reason = "at rest", rest.kind = SegmentKind::standing;
  motion.from = 1, motion.to = 6, motion.reason = "fits";
  push.from = 6, push.to = 8, push.label = contact, push.reason = "a push", push.kind = SegmentKind::contact;
  const auto plain = withMarks({rest, motion, push}, {}, "by you");
  ASSERT_EQ(plain.size(), 2u);
  EXPECT_EQ(plain[0].from, 0);
  EXPECT_EQ(plain[0].to, 6);
  EXPECT_EQ(plain[0].reason, "fits");
  const auto all = withMarks({rest, motion, push}, {{6, 8, free}}, "by you");
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].to, 8);
}

}  // namespace
}  // namespace heft
