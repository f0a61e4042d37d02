#pragma once
// The catalogue of causes.
#include <memory>
#include <string_view>
#include <vector>

#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/model/cause.h"

namespace heft::diagnosis {

/// A zero that wanders at random: part of the catalogue so that it competes with the others, but never a verdict.
inline constexpr std::string_view kRandomWalk = ids::wandering;

/// All causes that are fitted to the residual, in the order of the contract, and what registerCause() added.
const std::vector<std::unique_ptr<Cause>>& catalogue();
/// Causes that only show in single readings or their stamps.
const std::vector<std::unique_ptr<Cause>>& seenDirectly();
/// Of both; null for an unknown name.
const Cause* findCause(std::string_view id);
/// Of both; no title and no family's rules for an unknown name.
const CauseInfo& infoOf(std::string_view id);

/// A cause of one's own, from now on looked for with the others. Not while anything is diagnosed.
void registerCause(std::unique_ptr<Cause> cause);

}  // namespace heft::diagnosis
