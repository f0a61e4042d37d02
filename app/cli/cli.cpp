#include "app/cli/cli.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/cli/numbers.h"
#include "app/version.h"
#include "core/base/hash.h"
#include "core/base/json_file.h"
#include "core/base/text.h"

namespace heft::cli {
namespace {

// Edits (insert, delete, replace, swap neighbours) from a to b: optimal string alignment.
std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i)
    for (std::size_t j = 1; j <= b.size(); ++j) {
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[a.size()][b.size()];
}

}  // namespace

std::string programVersion() { return "heft " + std::string(version()); }

std::string didYouMean(std::string_view text, const std::vector<std::string>& candidates) {
  const std::string* best = nullptr;
  std::size_t bestDistance = std::max<std::size_t>(1, text.size() / 3) + 1;
  for (const auto& candidate : candidates) {
    std::size_t distance = editDistance(text, candidate);
    // Half a word typed ("exci") counts as near to the word it begins.
    if (text.size() >= 3 && candidate.starts_with(text)) distance = std::min<std::size_t>(distance, 1);
    if (distance < bestDistance) {
      bestDistance = distance;
      best = &candidate;
    }
  }
  return best ? fmt::format(" Did you mean '{}'?", *best) : "";
}

std::uint64_t parseSeed(const std::string& text) {
  std::uint64_t seed = 0;
  const char* const end = text.data() + text.size();
  const auto [next, error] = std::from_chars(text.data(), end, seed);
  if (error != std::errc{} || next != end)
    throw WrongUsage(fmt::format("--seed expects a whole number from 0 to 2^64 - 1, not '{}'.", printable(text)));
  return seed;
}

std::size_t chooseWord(const std::string& option, const std::string& text, const std::vector<std::string>& words) {
  const auto found = std::find(words.begin(), words.end(), text);
  if (found == words.end())
    throw WrongUsage(fmt::format("{} does not know '{}'.{} Choose one of {}.", option, printable(text),
                                 didYouMean(text, words), fmt::join(words, ", ")));
  return static_cast<std::size_t>(found - words.begin());
}

Vector3d parseVector3(const std::string& option, const std::string& text) {
  const auto numbers = parseNumbers(text);
  if (!numbers || numbers->size() != 3)
    throw WrongUsage(fmt::format("{} expects three numbers separated by commas such as 0,0,0.04, not '{}'.", option,
                                 printable(text)));
  return {(*numbers)[0], (*numbers)[1], (*numbers)[2]};
}

Isometry3d parsePose(const std::string& option, const std::string& text) {
  const auto numbers = parseNumbers(text);
  if (!numbers || (numbers->size() != 3 && numbers->size() != 6))
    throw WrongUsage(fmt::format("{} expects x,y,z or x,y,z,roll,pitch,yaw, numbers separated by commas, not '{}'.",
                                 option, printable(text)));
  const Eigen::Map<const VectorXd> v(numbers->data(), static_cast<Eigen::Index>(numbers->size()));
  return poseFromXyzRpy(v.head<3>(), v.size() == 6 ? Vector3d(v.tail<3>()) : Vector3d(Vector3d::Zero()));
}

void requireRange(const std::string& option, double value, double lower, double upper, const std::string& unit) {
  if (value >= lower && value <= upper) return;
  throw WrongUsage(fmt::format("{} must lie between {} and {}{}{}, not {}.", option, lower, upper,
                               unit.empty() ? "" : " ", unit, value));
}

void print(std::string_view text) {
  if (auto written = writeTextFile("-", text); !written) throw Failed(written.error().message);
}

void tell(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stderr); }

void printFindings(const Findings& findings, bool all) {
  for (const auto& finding : findings)
    if (all || finding.severity != Severity::info) tell(fmt::format("{}\n", toLine(finding)));
}

nlohmann::json toJson(const Findings& findings) {
  auto list = nlohmann::json::array();
  for (const auto& finding : findings) {
    nlohmann::json item{{"severity", toString(finding.severity)}, {"code", finding.code}, {"text", finding.text}};
    if (!finding.remedy.empty()) item["remedy"] = finding.remedy;
    if (!finding.where.file.empty())
      item["where"] = {{"file", finding.where.file}, {"line", finding.where.line}, {"column", finding.where.column}};
    list.push_back(std::move(item));
  }
  return list;
}

std::string dump(const nlohmann::json& json) {
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string fileText(const nlohmann::json& json) {
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

void requireWritable(const std::filesystem::path& path, const Overwrite& overwrite) {
  std::error_code ec;
  if (overwrite.force || path == "-" || !std::filesystem::is_regular_file(path, ec)) return;
  if (std::filesystem::file_size(path, ec) == 0) return;
  if (overwrite.expendable) {
    const auto old = readTextFile(path);
    if (old && overwrite.expendable(*old)) return;
  }
  throw Failed(fmt::format("{} already exists and was not overwritten: choose another name, or use --force.",
                           displayName(path)));
}

void writeOutput(const std::filesystem::path& path, std::string_view text, const Overwrite& overwrite) {
  std::error_code ec;
  if (path != "-" && std::filesystem::is_regular_file(path, ec)) {
    if (const auto old = readTextFile(path); old && *old == text) return;
  }
  requireWritable(path, overwrite);
  if (auto written = writeTextFile(path, text); !written) throw Failed(written.error().message);
}

std::string checksum(std::string_view text) { return fmt::format("{:016x}", hashOf(text)); }

namespace {

/// How long the work took is no part of it: the same result has the same checksum.
std::string checksumOf(nlohmann::json result) {
  for (const char* key : {"checksum", "timing_s"}) result.erase(key);
  return checksum(dump(result));
}

/// Whether it is a result of this schema as writeResult() wrote it, perhaps laid out anew.
bool asWritten(const std::string& text, std::string_view schema) {
  const auto json = nlohmann::json::parse(text, nullptr, false);
  return json.is_object() && json.value("schema", nlohmann::json()) == nlohmann::json(schema) &&
         json.value("checksum", nlohmann::json()) == nlohmann::json(checksumOf(json));
}

}  // namespace

void writeResult(const std::filesystem::path& path, nlohmann::json result, const Overwrite& overwrite) {
  if (path != "-") result["checksum"] = checksumOf(result);
  writeOutput(path, fileText(result), overwrite);
}

Overwrite ownResult(bool force, std::string_view schema) {
  return {force, [schema = std::string(schema)](const std::string& old) { return asWritten(old, schema); }};
}

ProgressLine::ProgressLine() : terminal_(isatty(STDERR_FILENO) != 0), start_(Clock::now()), last_(start_) {}

ProgressLine::~ProgressLine() { clear(); }

Progress ProgressLine::progress() {
  Progress progress;
  if (terminal_) progress.report = [this](double fraction, std::string_view what) { show(fraction, what); };
  return progress;
}

void ProgressLine::show(double fraction, std::string_view what) {
  using namespace std::chrono_literals;
  const std::lock_guard lock(mutex_);
  const auto now = Clock::now();
  if (now - start_ < 500ms || now - last_ < 80ms) return;
  last_ = now;
  visible_ = true;
  const int percent = static_cast<int>(std::lround(100.0 * std::clamp(fraction, 0.0, 1.0)));
  tell(fmt::format("\r\033[K{:3d} %  {}", percent, what.substr(0, 60)));
  std::fflush(stderr);
}

void ProgressLine::clear() {
  const std::lock_guard lock(mutex_);
  if (!visible_) return;
  visible_ = false;
  tell("\r\033[K");
  std::fflush(stderr);
}

}  // namespace heft::cli
