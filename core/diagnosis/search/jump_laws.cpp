#include "core/diagnosis/search/jump_laws.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/diagnosis/calibration.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/search/search.h"

namespace heft::diagnosis {

namespace {

/// Times [s] and sizes of the jumps of a channel's zero.
std::vector<std::pair<double, double>> jumpsOf(const Model& model, Eigen::Index channel) {
  std::vector<std::pair<double, double>> out;
  for (const Term& term : model.terms)
    if (causeOf(term) == ids::sensorBias && term.v(1 + channel) != 0.0)
      out.emplace_back(term.v(0), term.v(1 + channel));
  return out;
}

}  // namespace

bool jumpWithTheirReading(const Signals& signals, const Model& model) {
  if (std::ranges::count_if(model.terms, [](const Term& t) { return causeOf(t) == ids::sensorBias; }) < 2) return false;
  const Wrenches reads = valueOf(signals, without(model, ids::sensorBias));
  const Eigen::Index blocks = signals.blocks(),
                     around = std::max<Eigen::Index>(1, std::lround(kMoment * signals.blockRate()));
  for (Eigen::Index c = 0; c < 6; ++c) {
    const auto jumps = jumpsOf(model, c);
    if (jumps.size() < 2) continue;
    const double near = kTinyShare * (reads.row(c).maxCoeff() - reads.row(c).minCoeff());
    double least = 1e300, most = -1e300;
    std::ptrdiff_t upward = 0;
    for (const auto& [time, size] : jumps) {
      Eigen::Index at = 0;
      while (at + 1 < blocks && signals.blockTime(at + 1) <= time) ++at;
      const Eigen::Index before = std::max<Eigen::Index>(0, at - around), after = std::min(blocks - 1, at + around);
      least = std::min(least, reads(c, at));
      most = std::max(most, reads(c, at));
      upward += (reads(c, after) - reads(c, before)) * size > 0.0 ? 1 : 0;
    }
    if (most - least > near || (upward != 0 && upward != std::ssize(jumps))) continue;
    // It passes there at no other time.
    const double level = 0.5 * (least + most);
    std::size_t passes = 0;
    bool above = reads(c, 0) > level;
    for (Eigen::Index n = 1; n < blocks; ++n)
      if (above ? reads(c, n) < level - near : reads(c, n) > level + near) {
        above = !above;
        ++passes;
      }
    if (passes == jumps.size()) return true;
  }
  return false;
}

}  // namespace heft::diagnosis
