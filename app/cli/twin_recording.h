#pragma once
// heft simulate --like: a recording with the causes that a diagnosis found.
#include <optional>
#include <string>
#include <vector>

#include "core/simulation/simulate.h"

namespace heft::cli {

struct LikeArguments {
  std::string file;                  ///< heft.diagnose/1; empty: none
  std::vector<std::string> without;  ///< IDs of causes to switch off
  bool fixed = false;                ///< Sizes as found
};

/// `said` gets a line a cause: its sizes, or why it is not in the recording. Throws Failed.
Simulated simulateLike(const LikeArguments& like, const SimulateOptions& simulate,
                       const std::optional<Payload>& payload, const Progress& progress, std::string& said);

}  // namespace heft::cli
