#pragma once
// Writes complete samples to disk as they arrive, in contract form.
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/live/growing_file.h"
#include "core/live/source.h"
#include "core/recording/recording.h"

namespace heft {

/// A CSV whose rows are handed to the system every fifth of a second and to the disk every second, by a thread of its
/// own: a killed program loses at most that, and what is there ends with a whole row. The setup file is there before
/// the first row and no sooner, so that a program killed before it leaves nothing in the way. Without any row neither
/// file stays. Not safe to use from several threads at once.
class Recorder {
 public:
  /// Fails if a file exists (nothing is ever overwritten; but see GrowingFile, and a setup file that says the same will
  /// do) or cannot be made; of two programs that try at once one succeeds, and the other leaves no trace.
  /// `meta.wrenchSign` and `meta.conventions` say what the samples' numbers mean; they are written as they come.
  static Result<Recorder> create(const std::filesystem::path& csv, const RecordingMeta& meta);

  Recorder(Recorder&& other) noexcept = default;
  ~Recorder();  ///< Writes what is left.

  /// The samples of the first fifth of a second decide which columns there are; those of an inertial sensor that begins
  /// later are added behind them, empty in the rows before. False once the disk is full or gone;
  /// problem() says so.
  bool add(const LiveSample& sample);
  /// Waits until the disk has every row. False as above.
  bool flush();

  std::uint64_t rows() const { return rows_ + first_.size(); }
  std::string problem() const { return disk_->problem(); }
  const std::filesystem::path& file() const { return file_; }

 private:
  Recorder() = default;
  /// Writes the header, and the samples that waited for it.
  void begin();
  void write(const LiveSample& sample);
  /// Whether it brings readings of an inertial sensor that there are no columns for yet; there are then.
  bool noteInertial(const LiveSample& sample);
  bool handOver();
  void number(double value);

  std::filesystem::path file_;
  std::unique_ptr<GrowingFile> disk_;  ///< Null where moved from
  std::vector<LiveSample> first_;      ///< They wait until it is known which columns there are.
  std::string pending_;
  bool failed_ = false;
  std::uint64_t rows_ = 0;
  double origin_ = 0.0;
  double handed_ = 0.0;
  int joints_ = 0;
  bool q_ = false, dq_ = false, orientation_ = false, position_ = false;
  std::vector<bool> inertial_;  ///< Columns of an inertial sensor in their order: false accelerations, true rates
  bool begun_ = false;
};

}  // namespace heft
