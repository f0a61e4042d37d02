#pragma once
// From joints or poses to what the wrench model needs: specific force, angular velocity and angular acceleration of S.
#include "core/base/findings.h"
#include "core/base/result.h"
#include "core/motion/accelerometer.h"
#include "core/recording/recording.h"
#include "core/robot/robot_model.h"

namespace heft {

constexpr double kDefaultCutoffHz = 25.0;

enum class SmoothingKind {
  lowPass,        ///< Zero-phase Butterworth of order 6, then eighth-order central differences (default).
  savitzkyGolay,  ///< Local polynomials, as in the seed paper.
};

struct MotionOptions {
  SmoothingKind smoothing = SmoothingKind::lowPass;
  /// lowPass: -6 dB of the zero-phase filter [Hz]; lowered to 0.4 of a slower recording's rate. 0: 25 Hz here, chosen
  /// from the data where a payload is estimated.
  double cutoffHz = 0.0;
  /// lowPass: what the filter took is filtered once more and given back (twicing, Tukey 1977), so that of a loss e
  /// below the corner e^2 is left. Lets more noise through above it: only where noise asks for little smoothing.
  bool twicing = false;
  /// lowPass: each channel keeps only what stands out of its own noise (denoiser.h).
  bool denoise = false;
  int order = 3;    ///< savitzkyGolay: polynomial order
  int window = 11;  ///< savitzkyGolay: samples; an even window is widened by one (the paper's ten becomes 11).
  /// Motion::R_BS, velocity, position and joints stay empty: a payload's wrench does not depend on them.
  bool payloadOnly = false;
  double outputRateHz = 200.0;  ///< The motion is evaluated at this rate at most (0: every sample of the grid).
};

/// Uniformly sampled motion of S; K samples. All vectors in S axes.
struct Motion {
  double startTime = 0.0;  ///< [s] on the recording's clock
  double rateHz = 0.0;
  Eigen::Matrix3Xd specificForce;  ///< s = R_BS^T (a_BSo_B - g_B) [m/s2]: what an ideal accelerometer at S reads
  Eigen::Matrix3Xd omega;          ///< w_BS_S [rad/s]
  Eigen::Matrix3Xd alpha;          ///< alpha_BS_S [rad/s2]
  Eigen::Matrix3Xd velocity;       ///< v_BSo_B [m/s], B axes
  Eigen::Matrix3Xd position;       ///< p_BSo_B [m], B axes
  std::vector<Matrix3d> R_BS;
  MatrixXd q, dq, ddq;  ///< dof x K, smoothed joint motion [rad], [rad/s], [rad/s2]; empty without joints
  double keptHz =
      0.0;  ///< With MotionOptions::denoise: the highest frequency that was kept nearly whole; 0: all of them
  bool originAccelerationKnown = true;  ///< False with orientation only: a was taken as zero.
  /// Where the position is not known and an accelerometer stands in: the specific force is that of its own place, until
  /// addSwing() (core/estimation) moves it to S's origin.
  std::optional<AccelerometerMount> accelerometer;
  MatrixXd wrench;  ///< 6 x K: the recording's wrench, averaged and smoothed in the same way.
  Findings findings;

  Eigen::Index size() const { return omega.cols(); }
  double time(Eigen::Index k) const { return startTime + static_cast<double>(k) / rateHz; }
};

/// As of MotionOptions::payloadOnly.
void keepPayloadMotion(Motion& motion);

/// The robot and frame that a recording's joints refer to, resolved from its meta ("panda", a URDF, or none needed).
Result<RobotModel> robotFor(const RecordingMeta& meta, Findings& findings);

/// Specific force in standing poses (kind "poses"), a column a row of the recording; everything else is zero.
Result<Motion> standingPoses(const Recording& recording, const RobotModel* robot);

/// Kind "motion". `robot` may be null where the recording has poses. Fails if there are fewer than 10 rows.
Result<Motion> motionOf(const Recording& recording, const RobotModel* robot, const MotionOptions& options);

}  // namespace heft
