#include "core/estimation/smoothing_choice.h"

#include <array>
#include <utility>

#include "core/base/parallel.h"

namespace heft {

Result<Smoothed> onlySmoothed(Result<Prepared> prepared) {
  if (!prepared) return prepared.error();
  return Smoothed{std::move(*prepared), std::nullopt};
}

Result<Smoothed> bestSmoothed(const std::function<Result<Prepared>(double)>& preparedAt, const Progress& progress) {
  // Noise of angles grows in accelerations with the square of the frequency: where a narrower band gains nothing, those
  // narrower still are not asked. Two at a time, as there are two threads.
  constexpr std::array<double, 4> kCutoffs{kDefaultCutoffHz, 12.0, 6.0, 3.0};
  std::array<std::optional<Result<Prepared>>, kCutoffs.size()> prepared;
  const auto prepareTwo = [&](std::size_t from) {
    parallelFor(2, [&](std::size_t i) { prepared[from + i].emplace(preparedAt(kCutoffs[from + i])); });
  };
  prepareTwo(0);
  auto best = onlySmoothed(std::move(*prepared[0]));
  if (!best) return best;
  for (std::size_t i = 1; i < kCutoffs.size(); ++i) {
    if (i == 2) prepareTwo(2);
    if (progress.cancelled()) return Error{"Stopped.", true};
    auto next = std::move(*prepared[i]);
    prepared[i].reset();
    if (!next || advantage(best->prepared, *next) < kWorthSmoothing) break;
    if (!best->widest) best->widest = std::move(best->prepared.blocks);
    best->prepared = std::move(*next);
  }
  return best;
}

}  // namespace heft
