#pragma once
// Changing single keys of a meta file without losing what else a person wrote into it.
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/base/result.h"

namespace heft {

/// What the meta file says, with `changes` on top (a JSON merge patch: null takes a key away). The changes alone where
/// there is no such file yet; an error where it is none.
Result<nlohmann::json> mergedMeta(const std::filesystem::path& file, const nlohmann::json& changes);

}  // namespace heft
