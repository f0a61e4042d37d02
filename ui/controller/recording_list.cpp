// The session's list of recordings: names, closing, one result for all. Every change is an undo step.
#include <QFileInfo>
#include <algorithm>

#include "ui/controller/edit_command.h"
#include "ui/controller/workspace.h"

namespace heft {
namespace {

enum ListEditKind { kName = 20, kJoined };  ///< Apart from the kinds of workspace.cpp.

/// Closing a recording; undo puts it where it was.
class CloseCommand : public QUndoCommand {
 public:
  CloseCommand(const QString& text, std::function<void()> close, std::function<void()> bringBack)
      : QUndoCommand(text), close_(std::move(close)), bringBack_(std::move(bringBack)) {}
  void redo() override { close_(); }
  void undo() override { bringBack_(); }

 private:
  std::function<void()> close_, bringBack_;
};

}  // namespace

QString Workspace::nameOf(int index) const {
  if (index < 0 || index >= static_cast<int>(session_.recordings.size())) return {};
  const SessionRecording& recording = session_.recordings[static_cast<std::size_t>(index)];
  return recording.name.empty() ? QFileInfo(QString::fromStdString(recording.file.string())).fileName()
                                : QString::fromStdString(recording.name);
}

void Workspace::rename(int index, const QString& name) {
  if (index < 0 || index >= static_cast<int>(session_.recordings.size())) return;
  const auto at = static_cast<std::size_t>(index);
  const std::string after = name.trimmed().toStdString();
  if (after == session_.recordings[at].name) return;
  undo_.push(new EditCommand<std::string>(tr("rename “%1”").arg(nameOf(index)), kName, 0, session_.recordings[at].name,
                                          after, [this, at](const std::string& value) {
                                            session_.recordings[at].name = value;
                                            emit recordingsChanged();
                                            emit sessionChanged();
                                          }));
}

void Workspace::insertEntry(int index, const SessionRecording& recording, const Entry& entry) {
  session_.recordings.insert(session_.recordings.begin() + index, recording);
  entries_.insert(entries_.begin() + index, entry);
  show(index);
  listEdited();
}

void Workspace::removeEntry(int index) {
  session_.recordings.erase(session_.recordings.begin() + index);
  entries_.erase(entries_.begin() + index);
  const bool wasShown = session_.active == index;
  int shown = session_.active - (session_.active > index ? 1 : 0);
  shown = std::min(shown, static_cast<int>(entries_.size()) - 1);
  // One that was not read cannot be shown.
  for (int k = 0; k < static_cast<int>(entries_.size()) && shown >= 0 && !openedAt(shown); ++k)
    if (openedAt(k)) shown = k;
  jobs_.cancel();  // Of the recording that is gone, or with it.
  if (wasShown)
    show(shown);
  else
    session_.active = shown;
  listEdited();
}

void Workspace::listEdited() {
  emit recordingsChanged();
  emit sessionChanged();
  if (joins()) return estimateSoon(kAllRecordings);
  if (opened() && (!report() || outdated()) && !active()->failed) estimateSoon(session_.active);
}

void Workspace::close(int index) {
  if (index < 0 || index >= static_cast<int>(entries_.size()) || loading_) return;
  const auto at = static_cast<std::size_t>(index);
  const SessionRecording recording = session_.recordings[at];
  const Entry entry = entries_[at];
  undo_.push(new CloseCommand(
      tr("close “%1”").arg(nameOf(index)), [this, index] { removeEntry(index); },
      [this, index, recording, entry] { insertEntry(index, recording, entry); }));
}

bool Workspace::joins() const { return session_.joined && entries_.size() > 1; }

void Workspace::setJoined(bool joined) {
  if (joined == session_.joined) return;
  undo_.push(new EditCommand<bool>(joined ? tr("one result for all recordings") : tr("a result for each recording"),
                                   kJoined, 0, session_.joined, joined, [this](bool value) {
                                     session_.joined = value;
                                     emit recordingsChanged();
                                     emit sessionChanged();
                                     estimateSoon(kAllRecordings);
                                   }));
}

}  // namespace heft
