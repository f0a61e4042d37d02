#include "ui/main_window/main_window.h"

#include <QAbstractButton>
#include <QApplication>
#include <QCloseEvent>
#include <QDir>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileInfo>
#include <QKeyEvent>
#include <QLocale>
#include <QMenu>
#include <QPointer>
#include <QSettings>
#include <QStackedWidget>
#include <QTimer>
#include <QVariant>
#include <algorithm>

#include "ui/controller/autosave.h"
#include "ui/controller/workspace.h"
#include "ui/main_window/arrangement.h"
#include "ui/main_window/files.h"
#include "ui/main_window/header_bar.h"
#include "ui/main_window/menus.h"
#include "ui/main_window/preferences.h"
#include "ui/main_window/recovery.h"
#include "ui/main_window/screen_room.h"
#include "ui/main_window/status_bar.h"
#include "ui/main_window/tab_way.h"
#include "ui/main_window/tour.h"
#include "ui/manual/manual.h"
#include "ui/models/numbers.h"
#include "ui/robot_view/robot_view.h"
#include "ui/steps/step_bar.h"
#include "ui/theme/icons.h"
#include "ui/widgets/file_dialog_look.h"
#include "ui/widgets/message_bar.h"
#include "ui/widgets/wheel_guard.h"
#include "ui/wrench_plots/recording_pane.h"

