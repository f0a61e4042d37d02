#pragma once
// The way without motion: stand still in a few poses, a light for each; mass and centre of mass only.
#include "core/coach/guided_tool.h"
#include "core/online/online_estimator.h"

namespace heft {

enum class PoseLight {
  used,
  tooClose,  ///< Gravity pulls nearly as in another pose: it adds little and is not needed.
  moving,    ///< The tool did not stand still.
  contact,   ///< The forces do not fit the other poses: something touched the tool.
};
std::string_view toString(PoseLight light);  ///< "used", "too_close", "moving", "contact"

/// One standing pose: what was measured on average, and how still it was.
struct StandingPose {
  double time = 0.0;  ///< [s]
  VectorXd q;         ///< [rad]; empty if unknown
  Matrix3d R_BS = Matrix3d::Identity();
  Vector6d wrench = Vector6d::Zero();   ///< Mean F_PSo_S
  double speed = 0.0;                   ///< Largest turning rate while averaging [rad/s]
  Vector6d scatter = Vector6d::Zero();  ///< Standard deviation of the mean; 0: unknown
};

struct JudgedPose {
  StandingPose pose;
  PoseLight light = PoseLight::used;
  std::string words;    ///< "Used.", "Too close to pose 2 (6 degrees)."
  double misfit = 0.0;  ///< Of the force, against the fit [N]
};

struct PoseResult {
  bool known = false;                                          ///< False until the poses' tilts tell mass and centre.
  double mass = 0.0, massStd = 0.0;                            ///< [kg]
  Vector3d com = Vector3d::Zero(), comStd = Vector3d::Zero();  ///< [m]
  Vector6d bias = Vector6d::Zero();
  ExcitationLight spread = ExcitationLight::none;  ///< Of the orientations
  std::string spreadWords;  ///< "Gravity has pulled along two directions only: tilt the tool about another axis."
};

struct NextPose {
  VectorXd q;                          ///< Joint target
  std::string words;                   ///< "Tilt the tool by about 70 degrees ..."
  double massStd = 0.0, comStd = 0.0;  ///< Promised, worst coordinate of the centre [kg], [m]
};

struct PoseGuideOptions {
  int wanted = 8;                          ///< Poses that the user is asked for
  double closest = 12.0;                   ///< Between the gravity directions of two poses [degrees]
  double standStill = 0.02;                ///< Turning rate below which a tool stands [rad/s]
  double hold = 1.0;                       ///< Averaged over so long [s]
  double forceSd = 0.15, torqueSd = 0.01;  ///< What a pose's mean may be off by (drift, calibration) [N], [N m]
};

class PoseGuide {
 public:
  /// `tool` (and its robot) must outlive this; absent where poses come with orientations only: then there is no next
  /// pose. `gravity` g_B [m/s2].
  PoseGuide(std::optional<GuidedTool> tool, const Vector3d& gravity, const PoseGuideOptions& options = {});

  /// A pose that was measured elsewhere.
  void add(const StandingPose& pose);
  /// Live: finds standing stretches by itself. True when a pose was taken; move on then.
  bool add(const OnlineSample& sample);
  void remove(std::size_t index);

  const std::vector<JudgedPose>& poses() const { return poses_; }
  int usedCount() const;
  const PoseGuideOptions& options() const { return options_; }
  const PoseResult& result() const { return result_; }
  /// The posture, reached by the last three joints from `from`, that tells most; within the joints' ranges and torques,
  /// reached straight and clear of everything where `clearance` is not null. Nothing without a robot.
  std::optional<NextPose> next(const VectorXd& from, const Clearance* clearance = nullptr) const;

 private:
  Matrix3d orientationAt(const VectorXd& q) const;
  Vector3d gravityIn(const StandingPose& pose) const { return pose.R_BS.transpose() * gravity_; }
  void judge();
  /// Those that moved or stand as another one does.
  void lightByStanding();
  void lightTouched();
  /// How far the tilts of those that are used go apart; needs the mass.
  void judgeSpread();

  std::optional<GuidedTool> tool_;
  Vector3d gravity_;
  PoseGuideOptions options_;
  std::vector<JudgedPose> poses_;
  PoseResult result_;
  // The stretch that may become a pose.
  std::vector<StandingPose> stretch_;
  std::optional<Matrix3d> taken_;  ///< Orientation of the pose that was just taken: the next one has to differ.
};

/// The rows of a recording of kind "poses". Fails like standingPoses().
Result<std::vector<StandingPose>> posesOf(const Recording& recording, const RobotModel* robot);

}  // namespace heft
