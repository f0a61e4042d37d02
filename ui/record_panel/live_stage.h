#pragma once
// A live run in the shared 3D view: the arm as it moves now, what is known of its tool, and the suggested motion.
#include <QElapsedTimer>
#include <QObject>
#include <QPointer>
#include <memory>

#include "ui/robot_look/robot_look.h"
#include "ui/robot_view/robot_view.h"

namespace heft {

class Clearance;
class LiveRun;

class LiveStage : public QObject {
  Q_OBJECT
 public:
  /// Both must outlive it. `animated`: the ghost moves; else it stands where the suggestion leads.
  LiveStage(LiveRun* run, RobotView* view, bool animated, QObject* parent = nullptr);
  ~LiveStage() override;

  /// What the robot looks like; null while that is not known.
  void setLook(std::shared_ptr<const RobotLook> look);
  /// Takes the view over, and gives it back.
  void enter();
  void leave();
  void refresh();

 private:
  void showGhost();
  void showAdvice();
  /// Of the ghost, or of the arm itself if there is none.
  void showGap(const std::optional<VectorXd>& q);

  LiveRun* run_;
  QPointer<RobotView> view_;
  bool animated_, entered_ = false, begun_ = false;
  std::shared_ptr<const RobotLook> look_;
  QElapsedTimer ghostClock_;
  int refreshes_ = 0;
  const Clearance* hulls_ = nullptr;  ///< Whose hulls the view has
};

}  // namespace heft
