#include "core/motion/motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <numbers>
#include <stdexcept>

#include "core/base/parallel.h"
#include "core/base/remedy.h"
#include "core/base/say.h"
#include "core/base/stop.h"
#include "core/math/statistics.h"
#include "core/motion/denoiser.h"
#include "core/motion/inertial_witness.h"
#include "core/motion/mount_link.h"
#include "core/motion/resample.h"
#include "core/motion/savitzky_golay.h"

namespace heft {

namespace {

/// Value, first and second derivative of each channel at the output instants.
struct Derivatives {
  Channels value, first, second;
};

/// The output instants as rows of the uniform grid: first, first + stride, ...
struct Output {
  Eigen::Index first = 0;
  int stride = 1;
  Eigen::Index size = 0;
};

/// Channels of a recording as a uniform grid reads them, made where they are looked at: of an hour, only a stretch at a
/// time lies in memory.
struct Gridded {
  const UniformGrid& grid;
  const VectorXd& time;
  Eigen::Ref<const MatrixXd> values;  ///< Rows belong to `time`

  Eigen::Index channels() const { return values.cols(); }
  Channels rows(Eigen::Index from, Eigen::Index to) const { return onGrid(grid, time, values, from, to); }
  Channels all() const { return rows(0, grid.size); }
};

/// Rows of the grid that are smoothed at a time: they stay in the processor's cache.
constexpr Eigen::Index kStretchRows = Eigen::Index{1} << 15;
/// What a filter forgets of where it began before its output counts.
constexpr double kForgotten = 1e-12;

/// Rows after which the slowest pole of `sections` has forgotten all but kForgotten.
Eigen::Index settlingRows(const std::vector<Biquad>& sections) {
  double slowest = 0.0;
  for (const Biquad& s : sections) slowest = std::max(slowest, std::sqrt(std::abs(s.a2)));  // |pole| of a complex pair
  return static_cast<Eigen::Index>(std::ceil(std::log(kForgotten) / std::log(slowest)));
}

/// Reach of the shortest central differences of a slope that are right to a thousandth at the cutoff; the longest where
/// that lies close to half the rate.
int reachFor(double cutoffHz, double rateHz) {
  constexpr double kRight = 1e-3;
  constexpr int kLeastReach = 4, kMostReach = 16;
  const double w = 2.0 * std::numbers::pi * cutoffHz / rateHz;
  const auto off = [w](int reach) {
    const VectorXd kernel = centralDifferenceKernel(1, 1.0, reach);
    double slope = 0.0;
    for (int k = 1; k <= reach; ++k) slope += 2.0 * kernel(reach + k) * std::sin(k * w);
    return std::abs(slope / w - 1.0);
  };
  int reach = kLeastReach;
  while (reach < kMostReach && off(reach) > kRight) ++reach;
  return reach;
}

/// One smoother for every channel of a recording, so that motion and wrench pass through the same filter.
class Smoother {
 public:
  Smoother(const MotionOptions& options, const UniformGrid& grid) : rate_(grid.rateHz), savitzkyGolay_(2, 3) {
    kind_ = options.smoothing;
    output_.stride = 1;
    if (options.outputRateHz > 0.0)
      output_.stride = std::max(1, static_cast<int>(std::floor(grid.rateHz / options.outputRateHz + 1e-6)));
    output_.first = output_.stride / 2;
    output_.size = grid.size > output_.first ? (grid.size - 1 - output_.first) / output_.stride + 1 : 0;
    if (kind_ == SmoothingKind::savitzkyGolay) {
      savitzkyGolay_ = SavitzkyGolay(options.order, options.window);
    } else {
      twicing_ = options.twicing;
      denoise_ = options.denoise;
      cutoff_ = std::min(options.cutoffHz > 0.0 ? options.cutoffHz : kDefaultCutoffHz, 0.4 * grid.rateHz);
      sections_ = butterworthLowPass(6, cutoff_, grid.rateHz);
      // Derivatives commute with the average, so one set of weights does both.
      kernels_[0] = averagingKernel(output_.stride);
      const int reach = reachFor(cutoff_, grid.rateHz);
      for (const int d : {1, 2})
        kernels_[static_cast<std::size_t>(d)] = convolved(kernels_[0], centralDifferenceKernel(d, grid.rateHz, reach));
      const double remembers = denoise_ ? 1.0 : 2.0 / cutoff_;  // [s]
      pad_ = static_cast<Eigen::Index>(std::ceil(remembers * grid.rateHz)) + output_.stride + reach;
      settles_ = std::max(pad_, (twicing_ ? 2 : 1) * settlingRows(sections_));
    }
  }

