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
  connect(autosave_, &Autosave::failed, this, [this](const QString& why) {
    parts_.message->showMessage(Severity::warning,
                                tr("The session cannot be saved automatically: %1 Save it elsewhere.").arg(why),
                                tr("Save as …"), [this] { parts_.files->saveAs(); });
  });
  showSaved();
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
}

void Recovery::restore() {
  const auto recovered = autosave_->recover();
  if (!recovered.unreadable.isEmpty()) {
    const auto& [file, reason] = recovered.unreadable.first();
    parts_.message->showMessage(recovered.opened ? Severity::warning : Severity::error,
                                tr("The saved session could not be restored; it is now %1. %2").arg(file, reason));
  } else if (recovered.opened) {
    offerUnfinished();
  }
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
