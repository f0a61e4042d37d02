#pragma once
// The text of a setup file, and changing single keys of one without losing what else a person wrote into it.
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/base/result.h"
#include "core/recording/recording.h"

namespace heft {

/// What the setup file says, with `changes` on top (a JSON merge patch: null takes a key away). The changes alone where
/// there is no such file yet; an error where it is none.
Result<nlohmann::json> mergedMeta(const std::filesystem::path& file, const nlohmann::json& changes);

/// What writeMeta() writes to `file`; an error where a text in it is no UTF-8.
Result<std::string> metaText(const RecordingMeta& meta, const std::filesystem::path& file);

/// {"parent", "xyz_m", "rpy_rad"}
nlohmann::json toJson(const SensorMount& mount);

}  // namespace heft
