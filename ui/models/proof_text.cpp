#include "ui/models/proof_text.h"

#include <nlohmann/json.hpp>

#include "ui/models/units.h"

namespace heft {

PageUnits pageUnits() {
  const auto of = [](const ShownUnit& unit) {
    return PageUnits::Unit{unit.name.toStdString(), unit.scale, unit.decimals};
  };
  return {of(massUnit()), of(lengthUnit()), of(torqueUnit())};
}

std::optional<ProofText> describeProof(const std::string& proof, const Payload* now) {
  return proofText(nlohmann::json::parse(proof, nullptr, false), now, pageUnits());
}

}  // namespace heft
