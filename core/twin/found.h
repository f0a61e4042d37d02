#pragma once
// The file that `heft diagnose --json` wrote, as far as a twin is made from it.
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace heft {

/// The cause of this ID in a heft.diagnose/1; null where it was not found.
const nlohmann::json* findCauseIn(const nlohmann::json& found, const std::string& id);

/// What keeps `found`, read from the file `where`, from being used: it is no heft.diagnose/1, or it does not name a
/// cause of `without`. Nothing where all is well.
std::optional<Error> whatIsMissing(const nlohmann::json& found, const std::string& where,
                                   const std::vector<std::string>& without);

}  // namespace heft
