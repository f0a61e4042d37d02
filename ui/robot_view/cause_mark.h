#pragma once
// What the reality check found, drawn on the arm where it acts: a frame that is turned, a base that is tilted, a push,
// a load that changes, a mass that swings, a misplaced sensor.
#include <QString>
#include <optional>
#include <vector>

#include "ui/robot_view/handles.h"

class QPainter;

namespace heft {

struct CauseMark {
  enum class Kind {
    turnedFrame,  ///< `vector`: from the stated axes to the true ones, a rotation vector in S [rad]
    gravity,      ///< `vector`: true gravity, B axes
    push,         ///< `vector`: force on the tool, `at` where it acts
    load,         ///< `vector`: change of the weight, B axes
    swing,        ///< Something swings at `at`.
    misplaced     ///< `vector`: from the stated origin to the true one, S axes [m]
  };
  Kind kind = Kind::push;
  Vector3d vector = Vector3d::Zero();
  bool inBase = false;             ///< The vector of a push is in B axes, else in S axes.
  Vector3d at = Vector3d::Zero();  ///< S axes [m]
  double enlarged = 1.0;           ///< Factor by which angles and lengths are exaggerated; the note says so.
  QString title, note;             ///< "The sensor’s true axes", "5.0°, drawn 3× larger"
};

/// Where the words point to. `down`: gravity as stated, B axes.
QPointF causePixel(const CauseMark& mark, const Isometry3d& X_BS, const Vector3d& down, const HandleSet::View& view);
/// Without the words, which stand among the view's labels.
void paintCause(QPainter& painter, const CauseMark& mark, const Isometry3d& X_BS, const Vector3d& down,
                const HandleSet::View& view);

}  // namespace heft
