#include "ui/live/live_run.h"
#include "ui/controller/free_file.h"

#include <QDir>
#include <QFile>
#include <algorithm>
#include <utility>

#include "core/motion/motion.h"
#include "core/recording/csv_reader.h"

namespace heft {
namespace {

constexpr int kTick = 33;              ///< [ms] What was learned is shown so often.
constexpr double kPiece = 0.5;         ///< [s] of virtual time at once
constexpr double kAdviseEvery = 2.5;   ///< [s] A ghost that is older stands where the arm no longer is.
constexpr double kFirstAdvice = 0.5;   ///< [s]
constexpr double kLongestTick = 0.25;  ///< [s] After a hitch the virtual arm does not run after the time lost.

}  // namespace

LiveRun::LiveRun(QObject* parent) : QObject(parent) {
  timer_.setInterval(kTick);
  connect(&timer_, &QTimer::timeout, this, &LiveRun::tick);
}

LiveRun::~LiveRun() { stop(); }

Result<bool> LiveRun::start(LiveSetup setup, bool byClock) {
  stop();
  auto session = std::make_shared<LiveSession>(30000);
  for (auto& source : setup.sources) session->addSource(std::move(source));
  session->setConventions(setup.meta.conventions);
  QString file;
  if (!setup.poses) {
    if (!QDir().mkpath(setup.folder))
      return Error{tr("The folder %1 for recordings cannot be created.").arg(setup.folder).toStdString()};
    file = freeFile(setup.folder, setup.name, QStringLiteral("csv"));
    // If no robot is stated, the first samples show that it is a Panda; the meta file must then say so, too.
    if (auto recorded = session->record(file.toStdString(), setup.meta); !recorded) return recorded.error();
  }
  if (auto running = session->start(); !running) {
    session->endRecording();
    return running;
  }
  ++run_;
  session_ = std::move(session);
  virtualArm_ = setup.virtualArm;
  robot_ = setup.robot;
  meta_ = setup.meta;
  shape_ = setup.shape;
  room_ = std::move(setup.room);
  around_.reset();
  origin_ = setup.origin;
  poses_ = setup.poses;
  paused_ = false;
  byClock_ = byClock;
  file_ = file;
  folder_ = setup.folder;
  name_ = setup.name;
  underWay_ = file.isEmpty() ? nullptr : std::make_unique<UnderWay>(file);
  learner_.reset();
  view_ = {};
  advice_.reset();
  advisedAt_ = -1e9;
  refusal_.clear();
  tools_ = 1;
  removals_.clear();
  owed_ = 0.0;
  clock_.start();
  if (byClock_ || !virtualArm_) timer_.start();
  emit started();
  return true;
}

void LiveRun::setPaused(bool paused) {
  if (!session_) return;
  paused_ = paused;
  session_->setPaused(paused);
  emit refreshed();
}

SessionStatus LiveRun::status() const { return session_ ? session_->status() : SessionStatus(); }

bool LiveRun::finished() const {
  if (!session_) return false;
  const auto status = session_->status();
  return std::all_of(status.sources.begin(), status.sources.end(),
                     [](const SourceStatus& source) { return source.state == LinkState::finished; });
}

void LiveRun::tick() {
  const double passed = std::min(kLongestTick, static_cast<double>(clock_.restart()) / 1000.0);
  if (virtualArm_ && !paused_) virtualArm_->advance(passed);
  pump();
}

void LiveRun::pass(double seconds) {
  if (!virtualArm_) return;
  owed_ += seconds;
  pump();
}

/// The robot and the learner, once a sample shows whether there are joint angles.
bool LiveRun::prepare(const LiveSample& first) {
  if (first.q && !robot_) {
    if (!meta_.robot) meta_.robot = "panda";
    Findings findings;
    auto robot = robotFor(meta_, findings);
    if (!robot) return stop(), emit failed(QString::fromStdString(robot.error().message)), false;
    robot_ = std::make_shared<const RobotModel>(std::move(*robot));
    // At once, so that an interrupted recording states it, too.
    if (!file_.isEmpty()) (void)writeMeta(meta_, metaFileOf(file_.toStdString()));
  }
  if (first.q && first.joints != robot_->dof()) {
    stop();
    emit failed(tr("The source sends %1 joints, the robot has %2: name the right robot in the setup file.")
                    .arg(first.joints)
                    .arg(robot_->dof()));
    return false;
  }
  if (robot_) around_ = std::make_shared<ArmSurroundings>(robot_, meta_.mount, shape_, room_);
  auto learner = LiveLearner::create({meta_, first.q ? robot_ : nullptr, shape_, poses_, around_});
  if (!learner) return stop(), emit failed(QString::fromStdString(learner.error().message)), false;
  learner_ = std::move(*learner);
  return true;
}

void LiveRun::pump() {
  if (!session_ || learning().running()) return;
  if (!byClock_ && virtualArm_) {
    // Step by step the coach keeps up, so that the same steps always give the same advice.
    if (coaching().running()) return;
    const double piece = std::min(owed_, kPiece);
    if (piece <= 0.0 && removals_.empty()) return;
    owed_ = owed_ - piece < 1e-9 ? 0.0 : owed_ - piece;
    virtualArm_->advance(piece);
  }
  for (const SourceStatus& source : session_->status().sources) {
    if (source.state != LinkState::failed) continue;
    stop();
    return emit failed(QString::fromStdString(source.text));
  }
  auto fresh = std::make_shared<std::vector<LiveSample>>();
  session_->takeNew(*fresh);
  // While waiting for the first sample, the user sees the state of the sources.
  if (!learner_ && fresh->empty()) return emit refreshed();
  if (!learner_ && !prepare(fresh->front())) return;
  if (fresh->empty() && view_.any && removals_.empty()) return emit refreshed();
  learning().start(
      QString(),
      [learner = learner_, fresh, removals = std::exchange(removals_, {})](const Progress&) -> Result<LiveView> {
        for (const std::size_t pose : removals) learner->removePose(pose);
        for (const LiveSample& sample : *fresh) learner->add(sample);
        return learner->view();
      },
      [this, run = run_](Result<LiveView> result) {
        if (run != run_ || !session_) return pump();
        if (!result) return emit failed(QString::fromStdString(result.error().message));
        if (!result->problem.empty()) {
          stop();
          return emit failed(QString::fromStdString(result->problem));
        }
        const std::size_t poses = view_.poses.size();
        view_ = std::move(*result);
        if (view_.state.tools != tools_) {
          tools_ = view_.state.tools;
          emit toolChanged();
        }
        if (view_.poses.size() != poses) emit poseTaken();
        emit refreshed();
        coach();
        goOn();
      });
}

/// Where a clock runs, the next turn is its: without pause the window would be drawn as fast as it can.
void LiveRun::goOn() {
  if (!timer_.isActive()) pump();
}

void LiveRun::coach() {
  if (!session_ || poses_ || paused_ || !robot_ || !view_.q || coaching().running()) return;
  // A motion that the virtual arm is making is not to be replaced under it.
  if (virtualArm_) {
    bool making = false;
    virtualArm_->guide([&](GuidedArm& arm) {
      making = arm.mode() == GuidedArm::Mode::approaching || arm.mode() == GuidedArm::Mode::following;
    });
    if (making) return;
  }
  if (view_.time < kFirstAdvice || view_.time - advisedAt_ < kAdviseEvery) return;
  advisedAt_ = view_.time;
  coaching().start(
      QString(),
      [robot = robot_, meta = meta_, q = *view_.q, information = view_.information,
       around = around_](const Progress&) -> Result<Advice> {
        auto tool = guidedTool(*robot, meta.mount);
        if (!tool) return tool.error();
        CoachOptions options;
        options.limits.clearance = around->clearance();
        return advise(information ? std::optional(*information) : std::nullopt, *tool, meta.gravity,
                      robot->clampToLimits(q), options);
      },
      [this, run = run_](Result<Advice> result) {
        if (run != run_ || !session_) return pump();
        refusal_ = result ? QString() : QString::fromStdString(result.error().message);
        advice_.reset();
        if (result) advice_ = std::move(*result);
        advisedAt_ = view_.time;
        emit adviceChanged();
        goOn();
      });
}

bool LiveRun::makeAdvised() {
  if (!virtualArm_) return false;
  if (poses_) {
    if (!view_.next) return false;
    virtualArm_->guide([q = view_.next->q](GuidedArm& arm) { arm.goTo(q); });
    return true;
  }
  if (!advice_ || !advice_->needed || advice_->motion.size() < 2) return false;
  GuidedPath path;
  path.duration = advice_->motion.duration();
  path.at = [motion = advice_->motion](double t, VectorXd& q, VectorXd& dq, VectorXd& ddq) {
    motion.at(t, q, dq, ddq);
  };
  virtualArm_->guide([&](GuidedArm& arm) { arm.follow(path); });
  return true;
}

Recording LiveRun::poseRecording() const { return recordingOf(view_.poses, meta_); }

void LiveRun::removePose(int index) {
  if (!session_ || index < 0) return;
  removals_.push_back(static_cast<std::size_t>(index));
  pump();
}

QString LiveRun::stop() {
  if (!session_) return {};
  timer_.stop();
  session_->stop();
  const auto rows = session_->endRecording();
  session_.reset();
  underWay_.reset();
  virtualArm_ = nullptr;
  QString file = file_;
  if (!file.isEmpty() && rows < 2) {
    if (rows == 1) {  // Without a row the recorder leaves nothing.
      QFile::remove(file);
      QFile::remove(QString::fromStdString(metaFileOf(file.toStdString()).string()));
    }
    file.clear();
  }
  // What the first samples showed about the robot belongs in the recording.
  if (!file.isEmpty()) {
    if (auto written = writeMeta(meta_, metaFileOf(file.toStdString())); !written)
      emit failed(QString::fromStdString(written.error().message));
  }
  learning().cancel();
  coaching().cancel();
  emit ended();
  return file;
}

Result<QString> LiveRun::keep() {
  if (!session_) return QString();
  const bool poses = poses_;
  const Recording kept = poses ? poseRecording() : Recording();
  QString file = stop();
  if (!poses || kept.rows() < 2) return file;
  if (!QDir().mkpath(folder_))
    return Error{tr("The folder %1 for recordings cannot be created.").arg(folder_).toStdString()};
  QString path = freeFile(folder_, name_, QStringLiteral("csv"));
  if (auto written = writeRecording(kept, path.toStdString()); !written) return written.error();
  return path;
}

void LiveRun::discard() {
  const QString file = stop();
  if (file.isEmpty()) return;
  QFile::remove(file);
  QFile::remove(QString::fromStdString(metaFileOf(file.toStdString()).string()));
}

}  // namespace heft
