#pragma once
// Net F/T Raw Data Transfer as functions of bytes: UDP, big-endian. Request: 0x1234, command, count; record: three
// numbers of 32 bits (sequence of the transfer, sequence of the sensor, status), then six counts of 32 bits with sign.
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/live/source.h"
#include "core/recording/clock.h"

namespace heft::rdt {

enum Command : unsigned char { kStop = 0, kRealTime = 2 };
std::string request(Command command);

struct Units {
  double countsPerNewton = 0.0, countsPerNewtonMetre = 0.0;
  bool known() const { return countsPerNewton > 0.0; }
};
/// Of the sensor's configuration, netftapi2.xml.
Result<Units> unitsIn(std::string_view page);

/// What a datagram adds to the counts of SourceStatus.
struct Counts {
  std::uint64_t lost = 0, late = 0, reordered = 0, malformed = 0, flagged = 0;  ///< late: were counted as lost before
};

/// Records in the order of the transfer.
class RecordReader {
 public:
  /// The samples of a datagram that came at `now` [s].
  std::vector<LiveSample> read(std::string_view datagram, const Units& units, double now, Counts& counts);
  /// The next record may have any number.
  void restart() { started_ = false; }

 private:
  /// Whether the record of this number is newer than those before.
  bool follows(std::uint32_t number, Counts& counts);

  SequenceClock clock_;
  bool started_ = false;
  std::uint32_t number_ = 0;
  std::set<std::uint32_t> missing_;  ///< Counted as lost
  std::int64_t sequence_ = 0;
  int old_ = 0;
};

}  // namespace heft::rdt
