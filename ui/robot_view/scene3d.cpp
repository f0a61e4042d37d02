#include "ui/robot_view/scene3d.h"

#include <vtkActor.h>
#include <vtkBoundingBox.h>
#include <vtkCamera.h>
#include <vtkMath.h>
#include <vtkProperty.h>
#include <vtkRenderStepsPass.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ui/robot_view/ghost_arm.h"
#include "ui/robot_view/piece.h"
#include "ui/robot_view/room_shape.h"
#include "ui/robot_view/soft_shadow.h"
#include "ui/robot_view/solids.h"
#include "ui/robot_view/stage.h"
#include "ui/robot_view/tool_shape.h"
#include "ui/theme/theme.h"

namespace heft {
namespace {

constexpr double kBallRadius = 0.013;

void makeMatt(vtkActor* actor) {
  actor->GetProperty()->SetInterpolationToPhong();
  actor->GetProperty()->SetAmbient(0.30);
  actor->GetProperty()->SetDiffuse(0.75);
  actor->GetProperty()->SetSpecular(0.15);
  actor->GetProperty()->SetSpecularPower(20);
}

/// Shells shine a little, dark joint rings less.
void makeShell(vtkActor* actor, const Eigen::Vector4f& rgba) {
  auto* property = actor->GetProperty();
  const float brightness = (rgba.x() + rgba.y() + rgba.z()) / 3;
  property->SetInterpolationToPhong();
  property->SetColor(rgba.x(), rgba.y(), rgba.z());
  property->SetOpacity(rgba.w() > 0 ? rgba.w() : 1.0);
  property->SetAmbient(brightness > 0.5f ? 0.24 : 0.10);
  property->SetDiffuse(0.92);
  property->SetSpecular(brightness > 0.5f ? 0.22 : 0.28);
  property->SetSpecularPower(brightness > 0.5f ? 36 : 18);
}

/// Of a box, cylinder or sphere.
vtkSmartPointer<vtkPolyData> simpleMesh(const Visual& visual) {
  switch (visual.kind) {
    case Visual::Kind::box:
      return makeBox(visual.size);
    case Visual::Kind::sphere: {
      auto source = vtkSmartPointer<vtkSphereSource>::New();
      source->SetRadius(visual.size.x());
      source->SetThetaResolution(40);
      source->SetPhiResolution(24);
      source->Update();
      return source->GetOutput();
    }
    case Visual::Kind::cylinder:
      return makePuck(visual.size.x(), -visual.size.y() / 2, visual.size.y() / 2);
    case Visual::Kind::mesh:
      break;
  }
  return vtkSmartPointer<vtkPolyData>::New();
}

bool samePoses(const std::vector<Isometry3d>& a, const std::vector<Isometry3d>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Isometry3d& x, const Isometry3d& y) { return x.matrix() == y.matrix(); });
}

bool sameTool(const SceneState& a, const SceneState& b) {
  return a.selectedBody() == b.selectedBody() &&
         std::equal(a.tool().begin(), a.tool().end(), b.tool().begin(), b.tool().end(),
                    [](const SceneState::ToolBody& x, const SceneState::ToolBody& y) {
                      return x.solid == y.solid && x.X_SB.matrix() == y.X_SB.matrix();
                    });
}

}  // namespace

struct Scene3d::Impl {
  vtkRenderer* renderer;
  /// Drawn over everything else, so that arm and tool never hide what the view is about: arrows, centre, axes.
  vtkSmartPointer<vtkRenderer> front = vtkSmartPointer<vtkRenderer>::New();
  Stage stage;

  struct LinkPiece {
    int link;
    Eigen::Matrix4d X_LV;  ///< With the mesh's scale.
    Piece piece;
    bool ghost = false;  ///< Beyond the sensor: drawn as the translucent tool.
  };
  std::vector<LinkPiece> linkPieces;

  Piece sensorBody, ball, region, regionLines, box, path, force, torque, gravity;
  std::array<Piece, 3> axes;
  ToolShape tool;
  GhostArm ghost;
  RoomShape room;
  SoftShadow shadow;

  const Theme* theme = nullptr;  ///< Of what is shown; null before anything is.
  SceneState state;

