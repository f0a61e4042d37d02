#include "core/live/growing_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <string_view>
#include <utility>

#include "core/base/say.h"
#include "core/base/text.h"

namespace heft {
namespace {

constexpr std::chrono::seconds kSync{1};
constexpr std::size_t kMost = 256U << 20U;  ///< [bytes] Ten minutes of a stalled disk at 1 kHz.

}  // namespace

Result<std::unique_ptr<GrowingFile>> GrowingFile::create(const std::filesystem::path& file) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0644);
  if (descriptor < 0) return Error{heft::say("{} cannot be made: {}.", displayName(file), std::strerror(errno))};
  return std::unique_ptr<GrowingFile>(new GrowingFile(file, descriptor));
}

GrowingFile::GrowingFile(std::filesystem::path file, int descriptor)
    : file_(std::move(file)), descriptor_(descriptor), thread_([this] { run(); }) {}

GrowingFile::~GrowingFile() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  changed_.notify_all();
  thread_.join();
  ::close(descriptor_);
}

bool GrowingFile::append(std::string text) {
  const std::lock_guard lock(mutex_);
  if (problem_.empty() && waiting_.size() + text.size() > kMost)
    problem_ =
        heft::say("{} cannot be written as fast as samples come. What is there can be read.", displayName(file_));
  if (!problem_.empty()) return false;
  waiting_ += text;
  changed_.notify_all();
  return true;
}

bool GrowingFile::finish() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return !problem_.empty() || (waiting_.empty() && !writing_); });
  return problem_.empty();
}

std::string GrowingFile::problem() const {
  const std::lock_guard lock(mutex_);
  return problem_;
}

std::string GrowingFile::write(const std::string& text) const {
  std::string_view left = text;
  while (!left.empty()) {
    const auto written = ::write(descriptor_, left.data(), left.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0)
      return heft::say("{} cannot be written any further: {}. What is there can be read.", displayName(file_),
                       std::strerror(errno));
    left.remove_prefix(static_cast<std::size_t>(written));
  }
  return {};
}

void GrowingFile::run() {
  auto synced = std::chrono::steady_clock::now();
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [&] { return ending_ || (!waiting_.empty() && problem_.empty()); });
    if (waiting_.empty() || !problem_.empty()) break;
    const std::string text = std::exchange(waiting_, {});
    writing_ = true;
    lock.unlock();
    std::string problem = write(text);
    lock.lock();
    writing_ = false;
    if (problem_.empty()) problem_ = std::move(problem);
    changed_.notify_all();
    if (const auto now = std::chrono::steady_clock::now(); now - synced > kSync) {
      lock.unlock();
      ::fdatasync(descriptor_);
      lock.lock();
      synced = now;
    }
  }
}

}  // namespace heft
