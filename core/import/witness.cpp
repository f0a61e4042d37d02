#include "core/import/witness.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/say.h"
#include "core/import/align.h"

namespace heft {

bool ofWitness(const ColumnSource& column) { return column.column[0] == 'a' || column.column[0] == 'i'; }

void Witness::read(SignalReader& reader, Clocks& clocks, std::size_t wrench) {
  const auto first = std::find_if(joining_.columns.begin(), joining_.columns.end(), ofWitness);
  if (first == joining_.columns.end()) return;
  const auto s = first->stream;
  const auto& stream = joining_.streams[s];
  if (!joining_.used.contains(s)) {
    const bool stamps = clocks.usesStamps(wrench);
    const bool foreign =
        std::ranges::none_of(joining_.used, [&](auto other) { return joining_.streams[other].file == stream.file; });
    const bool epoch = !stream.received.empty() && 1e-9 * static_cast<double>(stream.received[0]) > kEpoch;
    if (clocks.anyShift() || (foreign && !epoch && !clocks.offsetStated(s)) || !clocks.admit(s, stamps))
      return forget(heft::say("it is on another clock"));
    if (clocks.restartsAt(s, clocks.timesOf(s))) return forget(heft::say("its times restart in the middle"));
  }
  accelerometer_ = reader.read({"ax", "ay", "az"});
  gyroscope_ = reader.read({"imu_wx", "imu_wy", "imu_wz"});
  if (gyroscope_.nanoseconds != accelerometer_.nanoseconds) gyroscope_ = {};
  if (accelerometer_.nanoseconds.size() < 2) forget(heft::say("it has too few samples"));
}

void Witness::forget(const std::string& why) {
  if (std::none_of(joining_.columns.begin(), joining_.columns.end(), ofWitness)) return;
  accelerometer_ = gyroscope_ = {};
  std::erase_if(joining_.columns, ofWitness);
  joining_.note(Severity::info, "accelerometer_unused", heft::say("The accelerometer was not used: {}.", why));
}

void Witness::align(const Signal& wrench) {
  if (accelerometer_.empty() || accelerometer_.stream == wrench.stream) return;
  const double delay =
      accelerometerDelay(accelerometer_.time, accelerometer_.values, wrench.time, wrench.values.leftCols<3>());
  if (delay == 0.0) return;
  accelerometer_.time.array() += delay;
  if (!gyroscope_.empty()) gyroscope_.time.array() += delay;
  joining_.note(
      Severity::info, "accelerometer_shifted",
      heft::say("The accelerometer's times were shifted by {:.4f} s, where it matches the force best.", delay));
}

void Witness::limit(double& from, double& to) const {
  if (accelerometer_.empty()) return;
  const double begin = std::max(from, accelerometer_.time(0));
  const double end = std::min(to, accelerometer_.time(accelerometer_.time.size() - 1));
  const double kept = (end - begin) / (to - from);
  if (kept < 1.0 - mostWithoutAccelerometer(false) || kept >= 1.0) return;
  joining_.note(
      Severity::info, "accelerometer_span",
      heft::say("The recording is read from {:.3f} to {:.3f} s, where the accelerometer was there.", begin, end));
  from = begin;
  to = end;
}

void Witness::take(const VectorXd& at, double step, Recording& recording) {
  if (accelerometer_.empty()) return;
  const auto there = std::count_if(at.begin(), at.end(), [&](double t) {
    return t >= accelerometer_.time(0) - step && nearSamples(accelerometer_, t, step);
  });
  if (static_cast<double>(there) < (1.0 - kMissingShare) * static_cast<double>(at.size()))
    return forget(heft::say("it was there for {} of {} samples only", there, at.size()));
  const double width = accelerometer_.step < 0.67 * step ? step : 0.0;
  const auto on = [&](const Signal& signal) -> MatrixXd {
    if (signal.empty()) return MatrixXd(0, 3);
    return averageAt(signal.time, signal.values, clamped(at, signal), width);
  };
  recording.accelerometer = on(accelerometer_);
  recording.gyroscope = on(gyroscope_);
}

}  // namespace heft
