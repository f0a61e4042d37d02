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

#include "ui/robot_view/ghost_arm.h"
#include "ui/robot_view/piece.h"
#include "ui/robot_view/soft_shadow.h"
#include "ui/robot_view/solids.h"
#include "ui/robot_view/stage.h"
#include "ui/robot_view/tool_shape.h"
#include "ui/theme/theme.h"

namespace heft {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kFullArrow = 0.22;    ///< [m]
constexpr double kGravityArrow = 0.2;  ///< [m]
constexpr double kAxisLength = 0.13;   ///< [m]
constexpr double kSensorRadius = 0.0375;
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

vtkSmartPointer<vtkPolyData> meshOf(const Visual& visual) {
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
    std::vector<Vector3d> shadowPoints;  ///< Some of its surface, in the link's frame.
    bool ghost = false;                  ///< Beyond the sensor: drawn as the translucent tool.
  };
  std::vector<LinkPiece> linkPieces;
  std::vector<Isometry3d> X_BL;

  Piece sensorBody, ball, region, regionLines, box, path, force, torque, gravity;
  std::array<Piece, 3> axes;
  ToolShape tool;
  GhostArm ghost;
  SoftShadow shadow;

  SceneParts parts;
  bool sensorShown = false;
  double sensorLength = 0.0;
  Isometry3d X_BS = Isometry3d::Identity();
  std::optional<PayloadLook> payload;
  std::optional<Vector6d> wrench;
  double fullForce = 1.0, fullTorque = 1.0;
  Vector3d down{0, 0, -1};
  std::vector<PathSample> samples;
  Anchors anchors;

