#include "core/live/sample_spool.h"

#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <span>
#include <string_view>

#include "core/base/say.h"

namespace heft {

namespace {

constexpr std::size_t kBlock = std::size_t{256} << 10;  // Bytes that are written at once

/// Which of a sample's optional parts are there.
enum Part : std::uint8_t {
  kQ = 1,
  kDq = 2,
  kPosition = 4,
  kOrientation = 8,
  kWrench = 16,
  kAccelerometer = 32,
  kGyroscope = 64
};

void put(std::string& to, std::span<const double> values) {
  to.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
}

template <class Values>
void put(std::string& to, const std::optional<Values>& values, std::size_t count) {
  if (values) put(to, {values->data(), count});
}

/// Reads one sample from the beginning of `from`; false, and nothing taken, where it is not there as a whole.
bool take(std::string_view& from, LiveSample& sample) {
  if (from.size() < 2) return false;
  const auto parts = static_cast<std::uint8_t>(from[0]);
  sample = {};
  sample.joints = static_cast<unsigned char>(from[1]);
  std::string_view rest = from.substr(2);
  bool whole = true;
  const auto get = [&](double* to, std::size_t count) {
    const std::size_t bytes = count * sizeof(double);
    whole = whole && rest.size() >= bytes;
    if (!whole) return;
    std::memcpy(to, rest.data(), bytes);
    rest.remove_prefix(bytes);
  };
  const auto joints = static_cast<std::size_t>(sample.joints);
  get(&sample.time, 1);
  if (parts & kQ) get(sample.q.emplace().data(), joints);
  if (parts & kDq) get(sample.dq.emplace().data(), joints);
  if (parts & kPosition) get(sample.position.emplace().data(), 3);
  if (parts & kOrientation) get(sample.orientation.emplace().coeffs().data(), 4);
  if (parts & kWrench) get(sample.wrench.emplace().data(), 6);
  if (parts & kAccelerometer) get(sample.accelerometer.emplace().data(), 3);
  if (parts & kGyroscope) get(sample.gyroscope.emplace().data(), 3);
  if (whole) from = rest;
  return whole;
}

}  // namespace

SampleSpool::SampleSpool() {
  std::error_code none;
  std::string path = (std::filesystem::temp_directory_path(none) / "heft-live-XXXXXX").string();
  file_ = ::mkostemp(path.data(), O_CLOEXEC);
  if (file_ < 0) return;
  if (auto file = InputFile::open(path)) readBack_ = std::move(*file);
  ::unlink(path.c_str());
}

SampleSpool::~SampleSpool() {
  if (file_ >= 0) ::close(file_);
}

void SampleSpool::add(const LiveSample& sample) {
  const auto joints = static_cast<std::size_t>(sample.joints);
  fresh_ += static_cast<char>((sample.q ? kQ : 0) | (sample.dq ? kDq : 0) | (sample.position ? kPosition : 0) |
                              (sample.orientation ? kOrientation : 0) | (sample.wrench ? kWrench : 0) |
                              (sample.accelerometer ? kAccelerometer : 0) | (sample.gyroscope ? kGyroscope : 0));
  fresh_ += static_cast<char>(sample.joints);
  put(fresh_, {&sample.time, 1});
  put(fresh_, sample.q, joints);
  put(fresh_, sample.dq, joints);
  put(fresh_, sample.position, 3);
  if (sample.orientation) put(fresh_, {sample.orientation->coeffs().data(), 4});
  put(fresh_, sample.wrench, 6);
  put(fresh_, sample.accelerometer, 3);
  put(fresh_, sample.gyroscope, 3);
  ++size_;
  if (fresh_.size() >= kBlock) putAway();
}

void SampleSpool::putAway() {
  std::size_t done = 0;
  while (readBack_ && inMemory_.empty() && done < fresh_.size()) {
    const auto put = ::pwrite(file_, fresh_.data() + done, fresh_.size() - done, static_cast<off_t>(written_ + done));
    if (put < 0 && errno == EINTR) continue;
    if (put <= 0) break;
    done += static_cast<std::size_t>(put);
  }
  if (done == fresh_.size())
    written_ += done;
  else
    inMemory_.push_back(fresh_);  // As a whole: what was written of it lies behind the file's end
  fresh_.clear();
}

Result<bool> SampleSpool::forEach(const std::function<void(const LiveSample&)>& each) const {
  LiveSample sample;
  std::string block;
  for (std::uint64_t at = 0; at < written_;) {
    const std::size_t left = block.size();
    block.resize(left + static_cast<std::size_t>(std::min<std::uint64_t>(kBlock, written_ - at)));
    const auto got = readBack_->readAt(at, block.data() + left, block.size() - left);
    if (!got) return got.error();
    if (left + *got < block.size()) return Error{heft::say("The temporary file with the samples ends too early.")};
    at += *got;
    std::string_view rest = block;
    while (take(rest, sample)) each(sample);
    block.erase(0, block.size() - rest.size());
  }
  const auto takeAll = [&](std::string_view kept) {
    while (take(kept, sample)) each(sample);
  };
  for (const std::string& kept : inMemory_) takeAll(kept);
  takeAll(fresh_);
  return true;
}

}  // namespace heft
