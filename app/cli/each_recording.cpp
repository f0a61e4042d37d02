#include "app/cli/each_recording.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "app/cli/cli.h"
#include "core/base/file_replacement.h"
#include "core/base/json_file.h"
#include "core/base/text.h"

namespace heft::cli {
namespace {

using nlohmann::json;

void writeWhole(int to, std::string_view text, const std::string& name) {
  while (!text.empty()) {
    const ssize_t written = ::write(to, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) throw Failed(fmt::format("{}: cannot be written: {}.", name, std::strerror(errno)));
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

/// Where lines go, and which files have one already.
class Lines {
 public:
  Lines(const std::filesystem::path& path, bool startOver) : name_(path == "-" ? "stdout" : displayName(path)) {
    if (path == "-") {
      descriptor_ = STDOUT_FILENO;
      return;
    }
    descriptor_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | (startOver ? O_TRUNC : 0), 0666);
    if (descriptor_ < 0) throw Failed(fmt::format("{}: cannot be opened: {}.", name_, std::strerror(errno)));
    std::error_code code;
    if (!startOver && std::filesystem::is_regular_file(path, code)) readWhatIsThere(path);
  }
  ~Lines() {
    if (descriptor_ != STDOUT_FILENO) ::close(descriptor_);
  }
  Lines(const Lines&) = delete;
  Lines& operator=(const Lines&) = delete;

  bool has(const std::string& file) const { return there_.contains(file); }
  /// Whether the line that was there says why there is no result.
  bool failed(const std::string& file) const { return has(file) && there_.at(file); }
  void add(const json& line) { writeWhole(descriptor_, dump(line) + "\n", name_); }
  /// All lines are on the disk after it.
  void finish() {
    if (const int reason = flushToDisk(descriptor_); reason != 0)
      throw Failed(fmt::format("{}: cannot be written: {}.", name_, std::strerror(reason)));
  }

 private:
  void readWhatIsThere(const std::filesystem::path& path) {
    const std::string text = orFail(readTextFile(path));
    std::size_t from = 0, line = 1;
    for (std::size_t end; (end = text.find('\n', from)) != std::string::npos; from = end + 1, ++line) {
      const json entry = json::parse(text.begin() + static_cast<std::ptrdiff_t>(from),
                                     text.begin() + static_cast<std::ptrdiff_t>(end), nullptr, false);
      if (!entry.is_object() || !entry.contains("file") || !entry["file"].is_string())
        throw Failed(fmt::format(
            "{}, line {}: is no line of 'heft estimate --each'. Choose another name for --json-lines, or give "
            "--force to replace the file.",
            name_, line));
      there_[entry["file"].get<std::string>()] = entry.contains("error");
    }
    // What was being written when the last run ended.
    if (::ftruncate(descriptor_, static_cast<off_t>(from)) != 0 || ::lseek(descriptor_, 0, SEEK_END) < 0)
      throw Failed(fmt::format("{}: cannot be continued: {}.", name_, std::strerror(errno)));
  }

  std::string name_;
  int descriptor_ = -1;
  std::map<std::string, bool> there_;  ///< By file: whether its line is an error.
};

/// One recording under way.
struct Worker {
  std::string file;
  pid_t process = -1;
  int from = -1;     ///< Its line comes through here.
  std::string line;  ///< What has come of it.
};

/// What the process of a recording does, from its start to its end.
[[noreturn]] void work(const std::string& file, int to, const std::function<json(const std::string&)>& task) {
  json line;
  try {
    line = task(file);
  } catch (const std::exception& failure) {
    line = {{"error", failure.what()}};
  }
  line["file"] = file;
  try {
    writeWhole(to, dump(line), file);
  } catch (const std::exception&) {
    _exit(kFailed);  // Nobody listens any more.
  }
  _exit(kDone);
}

class Pool {
 public:
  explicit Pool(const std::function<json(const std::string&)>& task) : task_(task) {}
  ~Pool() {
    for (Worker& worker : workers_) {
      ::kill(worker.process, SIGTERM);
      ::close(worker.from);
      ::waitpid(worker.process, nullptr, 0);
    }
  }
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;

  std::size_t size() const { return workers_.size(); }

  void start(const std::string& file) {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) throw Failed(fmt::format("No pipe to a process: {}.", std::strerror(errno)));
    const pid_t process = ::fork();
    if (process == 0) {
      ::close(ends[0]);
      for (const Worker& other : workers_) ::close(other.from);
      work(file, ends[1], task_);
    }
    ::close(ends[1]);
    if (process < 0) {
      ::close(ends[0]);
      throw Failed(fmt::format("Cannot start another process: {}. Use fewer --jobs.", std::strerror(errno)));
    }
    workers_.push_back({file, process, ends[0], {}});
  }

  /// Waits until at least one recording is done, and returns the lines of those that are.
  std::vector<json> wait() {
    std::vector<json> done;
    while (done.empty()) {
      std::vector<pollfd> ready;
      for (const Worker& worker : workers_) ready.push_back({worker.from, POLLIN, 0});
      if (::poll(ready.data(), ready.size(), -1) < 0 && errno != EINTR)
        throw Failed(fmt::format("Waiting for processes failed: {}.", std::strerror(errno)));
      for (std::size_t i = workers_.size(); i-- > 0;) {
        if (ready[i].revents == 0 || !hasEnded(workers_[i])) continue;
        done.push_back(lineOf(workers_[i]));
        workers_.erase(workers_.begin() + static_cast<std::ptrdiff_t>(i));
      }
    }
    return done;
  }

 private:
  static bool hasEnded(Worker& worker) {
    char buffer[65536];
    const ssize_t count = ::read(worker.from, buffer, sizeof buffer);
    if (count > 0) worker.line.append(buffer, static_cast<std::size_t>(count));
    return count == 0 || (count < 0 && errno != EINTR);
  }

  static json lineOf(Worker& worker) {
    int status = 0;
    ::close(worker.from);
    ::waitpid(worker.process, &status, 0);
    json line = json::parse(worker.line, nullptr, false);
    if (line.is_object()) return line;
    const std::string how = WIFSIGNALED(status) ? fmt::format("by signal {}", WTERMSIG(status)) : "without a result";
    return {{"file", worker.file}, {"error", fmt::format("The process of this recording ended {}.", how)}};
  }

  const std::function<json(const std::string&)>& task_;
  std::vector<Worker> workers_;
};

}  // namespace

void forEachRecording(const EachRecording& wish, const std::function<json(const std::string&)>& task) {
  Lines lines(wish.jsonLines, wish.startOver);
  std::vector<std::string> left;
  std::size_t failed = 0;
  std::set<std::string> asked;
  for (const std::string& file : wish.files) {
    if (!asked.insert(file).second) continue;
    if (!lines.has(file)) left.push_back(file);
    failed += lines.failed(file) ? 1 : 0;
  }
  if (left.size() < asked.size())
    tell(fmt::format("{} of {} recordings already have a line.\n", asked.size() - left.size(), asked.size()));

  const std::size_t jobs =
      wish.jobs > 0 ? static_cast<std::size_t>(wish.jobs) : std::max(1u, std::thread::hardware_concurrency());
  ProgressLine shown;
  const Progress progress = shown.progress();
  Pool pool(task);
  std::size_t next = 0, done = 0;
  while (done < left.size()) {
    while (next < left.size() && pool.size() < jobs) pool.start(left[next++]);
    for (const json& line : pool.wait()) {
      lines.add(line);
      ++done;
      failed += line.contains("error") ? 1 : 0;
    }
    progress(static_cast<double>(done) / static_cast<double>(left.size()),
             fmt::format("{} of {} recordings", done, left.size()));
  }
  shown.clear();
  lines.finish();
  if (failed > 0)
    throw Failed(fmt::format("{} of {} recordings could not be estimated; the lines with \"error\" say why.", failed,
                             asked.size()));
}

}  // namespace heft::cli