  const Output& output() const { return output_; }
  double cutoffHz() const { return cutoff_; }
  double rateHz() const { return rate_; }
  /// Of what was denoised so far, as Motion::keptHz.
  double keptHz() const { return std::isfinite(keptHz_) ? keptHz_ : 0.0; }

  /// Derivatives up to `order` (0, 1 or 2); what is not asked for stays empty.
  Derivatives run(const Gridded& signal, int order) {
    Derivatives out;
    if (kind_ == SmoothingKind::savitzkyGolay) {
      const Channels all = signal.all();
      out.value = picked(savitzkyGolay_.apply(all, 0, rate_));
      if (order > 0) out.first = picked(savitzkyGolay_.apply(all, 1, rate_));
      if (order > 1) out.second = picked(savitzkyGolay_.apply(all, 2, rate_));
      return out;
    }
    const std::array<Channels*, 3> wanted{&out.value, &out.first, &out.second};
    for (int d = 0; d <= order; ++d) wanted[static_cast<std::size_t>(d)]->setZero(output_.size, signal.channels());
    // A denoiser learns from the whole signal.
    inStretches(signal, denoise_ ? signal.grid.size : kStretchRows, pad_, settles_,
                [&](const Channels& part, Channels work, Eigen::Index row, Eigen::Index from, Eigen::Index to) {
                  smooth(part, work);
                  for (int d = 0; d <= order; ++d)
                    addWeighted(work, kernels_[static_cast<std::size_t>(d)], row, from, to,
                                *wanted[static_cast<std::size_t>(d)]);
                });
    return out;
  }

  /// The wrench: averaged over the output interval but not low-passed, so that its noise keeps a spectrum that an
  /// autoregressive model can describe. With Savitzky-Golay the same polynomials as for the motion.
  Channels wrench(const Gridded& signal) const {
    if (kind_ == SmoothingKind::savitzkyGolay) return picked(savitzkyGolay_.apply(signal.all(), 0, rate_));
    Channels out = Channels::Zero(output_.size, signal.channels());
    inStretches(signal, kStretchRows, output_.stride, output_.stride,
                [&](const Channels&, const Channels& work, Eigen::Index row, Eigen::Index from, Eigen::Index to) {
                  addWeighted(work, kernels_[0], row, from, to, out);
                });
    return out;
  }

