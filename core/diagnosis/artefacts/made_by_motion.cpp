#include "core/diagnosis/artefacts/made_by_motion.h"

#include <algorithm>
#include <array>
#include <limits>

#include "core/base/parallel.h"
#include "core/diagnosis/search/evidence.h"

namespace heft::diagnosis {

namespace {

/// Evidence for `cause` in the work's final model with the motion smoothed as on `way`; infinite where its blocks are
/// others, which tells nothing against the cause.
double gainOn(const Way& way, const Work& work, std::string_view cause) {
  constexpr int kRounds = 6;
  const auto signals = asIn(work, way);
  if (!signals) return std::numeric_limits<double>::infinity();
  const Model& model = work.search.final.model;
  return fitModel(*signals, work.stretches, model, kRounds).evidence -
         fitModel(*signals, work.stretches, without(model, cause), kRounds).evidence;
}

}  // namespace

std::vector<std::string> madeByMotion(const Work& work, const std::vector<Way>& ways, std::size_t at) {
  // Of 18 memories of less than kFaintest, 9 lost more than half: 8 that were wrong, and a right one.
  constexpr double kFaintest = 300.0, kStays = 0.5;
  constexpr std::size_t kSmoothest = 2;
  if (at + kSmoothest >= ways.size()) return {};
  const auto goes = [&](const Found& found) {
    if (found.gain > kFaintest) return false;
    std::array<double, kSmoothest> gains{};
    onTwoThreads(kSmoothest, [&](std::size_t i) { gains[i] = gainOn(ways[ways.size() - 1 - i], work, found.cause); });
    return *std::ranges::max_element(gains) < kStays * found.gain;
  };
  const auto& found = work.search.found;
  const auto memory = std::ranges::find(found, "hysteresis", &Found::cause);
  if (memory == found.end() || !goes(*memory)) return {};
  std::vector<std::string> out{memory->cause};
  for (const Found& other : found)
    if (lags(other.cause) && goes(other)) out.push_back(other.cause);
  return out;
}

}  // namespace heft::diagnosis
