#pragma once
// The one page of a tool's passport, for the window's paper and for programs without a window.
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/compensation/proof_words.h"

namespace heft {

/// "Payload passport: Gripper 3"
std::string passportTitle(const nlohmann::json& passport);

/// HTML of a heft.passport/1 of passportOf(), in the language of now ("en", "de": for the document's own mark).
std::string passportPage(const nlohmann::json& passport, const PageUnits& units = {},
                         const std::string& language = "en");

/// The same in short, as lines for a terminal: mass, proof, causes, what has changed.
std::string passportText(const nlohmann::json& passport);

}  // namespace heft
