#pragma once
// What is open and what was found out about it: the session of core/workspace, with every edit an undoable command, and
// the loading and estimating that follow from it. Windows and panels listen; they change nothing behind its back.
#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>
#include <QUndoStack>
#include <functional>
#include <memory>
#include <vector>

#include "core/estimation/estimate.h"
#include "core/recording/recording.h"
#include "core/robot/robot_model.h"
#include "core/workspace/session.h"
#include "ui/jobs/job_runner.h"
#include "ui/robot_look/robot_look.h"

namespace heft {

/// Everything that opening a recording yields; immutable afterwards, shared with jobs and views.
struct OpenRecording {
  QString path;
  Recording recording;
  std::shared_ptr<const RobotModel> robot;  ///< Null where the recording names none (it carries poses).
  std::shared_ptr<const RobotLook> look;    ///< Null in that case, too.
  Findings findings;                        ///< Of reading and of the robot.
  double readSeconds = 0.0;
};

/// What the user can do about a recording that cannot be read.
enum class ReadCure {
  none,     ///< Nothing here: the file itself is at fault.
  sources,  ///< Say which columns are what, and their units.
  rig       ///< Say which robot it is.
};

/// What an estimate or a diagnosis reads, detached from the window: the recording with the user's marks in it, and the
/// options that the session asks for. Cheap to copy; recording() copies the series where marks were painted, so call it
/// in the job.
struct Snapshot {
  std::shared_ptr<const OpenRecording> opened;
  std::vector<Mark> marks;  ///< Painted, laid over the file's own.
  EstimateOptions options;
  Corrections corrections;  ///< Of the reality check; recording() does not hold them, estimated() does.

  std::shared_ptr<const Recording> recording() const;
  /// With the corrections in the model.
  Result<EstimateReport> estimated(const Progress& progress) const;
  const RobotModel* robot() const { return opened->robot.get(); }
};

/// One per recording.
using SharedReports = std::vector<std::shared_ptr<const EstimateReport>>;

class Workspace : public QObject {
  Q_OBJECT
 public:
  explicit Workspace(QObject* parent = nullptr);

  /// Recordings are read in a job and added to the session, the last one is shown and estimated. A session (.heft)
  /// replaces what is open. What cannot be read leaves everything in place and gives failed().
  void open(const QString& path) { open(QStringList{path}); }
  void open(const QStringList& paths);
  /// Writes a recording made in the program (virtual arm, live) into `folder` under a name that is free and opens it.
  void addRecording(const Recording& recording, const QString& folder, const QString& name);
  /// Nothing open, nothing said.
  void startAfresh();
  /// Shows another recording of the session.
  void activate(int index);
  /// What the list calls a recording: the user's name, else the file's.
  QString nameOf(int index) const;
  /// An empty name gives it the file's again.
  void rename(int index, const QString& name);
  /// Takes a recording out of the session; its file stays. Undo brings it back.
  void close(int index);
  /// Whether all recordings are of one tool and give one result.
  void setJoined(bool joined);
  /// They do, and there are two at least.
  bool joins() const;
  /// Estimates the shown recording in a job.
  void estimate();
  void cancel();

  const Session& session() const { return session_; }
  /// Writes the session; false, with failed(), where that is not possible.
  bool save(const QString& file);
  QString sessionFile() const { return QString::fromStdString(session_.home.string()); }
  /// Something was edited or opened since the session was saved.
  bool modified() const { return modified_ || !undo_.isClean(); }
  /// Replaces what is open, for instance with a recovered session.
  void takeSession(Session session);

  /// Null if there is none.
  std::shared_ptr<const OpenRecording> opened() const;
  std::shared_ptr<const EstimateReport> report() const;
  /// Of any recording of the session; null while it is not read or not estimated.
  std::shared_ptr<const OpenRecording> openedAt(int index) const;
  std::shared_ptr<const EstimateReport> reportAt(int index) const;
  /// The report is of an earlier state: a new estimate is due or under way.
  bool outdated() const { return active() && active()->outdated; }
  Snapshot snapshot() const { return snapshotOf(session_.active); }
  /// The report's segments, painted marks laid over them at once.
  std::vector<Segment> segments() const;
  /// Heft suggests this segment, and the user has not decided yet.
  bool suggested(const Segment& segment) const;

