#pragma once
// Many recordings, each by itself: a pool of processes and one line of JSON per recording.
#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace heft::cli {

struct EachRecording {
  std::vector<std::string> files;
  int jobs = 0;                     ///< Processes at a time; 0: one per core.
  std::filesystem::path jsonLines;  ///< "-" is stdout.
  bool startOver = false;           ///< Whether a file of lines that is there is replaced instead of continued.
};

/// Calls `work` with each file in a process of its own, so that memory is given back and a crash costs one recording,
/// and writes what it returns as one line with the file's name as "file"; {"file", "error"} where it throws or its
/// process dies. Files that stand in `jsonLines` already are passed over; a line that was cut off is taken out. Lines
/// come in the order in which recordings are done. Call it before the program starts any thread. \throws Failed if
/// lines cannot be written, or at the end if any recording failed.
void forEachRecording(const EachRecording& wish, const std::function<nlohmann::json(const std::string&)>& work);

}  // namespace heft::cli