  explicit Impl(vtkRenderer* r) : renderer(r), stage(r), tool(r), ghost(r), room(r) {
    renderer->GetRenderWindow()->SetNumberOfLayers(2);
    front->SetLayer(1);
    front->InteractiveOff();
    front->SetActiveCamera(renderer->GetActiveCamera());
    stage.lightToo(front);
    renderer->GetRenderWindow()->AddRenderer(front);
    // VTK's own way sorts what is translucent through pictures of floating-point numbers as large as the view, for each
    // renderer; few bodies drawn one over the other look the same, and cost a fraction without a graphics card.
    for (vtkRenderer* each : {renderer, front.Get()}) each->SetPass(vtkSmartPointer<vtkRenderStepsPass>::New());
    for (Piece* piece : {&sensorBody, &path, &box}) add(*piece, renderer);
    for (Piece* piece : {&axes[0], &axes[1], &axes[2], &ball, &force, &torque, &gravity, &regionLines, &region}) {
      add(*piece, front);
    }
    ball.setMesh(makeCentreBall(kBallRadius));
    ball.mapper->SetColorModeToDirectScalars();
    region.setMesh(makeUnitBall());
    region.actor->GetProperty()->SetOpacity(0.38);
    region.actor->ForceTranslucentOn();
    regionLines.setMesh(makeUnitCircles());
    regionLines.actor->GetProperty()->LightingOff();
    regionLines.actor->GetProperty()->SetLineWidth(1.2F);
    box.actor->GetProperty()->LightingOff();
    box.actor->GetProperty()->SetLineWidth(1.6F);
    path.mapper->SetColorModeToDirectScalars();
    path.actor->GetProperty()->SetAmbient(0.6);
    path.actor->GetProperty()->SetDiffuse(0.5);
    for (int a = 0; a < 3; ++a) axes[a].setMesh(makeArrow(Vector3d::Zero(), kAxisLength * Vector3d::Unit(a), 0.0022));
  }

  static void add(Piece& piece, vtkRenderer* to) {
    makeMatt(piece.actor);
    piece.actor->VisibilityOff();
    to->AddActor(piece.actor);
  }

  static void show(Piece& piece, bool shown) { piece.actor->SetVisibility(shown); }

  void updateVisibility() {
    const SceneParts& parts = state.parts;
    show(sensorBody, state.sensorShown && state.sensorLength > 0);
    const bool payloadShown = state.sensorShown && state.payload && parts.payload;
    show(ball, payloadShown);
    const bool regionShown = payloadShown && state.payload->region.minCoeff() > 0;
    show(region, regionShown);
    show(regionLines, regionShown);
    show(box, payloadShown && state.payload->boxEdges);
    show(path, parts.path && state.path && state.path->size() > 1);
    show(force, state.sensorShown && parts.arrows && state.wrench);
    show(torque, state.sensorShown && parts.arrows && state.wrench);
    show(gravity, state.sensorShown && parts.arrows);
    for (auto& axis : axes) show(axis, state.sensorShown && parts.axes);
    tool.setShown(parts.tool);
    // A tool that the user described stands for the one that the robot's description brought along.
    for (auto& piece : linkPieces) show(piece.piece, !piece.ghost || (parts.tool && state.tool().empty()));
    stage.setGridShown(parts.grid);
  }

  /// What stands at the sensor: body, axes, tool, payload, arrows.
  void updateSensor() {
    const Isometry3d& X_BS = state.X_BS;
    const Eigen::Matrix4d X = X_BS.matrix();
    setPose(sensorBody.actor, X);
    for (auto& axis : axes) setPose(axis.actor, X);
    tool.setPose(X_BS);
    if (!state.sensorShown) return;
    Vector3d centre = X_BS.translation();
    if (state.payload && state.parts.payload) {
      centre = X_BS * state.payload->com;
      Isometry3d X_BC = X_BS;
      X_BC.translation() = centre;
      setPose(ball.actor, X_BC.matrix());
      Eigen::Matrix4d scaled = X_BC.matrix();
      for (int a = 0; a < 3; ++a) scaled.col(a) *= state.payload->enlargement * state.payload->region(a);
      setPose(region.actor, scaled);
      setPose(regionLines.actor, scaled);
      Isometry3d X_BBox = X_BC;
      X_BBox.linear() = X_BS.linear() * state.payload->R_SBox;
      setPose(box.actor, X_BBox.matrix());
    }
    if (!state.parts.arrows) return;
    gravity.setMesh(makeArrow(centre, centre + kGravityArrow * state.down, 0.0045));
    if (state.wrench) updateWrench();
  }

