#pragma once
// Recordings to practise on: each hides one fault of the rig, drawn from its number.
#include "core/simulation/simulate.h"

namespace heft {

/// The kinds that are hidden, by ID: those that a person can learn to see in the plots.
const std::vector<std::string>& practiceKinds();

/// What the recording with this number hides; the same number, the same fault.
EffectRequest practiceEffect(std::uint64_t seed);

/// 15 s of the Panda with a simulated sensor and that fault.
Result<Simulated> practiceRecording(std::uint64_t seed, const Progress& progress = {});

/// Its clean twin: the same tool, motion and sensor without the fault.
Result<Simulated> practiceTwin(std::uint64_t seed, const Progress& progress = {});

}  // namespace heft
