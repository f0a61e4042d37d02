#include "ui/controller/autosave.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>

#include "core/base/json_file.h"
#include "core/workspace/session.h"
#include "ui/controller/workspace.h"

namespace heft {
QString lockBeside(const QString& file) { return file + QStringLiteral(".lock"); }

QString stateFolder() {
  const QString state = qEnvironmentVariable("XDG_STATE_HOME");
  return (QDir::isAbsolutePath(state) ? state : QDir::homePath() + QStringLiteral("/.local/state")) +
         QStringLiteral("/heft");
}

namespace {
QString folderForRecordings;  // Empty: the user's own
}

QString recordedFolder() {
  if (!folderForRecordings.isEmpty()) return folderForRecordings;
  return QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation) + QStringLiteral("/Heft recordings");
}

QString earlierRecordedFolder() { return stateFolder() + QStringLiteral("/recordings"); }

void setRecordedFolder(const QString& folder) { folderForRecordings = folder; }

Autosave::Autosave(Workspace* workspace, const QString& folder, int interval, QObject* parent)
    : QObject(parent), workspace_(workspace), folder_(folder) {
  QDir().mkpath(folder_);
  // A name that no living program holds; two windows of one process differ by the number.
  for (int k = 0; k < 1000 && !lock_; ++k) {
    file_ =
        QDir(folder_).filePath(QStringLiteral("autosave-%1-%2.heft").arg(QCoreApplication::applicationPid()).arg(k));
    if (QFileInfo::exists(file_)) continue;
    auto lock = std::make_unique<QLockFile>(lockBeside(file_));
    lock->setStaleLockTime(0);  // Only a dead owner makes it stale, not its age.
    if (lock->tryLock(0)) lock_ = std::move(lock);
  }
  timer_.setSingleShot(true);
  timer_.setInterval(interval);
  connect(&timer_, &QTimer::timeout, this, &Autosave::flush);
  connect(workspace_, &Workspace::sessionChanged, this, [this] {
    changed_ = true;
    if (!timer_.isActive()) timer_.start();
  });
}

Autosave::~Autosave() {
  if (!leaves_) QFile::remove(file_);
}

void Autosave::leaveForNextStart() {
  flush();
  leaves_ = !workspace_->session().recordings.empty();
}

void Autosave::flush() {
  timer_.stop();
  if (!changed_ || !lock_) return;
  const Session& session = workspace_->session();
  const auto written = writeTextFile(file_.toStdString(), sessionText(session, folder_.toStdString(), true));
  // A full disk is no reason to trouble the user every few seconds; the next change tries again.
  if (!written) return;
  changed_ = false;
  lastSaved_ = QDateTime::currentDateTime();
  emit saved();
}

QStringList Autosave::leftBehind() const {
  QStringList orphans;
  const QFileInfoList files = QDir(folder_).entryInfoList({QStringLiteral("autosave-*.heft")}, QDir::Files, QDir::Time);
  for (const QFileInfo& info : files) {
    if (info.absoluteFilePath() == QFileInfo(file_).absoluteFilePath()) continue;
    QLockFile lock(lockBeside(info.absoluteFilePath()));
    lock.setStaleLockTime(0);
    if (lock.tryLock(0)) orphans << info.absoluteFilePath();
  }
  return orphans;
}

bool Autosave::recover() {
  for (const QString& orphan : leftBehind()) {
    auto text = readTextFile(orphan.toStdString());
    if (!text) continue;
    auto session = parseSession(*text, QFileInfo(orphan).fileName().toStdString(), folder_.toStdString());
    if (!session || session->recordings.empty()) {
      discard(orphan);
      continue;
    }
    workspace_->takeSession(std::move(session).value());
    // It stands in no file of the user's: closing asks.
    workspace_->undoStack()->resetClean();
    changed_ = true;
    flush();
    if (!changed_) discard(orphan);
    return true;
  }
  return false;
}

void Autosave::discard(const QString& file) {
  QFile::remove(file);
  QFile::remove(lockBeside(file));
}

}  // namespace heft
