#pragma once
// The motion that would tell two causes apart, performed by the arm's ghost in the shared 3D view.
#include <QElapsedTimer>
#include <QObject>
#include <QPointer>
#include <QTimer>
#include <memory>
#include <optional>

#include "core/coach/arm_surroundings.h"
#include "core/coach/coach.h"
#include "ui/jobs/job_runner.h"

namespace heft {

class Playback;
class RobotView;
class Workspace;

class DecidingMotion : public QObject {
  Q_OBJECT
 public:
  /// All must outlive it.
  DecidingMotion(Workspace* workspace, RobotView* view, const Playback* playback, QObject* parent = nullptr);
  ~DecidingMotion() override;

  /// The open recording has an arm that could show one.
  bool possible() const;
  /// From the posture shown now, repeated until hide().
  void show(const std::string& motion);
  void hide();
  bool shown() const { return advice_.has_value(); }
  JobRunner* runner() { return &jobs_; }

 signals:
  void failed(const QString& sentence);

 private:
  void begin(Advice advice);
  void step();
  void showAt(const VectorXd& q);

  Workspace* workspace_;
  QPointer<RobotView> view_;
  const Playback* playback_;
  JobRunner jobs_;
  QTimer timer_;
  QElapsedTimer clock_;
  std::optional<Advice> advice_;
  std::shared_ptr<ArmSurroundings> around_;
};

}  // namespace heft
