#include "ui/robot_view/robot_view.h"

#include <QAction>
#include <QEvent>
#include <QLabel>
#include <QMenu>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "ui/models/numbers.h"
#include "ui/robot_view/dimension_editor.h"
#include "ui/robot_view/gap_mark.h"
#include "ui/robot_view/label_overlay.h"
#include "ui/robot_view/posed_arm.h"
#include "ui/robot_view/scene_state.h"
#include "ui/robot_view/scene_track.h"
#include "ui/robot_view/viewport.h"
#include "ui/widgets/basics.h"

namespace heft {
namespace {

constexpr double kGravity = 9.81;

MarkLabel labelAt(const std::vector<Segment>& segments, double time) {
  for (const Segment& segment : segments) {
    if (time >= segment.from && time <= segment.to) return segment.label;
  }
  return MarkLabel::free;
}

/// Links that the mount's parent carries, the sensor itself excepted: they move with the tool and are drawn as it.
std::vector<bool> linksBeyond(const RobotModel& robot, const std::string& mountLink) {
  std::vector<bool> beyond(robot.links().size(), false);
  const auto mount = robot.findLink(mountLink);
  if (!mount) return beyond;
  // Parents come before children, but not in every URDF: repeat until nothing is added.
  for (bool added = true; added;) {
    added = false;
    for (const Joint& joint : robot.joints()) {
      if (beyond[joint.childLink] || !(joint.parentLink == *mount || beyond[joint.parentLink])) continue;
      if (robot.links()[joint.childLink].name.find("sensor") != std::string::npos) continue;
      beyond[joint.childLink] = true;
      added = true;
    }
  }
  return beyond;
}

/// Whether the robot's own shape has a sensor in it, which then need not be drawn a second time.
bool showsSensor(const RobotModel& robot, const RobotLook& look) {
  return std::any_of(look.parts.begin(), look.parts.end(), [&](const LookPart& part) {
    return robot.links()[part.link].name.find("sensor") != std::string::npos;
  });
}

/// The path of a longer recording [s] is a ball that shows nothing: it is drawn from so long before the instant shown
/// to so long after it [s], anew with each step [s].
constexpr double kWholePath = 60.0, kPathReach = 15.0, kPathStep = 2.0;

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
  note_ = styledLabel({}, "viewNote", viewport_);
  note_->hide();
  buildTools();
  editor_ = new DimensionEditor(
      viewport_, [this] { return placedDimensions(); },
      [this] { return handles_ ? handles_->current() : std::nullopt; });
  connect(editor_, &DimensionEditor::typed, this, &RobotView::dimensionTyped);
  connect(viewport_, &Viewport::rendered, this, &RobotView::updateLabels);
  connect(viewport_, &Viewport::cameraMoved, this, [this] { cameraTouched_ = true; });
  usePreset(Preset::overview);
}

RobotView::~RobotView() = default;

void RobotView::buildTools() {
  tools_ = new QWidget(viewport_);
  tools_->setObjectName("viewTools");
  tools_->setAttribute(Qt::WA_StyledBackground);
  auto* column = new QVBoxLayout(tools_);
  column->setContentsMargins(3, 3, 3, 3);
  column->setSpacing(2);
  auto* fit = new IconButton("home", tr("Show the whole arm (F)"), tools_);
  fit->setObjectName("fitButton");
  connect(fit, &QToolButton::clicked, this, [this] { usePreset(Preset::overview); });
  auto* tool = new IconButton("tool", tr("Zoom to the tool (T)"), tools_);
  tool->setObjectName("toolButton");
  connect(tool, &QToolButton::clicked, this, [this] { usePreset(Preset::tool); });

  auto* views = new IconButton("view", tr("View direction"), tools_);
  views->setPopupMode(QToolButton::InstantPopup);
  auto* viewMenu = new QMenu(views);
  const std::pair<QString, Preset> presets[] = {
      {tr("Front"), Preset::front}, {tr("Side"), Preset::side}, {tr("Top"), Preset::top}};
  for (const auto& [text, preset] : presets) {
    viewMenu->addAction(text, this, [this, p = preset] { usePreset(p); });
  }
  views->setMenu(viewMenu);

  auto* eye = new IconButton("eye", tr("Choose what is shown"), tools_);
  eye->setPopupMode(QToolButton::InstantPopup);
  auto* shown = new QMenu(eye);
  const auto addToggle = [&](const QString& text, bool* flag) {
    QAction* action = shown->addAction(text);
    action->setCheckable(true);
    action->setChecked(*flag);
    connect(action, &QAction::toggled, this, [this, flag](bool on) {
      *flag = on;
      applyParts();
    });
  };
  addToggle(tr("Tool"), &parts_->tool);
  addToggle(tr("Path"), &parts_->path);
  addToggle(tr("Force, torque and gravity"), &parts_->arrows);
  addToggle(tr("Sensor axes"), &parts_->axes);
  addToggle(tr("Centre of mass"), &parts_->payload);
  addToggle(tr("Floor grid"), &parts_->grid);
  addToggle(tr("Labels"), &labelsShown_);
  eye->setMenu(shown);

  auto* alone = new IconButton("fit", tr("Maximise the 3D view, or restore it (Shift+F11)"), tools_);
  alone->setObjectName("aloneButton");  // The window listens to it.
  auto* picture = new IconButton("camera", tr("Save a picture of this view"), tools_);
  connect(picture, &QToolButton::clicked, this, &RobotView::pictureWanted);
  for (auto* button : {fit, tool, views, eye, alone, picture}) column->addWidget(button);
}

void RobotView::showRobot(std::shared_ptr<const RobotModel> robot, std::shared_ptr<const RobotLook> look) {
  standIn_ = robot;
  standInLook_ = look;
  if (recording_ && !robot_ && !posed_) {
    poseStandIn();
    rebuildSweep();
    updateInstant();
    updateNote();
    if (!cameraTouched_) usePreset(preset_);
  }
  if (recording_) return;
  if (kept_) {  // Behind what is live.
    if (!kept_->recording) kept_->robot = std::move(robot), kept_->look = std::move(look);
    return;
  }
  robot_ = std::move(robot);
  look_ = look;
  scene_.setRobot(std::move(look), {});
  if (robot_) {
    std::vector<Isometry3d> X_BL;
    robot_->linkPoses(robot_->homePosture(), X_BL);
    // Before a recording says where the sensor is, the tool sits on the flange.
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
  look_ = robot_ ? std::move(look) : nullptr;
  const bool ownSensor = look_ && showsSensor(*robot_, *look_);
  scene_.setRobot(look_, robot_ ? linksBeyond(*robot_, mount.parent) : std::vector<bool>{});
  scene_.sensorShown = true;
  scene_.sensorLength = ownSensor ? 0.0 : sensorBodyLength(mount);
}

void RobotView::poseStandIn() {
  posed_.reset();
  if (!track_ || track_->hasJoints() || robot_ || !standIn_ || !standInLook_ || !recording_->hasOrientation()) return;
  const bool poses = recording_->meta.kind == RecordingKind::poses;
  const double first = poses ? 1.0 : recording_->time(0);
  auto arm = PosedArm::follow(*track_, recording_->meta.mount, first,
                              first + (poses ? static_cast<double>(recording_->rows() - 1) : recording_->duration()),
                              standIn_);
  if (!arm) return;
  posed_ = std::make_unique<PosedArm>(std::move(*arm));
  look_ = standInLook_;
  // All of it translucent: nobody recorded it.
  scene_.setRobot(look_, std::vector<bool>(standIn_->links().size(), true));
}

void RobotView::showRecording(std::shared_ptr<const Recording> recording, std::shared_ptr<const RobotModel> robot,
                              std::shared_ptr<const RobotLook> look) {
  kept_.reset();
  recording_ = std::move(recording);
  robot_ = std::move(robot);
  track_ = std::make_unique<SceneTrack>(recording_, robot_);
  dress(std::move(look), recording_->meta.mount);
  setGravity(recording_->meta.gravity);
  poseStandIn();
  time_ = recording_->meta.kind == RecordingKind::poses ? 1.0 : recording_->rows() > 0 ? recording_->time(0) : 0.0;
  rebuildPath();
  rebuildSweep();
  updateInstant();
  // A session that comes back in the step Shape is there before its recording.
  usePreset(editing_ ? Preset::tool : Preset::overview);
  updateNote();
}

void RobotView::showNothing() {
  kept_.reset();
  posed_.reset();
  recording_.reset();
  track_.reset();
  clearEstimate();
  pull_.reset();
  gap_.reset();
  causes_.clear();
  sweep_.clear();
  scene_.path.reset();
  scene_.ghost.clear();
  scene_.ghostWay.reset();
  scene_.sensorShown = false;
  robot_.reset();
  look_.reset();
  scene_.setRobot(nullptr, {});
  updateNote();
  viewport_->requestFrame();
}

void RobotView::beginLive(std::shared_ptr<const RobotModel> robot, std::shared_ptr<const RobotLook> look,
                          const SensorMount& mount, const Vector3d& gravity) {
  if (!kept_) kept_ = std::make_unique<Kept>(Kept{recording_, robot_, look_, report_, time_});
  recording_.reset();
  track_.reset();
  posed_.reset();
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
  setGhostLabel({}, {});
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

void RobotView::setGhostLabel(const QString& title, const QString& note) {
  ghostTitle_ = title;
  ghostNote_ = note;
  viewport_->requestFrame();
}

void RobotView::showPayload() {
  std::optional<PayloadLook> look;
  if (report_ && report_->trust != Trust::none && (recording_ || kept_)) look = payloadLook(*report_);
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
  if (report_ && recording_) rebuildPath();
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
  if (std::abs(time_ - pathAbout_) > kPathStep && recording_ && recording_->duration() > kWholePath) rebuildPath();
  updateInstant();
}

void RobotView::rebuildPath() {
  std::vector<PathSample> samples;
  pathAbout_ = time_;
  if (track_) {
    const bool whole = recording_->duration() <= kWholePath;
    const double reach = whole ? std::numeric_limits<double>::infinity() : kPathReach;
    for (const auto& point : track_->path(time_ - reach, time_ + reach, 1500)) {
      samples.push_back({point.p_BSo_B, report_ ? labelAt(report_->segments, point.time) : MarkLabel::free});
    }
  }
  scene_.path = std::make_shared<const std::vector<PathSample>>(std::move(samples));
}

void RobotView::rebuildSweep() {
  sweep_.clear();
  if (!track_ || !recording_) return;
  const bool poses = recording_->meta.kind == RecordingKind::poses;
  const double first = poses ? 1.0 : recording_->rows() > 0 ? recording_->time(0) : 0.0;
  const double span = poses ? static_cast<double>(recording_->rows() - 1) : recording_->duration();
  constexpr int kInstants = 40;
  std::vector<Isometry3d> X_BL;
  for (int i = 0; i <= kInstants; ++i) {
    const double time = first + span * i / kInstants;
    if (track_->hasJoints() || posed_) {
      if (posed_) {
        posed_->robot().linkPoses(posed_->jointsAt(time), X_BL);
      } else {
        robot_->linkPoses(track_->jointsAt(time), X_BL);
      }
      for (const Isometry3d& X : X_BL) {
        // A link is about this thick about its frame.
        for (const double side : {-0.09, 0.09}) {
          for (int axis = 0; axis < 3; ++axis) sweep_.push_back(X.translation() + side * Vector3d::Unit(axis));
        }
      }
    }
    const Vector3d sensor = track_->sensorAt(time).translation();
    sweep_.push_back(sensor - Vector3d(0, 0, 0.25));
    sweep_.push_back(sensor + Vector3d(0, 0, 0.2));
  }
}

void RobotView::updateInstant() {
  if (!track_) return;
  const Isometry3d X_BS = track_->sensorAt(time_);
  if (report_) {
    showWrench(X_BS, track_->wrenchAt(time_));
  }
  placeSensor(X_BS);
  if (track_->hasJoints()) {
    std::vector<Isometry3d> X_BL;
    robot_->linkPoses(track_->jointsAt(time_), X_BL);
    scene_.X_BL = X_BL;
  } else if (posed_) {
    std::vector<Isometry3d> X_BL;
    posed_->robot().linkPoses(posed_->jointsAt(time_), X_BL);
    scene_.X_BL = X_BL;
  }
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
  X_BS_ = X_BS;
  scene_.X_BS = X_BS;
  if (handles_) handles_->setPose(X_BS);
}

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

void RobotView::setHandles(HandleSet* handles) {
  if (handles_) disconnect(handles_, nullptr, overlay_, nullptr);
  handles_ = handles;
  viewport_->setHandles(handles);
  if (handles_) {
    handles_->setPose(X_BS_);
    connect(handles_, &HandleSet::changed, overlay_, QOverload<>::of(&QWidget::update));
  }
  overlay_->update();
}

std::optional<QPointF> RobotView::knob(int id) const {
  return handles_ ? handles_->knob(id, viewport_->handleView()) : std::nullopt;
}

void RobotView::setDimensions(std::vector<DimensionLine> lines) {
  dimensions_ = std::move(lines);
  if (dimensions_.empty()) editor_->close();
  overlay_->update();
}

std::vector<PlacedDimension> RobotView::placedDimensions() const {
  return placeDimensions(dimensions_, X_BS_, viewport_->handleView());
}

std::optional<QPointF> RobotView::dimensionLabel(int id) const {
  for (const PlacedDimension& each : placedDimensions())
    if (each.line->id == id) return each.label.center();
  return std::nullopt;
}

void RobotView::paintOver(QPainter& painter) const {
  const HandleSet::View view = viewport_->shownView();
  if (!dimensions_.empty()) paintDimensions(painter, placeDimensions(dimensions_, X_BS_, view));
  if (pull_) paintPull(painter, *pull_, X_BS_.translation(), view);
  for (const CauseMark& cause : causes_) paintCause(painter, cause, X_BS_, scene_.down, view);
  if (handles_) handles_->paint(painter, view);
  if (gap_) paintGap(painter, *gap_, view);
}

void RobotView::showCauses(std::vector<CauseMark> causes) {
  causes_ = std::move(causes);
  overlay_->update();
  viewport_->requestFrame();
}

void RobotView::showPull(const std::optional<PullMark>& pull) {
  pull_ = pull;
  viewport_->requestFrame();
}

void RobotView::setStepNote(const QString& text) {
  stepNote_ = text;
  updateNote();
}

void RobotView::setStepTools(QWidget* tools) {
  if (stepTools_) stepTools_->hide();
  stepTools_ = tools;
  if (tools) {
    tools->setParent(viewport_);
    tools->adjustSize();
    tools->move(16, 12);
    tools->show();
    tools->raise();
  }
  updateNote();
}

void RobotView::showGhost(const std::optional<VectorXd>& joints) {
  std::vector<Isometry3d> X_BL;
  if (joints && robot_ && joints->size() == robot_->dof()) robot_->linkPoses(*joints, X_BL);
  scene_.ghost = X_BL;
  viewport_->requestFrame();
}

void RobotView::showGhostWay(const std::vector<Vector3d>& way) {
  scene_.ghostWay = way.empty() ? nullptr : std::make_shared<const std::vector<Vector3d>>(way);
  ghostEnd_ = way.empty() ? std::nullopt : std::optional(way.back());
  viewport_->requestFrame();
}

void RobotView::showRoom(const Room& room) {
  scene_.room = room.obstacles.empty() ? nullptr : std::make_shared<const std::vector<ToolSolid>>(roomSolids(room));
  viewport_->requestFrame();
}

void RobotView::showHulls(const std::vector<HullSurface>& hulls) {
  scene_.hulls = hulls.empty() ? nullptr : std::make_shared<const std::vector<HullEdges>>(hullEdges(hulls));
  viewport_->requestFrame();
}

void RobotView::showGap(const std::optional<Nearest>& gap) {
  gap_ = gap && !gap->first.empty() ? gap : std::nullopt;
  viewport_->requestFrame();
}

void RobotView::usePreset(Preset preset) {
  preset_ = preset;
  cameraTouched_ = false;
  OrbitCamera& camera = viewport_->camera();
  switch (preset) {
    case Preset::overview:
      camera.azimuth = -0.95;
      camera.elevation = 0.20;
      break;
    case Preset::front:
      camera.azimuth = 0.0;
      camera.elevation = 0.05;
      break;
    case Preset::side:
      camera.azimuth = -std::numbers::pi / 2;
      camera.elevation = 0.05;
      break;
    case Preset::top:
      camera.azimuth = -std::numbers::pi / 2;
      camera.elevation = std::numbers::pi / 2 - 0.01;
      break;
    case Preset::tool:
      camera.elevation = std::clamp(camera.elevation, 0.0, 0.35);
      if (editing_) turnToAxes(camera, X_BS_.linear());
      break;
  }
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
  QString text = stepNote_;
  if (text.isEmpty() && track_ && !track_->hasJoints()) {
    text = posed_                    ? tr("No joint angles recorded: a Panda that reaches these poses is shown")
           : track_->positionKnown() ? tr("No robot in this recording: only the sensor is shown")
                                     : tr("No position in this recording: the sensor only rotates");
  }
  note_->setText(text);
  note_->adjustSize();
  note_->setVisible(!text.isEmpty());
  updateLabels();
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
  // A low pane has no room for the last ones, which the menus have, too.
  const auto buttons = tools_->findChildren<QToolButton*>(QString(), Qt::FindDirectChildrenOnly);
  const int room = (height() - 24) / (buttons.front()->sizeHint().height() + 2);
  for (int k = 0; k < buttons.size(); ++k) buttons[k]->setVisible(k < room);
  tools_->adjustSize();
  tools_->move(width() - tools_->width() - 12, 12);
  overlay_->setGeometry(viewport_->rect());
  tools_->raise();
  if (!cameraTouched_) usePreset(preset_);
}

}  // namespace heft
