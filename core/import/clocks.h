#pragma once
// Which clock each stream is on: stamps of the messages or the recorder's times, and what is added to them.
#include <optional>

#include "core/base/result.h"
#include "core/import/joining.h"

namespace heft {

inline constexpr double kEpoch = 1e9;  ///< [s] Later times count from 1970, earlier ones from some start.

class Clocks {
 public:
  explicit Clocks(Joining& joining) : joining_(joining) {}

  /// Stamps of the messages' headers are when something was measured; the recorder's times come after the network.
  void choose();
  /// An offset that is stated for something that is not there was misspelt.
  std::optional<Error> checkOffsets() const;
  /// Times of a used stream that go back over what was there: two recordings in one, or two clocks on one topic.
  std::optional<Error> refuseRestarts();
  /// The first sample whose time falls by more than half a second back into times that were there: a few samples that
  /// came late do not count, nor do samples that are there twice. Nothing if the order is sound.
  std::optional<std::size_t> restartsAt(std::size_t s, const std::vector<std::int64_t>& times) const;

  /// [ns] Of row k of a stream, with what is added to its clock.
  std::int64_t time(std::size_t s, std::size_t k) const { return timesOf(s)[k] + clockShift_[s] + offsetOf(s); }
  const std::vector<std::int64_t>& timesOf(std::size_t s) const {
    return useStamps_[s] ? joining_.streams[s].stamps : joining_.streams[s].received;
  }
  /// [ns] What the user says is to be added.
  std::int64_t offsetOf(std::size_t s) const;
  bool offsetStated(std::size_t s) const { return statedOffset(s).has_value(); }
  /// [ns] What was found to be added, because its stamps are on another clock.
  std::int64_t shiftOf(std::size_t s) const { return clockShift_[s]; }
  bool anyShift() const;
  bool usesStamps(std::size_t s) const { return useStamps_[s]; }
  /// A further stream on the same clock as the others; false where its messages are not stamped as theirs are.
  bool admit(std::size_t s, bool stamps);

 private:
  static bool isStamped(const Stream& stream);
  std::optional<double> statedOffset(std::size_t s) const;  ///< [s]

  Joining& joining_;
  std::vector<std::int64_t> clockShift_;  ///< [ns]
  std::vector<bool> useStamps_;
};

}  // namespace heft
