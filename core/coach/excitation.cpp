#include "core/coach/excitation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/say.h"
#include "core/motion/resample.h"
#include "core/simulation/trajectory.h"

namespace heft {

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kTaughtHz = 4.0;      // a hand's path without its tremor
constexpr double kOutputRate = 100.0;  // [Hz] of the samples between which quintics run
constexpr double kRamp = 1.0;          // [s] in which the replay's clock starts and stops
constexpr double kFade = 0.3;          // [s] in which the sines fade in and out
constexpr double kShortest = 1.5;      // [s] of a free part that gets sines
constexpr double kShare = 0.75;        // of the limits that the taught motion may use itself
constexpr int kSines = 3;              // a joint

/// The taught path as a function of its own time, from 0.
JointMotion taughtPath(const Recording& recording) {
  const UniformGrid grid = gridFor(recording.time);
  Channels q = onGrid(grid, recording.time, recording.q);
  const double cutoff = std::min(kTaughtHz, 0.2 * grid.rateHz);
  const auto pad = static_cast<Eigen::Index>(std::ceil(2.0 * grid.rateHz / cutoff));
  const auto stride = std::max<Eigen::Index>(1, std::lround(grid.rateHz / kOutputRate));
  Channels wide = padded(q, pad);
  filterForwardBackward(butterworthLowPass(4, cutoff, grid.rateHz), wide);
  const VectorXd first = centralDifferenceKernel(1, grid.rateHz), second = centralDifferenceKernel(2, grid.rateHz);
  const Eigen::Index n = (grid.size - 1) / stride + 1, dof = q.cols();
  JointMotion path{VectorXd(n), MatrixXd(n, dof), MatrixXd::Zero(n, dof), MatrixXd::Zero(n, dof)};
  for (Eigen::Index k = 0; k < n; ++k) {
    const Eigen::Index at = pad + k * stride;
    path.time(k) = static_cast<double>(k * stride) / grid.rateHz;
    path.q.row(k) = wide.row(at);
    for (Eigen::Index i = 0; i < 9; ++i) {
      path.dq.row(k) += first(i) * wide.row(at - 4 + i);
      path.ddq.row(k) += second(i) * wide.row(at - 4 + i);
    }
  }
  return path;
}

/// The path on a clock that starts and stops smoothly.
JointMotion fromRestToRest(const JointMotion& path) {
  // The clock's rate is a minimum-jerk step over kRamp, which covers half as much of the path.
  const double ramp = std::min(kRamp, path.duration()), duration = path.duration() + ramp;
  const auto n = static_cast<Eigen::Index>(std::lround(duration * kOutputRate)) + 1;
  JointMotion out{VectorXd::LinSpaced(n, 0.0, duration), MatrixXd(n, path.q.cols()), MatrixXd(n, path.q.cols()),
                  MatrixXd(n, path.q.cols())};
  const auto rising = [ramp](double t) {
    const double u = t / ramp;
    const Jet step = minimumJerk(u);
    return Jet{ramp * u * u * u * u * (2.5 + u * (u - 3.0)), step.value, step.rate / ramp};
  };
  VectorXd q, dq, ddq;
  for (Eigen::Index k = 0; k < n; ++k) {
    const double t = out.time(k);
    Jet tau{t - 0.5 * ramp, 1.0, 0.0};
    if (t < ramp) {
      tau = rising(t);
    } else if (t > duration - ramp) {
      const Jet back = rising(duration - t);
      tau = {path.duration() - back.value, back.rate, -back.second};
    }
    path.at(tau.value, q, dq, ddq);
    out.q.row(k) = q.transpose();
    out.dq.row(k) = tau.rate * dq.transpose();
    out.ddq.row(k) = (tau.rate * tau.rate * ddq + tau.second * dq).transpose();
  }
  return out;
}

/// The same motion with samples close enough for the sines.
JointMotion resampled(const JointMotion& motion) {
  const auto n = static_cast<Eigen::Index>(std::ceil(motion.duration() * kOutputRate)) + 1;
  const Eigen::Index dof = motion.q.cols();
  JointMotion out{VectorXd::LinSpaced(n, 0.0, motion.duration()), MatrixXd(n, dof), MatrixXd(n, dof), MatrixXd(n, dof)};
  VectorXd q, dq, ddq;
  for (Eigen::Index k = 0; k < n; ++k) {
    motion.at(out.time(k), q, dq, ddq);
    out.q.row(k) = q.transpose();
    out.dq.row(k) = dq.transpose();
    out.ddq.row(k) = ddq.transpose();
  }
  return out;
}

/// 0 outside the free parts, 1 inside, minimum-jerk steps between.
Jet fade(const std::vector<Segment>& free, double t) {
  for (const auto& part : free) {
    if (t <= part.from || t >= part.to) continue;
    Jet grip{1.0, 0.0, 0.0};
    if (t < part.from + kFade) {
      grip = minimumJerk((t - part.from) / kFade);
    } else if (t > part.to - kFade) {
      grip = minimumJerk((part.to - t) / kFade);
      grip.rate = -grip.rate;
    }
    return {grip.value, grip.rate / kFade, grip.second / (kFade * kFade)};
  }
  return {0.0, 0.0, 0.0};
}

/// Each joint's sines: its own frequencies, so that no two joints do the same; together of size 1 at most.
std::vector<std::vector<Wave>> wavesFor(const RobotModel& robot, const ExcitationOptions& options) {
  const auto rooms = jointRooms(robot, robot.homePosture());
  const int dof = robot.dof();
  std::vector<std::vector<Wave>> waves;
  for (int j = 0; j < dof; ++j) {
    std::vector<Wave> joint;
    double sum = 0.0;
    for (int k = 0; k < kSines; ++k) {
      // Spread over the band, joint by joint; phases by the golden angle keep the peaks apart.
      const double place = (k + (j + 0.5) / dof) / kSines;
      const double hz = options.lowHz + (options.highHz - options.lowHz) * place;
      joint.push_back({kTurn * hz, 2.4 * (3 * j + k), options.lowHz / hz});
      sum += options.lowHz / hz;
    }
    // The joints near the tool turn it most and move it least.
    const double weight = rooms[static_cast<std::size_t>(j)].unit * (j + 3 >= dof ? 1.0 : 0.25);
    for (Wave& wave : joint) wave.amplitude *= weight / sum;
    waves.push_back(std::move(joint));
  }
  return waves;
}

JointMotion withSines(const JointMotion& taught, const std::vector<Segment>& free,
                      const std::vector<std::vector<Wave>>& waves, double scale) {
  JointMotion out = taught;
  for (Eigen::Index k = 0; k < out.size(); ++k) {
    const double t = out.time(k);
    const Jet grip = fade(free, t);
    if (grip.value == 0.0) continue;
    for (std::size_t j = 0; j < waves.size(); ++j) {
      Jet wave;
      for (const Wave& w : waves[j]) addWave(w, t, wave);
      const auto i = static_cast<Eigen::Index>(j);
      out.q(k, i) += scale * grip.value * wave.value;
      out.dq(k, i) += scale * (grip.rate * wave.value + grip.value * wave.rate);
      out.ddq(k, i) += scale * (grip.second * wave.value + 2.0 * grip.rate * wave.rate + grip.value * wave.second);
    }
  }
  return out;
}

double deviationBetween(const GuidedTool& tool, const JointMotion& a, const JointMotion& b) {
  double most = 0.0;
  for (Eigen::Index k = 0; k < a.size(); k += 2) {
    const Isometry3d A = tool.robot->linkPose(a.q.row(k).transpose(), tool.link) * tool.X_LS;
    const Isometry3d B = tool.robot->linkPose(b.q.row(k).transpose(), tool.link) * tool.X_LS;
    most = std::max(most, (A.translation() - B.translation()).norm());
    for (const Vector3d& p : tool.points) most = std::max(most, (A * p - B * p).norm());
  }
  return most;
}

/// Its samples inside a segment, on the whole motion's clock.
JointMotion partOf(const JointMotion& motion, const Segment& part) {
  const double* begin = motion.time.data();
  const auto from = std::lower_bound(begin, begin + motion.size(), part.from) - begin;
  const auto count = std::max<Eigen::Index>(0, std::lower_bound(begin, begin + motion.size(), part.to) - begin - from);
  return {motion.time.segment(from, count), motion.q.middleRows(from, count), motion.dq.middleRows(from, count),
          motion.ddq.middleRows(from, count)};
}

/// What a replay of the free parts tells.
Uncertainty afterReplay(OnlineInformation information, const GuidedTool& tool, const Vector3d& gravity,
                        const JointMotion& motion, const std::vector<Segment>& free) {
  for (const auto& segment : free) {
    JointMotion part = partOf(motion, segment);
    if (part.size() < 2) continue;
    part.time.array() -= part.time(0);
    information = informationWith(information, rowsOfMotion(information, tool, gravity, part));
  }
  return uncertaintyOf(information);
}

}  // namespace

