#pragma once
// Motion of one source and wrench of another become complete samples, on the times of the slower one.
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "core/live/source.h"
#include "core/recording/unwrap.h"

namespace heft {

/// As joinStreams() does for recordings: the slower of motion and wrench gives the times, the faster one is averaged
/// over its steps. Which is slower is seen from the samples themselves. Samples that have both pass through. An
/// inertial sensor that sends by itself is averaged over the steps of what is complete; nothing waits for one that is
/// silent. Not safe to use from several threads at once.
class StreamMerger {
 public:
  /// Takes a part in and appends the samples that have become complete, their times rising.
  void add(const LiveSample& part, std::vector<LiveSample>& complete);

  /// By how much joint angles jump where they wrap: 2 pi, or 360 for samples in degrees. Turns are taken out before
  /// anything is interpolated.
  void setTurn(double turn) { angles_.fill(Unwrapper(turn)); }
  /// Joints that wrapped so far, from 0.
  std::vector<int> wrapped() const;

  std::uint64_t late() const { return late_; }            ///< Came after their time had passed, or twice.
  std::uint64_t unmatched() const { return unmatched_; }  ///< Found no partner within two seconds, or across a gap.

 private:
  struct Lane {
    std::deque<LiveSample> samples;
    double step = 0.0;  ///< [s] Running mean.
    int seen = 0;
    double last = 0.0;
  };
  bool take(Lane& lane, const LiveSample& part);
  void emitReady();
  std::optional<LiveSample> matched(const LiveSample& base, const Lane& other, double width, bool wrenchBase) const;
  /// Gives the `waiting_` samples what the inertial sensor read, as far as it has come.
  void release(std::vector<LiveSample>& complete);

  LiveSample unwrapped(const LiveSample& part);

  Lane motion_, wrench_, inertial_;
  std::deque<LiveSample> waiting_;  ///< Motion and wrench are there, the inertial sensor's part may still come.
  double released_ = -1e300;        ///< [s] Time of the newest sample that was passed on.
  std::array<Unwrapper, 7> angles_;
  double anglesAt_ = 0.0;  ///< [s] Of the newest joint angles
  double emitted_ = -1e300;
  std::uint64_t late_ = 0;
  std::uint64_t unmatched_ = 0;
};

}  // namespace heft
