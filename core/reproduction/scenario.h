#pragma once
// Recordings like the seed paper's, and what a real sensor on a real flange does to them, one cause at a time.
#include <vector>

#include "core/simulation/simulate.h"

namespace heft {

/// What is wrong with a measurement besides noise. None of it is in the paper's equation.
struct SensorFaults {
  bool bias = false;   ///< Constant force and torque that nobody tared.
  bool delay = false;  ///< The wrench arrives kWrenchDelay late.
  bool tilt = false;   ///< The sensor is turned by kMountTilt against where it is believed to be.
};

constexpr double kWrenchDelay = 0.010;                               ///< [s]
constexpr double kMountTilt = 2.0 * 3.14159265358979323846 / 180.0;  ///< [rad]

struct Scenario {
  std::string name;
  bool handGuided = false;
  Payload payload;
  SimulateOptions options;
};

/// The paper's five recordings, `repeats` times with other seeds: the predefined motion with 0.2, 0.35 and 0.5 kg
/// bolted to the sensor, and the gripper of 0.8 kg guided by hand, picking and placing and freely. `scale` shortens all
/// durations (1: 20 s and 10 s).
std::vector<Scenario> paperScenarios(std::uint64_t seed, int repeats, double scale, double rateHz);

/// The same motion as simulated, measured with noise and these faults. The truth stays in the axes that are believed.
Recording measured(const Simulated& simulated, const SensorFaults& faults);

/// The recording with the wrench that the payload's equation gives for the motion as measured, and nothing else: the
/// paper's validation data.
Result<Recording> validationData(const Recording& recording, const RobotModel& robot, const Payload& payload);

/// Of |I alpha + omega x I omega| about the sensor's origin over the motion [N m, root mean square]: all that the
/// sensor ever feels of the inertia.
Result<double> inertialTorque(const Recording& recording, const RobotModel& robot, const Payload& payload);

}  // namespace heft
