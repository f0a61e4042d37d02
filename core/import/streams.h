#pragma once
// What every kind of recording is brought to before it is joined: streams of numbers, each with its own times.
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/findings.h"
#include "core/base/progress.h"
#include "core/base/result.h"

namespace heft {

/// Kinds of files, told by their content.
enum class FileKind { contractCsv, table, jsonLines, rosBag, mcap, sqliteBag, ros2Folder, hdf5, matlab, numpy };

/// "ROS 1 bag", "table (CSV)" and so on.
std::string_view toString(FileKind kind);

/// A topic, or columns of a table that share their rows.
struct Stream {
  std::string name;                 ///< Topic; for tables what the columns' names begin with, possibly nothing.
  std::string type;                 ///< "geometry_msgs/WrenchStamped"; empty for tables.
  std::string file;                 ///< Where it stands, as in messages.
  std::size_t samples = 0;          ///< In the file.
  std::int64_t first = 0;           ///< Received [ns], on the recorder's clock.
  std::int64_t last = 0;            ///< Received [ns].
  std::vector<std::string> fields;  ///< "wrench.force.x"; a table's columns as they are called there.
  bool clockless = false;           ///< Nothing tells its times: they are the numbers of the rows.

  // Filled for selected fields only:
  std::vector<std::int64_t> received;       ///< [ns] One a sample; for tables the column of time.
  std::vector<std::int64_t> stamps;         ///< [ns] Of the messages' own headers; 0 where there is none.
  std::vector<std::vector<double>> values;  ///< By field; empty for a field that was not selected. NaN: missing.
  /// Who sent each sample, an index into `senders`: messages of one topic that come over different connections or hold
  /// other fields. Empty where all are alike.
  std::vector<std::uint16_t> sender;
  std::vector<std::string> senders;  ///< In words: "/gripper_driver", or the fields that its messages hold.

  double duration() const { return 1e-9 * static_cast<double>(last - first); }
  /// Mean rate [Hz]; 0 if it cannot be told.
  double rateHz() const { return samples > 1 && last > first ? static_cast<double>(samples - 1) / duration() : 0.0; }
};

/// A table's column of labels comes as a field of this name, holding MarkLabel's numbers or kNoLabel.
inline constexpr std::string_view kLabelField = "label";
inline constexpr double kNoLabel = -1.0;

struct StreamSet {
  std::string file;
  FileKind kind = FileKind::table;
  std::vector<Stream> streams;
  std::vector<std::string> timeCandidates;  ///< Columns or datasets that may be chosen as the time; empty for messages.
  Findings findings;                        ///< With an error among them the streams are good for a list only.
};

/// Which fields to read: called with a stream (name, type, fields known) and a field's index. An empty function lists
/// only: messages beyond the first of each topic are counted, not decoded.
using FieldFilter = std::function<bool(const Stream&, std::size_t field)>;

/// More numbers than these are not held in memory.
inline constexpr std::size_t kMaxStreamNumbers = 200'000'000;

/// Which column of a table is the time, where the user says so.
struct TimeChoice {
  std::string column;       ///< Empty: found by its name.
  double unit = 0.0;        ///< [s]; 0: by the name and the size of the numbers.
  double rateHz = 0.0;      ///< Above 0: rows are this far apart, whatever the file says; for files without a clock.
  bool clockNeeded = true;  ///< False for standing poses, whose rows are only counted.
};

/// Tells the kind from the first bytes; fails for what is no recording at all (a device, an empty file, an archive).
Result<FileKind> recognise(const std::filesystem::path& path);

/// Reads any kind but contractCsv, which is a table here.
Result<StreamSet> readStreams(const std::filesystem::path& path, FileKind kind, const FieldFilter& filter,
                              const TimeChoice& time, const Progress& progress);

// The readers behind it.
Result<StreamSet> readMessageStreams(const std::filesystem::path& path, FileKind kind, const FieldFilter& filter,
                                     const Progress& progress);
Result<StreamSet> readTableStreams(const std::filesystem::path& path, const TimeChoice& time, const Progress& progress);
Result<StreamSet> readJsonLines(const std::filesystem::path& path, const TimeChoice& time, const Progress& progress);
/// In a process of its own (own_process.h): damaged files take version 1.10 of the library out of its memory, and it is
/// not made for several threads.
Result<StreamSet> readHdf5Streams(const std::filesystem::path& path, const FieldFilter& filter, const TimeChoice& time,
                                  const Progress& progress);
/// What that process does; a fuzzer does it in its own.
Result<StreamSet> readHdf5StreamsHere(const std::filesystem::path& path, const FieldFilter& filter,
                                      const TimeChoice& time, const Progress& progress);
/// MATLAB's files of versions 4 to 7 (7.3 is HDF5).
Result<StreamSet> readMatlabStreams(const std::filesystem::path& path, const FieldFilter& filter,
                                    const TimeChoice& time, const Progress& progress);
/// NumPy's .npy and .npz.
Result<StreamSet> readNumpyStreams(const std::filesystem::path& path, const FieldFilter& filter, const TimeChoice& time,
                                   const Progress& progress);

/// [ns] Every stamp is smaller than this (73 years, until 2043 where it counts from 1970), so that sums and differences
/// of a few of them stay within 64 bits. What enters from a file or a wire goes through one of the next three.
inline constexpr std::int64_t kLargestStamp = std::int64_t{1} << 61;
constexpr bool isSoundStamp(std::int64_t stamp) { return stamp > -kLargestStamp && stamp < kLargestStamp; }
/// The stamp, or 0 (not stamped) for one that is no time.
std::int64_t soundStamp(std::int64_t stamp);
/// Seconds as nanoseconds; what is no time (NaN, beyond kLargestStamp) becomes 0.
std::int64_t nanoseconds(double seconds);

}  // namespace heft
