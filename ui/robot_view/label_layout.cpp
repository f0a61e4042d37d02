#include "ui/robot_view/label_layout.h"

#include <QLineF>
#include <algorithm>
#include <cmath>

namespace heft {
namespace {

constexpr double kGap = 10, kEdge = 16, kBeside = 60;  // [px]
constexpr double kNoRoom = 1e6, kHides = 4e4, kOutside = 5e3, kUnderNote = 400, kUnderLetter = 40,
                 kOnArm = 150;                        // Costs, beside pixels of way
constexpr double kLeftCosts = 60, kChangeCosts = 15;  // A label

const QRectF* firstHit(const QRectF& place, const std::vector<QRectF>& obstacles) {
  const QRectF wide = place.adjusted(-kGap / 2, -kGap / 2, kGap / 2, kGap / 2);
  const auto hit =
      std::find_if(obstacles.begin(), obstacles.end(), [&](const QRectF& each) { return each.intersects(wide); });
  return hit == obstacles.end() ? nullptr : &*hit;
}

/// Moves the places up or down until they are free of each other and of the obstacles; false without room for that.
bool pack(std::vector<QRectF>& places, const std::vector<QRectF>& obstacles, double height) {
  double below = kEdge;
  for (QRectF& place : places) {
    place.moveTop(std::max(place.top(), below));
    while (const QRectF* hit = firstHit(place, obstacles)) place.moveTop(hit->bottom() + kGap);
    below = place.bottom() + kGap;
  }
  // Pushed over the lower edge: push back up from below.
  double above = height - kEdge;
  for (auto place = places.rbegin(); place != places.rend(); ++place) {
    if (place->bottom() > above) {
      place->moveBottom(above);
      while (const QRectF* hit = firstHit(*place, obstacles)) place->moveBottom(hit->top() - kGap);
    }
    above = place->top() - kGap;
  }
  return places.empty() || places.front().top() >= 0;
}

bool crosses(const QLineF& line, const QRectF& rect) {
  const QPointF corners[] = {rect.topLeft(), rect.topRight(), rect.bottomRight(), rect.bottomLeft()};
  for (int k = 0; k < 4; ++k) {
    const QLineF edge(corners[k], corners[(k + 1) % 4]);
    if (line.intersects(edge, nullptr) == QLineF::BoundedIntersection) return true;
  }
  return false;
}

struct Column {
  LabelSide side;
  double edge;  ///< Its left edge at the right, its right edge at the left [px]
};

double cost(const std::vector<LabelToPlace>& labels, const std::vector<QRectF>& places, const LabelRoom& room) {
  double sum = 0;
  const QRectF picture(QPointF(0, 0), room.picture);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const QLineF leader(labels[i].anchor, leaderEnd(places[i], labels[i].anchor));
    sum += leader.length();
    if (!picture.contains(places[i])) sum += kOutside;
    for (const QRectF& each : room.taken)
      if (crosses(leader, each)) sum += kUnderNote;
    for (const QRectF& each : room.letters)
      if (crosses(leader, each)) sum += kUnderLetter;
    double onArm = 0;  // Links overlap each other.
    for (const QRectF& each : room.arm) {
      const QRectF common = each.intersected(places[i]);
      onArm = std::max(onArm, common.width() * common.height() / (places[i].width() * places[i].height()));
    }
    sum += kOnArm * onArm;
    for (const QRectF& each : room.subjects) {
      const QRectF common = each.intersected(places[i]);
      if (!common.isEmpty())
        sum += kHides * common.width() * common.height() / (places[i].width() * places[i].height());
    }
  }
  return sum;
}

}  // namespace

QPointF leaderEnd(const QRectF& label, QPointF anchor) {
  const double y = label.center().y();
  if (label.left() >= anchor.x()) return {label.left(), y};
  if (label.right() <= anchor.x()) return {label.right(), y};
  return {std::clamp(anchor.x(), label.left(), label.right()), anchor.y() < label.top() ? label.top() : label.bottom()};
}

std::vector<QRectF> placeLabels(const std::vector<LabelToPlace>& labels, const LabelRoom& room, LabelSide& side) {
  if (labels.empty()) return {};
  double widest = 0, leftmost = room.picture.width(), rightmost = 0;
  for (const LabelToPlace& label : labels) {
    widest = std::max(widest, label.size.width());
    leftmost = std::min(leftmost, label.anchor.x());
    rightmost = std::max(rightmost, label.anchor.x());
  }
  for (const QRectF& each : room.subjects) {
    leftmost = std::min(leftmost, each.left());
    rightmost = std::max(rightmost, each.right());
  }
  const double atRight = std::max(kEdge, room.picture.width() - kEdge - widest),
               atLeft = std::min(atRight, kEdge) + widest;
  const double besideRight = std::clamp(rightmost + kBeside, kEdge, atRight);
  const double besideLeft = std::clamp(leftmost - kBeside, atLeft, std::max(atLeft, room.picture.width() - kEdge));
  const Column columns[] = {{LabelSide::right, besideRight},
                            {LabelSide::right, atRight},
                            {LabelSide::left, besideLeft},
                            {LabelSide::left, atLeft}};
  std::vector<QRectF> never = room.taken;
  never.insert(never.end(), room.letters.begin(), room.letters.end());
  std::vector<QRectF> all = never;
  all.insert(all.end(), room.subjects.begin(), room.subjects.end());
  std::vector<QRectF> best;
  LabelSide bestSide = side;
  double least = 1e300;
  for (const Column& column : columns) {
    for (const bool aroundSubjects : {true, false}) {
      std::vector<QRectF> places;
      for (const LabelToPlace& label : labels) {
        QRectF place({0, label.anchor.y() - label.size.height() / 2}, label.size);
        column.side == LabelSide::right ? place.moveLeft(column.edge) : place.moveRight(column.edge);
        places.push_back(place);
      }
      const bool fits = pack(places, aroundSubjects ? all : never, room.picture.height());
      double price = cost(labels, places, room) + (fits ? 0 : kNoRoom);
      const double each = static_cast<double>(labels.size());
      if (column.side == LabelSide::left) price += each * kLeftCosts;
      if (column.side != side) price += each * kChangeCosts;
      if (price >= least) continue;
      least = price;
      best = std::move(places);
      bestSide = column.side;
    }
  }
  side = bestSide;
  return best;
}

}  // namespace heft
