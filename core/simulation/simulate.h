#pragma once
// Simulated demonstrations: a motion inside the robot's limits and what a real sensor makes of the payload's wrench.
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/recording/recording.h"
#include "core/robot/robot_model.h"
#include "core/simulation/effects/truth.h"

namespace heft {

enum class MotionKind {
  excitation,    ///< Superposed sines and cosines inside all limits (the seed paper's predefined motion).
  pickAndPlace,  ///< Approach, grasp, lift, carry, put down, with contact phases.
  free,          ///< Free hand guiding: smooth wandering with tremor and pauses.
};

/// "excitation", "pick-and-place", "free", as on the command line.
std::string_view toString(MotionKind kind);
std::optional<MotionKind> motionKindFromString(std::string_view text);

/// The force/torque sensor. Defaults are a Schunk/ATI Gamma SI-32-2.5.
struct SensorModel {
  std::string name = "Schunk FT Gamma SI-32-2.5";
  double forceNoise = 0.05;       ///< white noise, standard deviation [N]
  double torqueNoise = 0.002;     ///< [N m]
  double colouredForce = 0.03;    ///< stationary first-order Gauss-Markov noise, standard deviation [N]
  double colouredTorque = 0.001;  ///< [N m]
  double colourTime = 0.05;       ///< its correlation time [s]; 0: white
  double forceWalk = 0.0;         ///< random walk of the zero, starting at 0: deviation after one second [N/sqrt(s)]
  double torqueWalk = 0.0;        ///< [N m/sqrt(s)]
  Vector3d forceResolution{1.0 / 160, 1.0 / 160, 1.0 / 80};       ///< [N]; 0: none
  Vector3d torqueResolution{1.0 / 2000, 1.0 / 2000, 1.0 / 2000};  ///< [N m]; 0: none
  double forceBias = 3.0;            ///< Biases are drawn from a normal distribution of this standard deviation [N]
  double torqueBias = 0.1;           ///< [N m]
  Vector3d forceRange{32, 32, 100};  ///< Clipped beyond [N]
  double torqueRange = 2.5;          ///< [N m]
};

struct SimulateOptions {
  MotionKind motion = MotionKind::free;
  double duration = 20.0;  ///< [s]; round(duration * rateHz) rows, the first at time 0
  double rateHz = 1000.0;
  /// Scales how fast the arm moves: 1 = brisk hand guiding, joint peaks of about 1 rad/s; slow guiding is about 0.3.
  /// Limits always win, so a large value only makes a fast arm.
  double speed = 1.0;
  std::uint64_t seed = 1;
  std::optional<std::uint64_t> motionSeed;  ///< Of motion and contacts alone; nothing: `seed`
  SensorModel sensor;
  double positionNoise = 1e-5;    ///< encoder noise on q, standard deviation [rad]
  double positionStep = 0.0;      ///< step of the encoder on q [rad]; 0: exact
  double velocityQuantum = 1e-3;  ///< step of the controller's reported dq [rad/s]; 0: exact
  SensorMount mount{"panda_link8", {0.0, 0.0, 0.04}, {0.0, 0.0, 0.0}};
  Vector3d gravity{0.0, 0.0, -9.81};     ///< g_B [m/s2]
  std::string robotReference = "panda";  ///< What the meta names as robot: "panda" or the URDF's path.
  std::vector<EffectRequest> effects;    ///< Faults of the rig to hide (effects/effect.h).
};

/// What the recording hides.
struct SimulationTruth {
  Payload payload;
  Vector3d forceBias = Vector3d::Zero();   ///< [N]
  Vector3d torqueBias = Vector3d::Zero();  ///< [N m]
  std::vector<Mark> marks;                 ///< free and contact, true boundaries, without gaps
  std::vector<EffectTruth> effects;        ///< In the order of the chain.
  SimulateOptions options;                 ///< What was asked for.
};

struct Simulated {
  Recording recording;
  SimulationTruth truth;
  MatrixXd q, dq, ddq;  ///< The exact joint motion, N x dof: for tests.
  /// Parts of the exact F_PSo_S, N x 6, without bias and noise: what the payload's motion needs, and what balances the
  /// contact. Their sum plus bias and noise, clipped and rounded, is the recorded wrench where nothing is hidden.
  Eigen::Matrix<double, Eigen::Dynamic, 6> payloadWrench, contactWrench;
  /// What arrives from the gauges through filters and delays, effects included, before bias and noise, N x 6.
  Eigen::Matrix<double, Eigen::Dynamic, 6> signal;
};

/// Deterministic: same options and payload give the same bytes on every machine with the same libm.
/// Limits: the joints' positions, velocities and accelerations (where a URDF states none: 2 rad/s and 10 rad/s2, 0.5
/// m/s and 3 m/s2) and, at the mount's parent link and at S, Panda's Cartesian 1.7 m/s, 2.5 rad/s, 13 m/s2, 25 rad/s2.
/// Fails for an unphysical payload, an unknown mount link, a robot without moving joints and senseless options.
Result<Simulated> simulate(const RobotModel& robot, const Payload& payload, const SimulateOptions& options,
                           const Progress& progress = {});

/// {"schema": "heft.truth/1", "payload": {...}, "bias": {...}, "marks": [...], "effects": [...], "options": {...}},
/// keys as in a result.
nlohmann::json toJson(const SimulationTruth& truth);

}  // namespace heft
