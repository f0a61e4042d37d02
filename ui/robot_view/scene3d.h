#pragma once
// What stands in the 3D view: floor, lights, robot, sensor, payload, arrows, path. Fed with plain data, in B axes,
// metres.
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/math/rigid.h"
#include "core/payload/shape.h"
#include "core/recording/recording.h"
#include "core/robot/robot_model.h"
#include "ui/robot_view/orbit_camera.h"
#include "ui/robot_view/robot_look.h"

class vtkRenderer;

namespace heft {

/// The estimated payload as the view draws it, in S axes.
struct PayloadLook {
  Vector3d com = Vector3d::Zero();     ///< p_SPcm_S [m]
  Vector3d region = Vector3d::Zero();  ///< Half axes of the 95 % region of the centre [m]
  double enlargement = 1.0;            ///< The region is drawn this many times larger.
  std::optional<Vector3d> boxEdges;    ///< Homogeneous box with the same mass and inertia [m]; absent if not known
  Matrix3d R_SBox = Matrix3d::Identity();
};

struct PathSample {
  Vector3d point;
  MarkLabel label;
};

struct SceneParts {
  bool path = true, arrows = true, axes = true, grid = true, payload = true, tool = true;
};

class Scene3d {
 public:
  explicit Scene3d(vtkRenderer* renderer);
  ~Scene3d();

  /// Takes the colours of the theme in force.
  void restyle();
  /// Null shows no robot.
  /// `ghostLinks` (indices of links) are drawn as the translucent tool.
  void setRobot(std::shared_ptr<const RobotLook> look, const std::vector<bool>& ghostLinks = {});
  void setLinkPoses(const std::vector<Isometry3d>& X_BL);
  /// Shows the sensor's axes and, with `body`, a disc of `bodyLength` [m] behind S's origin.
  void setSensor(double bodyLength, bool body);
  void setSensorPose(const Isometry3d& X_BS);
  void setPayload(const std::optional<PayloadLook>& payload);
  /// The user's tool, in S axes; meshes must be loaded. `selected` is drawn stronger; -1: all alike.
  void setTool(const std::vector<ShapeBody>& bodies, int selected);
  /// A second, translucent arm with its links there; empty shows none.
  void setGhost(const std::vector<Isometry3d>& X_BL);
  void setGhostWay(const std::vector<Vector3d>& way);
  void setPath(const std::vector<PathSample>& samples);
  /// Force [N] and torque [N m] on the payload, without bias, B axes, about S's origin; lengths follow `fullForce` and
  /// `fullTorque`, which are drawn 0.22 m long and three quarters of a turn. Nothing for an absent wrench.
  void setWrench(const std::optional<Vector6d>& wrench, double fullForce, double fullTorque);
  /// Unit vector; drawn at the centre of mass, or at the sensor without payload.
  void setGravityDirection(const Vector3d& direction);
  void setParts(const SceneParts& parts);
  void applyCamera(const OrbitCamera& camera);

  /// What a picture should hold: points of robot, path and arrows; and those about the tool,
  /// with its arrows or (`alone`) without.
  std::vector<Vector3d> outline() const;
  std::vector<Vector3d> toolOutline(bool alone = false) const;

  /// Points that labels refer to; absent if not shown.
  struct Anchors {
    std::optional<Vector3d> centre, wrench, gravity, box, sensor;
    std::array<std::optional<Vector3d>, 3> axes;
  };
  Anchors anchors() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace heft
