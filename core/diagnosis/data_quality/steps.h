#pragma once
// Readings that come in steps.
#include <optional>
#include <vector>

namespace heft::diagnosis {

/// The step of which all readings lie whole numbers apart, as a coarse converter leaves them, in their unit. None where
/// they do not, or where fewer than four of them differ.
std::optional<double> stepOf(std::vector<double> readings);

}  // namespace heft::diagnosis
