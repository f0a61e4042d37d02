#pragma once
// What the controller's current entry costs in the shown recording, for every step that shows it.
#include <QObject>
#include <QString>
#include <memory>
#include <optional>
#include <string>

#include "core/compensation/entry_cost.h"
#include "ui/controller/workspace.h"

namespace heft {

/// The workspace's only child of its kind.
class EntryCosts : public QObject {
  Q_OBJECT
 public:
  /// `workspace` is the Workspace.
  explicit EntryCosts(QObject* workspace);

  struct Entry {
    PartialPayload payload;  ///< F axes
    QString source;          ///< File, or the recording's fields; empty: typed in
    bool byRecording = false;
  };
  /// The user's, else the recording's; nothing where neither states a mass.
  std::optional<Entry> entry() const;
  /// Null while it is not known.
  std::shared_ptr<const EntryCost> cost() const { return cost_; }
  /// Why there is none.
  QString failure() const { return failure_; }
  JobRunner& jobs() { return jobs_; }

  /// Makes a payload file the entry.
  Result<bool> read(const QString& file);

 signals:
  void changed();

 private:
  void refresh();

  Workspace& workspace_;
  JobRunner jobs_;
  std::shared_ptr<const EstimateReport> of_;
  std::string asked_;  ///< What cost_ or the job under way answers, beside of_
  std::shared_ptr<const EntryCost> cost_;
  QString failure_;
};

}  // namespace heft
