#include "core/live/recorder.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <utility>

#include "core/base/file_replacement.h"
#include "core/base/json_file.h"
#include "core/base/say.h"
#include "core/base/text.h"
#include "core/recording/csv_reader.h"
#include "core/recording/meta_file.h"

namespace heft {

namespace {

constexpr double kHandOver = 0.2;  ///< [s]
constexpr const char* kAccelerations = "ax,ay,az";
constexpr const char* kRates = "imu_wx,imu_wy,imu_wz";

/// That the setup file is there and says something else, or nothing. One that says the same is as good: a program that
/// was killed may have left it, or a person wrote it before.
std::string otherMeta(const std::filesystem::path& file, const std::string& text) {
  std::error_code code;
  if (!std::filesystem::exists(file, code)) return {};
  if (const auto old = readTextFile(file); old && *old == text) return {};
  return heft::say("{} already exists; a recording never overwrites a file. Choose another name.", displayName(file));
}

/// What is in the way of the setup file, or nothing once it is there. One that was written since the start is as good:
/// the studio states the arm that the first sample tells.
std::string provideMeta(const std::filesystem::path& file, const std::string& text) {
  std::error_code code;
  if (std::filesystem::exists(file, code)) return {};
  const auto written = createTextFile(file, text);
  return written || std::filesystem::exists(file, code) ? std::string() : written.error().message;
}

}  // namespace

Result<Recorder> Recorder::create(const std::filesystem::path& csv, const RecordingMeta& meta) {
  const auto metaFile = metaFileOf(csv);
  const auto text = metaText(meta, metaFile);
  if (!text) return text.error();
  Recorder out;
  out.file_ = csv;
  // Who has the CSV has the setup file: of two programs only one comes this far.
  auto disk = GrowingFile::create(csv, [metaFile, text = *text] { return provideMeta(metaFile, text); });
  if (!disk) return disk.error();
  out.disk_ = std::move(*disk);
  if (auto problem = otherMeta(metaFile, *text); !problem.empty()) return Error{std::move(problem)};
  return out;
}

Recorder::~Recorder() {
  if (!disk_) return;
  try {
    if (rows() > 0) {
      handOver();
      return;
    }
    // Empty files would only be in the next run's way.
    disk_->forget();
  } catch (const std::exception&) {
    // Out of memory: what was written before is on the disk.
  }
}

void Recorder::begin() {
  begun_ = true;
  const auto any = [&](const auto& has) { return std::ranges::any_of(first_, has); };
  origin_ = first_.front().time;
  q_ = any([](const LiveSample& s) { return s.q.has_value(); });
  // Poses that came before the first joint angles are not what the recording is about.
  const auto like = [&](const LiveSample& s) { return s.q.has_value() == q_; };
  dq_ = any([&](const LiveSample& s) { return s.q && s.dq; });
  orientation_ = any([&](const LiveSample& s) { return like(s) && s.orientation; });
  position_ = any([&](const LiveSample& s) { return like(s) && s.orientation && s.position; });
  for (const auto& sample : first_) noteInertial(sample);
  joints_ = std::clamp(std::ranges::find_if(first_, like)->joints, 0, 7);
  pending_ = "time";
  if (q_)
    for (int j = 1; j <= joints_; ++j) pending_ += fmt::format(",q{}", j);
  if (dq_)
    for (int j = 1; j <= joints_; ++j) pending_ += fmt::format(",dq{}", j);
  if (position_) pending_ += ",px,py,pz";
  if (orientation_) pending_ += ",qx,qy,qz,qw";
  pending_ += ",fx,fy,fz,tx,ty,tz";
  for (const bool rates : inertial_) pending_ += std::string(",") + (rates ? kRates : kAccelerations);
  pending_ += '\n';
  for (const auto& sample : std::exchange(first_, {})) write(sample);
}

bool Recorder::noteInertial(const LiveSample& sample) {
  const auto before = inertial_.size();
  for (const bool rates : {false, true})
    if (sample.accelerometer && (!rates || sample.gyroscope) && std::ranges::find(inertial_, rates) == inertial_.end())
      inertial_.push_back(rates);
  return inertial_.size() > before;
}

void Recorder::number(double value) { fmt::format_to(std::back_inserter(pending_), ",{}", value); }

void Recorder::write(const LiveSample& sample) {
  // A row without what the header promises would be a hole; the motion's other form may be there for a moment only.
  if ((q_ && !sample.q) || (orientation_ && !sample.orientation) || (position_ && !sample.position)) return;
  fmt::format_to(std::back_inserter(pending_), "{:.9f}", sample.time - origin_);
  const auto joints = static_cast<std::size_t>(joints_);
  const auto orEmpty = [&](const auto& values, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      if (values)
        number((*values)[static_cast<int>(i)]);
      else
        pending_ += ',';
    }
  };
  if (q_)
    for (std::size_t j = 0; j < joints; ++j) number((*sample.q)[j]);
  if (dq_) orEmpty(sample.dq, joints);
  if (position_)
    for (const double value : *sample.position) number(value);
  if (orientation_)
    for (const double value : sample.orientation->coeffs()) number(value);
  for (const double value : *sample.wrench) number(value);
  for (const bool rates : inertial_) orEmpty(rates ? sample.gyroscope : sample.accelerometer, 3);
  pending_ += '\n';
  ++rows_;
}

bool Recorder::add(const LiveSample& sample) {
  if (failed_) return false;
  if (!sample.wrench || !sample.hasMotion()) return true;
  if (!begun_) {
    if (first_.empty()) handed_ = hostNow();
    first_.push_back(sample);
  } else {
    const auto before = inertial_.size();
    if (noteInertial(sample)) {
      disk_->append(std::exchange(pending_, {}));
      for (auto i = before; i < inertial_.size(); ++i) disk_->addColumns(inertial_[i] ? kRates : kAccelerations);
    }
    write(sample);
  }
  return hostNow() - handed_ < kHandOver || handOver();
}

bool Recorder::handOver() {
  handed_ = hostNow();
  if (!begun_ && !first_.empty()) begin();
  failed_ = !disk_->append(std::exchange(pending_, {}));
  return !failed_;
}

bool Recorder::flush() {
  failed_ = !(handOver() && disk_->finish());
  return !failed_;
}

}  // namespace heft
