#pragma once
// Samples of a long run, kept on disk until its end.
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/input_file.h"
#include "core/live/source.h"

namespace heft {

/// Keeps samples in a temporary file without a name, which goes with the program however that ends: an hour at 1 kHz
/// has some 700 MB. What the disk does not take stays in memory.
class SampleSpool {
 public:
  SampleSpool();
  ~SampleSpool();
  SampleSpool(const SampleSpool&) = delete;
  SampleSpool& operator=(const SampleSpool&) = delete;

  void add(const LiveSample& sample);
  std::uint64_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  /// Calls `each` with all of them, in order. Fails where the file cannot be read back.
  Result<bool> forEach(const std::function<void(const LiveSample&)>& each) const;

 private:
  void putAway();

  int file_ = -1;                      ///< Its descriptor for writing; -1 without a file
  std::optional<InputFile> readBack_;  ///< The same, for reading
  std::uint64_t written_ = 0;          ///< Bytes in the file
  std::vector<std::string> inMemory_;  ///< Blocks that followed when the disk took no more
  std::string fresh_;                  ///< The block that grows
  std::uint64_t size_ = 0;
};

}  // namespace heft
