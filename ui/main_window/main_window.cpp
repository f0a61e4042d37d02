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
#include <QScreen>
#include <QScrollArea>
#include <QSettings>
#include <QSplitter>
#include <QStackedWidget>
#include <QTimer>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

#include "ui/controller/autosave.h"
#include "ui/controller/unfinished.h"
#include "ui/controller/workspace.h"
#include "ui/main_window/files.h"
#include "ui/main_window/header_bar.h"
#include "ui/main_window/menus.h"
#include "ui/main_window/panels.h"
#include "ui/main_window/preferences.h"
#include "ui/main_window/status_bar.h"
#include "ui/main_window/tab_way.h"
#include "ui/main_window/tour.h"
#include "ui/manual/manual.h"
#include "ui/models/numbers.h"
#include "ui/robot_view/robot_view.h"
#include "ui/steps/step_bar.h"
#include "ui/theme/icons.h"
#include "ui/widgets/message_bar.h"
#include "ui/widgets/wheel_guard.h"
#include "ui/wrench_plots/recording_pane.h"

namespace heft {
namespace {

constexpr int kPanelWidth = 440;
constexpr double kKeyStep = 0.1;  ///< [s] an arrow key moves the time
/// [px] What a window manager's frame takes, before it is known: title bar and edges.
constexpr QSize kFrame(12, 44);

QSize roomOnScreen() {
  const QScreen* screen = QGuiApplication::primaryScreen();
  return screen ? screen->availableSize() - kFrame : QSize(1440, 900);
}

}  // namespace

MainWindow::MainWindow(Workspace* workspace, bool remembers, QWidget* parent)
    : QMainWindow(parent), workspace_(workspace), remembers_(remembers), files_(new Files(workspace, remembers, this)) {
  setObjectName("mainWindow");
  setWindowTitle(tr("Heft Studio"));
  setWindowIcon(applicationIcon());
  setAcceptDrops(true);
  guardWheel();
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

  across_ = new QSplitter(Qt::Horizontal, window);
  down_ = new QSplitter(Qt::Vertical, across_);
  for (QSplitter* splitter : {across_, down_}) {
    splitter->setChildrenCollapsible(false);
    splitter->setHandleWidth(5);  // Wide enough to be caught; the sheet draws it as one line.
  }
  view_ = new RobotView(down_);
  below_ = new QStackedWidget(down_);
  pane_ = new RecordingPane(&playback_, below_);
  followed_.push_back(pane_->jobs());
  below_->addWidget(pane_);
  below_->hide();
  panelStack_ = new QStackedWidget(across_);
  // A wider window makes the picture wider; a higher one makes both higher.
  across_->setStretchFactor(0, 1);
  across_->setStretchFactor(1, 0);
  across_->setSizes({1000, kPanelWidth});
  column->addWidget(across_, 1);
  status_ = new StatusBar(window);
  status_->follow(&workspace_->jobs());
  column->addWidget(status_);
  setCentralWidget(window);
}

bool MainWindow::focusNextPrevChild(bool next) {
  const QVector<QWidget*> way = tabWay(*this, {header_, steps_, message_, tour_, view_, below_, panelStack_});
  if (way.isEmpty()) return QMainWindow::focusNextPrevChild(next);
  const int at = way.indexOf(QApplication::focusWidget()), count = way.size();
  const int to = at < 0 ? (next ? 0 : count - 1) : (at + (next ? 1 : count - 1)) % count;
  way[to]->setFocus(next ? Qt::TabFocusReason : Qt::BacktabFocusReason);
  for (QWidget* p = way[to]->parentWidget(); p; p = p->parentWidget())
    if (auto* area = qobject_cast<QScrollArea*>(p)) area->ensureWidgetVisible(way[to]);
  return true;
}

/// The next of the window's parts that takes the keyboard, as in other programs.
void MainWindow::focusNextPart(int by) {
  const QVector<QWidget*> parts{header_, steps_, message_, tour_, view_, below_, panelStack_};
  const int count = static_cast<int>(parts.size());
  int at = 0;
  for (int k = 0; k < count; ++k)
    if (parts[k]->isAncestorOf(QApplication::focusWidget())) at = k;
  for (int k = 1; k <= count; ++k) {
    QWidget* part = parts[((at + by * k) % count + count) % count];
    if (!part->isVisible()) continue;
    for (QWidget* each : tabWay(*this, {part}))
      if (part->isAncestorOf(each)) return each->setFocus(Qt::TabFocusReason);
  }
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
    panelStack_->addWidget(panel);
    if (QWidget* own = panel->ownPane()) below_->addWidget(own);
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
  manual_ = new Manual([this](const QString& part) { return pictureOf(part); }, panelStack_);
  panelStack_->addWidget(manual_);
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
      showAlone(alone_ == what ? Alone::nothing : what);
    });
  connect(pane_, &RecordingPane::unfoldWanted, this, [this] {
    pane_->setFolded(false);
    below_->setMaximumHeight(QWIDGETSIZE_MAX);
    down_->setSizes({down_->height() * 6 / 10, down_->height() * 4 / 10});
  });
  connect(pane_, &RecordingPane::pictureWanted, this,
          [this] { files_->savePicture(pane_->grab().toImage(), tr("plots")); });
}