 private:
  Channels picked(const Channels& all) const {
    Channels out(output_.size, all.cols());
    for (Eigen::Index k = 0; k < output_.size; ++k) out.row(k) = all.row(output_.first + k * output_.stride);
    return out;
  }
  /// Calls work(part, extended, row, from, to) for stretches of the grid of about `length` rows that make the output
  /// instants [from, to): `part` is what lies on the grid, with `margin` more rows on both sides where there are any;
  /// `extended` is padded by `pad` where the recording ends; its first row is row `row` of the grid.
  template <class Work>
  void inStretches(const Gridded& signal, Eigen::Index length, Eigen::Index pad, Eigen::Index margin,
                   const Work& work) const {
    const Eigen::Index instants = std::max<Eigen::Index>(1, length / output_.stride);
    const Eigen::Index reach = margin + kernels_[2].size() / 2;
    for (Eigen::Index from = 0; from < output_.size;) {
      // What would be left of less than half a stretch is done with this one.
      const Eigen::Index to = output_.size - from < instants + instants / 2 ? output_.size : from + instants;
      const Eigen::Index first = std::max<Eigen::Index>(0, output_.first + from * output_.stride - reach);
      const Eigen::Index last = std::min(signal.grid.size, output_.first + (to - 1) * output_.stride + reach + 1);
      stopPoint();
      const Channels part = signal.rows(first, to == output_.size ? signal.grid.size : last);
      const Eigen::Index before = first == 0 ? pad : 0, after = first + part.rows() == signal.grid.size ? pad : 0;
      work(part, padded(part, before, after), first - before, from, to);
      from = to;
    }
  }
  /// In place: the filter over what was padded; `part` without its padding.
  void smooth(const Channels& part, Channels& work) {
    Channels taken;
    if (twicing_) taken = work;
    filterForwardBackward(sections_, work);
    if (twicing_) {
      stopPoint();
      taken -= work;
      filterForwardBackward(sections_, taken);
      work += taken;
    }
    stopPoint();
    if (!denoise_) return;
    const Denoiser denoiser(part, rate_);
    denoiser.apply(work);
    const std::lock_guard lock(kept_);
    keptHz_ = std::max(keptHz_, denoiser.keptHz());
  }
  /// Weighted sums about the output instants [from, to) of a signal whose first row is row `row` of the grid.
  void addWeighted(const Channels& signal, const VectorXd& kernel, Eigen::Index row, Eigen::Index from, Eigen::Index to,
                   Channels& out) const {
    const Eigen::Index first = output_.first - row - kernel.size() / 2;
    const Eigen::Index channels = signal.cols();
    for (Eigen::Index k = from; k < to; ++k) {
      double* sum = &out(k, 0);
      const double* at = &signal(first + k * output_.stride, 0);
      for (Eigen::Index i = 0; i < kernel.size(); ++i, at += channels)
        for (Eigen::Index c = 0; c < channels; ++c) sum[c] += kernel(i) * at[c];
    }
  }

