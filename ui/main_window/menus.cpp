#include "ui/main_window/menus.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QMessageBox>
#include <QUndoStack>

#include "ui/controller/workspace.h"
#include "ui/main_window/files.h"
#include "ui/main_window/main_window.h"
#include "ui/robot_view/robot_view.h"
#include "ui/theme/icons.h"
#include "ui/wrench_plots/recording_pane.h"

namespace heft {

StudioMenus MenuBuilder::build(QMenuBar* bar) {
  const StudioMenus menus{bar->addMenu(tr("&File")),  bar->addMenu(tr("&Edit")),     bar->addMenu(tr("&View")),
                          bar->addMenu(tr("&Tools")), bar->addMenu(tr("&Practice")), bar->addMenu(tr("&Help"))};
  buildFile(menus.file);
  buildEdit(menus.edit);
  buildView(menus.view);
  buildTools(menus.tools);
  buildHelp(menus.help);
  return menus;
}

void MenuBuilder::finish(QMenuBar*, const StudioMenus& menus) {
  QMenu* steps = menus.view->addMenu(tr("&Go to step"));
  for (const Step step : kAllSteps) {
    if (!w_->panel(step)) continue;
    QAction* action = steps->addAction(stepName(step), w_, [w = w_, step] { w->showStep(step); });
    action->setShortcut(QKeySequence(QStringLiteral("Alt+%1").arg(static_cast<int>(step) + 1)));
  }
  menus.file->addSeparator();
  QAction* quit = menus.file->addAction(tr("&Quit"), w_, &QWidget::close);
  quit->setShortcut(QKeySequence::Quit);
  if (menus.practice->isEmpty()) menus.practice->menuAction()->setVisible(false);
}

void MenuBuilder::buildFile(QMenu* menu) {
  menu->addAction(tr("&New"), w_->files_, &Files::startAfresh)->setShortcut(QKeySequence::New);
  QAction* open = menu->addAction(tr("&Open …"), w_->files_, &Files::choose);
  open->setShortcut(QKeySequence::Open);
  open->setObjectName("openFiles");
  w_->files_->fillRecent(menu->addMenu(tr("Open &recent")));
  menu->addSeparator();
  menu->addAction(tr("&Save session"), w_->files_, &Files::save)->setShortcut(QKeySequence::Save);
  menu->addAction(tr("Save session &as …"), w_->files_, &Files::saveAs)->setShortcut(QKeySequence("Ctrl+Shift+S"));
  menu->addSeparator();
  QAction* payload = menu->addAction(tr("Export payload &file …"), w_, [w = w_] { w->showStep(Step::exportFile); });
  payload->setShortcut(QKeySequence("Ctrl+E"));
  QMenu* pictures = menu->addMenu(tr("Save &picture"));
  const std::pair<QString, const char*> parts[] = {
      {tr("&Window …"), "window"}, {tr("3D &view …"), "view"}, {tr("&Plots …"), "plots"}, {tr("Pan&el …"), "panel"}};
  for (const auto& [text, part] : parts)
    pictures->addAction(text, w_, [w = w_, name = QString(part)] { w->files_->savePicture(w->pictureOf(name), name); });
}

void MenuBuilder::buildEdit(QMenu* menu) {
  QUndoStack* stack = w_->workspace_->undoStack();
  QAction* undo = stack->createUndoAction(w_, tr("&Undo"));
  undo->setShortcut(QKeySequence::Undo);
  QAction* redo = stack->createRedoAction(w_, tr("&Redo"));
  redo->setShortcuts({QKeySequence("Ctrl+Y"), QKeySequence("Ctrl+Shift+Z")});
  menu->addAction(undo);
  menu->addAction(redo);
  menu->addSeparator();
  QAction* preferences = menu->addAction(tr("&Preferences …"), w_, [w = w_] { w->editPreferences(); });
  preferences->setObjectName("editPreferences");
  preferences->setShortcut(QKeySequence("Ctrl+,"));
}

void MenuBuilder::buildView(QMenu* menu) {
  const auto addView = [&](const QString& text, const QKeySequence& key, RobotView::Preset preset) {
    menu->addAction(text, w_, [w = w_, preset] { w->view_->usePreset(preset); })->setShortcut(key);
  };
  addView(tr("Zoom to &whole arm"), Qt::Key_F, RobotView::Preset::overview);
  addView(tr("Zoom to &tool"), Qt::Key_T, RobotView::Preset::tool);
  addView(tr("Fro&nt"), QKeySequence("Ctrl+1"), RobotView::Preset::front);
  addView(tr("&Side"), QKeySequence("Ctrl+2"), RobotView::Preset::side);
  addView(tr("T&op"), QKeySequence("Ctrl+3"), RobotView::Preset::top);
  menu->addSeparator();
  menu->addAction(tr("Zoom to whole &recording"), w_, [w = w_] { w->pane_->timeAxis()->showAll(); })
      ->setShortcut(QKeySequence("Ctrl+0"));
  using Alone = MainWindow::Alone;
  const auto addAlone = [&](const QString& text, const QKeySequence& key, Alone what) {
    menu->addAction(text, w_, [w = w_, what] { w->showAlone(w->alone() == what ? Alone::nothing : what); })
        ->setShortcut(key);
  };
  addAlone(tr("Maximise &plots"), Qt::Key_F11, Alone::below);
  addAlone(tr("Maximise 3D &view"), QKeySequence("Shift+F11"), Alone::view);
  QAction* details = menu->addAction(tr("D&etails"), w_, [w = w_] { w->showDetails(!w->detailsShown()); });
  details->setShortcut(QKeySequence("Ctrl+D"));
  menu->addSeparator();
  auto* themes = new QActionGroup(menu);
  const std::pair<QString, ThemeKind> kinds[] = {{tr("&Light"), ThemeKind::light}, {tr("&Dark"), ThemeKind::dark}};
  for (const auto& [text, kind] : kinds) {
    QAction* action = menu->addAction(text, w_, [w = w_, k = kind] { emit w->themeWanted(k); });
    action->setCheckable(true);
    action->setChecked(theme().dark == (kind == ThemeKind::dark));
    themes->addAction(action);
  }
  w_->languages_ = menu->addMenu(tr("L&anguage"));
  menu->addSeparator();
}

void MenuBuilder::buildTools(QMenu* menu) {
  QAction* again = menu->addAction(tr("&Estimate again"), w_->workspace_, &Workspace::estimate);
  again->setShortcut(QKeySequence("Ctrl+R"));
  QAction* stop = menu->addAction(tr("S&top the current task"), w_->workspace_, &Workspace::cancel);
  menu->addSeparator();
  QAction* rig = menu->addAction(tr("&Robot and sensor …"), w_, [w = w_] { w->files_->editRig(); });
  QAction* sources = menu->addAction(tr("Columns and &units …"), w_, [w = w_] { w->files_->editSources(); });
  rig->setObjectName("editRig");
  sources->setObjectName("editSources");
  QObject::connect(menu, &QMenu::aboutToShow, w_, [w = w_, again, stop, rig, sources] {
    for (QAction* each : {again, rig, sources}) each->setEnabled(w->workspace_->opened() != nullptr);
    stop->setEnabled(w->workspace_->busy());
  });
}

void MenuBuilder::buildHelp(QMenu* menu) {
  menu->addAction(tr("&Manual"), w_, [w = w_] { w->showManual(!w->manualShown()); })
      ->setShortcut(QKeySequence(Qt::Key_F1));
  menu->addAction(tr("&Tour with a sample"), w_, &MainWindow::startTour)->setObjectName("startTour");
  menu->addSeparator();
  QAction* about = menu->addAction(tr("&About Heft Studio"), w_, [w = w_] {
    QMessageBox box(w);
    box.setWindowTitle(tr("About Heft Studio"));
    box.setIconPixmap(applicationIcon().pixmap(48, 48));
    box.setText(tr("Heft Studio %1").arg(QCoreApplication::applicationVersion()));
    box.setInformativeText(
        tr("Estimates the mass, centre of mass and inertia of a robot’s payload. Heft’s source is under the Apache "
           "License 2.0; this program links QCustomPlot and may be redistributed under the GNU General Public License, "
           "version 3 or later."));
    box.exec();
  });
  about->setObjectName("about");
}

}  // namespace heft