  explicit Impl(vtkRenderer* r) : renderer(r), stage(r), tool(r), ghost(r) {
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

  void show(Piece& piece, bool shown) { piece.actor->SetVisibility(shown); }

  void updateVisibility() {
    show(sensorBody, sensorShown && sensorLength > 0);
    const bool payloadShown = sensorShown && payload && parts.payload;
    show(ball, payloadShown);
    const bool regionShown = payloadShown && payload->region.minCoeff() > 0;
    show(region, regionShown);
    show(regionLines, regionShown);
    show(box, payloadShown && payload->boxEdges);
    show(path, parts.path && samples.size() > 1);
    show(force, sensorShown && parts.arrows && wrench);
    show(torque, sensorShown && parts.arrows && wrench);
    show(gravity, sensorShown && parts.arrows);
    for (auto& axis : axes) show(axis, sensorShown && parts.axes);
    tool.setShown(parts.tool);
    // A tool that the user described stands for the one that the robot's description brought along.
    for (auto& piece : linkPieces) show(piece.piece, !(piece.ghost && parts.tool && !tool.empty()));
    stage.setGridShown(parts.grid);
  }

  void updateSensor() {
    const Eigen::Matrix4d X = X_BS.matrix();
    setPose(sensorBody.actor, X);
    for (auto& axis : axes) setPose(axis.actor, X);
    tool.setPose(X_BS);
    anchors = {};
    if (!sensorShown) return;
    for (int a = 0; a < 3; ++a) {
      if (parts.axes) anchors.axes[a] = X_BS * Vector3d(1.12 * kAxisLength * Vector3d::Unit(a));
    }
    anchors.sensor = X_BS * Vector3d(kSensorRadius, 0, -0.5 * sensorLength);
    Vector3d centre = X_BS.translation();
    if (payload && parts.payload) {
      centre = X_BS * payload->com;
      anchors.centre = centre;
      Isometry3d X_BC = X_BS;
      X_BC.translation() = centre;
      setPose(ball.actor, X_BC.matrix());
      Eigen::Matrix4d scaled = X_BC.matrix();
      for (int a = 0; a < 3; ++a) scaled.col(a) *= payload->enlargement * payload->region(a);
      setPose(region.actor, scaled);
      setPose(regionLines.actor, scaled);
      Isometry3d X_BBox = X_BC;
      X_BBox.linear() = X_BS.linear() * payload->R_SBox;
      setPose(box.actor, X_BBox.matrix());
      if (payload->boxEdges) anchors.box = X_BBox * Vector3d(0.5 * *payload->boxEdges);
    }
    if (parts.arrows) {
      gravity.setMesh(makeArrow(centre, centre + kGravityArrow * down, 0.0045));
      anchors.gravity = centre + kGravityArrow * down;
    }
    if (parts.arrows && wrench) {
      const Vector3d origin = X_BS.translation();
      const Vector3d f = wrench->head<3>() * (kFullArrow / std::max(1e-9, fullForce));
      // Spikes and contact would reach out of the picture.
      const Vector3d drawn = f.norm() > 2 * kFullArrow ? Vector3d(f.normalized() * 2 * kFullArrow) : f;
      force.setMesh(makeArrow(origin, origin + drawn, 0.0055));
      anchors.wrench = origin + drawn;
      const Vector3d tau = wrench->tail<3>();
      const double sweep = std::min(1.0, tau.norm() / std::max(1e-9, fullTorque)) * 1.5 * kPi;
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
  }

  void updateShadow() {
    shadow.clear();
    for (const LinkPiece& piece : linkPieces) {
      if (piece.link >= static_cast<int>(X_BL.size())) continue;
      for (const Vector3d& p : piece.shadowPoints) shadow.add(X_BL[piece.link] * p);
    }
    if (sensorShown) {
      for (int i = 0; i < 24; ++i) {
        shadow.add(X_BS *
                   Vector3d(kSensorRadius * std::cos(i * kPi / 12), kSensorRadius * std::sin(i * kPi / 12), -0.02));
      }
    }
    for (const Vector3d& p : tool.points()) shadow.add(X_BS * p);
    stage.setShadow(shadow.finish());
  }

  void rebuildPath() {
    std::vector<Vector3d> way;
    std::vector<std::array<unsigned char, 3>> colours;
    const Theme& t = theme();
    // On the light floor the pale mark colours need to be deeper to be seen as a line.
    const QColor free = t.dark ? t.markFree.lighter(135) : QColor("#4B9FD0");
    for (const PathSample& sample : samples) {
      const QColor c = sample.label == MarkLabel::free      ? free
                       : sample.label == MarkLabel::contact ? t.markContact
                                                            : t.text3;
      way.push_back(sample.point);
      colours.push_back({static_cast<unsigned char>(c.red()), static_cast<unsigned char>(c.green()),
                         static_cast<unsigned char>(c.blue())});
    }
    path.setMesh(makeTube(way, colours, 0.0028, 8));
  }
};

Scene3d::Scene3d(vtkRenderer* renderer) : impl_(std::make_unique<Impl>(renderer)) { restyle(); }
Scene3d::~Scene3d() = default;

void Scene3d::restyle() {
  Impl& s = *impl_;
  const Theme& t = theme();
  s.stage.restyle();
  setColour(s.sensorBody.actor, QColor("#4A545E"));
  setColour(s.region.actor, t.look);
  setColour(s.regionLines.actor, t.dark ? t.look : QColor("#8A6100"));
  setColour(s.box.actor, t.text);
  setColour(s.force.actor, t.wrench);
  setColour(s.torque.actor, t.wrench);
  setColour(s.gravity.actor, t.gravity);
  for (int a = 0; a < 3; ++a) setColour(s.axes[a].actor, t.axis[a]);
  for (auto& piece : s.linkPieces) {
    if (piece.ghost) makeTranslucent(piece.piece.actor, t.tool, 0.26);
  }
  s.tool.restyle();
  s.ghost.restyle();
  s.rebuildPath();
  s.updateShadow();
}

void Scene3d::setRobot(std::shared_ptr<const RobotLook> look, const std::vector<bool>& ghostLinks) {
  Impl& s = *impl_;
  for (auto& piece : s.linkPieces) s.renderer->RemoveActor(piece.piece.actor);
  s.linkPieces.clear();
  s.X_BL.clear();
  if (look) {
    for (const LookPart& part : look->parts) {
      Eigen::Matrix4d X_LV = part.visual.X_LV.matrix();
      if (part.mesh) {
        Eigen::Matrix4d scaled = X_LV;
        for (int a = 0; a < 3; ++a) scaled.col(a) *= part.visual.size(a);
        for (const MeshPart& meshPart : part.mesh->parts) {
          Impl::LinkPiece piece{part.link, scaled, {}, {}, false};
          piece.piece.setMesh(toPolyData(meshPart));
          const Eigen::Vector4f rgba =
              part.visual.hasColour ? Eigen::Vector4f(part.visual.rgba.cast<float>()) : meshPart.rgba;
          makeShell(piece.piece.actor, rgba);
          const std::size_t stride = std::max<std::size_t>(1, meshPart.vertices.size() / 500);
          for (std::size_t v = 0; v < meshPart.vertices.size(); v += stride) {
            piece.shadowPoints.push_back((scaled * meshPart.vertices[v].cast<double>().homogeneous()).head<3>());
          }
          s.linkPieces.push_back(std::move(piece));
        }
      } else {
        Impl::LinkPiece piece{part.link, X_LV, {}, {}, false};
        auto mesh = meshOf(part.visual);
        piece.piece.setMesh(mesh);
        makeShell(piece.piece.actor, part.visual.rgba.cast<float>());
        for (vtkIdType v = 0; v < mesh->GetNumberOfPoints(); ++v) {
          double p[3];
          mesh->GetPoint(v, p);
          piece.shadowPoints.push_back((X_LV * Eigen::Vector4d(p[0], p[1], p[2], 1)).head<3>());
        }
        s.linkPieces.push_back(std::move(piece));
      }
    }
  }
  for (auto& piece : s.linkPieces) {
    piece.ghost = piece.link < static_cast<int>(ghostLinks.size()) && ghostLinks[piece.link];
    if (piece.ghost) makeTranslucent(piece.piece.actor, theme().tool, 0.26);
    s.renderer->AddActor(piece.piece.actor);
  }
  std::vector<GhostArm::Part> ghost;
  for (const auto& piece : s.linkPieces) ghost.push_back({piece.link, piece.X_LV, piece.piece.mapper->GetInput()});
  s.ghost.setParts(ghost);
  s.updateVisibility();
  s.updateShadow();
}

void Scene3d::setLinkPoses(const std::vector<Isometry3d>& X_BL) {
  Impl& s = *impl_;
  s.X_BL = X_BL;
  for (auto& piece : s.linkPieces) {
    if (piece.link < static_cast<int>(X_BL.size())) setPose(piece.piece.actor, X_BL[piece.link].matrix() * piece.X_LV);
  }
  s.updateShadow();
}

void Scene3d::setSensor(double bodyLength, bool body) {
  Impl& s = *impl_;
  s.sensorShown = true;
  s.sensorLength = body ? bodyLength : 0.0;
  if (body) s.sensorBody.setMesh(makePuck(kSensorRadius, -bodyLength, 0));
  s.updateSensor();
  s.updateVisibility();
}

void Scene3d::setSensorPose(const Isometry3d& X_BS) {
  Impl& s = *impl_;
  s.X_BS = X_BS;
  s.updateSensor();
  if (s.linkPieces.empty()) s.updateShadow();
}

void Scene3d::setPayload(const std::optional<PayloadLook>& payload) {
  Impl& s = *impl_;
  s.payload = payload;
  if (payload && payload->boxEdges) s.box.setMesh(makeDashedBox(*payload->boxEdges, 0.009));
  s.updateSensor();
  s.updateVisibility();
}

void Scene3d::setTool(const std::vector<ShapeBody>& bodies, int selected) {
  impl_->tool.setBodies(bodies, selected);
  impl_->updateVisibility();
  impl_->updateShadow();
}

void Scene3d::setGhost(const std::vector<Isometry3d>& X_BL) {
  impl_->ghost.setPoses(X_BL, impl_->X_BL);
}

void Scene3d::setGhostWay(const std::vector<Vector3d>& way) { impl_->ghost.setWay(way); }

void Scene3d::setPath(const std::vector<PathSample>& samples) {
  impl_->samples = samples;
  impl_->rebuildPath();
  impl_->updateVisibility();
}

void Scene3d::setWrench(const std::optional<Vector6d>& wrench, double fullForce, double fullTorque) {
  Impl& s = *impl_;
  s.wrench = wrench;
  s.fullForce = fullForce;
  s.fullTorque = fullTorque;
  s.updateSensor();
  s.updateVisibility();
}

void Scene3d::setGravityDirection(const Vector3d& direction) {
  if (direction.norm() > 0) impl_->down = direction.normalized();
  impl_->updateSensor();
}

void Scene3d::setParts(const SceneParts& parts) {
  impl_->parts = parts;
  impl_->updateSensor();
  impl_->updateVisibility();
}

void Scene3d::applyCamera(const OrbitCamera& camera) {
  vtkCamera* c = impl_->renderer->GetActiveCamera();
  const Vector3d position = camera.position(), up = camera.up();
  c->SetPosition(position.x(), position.y(), position.z());
  c->SetFocalPoint(camera.target.x(), camera.target.y(), camera.target.z());
  c->SetViewUp(up.x(), up.y(), up.z());
  c->SetViewAngle(camera.viewAngle * 180.0 / kPi);
  double back[6], front[6];
  impl_->renderer->ComputeVisiblePropBounds(back);
  impl_->front->ComputeVisiblePropBounds(front);
  vtkBoundingBox bounds(back);
  if (vtkMath::AreBoundsInitialized(front)) bounds.AddBounds(front);
  double all[6];
  bounds.GetBounds(all);
  impl_->renderer->ResetCameraClippingRange(all);
}

std::vector<Vector3d> Scene3d::outline() const {
  const Impl& s = *impl_;
  std::vector<Vector3d> points;
  for (const auto& piece : s.linkPieces) {
    if (piece.link >= static_cast<int>(s.X_BL.size())) continue;
    for (std::size_t i = 0; i < piece.shadowPoints.size(); i += 4) {
      points.push_back(s.X_BL[piece.link] * piece.shadowPoints[i]);
    }
  }
  for (const PathSample& sample : s.samples) points.push_back(sample.point);
  for (const Vector3d& p : s.tool.points()) points.push_back(s.X_BS * p);
  if (s.sensorShown) {
    const Vector3d at = s.X_BS.translation();
    // Room for the arrows up and down, of which the way of the sensor says nothing.
    for (const double z : {-kGravityArrow, kFullArrow}) points.push_back(at + Vector3d(0, 0, z));
    for (int a = 0; a < 3; ++a) points.push_back(s.X_BS * Vector3d(kAxisLength * Vector3d::Unit(a)));
  }
  if (points.empty()) points = {Vector3d(-0.3, -0.3, 0), Vector3d(0.5, 0.3, 0.8)};
  return points;
}

std::vector<Vector3d> Scene3d::toolOutline(bool alone) const {
  const Impl& s = *impl_;
  if (alone) {
    // A hand's breadth of the arm tells where the tool is.
    std::vector<Vector3d> around;
    for (const double z : {-0.10, 0.09}) {
      for (int a = 0; a < 2; ++a) {
        for (const double side : {-0.08, 0.08}) around.push_back(s.X_BS * Vector3d(side * Vector3d::Unit(a) + Vector3d(0, 0, z)));
      }
    }
    for (const Vector3d& p : s.tool.points()) around.push_back(s.X_BS * p);
    return around;
  }
  const Vector3d at = s.X_BS.translation();
  const Vector3d centre = s.payload ? Vector3d(s.X_BS * s.payload->com) : at;
  std::vector<Vector3d> points{at + Vector3d(0, 0, kFullArrow), centre - Vector3d(0, 0, kGravityArrow)};
  for (int a = 0; a < 3; ++a) {
    for (const double side : {-1.0, 1.0}) points.push_back(centre + 0.16 * side * Vector3d::Unit(a));
  }
  for (const Vector3d& p : s.tool.points()) points.push_back(s.X_BS * p);
  return points;
}

Scene3d::Anchors Scene3d::anchors() const { return impl_->anchors; }

}  // namespace heft