  void updateWrench() {
    const Vector3d origin = state.X_BS.translation();
    force.setMesh(makeArrow(origin, state.forceEnd(), 0.0055));
    const Vector3d tau = state.wrench->tail<3>();
    const double sweep = std::min(1.0, tau.norm() / std::max(1e-9, state.fullTorque)) * 1.5 * std::numbers::pi;
    std::vector<Vector3d> arc;
    if (sweep > 0.15) {
      const Vector3d axis = tau.normalized();
      const Vector3d x = axis.unitOrthogonal(), y = axis.cross(x);
      constexpr double kArcRadius = 0.065;
      const int steps = std::max(4, static_cast<int>(sweep * 14));
      for (int i = 0; i <= steps; ++i) {
        const double angle = sweep * i / steps;
        arc.push_back(origin + kArcRadius * (std::cos(angle) * x + std::sin(angle) * y));
      }
    }
    torque.setMesh(makeBentArrow(arc, 0.0032));
  }

  void updateShadow() {
    shadow.clear();
    for (const Vector3d& p : state.surface()) shadow.add(p);
    stage.setShadow(shadow.finish());
  }

  void rebuildPath() {
    if (!state.path) return;
    std::vector<Vector3d> way;
    std::vector<std::array<unsigned char, 3>> colours;
    // On the light floor the pale mark colours need to be deeper to be seen as a line.
    const QColor free = theme->dark ? theme->markFree.lighter(135) : QColor("#4B9FD0");
    for (const PathSample& sample : *state.path) {
      const QColor c = sample.label == MarkLabel::free      ? free
                       : sample.label == MarkLabel::contact ? theme->markContact
                                                            : theme->text3;
      way.push_back(sample.point);
      colours.push_back({static_cast<unsigned char>(c.red()), static_cast<unsigned char>(c.green()),
                         static_cast<unsigned char>(c.blue())});
    }
    path.setMesh(makeTube(way, colours, 0.0028, 8));
  }

  void rebuildRobot() {
    for (auto& piece : linkPieces) renderer->RemoveActor(piece.piece.actor);
    linkPieces.clear();
    const auto addPiece = [&](int link, const Eigen::Matrix4d& X_LV, vtkPolyData* mesh, const Eigen::Vector4f& rgba) {
      const auto at = static_cast<std::size_t>(link);
      LinkPiece piece{link, X_LV, {}, at < state.ghostLinks.size() && state.ghostLinks[at]};
      piece.piece.setMesh(mesh);
      makeShell(piece.piece.actor, rgba);
      if (piece.ghost) makeTranslucent(piece.piece.actor, theme->tool, 0.26);
      renderer->AddActor(piece.piece.actor);
      linkPieces.push_back(std::move(piece));
    };
    if (state.look) {
      for (const LookPart& part : state.look->parts) {
        Eigen::Matrix4d X_LV = part.visual.X_LV.matrix();
        const Eigen::Vector4f rgba = part.visual.rgba.cast<float>();
        if (!part.mesh) {
          addPiece(part.link, X_LV, simpleMesh(part.visual), rgba);
          continue;
        }
        for (int a = 0; a < 3; ++a) X_LV.col(a) *= part.visual.size(a);
        for (const MeshPart& mesh : part.mesh->parts)
          addPiece(part.link, X_LV, toPolyData(mesh), part.visual.hasColour ? rgba : mesh.rgba);
      }
    }
    std::vector<GhostArm::Part> parts;
    for (const auto& piece : linkPieces) parts.push_back({piece.link, piece.X_LV, piece.piece.mapper->GetInput()});
    ghost.setParts(parts);
  }

  void placeLinks() {
    for (auto& piece : linkPieces) {
      const auto link = static_cast<std::size_t>(piece.link);
      if (link < state.X_BL.size()) setPose(piece.piece.actor, state.X_BL[link].matrix() * piece.X_LV);
    }
  }

