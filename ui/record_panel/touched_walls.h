#pragma once
// Walls and tables that the tool touched in the shown recording, as the session's room.
#include <QObject>
#include <QString>

#include "core/base/findings.h"
#include "ui/jobs/job_runner.h"

namespace heft {

class Workspace;

class TouchedWalls : public QObject {
  Q_OBJECT
 public:
  TouchedWalls(Workspace* workspace, QObject* parent);

  /// Looks for them in a job, writes a heft.room/1 beside the recording and makes it the session's room. Fails at once,
  /// with what to do, where recording, estimate or the tool's shape is missing.
  Result<bool> find();
  JobRunner& jobs() { return jobs_; }

 signals:
  /// How it ended, for a person: what was found and where it was written, or why nothing was.
  void ended(heft::Severity severity, const QString& sentence);

 private:
  Workspace* workspace_;
  JobRunner jobs_;
};

}  // namespace heft