  SmoothingKind kind_ = SmoothingKind::lowPass;
  double rate_;
  double cutoff_ = 0.0, keptHz_ = 0.0;
  std::mutex kept_;  ///< Of keptHz_: run() may be called from two threads.
  bool twicing_ = false, denoise_ = false;
  Output output_;
  SavitzkyGolay savitzkyGolay_;
  std::vector<Biquad> sections_;
  std::array<VectorXd, 3> kernels_;     ///< Average over an output interval, and its derivatives
  Eigen::Index pad_ = 0, settles_ = 0;  ///< Rows beyond the recording's ends, and beyond a stretch's
};

/// Noise of each channel's samples, by their second differences, which smooth motion hardly reaches.
VectorXd sampleNoise(const Gridded& signal) {
  // A median would be zero for coarsely quantised channels that mostly repeat.
  VectorXd sum = VectorXd::Zero(signal.channels());
  for (Eigen::Index from = 0; from + 2 < signal.grid.size; from += kStretchRows) {
    stopPoint();
    const Channels part = signal.rows(from, std::min(signal.grid.size, from + kStretchRows + 2));
    for (Eigen::Index i = 2; i < part.rows(); ++i)
      sum += (part.row(i) - 2.0 * part.row(i - 1) + part.row(i - 2)).cwiseAbs2().transpose();
  }
  return (sum / std::max<double>(1.0, static_cast<double>(signal.grid.size - 2)) / 6.0).cwiseSqrt();
}

/// Derivatives of positions, helped by reported velocities where these are the less noisy source of acceleration and
/// agree in time. A lag of more than two milliseconds disqualifies them.
Derivatives withReportedVelocity(Smoother& smoother, const Gridded& positions, const Gridded& velocities,
                                 const std::string& what, Findings& findings) {
  Derivatives fromPositions, fromVelocities;
  parallelFor(velocities.values.rows() == 0 ? 1 : 2, [&](std::size_t i) {
    i == 0 ? fromPositions = smoother.run(positions, 2) : fromVelocities = smoother.run(velocities, 1);
  });
  if (velocities.values.rows() == 0) return fromPositions;
  const double energy = fromPositions.second.squaredNorm();
  const Channels excess = fromVelocities.value - fromPositions.first;
  const double lag = energy > 0.0 ? -excess.cwiseProduct(fromPositions.second).sum() / energy : 0.0;
  const double spread = energy > 0.0 ? std::sqrt(excess.squaredNorm() / energy) : 0.0;
  if (std::abs(lag) > 0.002 && std::abs(lag) > 0.5 * spread) {
    findings.push_back(
        {Severity::info,
         "velocity_lag",
         heft::say("The reported {} velocities lag the positions by {:.0f} ms; velocities and accelerations "
                   "are taken from the positions.",
                   what, lag * 1e3),
         {},
         {}});
    return fromPositions;
  }
  // In-band noise of the acceleration: positions are differentiated twice, velocities once.
  const double w = 2.0 * std::numbers::pi * (smoother.cutoffHz() > 0.0 ? smoother.cutoffHz() : 0.1 * smoother.rateHz());
  const double positionNoise = 0.6 * w * w * sampleNoise(positions).squaredNorm();
  const double velocityNoise = sampleNoise(velocities).squaredNorm();
  if (velocityNoise < positionNoise) {
    fromPositions.first = std::move(fromVelocities.value);
    fromPositions.second = std::move(fromVelocities.first);
  }
  return fromPositions;
}

void resizeMotion(Motion& motion, Eigen::Index size, bool payloadOnly = false) {
  for (auto* series : {&motion.specificForce, &motion.omega, &motion.alpha}) series->setZero(3, size);
  for (auto* series : {&motion.velocity, &motion.position}) series->setZero(3, payloadOnly ? 0 : size);
  motion.R_BS.resize(static_cast<std::size_t>(payloadOnly ? 0 : size));
}

void setSample(Motion& motion, Eigen::Index k, const FrameMotion& frame, const Vector3d& gravity) {
  const Matrix3d R = frame.X_BS.linear();
  motion.specificForce.col(k) = R.transpose() * (frame.a_BSo_B - gravity);
  motion.omega.col(k) = R.transpose() * frame.w_BS_B;
  motion.alpha.col(k) = R.transpose() * frame.alpha_BS_B;
  if (motion.R_BS.empty()) return;
  motion.R_BS[static_cast<std::size_t>(k)] = R;
  motion.velocity.col(k) = frame.v_BSo_B;
  motion.position.col(k) = frame.X_BS.translation();
}

Result<int> checkedJoints(const Recording& recording, const RobotModel* robot) {
  if (robot == nullptr)
    return Error{heft::say("The recording has joint angles, but no robot is named.") + " " + remedy(Remedy::nameRobot)};
  if (recording.q.cols() != robot->dof())
    return Error{heft::say("The recording has {} joints, the robot \"{}\" has {}.", recording.q.cols(), robot->name(),
                           robot->dof()) +
                 " " + remedy(Remedy::nameRobot)};
  return mountLink(recording.meta.mount, *robot);
}

Result<bool> fromJoints(const Recording& recording, const RobotModel* robot, Smoother& smoother,
                        const UniformGrid& grid, Motion& motion) {
  const auto link = checkedJoints(recording, robot);
  if (!link) return link.error();
  const Isometry3d X_LS = poseFromXyzRpy(recording.meta.mount.xyz, recording.meta.mount.rpy);
  const Derivatives d = withReportedVelocity(smoother, {grid, recording.time, recording.q},
                                             {grid, recording.time, recording.dq}, heft::say("joint"), motion.findings);
  if (!motion.R_BS.empty()) {
    motion.q = d.value.transpose();
    motion.dq = d.first.transpose();
    motion.ddq = d.second.transpose();
  }
  parallelFor(static_cast<std::size_t>((motion.size() + kRowsBetweenStops - 1) / kRowsBetweenStops),
              [&](std::size_t part) {
                const Eigen::Index from = static_cast<Eigen::Index>(part) * kRowsBetweenStops;
                VectorXd qk, dqk, ddqk;
                for (Eigen::Index k = from; k < std::min(motion.size(), from + kRowsBetweenStops); ++k) {
                  qk = d.value.row(k).transpose();
                  dqk = d.first.row(k).transpose();
                  ddqk = d.second.row(k).transpose();
                  setSample(motion, k, robot->frameMotion(*link, X_LS, qk, dqk, ddqk), recording.meta.gravity);
                }
              });
  return true;
}

void fromPoses(const Recording& recording, Smoother& smoother, const UniformGrid& grid, Motion& motion) {
  // Quaternion components are smooth functions of time once their sign is continuous.
  MatrixXd quaternion = recording.quaternion;
  for (Eigen::Index i = 1; i < quaternion.rows(); ++i)
    if (quaternion.row(i).dot(quaternion.row(i - 1)) < 0.0) quaternion.row(i) *= -1.0;
  const Derivatives rotation = smoother.run({grid, recording.time, quaternion}, 2);
  Derivatives translation;
  motion.originAccelerationKnown = recording.hasPosition();
  if (recording.hasPosition()) {
    translation = withReportedVelocity(smoother, {grid, recording.time, recording.position},
                                       {grid, recording.time, recording.twist.leftCols<3>()}, heft::say("linear"),
                                       motion.findings);
  }
  for (Eigen::Index k = 0; k < motion.size(); ++k) {
    if (k % kRowsBetweenStops == 0) stopPoint();
    FrameMotion frame;
    const double norm = rotation.value.row(k).norm();
    const auto component = [&](const Channels& c) {
      return Quaterniond(c(k, 3) / norm, c(k, 0) / norm, c(k, 1) / norm, c(k, 2) / norm);
    };
    const Quaterniond q = component(rotation.value);
    frame.X_BS.linear() = q.toRotationMatrix();
    // w_B = 2 vec(dq q*), alpha_B = 2 vec(ddq q*); the scalar parts belong to the norm and drop out.
    frame.w_BS_B = 2.0 * (component(rotation.first) * q.conjugate()).vec();
    frame.alpha_BS_B = 2.0 * (component(rotation.second) * q.conjugate()).vec();
    if (recording.hasPosition()) {
      frame.X_BS.translation() = translation.value.row(k).transpose();
      frame.v_BSo_B = translation.first.row(k).transpose();
      frame.a_BSo_B = translation.second.row(k).transpose();
    }
    setSample(motion, k, frame, recording.meta.gravity);
  }
}

/// Where the accelerometer stands in for the motion it is treated as the wrench is, where it is compared as the motion.
void askAccelerometer(const Recording& recording, Smoother& smoother, const UniformGrid& grid, Motion& motion) {
  const auto like = [&](const Eigen::Ref<const MatrixXd>& series) -> Eigen::Matrix3Xd {
    if (series.rows() == 0) return Eigen::Matrix3Xd(3, 0);
    const Gridded gridded{grid, recording.time, series};
    return (motion.originAccelerationKnown ? smoother.run(gridded, 0).value : smoother.wrench(gridded)).transpose();
  };
  hearAccelerometer(like(recording.accelerometer), like(recording.gyroscope), motion);
}

void sayAccelerationUnknown(Motion& motion) {
  motion.findings.push_back(
      {Severity::warning,
       "origin_acceleration_unknown",
       heft::say("The recording has the sensor's orientation but not its position, so the acceleration of its "
                 "origin is unknown and taken as zero."),
       heft::say("Record px, py, pz or the joint angles for trustworthy numbers."),
       {}});
}

/// Whoever forgets it would fit a payload to forces in the wrong axes.
void requireSensorAxes(const Recording& recording) {
  if (recording.wrenchNeedsPose)
    throw std::logic_error("a wrench that is not in sensor axes is used; see toSensorAxes()");
}

}  // namespace

void keepPayloadMotion(Motion& motion) {
  motion.R_BS = {};
  for (auto* series : {&motion.velocity, &motion.position}) series->resize(3, 0);
  for (auto* series : {&motion.q, &motion.dq, &motion.ddq}) series->resize(0, 0);
}

Result<RobotModel> robotFor(const RecordingMeta& meta, Findings& findings) {
  if (!meta.robot) return Error{heft::say("The recording names no robot.")};
  if (*meta.robot == "panda") return RobotModel::panda();
  return RobotModel::fromUrdfFile(*meta.robot, findings, meta.mount.parent);
}

Result<Motion> standingPoses(const Recording& recording, const RobotModel* robot) {
  requireSensorAxes(recording);
  Motion motion;
  motion.rateHz = 1.0;
  const Eigen::Index n = recording.rows();
  if (n < 1) return Error{heft::say("The recording has no rows.")};
  resizeMotion(motion, n);
  std::optional<int> link;
  if (!recording.hasOrientation()) {
    const auto found = checkedJoints(recording, robot);
    if (!found) return found.error();
    link = *found;
  }
  const Isometry3d X_LS = poseFromXyzRpy(recording.meta.mount.xyz, recording.meta.mount.rpy);
  for (Eigen::Index k = 0; k < n; ++k) {
    FrameMotion frame;
    if (link) {
      frame.X_BS = robot->linkPose(recording.q.row(k).transpose(), *link) * X_LS;
    } else {
      const auto q = recording.quaternion.row(k);
      frame.X_BS.linear() = Quaterniond(q(3), q(0), q(1), q(2)).normalized().toRotationMatrix();
      if (recording.hasPosition()) frame.X_BS.translation() = recording.position.row(k).transpose();
    }
    setSample(motion, k, frame, recording.meta.gravity);
  }
  motion.wrench = recording.wrench.transpose();
  if (recording.hasAccelerometer())
    hearAccelerometer(recording.accelerometer.transpose(), Eigen::Matrix3Xd(3, 0), motion);
  return motion;
}

Result<Motion> motionOf(const Recording& recording, const RobotModel* robot, const MotionOptions& options) {
  requireSensorAxes(recording);
  const bool savitzkyGolay = options.smoothing == SmoothingKind::savitzkyGolay;
  const int window = options.window + (options.window % 2 == 0 ? 1 : 0);
  if (savitzkyGolay && (options.order < 2 || window <= options.order))
    return Error{
        heft::say("Savitzky-Golay needs an order of at least 2 and a window above the order, not order {} and "
                  "window {}.",
                  options.order, options.window)};
  if (!savitzkyGolay && !(options.cutoffHz >= 0.0))
    return Error{heft::say("The low-pass cutoff cannot be {} Hz; give a frequency above zero.", options.cutoffHz)};
  const Eigen::Index needed = std::max<Eigen::Index>(10, savitzkyGolay ? window : 0);
  if (recording.rows() < needed)
    return Error{heft::say("The recording has {} rows; at least {} are needed to compute the motion.", recording.rows(),
                           needed)};
  const UniformGrid grid = gridFor(recording.time);
  if (grid.size > 20 * recording.rows() + 1000) {
    const Eigen::Index n = recording.rows();
    Eigen::Index before = 0;
    (recording.time.tail(n - 1) - recording.time.head(n - 1)).maxCoeff(&before);
    return Error{heft::say(
        "The time steps differ too much: {} rows span {:.1f} s but most are {:.2g} s apart. Cut the "
        "recording at its gaps; the longest is between row {} at {:.3f} s and the next at {:.3f} s.",
        n, recording.duration(), 1.0 / grid.rateHz, before + 1, recording.time(before), recording.time(before + 1))};
  }
  Smoother smoother(options, grid);
  Motion motion;
  motion.rateHz = grid.rateHz / smoother.output().stride;
  motion.startTime = grid.start + static_cast<double>(smoother.output().first) / grid.rateHz;
  resizeMotion(motion, smoother.output().size, options.payloadOnly);
  // Poses are what S really did; joints only imply it through a robot model that may not be the right one.
  if (recording.hasOrientation()) {
    fromPoses(recording, smoother, grid, motion);
  } else if (auto done = fromJoints(recording, robot, smoother, grid, motion); !done) {
    return done.error();
  }
  motion.keptHz = smoother.keptHz();
  if (recording.wrench.rows() > 0)  // noisierMotion() has none
    motion.wrench = smoother.wrench({grid, recording.time, recording.wrench}).transpose();
  else
    motion.wrench.setZero(6, motion.size());
  if (recording.hasAccelerometer()) askAccelerometer(recording, smoother, grid, motion);
  if (!motion.originAccelerationKnown) sayAccelerationUnknown(motion);
  return motion;
}

}  // namespace heft
