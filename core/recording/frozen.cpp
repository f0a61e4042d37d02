#include "core/recording/frozen.h"

#include <algorithm>
#include <limits>

#include "core/math/statistics.h"

namespace heft {

Changes changesOf(const Eigen::Ref<const MatrixXd>& values) {
  constexpr double kOneStep = 1.5;  // Resolutions: between one step and two
  Changes changes(static_cast<std::size_t>(values.rows()), 0);
  for (Eigen::Index c = 0; c < values.cols(); ++c) {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    const Eigen::Index steps = std::max<Eigen::Index>(0, values.rows() - 1);
    const Eigen::ArrayXd sizes = (values.col(c).tail(steps) - values.col(c).head(steps)).cwiseAbs();
    const double resolution = steps > 0 ? (sizes > 0.0).select(sizes, kNone).minCoeff() : kNone;
    for (Eigen::Index k = 0; k < steps; ++k) {
      const char change = sizes(k) > kOneStep * resolution ? 2 : sizes(k) != 0.0 ? 1 : 0;
      auto& most = changes[static_cast<std::size_t>(k + 1)];
      most = std::max(most, change);
    }
  }
  if (!changes.empty()) changes[0] = 1;
  return changes;
}

bool inSingleSteps(const Changes& changes) {
  constexpr double kMostly = 0.9;
  const auto single = std::ranges::count(changes, char{1}), more = std::ranges::count(changes, char{2});
  return static_cast<double>(single) > kMostly * static_cast<double>(single + more);
}

Eigen::Index countIn(const Changes& changes, Eigen::Index from, Eigen::Index to) {
  return to - from - std::count(changes.begin() + from, changes.begin() + to, char{0});
}

std::vector<FrozenStretch> frozenStretches(const VectorXd& time, const Changes& changes, double shortest) {
  const auto rows = time.size();
  const auto runs = countIn(changes, 0, rows);
  const bool coarse = inSingleSteps(changes);
  std::vector<FrozenStretch> stretches;
  for (Eigen::Index from = 0; from < rows;) {
    auto to = from + 1;
    while (to < rows && changes[static_cast<std::size_t>(to)] == 0) ++to;
    const bool leaps =
        changes[static_cast<std::size_t>(from)] == 2 || (to < rows && changes[static_cast<std::size_t>(to)] == 2);
    const double others = runs > 1 ? static_cast<double>(rows - (to - from)) / static_cast<double>(runs - 1) : 1.0;
    if (to - from >= 10 && time(to - 1) - time(from) >= shortest && static_cast<double>(to - from) >= 20.0 * others &&
        (leaps || !coarse))
      stretches.push_back({from, to});
    from = to;
  }
  return stretches;
}

std::vector<FrozenStretch> frozenAlone(const VectorXd& time, const Changes& channel, const Changes& all) {
  constexpr double kShortest = 0.25;  // [s]
  std::vector<FrozenStretch> out;
  for (const auto& stretch : frozenStretches(time, channel, kShortest))
    if (4 * countIn(all, stretch.from + 1, stretch.to) > stretch.length()) out.push_back(stretch);
  return out;
}

std::vector<FrozenStretch> hungPostures(const VectorXd& time, const Eigen::Ref<const MatrixXd>& postures) {
  constexpr double kShortest = 0.1;  // [s]
  constexpr double kLeap = 10.0;     // Over what nine of ten steps stay below
  const Changes changes = changesOf(postures);
  std::vector<double> steps;
  for (Eigen::Index k = 1; k < postures.rows(); ++k)
    if (changes[static_cast<std::size_t>(k)] != 0) steps.push_back((postures.row(k) - postures.row(k - 1)).norm());
  std::vector<FrozenStretch> out;
  if (steps.empty()) return out;
  const auto ninth = steps.begin() + static_cast<std::ptrdiff_t>(0.9 * static_cast<double>(steps.size() - 1));
  std::nth_element(steps.begin(), ninth, steps.end());
  for (const auto& stretch : frozenStretches(time, changes, kShortest))
    if (stretch.to < postures.rows() &&
        (postures.row(stretch.to) - postures.row(stretch.to - 1)).norm() > kLeap * *ninth)
      out.push_back(stretch);
  return out;
}

std::array<bool, 6> silentChannels(const Eigen::Matrix<double, Eigen::Dynamic, 6>& wrench) {
  constexpr double kHardlyElse = 0.9;
  std::array<bool, 6> out{};
  for (Eigen::Index c = 0; c < 6 && wrench.rows() > 0; ++c) {
    const auto y = wrench.col(c);
    const auto same = (y.array() == median({y.begin(), y.end()})).count();
    out[static_cast<std::size_t>(c)] = static_cast<double>(same) > kHardlyElse * static_cast<double>(y.size());
  }
  return out;
}

}  // namespace heft