void MainWindow::loadArm() {
  lookJobs_.start(
      QString(),
      [](const Progress& progress) -> Result<std::shared_ptr<const RobotLook>> {
        Findings findings;
        return pandaLook(findings, progress);
      },
      [this](Result<std::shared_ptr<const RobotLook>> look) {
        // A recording that was opened meanwhile may have brought its own arm; the view keeps this one for those
        // without.
        if (look)
          view_->showRobot(std::shared_ptr<const RobotModel>(std::shared_ptr<void>(), &RobotModel::panda()), *look);
      });
}

void MainWindow::showStep(Step step) {
  StepPanel* panel = panels_.value(step);
  if (panel && manualShown()) showManual(false);
  if (!panel || step == step_) return;
  StepPanel* before = panels_.value(step_);
  keepSizes();
  const bool hadFocus = panelStack_->isAncestorOf(QApplication::focusWidget());
  before->left();
  step_ = step;
  workspace_->setStep(QString::fromUtf8(stepId(step).data()));
  panelStack_->setCurrentWidget(panel);
  steps_->setNow(step);
  tour_->setStep(step);
  arrangeFor(panel);
  status_->setHint(panel->hint());
  panel->entered();
  // Who goes on by keyboard goes on in the new panel.
  if (!hadFocus) return;
  const QVector<QWidget*> way = tabWay(*this, {panelStack_});
  if (!way.isEmpty()) way.front()->setFocus(Qt::OtherFocusReason);
}

/// Of the step shown, unless one pane stands alone.
void MainWindow::keepSizes() {
  if (!isVisible() || alone_ != Alone::nothing) return;
  panelWidths_[step_] = across_->sizes().value(1, kPanelWidth);
  const QList<int> down = down_->sizes();
  if (down.value(1) > 0) viewShares_[step_] = static_cast<double>(down[0]) / (down[0] + down[1]);
}

void MainWindow::showAlone(Alone what) {
  if (what == Alone::below && (!below_->isVisibleTo(this) || pane_->folded())) return;
  keepSizes();
  alone_ = what;
  if (what == Alone::nothing) return arrangeFor(panels_[step_]);
  panelStack_->hide();
  view_->setVisible(what == Alone::view);
  below_->setVisible(what == Alone::below);
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
  // Other units or another language are another window: this one has to be done first.
  if (wanted.units != now.units) QTimer::singleShot(0, this, [this, units = wanted.units] { emit unitsWanted(units); });
  if (wanted.language != now.language)
    QTimer::singleShot(0, this, [this, code = wanted.language] { emit languageWanted(code); });
}

void MainWindow::arrangeFor(StepPanel* panel) {
  alone_ = Alone::nothing;
  view_->show();
  panelStack_->show();
  const bool own = panel->below() == StepPanel::Below::own && panel->ownPane();
  below_->setCurrentWidget(own ? panel->ownPane() : pane_);
  below_->setVisible(own || workspace_->opened());
  pane_->setFolded(panel->below() == StepPanel::Below::marksOnly);
  below_->setMaximumHeight(!own && pane_->folded() ? pane_->foldedHeight() : QWIDGETSIZE_MAX);
  const int panelWidth = panelWidths_.value(step_, kPanelWidth);
  across_->setSizes({across_->width() - panelWidth, panelWidth});
  const int view = static_cast<int>(down_->height() * viewShares_.value(step_, panel->viewShare()));
  down_->setSizes({view, down_->height() - view});
}

bool MainWindow::settled() const {
  return !workspace_->busy() && !lookJobs_.running() &&
         std::none_of(followed_.begin(), followed_.end(), [](const JobRunner* runner) { return runner->running(); });
}

void MainWindow::showDetails(bool shown) { header_->setDetails(shown); }

