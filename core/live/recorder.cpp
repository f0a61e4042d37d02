#include "core/live/recorder.h"

#include <fmt/format.h>

#include <algorithm>
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

}  // namespace

Result<Recorder> Recorder::create(const std::filesystem::path& csv, const RecordingMeta& meta) {
  const auto metaFile = metaFileOf(csv);
  const auto text = metaText(meta, metaFile);
  if (!text) return text.error();
  Recorder out;
  out.file_ = csv;
  // Who has the CSV has the meta file: of two programs only one comes this far.
  auto disk = GrowingFile::create(csv);
  if (!disk) return disk.error();
  out.disk_ = std::move(*disk);
  std::error_code code;
  if (std::filesystem::exists(metaFile, code)) {
    // One that says the same is as good: a program that was killed may have left it, or a person wrote it before.
    if (const auto old = readTextFile(metaFile); !old || *old != *text)
      return Error{
          heft::say("{} exists; a recording never replaces a file. Choose another name.", displayName(metaFile))};
  } else {
    if (const auto written = createTextFile(metaFile, *text); !written) return written.error();
    out.madeMeta_ = true;
  }
  return out;
}

Recorder::~Recorder() {
  if (!disk_) return;
  if (rows_ > 0) {
    handOver();
    return;
  }
  // Empty files would only be in the next run's way.
  disk_->forget();
  std::error_code code;
  if (madeMeta_) std::filesystem::remove(metaFileOf(file_), code);
}

void Recorder::begin(const LiveSample& first) {
  origin_ = first.time;
  handed_ = hostNow();
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
  if (failed_) return false;
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
  return hostNow() - handed_ < kHandOver || handOver();
}

bool Recorder::handOver() {
  handed_ = hostNow();
  failed_ = !disk_->append(std::exchange(pending_, {}));
  return !failed_;
}

bool Recorder::flush() {
  failed_ = !(handOver() && disk_->finish());
  return !failed_;
}

}  // namespace heft
