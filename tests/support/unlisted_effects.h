#pragma once
// Faults that no catalogue lists, for tests of the answer "structured, but unknown".
#include "core/simulation/effects/effect.h"

namespace heft::test {

/// As an EffectKind, but out of reach of programs. SIZE is linear in what the sensor shows.
struct UnlistedKind {
  std::string id;
  double typical;
  std::vector<std::string> relatives;  ///< Cause IDs that would be a fair near answer.
  std::function<std::unique_ptr<Effect>(const EffectSetup&)> make;
};

/// magnet: pulls at the tool with 1 / distance^3. temperature_wave: the zero swings with the room's heating.
/// backlash_torque: a torque whose sign follows the side on which a wrist joint's gear lies. angle_ripple: a torque
/// that ripples with a joint's angle. squared_load: one axis sees the product of two others.
const std::vector<UnlistedKind>& unlistedKinds();

/// As makeEffects does, for one unlisted effect.
std::unique_ptr<Effect> makeUnlisted(const UnlistedKind& kind, double size, std::uint64_t seed,
                                     const EffectScene& scene);

}  // namespace heft::test
