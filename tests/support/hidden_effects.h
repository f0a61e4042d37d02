#pragma once
// Recordings with hidden faults for tests of the diagnosis: what is hidden is drawn at random from a seed and kept
// apart from the recording.
//
// "Visible" is measured, not assumed: the size at which what is left of the effect after payload and bias have been
// refitted, over the whole recording, is kVisibleSigma times the noise (white and coloured, as of a matched filter).
#include <nlohmann/json_fwd.hpp>

#include "core/recording/recording.h"
#include "core/simulation/simulate.h"

namespace heft::test {

constexpr double kVisibleSigma = 20.0;

enum class HiddenCase {
  clean,     ///< Nothing; the noise as usual, white, coloured or doubled.
  walking,   ///< Nothing, but the zero walks at random.
  single,    ///< One effect in its plain form.
  variant,   ///< One effect in a form that a simple model does not match.
  pair,      ///< Two effects of unlike kinds.
  unlisted,  ///< One effect that no catalogue has.
  triple,    ///< Three effects of unlike kinds.
};
inline constexpr HiddenCase kHiddenCases[] = {HiddenCase::clean,   HiddenCase::walking, HiddenCase::single,
                                              HiddenCase::variant, HiddenCase::pair,    HiddenCase::unlisted,
                                              HiddenCase::triple};
std::string_view toString(HiddenCase kind);

struct HiddenTruth {
  HiddenCase kind = HiddenCase::clean;
  std::uint64_t seed = 0;
  std::string noise;      ///< "usual", "white", "coloured", "doubled", "walking"
  double multiple = 1.0;  ///< Size over the visible one.
  SimulationTruth simulation;
  std::vector<std::string> ids;        ///< What is hidden, in the order of the chain.
  std::vector<std::string> relatives;  ///< Fair near answers to an unlisted effect.
  bool touches = false;                ///< The task touches things: contact is no answer.
};

struct HiddenRecording {
  Recording recording;
  HiddenTruth truth;
};

/// Same case and seed, same bytes. `multiple` 0: drawn from 1, 2 and 4. `id` empty: the kind is drawn too.
/// Throws std::runtime_error for an unknown kind.
HiddenRecording drawHidden(HiddenCase kind, std::uint64_t seed, double multiple = 0.0, const std::string& id = {});

/// What a file beside the recording may say.
nlohmann::json toJson(const HiddenTruth& truth);

/// The same from a file, with what a judgement of an answer needs: case, size, noise, IDs, relatives and payload.
Result<HiddenTruth> hiddenTruthFromJson(const nlohmann::json& json, const std::string& where);

/// What is left of the request's effect after a refit of payload and bias, in standard deviations of the noise.
double misfit(const Payload& payload, const SimulateOptions& options, const EffectRequest& request);

/// IDs that single cases draw from: all but those that a refit swallows.
std::vector<std::string> hideableIds();

}  // namespace heft::test