  bool busy() const { return jobs_.running() || due_.isActive(); }
  /// Why there is no report for the open recording; empty if nothing failed.
  QString lastFailure() const { return lastFailure_; }
  JobRunner& jobs() { return jobs_; }
  QUndoStack* undoStack() { return &undo_; }

  // Edits. Each is one undo step called `text`; edits with the same `mergeKey` above 0 in a row become one step (a
  // drag: take a new key from newMergeKey() when it begins).

  /// Marks a segment of the shown recording; without a label it becomes Heft's suggestion again.
  void paint(double from, double to, std::optional<MarkLabel> label, int mergeKey = 0);
  void setMarks(const std::vector<Mark>& marks, const QString& text, int mergeKey = 0);
  void setShape(const ShapeChoice& shape, const QString& text, int mergeKey = 0);
  void setSettings(const EstimateSettings& settings, const QString& text, int mergeKey = 0);
  void setExport(const ExportChoice& choice, const QString& text, int mergeKey = 0);
  void setController(const ControllerChoice& choice, const QString& text);
  /// A heft.room/1 that can be read; empty takes it away.
  void setRoom(const std::filesystem::path& file, const QString& text);
  /// Of the shown recording.
  void setCorrections(const Corrections& corrections, const QString& text);
  const Corrections& corrections() const;
  int newMergeKey() { return ++mergeKey_; }
  /// A heft.prove/1 as JSON text: a result, which no undo takes back.
  void setProof(const std::string& json);
  /// View state: kept in the session, never undone.
  void setStep(const QString& id);

 signals:
  /// Another recording is in the list or is gone from it, has another name, or all give one result now.
  void recordingsChanged();
  /// Another recording is shown, or none.
  void openedChanged();
  /// The report is null if there is none for the open recording.
  void reportChanged();
  void marksChanged();
  void shapeChanged();
  void settingsChanged();
  void exportChanged();
  void correctionsChanged();
  void controllerChanged();
  void roomChanged();
  void proofChanged();
  /// Anything in the session changed, results included.
  void sessionChanged();
  /// busy() has changed.
  void busyChanged();
  void saved(const QString& file);
  /// One sentence for a person.
  void failed(const QString& sentence);
  /// After failed(), where it was a recording that could not be read.
  void unreadable(const QString& path, const QString& sentence, heft::ReadCure cure);

 private:
  struct Entry {
    std::shared_ptr<const OpenRecording> opened;
    std::shared_ptr<const EstimateReport> report;
    bool failed = false;    ///< Its estimate ended in an error, and nothing was changed since.
    bool outdated = false;  ///< The report is of other marks, another shape or other settings.
  };
  void loadNext();
  void loaded(const QString& path, std::shared_ptr<const OpenRecording> opened);
  /// After an edit that concerns one recording, or all of them.
  void estimateSoon(int index);
  static constexpr int kAllRecordings = -1;
  void fail(const Error& error);
  const Entry* active() const;
  void show(int index);
  Snapshot snapshotOf(int index) const;
  /// Takes over what a job estimated, in the order of `of`.
  void takeReports(const std::vector<Snapshot>& of, const Result<SharedReports>& result);
  /// Adds a recording to the list or removes one; the shown one stays shown if possible.
  void insertEntry(int index, const SessionRecording& recording, const Entry& entry);
  void removeEntry(int index);
  /// Reports that the list has changed, and estimates again what that affects: a joint result, if there is one.
  void listEdited();

  /// One undoable change of a part of the session.
  template <class T>
  void edit(T Session::*part, T after, const QString& text, int mergeKey, void (Workspace::*changed)(), bool estimates);

  Session session_;
  std::vector<Entry> entries_;  ///< One per recording of the session.
  QStringList queue_;           ///< Still to be read.
  bool loading_ = false;        ///< The job under way reads a file of the queue.
  int showAfter_ = -1;          ///< Recording of a session to show when all are read.
  JobRunner jobs_;
  QTimer due_;  ///< Edits in quick succession make one estimate.
  QUndoStack undo_;
  QString lastFailure_;
  int mergeKey_ = 0;
  int sessions_ = 0;  ///< How many were taken so far.
  bool modified_ = false;
};

}  // namespace heft

Q_DECLARE_METATYPE(heft::ReadCure)
