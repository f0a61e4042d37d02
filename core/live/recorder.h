#pragma once
// Writes complete samples to disk as they arrive, in contract form.
#include <filesystem>
#include <string>

#include "core/base/result.h"
#include "core/live/source.h"
#include "core/recording/recording.h"

namespace heft {

/// A CSV whose rows are handed to the system every fifth of a second and to the disk every second: a killed program
/// loses at most that, and what is there ends with a whole row. The meta file is written first.
/// Not safe to use from several threads at once.
class Recorder {
 public:
  /// Fails if a file exists (nothing is ever overwritten) or cannot be made. `meta.wrenchSign` says which sign the
  /// samples' wrench has.
  static Result<Recorder> create(const std::filesystem::path& csv, const RecordingMeta& meta);

  Recorder(Recorder&& other) noexcept;
  Recorder& operator=(Recorder&& other) noexcept;
  ~Recorder();  ///< Writes what is left.

  /// The first sample decides which columns there are. False once the disk is full or gone; problem() says so.
  bool add(const LiveSample& sample);
  bool flush();

  std::uint64_t rows() const { return rows_; }
  const std::string& problem() const { return problem_; }
  const std::filesystem::path& file() const { return file_; }

 private:
  Recorder() = default;
  void begin(const LiveSample& first);
  void number(double value);

  std::filesystem::path file_;
  int descriptor_ = -1;
  std::string pending_;
  std::string problem_;
  std::uint64_t rows_ = 0;
  double origin_ = 0.0;
  double handed_ = 0.0;
  double synced_ = 0.0;
  int joints_ = 0;
  bool q_ = false, dq_ = false, orientation_ = false, position_ = false;
};

}  // namespace heft
