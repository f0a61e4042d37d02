#include "ui/controller/unfinished.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include "core/recording/csv_reader.h"
#include "ui/controller/autosave.h"

namespace heft {
namespace {

// The mark outlives a kill; the lock's owner does not.
QString markOf(const QString& csv) { return csv + QStringLiteral(".unfinished"); }

}  // namespace

UnderWay::UnderWay(const QString& csv) : csv_(csv), lock_(lockBeside(csv)) {
  lock_.setStaleLockTime(0);  // Only a dead owner makes it stale, not its age.
  lock_.tryLock(0);
  QFile mark(markOf(csv_));
  (void)mark.open(QIODevice::WriteOnly);
}

UnderWay::~UnderWay() { forgetUnfinished(csv_); }

QStringList unfinishedRecordings(const QString& folder) {
  QStringList out;
  const QString ending = markOf({});
  for (const QFileInfo& mark : QDir(folder).entryInfoList({QStringLiteral("*") + ending}, QDir::Files, QDir::Time)) {
    const QString csv = mark.absoluteFilePath().chopped(ending.size());
    QLockFile lock(lockBeside(csv));
    lock.setStaleLockTime(0);
    if (!lock.tryLock(0)) continue;  // It is still being made.
    if (QFileInfo(csv).size() > 0) {
      out << csv;
      continue;
    }
    forgetUnfinished(csv);
    QFile::remove(csv);
    QFile::remove(QString::fromStdString(metaFileOf(csv.toStdString()).string()));
  }
  return out;
}

void forgetUnfinished(const QString& csv) { QFile::remove(markOf(csv)); }

}  // namespace heft
