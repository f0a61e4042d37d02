#include "core/diagnosis/artefacts/made_by_motion.h"

#include <algorithm>
#include <array>
#include <limits>

#include "core/base/parallel.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/search/evidence.h"

namespace heft::diagnosis {

namespace {

/// Evidence for `cause` in the work's final model with the motion smoothed as on `candidate`; infinite where its blocks
/// are others, which tells nothing against the cause.
double gainOn(const SmoothingCandidate& candidate, const Hypothesis& hypothesis, std::string_view cause) {
  constexpr int kRounds = 6;
  const auto signals = asIn(hypothesis, candidate);
  if (!signals) return std::numeric_limits<double>::infinity();
  const Model& model = hypothesis.search.final.model;
  return fitModel(*signals, hypothesis.stretches, model, kRounds).evidence -
         fitModel(*signals, hypothesis.stretches, without(model, cause), kRounds).evidence;
}

}  // namespace

std::vector<std::string> motionArtefacts(const Hypothesis& hypothesis,
                                         const std::vector<SmoothingCandidate>& candidates, std::size_t at) {
  constexpr std::size_t kSmoothest = 2;
  if (at + kSmoothest >= candidates.size()) return {};
  const auto goes = [&](const Found& found) {
    if (found.gain > kOverwhelming) return false;
    std::array<double, kSmoothest> gains{};
    parallelFor(kSmoothest, [&](std::size_t i) {
      gains[i] = gainOn(candidates[candidates.size() - 1 - i], hypothesis, found.cause);
    });
    return *std::ranges::max_element(gains) < kMajority * found.gain;
  };
  const auto& found = hypothesis.search.found;
  const auto memory = std::ranges::find(found, ids::hysteresis, &Found::cause);
  if (memory == found.end() || !goes(*memory)) return {};
  std::vector<std::string> out{memory->cause};
  for (const Found& other : found)
    if (lags(other.cause) && goes(other)) out.push_back(other.cause);
  return out;
}

}  // namespace heft::diagnosis
