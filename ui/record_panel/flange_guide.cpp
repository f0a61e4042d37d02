#include "ui/record_panel/flange_guide.h"

#include <QKeyEvent>
#include <QWidget>

#include "ui/live/live_run.h"
#include "ui/robot_view/robot_view.h"

namespace heft {
namespace {

constexpr int kMove = 0, kTurnX = 1;     ///< Handles; turns about x, y, z follow one another.
constexpr double kRing = 0.13;           ///< [m]
constexpr double kKeyStep = 0.02;        ///< [m]
constexpr double kKeyTurn = 0.10;        ///< [rad]
constexpr double kToolReach = 0.11;      ///< [m] The tool is grabbed anywhere this near to its middle.
const Vector3d kMiddle(0.0, 0.0, 0.05);  ///< Of a tool, S axes [m]

}  // namespace

FlangeGuide::FlangeGuide(LiveRun* run, RobotView* view, QObject* parent) : QObject(parent), run_(run), view_(view) {
  std::vector<Handle> handles;
  Handle move;
  move.id = kMove;
  move.way = Handle::Way::plane;
  move.point = kMiddle;
  move.grabRadius = kToolReach;
  move.tip = tr("Drag to move the tool");
  handles.push_back(move);
  for (int a = 0; a < 3; ++a) {
    Handle turn;
    turn.id = kTurnX + a;
    turn.way = Handle::Way::circle;
    turn.axis = Vector3d::Unit(a);
    turn.centre = kMiddle;
    turn.point = kMiddle + kRing * Vector3d::Unit((a + 1) % 3);
    turn.tone = a;
    turn.tip = tr("Drag along the ring to rotate the tool");
    handles.push_back(turn);
  }
  handles_.setHandles(handles);
  connect(&handles_, &HandleSet::grabbed, this, [this] {
    if (view_) grabbedAt_ = view_->sensorPose();
  });
  connect(&handles_, &HandleSet::dragged, this, &FlangeGuide::drag);
  const auto release = [this] {
    if (run_->virtualArm()) run_->virtualArm()->guide([](GuidedArm& arm) { arm.letGo(); });
  };
  connect(&handles_, &HandleSet::released, this, release);
  connect(&handles_, &HandleSet::cancelled, this, release);
}

FlangeGuide::~FlangeGuide() { detach(); }

void FlangeGuide::attach() {
  if (attached_) return;
  attached_ = true;
  view_->handles().setHandles(&handles_);
  if (auto* viewport = view_->findChild<QWidget*>("viewport")) viewport->installEventFilter(this);
}

void FlangeGuide::detach() {
  if (!attached_) return;
  attached_ = false;
  if (!view_) return;
  view_->handles().setHandles(nullptr);
  if (auto* viewport = view_->findChild<QWidget*>("viewport")) viewport->removeEventFilter(this);
}

void FlangeGuide::drag(const HandleDrag& drag) {
  VirtualSource* arm = run_->virtualArm();
  if (!arm) return;
  Isometry3d X = grabbedAt_;
  if (drag.handle.way == Handle::Way::plane) {
    X.translation() += X.linear() * drag.shift;
  } else {
    Isometry3d turn = Isometry3d::Identity();
    turn.linear() = rotationFromVector(drag.angle * drag.handle.axis);
    turn.translation() = drag.handle.centre - turn.linear() * drag.handle.centre;
    X = X * turn;
  }
  arm->guide([&](GuidedArm& guided) { guided.pullTo(X); });
}

void FlangeGuide::nudge(GuidedArm& arm, const Vector3d& shift, const Vector3d& turn) {
  Isometry3d X = arm.pulledTo();
  X.translation() += shift;
  X.linear() = X.linear() * rotationFromVector(turn);
  arm.pullTo(X);
}

bool FlangeGuide::key(QKeyEvent* event) {
  VirtualSource* arm = run_->virtualArm();
  if (!arm) return false;
  Vector3d way = Vector3d::Zero();
  switch (event->key()) {
    case Qt::Key_Left:
      way.y() = 1.0;
      break;
    case Qt::Key_Right:
      way.y() = -1.0;
      break;
    case Qt::Key_Up:
      way.z() = 1.0;
      break;
    case Qt::Key_Down:
      way.z() = -1.0;
      break;
    case Qt::Key_PageUp:
      way.x() = 1.0;
      break;
    case Qt::Key_PageDown:
      way.x() = -1.0;
      break;
    default:
      return false;
  }
  const bool turns = event->modifiers() & Qt::ShiftModifier;
  arm->guide([&](GuidedArm& guided) {
    if (turns) {
      nudge(guided, Vector3d::Zero(), kKeyTurn * Vector3d(way.y(), way.z(), way.x()));
    } else {
      nudge(guided, kKeyStep * way, Vector3d::Zero());
    }
  });
  return true;
}

bool FlangeGuide::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress && key(static_cast<QKeyEvent*>(event))) return true;
  return QObject::eventFilter(watched, event);
}

}  // namespace heft
