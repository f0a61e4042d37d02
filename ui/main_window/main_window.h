#pragma once
// Assembles header, step bar, 3D view, plots, the steps' panels and the status line, and switches between the steps.
#include <QMainWindow>
#include <QMap>
#include <memory>
#include <vector>

#include "ui/jobs/job_runner.h"
#include "ui/main_window/arrangement.h"
#include "ui/models/units.h"
#include "ui/robot_look/robot_look.h"
#include "ui/steps/step_panel.h"
#include "ui/theme/theme.h"
#include "ui/timeline/playback.h"

class QMenu;

namespace heft {

class Autosave;
class Files;
class HeaderBar;
class Manual;
class MessageBar;
class RecordingPane;
class RobotView;
class StatusBar;
class StepBar;
class Tour;
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
  MessageBar* messageBar() { return message_; }
  StepBar* stepBar() { return steps_; }
  /// Null if the step has no panel.
  StepPanel* panel(Step step) const { return panels_.value(step); }

  /// Shows a step's panel; nothing happens if it has none.
  void showStep(Step step);
  Step step() const { return step_; }

  /// Which languages the menu offers, and which one is active.
  void setLanguages(const QStringList& codes, const QString& current);
  /// Recordings under way are ended and kept; nothing is asked.
  void keepUnderWay();
  /// Shows when it saved, and offers what an earlier program left behind. Must outlive the window.
  void useAutosave(Autosave* autosave);

  /// True once the arm's shape is loaded and nothing is under way: the picture will not change by itself.
  bool settled() const;
  /// The manual in place of the panel, at the chapter of the step shown.
  void showManual(bool shown);
  bool manualShown() const;
  /// A part as it looks now: window, view, plots, panel, steps, or the panel of a step by its id; null for other names.
  QImage pictureOf(const QString& part);
  /// Also the engineer's numbers.
  void showDetails(bool shown);
  bool detailsShown() const { return details_; }
  /// Opens a sample and leads through the steps with it.
  void startTour();
  /// One pane beside header and steps, without the rest; nothing: all of them again.
  using Alone = Arrangement::Alone;
  void showAlone(Alone what);
  Alone alone() const { return arrangement_->alone(); }
  /// The whole window as it looks now, 3D included.
  QImage picture();

 signals:
  void themeWanted(heft::ThemeKind kind);
  void languageWanted(const QString& code);
  void unitsWanted(const heft::UnitChoice& units);

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void showEvent(QShowEvent* event) override;
  bool focusNextPrevChild(bool next) override;

 private:
  friend class MenuBuilder;  ///< Joins the menus to the parts.
  void assemble();
  void addPanels(const StudioMenus& menus);
  void connectParts();
  void showOpened();
  void showNothing();
  void showReport();
  void showEstimated();
  void showMarks();
  void showName();
  void showFacts();
  void loadArm();
  void arrangeFor(StepPanel* panel);
  QVector<QWidget*> tabParts() const;
  void pressEnter();
  void editPreferences();

  Workspace* workspace_;
  bool remembers_;
  bool details_ = false;
  double rate_ = 0.0;  ///< Of the open recording [Hz]; the median of its steps takes a while where there are many.
  Step step_ = Step::record;
  Playback playback_;
  JobRunner lookJobs_;  ///< Loads the arm that stands there before a recording is open.
  std::vector<JobRunner*> followed_;
  Files* files_;
  HeaderBar* header_ = nullptr;
  StepBar* steps_ = nullptr;
  MessageBar* message_ = nullptr;
  Tour* tour_ = nullptr;
  Arrangement* arrangement_ = nullptr;
  RobotView* view_ = nullptr;
  RecordingPane* pane_ = nullptr;
  StatusBar* status_ = nullptr;
  Manual* manual_ = nullptr;
  QMenu* languages_ = nullptr;
  bool arranged_ = false;
  QMap<Step, StepPanel*> panels_;
};

}  // namespace heft
