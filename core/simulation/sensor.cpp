#include "core/simulation/sensor.h"

#include <algorithm>
#include <cmath>

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

SensorNoise::SensorNoise(const SensorModel& sensor, std::uint64_t seed, double rateHz) {
  // First-order Gauss-Markov: x' = rho x + sqrt(1 - rho^2) sigma n, started in its stationary state.
  rho_ = sensor.colourTime > 0.0 ? std::exp(-1.0 / (rateHz * sensor.colourTime)) : 0.0;
  innovation_ = std::sqrt(1.0 - rho_ * rho_);
  for (int c = 0; c < 6; ++c) {
    const auto channel = static_cast<std::uint64_t>(c);
    RandomStream coloured(seed, RandomPurpose::coloured, channel);
    const double state = coloured.normal();
    channels_.push_back(
        {RandomStream(seed, RandomPurpose::white, channel), coloured, RandomStream(seed, RandomPurpose::walk, channel),
         c < 3 ? sensor.forceNoise : sensor.torqueNoise, c < 3 ? sensor.colouredForce : sensor.colouredTorque,
         (c < 3 ? sensor.forceWalk : sensor.torqueWalk) / std::sqrt(rateHz), state});
  }
}

Vector6d SensorNoise::next() {
  Vector6d noise;
  for (int c = 0; c < 6; ++c) {
    Channel& channel = channels_[static_cast<std::size_t>(c)];
    noise(c) = channel.whiteSigma * channel.white.normal() + channel.colouredSigma * channel.state + channel.place;
    channel.state = rho_ * channel.state + innovation_ * channel.coloured.normal();
    if (channel.stride > 0.0) channel.place += channel.stride * channel.walk.normal();
  }
  return noise;
}

SampledWrench drawNoise(const SensorModel& sensor, std::uint64_t seed, double rateHz, Eigen::Index rows) {
  SampledWrench noise(rows, 6);
  SensorNoise stream(sensor, seed, rateHz);
  for (Eigen::Index k = 0; k < rows; ++k) noise.row(k) = stream.next().transpose();
  return noise;
}

Vector6d digitised(const SensorModel& sensor, const Vector6d& wrench) {
  Vector6d out;
  for (int c = 0; c < 6; ++c) {
    const double range = c < 3 ? sensor.forceRange(c) : sensor.torqueRange;
    const double step = c < 3 ? sensor.forceResolution(c) : sensor.torqueResolution(c - 3);
    out(c) = std::clamp(rounded(std::clamp(wrench(c), -range, range), step), -range, range);
  }
  return out;
}

void digitise(const SensorModel& sensor, SampledWrench& wrench) {
  for (Eigen::Index k = 0; k < wrench.rows(); ++k)
    wrench.row(k) = digitised(sensor, wrench.row(k).transpose()).transpose();
}

void measureWrench(const SensorModel& sensor, std::uint64_t seed, double rateHz, const Vector6d& bias,
                   SampledWrench& wrench) {
  wrench.rowwise() += bias.transpose();
  wrench += drawNoise(sensor, seed, rateHz, wrench.rows());
  digitise(sensor, wrench);
}

void measureJoints(const SimulateOptions& options, MatrixXd& q, MatrixXd& dq) {
  for (Eigen::Index j = 0; j < q.cols(); ++j) {
    RandomStream random(options.seed, RandomPurpose::encoder, static_cast<std::uint64_t>(j));
    for (Eigen::Index k = 0; k < q.rows(); ++k) {
      q(k, j) = rounded(q(k, j) + options.positionNoise * random.normal(), options.positionStep);
      dq(k, j) = rounded(dq(k, j), options.velocityQuantum);
    }
  }
}

}  // namespace heft