Result<ExcitedMotion> excite(const Recording& recording, const GuidedTool& given, const std::vector<Segment>& segments,
                             const OnlineInformation& information, const ExcitationOptions& wanted) {
  if (!recording.hasJoints() || recording.q.cols() != given.robot->dof())
    return Error{"A replay needs the joint angles of the robot that will make it: the recording has none that fit."};
  if (!(wanted.lowHz > 0.0) || !(wanted.highHz > wanted.lowHz) || !(wanted.highHz <= 10.0))
    return Error{"The sines' band must lie between 0 and 10 Hz, the lower end first."};
  if (recording.rows() < 20) return Error{"The recording is too short to be replayed."};
  ExcitationOptions options = wanted;
  options.limits.gravity = recording.meta.gravity;
  options.limits.payload = fromParameters(information.solution.phi);
  GuidedTool tool = given;
  tool.points.push_back(options.limits.payload->com);

  ExcitedMotion out;
  const double start = recording.time(0);
  const JointMotion path = taughtPath(recording);
  out.taught = fromRestToRest(path);
  LimitUse use = limitUse(tool, out.taught, options.limits);
  if (use.position > 1.0)
    return Error{
        "The taught path itself comes too close to the end of a joint's range (margin 0.03 rad). Teach it further "
        "inside."};
  JointMotion standing = out.taught;
  standing.dq.setZero();
  standing.ddq.setZero();
  if (const TorqueUse weight = torqueUse(tool, standing, options.limits); weight.share > 1.0)
    return Error{heft::say("The arm cannot hold this load all along the taught path: {}", weight.sentence())};
  // Speeds go with one over the time; accelerations, and what of the torques is not weight, with its square.
  for (int round = 0; round < 8; ++round) {
    const double factor = std::max({std::max({use.velocity, use.tcpSpeed, use.cartesian}) / kShare,
                                    std::sqrt(use.acceleration / kShare), std::sqrt(use.torque.share)});
    if (factor <= 1.0) break;
    out.slowed *= 1.02 * factor;
    out.taught = out.taught.slower(1.02 * factor);
    use = limitUse(tool, out.taught, options.limits);
  }
  if (out.slowed > 1.0) out.taught = resampled(out.taught);
  const double ramp = std::min(kRamp, path.duration());
  for (const auto& s : segments) {
    if (s.label != MarkLabel::free) continue;
    Segment part = s;
    part.from = out.slowed * (std::max(0.0, s.from - start) + 0.5 * ramp);
    part.to = out.slowed * (std::min(path.duration(), s.to - start) + 0.5 * ramp);
    if (part.to - part.from >= kShortest) out.free.push_back(part);
  }
  if (out.free.empty())
    return Error{
        fmt::format("No free part of the demonstration is at least {} s long: there is no room for added sine motions.",
                    kShortest)};

  const auto waves = wavesFor(*tool.robot, options);
  // Elsewhere the task touches something on purpose.
  const auto conflictIn = [&](const JointMotion& motion) -> std::optional<Conflict> {
    if (options.limits.clearance)
      for (const auto& part : out.free)
        if (auto conflict = options.limits.clearance->firstConflict(partOf(motion, part))) return conflict;
    return std::nullopt;
  };
  if (const auto conflict = conflictIn(out.taught))
    return Error{heft::say("The taught path leaves no room for added sine motions, even where it is free: {}",
                           conflict->sentence())};
  const auto within = [&](double scale) {
    const JointMotion motion = withSines(out.taught, out.free, waves, scale);
    return limitUse(tool, motion, options.limits).kept() && !conflictIn(motion) &&
           deviationBetween(tool, out.taught, motion) <= options.deviation;
  };
  double low = 0.0, high = options.amplitude;
  if (within(high)) low = high;
  for (int i = 0; i < 7 && low < high; ++i) (within(0.5 * (low + high)) ? low : high) = 0.5 * (low + high);
  out.excited = withSines(out.taught, out.free, waves, low);
  out.use = limitUse(tool, out.excited, options.limits);
  out.amplitude = (out.excited.q - out.taught.q).cwiseAbs().maxCoeff();
  out.deviation = deviationBetween(tool, out.taught, out.excited);
  out.now = uncertaintyOf(information);
  out.replayed = afterReplay(information, tool, recording.meta.gravity, out.taught, out.free);
  out.after = afterReplay(information, tool, recording.meta.gravity, out.excited, out.free);
  return out;
}

}  // namespace heft
