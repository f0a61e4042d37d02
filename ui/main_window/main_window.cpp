#include "ui/main_window/main_window.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QKeyEvent>
#include <QMenu>
#include <QMenuBar>
#include <QMimeData>
#include <QSettings>
#include <QSplitter>
#include <QUrl>
#include <QVBoxLayout>
#include <QVariant>

#include "core/base/json_file.h"
#include "ui/controller/payload_file.h"
#include "ui/controller/workspace.h"
#include "ui/main_window/header_bar.h"
#include "ui/main_window/status_bar.h"
#include "ui/models/numbers.h"
#include "ui/models/result_text.h"
#include "ui/results/result_panel.h"
#include "ui/robot_view/robot_view.h"
#include "ui/theme/icons.h"
#include "ui/widgets/message_bar.h"
#include "ui/wrench_plots/recording_pane.h"
#include "ui/wrench_plots/wrench_plots.h"

namespace heft {
namespace {

constexpr int kPanelWidth = 440, kRecentFiles = 8;
constexpr double kKeyStep = 0.1;  ///< [s] an arrow key moves the time

QString droppedFile(const QMimeData* data) {
  for (const QUrl& url : data->urls()) {
    if (url.isLocalFile()) return url.toLocalFile();
  }
  return {};
}

}  // namespace

MainWindow::MainWindow(Workspace* workspace, bool remembers, QWidget* parent)
    : QMainWindow(parent), workspace_(workspace), remembers_(remembers) {
  setObjectName("mainWindow");
  setWindowTitle(tr("Heft Studio"));
  setWindowIcon(applicationIcon());
  setAcceptDrops(true);
  resize(1440, 900);
  setMinimumSize(960, 600);

  auto* window = new QWidget(this);
  window->setObjectName("window");
  auto* column = new QVBoxLayout(window);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  header_ = new HeaderBar(window);
  column->addWidget(header_);
  message_ = new MessageBar(window);
  column->addWidget(message_);

  across_ = new QSplitter(Qt::Horizontal, window);
  across_->setChildrenCollapsible(false);
  down_ = new QSplitter(Qt::Vertical, across_);
  down_->setChildrenCollapsible(false);
  // Wide enough to be caught; the sheet draws it as one line.
  across_->setHandleWidth(5);
  down_->setHandleWidth(5);
  view_ = new RobotView(down_);
  pane_ = new RecordingPane(&playback_, down_);
  pane_->hide();
  panel_ = new ResultPanel(across_);
  down_->setStretchFactor(0, 1);
  down_->setStretchFactor(1, 0);
  across_->setStretchFactor(0, 1);
  across_->setStretchFactor(1, 0);
  across_->setSizes({1000, kPanelWidth});
  column->addWidget(across_, 1);
  status_ = new StatusBar(&workspace_->jobs(), window);
  column->addWidget(status_);
  setCentralWidget(window);

  buildMenus();
  connect(header_, &HeaderBar::detailsWanted, panel_, &ResultPanel::setDetailsShown);
  connect(panel_, &ResultPanel::openWanted, this, &MainWindow::chooseFile);
  connect(panel_, &ResultPanel::fileWanted, this, &MainWindow::open);
  connect(panel_, &ResultPanel::estimateWanted, workspace_, &Workspace::estimate);
  connect(panel_, &ResultPanel::saveWanted, this, &MainWindow::savePayload);
  connect(workspace_, &Workspace::openedChanged, this, &MainWindow::showOpened);
  connect(workspace_, &Workspace::reportChanged, this, &MainWindow::showReport);
  connect(workspace_, &Workspace::failed, this, &MainWindow::showFailure);
  connect(&workspace_->jobs(), &JobRunner::finished, this, [this] {
    // Stopped by hand: nothing came, nothing failed.
    if (workspace_->opened() && !workspace_->report() && !message_->isVisible()) {
      panel_->showNoResult(tr("The estimate was stopped."));
    }
  });
  connect(&playback_, &Playback::timeChanged, view_, &RobotView::showTime);
  connect(view_, &RobotView::pictureWanted, this, [this] { savePicture(view_->grab().toImage(), tr("view")); });
  connect(pane_, &RecordingPane::pictureWanted, this, [this] { savePicture(pane_->grab().toImage(), tr("plots")); });

  panel_->showWelcome(recentFiles());
  status_->setFacts(tr("No recording open"));
  lookJobs_.start(
      QString(),
      [](const Progress& progress) -> Result<std::shared_ptr<const RobotLook>> {
        Findings findings;
        return pandaLook(findings, progress);
      },
      [this](Result<std::shared_ptr<const RobotLook>> look) {
        if (look)
          view_->showRobot(std::shared_ptr<const RobotModel>(std::shared_ptr<void>(), &RobotModel::panda()), *look);
      });

  if (remembers_) {
    const QSettings settings;
    restoreGeometry(settings.value("window/geometry").toByteArray());
  }
}

MainWindow::~MainWindow() = default;

void MainWindow::buildMenus() {
  QMenuBar* bar = header_->menuBar();
  QMenu* file = bar->addMenu(tr("&File"));
  QAction* openAction = file->addAction(tr("&Open a recording …"), this, &MainWindow::chooseFile);
  openAction->setShortcut(QKeySequence::Open);
  recent_ = file->addMenu(tr("Opened &lately"));
  connect(recent_, &QMenu::aboutToShow, this, &MainWindow::fillRecentMenu);
  file->addSeparator();
  QAction* save = file->addAction(tr("&Save the payload file …"), this, &MainWindow::savePayload);
  save->setShortcut(QKeySequence::Save);
  save->setEnabled(false);
  connect(workspace_, &Workspace::reportChanged, save,
          [this, save] { save->setEnabled(workspace_->report() != nullptr); });
  file->addAction(tr("Save a &picture of the window …"), this, [this] { savePicture(picture(), tr("window")); });
  file->addSeparator();
  QAction* quit = file->addAction(tr("&Quit"), this, &QWidget::close);
  quit->setShortcut(QKeySequence::Quit);

  QMenu* look = bar->addMenu(tr("&View"));
  const auto addView = [&](const QString& text, const QKeySequence& key, RobotView::Preset preset) {
    look->addAction(text, this, [this, preset] { view_->usePreset(preset); })->setShortcut(key);
  };
  addView(tr("&Whole arm"), Qt::Key_F, RobotView::Preset::overview);
  addView(tr("&Tool"), Qt::Key_T, RobotView::Preset::tool);
  addView(tr("F&ront"), QKeySequence("Ctrl+1"), RobotView::Preset::front);
  addView(tr("&Side"), QKeySequence("Ctrl+2"), RobotView::Preset::side);
  addView(tr("T&op"), QKeySequence("Ctrl+3"), RobotView::Preset::top);
  look->addSeparator();
  look->addAction(tr("Whole &recording in the plots"), this, [this] { pane_->timeAxis()->showAll(); })
      ->setShortcut(QKeySequence("Ctrl+0"));
  look->addSeparator();
  auto* themes = new QActionGroup(this);
  const std::pair<QString, ThemeKind> kinds[] = {{tr("&Light"), ThemeKind::light}, {tr("&Dark"), ThemeKind::dark}};
  for (const auto& [text, kind] : kinds) {
    QAction* action = look->addAction(text, this, [this, k = kind] { emit themeWanted(k); });
    action->setCheckable(true);
    action->setChecked(theme().dark == (kind == ThemeKind::dark));
    themes->addAction(action);
  }
}

bool MainWindow::settled() const { return !workspace_->busy() && !lookJobs_.running(); }

void MainWindow::showDetails(bool shown) { header_->setDetails(shown); }

QImage MainWindow::picture() {
  view_->renderNow();
  return grab().toImage();
}

void MainWindow::chooseFile() {
  const QString folder = workspace_->opened() ? QFileInfo(workspace_->opened()->path).absolutePath() : QString();
  const QString path =
      QFileDialog::getOpenFileName(this, tr("Open a recording"), folder, tr("Recordings (*.csv);;All files (*)"));
  if (!path.isEmpty()) open(path);
}

void MainWindow::open(const QString& path) {
  message_->hide();
  workspace_->open(path);
}

void MainWindow::showOpened() {
  const auto opened = workspace_->opened();
  if (!opened) return;
  const Recording& recording = opened->recording;
  const std::shared_ptr<const Recording> shared(opened, &recording);
  message_->hide();
  header_->setFileName(QFileInfo(opened->path).fileName(), opened->path);
  setWindowTitle(tr("%1 – Heft Studio").arg(QFileInfo(opened->path).fileName()));
  const bool first = !pane_->isVisible();
  pane_->show();
  if (first) down_->setSizes({down_->height() * 55 / 100, down_->height() * 45 / 100});
  view_->showRecording(shared, opened->robot, opened->look);
  pane_->setRecording(&recording);
  panel_->showWorking(QFileInfo(opened->path).fileName());
  QStringList facts{QFileInfo(opened->path).fileName()};
  if (recording.meta.kind == RecordingKind::poses) {
    facts << tr("%1 standing poses").arg(recording.rows());
  } else {
    facts << tr("%1 s").arg(numberText(recording.duration(), 1)) << tr("%1 Hz").arg(numberText(recording.rateHz(), 0));
  }
  if (!recording.meta.sensorModel.empty()) facts << QString::fromStdString(recording.meta.sensorModel);
  status_->setFacts(facts.join(QStringLiteral(" · ")));
  rememberFile(opened->path);
}

void MainWindow::showReport() {
  const auto opened = workspace_->opened();
  const auto report = workspace_->report();
  if (!opened) return;
  pane_->setReport(&opened->recording, report.get());
  view_->showReport(report);
  if (report) panel_->showResult(describeResult(*report, opened->recording.meta.knownPayload));
}

void MainWindow::showFailure(const QString& sentence) {
  message_->showMessage(Severity::error, sentence);
  if (workspace_->opened() && !workspace_->report()) {
    panel_->showNoResult(tr("See the message at the top of the window."));
  }
}

void MainWindow::savePayload() {
  const auto opened = workspace_->opened();
  const auto report = workspace_->report();
  if (!opened || !report) return;
  QStringList filters;
  for (const ExportFormat& format : exportFormats()) {
    filters << QStringLiteral("%1 (*%2)")
                   .arg(QString::fromUtf8(format.title.data(), static_cast<int>(format.title.size()))
                            .remove('(')
                            .remove(')'),
                        QString::fromUtf8(format.extension.data(), static_cast<int>(format.extension.size())));
  }
  QString chosen;
  const QFileInfo source(opened->path);
  const QString path = QFileDialog::getSaveFileName(
      this, tr("Save the payload file"), source.absolutePath() + "/" + source.completeBaseName() + "-payload",
      filters.join(";;"), &chosen);
  if (path.isEmpty()) return;
  const ExportFormat& format = exportFormats()[std::max(0, static_cast<int>(filters.indexOf(chosen)))];
  Findings findings;
  const auto text = payloadFile(*opened, *report, format, findings);
  if (!text) return showFailure(QString::fromStdString(text.error().message));
  const QString extension = QString::fromUtf8(format.extension.data(), static_cast<int>(format.extension.size()));
  QString target = path;
  if (QFileInfo(path).suffix().isEmpty()) {
    target += extension;
    // The dialog asked about the name without the extension; this one it has not seen.
    if (QFileInfo::exists(target)) {
      return showFailure(
          tr("%1 exists already and was not replaced: choose it in the dialog to replace it.").arg(target));
    }
  }
  const auto written = writeTextFile(target.toStdString(), *text);
  if (!written) return showFailure(QString::fromStdString(written.error().message));
  QString said = tr("Saved %1.").arg(target);
  for (const Finding& finding : findings) {
    if (finding.severity != Severity::info) said += QStringLiteral(" ") + QString::fromStdString(finding.text);
  }
  message_->showMessage(findings.empty() ? Severity::info : Severity::warning, said);
}

void MainWindow::savePicture(const QImage& image, const QString& what) {
  const auto opened = workspace_->opened();
  const QString base =
      opened ? QFileInfo(opened->path).absolutePath() + "/" + QFileInfo(opened->path).completeBaseName() + "-"
             : QString();
  const QString path =
      QFileDialog::getSaveFileName(this, tr("Save a picture"), base + what + ".png", tr("Pictures (*.png)"));
  if (path.isEmpty()) return;
  if (image.save(path)) {
    message_->showMessage(Severity::info, tr("Saved %1.").arg(path));
  } else {
    showFailure(tr("%1 could not be written: check that the folder exists and may be written to.").arg(path));
  }
}

QStringList MainWindow::recentFiles() const {
  if (!remembers_) return {};
  QStringList present;
  for (const QString& path : QSettings().value("files/recent").toStringList()) {
    if (QFileInfo::exists(path)) present << path;
  }
  return present;
}

void MainWindow::rememberFile(const QString& path) {
  if (!remembers_) return;
  QStringList files = recentFiles();
  files.removeAll(path);
  files.prepend(path);
  QSettings().setValue("files/recent", QStringList(files.mid(0, kRecentFiles)));
}

void MainWindow::fillRecentMenu() {
  recent_->clear();
  for (const QString& path : recentFiles()) recent_->addAction(path, this, [this, path] { open(path); });
  if (recent_->isEmpty()) recent_->addAction(tr("Nothing yet"))->setEnabled(false);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (!droppedFile(event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  const QString path = droppedFile(event->mimeData());
  if (path.isEmpty()) return;
  event->acceptProposedAction();
  open(path);
}

void MainWindow::keyPressEvent(QKeyEvent* event) {
  // Keys that reach the window were not wanted by the focused control; a focused button keeps its Space.
  const double step = pane_->timeAxis()->poses()                 ? 1.0
                      : (event->modifiers() & Qt::ShiftModifier) ? 10 * kKeyStep
                                                                 : kKeyStep;
  switch (event->key()) {
    case Qt::Key_Space:
      playback_.toggle();
      return;
    case Qt::Key_Left:
      playback_.setTime(playback_.time() - step);
      return;
    case Qt::Key_Right:
      playback_.setTime(playback_.time() + step);
      return;
    case Qt::Key_Home:
      playback_.setTime(playback_.lower());
      return;
    case Qt::Key_End:
      playback_.setTime(playback_.upper());
      return;
    default:
      QMainWindow::keyPressEvent(event);
  }
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (remembers_) QSettings().setValue("window/geometry", saveGeometry());
  QMainWindow::closeEvent(event);
}

}  // namespace heft
