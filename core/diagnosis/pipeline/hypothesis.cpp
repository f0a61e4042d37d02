#include "core/diagnosis/pipeline/hypothesis.h"

namespace heft::diagnosis {

std::optional<Signals> asIn(const Hypothesis& hypothesis, const SmoothingCandidate& candidate) {
  if (candidate.signals.blocks() != hypothesis.signals.blocks()) return std::nullopt;
  return candidate.signals;
}

}  // namespace heft::diagnosis