bool MainWindow::manualShown() const { return manual_ && panelStack_->currentWidget() == manual_; }

void MainWindow::showManual(bool shown) {
  if (!shown) return panelStack_->setCurrentWidget(panels_[step_]);
  panelStack_->setCurrentWidget(manual_);
  manual_->open(QString::fromUtf8(stepId(step_).data()));
}

QImage MainWindow::pictureOf(const QString& part) {
  if (part == "window") return picture();
  if (part == "view") return view_->picture();
  // What stands under the 3D view: in the reality check, the difference.
  if (part == "plots") return (below_->currentWidget() ? below_->currentWidget() : pane_)->grab().toImage();
  if (part == "panel") return panelStack_->grab().toImage();
  if (part == "steps") return steps_->grab().toImage();
  const auto step = stepFromId(part.toStdString());
  StepPanel* panel = step ? panels_.value(*step) : nullptr;
  if (!panel) return {};
  // A panel that was not shown yet has no size.
  if (!panel->isVisible()) panel->resize(kPanelWidth, std::max(600, panelStack_->height()));
  return panel->grab().toImage();
}

QImage MainWindow::picture() {
  view_->renderNow();
  return grab().toImage();
}

void MainWindow::keepUnderWay() {
  for (StepPanel* panel : panels_) panel->keepUnderWay();
}

void MainWindow::showSaved() {
  const QString at = autosave_ && autosave_->lastSaved().isValid()
                         ? QLocale().toString(autosave_->lastSaved().time(), QLocale::ShortFormat)
                         : QString();
  status_->setSaved(at.isEmpty() ? QString() : tr("Saved automatically, %1").arg(at));
}

void MainWindow::useAutosave(Autosave* autosave) {
  autosave_ = autosave;
  connect(autosave_, &Autosave::saved, this, &MainWindow::showSaved);
  connect(autosave_, &Autosave::failed, this, [this](const QString& why) {
    message_->showMessage(Severity::warning,
                          tr("The session cannot be saved automatically: %1 Save it elsewhere.").arg(why),
                          tr("Save as …"), [this] { files_->saveAs(); });
  });
  showSaved();
  if (autosave_->leftBehind().isEmpty()) return offerUnfinished();
  message_->showMessage(
      Severity::warning, tr("Your last session was not closed. It was saved automatically."), tr("Restore"), [this] {
        const auto recovered = autosave_->recover();
        if (!recovered.unreadable.isEmpty()) {
          const auto& [file, reason] = recovered.unreadable.first();
          message_->showMessage(recovered.opened ? Severity::warning : Severity::error,
                                tr("The saved session could not be restored; it is now %1. %2").arg(file, reason));
        } else if (recovered.opened) {
          offerUnfinished();
        }
      });
}

void MainWindow::offerUnfinished() {
  const QStringList recordings = unfinishedRecordings(recordedFolder()) + unfinishedRecordings(earlierRecordedFolder());
  if (recordings.isEmpty()) return;
  message_->showMessage(Severity::warning,
                        tr("Heft Studio closed during a recording. The data up to that point was saved."),
                        tr("Open the recording"), [this, recordings] {
                          for (const QString& recording : recordings) forgetUnfinished(recording);
                          workspace_->open(recordings);
                        });
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
  } else if (!below_->isVisible()) {
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
  auto* main = panelStack_->currentWidget()->findChild<QAbstractButton*>("mainButton");
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
      return focusNextPart(event->modifiers() & Qt::ShiftModifier ? -1 : 1);
    case Qt::Key_Escape:
      if (alone_ != Alone::nothing) return showAlone(Alone::nothing);
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
      keepOnScreen();
      arrangeFor(panels_[step_]);
    });
  arranged_ = true;
}

/// The frame is known only now.
void MainWindow::keepOnScreen() {
  const QScreen* on = screen();
  if (!on || isMaximized() || isFullScreen() || (windowFlags() & Qt::FramelessWindowHint)) return;
  const QRect room = on->availableGeometry();
  const QSize frame = frameGeometry().size() - size();
  resize(size().boundedTo(room.size() - frame));
  const QRect now = frameGeometry();
  move(std::clamp(now.left(), room.left(), std::max(room.left(), room.right() + 1 - now.width())),
       std::clamp(now.top(), room.top(), std::max(room.top(), room.bottom() + 1 - now.height())));
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!files_->mayClose()) return event->ignore();
  if (remembers_) QSettings().setValue("window/geometry", saveGeometry());
  QMainWindow::closeEvent(event);
}

}  // namespace heft
