#pragma once
// What every subcommand of `heft` shares: how it ends, how it writes, how it answers a typing error.
//
// Exit codes: 0 done, 1 could not be done (bad data, no solution), 2 wrong usage. Results go to stdout, everything else
// to stderr; nothing here depends on the locale.
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <mutex>
#include <nlohmann/json_fwd.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/findings.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/math/rigid.h"

namespace CLI {
class App;
}

namespace heft::cli {

enum ExitCode { kDone = 0, kFailed = 1, kWrongUsage = 2 };

/// Could not be done; the text is the whole sentence for the user.
struct Failed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The command line itself is wrong.
struct WrongUsage : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A subcommand: its options live in `run`'s captures, so `run` is called after parsing.
struct Command {
  CLI::App* app = nullptr;
  std::function<void()> run;
};

Command makeEstimateCommand(CLI::App& root);
Command makeDiagnoseCommand(CLI::App& root);
Command makeSimulateCommand(CLI::App& root);
Command makeExportCommand(CLI::App& root);
Command makeExportModelCommand(CLI::App& root);
Command makeConvertCommand(CLI::App& root);
Command makeReproduceCommand(CLI::App& root);
Command makeLiveCommand(CLI::App& root);
Command makeSegmentCommand(CLI::App& root);
Command makeCompensateCommand(CLI::App& root);
Command makeProveCommand(CLI::App& root);
Command makePassportCommand(CLI::App& root);
Command makeCoachCommand(CLI::App& root);
Command makeExciteCommand(CLI::App& root);
Command makeRoomCommand(CLI::App& root);

/// "heft 0.2.0"
std::string programVersion();

template <class T>
T orFail(Result<T> result) {
  if (!result) throw Failed(result.error().message);
  return std::move(result).value();
}

/// " Did you mean 'estimate'?" for the nearest candidate, or "" if none is near enough to be meant.
std::string didYouMean(std::string_view text, const std::vector<std::string>& candidates);

/// A whole number from 0 to 2^64 - 1; throws WrongUsage. Not left to CLI11, which wraps -1 round to the largest.
std::uint64_t parseSeed(const std::string& text);

/// Finds `text` among the allowed words and returns its position; throws WrongUsage that lists them.
std::size_t chooseWord(const std::string& option, const std::string& text, const std::vector<std::string>& words);

/// "x,y,z" with from_chars; throws WrongUsage.
Vector3d parseVector3(const std::string& option, const std::string& text);

/// "x,y,z[,roll,pitch,yaw]" in metres and radians, fixed axes; throws WrongUsage.
Isometry3d parsePose(const std::string& option, const std::string& text);

/// Throws WrongUsage unless lower <= value <= upper (so also for NaN). `unit` may be empty.
void requireRange(const std::string& option, double value, double lower, double upper, const std::string& unit);

/// Writes to stdout and fails where that fails (a full disk behind a redirection).
void print(std::string_view text);

/// Writes to stderr. If nothing can read it any more (the terminal was closed), the work goes on.
void tell(std::string_view text);

/// Warnings and errors, one per line, to stderr; information too where `all` is set.
void printFindings(const Findings& findings, bool all);

nlohmann::json toJson(const Findings& findings);

/// On one line; a file name that is not UTF-8 becomes readable instead of an exception.
std::string dump(const nlohmann::json& json);

/// As a file has it: indented, ending in a line break.
std::string fileText(const nlohmann::json& json);

/// What may happen to a file that is already there.
struct Overwrite {
  bool force = false;  ///< --force was given.
  /// Says of an existing text that this command can make it again, so that replacing it loses nothing.
  std::function<bool(const std::string&)> expendable;
};

/// Throws Failed if `path` names a file that would be lost. Empty files, pipes and "-" never are.
void requireWritable(const std::filesystem::path& path, const Overwrite& overwrite);

/// writeTextFile after requireWritable; a file that already holds `text` is left alone.
void writeOutput(const std::filesystem::path& path, std::string_view text, const Overwrite& overwrite);

/// Tells a text that somebody changed from one that is as it was written; not meant against forgery. 16 hex digits.
std::string checksum(std::string_view text);

/// writeOutput() of a result; a file gets a "checksum", by which ownResult() knows it.
void writeResult(const std::filesystem::path& path, nlohmann::json result, const Overwrite& overwrite);

/// A result of this schema may be replaced as writeResult() wrote it, perhaps laid out anew: a command can make it
/// again, but not what a person changed in it.
Overwrite ownResult(bool force, std::string_view schema);

/// A line on stderr that shows how far long work is: only on a terminal, and only after half a second.
class ProgressLine {
 public:
  ProgressLine();
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  Progress progress();
  /// Wipes the line, so that what follows starts in a clean one.
  void clear();

 private:
  void show(double fraction, std::string_view what);

  using Clock = std::chrono::steady_clock;
  std::mutex mutex_;
  bool terminal_ = false;
  bool visible_ = false;
  Clock::time_point start_, last_;
};

}  // namespace heft::cli
