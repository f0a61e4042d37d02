#pragma once
// Simulated demonstrations: a motion inside the robot's limits and what a real sensor makes of the payload's wrench.
#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/recording/recording.h"
#include "core/robot/robot_model.h"

namespace heft {

enum class MotionKind {
  excitation,    ///< Superposed sines and cosines inside all limits (the seed paper's predefined motion).
  pickAndPlace,  ///< Approach, grasp, lift, carry, put down, with contact phases.
  free,          ///< Free hand guiding: smooth wandering with tremor.
};

/// The force/torque sensor. Defaults are a Schunk/ATI Gamma SI-32-2.5.
struct SensorModel {
  double forceNoise = 0.05;    ///< white noise, standard deviation [N]
  double torqueNoise = 0.002;  ///< [N m]
  double colouredForce = 0.03;    ///< stationary first-order Gauss-Markov noise, standard deviation [N]
  double colouredTorque = 0.001;  ///< [N m]
  double colourTime = 0.05;       ///< its correlation time [s]
  Vector3d forceResolution{1.0 / 160, 1.0 / 160, 1.0 / 80};                  ///< [N]
  Vector3d torqueResolution{1.0 / 2000, 1.0 / 2000, 1.0 / 2000};             ///< [N m]
  double forceBias = 3.0;    ///< Biases are drawn from a normal distribution of this standard deviation [N]
  double torqueBias = 0.1;   ///< [N m]
  Vector3d forceRange{32, 32, 100};  ///< Clipped beyond [N]
  double torqueRange = 2.5;          ///< [N m]
};

struct SimulateOptions {
  MotionKind motion = MotionKind::free;
  double duration = 20.0;  ///< [s]
  double rateHz = 1000.0;
  double speed = 1.0;  ///< Scales how fast the arm moves: 1 = brisk hand guiding; slow guiding is about 0.3.
  std::uint64_t seed = 1;
  SensorModel sensor;
  double positionNoise = 1e-5;       ///< encoder noise on q [rad]
  double velocityQuantum = 1e-3;     ///< step of the controller's reported dq [rad/s]
  SensorMount mount{"panda_link8", {0.0, 0.0, 0.04}, {0.0, 0.0, 0.0}};
  Vector3d gravity{0.0, 0.0, -9.81};
};

/// What the recording hides.
struct SimulationTruth {
  Payload payload;
  Vector3d forceBias = Vector3d::Zero();
  Vector3d torqueBias = Vector3d::Zero();
  std::vector<Mark> marks;  ///< free and contact, true boundaries
};

struct Simulated {
  Recording recording;
  SimulationTruth truth;
  MatrixXd q, dq, ddq;  ///< The exact joint motion, N x dof: for tests.
};

/// Deterministic: same options and payload give the same bytes on every machine with the same libm.
Result<Simulated> simulate(const RobotModel& robot, const Payload& payload, const SimulateOptions& options,
                           const Progress& progress = {});

}  // namespace heft
