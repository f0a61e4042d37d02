#include "app/cli/stage_times.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace heft::cli {

namespace {

rusage used() {
  rusage out{};
  getrusage(RUSAGE_SELF, &out);
  return out;
}

double processorSeconds(const rusage& u) {
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(u.ru_utime) + seconds(u.ru_stime);
}

}  // namespace

Progress StageTimes::watching(Progress onward) {
  begin("Starting");
  const auto stop = onward.stop;
  return {stop, [this, onward = std::move(onward)](double fraction, std::string_view what) {
            begin(what);
            onward(fraction, what);
          }};
}

void StageTimes::begin(std::string_view name) {
  const std::lock_guard lock(mutex_);
  if (current_ > 0 && stages_[current_ - 1].name == name) return;
  endCurrent();
  auto stage = std::ranges::find(stages_, name, &Stage::name);
  if (stage == stages_.end()) stage = stages_.insert(stages_.end(), {std::string(name)});
  current_ = static_cast<std::size_t>(stage - stages_.begin()) + 1;
}

void StageTimes::endCurrent() {
  const auto now = Clock::now();
  const rusage u = used();
  const double processor = processorSeconds(u);
  if (current_ > 0) {
    Stage& stage = stages_[current_ - 1];
    stage.wall += std::chrono::duration<double>(now - wall_).count();
    stage.processor += processor - processor_;
    stage.peak = static_cast<double>(u.ru_maxrss) / 1024.0;
  }
  wall_ = now;
  processor_ = processor;
  current_ = 0;
}

void StageTimes::finish() {
  const std::lock_guard lock(mutex_);
  endCurrent();
}

std::string StageTimes::table() const {
  std::string out = fmt::format("{:<48} {:>8} {:>12} {:>14}\n", "Stage", "Time", "Processor", "Most memory");
  for (const Stage& s : stages_)
    out += fmt::format("{:<48} {:>6.3f} s {:>10.3f} s {:>11.0f} MB\n", s.name, s.wall, s.processor, s.peak);
  return out;
}

nlohmann::json StageTimes::toJson() const {
  nlohmann::json out = nlohmann::json::array();
  for (const Stage& s : stages_)
    out.push_back({{"stage", s.name}, {"wall_s", s.wall}, {"processor_s", s.processor}, {"peak_mb", s.peak}});
  return out;
}

}  // namespace heft::cli
