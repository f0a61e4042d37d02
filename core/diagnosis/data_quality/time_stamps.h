#pragma once
// Time stamps of a busy computer: the rows were taken evenly, but each was stamped when there was time for it.
#include <optional>

#include "core/recording/recording.h"

namespace heft::diagnosis {

struct UnevenStamps {
  double spread = 0.0;  ///< [s] between the earliest and the latest stamp, against even ones
  VectorXd even;        ///< [s] the recording's rows on an even clock
};

/// Only where even times make the recorded motion smoother: a motion that was truly taken at uneven instants is not.
std::optional<UnevenStamps> unevenStamps(const Recording& recording);

}  // namespace heft::diagnosis
