#include "ui/record_panel/record_panel.h"

#include <QAction>
#include <QButtonGroup>
#include <QDateTime>
#include <QDesktopServices>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QRandomGenerator>
#include <QUrl>
#include <QVBoxLayout>
#include <QVariant>
#include <thread>
#include <tuple>

#include "core/base/file_replacement.h"
#include "core/motion/motion.h"
#include "core/recording/csv_reader.h"
#include "core/workspace/session.h"
#include "ui/controller/autosave.h"
#include "ui/controller/only_child.h"
#include "ui/controller/workspace.h"
#include "ui/live/live_words.h"
#include "ui/models/numbers.h"
#include "ui/record_panel/flange_guide.h"
#include "ui/record_panel/live_board.h"
#include "ui/record_panel/live_stage.h"
#include "ui/record_panel/recording_list.h"
#include "ui/record_panel/samples.h"
#include "ui/record_panel/source_form.h"
#include "ui/record_panel/touched_walls.h"
#include "ui/robot_view/robot_view.h"
#include "ui/theme/icons.h"
#include "ui/timeline/playback.h"
#include "ui/widgets/basics.h"
#include "ui/widgets/choice_card.h"
#include "ui/widgets/segments.h"
#include "ui/wrench_plots/recording_pane.h"

namespace heft {
namespace {

QString nameNow(const char* what) {
  return QString::fromLatin1(what) + QDateTime::currentDateTime().toString(QStringLiteral("-yyyy-MM-dd-HHmm"));
}

}  // namespace

std::uint64_t RecordPanel::toolBetween(double lightest, double heaviest) {
  std::uint64_t seed = QRandomGenerator::global()->bounded(1000000);
  while (true) {
    const double mass = practiceTool(++seed).mass;
    if (mass >= lightest && mass <= heaviest) return seed;
  }
}

RecordPanel::RecordPanel(const StudioParts& parts) : StepPanel(parts), run_(onlyChild<LiveRun>(*parts.workspace)) {
  if (parts.view) {
    auto* playback = new Playback(this);
    ownPane_ = new RecordingPane(playback);
    ownPane_->setObjectName("livePlots");
    guide_ = new FlangeGuide(run_, parts.view, this);
  }
  connect(&workspace(), &Workspace::openedChanged, this, &RecordPanel::refresh);
  connect(&workspace(), &Workspace::recordingsChanged, this, &RecordPanel::refresh);
  connect(&workspace(), &Workspace::reportChanged, this, &RecordPanel::refresh);
  connect(&workspace(), &Workspace::busyChanged, this, &StepPanel::stateChanged);
  connect(&workspace(), &Workspace::roomChanged, this, &RecordPanel::showRoom);
  connect(run_, &LiveRun::refreshed, this, &RecordPanel::liveRefreshed);
  connect(run_, &LiveRun::adviceChanged, this, [this] {
    if (board_) board_->refresh();
  });
  connect(run_, &LiveRun::toolChanged, this,
          [this] { this->parts().say(Severity::info, tr("The tool was changed. Heft now learns the new one.")); });
  connect(run_, &LiveRun::failed, this, &RecordPanel::fail);
  for (JobRunner* runner : run_->runners()) parts.followJobs(runner);
  parts.followJobs(&looking_);
  parts.followJobs(&waiting_);
  parts.followJobs(&sampling_);
  touchedWalls_ = new TouchedWalls(&workspace(), this);
  parts.followJobs(&touchedWalls_->jobs());
  connect(touchedWalls_, &TouchedWalls::ended, this,
          [this](Severity severity, const QString& sentence) { this->parts().say(severity, sentence); });
  showRoom();
  if (run_->running()) {
    follow();
  } else {
    refresh();
  }
}

QWidget* RecordPanel::ownPane() { return ownPane_; }

RecordPanel::~RecordPanel() {
  // The board and the stage look at the run.
  waiting_.cancel();
  delete stage_;
  delete guide_;
}

StepState RecordPanel::state() const {
  using P = StepState::Progress;
  if (run_->running()) {
    const LiveView& now = run_->view();
    if (!now.any) return {P::ready, Light::measured, tr("waiting for data")};
    if (run_->poses())
      return {P::ready, Light::measured, tr("%n pose(s), recording", "", static_cast<int>(now.poses.size()))};
    return {P::ready, Light::measured, tr("%1 s, recording").arg(numberText(now.time, 1))};
  }
  const auto opened = workspace().opened();
  if (!opened) return {P::ready, Light::measured, workspace().busy() ? tr("opening …") : tr("nothing open yet")};
  const Recording& recording = opened->recording;
  return {P::done, Light::measured,
          recording.meta.kind == RecordingKind::poses
              ? tr("%n pose(s) recorded", "", static_cast<int>(recording.rows()))
              : tr("%1 s recorded").arg(numberText(recording.duration(), 1))};
}

QString RecordPanel::hint() const {
  if (!run_->running()) return {};
  return virtualRun() ? tr("Drag the tool, or use the arrow keys; hold Shift to rotate")
                      : tr("Move the arm as the coach suggests, then press “Stop and save”");
}

QString RecordPanel::facts() const {
  if (!run_->running()) return {};
  const QString what = virtualRun() ? tr("Virtual arm") : tr("Live robot");
  return run_->paused() ? tr("%1, paused").arg(what) : tr("%1, recording").arg(what);
}

void RecordPanel::entered() {
  here_ = true;
  if (run_->running()) {
    if (stage_) stage_->enter();
    if (guide_ && virtualRun()) guide_->attach();
    if (board_) board_->refresh();
  } else {
    refresh();
  }
}

void RecordPanel::left() {
  here_ = false;
  if (stage_) stage_->leave();
  if (guide_) guide_->detach();
}

bool RecordPanel::keyPressed(QKeyEvent* event) {
  return guide_ && run_->running() && virtualRun() && guide_->key(event);
}

void RecordPanel::setWay(Way way) {
  if (way == way_ && (way != Way::live || form_)) return;
  way_ = way;
  if (!run_->running()) refresh();
}

void RecordPanel::fail(const QString& sentence) {
  parts().say(Severity::error, sentence);
  if (!run_->running()) showNoLive();
}

void RecordPanel::showNoLive() {
  if (stage_) stage_->leave();
  if (guide_) guide_->detach();
  board_ = nullptr;
  refresh();
  emit arrangementChanged();
}

void RecordPanel::startVirtual(std::uint64_t seed, bool poses, bool byClock) {
  VirtualRigOptions options;
  options.seed = seed;
  options.payload = practiceTool(seed);
  auto source = VirtualSource::create(RobotModel::panda(), options, VirtualSource::Pace::stepped);
  if (!source) return fail(QString::fromStdString(source.error().message));
  LiveSetup setup;
  setup.virtualArm = source->get();
  setup.sources.push_back(std::move(*source));
  setup.meta = VirtualRig::metaFor(options);
  // Nothing estimates from it; the result shows how far off it was.
  setup.meta.knownPayload = {options.payload.mass, options.payload.com, options.payload.inertiaCom};
  setup.robot = std::shared_ptr<const RobotModel>(std::shared_ptr<void>(), &RobotModel::panda());
  setup.poses = poses;
  setup.name = nameNow("virtual");
  setup.origin.tool = seed;
  way_ = Way::virtualArm;
  begin(std::move(setup), byClock);
}

void RecordPanel::startListening() {
  if (!form_) return;
  auto addresses = form_->addresses();
  if (!addresses) return form_->complain(QString::fromStdString(addresses.error().message));
  auto meta = form_->meta();
  if (!meta) return form_->complain(QString::fromStdString(meta.error().message));
  const bool assumed = form_->mountAssumed();
  listenTo({0, std::move(*addresses), std::move(*meta), form_->rigFile().toStdString(), assumed}, false);
}

void RecordPanel::listenTo(LiveOrigin origin, bool poses) {
  LiveSetup setup;
  const auto jointNames = jointNamesOf(origin.meta);
  for (const std::string& address : origin.addresses) {
    auto source = makeLiveSource(address, origin.replayMeta, jointNames, origin.meta.conventions);
    if (!source) return fail(QString::fromStdString(source.error().message));
    setup.sources.push_back(std::move(*source));
  }
  setup.meta = origin.meta;
  if (setup.meta.robot && *setup.meta.robot != "panda") {
    Findings findings;
    auto robot = robotFor(setup.meta, findings);
    if (!robot) return fail(QString::fromStdString(robot.error().message));
    setup.robot = std::make_shared<const RobotModel>(std::move(*robot));
  }
  setup.poses = poses;
  setup.name = nameNow("live");
  setup.origin = std::move(origin);
  begin(std::move(setup), true);
}

void RecordPanel::begin(LiveSetup setup, bool byClock) {
  setup.folder = recordedFolder();
  setup.shape = estimateOptions(workspace().session()).shape;
  if (const auto& file = workspace().session().room; !file.empty()) {
    auto room = readRoom(file);
    if (!room) return fail(QString::fromStdString(room.error().message));
    setup.room = std::move(*room);
  }
  delete stage_;
  stage_ = nullptr;
  board_ = nullptr;
  if (auto started = run_->start(std::move(setup), byClock); !started)
    return fail(QString::fromStdString(started.error().message));
  follow();
  emit arrangementChanged();
  emit stateChanged();
}

/// Shows the run that goes on.
void RecordPanel::follow() {
  way_ = virtualRun() ? Way::virtualArm : Way::live;
  form_ = nullptr;
  plotted_ = 0;
  if (ownPane_) ownPane_->setRecording(nullptr, nullptr);
  if (parts().view) {
    stage_ = new LiveStage(run_, parts().view, run_->byClock(), this);
    if (here_) stage_->enter();
    if (here_ && virtualRun() && guide_) guide_->attach();
    looking_.start(
        QString(),
        [robot = run_->robot(),
         virtualRun = virtualRun()](const Progress& progress) -> Result<std::shared_ptr<const RobotLook>> {
          Findings findings;
          if (!robot || virtualRun) return pandaLook(findings, progress);
          return std::make_shared<const RobotLook>(heft::loadLook(*robot, findings, progress));
        },
        [this](const Result<std::shared_ptr<const RobotLook>>& look) {
          if (look && stage_ && run_->running()) stage_->setLook(*look);
        });
  }
  showLive();
}

void RecordPanel::liveRefreshed() {
  if (!run_->running() || !board_) return;
  const LiveView& now = run_->view();
  board_->refresh();
  const bool enough = run_->poses() ? now.poses.size() >= 2 : now.any;
  if (enough != page()->mainButton()->isEnabled())
    page()->setMainEnabled(enough,
                           run_->poses() ? tr("At least two poses are needed.") : tr("Nothing has been received yet."));
  // Plots cost more than numbers: every other time is enough for the eye.
  if (ownPane_ && here_ && (plotted_++ % 2 == 0 || !run_->byClock()))
    ownPane_->showLive(now.traces, now.touched, now.time);
  emit stateChanged();
}

void RecordPanel::changeWay(bool poses) {
  const LiveOrigin origin = run_->origin();
  const bool virtualArm = virtualRun(), byClock = run_->byClock();
  // What came so far is a recording like any other.
  const QString kept = keepAside();
  if (!kept.isEmpty())
    parts().offer(Severity::info, tr("What was recorded so far was kept: %1").arg(kept), tr("Open it"),
                  [this, kept] { workspace().open(kept); });
  if (virtualArm) {
    startVirtual(origin.tool, poses, byClock);
  } else {
    listenTo(origin, poses);
  }
}

void RecordPanel::changeTool() {
  VirtualSource* arm = run_->virtualArm();
  if (!arm) return;
  // A clearly different weight, as with a real tool change.
  const double before = arm->payload().mass;
  const auto seed = before > 0.7 ? toolBetween(0.25, 0.6 * before) : toolBetween(1.5 * before, 1.6);
  if (auto changed = arm->changeTool(practiceTool(seed)); !changed)
    parts().say(Severity::error, QString::fromStdString(changed.error().message));
}

QString RecordPanel::keepAside() {
  auto kept = run_->keep();
  if (!kept) {
    parts().say(Severity::error, QString::fromStdString(kept.error().message));
    return {};
  }
  if (!kept->isEmpty()) parts().remember(*kept);
  return *kept;
}

void RecordPanel::stopAndKeep() {
  if (!run_->running()) return;
  const bool assumed = !virtualRun() && run_->origin().mountAssumed;
  const QString file = keepAside();
  way_ = Way::files;
  showNoLive();
  if (file.isEmpty()) return parts().say(Severity::warning, tr("Nothing was recorded."));
  workspace().open(file);
  parts().offer(Severity::info, tr("Recording saved: %1").arg(file), tr("Show in folder"),
                [file] { QDesktopServices::openUrl(QUrl::fromLocalFile(QFileInfo(file).absolutePath())); });
  if (assumed && parts().editRig)
    parts().offer(Severity::warning,
                  tr("The sensor’s mounting on the flange is not stated, so Heft assumes the flange’s axes. If it is "
                     "mounted differently, the inertia and the exported numbers are wrong."),
                  tr("Specify it now …"), parts().editRig);
}

void RecordPanel::keepUnderWay() {
  if (run_->running()) keepAside();
}

bool RecordPanel::mayEnd() {
  if (!run_->running()) return true;
  if (parts().asks) {
    QMessageBox box(QMessageBox::NoIcon, tr("Heft Studio"), tr("A recording is running. Stop it?"),
                    QMessageBox::NoButton, this);
    box.setInformativeText(tr("What has been recorded so far is kept in %1.").arg(recordedFolder()));
    auto* stop = box.addButton(tr("Stop and save"), QMessageBox::AcceptRole);
    auto* goOn = box.addButton(tr("Continue recording"), QMessageBox::RejectRole);
    box.setDefaultButton(goOn);
    box.exec();
    if (box.clickedButton() != stop) return false;
  }
  keepAside();
  way_ = Way::files;
  showNoLive();
  return true;
}

void RecordPanel::discardPoses() {
  const int count = static_cast<int>(run_->view().poses.size());
  if (parts().asks && count > 0) {
    QMessageBox box(QMessageBox::NoIcon, tr("Heft Studio"), tr("Discard %n pose(s)?", "", count), QMessageBox::NoButton,
                    this);
    auto* away = box.addButton(tr("Discard"), QMessageBox::DestructiveRole);
    auto* goOn = box.addButton(tr("Continue recording"), QMessageBox::RejectRole);
    box.setDefaultButton(goOn);
    box.exec();
    if (box.clickedButton() != away) return;
  }
  obey({"live", "discard"});
}

void RecordPanel::saveRecordingAs() {
  const auto opened = workspace().opened();
  if (!opened) return parts().say(Severity::info, tr("Open a recording first."));
  const QFileInfo from(opened->path);
  const QString to = QFileDialog::getSaveFileName(this, tr("Save the recording"), from.absoluteFilePath(),
                                                  tr("Recordings (*.%1)").arg(from.suffix()));
  if (to.isEmpty() || QFileInfo(to) == from) return;
  // The dialog asked before an existing file is replaced.
  const auto copy = [](const QString& source, const QString& target) {
    return copyFile(source.toStdString(), target.toStdString());
  };
  const auto metaOf = [](const QString& file) {
    return QString::fromStdString(metaFileOf(file.toStdString()).string());
  };
  auto copied = copy(opened->path, to);
  if (copied && QFileInfo::exists(metaOf(opened->path))) copied = copy(metaOf(opened->path), metaOf(to));
  if (!copied) return parts().say(Severity::error, QString::fromStdString(copied.error().message));
  parts().remember(to);
  parts().say(Severity::info, tr("Saved %1.").arg(to));
}

void RecordPanel::chooseRoom() {
  const auto& now = workspace().session().room;
  const QString file = QFileDialog::getOpenFileName(
      window(), tr("Choose a room"), now.empty() ? QString() : QString::fromStdString(now.parent_path().string()),
      tr("Rooms (*.json);;All files (*)"));
  if (file.isEmpty()) return;
  if (const auto taken = setRoom(file); !taken)
    parts().say(Severity::error, QString::fromStdString(taken.error().message));
}

void RecordPanel::findTouchedWalls() {
  if (const auto started = touchedWalls_->find(); !started)
    parts().say(Severity::info, QString::fromStdString(started.error().message));
}

Result<bool> RecordPanel::setRoom(const QString& file) {
  const std::filesystem::path path = std::filesystem::absolute(file.toStdString());
  if (const auto room = readRoom(path); !room) return room.error();
  workspace().setRoom(path, tr("Choose a room"));
  return true;
}

void RecordPanel::showRoom() {
  if (!parts().view) return;
  const auto& file = workspace().session().room;
  const auto room = file.empty() ? Result<Room>(Room()) : readRoom(file);
  parts().view->marks().showRoom(room ? *room : Room());
  if (!room) parts().say(Severity::warning, QString::fromStdString(room.error().message));
}

void RecordPanel::addActions(const StudioMenus& menus) {
  menus.tools->addAction(tr("Choose a r&oom …"), this, &RecordPanel::chooseRoom)->setObjectName("chooseRoomAction");
  menus.tools->addAction(tr("Walls t&hat were touched"), this, &RecordPanel::findTouchedWalls)
      ->setObjectName("touchedWallsAction");
  menus.file->addAction(tr("Save recordin&g as …"), this, &RecordPanel::saveRecordingAs)
      ->setObjectName("saveRecordingAs");
  menus.file->addAction(tr("Open the recordings fol&der"), this, [] {
    QDir().mkpath(recordedFolder());
    QDesktopServices::openUrl(QUrl::fromLocalFile(recordedFolder()));
  });
}

}  // namespace heft
