#include "core/import/join.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/say.h"
#include "core/base/text.h"
#include "core/import/align.h"
#include "core/import/delay.h"
#include "core/import/witness.h"
#include "core/math/statistics.h"
#include "core/motion/motion.h"
#include "core/recording/checks.h"
#include "core/recording/plain_form.h"

namespace heft {

namespace {

constexpr double kNoDelay = 0.06;  ///< [s] A little to either side, so that the fit at none is seen.

class Joiner {
 public:
  Joiner(const std::vector<Stream>& streams, const std::vector<ColumnSource>& columns, const MappingWishes& wishes,
         Findings& findings)
      : joining_{streams, columns, wishes, findings, streams[columns[0].stream].file, {}} {
    for (const auto& column : columns)
      if (!ofWitness(column)) joining_.used.insert(column.stream);
  }

  std::optional<double> explained(RecordingMeta meta) {
    if (const auto failure = makeSignals(std::move(meta)); failure || unrelated_) return std::nullopt;
    const auto moved = specificForce();
    if (!moved) return std::nullopt;
    return findOffset(inWrenchAxes(*moved, recording_.meta.conventions), moved->startTime, moved->rateHz, wrench_.time,
                      wrench_.values.leftCols<3>(), -kNoDelay, kNoDelay)
        .explained;
  }

  Result<Recording> join(RecordingMeta meta) {
    if (auto failure = makeSignals(std::move(meta))) return *failure;
    if (wrench_.stream != motion().stream) recording_.meta.clockAlignmentStd.reset();  // It is found anew.
    if (auto failure = align()) return *failure;
    if (recording_.meta.kind == RecordingKind::motion) witness_.align(wrench_);
    if (auto failure = resample()) return *failure;
    for (const auto s : {wrench_.stream, motion().stream}) {
      if (!recording_.labels.empty()) break;
      takeLabels(s);
    }
    return std::move(recording_);
  }

 private:
  /// All signals on their own times, in the plain form.
  std::optional<Error> makeSignals(RecordingMeta meta) {
    recording_.file = joining_.file;
    recording_.meta = std::move(meta);
    if (auto failure = clocks_.checkOffsets()) return *failure;
    clocks_.choose();
    publishers_.choose();
    reader_.setAsideSparse();
    if (auto failure = clocks_.refuseRestarts()) return *failure;
    wrench_ = reader_.read({"fx", "fy", "fz", "tx", "ty", "tz"});
    joints_ = reader_.read(joining_.numbered("q"));
    velocities_ = reader_.read(joining_.numbered("dq"));
    quaternion_ = reader_.read({"qx", "qy", "qz", "qw"});
    for (const auto& form : rotationForms())
      if (quaternion_.empty())
        quaternion_ = quaternionsOf(reader_.read(form), form, recording_.meta.conventions.quaternionOrder);
    position_ = reader_.read({"px", "py", "pz"});
    witness_.read(reader_, clocks_, wrench_.stream);
    for (const auto* signal : {&wrench_, &joints_, &velocities_, &quaternion_, &position_})
      if (!signal->empty() && signal->nanoseconds.size() < 2)
        return errorAt({joining_.streams[signal->stream].file, 0, 0},
                       heft::say("{} has fewer than two complete samples.", joining_.nameOf(signal->stream)),
                       heft::say("Record again, or choose other columns."));
    makeTimes();
    if (auto failure = toPlainForm()) return *failure;
    makeQuaternionsSmooth();
    return std::nullopt;
  }

  Signal& motion() { return joints_.empty() ? quaternion_ : joints_; }

