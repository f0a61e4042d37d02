#pragma once
// What the force/torque sensor and the controller make of exact values.
#include "core/simulation/simulate.h"

namespace heft {

using WrenchSeries = Eigen::Matrix<double, Eigen::Dynamic, 6>;  ///< N x 6, force [N], torque [N m]

/// The bias of this seed's sensor.
Vector6d drawBias(const SensorModel& sensor, std::uint64_t seed);

/// White, coloured and random-walk noise.
WrenchSeries drawNoise(const SensorModel& sensor, std::uint64_t seed, double rateHz, Eigen::Index rows);

/// Clips to the range and rounds to the resolution, in place.
void digitise(const SensorModel& sensor, WrenchSeries& wrench);

/// Adds bias and noise and digitises, in place.
void measureWrench(const SensorModel& sensor, std::uint64_t seed, double rateHz, const Vector6d& bias,
                   WrenchSeries& wrench);

/// Encoder noise on q and the step of the reported dq, in place. Sliders' noise is taken in metres.
void measureJoints(const SimulateOptions& options, MatrixXd& q, MatrixXd& dq);

}  // namespace heft
