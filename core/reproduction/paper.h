#pragma once
// The numbers printed in the seed paper (Hartwig, Lienhardt, Henrich 2025), Tables 1 and 2.
#include <optional>

#include "core/estimation/options.h"

namespace heft {

enum class Quantity { mass, com, inertia };
enum class DataKind { validation, measured };

std::string_view toString(Quantity quantity);  ///< "mass", "com", "inertia"
std::string_view toString(DataKind data);      ///< "validation", "measured"

/// Relative error |p_e - p_gt| / |p_gt| on the predefined motion; absent where the paper prints none.
/// `method` is ceres or eigenLm.
std::optional<double> paperError(Method method, ParameterSet estimated, Quantity quantity, DataKind data);

struct PaperTime {
  double seconds = 0.0;
  bool below = false;  ///< The paper says only "less than".
};

/// Runtime on the predefined motion. The total-least-squares methods saw every tenth sample only.
std::optional<PaperTime> paperTime(Method method, ParameterSet estimated);

}  // namespace heft
