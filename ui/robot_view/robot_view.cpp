#include "ui/robot_view/robot_view.h"

#include <QEvent>
#include <QPainter>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/robot_view/label_overlay.h"
#include "ui/robot_view/mounted_links.h"
#include "ui/robot_view/scene_state.h"
#include "ui/robot_view/shown_motion.h"
#include "ui/robot_view/view_tools.h"
#include "ui/robot_view/viewport.h"

namespace heft {
namespace {

constexpr double kGravity = 9.81;

/// Thickness of the sensor's body [m]: what the mount leaves between its parent and S, kept in a plausible range.
double sensorBodyLength(const SensorMount& mount) { return std::clamp(mount.xyz.norm(), 0.012, 0.045); }

}  // namespace

struct RobotView::LookBefore {
  OrbitCamera camera;
  Preset preset;
  bool touched;
};

struct RobotView::Kept {
  std::shared_ptr<const Recording> recording;
  std::shared_ptr<const RobotModel> robot;
  std::shared_ptr<const RobotLook> look;
  std::shared_ptr<const EstimateReport> report;
  double time = 0.0;
};

RobotView::RobotView(QWidget* parent)
    : QWidget(parent),
      viewport_(new Viewport(this)),
      scene_(viewport_->scene()),
      parts_(std::make_unique<SceneParts>()) {
  setObjectName("robotView");
  setMinimumSize(240, 120);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  viewport_->setObjectName("viewport");
  viewport_->setAccessibleName(tr("3D view of robot and tool"));
  viewport_->setAccessibleDescription(tr("Arrow keys turn the view, with Shift they move it, plus and minus zoom"));
  layout->addWidget(viewport_);
  overlay_ = new LabelOverlay(viewport_);
  overlay_->setUnderlay([this](QPainter& painter) { paintOver(painter); });
  marks_ = std::make_unique<ViewMarks>(viewport_);
  note_ = std::make_unique<StepNote>(viewport_, [this] { updateLabels(); });
  tools_ = new ViewTools(parts_.get(), &labelsShown_, viewport_);
  connect(tools_, &ViewTools::presetWanted, this, &RobotView::usePreset);
  connect(tools_, &ViewTools::partsChanged, this, &RobotView::applyParts);
  connect(tools_, &ViewTools::pictureWanted, this, &RobotView::pictureWanted);
  handles_ = new HandleLayer(viewport_, overlay_, this);
  connect(viewport_, &Viewport::rendered, this, &RobotView::updateLabels);
  connect(viewport_, &Viewport::cameraMoved, this, [this] { cameraTouched_ = true; });
  usePreset(Preset::overview);
}

RobotView::~RobotView() = default;

void RobotView::showRobot(std::shared_ptr<const RobotModel> robot, std::shared_ptr<const RobotLook> look) {
  standIn_ = robot;
  standInLook_ = look;
  if (motion_ && !robot_ && !motion_->standsIn()) {
    poseStandIn();
    sweep_ = motion_->sweep();
    updateInstant();
    updateNote();
    if (!cameraTouched_) usePreset(preset_);
  }
  if (motion_) return;
  if (kept_) {  // Behind what is live.
    if (!kept_->recording) kept_->robot = std::move(robot), kept_->look = std::move(look);
    return;
  }
  robot_ = std::move(robot);
  marks_->setRobot(robot_);
  look_ = look;
  scene_.setRobot(std::move(look), {});
  if (robot_) {
    std::vector<Isometry3d> X_BL;
    robot_->linkPoses(robot_->homePosture(), X_BL);
    // Until a recording states where the sensor is, the tool is mounted on the flange.
    if (const auto flange = robot_->findLink("panda_link8")) placeSensor(X_BL[static_cast<std::size_t>(*flange)]);
    scene_.X_BL = X_BL;
  }
  usePreset(Preset::overview);
}

void RobotView::setGravity(const Vector3d& gravity) {
  if (gravity.norm() > 0) scene_.down = gravity.normalized();
}

void RobotView::dress(std::shared_ptr<const RobotLook> look, const SensorMount& mount) {
  clearEstimate();
  marks_->setRobot(robot_);
  look_ = robot_ ? std::move(look) : nullptr;
  const bool ownSensor = look_ && showsSensor(*robot_, *look_);
  scene_.setRobot(look_, robot_ ? linksBeyond(*robot_, mount.parent) : std::vector<bool>{});
  scene_.sensorShown = true;
  scene_.sensorLength = ownSensor ? 0.0 : sensorBodyLength(mount);
}

void RobotView::poseStandIn() {
  if (!motion_ || !standIn_ || !standInLook_ || !motion_->follow(standIn_)) return;
  look_ = standInLook_;
  // All of it translucent: it was not recorded.
  scene_.setRobot(look_, std::vector<bool>(standIn_->links().size(), true));
}

void RobotView::showRecording(std::shared_ptr<const Recording> recording, std::shared_ptr<const RobotModel> robot,
                              std::shared_ptr<const RobotLook> look) {
  kept_.reset();
  robot_ = std::move(robot);
  motion_ = std::make_unique<ShownMotion>(std::move(recording), robot_);
  const auto& meta = motion_->recording()->meta;
  dress(std::move(look), meta.mount);
  setGravity(meta.gravity);
  poseStandIn();
  time_ = motion_->firstTime();
  rebuildPath();
  sweep_ = motion_->sweep();
  updateInstant();
  // A session that comes back in the step Shape is there before its recording.
  usePreset(editing_ ? Preset::tool : Preset::overview);
  updateNote();
}

void RobotView::showNothing() {
  kept_.reset();
  motion_.reset();
  clearEstimate();
  marks_->clear();
  sweep_.clear();
  scene_.path.reset();
  scene_.sensorShown = false;
  robot_.reset();
  marks_->setRobot(nullptr);
  look_.reset();
  scene_.setRobot(nullptr, {});
  updateNote();
  viewport_->requestFrame();
}

void RobotView::beginLive(std::shared_ptr<const RobotModel> robot, std::shared_ptr<const RobotLook> look,
                          const SensorMount& mount, const Vector3d& gravity) {
  if (!kept_)
    kept_ = std::make_unique<Kept>(Kept{motion_ ? motion_->recording() : nullptr, robot_, look_, report_, time_});
  motion_.reset();
  robot_ = std::move(robot);
  dress(std::move(look), mount);
  setGravity(gravity);
  scene_.path.reset();
  sweep_.clear();
  if (robot_) {
    std::vector<Isometry3d> X_BL;
    robot_->linkPoses(robot_->homePosture(), X_BL);
    scene_.X_BL = X_BL;
    const auto link = robot_->findLink(mount.parent);
    const Isometry3d X_BS =
        X_BL[link ? static_cast<std::size_t>(*link) : X_BL.size() - 1] * poseFromXyzRpy(mount.xyz, mount.rpy);
    placeSensor(X_BS);
    // Room for the motion to come.
    for (int axis = 0; axis < 3; ++axis)
      for (const double side : {-0.28, 0.28}) sweep_.push_back(X_BS.translation() + side * Vector3d::Unit(axis));
    sweep_.push_back(X_BS.translation() + Vector3d(0.0, 0.0, 0.45));
  }
  usePreset(Preset::overview);
  updateNote();
}

void RobotView::showLive(const LiveMoment& moment) {
  if (!kept_) return;
  if (moment.q && robot_ && moment.q->size() == robot_->dof()) {
    std::vector<Isometry3d> X_BL;
    robot_->linkPoses(*moment.q, X_BL);
    scene_.X_BL = X_BL;
  }
  report_ = moment.report;
  if (report_) {
    showPayload();
    showWrench(moment.X_BS, moment.wrench);
  }
  placeSensor(moment.X_BS);
  viewport_->requestFrame();
}

void RobotView::showLivePath(const std::vector<Vector3d>& path) {
  if (!kept_) return;
  std::vector<PathSample> samples;
  for (const Vector3d& point : path) samples.push_back({point, MarkLabel::free});
  scene_.path = std::make_shared<const std::vector<PathSample>>(std::move(samples));
}

void RobotView::endLive() {
  const auto kept = std::move(kept_);
  if (!kept) return;
  marks_->setGhostLabel({}, {});
  if (kept->recording) {
    showRecording(kept->recording, kept->robot, kept->look);
    showReport(kept->report);
    showTime(kept->time);
    return;
  }
  clearEstimate();
  sweep_.clear();
  scene_.path.reset();
  if (kept->robot && kept->look) showRobot(kept->robot, kept->look);
  updateNote();
}

void RobotView::showPayload() {
  std::optional<PayloadLook> look;
  if (report_ && report_->trust != Trust::none && (motion_ || kept_)) look = payloadLook(*report_);
  scene_.payload = look;
}

void RobotView::clearEstimate() {
  report_.reset();
  showPayload();
  scene_.wrench.reset();
}

void RobotView::showReport(std::shared_ptr<const EstimateReport> report) {
  if (kept_) {
    kept_->report = std::move(report);
    return;
  }
  report_ = std::move(report);
  showPayload();
  if (report_ && motion_) rebuildPath();
  updateInstant();
  // The labels that come with an estimate need room at the right.
  if (!cameraTouched_) usePreset(preset_);
}

void RobotView::showTime(double time) {
  if (kept_) {
    kept_->time = time;
    return;
  }
  if (time == time_) return;
  time_ = time;
  if (motion_ && !motion_->pathHolds(pathAbout_, time_)) rebuildPath();
  updateInstant();
}

void RobotView::rebuildPath() {
  pathAbout_ = time_;
  scene_.path = std::make_shared<const std::vector<PathSample>>(
      motion_->path(time_, report_ ? report_->segments : std::vector<Segment>{}));
}

void RobotView::updateInstant() {
  if (!motion_) return;
  const Isometry3d X_BS = motion_->track().sensorAt(time_);
  if (report_) showWrench(X_BS, motion_->track().wrenchAt(time_));
  placeSensor(X_BS);
  if (auto X_BL = motion_->linksAt(time_); !X_BL.empty()) scene_.X_BL = std::move(X_BL);
  viewport_->requestFrame();
}

void RobotView::showWrench(const Isometry3d& X_BS, Vector6d wrench) {
  // Without bias the arrows show what the tool really needs: its weight and the forces that move it.
  wrench.head<3>() -= report_->forceBias;
  wrench.tail<3>() -= report_->torqueBias;
  Vector6d inBase;
  inBase << X_BS.linear() * wrench.head<3>(), X_BS.linear() * wrench.tail<3>();
  const double weight = std::max(0.5, report_->payload.mass * kGravity);
  scene_.wrench = inBase;
  scene_.fullForce = weight;
  scene_.fullTorque = std::max(0.05, weight * report_->payload.com.norm() * 1.5);
}

void RobotView::placeSensor(const Isometry3d& X_BS) {
  scene_.X_BS = X_BS;
  handles_->setPose(X_BS);
}

Isometry3d RobotView::sensorPose() const { return scene_.X_BS; }

void RobotView::showTool(std::vector<ShapeBody> bodies, int selected) {
  tool_ = std::move(bodies);
  scene_.setTool(tool_, selected);
  if (editing_) applyParts();
  viewport_->requestFrame();
}

void RobotView::setToolEditing(bool editing) {
  if (editing == editing_) return;
  editing_ = editing;
  if (editing) {
    before_ = std::make_unique<LookBefore>(LookBefore{viewport_->camera(), preset_, cameraTouched_});
    applyParts();
    usePreset(Preset::tool);
  } else {
    applyParts();
    if (before_ && before_->touched) {
      viewport_->camera() = before_->camera;
      preset_ = before_->preset;
      cameraTouched_ = true;
    } else if (before_) {
      usePreset(before_->preset);
    }
    before_.reset();
  }
  viewport_->requestFrame();
}

void RobotView::applyParts() {
  SceneParts shown = *parts_;
  if (editing_) {
    shown.path = shown.arrows = shown.axes = shown.payload = false;
    shown.tool = !tool_.empty();  // Nothing is assumed while nothing was chosen: no hand of the model's either.
  }
  scene_.parts = shown;
  viewport_->requestFrame();
}

void RobotView::paintOver(QPainter& painter) const {
  const HandleSet::View view = viewport_->shownView();
  marks_->paint(painter, view);
  handles_->paint(painter, view);
}

void RobotView::usePreset(Preset preset) {
  preset_ = preset;
  cameraTouched_ = false;
  OrbitCamera& camera = viewport_->camera();
  turnTo(camera, preset);
  if (preset == Preset::tool && editing_) turnToAxes(camera, scene_.X_BS.linear());
  std::vector<Vector3d> points = preset == Preset::tool ? scene_.toolOutline(editing_) : scene_.outline();
  // The whole recording shall stay in the picture, not only this instant.
  if (preset != Preset::tool) points.insert(points.end(), sweep_.begin(), sweep_.end());
  // Labels stand at the right, so the picture keeps that side free where something is labelled.
  camera.fit(points, viewport_->aspect(), editing_ ? 0.14 : 0.05, report_ || editing_ || kept_ ? 0.2 : 0.08);
  viewport_->requestFrame();
}

void RobotView::renderNow() { viewport_->renderNow(); }

QImage RobotView::picture() {
  renderNow();
  tools_->hide();
  QImage out = grab().toImage();
  tools_->show();
  return out;
}

double RobotView::lastFrameMilliseconds() const { return viewport_->lastFrameMilliseconds(); }

void RobotView::updateNote() {
  QString text;
  if (motion_ && !motion_->track().hasJoints()) {
    text = motion_->standsIn() ? tr("No joint angles recorded: a Panda that reaches these poses is shown")
           : motion_->track().positionKnown() ? tr("No robot in this recording: only the sensor is shown")
                                              : tr("No position in this recording: the sensor only rotates");
  }
  note_->setOtherwise(text);
}

void RobotView::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) {
    overlay_->update();
    viewport_->requestFrame();
  }
}

void RobotView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  tools_->arrange(size());
  overlay_->setGeometry(viewport_->rect());
  tools_->raise();
  if (!cameraTouched_) usePreset(preset_);
}

}  // namespace heft
