#pragma once
// What a proof says to a person, from its JSON: in the language of now and in the units that are wanted.
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/payload/inertial_parameters.h"

namespace heft {

/// In which units masses and lengths are shown: the SI value times `scale`, with so many more decimals than in kg, mm.
struct PageUnits {
  struct Unit {
    std::string name;
    double scale;
    int decimals;
  };
  Unit mass{"kg", 1.0, 0}, length{"mm", 1e3, 0}, torque{"N m", 1.0, 0};
};

struct ProofText {
  bool passed = false;
  std::string headline;  ///< "PASS: with these numbers subtracted, only sensor noise remains."
  struct Reason {
    std::string text, remedy;
  };
  std::vector<Reason> reasons;     ///< Unless it passed; the most important first
  std::vector<std::string> facts;  ///< On which recording, what was left, what would have shown
  bool outdated = false;           ///< The numbers are others now.
};

/// Of a heft.prove/1, which may be damaged; nothing if it is none. `now`: the numbers as they stand, or null.
std::optional<ProofText> proofText(const nlohmann::json& proof, const Payload* now, const PageUnits& units = {});

}  // namespace heft
