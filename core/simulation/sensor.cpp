#include "core/simulation/sensor.h"

#include <algorithm>
#include <cmath>

#include "core/simulation/random.h"

namespace heft {

namespace {

double rounded(double value, double step) { return step > 0.0 ? std::nearbyint(value / step) * step : value; }

}  // namespace

Vector6d drawBias(const SensorModel& sensor, std::uint64_t seed) {
  Vector6d bias;
  for (int c = 0; c < 6; ++c) {
    RandomStream random(seed, RandomPurpose::bias, static_cast<std::uint64_t>(c));
    bias(c) = (c < 3 ? sensor.forceBias : sensor.torqueBias) * random.normal();
  }
  return bias;
}

WrenchSeries drawNoise(const SensorModel& sensor, std::uint64_t seed, double rateHz, Eigen::Index rows) {
  WrenchSeries noise(rows, 6);
  // First-order Gauss-Markov: x' = rho x + sqrt(1 - rho^2) sigma n, started in its stationary state.
  const double rho = sensor.colourTime > 0.0 ? std::exp(-1.0 / (rateHz * sensor.colourTime)) : 0.0;
  const double innovation = std::sqrt(1.0 - rho * rho);
  for (int c = 0; c < 6; ++c) {
    const auto channel = static_cast<std::uint64_t>(c);
    RandomStream white(seed, RandomPurpose::white, channel), coloured(seed, RandomPurpose::coloured, channel),
        walk(seed, RandomPurpose::walk, channel);
    const double whiteSigma = c < 3 ? sensor.forceNoise : sensor.torqueNoise;
    const double colouredSigma = c < 3 ? sensor.colouredForce : sensor.colouredTorque;
    const double stride = (c < 3 ? sensor.forceWalk : sensor.torqueWalk) / std::sqrt(rateHz);
    double state = coloured.normal(), place = 0.0;
    for (Eigen::Index k = 0; k < rows; ++k) {
      noise(k, c) = whiteSigma * white.normal() + colouredSigma * state + place;
      state = rho * state + innovation * coloured.normal();
      if (stride > 0.0) place += stride * walk.normal();
    }
  }
  return noise;
}

void digitise(const SensorModel& sensor, WrenchSeries& wrench) {
  for (int c = 0; c < 6; ++c) {
    const double range = c < 3 ? sensor.forceRange(c) : sensor.torqueRange;
    const double step = c < 3 ? sensor.forceResolution(c) : sensor.torqueResolution(c - 3);
    for (double& x : wrench.col(c)) x = std::clamp(rounded(std::clamp(x, -range, range), step), -range, range);
  }
}

void measureWrench(const SensorModel& sensor, std::uint64_t seed, double rateHz, const Vector6d& bias,
                   WrenchSeries& wrench) {
  wrench.rowwise() += bias.transpose();
  wrench += drawNoise(sensor, seed, rateHz, wrench.rows());
  digitise(sensor, wrench);
}

void measureJoints(const SimulateOptions& options, MatrixXd& q, MatrixXd& dq) {
  for (Eigen::Index j = 0; j < q.cols(); ++j) {
    RandomStream random(options.seed, RandomPurpose::encoder, static_cast<std::uint64_t>(j));
    for (Eigen::Index k = 0; k < q.rows(); ++k) {
      q(k, j) += options.positionNoise * random.normal();
      dq(k, j) = rounded(dq(k, j), options.velocityQuantum);
    }
  }
}

}  // namespace heft
