#pragma once
// What stands in the 3D view, as plain data: robot, sensor, payload, arrows, path; in B axes, metres. The window edits
// it; a copy goes to the thread that draws. Free of Qt and VTK.
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/math/rigid.h"
#include "core/payload/shape.h"
#include "core/recording/recording.h"
#include "ui/robot_look/robot_look.h"
#include "ui/robot_view/room_solid.h"
#include "ui/robot_view/tool_solid.h"

namespace heft {

// Lengths used both for drawing and for fitting the picture [m].
inline constexpr double kFullArrow = 0.22;
inline constexpr double kGravityArrow = 0.2;
inline constexpr double kAxisLength = 0.13;
inline constexpr double kSensorRadius = 0.0375;

/// The estimated payload as the view draws it, in S axes.
struct PayloadLook {
  Vector3d com = Vector3d::Zero();     ///< p_SPcm_S [m]
  Vector3d region = Vector3d::Zero();  ///< Half axes of the 95 % region of the centre [m]; zero: not drawn
  bool centreKnown = true;             ///< False where that region would be larger than a tool
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
  bool operator==(const SceneParts&) const = default;
};

/// Some points of a link's surface, in the link's frame [m].
struct LinkSurface {
  int link = 0;
  std::vector<Vector3d> points;
};

struct SceneState {
  std::shared_ptr<const RobotLook> look;  ///< Null shows no robot.
  std::vector<bool> ghostLinks;           ///< Of the look's robot: drawn as the translucent tool
  std::vector<Isometry3d> X_BL;
  bool sensorShown = false;
  double sensorLength = 0.0;  ///< Of a disc behind S's origin [m]; 0 for none
  Isometry3d X_BS = Isometry3d::Identity();
  std::optional<PayloadLook> payload;
  /// On the payload, without bias, B axes, about S's origin: force [N], torque [N m].
  std::optional<Vector6d> wrench;
  double fullForce = 1.0, fullTorque = 1.0;  ///< Drawn kFullArrow long, and three quarters of a turn
  Vector3d down{0, 0, -1};                   ///< Unit vector
  std::shared_ptr<const std::vector<PathSample>> path;
  std::vector<Isometry3d> ghost;  ///< A second, translucent arm with its links there; empty for none
  std::shared_ptr<const std::vector<Vector3d>> ghostWay;
  std::shared_ptr<const std::vector<ToolSolid>> room;   ///< B axes; null for none
  std::shared_ptr<const std::vector<HullEdges>> hulls;  ///< Drawn about the ghost; null for none
  SceneParts parts;

  struct ToolBody {
    Isometry3d X_SB = Isometry3d::Identity();
    std::shared_ptr<const ToolSolid> solid;  ///< Another one where the form changes
  };
  const std::vector<ToolBody>& tool() const { return tool_; }
  /// The one drawn stronger; -1: all alike.
  int selectedBody() const { return selected_; }

  /// Null shows no robot.
  void setRobot(std::shared_ptr<const RobotLook> look, std::vector<bool> ghostLinks);
  /// The user's tool, in S axes; meshes must be loaded.
  void setTool(const std::vector<ShapeBody>& bodies, int selected);

  /// What a picture should hold: points of robot, path and arrows; and those about the tool, with its arrows or
  /// (`alone`) without. B axes [m].
  std::vector<Vector3d> outline() const;
  std::vector<Vector3d> toolOutline(bool alone) const;
  /// What labels name, piece by piece: sensor, bodies, region of the centre, arrows in short lengths. B axes [m].
  std::vector<std::vector<Vector3d>> namedPieces() const;
  /// Of robot, sensor and tool, to throw a shadow. B axes [m].
  std::vector<Vector3d> surface() const;
  /// Where the arrow of the force ends, B axes [m]; only with a wrench.
  Vector3d forceEnd() const;

  /// Points that labels refer to, B axes; absent if not shown.
  struct Anchors {
    std::optional<Vector3d> centre, wrench, gravity, box, sensor;
    std::array<std::optional<Vector3d>, 3> axes;
  };
  Anchors anchors() const;

 private:
  /// Some points of its surface, B axes [m].
  void addTool(std::vector<Vector3d>& points) const;

  std::shared_ptr<const std::vector<LinkSurface>> surfaces_;
  std::vector<ShapeBody> bodies_;  ///< What tool_ was made of
  std::vector<ToolBody> tool_;
  int selected_ = -1;
};

}  // namespace heft
