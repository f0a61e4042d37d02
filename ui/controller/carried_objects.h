#pragma once
// The object that the tool carries in the shown recording, once the user has asked for it.
#include <QObject>
#include <QString>
#include <memory>
#include <optional>

#include "core/estimation/carried_object.h"
#include "ui/controller/workspace.h"

namespace heft {

/// The workspace's only child of its kind. The answer follows marks and settings; another recording ends it.
class CarriedObjects : public QObject {
  Q_OBJECT
 public:
  /// `workspace` is the Workspace.
  explicit CarriedObjects(QObject* workspace);

  /// Something is picked up or put down in the shown recording.
  Result<bool> findPickedUp() { return ask({}); }
  /// What the shown recording carries more than this one.
  Result<bool> findMinus(const QString& without);
  void forget();

  /// It was asked for, and is answered or being worked on.
  bool asked() const { return asked_; }
  /// Null if there is none.
  std::shared_ptr<const CarriedObject> object() const { return object_; }
  /// The recording without the object; empty: it is picked up in the shown one.
  QString without() const { return without_; }
  /// Why there is none.
  QString failure() const { return failure_; }
  JobRunner& jobs() { return jobs_; }

 signals:
  void changed();

 private:
  Result<bool> ask(const QString& without);
  void start();
  void refresh();

  Workspace& workspace_;
  JobRunner jobs_;
  bool asked_ = false;
  QString without_, failure_;
  std::weak_ptr<const OpenRecording> of_;
  std::shared_ptr<const EstimateReport> report_;  ///< The numbers of the time when it was asked
  std::shared_ptr<const CarriedObject> object_;
};

}  // namespace heft
