// Motions that are sums of waves, run on a clock that can slow down and stand: excitation and free hand guiding.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/simulation/random.h"
#include "core/simulation/trajectory.h"

namespace heft {

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

/// The clock tau(t) of the motion. Its rate goes smoothly between 0 (at rest) and 1, so that starting, stopping and
/// pausing never exceed the speed of the motion itself.
class Clock {
 public:
  explicit Clock(double start) : end_(start) {}
  /// Continues for `duration` with the rate going to `rate` along a minimum-jerk profile.
  void go(double duration, double rate) {
    if (duration <= 0.0) return;
    pieces_.push_back({end_, duration, tau_, rate_, rate});
    tau_ += duration * 0.5 * (rate_ + rate);
    end_ += duration;
    rate_ = rate;
  }
  double end() const { return end_; }
  Jet at(double t) const {
    const auto after = std::upper_bound(pieces_.begin(), pieces_.end(), t,
                                        [](double time, const Piece& piece) { return time < piece.from; });
    if (after == pieces_.begin()) return {};
    const Piece& piece = *(after - 1);
    const double u = (t - piece.from) / piece.duration;
    const Jet profile = minimumJerk(u);
    const double change = piece.toRate - piece.fromRate;
    const double integral = u >= 1.0 ? u - 0.5 : u * u * u * u * (2.5 + u * (u - 3.0));
    return {piece.tau + piece.duration * (piece.fromRate * u + change * integral),
            piece.fromRate + change * profile.value, change * profile.rate / piece.duration};
  }

 private:
  struct Piece {
    double from, duration, tau, fromRate, toRate;
  };
  std::vector<Piece> pieces_;
  double end_ = 0.0, tau_ = 0.0, rate_ = 0.0;
};

class WaveTrajectory final : public Trajectory {
 public:
  WaveTrajectory(Clock clock, Tremor tremor, std::size_t dof)
      : clock_(std::move(clock)), tremor_(std::move(tremor)), waves_(dof), centre_(dof, 0.0) {}

  void at(double t, VectorXd& q, VectorXd& dq, VectorXd& ddq) const override {
    const Jet tau = clock_.at(t);
    for (std::size_t j = 0; j < waves_.size(); ++j) {
      const Jet wave = joint(j, tau);
      const auto i = static_cast<Eigen::Index>(j);
      q(i) = centre_[j] + wave.value;
      dq(i) = wave.rate;
      ddq(i) = wave.second;
    }
    tremor_.add(t, q, dq, ddq);
  }

  Jet joint(std::size_t j, const Jet& tau) const {
    Jet p;
    for (const Wave& wave : waves_[j]) addWave(wave, tau.value, p);
    return {p.value, p.rate * tau.rate, p.second * tau.rate * tau.rate + p.rate * tau.second};
  }

  void scale(std::size_t j, double factor) {
    for (Wave& wave : waves_[j]) wave.amplitude *= factor;
  }

  std::vector<Wave>& waves(std::size_t j) { return waves_[j]; }
  double& centre(std::size_t j) { return centre_[j]; }
  const Clock& clock() const { return clock_; }
  const Tremor& tremor() const { return tremor_; }

