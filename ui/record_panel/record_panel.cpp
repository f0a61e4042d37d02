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
#include "ui/record_panel/samples.h"
#include "ui/record_panel/source_form.h"
#include "ui/robot_view/robot_view.h"
#include "ui/theme/icons.h"
#include "ui/timeline/playback.h"
#include "ui/widgets/basics.h"
#include "ui/widgets/choice_card.h"
#include "ui/widgets/segments.h"
#include "ui/wrench_plots/recording_pane.h"

namespace heft {
namespace {

/// A seed whose practice tool weighs between both [kg].
std::uint64_t toolBetween(double lightest, double heaviest) {
  std::uint64_t seed = QRandomGenerator::global()->bounded(1000000);
  while (true) {
    const double mass = practiceTool(++seed).mass;
    if (mass >= lightest && mass <= heaviest) return seed;
  }
}

QString nameNow(const char* what) {
  return QString::fromLatin1(what) + QDateTime::currentDateTime().toString(QStringLiteral("-yyyy-MM-dd-HHmm"));
}

}  // namespace

RecordPanel::RecordPanel(const StudioParts& parts) : StepPanel(parts), run_(onlyChild<LiveRun>(*parts.workspace)) {
  if (parts.view) {
    auto* playback = new Playback(this);
    ownPane_ = new RecordingPane(playback);
    ownPane_->setObjectName("livePlots");
    guide_ = new FlangeGuide(run_, parts.view, this);
  }
  connect(&workspace(), &Workspace::openedChanged, this, &RecordPanel::refresh);
  connect(&workspace(), &Workspace::reportChanged, this, &RecordPanel::refresh);
  connect(&workspace(), &Workspace::busyChanged, this, &StepPanel::stateChanged);
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
  return virtualRun() ? tr("Drag the tool, or use arrow keys; with Shift they turn it")
                      : tr("Move the arm as the coach says, then press “Stop and keep”");
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

void RecordPanel::refresh() {
  if (run_->running()) return;
  if (way_ == Way::live && form_) {
    emit stateChanged();
    return;  // What is typed in stays.
  }
  form_ = nullptr;
  const auto opened = workspace().opened();
  QVBoxLayout* column = nullptr;
  switch (way_) {
    case Way::files:
      column = page()->restart(tr("What does your tool weigh?"),
                               tr("Open a recording of the arm moving with its tool. Heft finds mass, centre of mass "
                                  "and inertia, and tells how sure each number is."));
      addWays(column);
      addFiles(column);
      break;
    case Way::live: {
      column =
          page()->restart(tr("Listen to your robot"), tr("Heft only listens: it moves nothing and changes nothing."));
      addWays(column);
      form_ = new SourceForm(page()->content());
      column->addWidget(form_);
      page()->setSecondButton({});
      page()->setMainButton(tr("Connect and record"), [this] { startListening(); });
      break;
    }
    case Way::virtualArm:
      column = page()->restart(tr("Try it without a robot"),
                               tr("The virtual arm follows your mouse as a hand-guided one follows your hand. Find out "
                                  "what its hidden tool weighs."));
      addWays(column);
      addVirtual(column);
      break;
  }
  column->addStretch(1);
  if (way_ == Way::files) {
    if (opened) {
      page()->setSecondButton(tr("Open another …"), [this] { parts().chooseFiles(); });
      page()->setMainButton(tr("See the result"), [this] { parts().goTo(Step::result); });
    } else {
      page()->setSecondButton({});
      page()->setMainButton(
          tr("Open a recording …"), [this] { parts().chooseFiles(); }, "open");
    }
  }
  emit stateChanged();
}

void RecordPanel::addWays(QVBoxLayout* column) {
  static constexpr std::pair<Way, const char*> kWays[] = {
      {Way::live, "hand"}, {Way::files, "folder"}, {Way::virtualArm, "tool"}};
  const auto spaced = [](const QString& text) { return QStringLiteral(" ") + text; };
  auto* ways = new Segments({spaced(tr("Live robot")), spaced(tr("Open files")), spaced(tr("Virtual arm"))},
                            {"wayLive", "wayFiles", "wayVirtual"}, page()->content());
  for (int i = 0; i < 3; ++i) {
    ways->button(i)->setIcon(themedIcon(kWays[i].second));
    if (kWays[i].first == way_) ways->setChosen(i);
  }
  connect(ways, &Segments::picked, this, [this](int i) { setWay(kWays[i].first); });
  column->addWidget(ways);
}

void RecordPanel::addFiles(QVBoxLayout* column) {
  QWidget* content = page()->content();
  const Card card = makeCard("card", content);
  card.layout->addWidget(styledLabel(tr("What a recording holds"), "sectionTitle", content));
  card.layout->addWidget(wrappedLabel(tr("Time, joint angles or sensor poses, and force and torque: a CSV, a ROS bag, "
                                         "MCAP or HDF5. A file NAME.meta.json beside it may name the robot and how the "
                                         "sensor is mounted."),
                                      "caption", content));
  card.layout->addWidget(wrappedLabel(tr("You can also drop a file anywhere in this window."), "caption", content));
  column->addWidget(card.frame);
  addOpened(column);
  addRecent(column);
  if (!workspace().opened()) addSamples(column);
}

/// For the first minutes: something to open, to guide, to find out.
void RecordPanel::addSamples(QVBoxLayout* column) {
  QWidget* content = page()->content();
  column->addSpacing(6);
  column->addWidget(styledLabel(tr("No recording at hand?"), "sectionTitle", content));
  for (const Sample& sample : samples()) {
    auto* button = new QPushButton(sample.title, content);
    button->setObjectName("sampleButton");
    button->setProperty("role", "plain");
    button->setToolTip(tr("Makes this recording with the simulation and opens it"));
    connect(button, &QPushButton::clicked, this, [this, sample] {
      sampling_.start(
          tr("Making a sample recording"), [sample](const Progress& progress) { return sampleFile(sample, progress); },
          [this](Result<QString> made) {
            if (!made) return parts().say(Severity::error, QString::fromStdString(made.error().message));
            workspace().open(*made);
          });
    });
    column->addWidget(button);
  }
  column->addWidget(wrappedLabel(tr("Or guide the virtual arm yourself (third tab above), or look for a hidden fault: "
                                    "menu Practice."),
                                 "caption", content));
}

void RecordPanel::addVirtual(QVBoxLayout* column) {
  QWidget* content = page()->content();
  column->addWidget(styledLabel(tr("Which tool does it carry?"), "sectionTitle", content));
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  auto* group = new QButtonGroup(content);
  const std::tuple<QString, QString, double, double> tools[] = {{tr("Surprise"), tr("anything"), 0.25, 1.6},
                                                                {tr("Light"), tr("below 0.5 kg"), 0.25, 0.5},
                                                                {tr("Heavy"), tr("over 1.1 kg"), 1.1, 1.6}};
  for (const auto& [name, detail, lightest, heaviest] : tools) {
    auto* card = new ChoiceCard(name, detail, content);
    group->addButton(card);
    card->setChecked(group->buttons().size() == 1);
    connect(card, &QAbstractButton::clicked, this, [this, a = lightest, b = heaviest] { tool_ = toolBetween(a, b); });
    row->addWidget(card);
  }
  column->addLayout(row);
  tool_ = toolBetween(0.25, 1.6);
  const Card card = makeCard("card", content);
  card.layout->addWidget(styledLabel(tr("How to guide it"), "sectionTitle", content));
  for (const QString& line :
       {tr("Drag the tool in the picture: the arm follows."), tr("Drag one of the three rings: the tool turns."),
        tr("Or use the arrow keys and Page Up, Page Down; with Shift they turn."),
        tr("The coach says what helps most. Let it be shown to you if you like.")})
    card.layout->addWidget(wrappedLabel(line, "caption", content));
  column->addWidget(card.frame);
  page()->setSecondButton(tr("Standing poses"), [this] { startVirtual(tool_, true, true); });
  page()->setMainButton(
      tr("Start guiding"), [this] { startVirtual(tool_, false, true); }, "hand");
}

void RecordPanel::addOpened(QVBoxLayout* column) {
  const Session& session = workspace().session();
  if (session.recordings.empty()) return;
  column->addSpacing(6);
  column->addWidget(styledLabel(tr("In this session"), "sectionTitle", page()->content()));
  for (int k = 0; k < static_cast<int>(session.recordings.size()); ++k) {
    const QString path = QString::fromStdString(session.recordings[static_cast<std::size_t>(k)].file.string());
    const auto opened = workspace().openedAt(k);
    const auto report = workspace().reportAt(k);
    QString text = QFileInfo(path).fileName();
    if (!opened) {
      text = tr("%1, not read").arg(text);
    } else if (report) {
      text = tr("%1, %2 kg").arg(text, numberText(report->payload.mass, 3));
    }
    auto* button = new QPushButton(text, page()->content());
    button->setObjectName(QStringLiteral("recording%1").arg(k));
    button->setProperty("role", k == session.active ? "chosen" : "plain");
    button->setToolTip(k == session.active ? tr("Shown now: %1").arg(path) : tr("Show %1").arg(path));
    button->setEnabled(opened != nullptr);
    connect(button, &QPushButton::clicked, this, [this, k] { workspace().activate(k); });
    column->addWidget(button);
  }
}

void RecordPanel::addRecent(QVBoxLayout* column) {
  const QStringList recent = parts().recentFiles();
  if (recent.isEmpty()) return;
  column->addSpacing(6);
  column->addWidget(styledLabel(tr("Recent files"), "sectionTitle", page()->content()));
  for (const QString& path : recent) {
    // Names alone repeat: with the folder and the day.
    const QFileInfo file(path);
    auto* button = new QPushButton(tr("%1   ·   %2, %3")
                                       .arg(file.fileName(), QDir(file.absolutePath()).dirName(),
                                            QLocale().toString(file.lastModified().date(), QLocale::ShortFormat)),
                                   page()->content());
    button->setObjectName("linkButton");
    button->setToolTip(path);
    button->setAccessibleName(tr("Open %1").arg(path));
    connect(button, &QPushButton::clicked, this, [this, path] { workspace().open(path); });
    column->addWidget(button);
  }
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
  if (!addresses) return fail(QString::fromStdString(addresses.error().message));
  auto meta = form_->meta();
  if (!meta) return fail(QString::fromStdString(meta.error().message));
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

void RecordPanel::showLive() {
  const bool poses = run_->poses();
  QVBoxLayout* column =
      poses ? page()->restart(tr("Hold the tool still, in several tilts"),
                              tr("Heft takes a pose by itself after one still second. Touch nothing with the tool."))
            : page()->restart(tr("Move the arm. Heft listens."),
                              tr("Guide it as you always do. Touch nothing with the tool."));
  board_ = new LiveBoard(run_, page()->content());
  connect(board_, &LiveBoard::posesWanted, this, &RecordPanel::changeWay);
  connect(board_, &LiveBoard::anotherToolWanted, this, &RecordPanel::changeTool);
  column->addWidget(board_);
  column->addStretch(1);
  if (poses) {
    page()->setSecondButton(tr("Discard"), [this] { discardPoses(); });
  } else {
    showPause();
  }
  page()->setMainButton(
      tr("Stop and keep"), [this] { stopAndKeep(); }, "check");
  page()->setMainEnabled(false, tr("Nothing has come yet."));
}

void RecordPanel::showPause() {
  page()->setSecondButton(
      run_->paused() ? tr("Resume") : tr("Pause"),
      [this] {
        run_->setPaused(!run_->paused());
        showPause();
        emit stateChanged();
      },
      run_->paused() ? "play" : "pause");
}

void RecordPanel::liveRefreshed() {
  if (!run_->running() || !board_) return;
  const LiveView& now = run_->view();
  board_->refresh();
  const bool enough = run_->poses() ? now.poses.size() >= 2 : now.any;
  if (enough != page()->mainButton()->isEnabled())
    page()->setMainEnabled(enough, run_->poses() ? tr("Two poses at least are needed.") : tr("Nothing has come yet."));
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
  // Clearly another weight, as when somebody really changes a tool.
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
  parts().say(Severity::info, tr("Recording saved: %1").arg(file));
  if (assumed && parts().editRig)
    parts().offer(
        Severity::warning,
        tr("Nobody said how the sensor sits on the flange, so Heft took its axes for the flange’s. A sensor that "
           "sits elsewhere makes the inertia and the exported numbers wrong."),
        tr("Say it now …"), parts().editRig);
}

void RecordPanel::keepUnderWay() {
  if (run_->running()) keepAside();
}

bool RecordPanel::mayEnd() {
  if (!run_->running()) return true;
  if (parts().asks) {
    QMessageBox box(QMessageBox::NoIcon, tr("Heft Studio"), tr("A recording is under way. Stop it?"),
                    QMessageBox::NoButton, this);
    box.setInformativeText(tr("What has come so far is kept in %1.").arg(recordedFolder()));
    auto* stop = box.addButton(tr("Stop and keep"), QMessageBox::AcceptRole);
    auto* goOn = box.addButton(tr("Go on recording"), QMessageBox::RejectRole);
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
    QMessageBox box(QMessageBox::NoIcon, tr("Heft Studio"), tr("Throw %n pose(s) away?", "", count),
                    QMessageBox::NoButton, this);
    auto* away = box.addButton(tr("Throw away"), QMessageBox::DestructiveRole);
    auto* goOn = box.addButton(tr("Go on recording"), QMessageBox::RejectRole);
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

void RecordPanel::addActions(const StudioMenus& menus) {
  menus.file->addAction(tr("Save &recording as …"), this, &RecordPanel::saveRecordingAs)
      ->setObjectName("saveRecordingAs");
  menus.file->addAction(tr("Open the recordings f&older"), this, [] {
    QDir().mkpath(recordedFolder());
    QDesktopServices::openUrl(QUrl::fromLocalFile(recordedFolder()));
  });
}

std::optional<Result<bool>> RecordPanel::obey(const QStringList& words) {
  if (words[0] != "live") return std::nullopt;
  const auto wrong = [](const QString& sentence) { return Result<bool>(Error{sentence.toStdString()}); };
  const QString what = words.value(1);
  bool numbers = true;
  const auto number = [&](int index, double otherwise) {
    if (words.size() <= index) return otherwise;
    bool ok = false;
    const double value = words[index].toDouble(&ok);
    numbers = numbers && ok;
    return value;
  };
  if (what == "virtual" || what == "poses") {
    const double seconds = number(2, 0.0), seed = number(3, 1.0);
    if (!numbers || seconds < 0 || seconds > 7200 || seed < 0)
      return wrong(tr("live %1 expects seconds and a tool's number.").arg(what));
    startVirtual(static_cast<std::uint64_t>(seed), what == "poses", false);
    if (!run_->running()) return wrong(tr("The virtual arm did not start."));
    if (what == "virtual") run_->virtualArm()->guide([](GuidedArm& arm) { arm.wander(); });
    run_->pass(seconds);
    return Result<bool>(true);
  }
  if (what == "form") {
    way_ = Way::live;
    refresh();
    return Result<bool>(true);
  }
  if (what == "replay" && words.size() >= 3) {
    way_ = Way::live;
    form_ = nullptr;
    LiveOrigin origin{0, {"replay:" + words[2].toStdString() + "?speed=20"}, {}, {}, false};
    Findings findings;
    if (QFileInfo::exists(QString::fromStdString(metaFileOf(words[2].toStdString()).string()))) {
      auto meta = readMeta(metaFileOf(words[2].toStdString()), findings);
      if (!meta) return Result<bool>(meta.error());
      origin.meta = std::move(*meta);
      origin.meta.numbersArePlain();
    }
    listenTo(std::move(origin), false);
    if (!run_->running()) return wrong(tr("%1 could not be played.").arg(words[2]));
    // The script goes on when all has come and has been learned.
    waiting_.start(
        QString(),
        [session = run_->session()](const Progress& progress) -> Result<bool> {
          const auto under = [&](LinkState state) {
            return state == LinkState::connecting || state == LinkState::live;
          };
          while (!progress.cancelled() && under(session->status().sources.front().state))
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
          std::this_thread::sleep_for(std::chrono::milliseconds(300));
          return true;
        },
        [](Result<bool>) {});
    return Result<bool>(true);
  }
  if (!run_->running()) return wrong(tr("Nothing is being recorded: begin with live virtual or live replay."));
  if (what == "pass") {
    const double seconds = number(2, 0.0);
    if (!numbers || seconds < 0 || !run_->virtualArm()) return wrong(tr("live pass expects seconds of a virtual arm."));
    run_->pass(seconds);
    return Result<bool>(true);
  }
  if (what == "guide" && run_->virtualArm()) {
    const Vector3d shift(number(2, 0), number(3, 0), number(4, 0)), turn(number(5, 0), number(6, 0), number(7, 0));
    if (!numbers) return wrong(tr("live guide expects metres and, if you like, radians."));
    run_->virtualArm()->guide([&](GuidedArm& arm) { FlangeGuide::nudge(arm, shift, turn); });
    return Result<bool>(true);
  }
  if (what == "show") return run_->makeAdvised() ? Result<bool>(true) : wrong(tr("There is nothing to be shown now."));
  if (what == "change") return changeTool(), Result<bool>(true);
  if (what == "stop") return stopAndKeep(), Result<bool>(true);
  if (what == "discard") {
    run_->discard();
    showNoLive();
    return Result<bool>(true);
  }
  return wrong(tr("live expects virtual, poses, replay, pass, guide, show, change, stop or discard."));
}

}  // namespace heft
