#pragma once
// One run of listening: the session with its sources, the recording that grows on disk, what was learned from it, and
// the coach's advice. Learning and coaching are jobs; this class belongs to the GUI thread.
#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QTimer>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "core/live/session.h"
#include "core/live/virtual_source.h"
#include "ui/controller/unfinished.h"
#include "ui/jobs/job_runner.h"
#include "ui/live/live_learner.h"

namespace heft {

/// What it takes to begin the same run anew.
struct LiveOrigin {
  std::uint64_t tool = 0;              ///< Seed of the virtual arm's hidden tool
  std::vector<std::string> addresses;  ///< Of the sources; empty for the virtual arm
  RecordingMeta meta;                  ///< As the rig file says
  std::filesystem::path replayMeta;    ///< For a recording that is played: the rig file; empty: its own setup file
  bool mountAssumed = false;           ///< How the sensor is mounted on the flange was not stated.
};

struct LiveSetup {
  std::vector<std::unique_ptr<LiveSource>> sources;
  VirtualSource* virtualArm = nullptr;      ///< One of the sources, or null.
  std::shared_ptr<const RobotModel> robot;  ///< Null: found from the first sample and the meta.
  RecordingMeta meta;
  std::optional<Shape> shape;
  Room room;             ///< What stands around the arm
  bool poses = false;    ///< Standing poses instead of a motion
  QString folder, name;  ///< Of the recording; a number is added where it exists.
  LiveOrigin origin;
};

class LiveRun : public QObject {
  Q_OBJECT
 public:
  explicit LiveRun(QObject* parent = nullptr);
  ~LiveRun() override;

  /// With `byClock` a virtual arm's time passes as on the wall; without it by pass() alone.
  Result<bool> start(LiveSetup setup, bool byClock);
  bool running() const { return session_ != nullptr; }
  bool poses() const { return poses_; }
  bool paused() const { return paused_; }
  bool byClock() const { return byClock_; }
  const LiveOrigin& origin() const { return origin_; }
  void setPaused(bool paused);
  /// So many seconds of the virtual arm pass, in pieces of half a second, with learning and coaching between them.
  void pass(double seconds);
  /// Ends. The file that was recorded; empty where no complete sample came, or with standing poses.
  QString stop();
  /// Ends and deletes what was recorded.
  void discard();

  /// Of the newest refresh; kept after the end.
  const LiveView& view() const { return view_; }
  SessionStatus status() const;
  std::shared_ptr<const LiveSession> session() const { return session_; }
  const RecordingMeta& meta() const { return meta_; }
  std::shared_ptr<const RobotModel> robot() const { return robot_; }
  /// What proposed motions keep clear of; null until it is made, which no picture waits for.
  const Clearance* clearance() const { return around_ ? around_->ready() : nullptr; }
  VirtualSource* virtualArm() const { return virtualArm_; }
  QString file() const { return file_; }
  /// What the coach says now; nothing while it knows nothing to say.
  const std::optional<Advice>& advice() const { return advice_; }
  /// Why no motion can be proposed from here; empty where one can.
  const QString& refusal() const { return refusal_; }
  double adviceAge() const { return view_.time - advisedAt_; }  ///< [s]
  Recording poseRecording() const;
  /// Ends and keeps what came: the file of a motion, or of two poses or more, which is written now. Empty where there
  /// is too little to keep; an error where it could not be written.
  Result<QString> keep();
  void removePose(int index);
  /// The virtual arm makes the coach's motion, or goes to the next pose. False without one.
  bool makeAdvised();
  /// All sources have come to their end (replays).
  bool finished() const;

  /// Their work counts as the window being busy. By the clock there is always some: that does not count.
  std::vector<JobRunner*> runners() { return {&learning_[0], &coaching_[0]}; }

 signals:
  void started();
  void ended();
  /// view() is new; at most 15 times a second.
  void refreshed();
  void adviceChanged();
  void toolChanged();
  void poseTaken();
  void failed(const QString& sentence);

 private:
  void tick();
  void pump();
  void goOn();
  bool prepare(const LiveSample& first);
  void coach();

  std::shared_ptr<LiveSession> session_;
  VirtualSource* virtualArm_ = nullptr;
  std::shared_ptr<const RobotModel> robot_;
  std::shared_ptr<ArmSurroundings> around_;  ///< Null without a robot
  RecordingMeta meta_;
  std::optional<Shape> shape_;
  Room room_;
  LiveOrigin origin_;
  std::shared_ptr<LiveLearner> learner_;
  bool poses_ = false, paused_ = false, byClock_ = true;
  QString file_;
  QString folder_, name_;
  std::unique_ptr<UnderWay> underWay_;  ///< Lets the next start find the file if this program is killed.
  LiveView view_;
  std::optional<Advice> advice_;
  QString refusal_;
  double advisedAt_ = -1e9;
  int tools_ = 1;
  std::vector<std::size_t> removals_;  ///< Poses that the next job takes away
  double owed_ = 0.0;                  ///< [s] that are still to pass
  quint64 run_ = 0;                    ///< Results of an earlier run are dropped.
  QTimer timer_;
  QElapsedTimer clock_;
  JobRunner& learning() { return learning_[byClock_ ? 1 : 0]; }
  JobRunner& coaching() { return coaching_[byClock_ ? 1 : 0]; }
  JobRunner learning_[2], coaching_[2];  ///< Stepped, and by the clock
};

}  // namespace heft
