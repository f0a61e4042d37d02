#pragma once
// When something was measured, on the host's clock.
#include <cstdint>
#include <limits>

namespace heft {

/// Times of packets that a device sends at a steady rate, from their numbers and arrivals: a second-order loop follows
/// the arrivals slowly, so that the network's jitter goes and the device's rate stays.
class SequenceClock {
 public:
  /// `sequence`: the packet's number, counted on over wraps. `arrival` [s].
  double timeOf(std::int64_t sequence, double arrival);

 private:
  bool started_ = false;
  std::int64_t sequence_ = 0;
  std::int64_t seen_ = 0;
  double time_ = 0.0;
  double period_ = 0.0;
};

/// Times of messages that carry stamps of another machine: the stamp plus the least delay seen. The first messages only
/// teach the delay, so that the clock does not jump later.
class StampClock {
 public:
  /// NaN while it learns.
  double timeOf(double stamp, double arrival);

 private:
  static constexpr int kLessons = 10;
  int seen_ = 0;
  double delay_ = std::numeric_limits<double>::infinity();
};

}  // namespace heft
