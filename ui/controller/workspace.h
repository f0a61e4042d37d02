#pragma once
// What is open, and what was found out about it. The window and its panels listen; they change nothing behind its back.
#include <QObject>
#include <QString>
#include <QUndoStack>
#include <memory>

#include "core/estimation/estimate.h"
#include "core/recording/recording.h"
#include "core/robot/robot_model.h"
#include "ui/jobs/job_runner.h"
#include "ui/robot_view/robot_look.h"

namespace heft {

/// Everything that opening a recording yields; immutable afterwards, shared with jobs and views.
struct OpenRecording {
  QString path;
  Recording recording;
  std::shared_ptr<const RobotModel> robot;  ///< Null where the recording names none (it carries poses).
  std::shared_ptr<const RobotLook> look;    ///< Null likewise.
  Findings findings;                        ///< Of reading and of the robot.
  double readSeconds = 0.0;
};

class Workspace : public QObject {
  Q_OBJECT
 public:
  explicit Workspace(QObject* parent = nullptr);

  /// Reads the file in a job, then estimates. The present recording stays until the new one is read; a file that cannot
  /// be read leaves it in place and gives failed().
  void open(const QString& path);
  /// Estimates the open recording in a job.
  void estimate();
  void cancel();

  std::shared_ptr<const OpenRecording> opened() const { return opened_; }
  std::shared_ptr<const EstimateReport> report() const { return report_; }
  bool busy() const { return jobs_.running(); }
  /// Why there is no report for the open recording; empty if nothing failed.
  QString lastFailure() const { return lastFailure_; }
  JobRunner& jobs() { return jobs_; }
  QUndoStack* undoStack() { return &undo_; }

 signals:
  void openedChanged();
  /// The report is null while there is none for the open recording.
  void reportChanged();
  /// busy() would answer differently.
  void busyChanged();
  /// One sentence for a person.
  void failed(const QString& sentence);

 private:
  void fail(const Error& error);

  JobRunner jobs_;
  QUndoStack undo_;
  std::shared_ptr<const OpenRecording> opened_;
  std::shared_ptr<const EstimateReport> report_;
  QString lastFailure_;
};

}  // namespace heft