  void restyle() {
    stage.restyle(*theme);
    setColour(sensorBody.actor, QColor(theme->dark ? "#8B98A5" : "#4A545E"));
    setColour(region.actor, theme->look);
    setColour(regionLines.actor, theme->dark ? theme->look : QColor("#8A6100"));
    setColour(box.actor, theme->text);
    setColour(force.actor, theme->wrench);
    setColour(torque.actor, theme->wrench);
    setColour(gravity.actor, theme->gravity);
    for (int a = 0; a < 3; ++a)
      setColour(axes[static_cast<std::size_t>(a)].actor, theme->axis[static_cast<std::size_t>(a)]);
    for (auto& piece : linkPieces)
      if (piece.ghost) makeTranslucent(piece.piece.actor, theme->tool, 0.26);
    tool.restyle(*theme);
    ghost.restyle(*theme);
    room.restyle(*theme);
  }
};

Scene3d::Scene3d(vtkRenderer* renderer) : impl_(std::make_unique<Impl>(renderer)) {}
Scene3d::~Scene3d() = default;

void Scene3d::show(const SceneState& state, const Theme& theme) {
  Impl& s = *impl_;
  const SceneState before = std::exchange(s.state, state);
  const bool first = s.theme == nullptr, colours = first || s.theme != &theme;
  s.theme = &theme;
  const bool robot = before.look != state.look || before.ghostLinks != state.ghostLinks;
  const bool tool = !sameTool(before, state);
  const bool arm = robot || !samePoses(before.X_BL, state.X_BL);
  const bool path = before.path != state.path;
  const bool way = before.ghostWay != state.ghostWay;
  const bool sensor = before.sensorLength != state.sensorLength;
  const bool box = state.payload && state.payload->boxEdges &&
                   (!before.payload || before.payload->boxEdges != state.payload->boxEdges);
  const bool moved = before.X_BS.matrix() != state.X_BS.matrix();
  if (robot) s.rebuildRobot();
  if (tool) s.tool.setBodies(state.tool(), state.selectedBody());
  const bool room = before.room != state.room, hulls = before.hulls != state.hulls;
  if (room) s.room.setRoom(state.room ? *state.room : std::vector<ToolSolid>());
  if (hulls) s.room.setHulls(state.hulls ? *state.hulls : std::vector<HullEdges>());
  if (colours || tool || robot || room || hulls) s.restyle();
  if (hulls || !samePoses(before.ghost, state.ghost)) s.room.setPoses(state.ghost);
  if (arm) s.placeLinks();
  if (robot || colours || arm || !samePoses(before.ghost, state.ghost)) s.ghost.setPoses(state.ghost, state.X_BL);
  if (way) s.ghost.setWay(state.ghostWay ? *state.ghostWay : std::vector<Vector3d>());
  if (path || colours) s.rebuildPath();
  if (sensor && state.sensorLength > 0) s.sensorBody.setMesh(makePuck(kSensorRadius, -state.sensorLength, 0));
  if (box) s.box.setMesh(makeDashedBox(*state.payload->boxEdges, 0.009));
  s.updateSensor();
  s.updateVisibility();
  if (first || colours || arm || tool || moved || before.sensorShown != state.sensorShown) s.updateShadow();
}

void Scene3d::applyCamera(const OrbitCamera& camera) {
  vtkCamera* c = impl_->renderer->GetActiveCamera();
  const Vector3d position = camera.position(), up = camera.up();
  c->SetPosition(position.x(), position.y(), position.z());
  c->SetFocalPoint(camera.target.x(), camera.target.y(), camera.target.z());
  c->SetViewUp(up.x(), up.y(), up.z());
  c->SetViewAngle(camera.viewAngle * 180.0 / std::numbers::pi);
  double back[6], front[6];
  impl_->renderer->ComputeVisiblePropBounds(back);
  impl_->front->ComputeVisiblePropBounds(front);
  vtkBoundingBox bounds(back);
  if (vtkMath::AreBoundsInitialized(front)) bounds.AddBounds(front);
  double all[6];
  bounds.GetBounds(all);
  impl_->renderer->ResetCameraClippingRange(all);
}

}  // namespace heft
