#pragma once
// Nothing is lost when the program or the machine dies: the session is written every few seconds into the state folder
// (XDG_STATE_HOME/heft), and the next start finds what was left behind there.
#include <QDateTime>
#include <QLockFile>
#include <QObject>
#include <QStringList>
#include <QTimer>
#include <memory>

#include "core/base/result.h"

namespace heft {

class Workspace;

/// XDG_STATE_HOME/heft, or ~/.local/state/heft.
QString stateFolder();
/// The lock beside a file that belongs to a running program.
QString lockBeside(const QString& file);
/// Where recordings made in the program are kept: "Heft recordings" among the user's documents, or where
/// setRecordedFolder() said.
QString recordedFolder();
void setRecordedFolder(const QString& folder);
/// Where earlier versions kept them: what a killed one left there is found, too.
QString earlierRecordedFolder();

class Autosave : public QObject {
  Q_OBJECT
 public:
  /// Writes to `folder` at most every `interval` milliseconds, and only when something changed. `workspace` must
  /// outlive it.
  Autosave(Workspace* workspace, const QString& folder, int interval = 3000, QObject* parent = nullptr);
  /// A normal end: what was autosaved is removed.
  ~Autosave() override;

  /// Sessions that programs left behind that are no longer running, newest first.
  QStringList leftBehind() const;
  /// A session that could not be read: where it is now, and why.
  struct Unreadable {
    QString file, reason;
  };
  struct Recovered {
    bool opened = false;
    QDateTime savedAt;  ///< When the one that was opened was saved
    QList<Unreadable> unreadable;
  };
  /// Opens the newest of them that can be read and removes it once it is saved under this program's own name. Newer
  /// ones that cannot be read are moved aside, never deleted: another version of Heft or a person may still make use of
  /// them.
  Recovered recover();
  /// The system ends the program: what is open stays, for the next start to offer.
  void leaveForNextStart();
  /// Forgets one that the user does not want.
  static void discard(const QString& file);

  QString file() const { return file_; }
  QDateTime lastSaved() const { return lastSaved_; }
  /// Why the session cannot be saved; empty once it could.
  QString problem() const { return problem_; }
  /// Writes at once if anything changed. If that fails, it is retried from time to time; so is getting the folder and
  /// a name in it.
  void flush();

 signals:
  void saved();
  /// The first time that the session cannot be written, and again after it could be.
  void failed(const QString& sentence);

 private:
  /// Sees to the folder, and to a name in it with a lock. Without a lock afterwards it failed.
  void takeName();
  Result<bool> write();
  /// Renames it, so that it is not offered again; returns its new name.
  static QString setAside(const QString& file);

  Workspace* workspace_;
  QString folder_, file_;
  std::unique_ptr<QLockFile>
      lock_;      ///< Held as long as the program lives; a dead one's is stale. None: file_ is not ours.
  int interval_;  ///< [ms]
  QTimer timer_;
  QDateTime lastSaved_;
  QString problem_;  ///< Why the last attempt failed
  bool changed_ = false;
  bool leaves_ = false;
};

}  // namespace heft