  void makeTimes() {
    // Times that count from 1970 begin at the motion's first sample; others stay as they are, so that marks fit.
    unrelated_ = !joining_.sameFile() && !clocksRelated();
    const auto origin = [](const Signal& signal) {
      const auto first = signal.nanoseconds.front();
      return 1e-9 * static_cast<double>(first) > kEpoch ? first : 0;
    };
    const auto common = origin(motion());
    motionZero_ = common;
    wrenchZero_ = unrelated_ ? origin(wrench_) : common;
    if (unrelated_) witness_.forget(heft::say("the files' clocks have nothing in common"));
    for (auto* signal : {&wrench_, &joints_, &velocities_, &quaternion_, &position_, &witness_.accelerometer(),
                         &witness_.gyroscope()}) {
      if (signal->empty()) continue;
      const auto zero = unrelated_ ? origin(*signal) : common;
      const auto size = static_cast<Eigen::Index>(signal->nanoseconds.size());
      signal->time.resize(size);
      std::vector<double> steps;
      for (Eigen::Index k = 0; k < size; ++k) {
        signal->time(k) = 1e-9 * static_cast<double>(signal->nanoseconds[static_cast<std::size_t>(k)] - zero);
        if (k > 0) steps.push_back(signal->time(k) - signal->time(k - 1));
      }
      signal->step = median(std::move(steps));
    }
  }

  /// Of each signal by itself; the position has to wait for the orientation at its times.
  std::optional<Error> toPlainForm() {
    plain_.emplace(recording_.meta);
    if (!wrench_.empty()) plain_->undoWrench(wrench_.values);
    plain_->undoAngles(joints_.values);
    plain_->undoAngles(velocities_.values);
    plain_->undoAcceleration(witness_.accelerometer().values);
    plain_->undoAngles(witness_.gyroscope().values);
    if (!quaternion_.empty()) plain_->undoQuaternionOrder(quaternion_.values);
    if (!quaternion_.empty()) plain_->undoDirection(quaternion_.values);
    if (joints_.empty()) return std::nullopt;
    Recording angles;
    angles.meta = recording_.meta;
    angles.time = joints_.time;
    angles.q = std::move(joints_.values);
    ColumnMap map;
    map.joints.assign(static_cast<std::size_t>(angles.q.cols()), 1);
    std::vector<std::uint32_t> lines(static_cast<std::size_t>(angles.q.rows()), 0);
    if (auto failure = checkAngles({angles, map, joining_.file, lines, joining_.findings, false})) return failure;
    joints_.values = std::move(angles.q);
    return std::nullopt;
  }

  /// Two files share a clock if both count from 1970 and overlap.
  bool clocksRelated() {
    const auto& a = motion().nanoseconds;
    const auto& b = wrench_.nanoseconds;
    if (recording_.meta.kind == RecordingKind::poses && a == b) return true;  // row by row
    if (clocks_.offsetStated(motion().stream) || clocks_.offsetStated(wrench_.stream)) return true;
    const double shorter = 1e-9 * static_cast<double>(std::min(a.back() - a.front(), b.back() - b.front()));
    const double overlap = 1e-9 * static_cast<double>(std::min(a.back(), b.back()) - std::max(a.front(), b.front()));
    return 1e-9 * static_cast<double>(a.front()) > kEpoch && 1e-9 * static_cast<double>(b.front()) > kEpoch &&
           overlap > 0.2 * shorter;
  }

  /// q and -q are one rotation; neighbours get the same sign before anything is averaged.
  void makeQuaternionsSmooth() {
    auto& values = quaternion_.values;
    for (Eigen::Index k = 1; k < values.rows(); ++k)
      if (values.row(k).dot(values.row(k - 1)) < 0.0) values.row(k) = -values.row(k);
  }

  std::optional<Motion> specificForce() const {
    return specificForceOf(joints_, quaternion_, recording_.meta, joining_.file);
  }

  std::optional<Error> align() {
    if (wrench_.stream == motion().stream) return std::nullopt;
    const auto moved = recording_.meta.kind == RecordingKind::motion ? specificForce() : std::nullopt;
    if (!unrelated_) {
      if (moved) tellDelay(*moved, recording_.meta.conventions, motion(), wrench_, joining_);
      return std::nullopt;
    }
    if (recording_.meta.kind == RecordingKind::poses)
      return errorAt({joining_.file, 0, 0},
                     heft::say("{} has {} poses and {} has {} wrenches, without times in common.",
                               joining_.nameOf(motion().stream), motion().nanoseconds.size(),
                               joining_.nameOf(wrench_.stream), wrench_.nanoseconds.size()),
                     heft::say("Standing poses in two files are joined row by row: write as many rows in both."));
    // What would have to be stated to get the same counts between the clocks as the files have them.
    const double zeros = 1e-9 * (static_cast<double>(motionZero_) - static_cast<double>(wrenchZero_));
    const auto offset = findClockOffset(moved, recording_.meta.conventions, motion(), wrench_, zeros, joining_);
    if (!offset) return offset.error();
    wrench_.time.array() += offset->seconds;
    wrenchShift_ = offset->seconds;
    recording_.meta.clockAlignmentStd = offset->std;
    return std::nullopt;
  }

