#pragma once
// The catalogue of causes.
#include <memory>
#include <string_view>
#include <vector>

#include "core/diagnosis/model/cause.h"

namespace heft::diagnosis {

/// A zero that wanders at random: part of the catalogue so that it competes with the others, but never a verdict.
inline constexpr std::string_view kWandering = "wandering";

/// All causes that are fitted to the residual, in the order of the contract.
const std::vector<std::unique_ptr<Cause>>& catalogue();
/// Null for an unknown name.
const Cause* findCause(std::string_view id);

}  // namespace heft::diagnosis