 private:
  Clock clock_;
  Tremor tremor_;
  std::vector<std::vector<Wave>> waves_;
  std::vector<double> centre_;
};

/// Fourier series of sines and cosines on a common base frequency (excitation), or unrelated low frequencies (free).
std::vector<Wave> drawWaves(const SimulateOptions& options, RandomStream& random) {
  // A slow hand covers less ground and takes longer: both share the factor.
  const double pace = std::sqrt(std::min(options.speed, 1.0));
  std::vector<Wave> waves;
  if (options.motion == MotionKind::excitation) {
    // Slow waves turn the tool far against gravity, fast ones shake its inertia.
    constexpr double kBaseHz = 0.1;
    for (const int k : {1, 2, 3, 5, 7, 10}) {
      const double a = random.normal(), b = random.normal();
      waves.push_back({kTurn * kBaseHz * k * pace, std::atan2(b, a), std::hypot(a, b) / k});
    }
  } else {
    constexpr int kWaves = 8;
    for (int k = 0; k < kWaves; ++k) {
      // One frequency in each eighth of the band, so that no draw is all slow or all fast.
      const double hz = 0.06 + 0.94 * (k + random.uniform()) / kWaves;
      waves.push_back({kTurn * hz * pace, random.uniform(0.0, kTurn), std::abs(random.normal()) / (0.15 + hz)});
    }
  }
  return waves;
}

Clock makeClock(const SimulateOptions& options, double rest, double ramp) {
  Clock clock(rest);
  clock.go(ramp, 1.0);
  const double stop = options.duration - rest - ramp;
  if (options.motion == MotionKind::free) {
    RandomStream random(options.seed, RandomPurpose::motion, 1000);
    for (;;) {
      const double move = random.uniform(3.0, 7.0);
      const double blend = random.uniform(0.5, 0.8);
      const double hold = random.uniform(0.2, 1.0);
      if (clock.end() + move + 2.0 * blend + hold + 1.0 > stop) break;
      clock.go(move, 1.0);
      clock.go(blend, 0.0);
      clock.go(hold, 0.0);
      clock.go(blend, 1.0);
    }
  }
  clock.go(stop - clock.end(), 1.0);
  clock.go(ramp, 0.0);
  clock.go(2.0 * rest + 1.0, 0.0);
  return clock;
}

/// Scales and centres joint j so that it stays in its room and peaks at `targetSpeed` where the room allows it.
void fitJoint(WaveTrajectory& trajectory, std::size_t j, const JointRoom& room, double home, double targetSpeed,
              const std::vector<Jet>& ticks) {
  double low = 0.0, high = 0.0, speed = 0.0, acceleration = 0.0;
  bool first = true;
  for (const Jet& tau : ticks) {
    const Jet p = trajectory.joint(j, tau);
    low = first ? p.value : std::min(low, p.value);
    high = first ? p.value : std::max(high, p.value);
    speed = std::max(speed, std::abs(p.rate));
    acceleration = std::max(acceleration, std::abs(p.second));
    first = false;
  }
  const Jet shake = trajectory.tremor().bound(j);
  const double tiny = 1e-12;
  double factor = std::min(targetSpeed, 0.98 * std::max(0.0, room.velocity - shake.rate)) / std::max(speed, tiny);
  factor = std::min(factor, 0.98 * std::max(0.0, room.acceleration - shake.second) / std::max(acceleration, tiny));
  const double width = std::max(0.0, room.upper - room.lower - 2.0 * shake.value);
  factor = std::min(factor, 0.98 * width / std::max(high - low, tiny));
  trajectory.scale(j, factor);
  const double half = 0.5 * (high - low) * factor * 1.01 + shake.value;
  const double middle = std::min(std::max(home, room.lower + half), std::max(room.lower + half, room.upper - half));
  trajectory.centre(j) = middle - 0.5 * (high + low) * factor;
}

struct Judgement {
  double load = 0.0;  ///< Largest Cartesian load.
  double low = 0.0;   ///< How far S comes below a floor at the base or into the robot's column [m].
};

Judgement judge(const RobotModel& robot, const ToolFrame& tool, const Trajectory& trajectory, double duration,
                int steps) {
  Judgement result;
  VectorXd q(robot.dof()), dq(robot.dof()), ddq(robot.dof());
  for (int k = 0; k <= steps; ++k) {
    trajectory.at(duration * k / steps, q, dq, ddq);
    result.load = std::max(result.load, cartesianLoad(robot, tool, q, dq, ddq));
    if (k % 4 != 0) continue;
    const Vector3d p = (robot.linkPose(q, tool.link) * tool.X_LS).translation();
    result.low = std::max({result.low, 0.10 - p.z(), 0.20 - p.head<2>().norm() - std::max(0.0, p.z() - 0.5)});
  }
  return result;
}

}  // namespace

std::unique_ptr<Trajectory> planWander(const RobotModel& robot, const ToolFrame& tool, const SimulateOptions& options) {
  const VectorXd home = robot.homePosture();
  const std::vector<JointRoom> rooms = jointRooms(robot, home);
  const double rest = std::min(0.25, 0.05 * options.duration);
  const double ramp = std::min(1.0, 0.2 * options.duration);
  const Clock clock = makeClock(options, rest, ramp);
  Tremor tremor;
  if (options.motion == MotionKind::free)
    tremor = Tremor(options.seed, rooms, rest, options.duration - rest, std::min(0.5, 0.2 * options.duration));

  // Fast enough for waves up to 1 Hz: a peak between two instants is missed by 0.2 % at most.
  const int steps = static_cast<int>(std::max(400.0, 50.0 * options.duration));
  std::vector<Jet> ticks;
  for (int k = 0; k <= steps; ++k) ticks.push_back(clock.at(options.duration * k / steps));

  // Seven joints at full speed may together be too fast for the flange. Of a few draws the best is taken, so that the
  // joints keep most of their speed; the rest is scaled away.
  constexpr int kDraws = 6;
  std::unique_ptr<WaveTrajectory> best;
  double bestScore = 0.0;
  for (int draw = 0; draw < kDraws; ++draw) {
    auto trajectory = std::make_unique<WaveTrajectory>(clock, tremor, rooms.size());
    for (std::size_t j = 0; j < rooms.size(); ++j) {
      RandomStream random(options.seed, RandomPurpose::motion, static_cast<std::uint64_t>(draw) * 64 + j);
      const double target = rooms[j].unit * options.speed * random.uniform(0.9, 1.2);
      trajectory->waves(j) = drawWaves(options, random);
      fitJoint(*trajectory, j, rooms[j], home(static_cast<Eigen::Index>(j)), target, ticks);
    }
    const Judgement judgement = judge(robot, tool, *trajectory, options.duration, steps);
    const double score = std::max(1.0, judgement.load) + 3.0 * judgement.low;
    if (!best || score < bestScore) {
      best = std::move(trajectory);
      bestScore = score;
    }
    if (bestScore <= 1.0) break;
  }
  // Speeds shrink in proportion, accelerations a little faster, but the posture moves too: repeat.
  for (int pass = 0; pass < 20; ++pass) {
    const double load = judge(robot, tool, *best, options.duration, steps).load;
    if (load <= 1.0) break;
    const double factor = 0.995 / load;
    for (std::size_t j = 0; j < rooms.size(); ++j) {
      // Shrinks around the middle of the stroke, which stays where it was.
      double low = best->joint(j, ticks.front()).value, high = low;
      for (const Jet& tau : ticks) {
        const double value = best->joint(j, tau).value;
        low = std::min(low, value);
        high = std::max(high, value);
      }
      best->centre(j) += (1.0 - factor) * 0.5 * (low + high);
      best->scale(j, factor);
    }
  }
  return best;
}

}  // namespace heft
