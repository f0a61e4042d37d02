#pragma once
// Where the labels of the 3D view stand: in one column beside what they name, free of each other, of notes and tools,
// and of the named things themselves where there is room.
#include <QPointF>
#include <QRectF>
#include <QSizeF>
#include <vector>

namespace heft {

struct LabelToPlace {
  QPointF anchor;  ///< What it names [px]
  QSizeF size;     ///< [px]
};

struct LabelRoom {
  QSizeF picture;
  std::vector<QRectF> taken;         ///< Notes, buttons, lengths: never covered.
  std::vector<QRectF> subjects;      ///< What is named: not covered where there is room.
  std::vector<QRectF> letters = {};  ///< Of the axes: never covered, but a leader may go below them.
  std::vector<QRectF> arm = {};      ///< Its links: rather left in sight.
};

enum class LabelSide { right, left };

/// Places in the order of `labels`, which are sorted by their anchors' height. `side` is where the column stood before
/// and stands now: it changes only where that is much better, so that nothing jumps while the picture moves.
std::vector<QRectF> placeLabels(const std::vector<LabelToPlace>& labels, const LabelRoom& room, LabelSide& side);

/// Where the leader of a label ends.
QPointF leaderEnd(const QRectF& label, QPointF anchor);

}  // namespace heft
