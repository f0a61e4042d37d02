#pragma once
// Files of named arrays of numbers (HDF5, MATLAB, NumPy): arrays of as many rows in one group are channels of one
// stream, timed by the array of times beside them.
#include <functional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/import/streams.h"

namespace heft {

/// A longer second dimension is no set of channels.
inline constexpr std::size_t kMostArrayChannels = 64;

/// An array with one row a sample and up to kMostArrayChannels numbers a row.
struct NumberArray {
  std::string path;   ///< "robot/q"
  std::string group;  ///< "robot"; empty for the root
  std::string name;   ///< "q"
  std::size_t rows = 0;
  std::size_t channels = 1;
  bool vector = true;                ///< One dimension: its field has no index.
  std::vector<std::string> columns;  ///< Names of the channels, where the file has some; else empty.
};

/// One channel of array `index`; empty if the file is damaged there.
using ChannelReader = std::function<std::vector<double>(std::size_t index, std::size_t channel)>;

/// Splits "robot/q" into group and name.
void placeArray(NumberArray& array, const std::string& path);

/// Adds streams, candidates for the time and findings to `set`. Without an array of times a group is left out and
/// told, unless `choice` states a rate.
Result<bool> addArrayStreams(const std::vector<NumberArray>& arrays, const ChannelReader& read,
                             const FieldFilter& filter, const TimeChoice& choice, const Progress& progress,
                             StreamSet& set);

/// The note that times were made from a rate that the user stated.
void noteRate(StreamSet& set, double rateHz);

}  // namespace heft
