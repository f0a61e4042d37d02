#include "ui/widgets/file_dialog_look.h"

#include <QApplication>
#include <QCoreApplication>
#include <QDir>
#include <QEvent>
#include <QFileDialog>
#include <QFileIconProvider>
#include <QFileInfo>
#include <QSplitter>
#include <QStandardPaths>
#include <QTreeView>
#include <QUrl>
#include <utility>

#include "ui/theme/icons.h"

namespace heft {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(FileDialogLook)
};

/// Folders, drives and files in the studio's lines and language.
class LineIcons : public QFileIconProvider {
 public:
  QIcon icon(IconType type) const override {
    return themedIcon(type == Folder                                         ? "folder"
                      : type == Computer || type == Drive || type == Network ? "drive"
                      : type == Desktop                                      ? "home"
                                                                             : "file");
  }
  QIcon icon(const QFileInfo& info) const override {
    return icon(info.isRoot() ? Drive : info.isDir() ? Folder : File);
  }
  QString type(const QFileInfo& info) const override {
    return info.isDir()              ? Words::tr("Folder")
           : info.suffix().isEmpty() ? Words::tr("File")
                                     : Words::tr("%1 file").arg(info.suffix());
  }
};

class FileDialogLook : public QObject {
 public:
  FileDialogLook(std::function<QStringList()> folders, QObject* parent)
      : QObject(parent), folders_(std::move(folders)) {}

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    // Not earlier: what an earlier dialog was like is restored after it is polished.
    if (event->type() != QEvent::Show || event->spontaneous()) return false;
    if (auto* dialog = qobject_cast<QFileDialog*>(watched)) dress(*dialog);
    return false;
  }

 private:
  void dress(QFileDialog& dialog) {
    constexpr QSize kRoomy(860, 540);  // [px]
    dialog.setIconProvider(&icons_);
    dialog.setViewMode(QFileDialog::Detail);
    QStringList places{QDir::homePath(), QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)};
    places += folders_();
    QList<QUrl> urls;
    for (const QString& place : places) {
      const QUrl url = QUrl::fromLocalFile(QDir::cleanPath(place));
      if (!place.isEmpty() && QFileInfo(place).isDir() && !urls.contains(url)) urls << url;
    }
    urls << QUrl(QStringLiteral("file:"));  // The computer
    dialog.setSidebarUrls(urls);
    dialog.resize(dialog.size().expandedTo(kRoomy));
    if (auto* splitter = dialog.findChild<QSplitter*>("splitter")) {
      constexpr int kPlaces = 180;  // [px]
      splitter->setSizes({kPlaces, dialog.width() - kPlaces});
    }
    // Names need most of the room.
    if (auto* tree = dialog.findChild<QTreeView*>("treeView")) {
      constexpr int kName = 300, kSize = 90;  // [px]
      tree->setColumnWidth(0, kName);
      tree->setColumnWidth(1, kSize);
      tree->setAlternatingRowColors(false);
    }
  }
  LineIcons icons_;
  std::function<QStringList()> folders_;
};

}  // namespace

void dressFileDialogs(std::function<QStringList()> folders) {
  static const QString kName = QStringLiteral("heftFileDialogLook");
  delete qApp->findChild<QObject*>(kName, Qt::FindDirectChildrenOnly);
  auto* look = new FileDialogLook(std::move(folders), qApp);
  look->setObjectName(kName);
  qApp->installEventFilter(look);
}

}  // namespace heft
