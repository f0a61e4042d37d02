#pragma once
// A file that grows in a thread of its own: whoever measures waits for no disk.
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "core/base/result.h"

namespace heft {

/// Text is handed to the system as soon as it is appended and to the disk every second. All functions may be called
/// from any thread.
class GrowingFile {
 public:
  /// Fails if the file exists or cannot be made. An empty one that no living program writes to, as a killed one leaves
  /// it, is taken. Of several programs that try at the same moment one succeeds.
  /// `before`: done by the file's own thread before the first text; what it returns is the problem, or nothing.
  static Result<std::unique_ptr<GrowingFile>> create(const std::filesystem::path& file,
                                                     std::function<std::string()> before = {});
  ~GrowingFile();  ///< Writes what is left.
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;

  /// Returns at once. False once the disk is full, gone, or far too slow; problem() says so.
  bool append(std::string text);
  /// Gives a CSV more columns after all that was appended so far: `names` ("ax,ay") behind the first line's, empty
  /// cells behind every other line's. The file is replaced as a whole; a killed program leaves the old or the new one.
  bool addColumns(std::string names);
  /// Waits until everything is on the disk. False if there is a problem.
  bool finish();
  /// Takes the file's name away if create() made it: for one that nothing was written to.
  void forget();
  std::string problem() const;

 private:
  GrowingFile(std::filesystem::path file, int descriptor, bool made, std::function<std::string()> before);
  void run();
  /// Text to append, or the names of columns to add.
  struct Piece {
    std::string text;
    bool columns = false;
  };
  bool take(Piece piece);
  /// What went wrong, or nothing.
  std::string widen(const std::string& names);
  std::string write(const std::string& text) const;
  /// The same of what was written, handed to the disk.
  std::string flush() const;
  std::string cannotGrow(int reason) const;

  std::filesystem::path file_;
  int descriptor_;
  bool made_;  ///< The file was not there before.
  std::function<std::string()> before_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Piece> waiting_;
  std::string problem_;
  bool writing_ = false, ending_ = false;
  std::thread thread_;  ///< Last, so that it sees everything else made.
};

}  // namespace heft
