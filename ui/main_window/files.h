#pragma once
// Files from the window's side: choosing, opening, what was opened lately, saving pictures.
#include <QImage>
#include <QObject>
#include <QStringList>
#include <functional>
#include <string>

#include "core/base/findings.h"

class QMenu;
class QMimeData;
class QWidget;

namespace heft {

class Workspace;

class Files : public QObject {
  Q_OBJECT
 public:
  /// Dialogs belong to `window`. With `remembers` false recent files are neither read nor kept.
  Files(Workspace* workspace, bool remembers, QWidget* window);

  /// Recordings or a session.
  void choose();
  /// A new, empty session; asks first where something would be lost.
  void startAfresh();
  /// Saves the session where it lives, or asks where; true once it is saved.
  bool save();
  bool saveAs();
  /// What else is asked before a session is closed: whether what is under way may end.
  void setMayEnd(std::function<bool()> mayEnd) { mayEnd_ = std::move(mayEnd); }
  /// True if the session may be closed: saved, unchanged, or given up by the user.
  bool mayClose();
  void open(const QStringList& paths);
  /// Robot and sensor of a recording, in a dialog; what is said goes into its setup file. Empty: the one that is open.
  void editRig(const QString& recording = {});
  /// The meaning of its columns, also in a dialog; saved in its map file.
  void editSources(const QString& recording = {});
  QStringList recent() const;
  void remember(const QString& path);
  /// Fills `menu` with the recent files whenever it opens.
  void fillRecent(QMenu* menu);
  /// Asks where to, beside the recording, and saves; `what` becomes part of the name.
  void savePicture(const QImage& image, const QString& what);

  /// The same for text.
  void saveText(const std::string& text, const QString& what, const QString& extension, const QString& filter);

  /// The local files of a drop.
  static QStringList dropped(const QMimeData* data);

 signals:
  void opening();
  void said(heft::Severity severity, const QString& sentence);

 private:
  void tellSaved(const Result<bool>& written, const QString& path);
  /// Folder and beginning of a name beside the open recording.
  QString besideRecording() const;

  Workspace* workspace_;
  bool remembers_;
  std::function<bool()> mayEnd_;
  QWidget* window_;
};

}  // namespace heft
