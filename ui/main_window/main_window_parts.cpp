// What the window is put together from, and who listens to whom.
#include "ui/main_window/main_window.h"

#include <QAbstractButton>
#include <QSplitter>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/controller/workspace.h"
#include "ui/main_window/files.h"
#include "ui/main_window/header_bar.h"
#include "ui/main_window/panels.h"
#include "ui/main_window/status_bar.h"
#include "ui/main_window/tour.h"
#include "ui/manual/manual.h"
#include "ui/robot_view/robot_view.h"
#include "ui/steps/step_bar.h"
#include "ui/widgets/message_bar.h"
#include "ui/wrench_plots/recording_pane.h"

namespace heft {

void MainWindow::assemble() {
  auto* window = new QWidget(this);
  window->setObjectName("window");
  auto* column = new QVBoxLayout(window);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  header_ = new HeaderBar(workspace_->undoStack(), window);
  column->addWidget(header_);
  steps_ = new StepBar(window);
  column->addWidget(steps_);
  message_ = new MessageBar(window);
  column->addWidget(message_);
  tour_ = new Tour(window);
  column->addWidget(tour_);
  connect(tour_, &Tour::stepWanted, this, &MainWindow::showStep);

  arrangement_ = new Arrangement(&playback_, window);
  view_ = arrangement_->view();
  pane_ = arrangement_->plots();
  followed_.push_back(pane_->jobs());
  column->addWidget(arrangement_->widget(), 1);
  status_ = new StatusBar(window);
  status_->follow(&workspace_->jobs());
  column->addWidget(status_);
  setCentralWidget(window);
}

void MainWindow::addPanels(const StudioMenus& menus) {
  StudioParts parts;
  parts.workspace = workspace_;
  parts.playback = &playback_;
  parts.view = view_;
  parts.plots = pane_;
  // "Continue" leads past a step that this build has no panel for.
  parts.goTo = [this](Step step) {
    while (!panels_.contains(step) && step < Step::exportFile) step = static_cast<Step>(static_cast<int>(step) + 1);
    showStep(step);
  };
  parts.say = [this](Severity severity, const QString& sentence) { message_->showMessage(severity, sentence); };
  parts.offer = [this](Severity severity, const QString& sentence, const QString& action,
                       std::function<void()> clicked) {
    message_->showMessage(severity, sentence, action, std::move(clicked));
  };
  parts.remember = [this](const QString& path) { files_->remember(path); };
  parts.editRig = [this] { files_->editRig(); };
  parts.savePicture = [this](const QImage& image, const QString& what) { files_->savePicture(image, what); };
  parts.asks = remembers_;
  parts.startTour = [this] { startTour(); };
  parts.chooseFiles = [this] { files_->choose(); };
  parts.recentFiles = [this] { return files_->recent(); };
  parts.followJobs = [this](JobRunner* runner) {
    followed_.push_back(runner);
    status_->follow(runner);
  };
  for (StepPanel* panel : makePanels(parts)) {
    panels_[panel->step()] = panel;
    arrangement_->addPanel(panel);
    steps_->addStep(panel->step());
    steps_->setState(panel->step(), panel->state());
    connect(panel, &StepPanel::stateChanged, this, [this, panel] {
      steps_->setState(panel->step(), panel->state());
      if (panel == panels_.value(step_)) status_->setHint(panel->hint());
      showFacts();
    });
    connect(panel, &StepPanel::arrangementChanged, this, [this, panel] {
      if (panel == panels_.value(step_)) arrangeFor(panel);
    });
    panel->addActions(menus);
  }
  files_->setMayEnd(
      [this] { return std::all_of(panels_.begin(), panels_.end(), [](StepPanel* panel) { return panel->mayEnd(); }); });
  panels_[step_]->entered();
  manual_ = new Manual([this](const QString& part) { return pictureOf(part); }, arrangement_->panels());
  arrangement_->panels()->addWidget(manual_);
  connect(manual_, &Manual::closeWanted, this, [this] { showManual(false); });
}

void MainWindow::connectParts() {
  connect(steps_, &StepBar::stepWanted, this, &MainWindow::showStep);
  connect(header_, &HeaderBar::detailsWanted, this, [this](bool shown) {
    details_ = shown;
    for (StepPanel* panel : panels_) panel->setDetailsShown(shown);
  });
  connect(files_, &Files::opening, message_, &MessageBar::clear);
  connect(files_, &Files::said, this,
          [this](Severity severity, const QString& sentence) { message_->showMessage(severity, sentence); });
  connect(workspace_, &Workspace::openedChanged, this, &MainWindow::showOpened);
  connect(workspace_, &Workspace::recordingsChanged, this, &MainWindow::showName);
  connect(workspace_, &Workspace::recordingsChanged, this, &MainWindow::showFacts);
  connect(workspace_, &Workspace::reportChanged, this, &MainWindow::showReport);
  connect(workspace_, &Workspace::marksChanged, this, &MainWindow::showMarks);
  connect(workspace_, &Workspace::failed, this, [this](const QString& sentence) {
    const auto opened = workspace_->opened();
    const bool noRobot =
        opened && opened->recording.hasJoints() && !opened->recording.hasOrientation() && !opened->robot;
    if (!noRobot) return message_->showMessage(Severity::error, sentence);
    message_->showMessage(Severity::error, sentence, tr("Robot and sensor …"), [this] { files_->editRig(); });
  });
  connect(workspace_, &Workspace::unreadable, this,
          [this](const QString& path, const QString& sentence, ReadCure cure) {
            if (cure == ReadCure::sources)
              message_->showMessage(Severity::error, sentence, tr("Choose columns and units …"),
                                    [this, path] { files_->editSources(path); });
            if (cure == ReadCure::rig)
              message_->showMessage(Severity::error, sentence, tr("Robot and sensor …"),
                                    [this, path] { files_->editRig(path); });
          });
  connect(&playback_, &Playback::timeChanged, view_, &RobotView::showTime);
  connect(view_, &RobotView::pictureWanted, this, [this] { files_->savePicture(view_->picture(), tr("view")); });
  connect(pane_, &RecordingPane::csvWanted, this,
          [this] { files_->saveText(pane_->visibleText(), tr("visible"), ".csv", tr("Tables (*.csv)")); });
  for (auto* button : findChildren<QAbstractButton*>("aloneButton"))
    connect(button, &QAbstractButton::clicked, this, [this, button] {
      const Alone what = view_->isAncestorOf(button) ? Alone::view : Alone::below;
      showAlone(alone() == what ? Alone::nothing : what);
    });
  connect(pane_, &RecordingPane::unfoldWanted, arrangement_, &Arrangement::unfoldPlots);
  connect(pane_, &RecordingPane::pictureWanted, this,
          [this] { files_->savePicture(pane_->grab().toImage(), tr("plots")); });
}

}  // namespace heft
