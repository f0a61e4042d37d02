#pragma once
// Assembles header, 3D view, plots, panel and status line, and joins them to the workspace.
#include <QMainWindow>
#include <memory>

#include "ui/jobs/job_runner.h"
#include "ui/robot_view/robot_look.h"
#include "ui/theme/theme.h"
#include "ui/timeline/playback.h"

class QMenu;
class QSplitter;

namespace heft {

class HeaderBar;
class MessageBar;
class RecordingPane;
class ResultPanel;
class RobotView;
class StatusBar;
class Workspace;

class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  /// `workspace` must outlive the window. With `remembers` false neither recent files nor sizes are read or kept.
  MainWindow(Workspace* workspace, bool remembers, QWidget* parent = nullptr);
  ~MainWindow() override;

  Playback* playback() { return &playback_; }
  RecordingPane* recordingPane() { return pane_; }
  RobotView* robotView() { return view_; }
  ResultPanel* resultPanel() { return panel_; }
  MessageBar* messageBar() { return message_; }

  /// True once the arm's shape is loaded and nothing is under way: the picture will not change by itself.
  bool settled() const;
  /// Also the engineer's numbers.
  void showDetails(bool shown);
  /// The whole window as it looks now, 3D included.
  QImage picture();

 signals:
  void themeWanted(heft::ThemeKind kind);

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

 private:
  void buildMenus();
  void chooseFile();
  void open(const QString& path);
  void showOpened();
  void showReport();
  void showFailure(const QString& sentence);
  void savePayload();
  void savePicture(const QImage& picture, const QString& what);
  QStringList recentFiles() const;
  void rememberFile(const QString& path);
  void fillRecentMenu();

  Workspace* workspace_;
  bool remembers_;
  Playback playback_;
  JobRunner lookJobs_;  ///< Loads the arm that stands there before a recording is open.
  HeaderBar* header_;
  MessageBar* message_;
  RobotView* view_;
  RecordingPane* pane_;
  ResultPanel* panel_;
  StatusBar* status_;
  QSplitter* across_;
  QSplitter* down_;
  QMenu* recent_ = nullptr;
};

}  // namespace heft
