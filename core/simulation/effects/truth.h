#pragma once
// What was asked to be hidden in a simulated recording, and what was hidden.
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/result.h"

namespace heft {

/// One effect to hide: a kind, one of its forms (empty: the kind's first) and its size in the kind's unit.
struct EffectRequest {
  std::string id;
  std::string form;
  double size = 0.0;  ///< 0: nothing at all is hidden.
};

/// "ID=SIZE" or "ID/FORM=SIZE", checked against the kinds that exist and the sizes that they allow.
Result<EffectRequest> parseEffect(std::string_view text);

struct EffectParameter {
  std::string name;  ///< Ends in its unit, for instance "anchor_b_m".
  std::vector<double> values;
};

/// An effect as it acted in one recording.
struct EffectTruth {
  std::string id, form;
  double size = 0.0;
  std::string unit;
  std::vector<EffectParameter> parameters;
  std::vector<std::pair<double, double>> when;  ///< [s]; empty: all the time
};

/// {"effect", "form", "size", "unit", "parameters": {NAME: number or array}, "when": [[from_s, to_s]]}
nlohmann::json toJson(const EffectTruth& truth);

}  // namespace heft
