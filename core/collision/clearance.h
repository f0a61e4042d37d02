#pragma once
// How near arm, tool and room come to each other, in one posture or along the whole course of a motion.
//
// Each body is its convex hull (a room's mesh stays a surface). Distances are FCL's, between triangle meshes with
// oriented boxes; FCL's own continuous check is not used, as it ignores rotation or samples. Along a course no point of
// one body can come nearer to another than the distance now, less how far the joints between the two can move it
// meanwhile (conservative advancement, Mirtich 1996), so nothing between two looks is missed.
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/findings.h"
#include "core/collision/room.h"
#include "core/payload/shape.h"
#include "core/robot/joint_motion.h"
#include "core/robot/robot_model.h"

namespace heft {

/// What the arm holds.
struct HeldTool {
  int link = 0;                              ///< Of the arm, that carries the sensor
  Isometry3d X_LS = Isometry3d::Identity();  ///< Sensor on it
  std::optional<Shape> shape;  ///< In S; grown by what its certainty leaves open (95 %). Nothing: what the URDF has.
};

/// Two bodies and how near they are.
struct Nearest {
  std::string first, second;
  double distance = 0.0;  ///< [m]; 0: they touch or overlap
  double margin = 0.0;    ///< That the two have to keep [m]: the room's; 0 for two links of the arm
  Vector3d onFirst = Vector3d::Zero(), onSecond = Vector3d::Zero();  ///< Where, for a picture, base axes [m]
  bool tooNear() const { return distance <= margin; }
};

/// A body of arm or tool as it is judged.
struct HullSurface {
  int link = 0;               ///< That it is fixed to
  Eigen::Matrix3Xd vertices;  ///< Link axes [m]
  std::vector<std::array<int, 3>> triangles;
};

/// Where a motion brings two bodies nearer to each other than the margin.
struct Conflict {
  Nearest bodies;
  double time = 0.0;             ///< [s]
  std::string sentence() const;  ///< "The tool comes within 12 mm of the table 3.2 s into the motion."
};

class Clearance {
 public:
  /// Each link's bodies are its <collision> elements, or where it has none, what it looks like. `robot` must outlive
  /// this. Neighbouring links touch by design and are not judged, nor are bodies whose hulls are too coarse to part
  /// them in the home posture; a finding names those. Fails where a mesh cannot be read.
  static Result<Clearance> of(const RobotModel& robot, const HeldTool& tool, const Room& room, Findings& findings);
  Clearance(Clearance&&) noexcept;
  Clearance& operator=(Clearance&&) noexcept;
  ~Clearance();

  /// The two bodies that leave each other least beyond their margin; without names where none are judged. Where tool or
  /// room are judged, two links of the arm count only if they touch. `q` has dof() entries.
  Nearest nearest(const VectorXd& q) const;
  /// Of arm and tool.
  std::vector<HullSurface> hulls() const;
  /// The first moment of the whole course at which two bodies are nearer than the margin, to a millimetre; nothing
  /// where they never are.
  std::optional<Conflict> firstConflict(const JointMotion& motion) const;

 private:
  struct Impl;
  explicit Clearance(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace heft
