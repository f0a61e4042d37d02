#pragma once
// Where the time of long work goes, by the stages that it reports as progress.
#include <chrono>
#include <mutex>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/base/progress.h"

namespace heft::cli {

/// Each new message of the progress begins a stage; one that comes back goes on with its own.
class StageTimes {
 public:
  /// Reports to `onward` as well. The work must end before this object does.
  Progress watching(Progress onward);
  /// Ends the last stage.
  void finish();
  /// Stage, wall and processor time [s], and the most memory so far [MB], a line each.
  std::string table() const;
  /// [{"stage", "wall_s", "processor_s", "peak_mb"}]
  nlohmann::json toJson() const;

 private:
  struct Stage {
    std::string name;
    double wall = 0.0, processor = 0.0;  ///< [s]
    double peak = 0.0;                   ///< Of the whole program until its end [MB]
  };
  void begin(std::string_view name);
  void endCurrent();

  using Clock = std::chrono::steady_clock;
  std::mutex mutex_;
  std::vector<Stage> stages_;
  std::size_t current_ = 0;  ///< One past it; 0: none
  Clock::time_point wall_;
  double processor_ = 0.0;
};

}  // namespace heft::cli
