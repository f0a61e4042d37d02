#pragma once
// The hand on the virtual arm's tool: dragging it in the 3D view moves it, its rings turn it, and keys do both.
#include <QObject>
#include <QPointer>

#include "core/simulation/guided_arm.h"
#include "ui/robot_view/handles.h"
#include "ui/robot_view/robot_view.h"

class QKeyEvent;

namespace heft {

class LiveRun;

class FlangeGuide : public QObject {
  Q_OBJECT
 public:
  /// Both must outlive it.
  FlangeGuide(LiveRun* run, RobotView* view, QObject* parent = nullptr);
  ~FlangeGuide() override;

  void attach();
  void detach();
  /// Arrow keys and Page Up, Page Down move, with Shift they turn; true if the key was one of these.
  bool key(QKeyEvent* event);
  /// Pulls S by `shift` [m, B axes] and turns it by `turn` [rad, its own axes], from where it is being pulled to.
  static void nudge(GuidedArm& arm, const Vector3d& shift, const Vector3d& turn);
  HandleSet* handles() { return &handles_; }

 protected:
  /// Keys over the 3D view guide the arm instead of turning the camera.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void drag(const HandleDrag& drag);

  LiveRun* run_;
  QPointer<RobotView> view_;
  HandleSet handles_{HandleSet::Frame::sensor};
  Isometry3d grabbedAt_ = Isometry3d::Identity();
  bool attached_ = false;
};

}  // namespace heft
