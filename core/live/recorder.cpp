#include "core/live/recorder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "core/base/say.h"
#include "core/base/text.h"
#include "core/recording/csv_reader.h"

namespace heft {

namespace {

constexpr double kHandOver = 0.2;  ///< [s]
constexpr double kSync = 1.0;      ///< [s]

}  // namespace

Result<Recorder> Recorder::create(const std::filesystem::path& csv, const RecordingMeta& meta) {
  const auto metaFile = metaFileOf(csv);
  for (const auto& file : {csv, metaFile})
    if (std::filesystem::exists(file))
      return Error{heft::say("{} exists; a recording never replaces a file. Choose another name.", displayName(file))};
  if (const auto written = writeMeta(meta, metaFile); !written) return written.error();
  Recorder out;
  out.file_ = csv;
  out.descriptor_ = ::open(csv.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0644);
  if (out.descriptor_ < 0) return Error{heft::say("{} cannot be made: {}.", displayName(csv), std::strerror(errno))};
  return out;
}

Recorder::Recorder(Recorder&& other) noexcept { *this = std::move(other); }

Recorder& Recorder::operator=(Recorder&& other) noexcept {
  std::swap(file_, other.file_);
  std::swap(descriptor_, other.descriptor_);
  std::swap(pending_, other.pending_);
  std::swap(problem_, other.problem_);
  std::swap(rows_, other.rows_);
  std::swap(origin_, other.origin_);
  std::swap(handed_, other.handed_);
  std::swap(synced_, other.synced_);
  std::swap(joints_, other.joints_);
  std::swap(q_, other.q_);
  std::swap(dq_, other.dq_);
  std::swap(orientation_, other.orientation_);
  std::swap(position_, other.position_);
  return *this;
}

Recorder::~Recorder() {
  if (descriptor_ < 0) return;
  flush();
  ::close(descriptor_);
}

void Recorder::begin(const LiveSample& first) {
  origin_ = first.time;
  handed_ = synced_ = hostNow();
  joints_ = std::clamp(first.joints, 0, 7);
  q_ = first.q.has_value();
  dq_ = q_ && first.dq.has_value();
  orientation_ = first.orientation.has_value();
  position_ = orientation_ && first.position.has_value();
  pending_ = "time";
  if (q_)
    for (int j = 1; j <= joints_; ++j) pending_ += fmt::format(",q{}", j);
  if (dq_)
    for (int j = 1; j <= joints_; ++j) pending_ += fmt::format(",dq{}", j);
  if (position_) pending_ += ",px,py,pz";
  if (orientation_) pending_ += ",qx,qy,qz,qw";
  pending_ += ",fx,fy,fz,tx,ty,tz\n";
}

void Recorder::number(double value) { fmt::format_to(std::back_inserter(pending_), ",{}", value); }

bool Recorder::add(const LiveSample& sample) {
  if (descriptor_ < 0 || !problem_.empty()) return false;
  if (!sample.wrench || !sample.hasMotion()) return true;
  if (rows_ == 0) begin(sample);
  // A row without what the header promises would be a hole; the motion's other form may be there for a moment only.
  if ((q_ && !sample.q) || (orientation_ && !sample.orientation) || (position_ && !sample.position)) return true;
  fmt::format_to(std::back_inserter(pending_), "{:.9f}", sample.time - origin_);
  const auto joints = static_cast<std::size_t>(joints_);
  if (q_)
    for (std::size_t j = 0; j < joints; ++j) number((*sample.q)[j]);
  if (dq_) {
    for (std::size_t j = 0; j < joints; ++j) {
      if (sample.dq)
        number((*sample.dq)[j]);
      else
        pending_ += ',';
    }
  }
  if (position_)
    for (const double value : *sample.position) number(value);
  if (orientation_)
    for (const double value : sample.orientation->coeffs()) number(value);
  for (const double value : *sample.wrench) number(value);
  pending_ += '\n';
  ++rows_;
  return hostNow() - handed_ < kHandOver || flush();
}

bool Recorder::flush() {
  if (descriptor_ < 0 || !problem_.empty()) return false;
  std::string_view left = pending_;
  while (!left.empty()) {
    const auto written = ::write(descriptor_, left.data(), left.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) {
      problem_ = heft::say("{} cannot be written any further: {}. What is there can be read.", displayName(file_),
                           std::strerror(errno));
      pending_.assign(left);
      return false;
    }
    left.remove_prefix(static_cast<std::size_t>(written));
  }
  pending_.clear();
  handed_ = hostNow();
  if (handed_ - synced_ > kSync) {
    ::fdatasync(descriptor_);
    synced_ = handed_;
  }
  return true;
}

}  // namespace heft
