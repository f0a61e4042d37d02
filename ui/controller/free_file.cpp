#include "ui/controller/free_file.h"

#include <QDir>
#include <QFileInfo>

namespace heft {

QString freeFile(const QString& folder, const QString& name, const QString& suffix) {
  const QDir dir(folder);
  QString file = dir.absoluteFilePath(QStringLiteral("%1.%2").arg(name, suffix));
  for (int k = 2; QFileInfo::exists(file); ++k)
    file = dir.absoluteFilePath(QStringLiteral("%1-%2.%3").arg(name, QString::number(k), suffix));
  return file;
}

}  // namespace heft