  /// Both signals at the times of the slower one.
  std::optional<Error> resample() {
    Signal& moving = motion();
    const bool together = wrench_.stream == moving.stream && wrench_.nanoseconds == moving.nanoseconds;
    const bool wrenchSlower = wrench_.step > 1.01 * moving.step;
    const Signal& base = wrenchSlower ? wrench_ : moving;
    double overlapFrom = std::max(wrench_.time(0), moving.time(0));
    double overlapTo = std::min(wrench_.time(wrench_.time.size() - 1), moving.time(moving.time.size() - 1));
    if (joints_.empty() && position_.empty()) witness_.limit(overlapFrom, overlapTo);
    std::vector<double> times;
    std::size_t inGaps = 0;
    for (const double t : base.time) {
      if (t < overlapFrom || t > overlapTo) continue;
      if (nearSamples(wrench_, t, base.step) && nearSamples(moving, t, base.step))
        times.push_back(t);
      else
        ++inGaps;
    }
    if (times.size() < 2)
      return errorAt(
          {joining_.file, 0, 0},
          heft::say("{} and {} do not overlap in time: {:.3f} to {:.3f} s and {:.3f} to {:.3f} s.",
                    joining_.nameOf(moving.stream), joining_.nameOf(wrench_.stream), moving.time(0),
                    moving.time(moving.time.size() - 1), wrench_.time(0), wrench_.time(wrench_.time.size() - 1)),
          heft::say("Were they recorded together, or is one clock late?") + " " +
              joining_.howToShift(wrench_.stream, 0.0));
    const VectorXd at = Eigen::Map<const VectorXd>(times.data(), static_cast<Eigen::Index>(times.size()));
    const auto on = [&](const Signal& signal) -> MatrixXd {
      if (signal.empty()) return {};
      if (signal.time.size() == at.size() && signal.time == at) return signal.values;
      return averageAt(signal.time, signal.values, clamped(at, signal),
                       signal.step < 0.67 * base.step ? base.step : 0.0);
    };
    recording_.time = at;
    recording_.wrench = on(wrench_);
    recording_.q = on(joints_);
    recording_.dq = on(velocities_);
    if (!quaternion_.empty()) recording_.quaternion = on(quaternion_);
    witness_.take(at, base.step, recording_);
    if (!position_.empty() && !quaternion_.empty()) {
      MatrixXd unit = recording_.quaternion;
      unit.rowwise().normalize();
      recording_.position = on(position_);
      plain_->undoPosition(recording_.position, unit);
    }
    if (joining_.wishes.poseOfFlange && !quaternion_.empty()) fromFlangeToSensor();

    if (!together && recording_.meta.kind == RecordingKind::poses) {
      joining_.note(Severity::info, "streams_joined",
                    heft::say("{} and {} were joined row by row.", joining_.nameOf(moving.stream),
                              joining_.nameOf(wrench_.stream)));
    } else if (!together) {
      const Signal& other = wrenchSlower ? moving : wrench_;
      joining_.note(Severity::info, "streams_joined",
                    heft::say("{} ({:.4g} Hz) and {} ({:.4g} Hz) were joined on the times of {}; {}.",
                              joining_.nameOf(moving.stream), 1.0 / moving.step, joining_.nameOf(wrench_.stream),
                              1.0 / wrench_.step, joining_.nameOf(base.stream),
                              other.step < 0.67 * base.step ? heft::say("the faster one is averaged over each step")
                                                            : heft::say("the other one is interpolated")));
    }
    if (inGaps > 0)
      joining_.note(Severity::warning, "stream_gaps",
                    heft::say("At {} of {} times one of the streams has a gap; these were left out.", inGaps,
                              inGaps + times.size()));
    if (moving.step > 0.0201 && moving.step > 2.0 * wrench_.step)
      joining_.note(
          Severity::warning, "motion_rate_low",
          heft::say("The motion comes at {:.3g} Hz only; inertia needs about 100 Hz or more.", 1.0 / moving.step),
          heft::say("Panda's ROS driver publishes at 30 Hz by default: raise its publish rate to 1000 Hz."));
    return std::nullopt;
  }

