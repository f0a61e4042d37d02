#include "ui/main_window/recovery.h"

#include <QDateTime>
#include <QLocale>

#include "ui/controller/autosave.h"
#include "ui/controller/unfinished.h"
#include "ui/controller/workspace.h"
#include "ui/main_window/files.h"
#include "ui/main_window/status_bar.h"
#include "ui/widgets/message_bar.h"

namespace heft {

Recovery::Recovery(Autosave* autosave, const Parts& parts, QObject* parent)
    : QObject(parent), autosave_(autosave), parts_(parts) {
  connect(autosave_, &Autosave::saved, this, &Recovery::showSaved);
  connect(autosave_, &Autosave::failed, this, &Recovery::showProblem);
  showSaved();
  // Another language or theme makes a new window.
  if (!autosave_->problem().isEmpty()) showProblem(autosave_->problem());
  if (autosave_->leftBehind().isEmpty()) {
    offerUnfinished();
    return;
  }
  parts_.message->showMessage(Severity::warning, tr("Your last session was not closed. It was saved automatically."),
                              tr("Restore"), [this] { restore(); });
}

void Recovery::showSaved() {
  const QString at = autosave_->lastSaved().isValid()
                         ? QLocale().toString(autosave_->lastSaved().time(), QLocale::ShortFormat)
                         : QString();
  parts_.status->setSaved(at.isEmpty() ? QString() : tr("Saved automatically, %1").arg(at));
  if (!warning_.isEmpty()) parts_.message->withdraw(warning_);
  warning_.clear();
}

void Recovery::showProblem(const QString& why) {
  warning_ = tr("The session cannot be saved automatically: %1 Save it elsewhere.").arg(why);
  parts_.message->showMessage(Severity::warning, warning_, tr("Save as …"), [this] { parts_.files->saveAs(); });
}

void Recovery::restore() {
  const auto recovered = autosave_->recover();
  QStringList sentences;
  if (recovered.opened)
    sentences << tr("An older session was restored, saved on %1.")
                     .arg(QLocale().toString(recovered.savedAt, QLocale::ShortFormat));
  for (const auto& [file, reason] : recovered.unreadable)
    sentences << (recovered.opened ? tr("A newer one could not be read; it is now %1. %2")
                                   : tr("The saved session could not be restored; it is now %1. %2"))
                     .arg(file, reason);
  if (!recovered.unreadable.isEmpty())
    parts_.message->showMessage(recovered.opened ? Severity::warning : Severity::error, sentences.join(' '));
  if (recovered.opened) offerUnfinished();
}

void Recovery::offerUnfinished() {
  const QStringList recordings = unfinishedRecordings(recordedFolder()) + unfinishedRecordings(earlierRecordedFolder());
  if (recordings.isEmpty()) return;
  parts_.message->showMessage(Severity::warning,
                              tr("Heft Studio closed during a recording. The data up to that point was saved."),
                              tr("Open the recording"), [this, recordings] {
                                for (const QString& recording : recordings) forgetUnfinished(recording);
                                parts_.workspace->open(recordings);
                              });
}

}  // namespace heft
