#include "ui/reality_panel/deciding_motion.h"

#include <algorithm>
#include <cmath>

#include "ui/controller/workspace.h"
#include "ui/live/live_words.h"
#include "ui/robot_view/robot_view.h"
#include "ui/timeline/playback.h"

namespace heft {
namespace {

constexpr int kFrame = 33;  ///< [ms]

}  // namespace

DecidingMotion::DecidingMotion(Workspace* workspace, RobotView* view, const Playback* playback, QObject* parent)
    : QObject(parent), workspace_(workspace), view_(view), playback_(playback) {
  timer_.setInterval(kFrame);
  connect(&timer_, &QTimer::timeout, this, &DecidingMotion::step);
}

DecidingMotion::~DecidingMotion() { hide(); }

bool DecidingMotion::possible() const {
  const auto opened = workspace_->opened();
  return view_ && opened && opened->robot && opened->recording.q.rows() > 0;
}

void DecidingMotion::show(const std::string& motion) {
  hide();
  if (!possible()) return;
  const auto opened = workspace_->opened();
  const VectorXd& time = opened->recording.time;
  const auto row = std::clamp<Eigen::Index>(
      std::lower_bound(time.data(), time.data() + time.size(), playback_->time()) - time.data(), 0, time.size() - 1);
  auto room = Result<Room>(Room());
  if (const auto& file = workspace_->session().room; !file.empty()) room = readRoom(file);
  if (!room) return emit failed(QString::fromStdString(room.error().message));
  around_ = std::make_shared<ArmSurroundings>(opened->robot, opened->recording.meta.mount,
                                              estimateOptions(workspace_->session()).shape, std::move(*room));
  jobs_.start(
      QString(),
      [opened, motion, around = around_,
       q = VectorXd(opened->recording.q.row(row).transpose())](const Progress&) -> Result<Advice> {
        const auto tool = guidedTool(*opened->robot, opened->recording.meta.mount);
        if (!tool) return tool.error();
        CoachOptions options;
        options.limits.clearance = around->clearance();
        return namedMotion(motion, *tool, opened->robot->clampToLimits(q), options);
      },
      [this](Result<Advice> advice) {
        if (advice) {
          begin(std::move(*advice));
        } else {
          emit failed(QString::fromStdString(advice.error().message));
        }
      });
}

void DecidingMotion::begin(Advice advice) {
  const auto opened = workspace_->opened();
  if (!view_ || !opened || !opened->robot) return;
  advice_ = std::move(advice);
  std::vector<Vector3d> way;
  if (const auto tool = guidedTool(*opened->robot, opened->recording.meta.mount)) {
    // Half of the motion: the way there. A point a hand's breadth out of the sensor shows turns, too.
    constexpr int kPoints = 40;
    VectorXd q, dq, ddq;
    for (int k = 0; k <= kPoints; ++k) {
      advice_->motion.at(0.5 * advice_->motion.duration() * k / kPoints, q, dq, ddq);
      way.push_back(opened->robot->linkPose(q, tool->link) * tool->X_LS * Vector3d(0.06, 0.0, 0.12));
    }
  }
  view_->marks().showGhostWay(way);
  view_->marks().setGhostLabel(tr("Move like this"), coachShort(*advice_));
  if (const Clearance* clearance = around_->ready()) view_->marks().showHulls(clearance->hulls());
  showAt(advice_->target);
  clock_.start();
  timer_.start();
}

void DecidingMotion::step() {
  if (!advice_ || !view_) return;
  // Start at the farthest point of the motion, which shows most at a glance.
  VectorXd q, dq, ddq;
  const double duration = advice_->motion.duration();
  advice_->motion.at(std::fmod(0.25 * duration + static_cast<double>(clock_.elapsed()) / 1000.0, duration), q, dq, ddq);
  showAt(q);
}

void DecidingMotion::showAt(const VectorXd& q) {
  view_->marks().showGhost(q);
  if (const Clearance* clearance = around_->ready()) view_->marks().showGap(clearance->nearest(q));
}

void DecidingMotion::hide() {
  jobs_.cancel();
  timer_.stop();
  if (!advice_ || !view_) return;
  advice_.reset();
  view_->marks().showGhost(std::nullopt);
  view_->marks().showGhostWay({});
  view_->marks().showGap(std::nullopt);
  view_->marks().showHulls({});
  view_->marks().setGhostLabel({}, {});
}

}  // namespace heft