  /// What the user labelled in the file of stream `like`, on the recording's times.
  void takeLabels(std::size_t like) {
    const bool withWrench = like == wrench_.stream;
    for (std::size_t s = 0; s < joining_.streams.size(); ++s) {
      const Stream& stream = joining_.streams[s];
      const auto field = std::find(stream.fields.begin(), stream.fields.end(), kLabelField);
      if (stream.file != joining_.streams[like].file || field == stream.fields.end()) continue;
      const auto& values = stream.values[static_cast<std::size_t>(field - stream.fields.begin())];
      const std::int64_t zero = (withWrench ? wrenchZero_ : motionZero_) - clocks_.offsetOf(s) - clocks_.shiftOf(like);
      std::vector<std::pair<double, double>> labelled;
      for (std::size_t k = 0; k < std::min(values.size(), stream.received.size()); ++k)
        labelled.emplace_back(1e-9 * (static_cast<double>(stream.received[k]) - static_cast<double>(zero)) +
                                  (withWrench ? wrenchShift_ : 0.0),
                              values[k]);
      std::sort(labelled.begin(), labelled.end());
      if (labelled.empty()) continue;
      const double step = std::max(wrench_.step, motion().step);
      std::vector<std::optional<MarkLabel>> labels;
      for (const double t : recording_.time) {
        auto next = std::lower_bound(labelled.begin(), labelled.end(), std::pair(t, -2.0));
        if (next == labelled.end() || (next != labelled.begin() && t - (next - 1)->first < next->first - t)) --next;
        const bool known = next->second >= 0.0 && std::abs(next->first - t) <= step;
        labels.push_back(known ? std::optional(static_cast<MarkLabel>(std::lround(next->second))) : std::nullopt);
      }
      recording_.labels = std::move(labels);
      return;
    }
  }

  /// X_BS = X_BF X_FS for poses of the flange.
  void fromFlangeToSensor() {
    const Isometry3d X_FS = poseFromXyzRpy(recording_.meta.mount.xyz, recording_.meta.mount.rpy);
    for (Eigen::Index k = 0; k < recording_.quaternion.rows(); ++k) {
      Quaterniond q(recording_.quaternion(k, 3), recording_.quaternion(k, 0), recording_.quaternion(k, 1),
                    recording_.quaternion(k, 2));
      q.normalize();
      if (recording_.position.rows() > 0) recording_.position.row(k) += (q * X_FS.translation()).transpose();
      const Quaterniond turned = q * Quaterniond(X_FS.linear());
      recording_.quaternion.row(k) = turned.coeffs().transpose();
    }
    joining_.note(Severity::info, "pose_of_flange",
                  heft::say("The poses are those of the flange; the sensor's poses are derived from its mount."));
  }

  Joining joining_;
  Publishers publishers_{joining_};
  Clocks clocks_{joining_};
  SignalReader reader_{joining_, publishers_, clocks_};
  Witness witness_{joining_};
  std::optional<PlainForm> plain_;
  bool unrelated_ = false;
  std::int64_t motionZero_ = 0, wrenchZero_ = 0;  ///< [ns] What time 0 is in each of the two files.
  double wrenchShift_ = 0.0;                      ///< [s] added to the wrench's times
  Signal wrench_, joints_, velocities_, quaternion_, position_;
  Recording recording_;
};

}  // namespace

std::optional<double> explainedByMotion(const std::vector<Stream>& streams, const std::vector<ColumnSource>& columns,
                                        const MappingWishes& wishes, RecordingMeta meta) {
  Findings aside;
  return Joiner(streams, columns, wishes, aside).explained(std::move(meta));
}

Result<Recording> joinStreams(const std::vector<Stream>& streams, const std::vector<ColumnSource>& columns,
                              const MappingWishes& wishes, RecordingMeta meta, Findings& findings) {
  return Joiner(streams, columns, wishes, findings).join(std::move(meta));
}

}  // namespace heft
