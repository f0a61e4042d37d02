#pragma once
// "Is it right on the robot?" at the end of Export: the numbers checked on another recording, and the tool's passport.
#include <QObject>
#include <QStringList>
#include <optional>

#include "ui/jobs/job_runner.h"
#include "ui/steps/step_panel.h"

class QVBoxLayout;

namespace heft {

class LiveRun;

class ProofCard : public QObject {
  Q_OBJECT
 public:
  ProofCard(const StudioParts& parts, QWidget* owner);

  /// At the end of a page that is being built.
  void addTo(QVBoxLayout* column, QWidget* content);
  /// Checks the numbers as they stand on another recording, in a job. Refuses the one that they come from.
  Result<bool> prove(const QString& recording);
  /// On what a live run has recorded so far.
  Result<bool> proveLive();
  /// Lines of a script that this obeys.
  static ScriptForms scriptForms();
  std::optional<Result<bool>> obey(const QStringList& words);

 signals:
  void changed();

 private:
  void addProof(QVBoxLayout* card, QWidget* content);
  void addButtons(QVBoxLayout* card, QWidget* content);
  void tell(const Result<bool>& outcome);
  void chooseRecording();
  void askPassport();
  /// Name of the tool as it is proposed.
  QString toolName() const;
  Result<bool> savePassport(const QString& file, const QString& tool, const QString& before, bool replace);

  StudioParts parts_;
  QWidget* owner_;
  LiveRun* run_;
  JobRunner jobs_;
};

}  // namespace heft
