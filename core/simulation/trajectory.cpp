#include "core/simulation/trajectory.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/simulation/random.h"

namespace heft {

Jet minimumJerk(double u) {
  if (u <= 0.0) return {0.0, 0.0, 0.0};
  if (u >= 1.0) return {1.0, 0.0, 0.0};
  return {u * u * u * (10.0 + u * (-15.0 + 6.0 * u)), 30.0 * u * u * (1.0 - u) * (1.0 - u),
          60.0 * u * (1.0 - u) * (1.0 - 2.0 * u)};
}

void addWave(const Wave& wave, double t, Jet& jet) {
  const double angle = wave.omega * t + wave.phase;
  const double s = wave.amplitude * std::sin(angle);
  jet.value += s;
  jet.rate += wave.omega * wave.amplitude * std::cos(angle);
  jet.second -= wave.omega * wave.omega * s;
}

Tremor::Tremor(std::uint64_t seed, const std::vector<JointRoom>& rooms, double from, double to, double fade)
    : from_(from), to_(to), fade_(fade) {
  constexpr int kWaves = 3;
  constexpr double kFastest = 2.0 * std::numbers::pi * 11.0;
  for (std::size_t j = 0; j < rooms.size(); ++j) {
    RandomStream random(seed, RandomPurpose::tremor, j);
    const JointRoom& room = rooms[j];
    // Three waves of equal size that beat against each other; together they have the power of one of `size`.
    double size = room.unit * random.uniform(2e-4, 5e-4);
    // A weak or narrow joint keeps most of its room for the motion itself.
    const double most = std::min({0.3 * room.acceleration / (kFastest * kFastest), 0.1 * room.velocity / kFastest,
                                  0.02 * (room.upper - room.lower)});
    size = std::max(0.0, std::min(size, most / std::sqrt(kWaves)));
    std::vector<Wave> waves(kWaves);
    for (Wave& wave : waves) {
      wave.omega = 2.0 * std::numbers::pi * random.uniform(8.0, 11.0);
      wave.phase = random.uniform(0.0, 2.0 * std::numbers::pi);
      wave.amplitude = size / std::sqrt(kWaves);
    }
    waves_.push_back(std::move(waves));
  }
}

void Tremor::add(double t, VectorXd& q, VectorXd& dq, VectorXd& ddq) const {
  if (waves_.empty() || t <= from_ || t >= to_) return;
  Jet grip{1.0, 0.0, 0.0};
  if (t < from_ + fade_) {
    grip = minimumJerk((t - from_) / fade_);
  } else if (t > to_ - fade_) {
    grip = minimumJerk((to_ - t) / fade_);
    grip.rate = -grip.rate;
  }
  grip.rate /= fade_;
  grip.second /= fade_ * fade_;
  for (std::size_t j = 0; j < waves_.size(); ++j) {
    Jet shake;
    for (const Wave& wave : waves_[j]) addWave(wave, t, shake);
    const auto i = static_cast<Eigen::Index>(j);
    q(i) += grip.value * shake.value;
    dq(i) += grip.rate * shake.value + grip.value * shake.rate;
    ddq(i) += grip.second * shake.value + 2.0 * grip.rate * shake.rate + grip.value * shake.second;
  }
}

Jet Tremor::bound(std::size_t j) const {
  Jet bound;
  if (waves_.empty()) return bound;
  for (const Wave& wave : waves_[j]) {
    bound.value += wave.amplitude;
    bound.rate += wave.amplitude * (wave.omega + 1.875 / fade_);
    bound.second += wave.amplitude * (wave.omega * wave.omega + 3.75 * wave.omega / fade_ + 5.78 / (fade_ * fade_));
  }
  return bound;
}

double Contact::level(double t) const {
  if (t <= from || t >= to) return 0.0;
  if (edge <= 0.0) return std::sin(std::numbers::pi * (t - from) / (to - from));
  return minimumJerk((t - from) / edge).value * minimumJerk((to - t) / edge).value;
}

std::unique_ptr<Trajectory> planTrajectory(const RobotModel& robot, const ToolFrame& tool, const Payload& payload,
                                           const SimulateOptions& options) {
  if (options.motion == MotionKind::pickAndPlace) return planPickAndPlace(robot, tool, payload, options);
  return planWander(robot, tool, options);
}

}  // namespace heft
