// Labels of the 3D view: free of each other, of notes, and of what they name.
#include <gtest/gtest.h>

#include "ui/robot_view/label_layout.h"

namespace heft {
namespace {

void expectFree(const std::vector<QRectF>& places, const std::vector<QRectF>& obstacles, QSizeF picture) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    EXPECT_TRUE(QRectF(QPointF(0, 0), picture).contains(places[i])) << "label " << i << " leaves the picture";
    for (std::size_t j = i + 1; j < places.size(); ++j)
      EXPECT_FALSE(places[i].intersects(places[j])) << i << " and " << j;
    for (const QRectF& each : obstacles)
      EXPECT_FALSE(places[i].intersects(each)) << "label " << i << " covers something";
  }
}

TEST(LabelLayout, StandsInOneColumnAtTheRightOfWhatItNames) {
  LabelSide side = LabelSide::right;
  const LabelRoom room{{800, 500}, {}, {QRectF(300, 100, 150, 300)}};
  const auto places =
      placeLabels({{{380, 90}, {120, 24}}, {{390, 200}, {180, 40}}, {{400, 205}, {90, 24}}}, room, side);
  ASSERT_EQ(places.size(), 3u);
  expectFree(places, room.subjects, room.picture);
  for (const QRectF& place : places) {
    EXPECT_DOUBLE_EQ(place.left(), places[0].left());
    EXPECT_GT(place.left(), 450);
  }
  EXPECT_EQ(side, LabelSide::right);
}

TEST(LabelLayout, ANoteIsNeverCovered) {
  LabelSide side = LabelSide::right;
  // The note spans most of the top, as it does in a narrow view with long words.
  const LabelRoom room{{500, 400}, {QRectF(16, 14, 400, 30), QRectF(450, 12, 40, 200)}, {QRectF(180, 60, 80, 200)}};
  const auto places = placeLabels({{{220, 30}, {130, 24}}, {{220, 40}, {160, 40}}}, room, side);
  expectFree(places, room.taken, room.picture);
  expectFree(places, room.subjects, room.picture);
}

TEST(LabelLayout, GoesToTheLeftWhereTheRightHasNoRoom) {
  LabelSide side = LabelSide::right;
  const LabelRoom room{{600, 400}, {}, {QRectF(300, 5, 260, 390)}};
  const auto places = placeLabels({{{420, 90}, {170, 40}}}, room, side);
  expectFree(places, room.subjects, room.picture);
  EXPECT_EQ(side, LabelSide::left);
  // With room at the right it comes back.
  const LabelRoom later{{600, 400}, {}, {QRectF(250, 80, 60, 240)}};
  placeLabels({{{280, 90}, {170, 40}}}, later, side);
  EXPECT_EQ(side, LabelSide::right);
}

TEST(LabelLayout, LeavesTheArmInSight) {
  // The tool at the right of the arm: the letter of an axis in the way of two leaders is no reason to cover the arm.
  LabelSide side = LabelSide::left;
  LabelRoom room{{800, 400}, {}, {QRectF(420, 120, 60, 140)}};
  room.letters = {QRectF(500, 150, 18, 18), QRectF(500, 200, 18, 18)};
  room.arm = {QRectF(240, 100, 170, 80), QRectF(240, 180, 60, 180)};
  const auto places = placeLabels(
      {{{450, 130}, {120, 24}}, {{450, 160}, {120, 24}}, {{450, 208}, {150, 40}}, {{450, 250}, {90, 24}}}, room, side);
  expectFree(places, room.letters, room.picture);
  expectFree(places, room.arm, room.picture);
  EXPECT_EQ(side, LabelSide::right);
}

TEST(LabelLayout, WhereNothingIsFreeLabelsStillDoNotCoverEachOther) {
  LabelSide side = LabelSide::right;
  const LabelRoom room{{300, 200}, {}, {QRectF(0, 0, 300, 200)}};
  const auto places =
      placeLabels({{{150, 20}, {120, 24}}, {{150, 30}, {120, 24}}, {{150, 180}, {120, 24}}}, room, side);
  expectFree(places, {}, room.picture);
}

TEST(LabelLayout, LeadersEndAtTheNearSide) {
  EXPECT_EQ(leaderEnd(QRectF(200, 10, 50, 20), {100, 50}), QPointF(200, 20));
  EXPECT_EQ(leaderEnd(QRectF(20, 10, 50, 20), {100, 50}), QPointF(70, 20));
  EXPECT_EQ(leaderEnd(QRectF(20, 10, 50, 20), {40, 50}), QPointF(40, 30));
}

}  // namespace
}  // namespace heft
