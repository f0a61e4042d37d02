#pragma once
// What a proof of exported numbers says, in the units shown.
#include <optional>
#include <string>

#include "core/compensation/proof_words.h"

namespace heft {

/// The units of the window, for core's pages.
PageUnits pageUnits();

/// Of a heft.prove/1 as JSON text; nothing if it is none. `now`: the numbers as they stand, or null.
std::optional<ProofText> describeProof(const std::string& proof, const Payload* now);

}  // namespace heft
