#pragma once
// What the causes work on: the recorded motion and wrench on one uniform clock, and which instants may be judged.
#include <memory>
#include <optional>
#include <vector>

#include "core/diagnosis/signals/joint_turns.h"
#include "core/diagnosis/signals/kinematics.h"
#include "core/diagnosis/signals/noise_scale.h"
#include "core/motion/motion.h"
#include "core/recording/recording.h"
#include "core/robot/robot_model.h"

namespace heft::diagnosis {

using Wrenches = Eigen::Matrix<double, 6, Eigen::Dynamic>;  ///< A column an instant: force [N], torque [N m], S axes

/// All of it one instant after the other.
inline Eigen::Map<const VectorXd> flat(const Wrenches& w) { return {w.data(), w.size()}; }

/// How much less smooth than recorded the joints' motion is: kind and size as derivative_noise has them.
struct Sharpening {
  int kind = 0;
  double size = 0.0;
  Vector3d gravity{0.0, 0.0, 0.0};  ///< g_B [m/s2]

  bool operator==(const Sharpening&) const = default;
};

/// Share of the corner below which a smoothing by twicing, of order 6 and run both ways, takes less than 1.5 %.
constexpr double kKeptTwiced = 0.85;

/// The recording at about 200 Hz, K instants, and blocks of it at about 50 Hz, N of them, on which everything is
/// judged.
struct Signals {
  double startTime = 0.0;  ///< [s] on the recording's clock
  double rateHz = 0.0;
  Kinematics kinematics;
  std::vector<Matrix3d> R_BS;
  Eigen::Matrix3Xd velocity;          ///< v_BSo_B [m/s]
  Eigen::Matrix3Xd position;          ///< p_BSo_B [m]
  Vector3d gravity{0.0, 0.0, -9.81};  ///< g_B [m/s2]
  std::optional<Vector6d> range;      ///< Of the sensor [N, N m], where its model is known: sensor_range.h
  bool positionKnown = true;
  std::optional<double> clockAlignmentStd;  ///< [s] As of RecordingMeta
  bool noisyMotion = false;  ///< Accelerations are noise not only above `keptHz`, but clearly so below, too
  /// Evidence for a motion smoothed this much, over one as usual, of bias and payload alone: how much of the misfit is
  /// noise of the motion. 0: smoothed as usual.
  double smoothedAway = 0.0;
  /// Above which smoothing takes more than 1.5 % of what moves, since noise made it useless; 0: nowhere
  double keptHz = 0.0;
  bool denoised = false;  ///< Its motion was, see MotionOptions: `keptHz` is the top of a tremor, no corner

  const RobotModel* robot = nullptr;  ///< With joints only: for causes that bend them.
  int link = 0;
  Isometry3d X_LS = Isometry3d::Identity();
  std::shared_ptr<const JointTurns> joints;  ///< Null without them
  std::shared_ptr<Memo<Sharpening, Kinematics>> sharpened;

  int samplesPerBlock = 4;
  Wrenches readings;  ///< 6 x K
  Wrenches measured;  ///< 6 x N: their averages
  /// Of noise where the motion is less well known; null: nowhere.
  std::shared_ptr<const NoiseScale> noiseScale;
  /// What the payload makes of motion smoothed less, each way, over what it makes of this one, as far as bias and
  /// payload alone know it; null: not asked for.
  std::shared_ptr<const std::vector<Wrenches>> lost;
  /// The same of motion smoothed less than usual, which may be mostly noise.
  std::shared_ptr<const std::vector<Wrenches>> lostFast;
  std::vector<bool> usable;  ///< N: inside the trim and neither marked as contact nor to be ignored

  Eigen::Index size() const { return kinematics.omega.cols(); }
  Eigen::Index blocks() const { return measured.cols(); }
  /// The joints' motion, dof x K [rad, rad/s, rad/s2]; empty without joints.
  const MatrixXd& q() const { return joints ? joints->q() : kNoJoints; }
  const MatrixXd& dq() const { return joints ? joints->dq() : kNoJoints; }
  const MatrixXd& ddq() const { return joints ? joints->ddq() : kNoJoints; }
  double time(Eigen::Index k) const { return startTime + static_cast<double>(k) / rateHz; }
  double blockTime(Eigen::Index n) const { return time(n * samplesPerBlock) + 0.5 * (samplesPerBlock - 1) / rateHz; }
  double blockRate() const { return rateHz / samplesPerBlock; }
  double duration() const { return static_cast<double>(size()) / rateHz; }

 private:
  static const MatrixXd kNoJoints;
};

/// Evidence that anything fast may gain of what a smoothed motion leaves: smoothing takes noise and a little of the
/// motion, and leaves a little of the noise. Of 45 recordings, what was false had 2 to 5 % of what smoothing gained,
/// what was true 35 % and more, one 4 % at 611.
double leftByNoise(const Signals& signals);

/// [Hz] Blocks that a recording is judged on.
constexpr double kBlocksHz = 50.0;

/// Signals of a recording whose motion has been worked out. `robot` must outlive them; null without joints.
Signals signalsOf(const Recording& recording, Motion motion, const RobotModel* robot, double blocksHz = kBlocksHz);

/// The blocks [from, to) as if nothing else had been recorded, without joints and what smoothing took.
Signals partOf(const Signals& signals, Eigen::Index from, Eigen::Index to);

/// Axes of S in B at each instant, as `kinematics` has them.
inline const std::vector<Matrix3d>& axesOf(const Signals& signals, const Kinematics& kinematics) {
  return kinematics.turned ? *kinematics.turned : signals.R_BS;
}

/// Kinematics of another motion of the joints, each dof x K; only with a robot.
Kinematics kinematicsOf(const Signals& signals, const MatrixXd& q, const MatrixXd& dq, const MatrixXd& ddq);

/// Averages of samplesPerBlock neighbours.
Wrenches averaged(const Signals& signals, const Wrenches& wrench);

/// The rows of `value` read `delay` seconds earlier (positive: late), cubic between samples, held at the ends.
Eigen::MatrixXd delayed(const Eigen::Ref<const Eigen::MatrixXd>& value, double delay, double rateHz);
/// The same with a delay [s] of its own for each instant.
Eigen::MatrixXd delayed(const Eigen::Ref<const Eigen::MatrixXd>& value, const VectorXd& delays, double rateHz);

/// Mean over the last `duration` [s] of what cubics make of the samples, and of the first one before it.
Eigen::MatrixXd meanSince(const Eigen::Ref<const Eigen::MatrixXd>& value, double duration, double rateHz);

/// Exact response of T y' + y = u between samples of u interpolated by cubics, started in balance; T [s] > 0.
Eigen::MatrixXd onePole(const Eigen::Ref<const Eigen::MatrixXd>& value, double T, double rateHz);

/// What a spring with a damper beside it passes on of a force on the mass that it carries: the response of
/// y'' + 2 z w y' + w^2 y = 2 z w u' + w^2 u, as exact and started so; w = 2 pi f, damping z < 1.
Eigen::MatrixXd throughSpring(const Eigen::Ref<const Eigen::MatrixXd>& value, double frequencyHz, double damping,
                              double rateHz);

/// Central differences in time of each row [1/s].
Eigen::MatrixXd rateOf(const Eigen::MatrixXd& value, double rateHz);

}  // namespace heft::diagnosis
