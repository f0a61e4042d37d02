#include "ui/record_panel/live_stage.h"

#include <cmath>
#include <utility>

#include "core/estimation/estimate.h"
#include "ui/live/live_run.h"
#include "ui/live/live_words.h"
#include "ui/models/numbers.h"
#include "ui/robot_view/robot_view.h"

namespace heft {

LiveStage::LiveStage(LiveRun* run, RobotView* view, bool animated, QObject* parent)
    : QObject(parent), run_(run), view_(view), animated_(animated) {
  connect(run_, &LiveRun::refreshed, this, &LiveStage::refresh);
  connect(run_, &LiveRun::adviceChanged, this, &LiveStage::showAdvice);
  ghostClock_.start();
}

LiveStage::~LiveStage() { leave(); }

void LiveStage::setLook(std::shared_ptr<const RobotLook> look) {
  look_ = std::move(look);
  begun_ = false;
  refresh();
}

void LiveStage::enter() {
  entered_ = true;
  begun_ = false;
  refresh();
}

void LiveStage::leave() {
  if (!entered_ || !view_) return;
  entered_ = false;
  view_->note().setText({});
  view_->marks().showGhost(std::nullopt);
  view_->marks().showGhostWay({});
  view_->marks().showGap(std::nullopt);
  view_->marks().showHulls({});
  hulls_ = nullptr;
  if (begun_) view_->endLive();
}

void LiveStage::refresh() {
  if (!entered_ || !run_->running()) return;
  const LiveView& now = run_->view();
  view_->note().setText(run_->paused() ? tr("Paused at %1 s").arg(numberText(now.time, 1))
                        : run_->poses()
                            ? tr("● Standing poses  %1 s").arg(numberText(now.time, 1))
                            : tr("● Recording %1 s   %2 Hz").arg(numberText(now.time, 1), numberText(now.rateHz, 0)));
  if (!now.any) return;
  if (!begun_) {
    if (now.q && !look_) return;  // It is being loaded.
    begun_ = true;
    view_->beginLive(now.q ? run_->robot() : nullptr, now.q ? look_ : nullptr, run_->meta().mount,
                     run_->meta().gravity);
    showAdvice();
  }
  LiveMoment moment;
  moment.q = now.q;
  moment.X_BS = now.X_BS;
  moment.wrench = now.wrench;
  if (now.state.estimated) {
    auto report = std::make_shared<EstimateReport>();
    report->payload = now.state.payload;
    report->std = now.state.std;
    report->identifiability = now.state.identifiability;
    report->physicallyConsistent = checkPhysical(now.state.payload).physical;
    report->forceBias = now.state.bias.head<3>();
    report->torqueBias = now.state.bias.tail<3>();
    moment.report = std::move(report);
  }
  view_->showLive(moment);
  if (refreshes_++ % 5 == 0 || !animated_) view_->showLivePath(now.path);
  showGhost();
}

void LiveStage::showAdvice() {
  if (!entered_ || !begun_) return;
  std::vector<Vector3d> way;
  QString note;
  const auto& advice = run_->advice();
  if (advice && advice->needed && run_->robot() && advice->motion.size() > 1) {
    const auto tool = guidedTool(*run_->robot(), run_->meta().mount);
    // Half of the motion: the way there. A point a hand's breadth out of the sensor shows turns, too.
    VectorXd q, dq, ddq;
    constexpr int kPoints = 40;
    for (int k = 0; tool && k <= kPoints; ++k) {
      advice->motion.at(0.5 * advice->motion.duration() * k / kPoints, q, dq, ddq);
      way.push_back(run_->robot()->linkPose(q, tool->link) * tool->X_LS * Vector3d(0.06, 0.0, 0.12));
    }
    note = coachShort(*advice);
  }
  view_->marks().showGhostWay(way);
  view_->marks().setGhostLabel(way.empty() ? QString() : tr("Move like this"), note);
  showGhost();
}

void LiveStage::showGhost() {
  if (!entered_ || !begun_) return;
  std::optional<VectorXd> q;
  const auto& advice = run_->advice();
  if (run_->poses()) {
    if (run_->view().next) q = run_->view().next->q;
  } else if (advice && advice->needed && advice->motion.size() > 1) {
    if (animated_) {
      VectorXd dq, ddq;
      q.emplace();
      const double t = static_cast<double>(ghostClock_.elapsed()) / 1000.0;
      advice->motion.at(std::fmod(t, advice->motion.duration()), *q, dq, ddq);
    } else {
      q = advice->target;
    }
  }
  view_->marks().showGhost(q);
  showGap(q ? q : run_->view().q);
}

void LiveStage::showGap(const std::optional<VectorXd>& q) {
  const Clearance* clearance = run_->clearance();
  if (!clearance || !q) return view_->marks().showGap(std::nullopt);
  if (std::exchange(hulls_, clearance) != clearance) view_->marks().showHulls(clearance->hulls());
  view_->marks().showGap(clearance->nearest(*q));
}

}  // namespace heft
