#include "ui/controller/autosave.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>
#include <utility>

#include "core/base/file_replacement.h"
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
constexpr int kRetry = 15000;  ///< [ms] After a disk that was full
QString folderForRecordings;   // Empty: the user's own
}  // namespace

QString recordedFolder() {
  if (!folderForRecordings.isEmpty()) return folderForRecordings;
  return QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation) + QStringLiteral("/Heft recordings");
}

QString earlierRecordedFolder() { return stateFolder() + QStringLiteral("/recordings"); }

void setRecordedFolder(const QString& folder) { folderForRecordings = folder; }

Autosave::Autosave(Workspace* workspace, const QString& folder, int interval, QObject* parent)
    : QObject(parent), workspace_(workspace), folder_(folder), interval_(interval) {
  takeName();
  timer_.setSingleShot(true);
  timer_.setInterval(interval_);
  connect(&timer_, &QTimer::timeout, this, &Autosave::flush);
  connect(workspace_, &Workspace::sessionChanged, this, [this] {
    changed_ = true;
    if (!timer_.isActive()) timer_.start();
  });
}

Autosave::~Autosave() {
  if (lock_ && !leaves_) QFile::remove(file_);
}

void Autosave::takeName() {
  // Without its lock, another program would take the file for a dead one's.
  if (lock_ && QFileInfo::exists(lockBeside(file_))) return;
  lock_.reset();
  QDir().mkpath(folder_);
  // A name that no living program holds; two windows of one process differ by the number.
  for (int k = 0; k < 1000 && !lock_; ++k) {
    file_ =
        QDir(folder_).filePath(QStringLiteral("autosave-%1-%2.heft").arg(QCoreApplication::applicationPid()).arg(k));
    if (QFileInfo::exists(file_)) continue;
    auto lock = std::make_unique<QLockFile>(lockBeside(file_));
    lock->setStaleLockTime(0);  // Only a dead owner makes it stale, not its age.
    if (lock->tryLock(0))
      lock_ = std::move(lock);
    else if (lock->error() != QLockFile::LockFailedError)
      return;  // The folder is missing or the disk is full, which no other name helps.
  }
}

Result<bool> Autosave::write() {
  takeName();
  const std::string text = sessionText(workspace_->session(), folder_.toStdString(), true);
  if (lock_) return writeTextFile(file_.toStdString(), text);
  // Nothing stays there without a lock, but the attempt says what is in the way.
  auto attempt = FileReplacement::begin(file_.toStdString());
  if (!attempt) return attempt.error();
  if (const auto written = attempt->write(text); !written) return written.error();
  return Error{tr("%1 cannot be locked.").arg(file_).toStdString()};
}

void Autosave::leaveForNextStart() {
  flush();
  leaves_ = !workspace_->session().recordings.empty();
}

void Autosave::flush() {
  timer_.stop();
  if (!changed_) return;
  if (const auto written = write(); !written) {
    // Told once, while something can be done about it; every retry would be a nuisance.
    const QString why = QString::fromStdString(written.error().message);
    if (std::exchange(problem_, why).isEmpty()) emit failed(why);
    timer_.start(kRetry);
    return;
  }
  timer_.setInterval(interval_);
  problem_.clear();
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

Autosave::Recovered Autosave::recover() {
  Recovered out;
  for (const QString& orphan : leftBehind()) {
    const auto text = readTextFile(orphan.toStdString());
    auto session = text ? parseSession(*text, QFileInfo(orphan).fileName().toStdString(), folder_.toStdString())
                        : Result<Session>(text.error());
    if (!session) {
      out.unreadable << Unreadable{setAside(orphan), QString::fromStdString(session.error().message)};
      continue;
    }
    if (session->recordings.empty()) {  // Nothing was open.
      discard(orphan);
      continue;
    }
    out.savedAt = QFileInfo(orphan).lastModified();
    workspace_->takeSession(std::move(session).value());
    // It stands in no file of the user's: closing asks.
    workspace_->undoStack()->resetClean();
    changed_ = true;
    flush();
    if (!changed_) discard(orphan);
    out.opened = true;
    break;
  }
  return out;
}

QString Autosave::setAside(const QString& file) {
  const QFileInfo info(file);
  // Not "autosave-*": the next start shall not offer again what cannot be read.
  QString name;
  for (int k = 0; k == 0 || QFileInfo::exists(name); ++k)
    name = info.dir().filePath(QStringLiteral("unreadable-%1%2.heft")
                                   .arg(info.completeBaseName(), k > 0 ? QStringLiteral("-%1").arg(k) : QString()));
  if (!QFile::rename(file, name)) return file;
  QFile::remove(lockBeside(file));
  return name;
}

void Autosave::discard(const QString& file) {
  QFile::remove(file);
  QFile::remove(lockBeside(file));
}

}  // namespace heft
