#pragma once
// A serial arm from a URDF: links, joints with limits, forward kinematics and the motion of a frame on it.
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/findings.h"
#include "core/base/result.h"
#include "core/math/rigid.h"

namespace heft {

struct JointLimits {
  double lower = -std::numeric_limits<double>::infinity();  ///< [rad] or [m]
  double upper = std::numeric_limits<double>::infinity();
  double velocity = std::numeric_limits<double>::infinity();      ///< [rad/s] or [m/s]
  double acceleration = std::numeric_limits<double>::infinity();  ///< [rad/s2]; a URDF has none, Panda's table has
  double effort = std::numeric_limits<double>::infinity();        ///< [N m] or [N]; above 0
};

enum class JointType { fixed, revolute, prismatic };

struct Joint {
  std::string name;
  JointType type = JointType::fixed;
  int parentLink = 0;
  int childLink = 0;
  Isometry3d X_PJ = Isometry3d::Identity();  ///< Joint frame in the parent link at q = 0.
  Vector3d axis = Vector3d::UnitZ();         ///< Unit vector in the joint frame.
  JointLimits limits;
  int index = -1;  ///< Column in q, or -1 for a fixed joint.
  /// The joint's value is ratio * q[index] + offset: 1 and 0 unless it mimics the joint that owns the column.
  double ratio = 1.0;
  double offset = 0.0;
};

/// What a link looks like; the file is resolved but loaded only by loadMesh (core/mesh/mesh.h).
struct Visual {
  enum class Kind { mesh, box, cylinder, sphere } kind = Kind::mesh;
  std::filesystem::path file;        ///< For a mesh.
  Vector3d size = Vector3d::Ones();  ///< Mesh: scale. Box: edges [m]. Cylinder: radius, length. Sphere: radius.
  Isometry3d X_LV = Isometry3d::Identity();
  Eigen::Vector4d rgba{0.8, 0.8, 0.8, 1.0};
  bool hasColour = false;  ///< False: use the mesh's own colours if it has any.
};

/// A rigid body's mass in the axes of the link that it belongs to.
struct BodyInertia {
  double mass = 0.0;                       ///< [kg]
  Vector3d com = Vector3d::Zero();         ///< [m]
  Matrix3d inertiaCom = Matrix3d::Zero();  ///< About com [kg m2]
};

struct Link {
  std::string name;
  int parentJoint = -1;
  std::vector<Visual> visuals;
  std::vector<Visual> collisions;      ///< Where it takes up room; empty: not stated, or not understood
  std::optional<BodyInertia> inertia;  ///< Nothing: not stated, or no mass
};

/// Position, velocity and acceleration of frame S fixed to a link, relative to the base B.
struct FrameMotion {
  Isometry3d X_BS = Isometry3d::Identity();
  Vector3d w_BS_B = Vector3d::Zero();      ///< angular velocity [rad/s]
  Vector3d v_BSo_B = Vector3d::Zero();     ///< velocity of S's origin [m/s]
  Vector3d alpha_BS_B = Vector3d::Zero();  ///< angular acceleration [rad/s2]
  Vector3d a_BSo_B = Vector3d::Zero();     ///< acceleration of S's origin, without gravity [m/s2]
};

struct UrdfTree;

/// Immutable after loading, safe to share between threads. B is the frame of the root link.
///
/// The columns of q are the moving joints on the way to the link that carries the sensor and on to the deepest turning
/// joint; where no such link is named, to the deepest turning joint of all. Joints beside that way (a gripper's
/// fingers, a second arm) are held at zero, or at their nearest limit, with a finding; a joint that mimics one of q's
/// joints follows it. A branching with only short chains behind an arm of four or more joints is taken as a hand.
///
/// Functions throw std::invalid_argument if q has not dof() entries or a link does not exist.
class RobotModel {
 public:
  /// Reads a URDF. Everything odd but survivable (unphysical inertia, missing mesh, unnormalised axis) is a finding;
  /// what makes the kinematics unsure (two parents, zero axis, unexpanded xacro) is a finding and fails.
  /// `sensorLink`: the link that carries the sensor; empty, or no link of this robot: not known.
  static Result<RobotModel> fromUrdfFile(const std::filesystem::path& file, Findings& findings,
                                         std::string_view sensorLink = {});
  static Result<RobotModel> fromUrdfText(const std::string& urdf, const std::filesystem::path& baseFolder,
                                         Findings& findings, std::string_view sensorLink = {});
  /// The project's own Panda, embedded in the program: kinematics always work; its meshes lie in the data folder.
  static const RobotModel& panda();

  const std::string& name() const { return name_; }
  const std::vector<Link>& links() const { return links_; }
  const std::vector<Joint>& joints() const { return joints_; }
  int dof() const { return dof_; }
  /// Joints that move, in the order of q's columns (from base to tip).
  const std::vector<int>& movingJoints() const { return moving_; }
  std::optional<int> findLink(std::string_view name) const;
  const JointLimits& limits(int qIndex) const { return joints_[moving_[qIndex]].limits; }
  VectorXd clampToLimits(const VectorXd& q) const;
  /// A comfortable posture well inside the limits (Panda's is the usual "ready" pose).
  VectorXd homePosture() const;

  /// Pose of every link in B, indexed as links().
  void linkPoses(const VectorXd& q, std::vector<Isometry3d>& X_BL) const;
  Isometry3d linkPose(const VectorXd& q, int link) const;
  /// Motion of frame S at X_LS on `link`. q, dq, ddq have dof() entries; allocates nothing.
  FrameMotion frameMotion(int link, const Isometry3d& X_LS, const Eigen::Ref<const VectorXd>& q,
                          const Eigen::Ref<const VectorXd>& dq, const Eigen::Ref<const VectorXd>& ddq) const;
  /// 6 x dof geometric Jacobian [v; w] of that frame's origin, B axes.
  MatrixXd jacobian(int link, const Isometry3d& X_LS, const VectorXd& q) const;

 private:
  std::string name_;
  std::vector<Link> links_;
  std::vector<Joint> joints_;
  std::vector<int> moving_;
  int dof_ = 0;

  /// One moving joint on the way to a link: pose of the joint frame, turned so that its axis is z, in the frame before.
  struct Step {
    Matrix3d R;
    Vector3d p;
    int index;
    bool turns;
    double ratio;
    double offset;
  };
  /// The way from the root to a link with everything fixed merged into the steps.
  struct Chain {
    std::vector<Step> steps;
    Matrix3d R_end = Matrix3d::Identity();  ///< Link in the last step's frame.
    Vector3d p_end = Vector3d::Zero();
  };
  std::vector<Chain> chains_;  ///< One a link.

  static Result<RobotModel> assemble(UrdfTree tree, const std::string& file, std::string_view sensorLink,
                                     Findings& findings);
  void buildChains();
  const Chain& chainTo(int link, Eigen::Index columns) const;
};

}  // namespace heft
