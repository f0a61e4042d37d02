#include "ui/main_window/files.h"

#include <QBuffer>
#include <QFileDialog>
#include <QFileInfo>
#include <QImageWriter>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QSettings>
#include <QUndoStack>
#include <QUrl>
#include <QVariant>
#include <algorithm>

#include "core/base/json_file.h"
#include "ui/controller/robot_choice.h"
#include "ui/controller/workspace.h"
#include "ui/import_dialogs/rig_dialog.h"
#include "ui/import_dialogs/sources_dialog.h"

namespace heft {
namespace {

constexpr int kRecentFiles = 8;

}  // namespace

Files::Files(Workspace* workspace, bool remembers, QWidget* window)
    : QObject(window), workspace_(workspace), remembers_(remembers), window_(window) {}

void Files::choose() {
  const QString folder = workspace_->opened() ? QFileInfo(workspace_->opened()->path).absolutePath() : QString();
  const QStringList paths = QFileDialog::getOpenFileNames(
      window_, tr("Open recordings or a session"), folder,
      tr("Recordings and sessions (%1);;All files (*)")
          .arg(QStringLiteral("*.csv *.heft *.bag *.mcap *.db3 *.zstd *.h5 *.hdf5 *.jsonl *.json *.txt *.log")));
  open(paths);
}

void Files::open(const QStringList& paths) {
  const bool replaces = std::any_of(paths.begin(), paths.end(), [](const QString& path) {
    return path.endsWith(QLatin1String(kSessionExtension.data()), Qt::CaseInsensitive);
  });
  if (replaces && !mayClose()) return;
  if (paths.isEmpty()) return;
  emit opening();
  workspace_->open(paths);
}

void Files::editRig(const QString& recording) {
  const auto now = workspace_->opened();
  const QString path = recording.isEmpty() && now ? now->path : recording;
  if (path.isEmpty()) return emit said(Severity::info, tr("Open a recording first: robot and sensor belong to it."));
  const std::shared_ptr<const OpenRecording> opened = now && now->path == path ? now : nullptr;
  const auto meta = rigOf(path, opened.get());
  if (!meta) return emit said(Severity::error, QString::fromStdString(meta.error().message));
  auto* dialog = new RigDialog(
      path, *meta,
      [path, opened, before = *meta](const RecordingMeta& after) {
        const auto written = writeRig(path, opened.get(), before, after);
        return written ? QString() : QString::fromStdString(written.error().message);
      },
      window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, path] { open({path}); });
  dialog->open();
}

void Files::editSources(const QString& recording) {
  const auto now = workspace_->opened();
  const QString path = recording.isEmpty() && now ? now->path : recording;
  if (path.isEmpty()) return emit said(Severity::info, tr("Open a recording first: its columns belong to it."));
  auto* dialog = new SourcesDialog(path, window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, path] { open({path}); });
  dialog->open();
}

void Files::startAfresh() {
  if (mayClose()) workspace_->startAfresh();
}

bool Files::save() {
  return workspace_->sessionFile().isEmpty() ? saveAs() : workspace_->save(workspace_->sessionFile());
}

bool Files::saveAs() {
  const QString base = besideRecording();
  QString path = QFileDialog::getSaveFileName(window_, tr("Save session"), base.isEmpty() ? QString() : base + ".heft",
                                              tr("Heft sessions (*.heft)"));
  if (path.isEmpty()) return false;
  if (QFileInfo(path).suffix().isEmpty()) {
    path += ".heft";
    // The dialog asked about the name without the extension; this one it has not seen.
    if (QFileInfo::exists(path)) {
      emit said(Severity::error,
                tr("%1 already exists and was not overwritten. Choose it in the dialog to overwrite it.").arg(path));
      return false;
    }
  }
  if (!workspace_->save(path)) return false;
  remember(path);
  emit said(Severity::info, tr("Saved %1.").arg(path));
  return true;
}

bool Files::mayClose() {
  if (mayEnd_ && !mayEnd_()) return false;
  // A recording that was only opened is not worth a question.
  if (!remembers_ || workspace_->undoStack()->isClean()) return true;
  QMessageBox box(QMessageBox::NoIcon, tr("Heft Studio"), tr("Save changes to this session?"),
                  QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, window_);
  box.setInformativeText(tr("Unsaved marks, shape and settings will be lost."));
  const int answer = box.exec();
  return answer == QMessageBox::Discard || (answer == QMessageBox::Save && save());
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
    if (menu->isEmpty()) menu->addAction(tr("No recent files"))->setEnabled(false);
  });
}

QString Files::besideRecording() const {
  const auto opened = workspace_->opened();
  if (!opened) return {};
  const QFileInfo file(opened->path);
  return file.absolutePath() + "/" + file.completeBaseName();
}

void Files::tellSaved(const Result<bool>& written, const QString& path) {
  if (written) {
    emit said(Severity::info, tr("Saved %1.").arg(path));
  } else {
    emit said(Severity::error, QString::fromStdString(written.error().message));
  }
}

void Files::savePicture(const QImage& image, const QString& what) {
  const QString base = besideRecording();
  const QString path = QFileDialog::getSaveFileName(
      window_, tr("Save picture"), (base.isEmpty() ? QString() : base + "-") + what + ".png", tr("Pictures (*.png)"));
  if (path.isEmpty()) return;
  QBuffer bytes;
  bytes.open(QIODevice::WriteOnly);
  const QByteArray format = QFileInfo(path).suffix().toLatin1();
  image.save(&bytes, QImageWriter::supportedImageFormats().contains(format.toLower()) ? format.constData() : "png");
  tellSaved(writeTextFile(path.toStdString(), bytes.data().toStdString()), path);
}

void Files::saveText(const std::string& text, const QString& what, const QString& extension, const QString& filter) {
  const QString base = besideRecording();
  const QString path = QFileDialog::getSaveFileName(
      window_, tr("Save"), (base.isEmpty() ? QString() : base + "-") + what + extension, filter);
  if (path.isEmpty()) return;
  tellSaved(writeTextFile(path.toStdString(), text), path);
}

QStringList Files::dropped(const QMimeData* data) {
  QStringList paths;
  for (const QUrl& url : data->urls()) {
    if (url.isLocalFile()) paths << url.toLocalFile();
  }
  return paths;
}

}  // namespace heft
