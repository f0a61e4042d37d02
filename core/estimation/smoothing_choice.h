#pragma once
// How strongly a recording's motion is smoothed: as little as its wrench is still predicted best with.
#include <functional>
#include <optional>

#include "core/estimation/prepare.h"

namespace heft {

/// A recording prepared with the smoothing that predicts its wrench best.
struct Smoothed {
  Prepared prepared;
  /// Blocks of the widest band, where a narrower one was chosen: the wrench is then smoothed with the motion.
  std::optional<WrenchRows> widest;
};

/// With the only smoothing that is asked for.
Result<Smoothed> onlySmoothed(Result<Prepared> prepared);

/// With 25, 12, 6 or 3 Hz, see prepare(). `preparedAt`: prepares the recording with a cut-off [Hz]; called by two
/// threads at once, never twice with the same.
Result<Smoothed> bestSmoothed(const std::function<Result<Prepared>(double)>& preparedAt, const Progress& progress);

}  // namespace heft
