#include "ui/main_window/files.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMimeData>
#include <QSettings>
#include <QUrl>
#include <QVariant>

#include "ui/controller/workspace.h"

namespace heft {
namespace {

constexpr int kRecentFiles = 8;

}  // namespace

Files::Files(Workspace* workspace, bool remembers, QWidget* window)
    : QObject(window), workspace_(workspace), remembers_(remembers), window_(window) {}

void Files::choose() {
  const QString folder = workspace_->opened() ? QFileInfo(workspace_->opened()->path).absolutePath() : QString();
  const QStringList paths =
      QFileDialog::getOpenFileNames(window_, tr("Open recordings"), folder, tr("Recordings (*.csv);;All files (*)"));
  open(paths);
}

void Files::open(const QStringList& paths) {
  for (const QString& path : paths) workspace_->open(path);
}

QStringList Files::recent() const {
  if (!remembers_) return {};
  QStringList present;
  for (const QString& path : QSettings().value("files/recent").toStringList()) {
    if (QFileInfo::exists(path)) present << path;
  }
  return present;
}

void Files::remember(const QString& path) {
  if (!remembers_) return;
  QStringList files = recent();
  files.removeAll(path);
  files.prepend(path);
  QSettings().setValue("files/recent", QStringList(files.mid(0, kRecentFiles)));
}

void Files::fillRecent(QMenu* menu) {
  connect(menu, &QMenu::aboutToShow, this, [this, menu] {
    menu->clear();
    for (const QString& path : recent()) menu->addAction(path, this, [this, path] { open({path}); });
    if (menu->isEmpty()) menu->addAction(tr("Nothing yet"))->setEnabled(false);
  });
}

QString Files::besideRecording() const {
  const auto opened = workspace_->opened();
  if (!opened) return {};
  const QFileInfo file(opened->path);
  return file.absolutePath() + "/" + file.completeBaseName();
}

void Files::savePicture(const QImage& image, const QString& what) {
  const QString base = besideRecording();
  const QString path = QFileDialog::getSaveFileName(window_, tr("Save a picture"),
                                                    (base.isEmpty() ? QString() : base + "-") + what + ".png",
                                                    tr("Pictures (*.png)"));
  if (path.isEmpty()) return;
  if (image.save(path)) {
    emit said(Severity::info, tr("Saved %1.").arg(path));
  } else {
    emit said(Severity::error,
              tr("%1 could not be written: check that the folder exists and may be written to.").arg(path));
  }
}

QStringList Files::dropped(const QMimeData* data) {
  QStringList paths;
  for (const QUrl& url : data->urls()) {
    if (url.isLocalFile()) paths << url.toLocalFile();
  }
  return paths;
}

}  // namespace heft