namespace heft {
namespace {

constexpr double kKeyStep = 0.1;  ///< [s] an arrow key moves the time

}  // namespace

MainWindow::MainWindow(Workspace* workspace, bool remembers, QWidget* parent)
    : QMainWindow(parent), workspace_(workspace), remembers_(remembers), files_(new Files(workspace, remembers, this)) {
  setObjectName("mainWindow");
  setWindowTitle(tr("Heft Studio"));
  setWindowIcon(applicationIcon());
  setAcceptDrops(true);
  guardWheel();
  dressFileDialogs([session = QPointer<Workspace>(workspace)] {
    QStringList folders{recordedFolder()};
    const auto opened = session ? session->opened() : nullptr;
    if (opened) folders << QFileInfo(opened->path).absolutePath();
    return folders;
  });
  // Not larger than a small laptop's screen, its frame included.
  const QSize room = roomOnScreen();
  resize(QSize(1440, 900).boundedTo(room));
  setMinimumSize(QSize(960, 600).boundedTo(room));
  assemble();
  MenuBuilder builder(this);
  const StudioMenus menus = builder.build(header_->menuBar());
  addPanels(menus);
  builder.finish(header_->menuBar(), menus);
  connectParts();
  if (remembers_) restoreGeometry(QSettings().value("window/geometry").toByteArray());
  showOpened();
}

MainWindow::~MainWindow() = default;

QVector<QWidget*> MainWindow::tabParts() const {
  return {header_, steps_, message_, tour_, view_, arrangement_->below(), arrangement_->panels()};
}

bool MainWindow::focusNextPrevChild(bool next) {
  return focusNext(*this, tabParts(), next) || QMainWindow::focusNextPrevChild(next);
}

void MainWindow::loadArm() {
  lookJobs_.start(
      QString(),
      [](const Progress& progress) -> Result<std::shared_ptr<const RobotLook>> {
        Findings findings;
        return pandaLook(findings, progress);
      },
      [this](Result<std::shared_ptr<const RobotLook>> look) {
        // A recording opened in the meantime may have its own arm; the view keeps this one for recordings without.
        if (look)
          view_->showRobot(std::shared_ptr<const RobotModel>(std::shared_ptr<void>(), &RobotModel::panda()), *look);
      });
}

void MainWindow::showStep(Step step) {
  StepPanel* panel = panels_.value(step);
  if (panel && manualShown()) showManual(false);
  if (!panel || step == step_) return;
  StepPanel* before = panels_.value(step_);
  arrangement_->keepSizes(step_);
  const bool hadFocus = arrangement_->panels()->isAncestorOf(QApplication::focusWidget());
  before->left();
  step_ = step;
  workspace_->setStep(QString::fromUtf8(stepId(step).data()));
  arrangement_->panels()->setCurrentWidget(panel);
  steps_->setNow(step);
  tour_->setStep(step);
  arrangeFor(panel);
  status_->setHint(panel->hint());
  panel->entered();
  // Who goes on by keyboard goes on in the new panel.
  if (!hadFocus) return;
  const QVector<QWidget*> way = tabWay(*this, {arrangement_->panels()});
  if (!way.isEmpty()) way.front()->setFocus(Qt::OtherFocusReason);
}

void MainWindow::showAlone(Alone what) {
  if (!arrangement_->mayStandAlone(what)) return;
  arrangement_->keepSizes(step_);
  if (what == Alone::nothing) return arrangeFor(panels_[step_]);
  arrangement_->showAlone(what);
}

void MainWindow::editPreferences() {
  QList<QPair<QString, QString>> languages;
  Preferences::Choice now{{}, theme().dark ? ThemeKind::dark : ThemeKind::light, recordedFolder(), units()};
  for (const QAction* action : languages_->actions()) {
    languages << qMakePair(action->data().toString(), action->text());
    if (action->isChecked()) now.language = action->data().toString();
  }
  Preferences dialog(now, languages, header_->menuBar(), this);
  if (dialog.exec() != QDialog::Accepted) return;
  const Preferences::Choice wanted = dialog.choice();
  if (QDir::isAbsolutePath(wanted.folder) && wanted.folder != now.folder) {
    setRecordedFolder(wanted.folder);
    if (remembers_) QSettings().setValue("files/recordings", wanted.folder);
  }
  if (wanted.theme != now.theme) emit themeWanted(wanted.theme);
  // A change of units or language replaces the window: this call must return first.
  if (wanted.units != now.units) QTimer::singleShot(0, this, [this, units = wanted.units] { emit unitsWanted(units); });
  if (wanted.language != now.language)
    QTimer::singleShot(0, this, [this, code = wanted.language] { emit languageWanted(code); });
}

void MainWindow::arrangeFor(StepPanel* panel) { arrangement_->show(panel, workspace_->opened() != nullptr); }

bool MainWindow::settled() const {
  return !workspace_->busy() && !lookJobs_.running() &&
         std::none_of(followed_.begin(), followed_.end(), [](const JobRunner* runner) { return runner->running(); });
}

void MainWindow::showDetails(bool shown) { header_->setDetails(shown); }

bool MainWindow::manualShown() const { return manual_ && arrangement_->panels()->currentWidget() == manual_; }

void MainWindow::showManual(bool shown) {
  if (!shown) return arrangement_->panels()->setCurrentWidget(panels_[step_]);
  arrangement_->panels()->setCurrentWidget(manual_);
  manual_->open(QString::fromUtf8(stepId(step_).data()));
}

QImage MainWindow::pictureOf(const QString& part) {
  if (part == "window") return picture();
  if (part == "view") return view_->picture();
  // What stands under the 3D view: in the reality check, the difference.
  if (part == "plots") return arrangement_->below()->currentWidget()->grab().toImage();
  if (part == "panel") return arrangement_->panels()->grab().toImage();
  if (part == "steps") return steps_->grab().toImage();
  const auto step = stepFromId(part.toStdString());
  StepPanel* panel = step ? panels_.value(*step) : nullptr;
  return panel ? arrangement_->pictureOf(panel) : QImage();
}

QImage MainWindow::picture() {
  view_->renderNow();
  return grab().toImage();
}

void MainWindow::keepUnderWay() {
  for (StepPanel* panel : panels_) panel->keepUnderWay();
}

void MainWindow::useAutosave(Autosave* autosave) {
  new Recovery(autosave, {workspace_, files_, message_, status_}, this);
}

void MainWindow::showOpened() {
  const auto opened = workspace_->opened();
  if (!opened) return showNothing();
  const Recording& recording = opened->recording;
  const std::shared_ptr<const Recording> shared(opened, &recording);
  showName();
  view_->showRecording(shared, opened->robot, opened->look);
  pane_->setRecording(shared, workspace_->report(), opened->robot);
  rate_ = shared->rateHz();
  showFacts();
  files_->remember(opened->path);
  if (step_ == Step::record && !tour_->running()) {
    // A session comes back where it was left.
    const auto kept = stepFromId(workspace_->session().step);
    showStep(kept && *kept != Step::record && panels_.contains(*kept) ? *kept : Step::result);
  } else if (!arrangement_->below()->isVisible()) {
    arrangeFor(panels_[step_]);
  }
  showEstimated();
}

void MainWindow::showName() {
  const auto opened = workspace_->opened();
  const QString name = opened ? workspace_->nameOf(workspace_->session().active) : QString();
  header_->setFileName(name, opened ? opened->path : QString());
  setWindowTitle(opened ? tr("%1 – Heft Studio").arg(name) : tr("Heft Studio"));
}

void MainWindow::startTour() {
  tour_->begin();
  showStep(Step::record);
  if (StepPanel* record = panel(Step::record)) record->obey({"sample", "hose"});
}

void MainWindow::showFacts() {
  QStringList facts;
  for (const StepPanel* panel : panels_) facts << panel->facts();
  facts.removeAll({});
  const auto opened = workspace_->opened();
  // What is under way is not the recording that was open before.
  if (!facts.isEmpty()) return status_->setFacts(facts.join(QStringLiteral(" · ")));
  if (opened) {
    const Recording& recording = opened->recording;
    facts << workspace_->nameOf(workspace_->session().active);
    if (recording.meta.kind == RecordingKind::poses) {
      facts << tr("%1 standing poses").arg(recording.rows());
    } else {
      facts << tr("%1 s").arg(numberText(recording.duration(), 1)) << tr("%1 Hz").arg(numberText(rate_, 0));
    }
    if (!recording.meta.sensorModel.empty()) facts << QString::fromStdString(recording.meta.sensorModel);
  } else {
    facts << tr("No recording open");
  }
  status_->setFacts(facts.join(QStringLiteral(" · ")));
}

void MainWindow::showNothing() {
  showName();
  showFacts();
  pane_->setRecording(nullptr, nullptr);
  view_->showNothing();
  showStep(Step::record);
  arrangeFor(panels_[step_]);
  loadArm();
}

void MainWindow::showReport() {
  const auto opened = workspace_->opened();
  if (!opened) return;
  pane_->setReport(workspace_->report());
  showEstimated();
}

void MainWindow::showEstimated() {
  view_->showReport(workspace_->report());
  showMarks();
}

void MainWindow::showMarks() {
  if (!workspace_->opened()) return;
  const std::vector<Segment> segments = workspace_->segments();
  std::vector<bool> suggested;
  for (const Segment& segment : segments) suggested.push_back(workspace_->suggested(segment));
  pane_->setSegments(segments, suggested);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (!Files::dropped(event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  const QStringList paths = Files::dropped(event->mimeData());
  if (paths.isEmpty()) return;
  event->acceptProposedAction();
  files_->open(paths);
}

/// As in a dialog: it presses the button that has the focus, or else the filled one; what is being typed ends there.
void MainWindow::pressEnter() {
  QWidget* focus = QApplication::focusWidget();
  if (auto* button = qobject_cast<QAbstractButton*>(focus)) return button->click();
  for (const char* typed : {"QLineEdit", "QAbstractSpinBox", "QComboBox", "QAbstractItemView", "QTextEdit"})
    if (focus && focus->inherits(typed)) return;
  auto* main = arrangement_->panels()->currentWidget()->findChild<QAbstractButton*>("mainButton");
  if (main && main->isVisible() && main->isEnabled()) main->click();
}

void MainWindow::keyPressEvent(QKeyEvent* event) {
  // Keys that reach the window were not wanted by the focused control; a focused button keeps its Space.
  const double step = pane_->timeAxis()->poses()                 ? 1.0
                      : (event->modifiers() & Qt::ShiftModifier) ? 10 * kKeyStep
                                                                 : kKeyStep;
  const auto goToTime = [this](double time) {
    playback_.setTime(time);
    pane_->timeAxis()->reveal(playback_.time());
  };
  if (panels_[step_]->keyPressed(event)) return;
  switch (event->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
      return pressEnter();
    case Qt::Key_F6:
      return focusNextPart(*this, tabParts(), event->modifiers() & Qt::ShiftModifier ? -1 : 1);
    case Qt::Key_Escape:
      if (alone() != Alone::nothing) return showAlone(Alone::nothing);
      return QMainWindow::keyPressEvent(event);
    case Qt::Key_Space:
      playback_.toggle();
      return;
    case Qt::Key_Left:
      return goToTime(playback_.time() - step);
    case Qt::Key_Right:
      return goToTime(playback_.time() + step);
    case Qt::Key_Home:
      return goToTime(playback_.lower());
    case Qt::Key_End:
      return goToTime(playback_.upper());
    default:
      QMainWindow::keyPressEvent(event);
  }
}

void MainWindow::setLanguages(const QStringList& codes, const QString& current) {
  languages_->clear();
  for (const QString& code : codes) {
    // Each language in its own words, so that everybody finds theirs.
    QString name = QLocale(code).nativeLanguageName();
    if (code == QLatin1String("en")) name = QStringLiteral("English");
    QAction* action = languages_->addAction(name, this, [this, code] { emit languageWanted(code); });
    action->setCheckable(true);
    action->setChecked(code == current);
    action->setData(code);
  }
}

void MainWindow::showEvent(QShowEvent* event) {
  QMainWindow::showEvent(event);
  // Only now the splitters have a height to share out.
  if (!arranged_)
    QTimer::singleShot(0, this, [this] {
      keepOnScreen(this);
      arrangeFor(panels_[step_]);
    });
  arranged_ = true;
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!files_->mayClose()) return event->ignore();
  if (remembers_) QSettings().setValue("window/geometry", saveGeometry());
  QMainWindow::closeEvent(event);
}

}  // namespace heft
