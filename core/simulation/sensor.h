#pragma once
// What the force/torque sensor and the controller make of exact values.
#include <vector>

#include "core/simulation/random.h"
#include "core/simulation/simulate.h"

namespace heft {

using SampledWrench = Eigen::Matrix<double, Eigen::Dynamic, 6>;  ///< N x 6, force [N], torque [N m]

/// The bias of this seed's sensor.
Vector6d drawBias(const SensorModel& sensor, std::uint64_t seed);

/// White, coloured and random-walk noise, sample by sample.
class SensorNoise {
 public:
  SensorNoise(const SensorModel& sensor, std::uint64_t seed, double rateHz);
  Vector6d next();

 private:
  struct Channel {
    RandomStream white, coloured, walk;
    double whiteSigma, colouredSigma, stride;
    double state, place = 0.0;
  };
  double rho_ = 0.0, innovation_ = 1.0;
  std::vector<Channel> channels_;
};

/// The same for a whole recording.
SampledWrench drawNoise(const SensorModel& sensor, std::uint64_t seed, double rateHz, Eigen::Index rows);

/// Clips to the range and rounds to the resolution, in place.
void digitise(const SensorModel& sensor, SampledWrench& wrench);

/// The same for one sample.
Vector6d digitised(const SensorModel& sensor, const Vector6d& wrench);

/// Adds bias and noise and digitises, in place.
void measureWrench(const SensorModel& sensor, std::uint64_t seed, double rateHz, const Vector6d& bias,
                   SampledWrench& wrench);

/// Encoder noise on q and the step of the reported dq, in place. Sliders' noise is taken in metres.
void measureJoints(const SimulateOptions& options, MatrixXd& q, MatrixXd& dq);

}  // namespace heft
