#include "app/cli/twin_recording.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/cli/cli.h"
#include "core/base/json_file.h"
#include "core/twin/twin.h"

namespace heft::cli {

Simulated simulateLike(const LikeArguments& like, const SimulateOptions& simulate,
                       const std::optional<Payload>& payload, const Progress& progress, std::string& said) {
  const nlohmann::json found = orFail(readJsonFile(like.file));
  Twin twin = orFail(
      simulateTwin(found, like.file, RobotModel::panda(), {simulate, like.without, like.fixed, payload}, progress));
  for (const auto& effect : twin.simulated.truth.effects) {
    said += fmt::format("  {}", effect.id);
    for (const auto& parameter : effect.parameters)
      if (parameter.values.size() == 1) said += fmt::format("  {} {:.4g}", parameter.name, parameter.values.front());
    said += "\n";
  }
  for (const auto& cause : twin.causes)
    if (!cause.simulated) said += fmt::format("  {} is left out: {}\n", cause.id, cause.why);
  return std::move(twin.simulated);
}

}  // namespace heft::cli
