#pragma once
// The step "Record": where the motion and the forces come from - files, a robot that is listened to, or the virtual
// arm.
#include <QPointer>
#include <memory>

#include "ui/jobs/job_runner.h"
#include "ui/live/live_run.h"
#include "ui/robot_look/robot_look.h"
#include "ui/steps/step_panel.h"
#include "ui/wrench_plots/recording_pane.h"

class QHBoxLayout;
class QVBoxLayout;

namespace heft {

class FlangeGuide;
class LiveBoard;
class LiveStage;
class SourceForm;
class TouchedWalls;
struct Sample;

class RecordPanel : public StepPanel {
  Q_OBJECT
 public:
  explicit RecordPanel(const StudioParts& parts);
  ~RecordPanel() override;

  Step step() const override { return Step::record; }
  StepState state() const override;
  void entered() override;
  void left() override;
  Below below() const override { return run_->running() && ownPane_ ? Below::own : Below::plots; }
  QWidget* ownPane() override;
  QString hint() const override;
  QString facts() const override;
  bool keyPressed(QKeyEvent* event) override;
  /// Asks whether to stop and keep, or to go on recording.
  bool mayEnd() override;
  void keepUnderWay() override;
  void addActions(const StudioMenus& menus) override;
  static ScriptForms scriptForms();
  std::optional<Result<bool>> obey(const QStringList& words) override;

  enum class Way { files, live, virtualArm };
  void setWay(Way way);
  /// The virtual arm with a tool that the seed chooses. With `byClock` it runs in real time.
  void startVirtual(std::uint64_t seed, bool poses, bool byClock);
  /// What the form says.
  void startListening();
  void stopAndKeep();
  LiveRun* run() { return run_; }
  FlangeGuide* guide() { return guide_; }

 private:
  void refresh();
  /// A seed whose practice tool weighs between both [kg].
  static std::uint64_t toolBetween(double lightest, double heaviest);
  void showLive();
  void showPause();
  void addWays(QVBoxLayout* column);
  void addFiles(QVBoxLayout* column);
  void addVirtual(QVBoxLayout* column);
  void addOpened(QVBoxLayout* column);
  void addRecent(QVBoxLayout* column);
  void addRoom(QVBoxLayout* column);
  void chooseRoom();
  /// Walls that were touched in the shown recording become the room.
  void findTouchedWalls();
  /// Takes a room over where it can be read.
  Result<bool> setRoom(const QString& file);
  /// The session's room in the view.
  void showRoom();
  void addSamples(QVBoxLayout* column);
  void openSample(const Sample& sample);
  void listenTo(LiveOrigin origin, bool poses);
  bool virtualRun() const { return run_->virtualArm() != nullptr; }
  void begin(LiveSetup setup, bool byClock);
  void follow();
  void changeWay(bool poses);
  /// Ends the run and keeps what came, without opening it. Its file; empty if there is too little.
  QString keepAside();
  void discardPoses();
  void saveRecordingAs();
  void showNoLive();
  void liveRefreshed();
  void changeTool();
  void fail(const QString& sentence);
  std::optional<Result<bool>> obeyLive(const QStringList& words);
  /// The script goes on when all has come and has been learned.
  Result<bool> replay(const QString& file);

  QPointer<RecordingPane> ownPane_;  ///< Plots of the live run; the window places it.
  LiveRun* run_;                     ///< The workspace's: it goes on when the window is replaced.
  JobRunner looking_;                ///< Loads what the robot looks like.
  JobRunner sampling_;               ///< Makes a recording to try with.
  JobRunner waiting_;                ///< In scripts: until a replay has come to its end.
  Way way_ = Way::files;
  bool here_ = false;
  std::uint64_t tool_ = 0;  ///< Seed of the virtual tool that is offered
  SourceForm* form_ = nullptr;
  LiveBoard* board_ = nullptr;
  LiveStage* stage_ = nullptr;
  FlangeGuide* guide_ = nullptr;
  TouchedWalls* touchedWalls_;
  int plotted_ = 0;
};

}  // namespace heft
