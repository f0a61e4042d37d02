#pragma once
// Things that can be grabbed in the 3D view and dragged along a line, in a plane or round a circle. A step makes a set,
// gives it to HandleLayer::setHandles while it is shown, and listens: grabbed, dragged (again and again), then released
// or cancelled. Every drag is reported relative to its start, so the listener may move the handles during it.
#include <QObject>
#include <QPointF>
#include <QSizeF>
#include <QString>
#include <optional>
#include <vector>

#include "ui/robot_view/dragging.h"
#include "ui/robot_view/orbit_camera.h"

class QPainter;

namespace heft {

struct Handle {
  enum class Way {
    line,    ///< Slides along `axis`.
    plane,   ///< Moves in the plane with normal `axis`; facing the viewer if that is zero.
    circle,  ///< Turns about `axis` through `centre`.
  };
  int id = 0;
  Way way = Way::line;
  Vector3d point = Vector3d::Zero();   ///< Where its knob is [m]
  Vector3d axis = Vector3d::Zero();    ///< Unit vector, or zero with Way::plane
  Vector3d centre = Vector3d::Zero();  ///< With Way::circle [m]
  int tone = -1;                       ///< 0, 1, 2: colour and letter of an axis; else neutral
  double grabRadius = 0.0;             ///< Can be grabbed anywhere this near to `point` [m], besides its knob.
  bool shown = true;  ///< Draws knob and arrow or circle; else only the pointer shows that it is there.
  bool arrow = true;  ///< With Way::line: an arrow with the axis' letter besides the knob.
  QString tip;        ///< What it does: "height 64 mm"
};

struct HandleDrag {
  Handle handle;                      ///< As it was when it was grabbed.
  double along = 0.0;                 ///< With Way::line [m]
  Vector3d shift = Vector3d::Zero();  ///< With Way::line and Way::plane: from where it was grabbed [m]
  double angle = 0.0;                 ///< With Way::circle [rad]; goes on past half a turn.
  bool fine = false;                  ///< Shift is held: a tenth of the way.
};

class HandleSet : public QObject {
  Q_OBJECT
 public:
  /// Whose axes the handles are given in: the robot's base, or the sensor, which they then follow.
  enum class Frame { base, sensor };
  explicit HandleSet(Frame frame, QObject* parent = nullptr);

  void setHandles(std::vector<Handle> handles);
  const std::vector<Handle>& handles() const { return handles_; }
  Frame frame() const { return frame_; }
  bool dragging() const { return grabbed_.has_value(); }
  /// Id of the handle under the pointer or in the hand; nothing without.
  std::optional<int> current() const;
  QString tip() const;

  // For the view.
  struct View {
    OrbitCamera camera;
    QSizeF size;  ///< [pixels]
    QPointF pixelOf(const Vector3d& point) const;
    Ray rayThrough(QPointF pixel) const;
  };
  /// Pose of the frame in B; Frame::base keeps the identity.
  void setPose(const Isometry3d& X_BF);
  /// True if something is under the pointer.
  bool hover(QPointF pixel, const View& view);
  bool press(QPointF pixel, const View& view);
  void move(QPointF pixel, const View& view, bool fine);
  void release();
  void cancel();
  void leave();
  void paint(QPainter& painter, const View& view) const;
  /// Where a handle's knob is drawn; nothing if it would point at the viewer and cannot be dragged.
  std::optional<QPointF> knob(int id, const View& view) const;

 signals:
  void grabbed(int id);
  void dragged(const heft::HandleDrag& drag);
  void released(int id);
  /// Esc: put back what the drag changed.
  void cancelled(int id);
  /// Paint again.
  void changed();

 private:
  struct Grab {
    Handle handle;       ///< In F axes.
    Isometry3d X_BF;     ///< At the time of grabbing.
    double along = 0.0;  ///< At the time of grabbing.
    Vector3d point;      ///< On the plane, B axes.
    double lastAngle = 0.0, angle = 0.0;
    Vector3d from;  ///< From the circle's centre to the pointer, B axes.
  };
  const Handle* find(QPointF pixel, const View& view) const;
  std::optional<QPointF> knobOf(const Handle& handle, const View& view) const;
  void paintHandle(QPainter& painter, const View& view, const Handle& handle, QPointF knob, bool current) const;

  Frame frame_;
  Isometry3d X_BF_ = Isometry3d::Identity();
  std::vector<Handle> handles_;
  std::optional<int> hovered_;
  std::optional<Grab> grabbed_;
};

}  // namespace heft
