#include "core/live/growing_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>
#include <string_view>
#include <utility>

#include "core/base/file_replacement.h"
#include "core/base/say.h"
#include "core/base/text.h"

namespace heft {
namespace {

constexpr std::chrono::seconds kSync{1};
constexpr std::size_t kChunk = 1U << 20U;   ///< [bytes] A widened file is written in such pieces.
constexpr std::size_t kMost = 256U << 20U;  ///< [bytes] Ten minutes of a stalled disk at 1 kHz.

/// Whether this program alone may write to the file: it is empty, still has its name, and no living program holds it.
/// Where the file system knows no locks, only a file that was made just now is its maker's.
bool claimed(const std::filesystem::path& file, int descriptor, bool made) {
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) return made && errno != EWOULDBLOCK;
  struct stat opened {
  }, named{};
  return ::fstat(descriptor, &opened) == 0 && ::stat(file.c_str(), &named) == 0 && S_ISREG(opened.st_mode) &&
         opened.st_size == 0 && opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

}  // namespace

Result<std::unique_ptr<GrowingFile>> GrowingFile::create(const std::filesystem::path& file,
                                                         std::function<std::string()> before) {
  int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0666);
  const bool made = descriptor >= 0;
  if (!made && errno == EEXIST) {
    descriptor = ::open(file.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
    errno = EEXIST;
  }
  if (descriptor >= 0 && !claimed(file, descriptor, made)) {
    ::close(descriptor);
    descriptor = -1;
    errno = EEXIST;
  }
  if (descriptor < 0 && errno == EEXIST)
    return Error{
        heft::say("{} already exists; a recording never overwrites a file. Choose another name.", displayName(file))};
  if (descriptor < 0) return Error{heft::say("{} cannot be created: {}.", displayName(file), std::strerror(errno))};
  flushFolderOf(file);
  return std::unique_ptr<GrowingFile>(new GrowingFile(file, descriptor, made, std::move(before)));
}

GrowingFile::GrowingFile(std::filesystem::path file, int descriptor, bool made, std::function<std::string()> before)
    : file_(std::move(file)), descriptor_(descriptor), made_(made), before_(std::move(before)), thread_([this] {
        run();
      }) {}

GrowingFile::~GrowingFile() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  changed_.notify_all();
  thread_.join();
  flushToDisk(descriptor_);
  ::close(descriptor_);
}

bool GrowingFile::append(std::string text) { return take({std::move(text), false}); }

bool GrowingFile::addColumns(std::string names) { return take({std::move(names), true}); }

bool GrowingFile::take(Piece piece) {
  const std::lock_guard lock(mutex_);
  std::size_t bytes = piece.text.size();
  for (const auto& each : waiting_) bytes += each.text.size();
  if (problem_.empty() && bytes > kMost)
    problem_ = heft::say("{} cannot be written as fast as samples arrive. What was written so far can be read.",
                         displayName(file_));
  if (!problem_.empty()) return false;
  if (!piece.columns && !waiting_.empty() && !waiting_.back().columns)
    waiting_.back().text += piece.text;
  else if (!piece.text.empty())
    waiting_.push_back(std::move(piece));
  changed_.notify_all();
  return true;
}

bool GrowingFile::finish() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return !problem_.empty() || (waiting_.empty() && !writing_); });
  if (problem_.empty()) problem_ = flush();
  return problem_.empty();
}

void GrowingFile::forget() {
  if (std::exchange(made_, false)) ::unlink(file_.c_str());
}

std::string GrowingFile::problem() const {
  const std::lock_guard lock(mutex_);
  return problem_;
}

std::string GrowingFile::flush() const {
  if (const int reason = flushToDisk(descriptor_); reason != 0) return cannotGrow(reason);
  struct stat status {};
  if (::fstat(descriptor_, &status) == 0 && status.st_nlink == 0)
    return heft::say("{} was deleted while it was being written.", displayName(file_));
  return {};
}

std::string GrowingFile::cannotGrow(int reason) const {
  return heft::say("{} can no longer be written: {}. What was written so far can be read.", displayName(file_),
                   std::strerror(reason));
}

std::string GrowingFile::write(const std::string& text) const {
  std::string_view left = text;
  while (!left.empty()) {
    const auto written = ::write(descriptor_, left.data(), left.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return cannotGrow(written < 0 ? errno : ENOSPC);
    left.remove_prefix(static_cast<std::size_t>(written));
  }
  return {};
}

std::string GrowingFile::widen(const std::string& names) {
  std::ifstream old(file_, std::ios::binary);
  auto fresh = FileReplacement::begin(file_);
  if (!fresh) return fresh.error().message;
  const std::string cells(static_cast<std::size_t>(std::count(names.begin(), names.end(), ',')) + 1, ',');
  std::string line, text;
  bool first = true, more = static_cast<bool>(std::getline(old, line));
  while (more) {
    text += line;
    if (first) text += ',';
    text += first ? names : cells;
    text += '\n';
    first = false;
    more = static_cast<bool>(std::getline(old, line));
    if (more && text.size() < kChunk) continue;
    if (const auto written = fresh->write(text); !written) return written.error().message;
    text.clear();
  }
  if (!old.eof()) return cannotGrow(EIO);
  if (const auto done = fresh->commit(); !done) return done.error().message;
  const int descriptor = ::open(file_.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  if (descriptor < 0) return cannotGrow(errno);
  ::flock(descriptor, LOCK_EX | LOCK_NB);
  const std::lock_guard lock(mutex_);
  ::close(std::exchange(descriptor_, descriptor));
  return {};
}

void GrowingFile::run() {
  auto synced = std::chrono::steady_clock::now();
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [&] { return ending_ || (!waiting_.empty() && problem_.empty()); });
    if (waiting_.empty() || !problem_.empty()) break;
    const Piece piece = std::move(waiting_.front());
    waiting_.pop_front();
    writing_ = true;
    lock.unlock();
    std::string problem;
    if (const auto before = std::exchange(before_, {})) problem = before();
    if (problem.empty()) problem = piece.columns ? widen(piece.text) : write(piece.text);
    lock.lock();
    writing_ = false;
    if (problem_.empty()) problem_ = std::move(problem);
    changed_.notify_all();
    if (const auto now = std::chrono::steady_clock::now(); now - synced > kSync) {
      lock.unlock();
      problem = flush();
      lock.lock();
      if (problem_.empty()) problem_ = std::move(problem);
      synced = now;
    }
  }
}

}  // namespace heft
