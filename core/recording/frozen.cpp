#include "core/recording/frozen.h"

#include <algorithm>
#include <limits>

#include "core/base/parallel.h"

namespace heft {

namespace {

Changes changesOfColumn(const Eigen::Ref<const VectorXd>& values) {
  constexpr double kOneStep = 1.5;  // Resolutions: between one step and two
  const Eigen::Index steps = std::max<Eigen::Index>(0, values.size() - 1);
  const auto sizes = (values.tail(steps) - values.head(steps)).array().abs();
  double resolution = std::numeric_limits<double>::infinity();
  for (Eigen::Index k = 0; k < steps; ++k)
    if (const double size = sizes.coeff(k); size > 0.0) resolution = std::min(resolution, size);
  Changes changes(static_cast<std::size_t>(values.size()), 1);
  for (Eigen::Index k = 0; k < steps; ++k) {
    const double size = sizes.coeff(k);
    changes[static_cast<std::size_t>(k + 1)] = size > kOneStep * resolution ? 2 : size != 0.0 ? 1 : 0;
  }
  return changes;
}

}  // namespace

std::vector<Changes> changesOfEach(const Eigen::Ref<const MatrixXd>& values) {
  std::vector<Changes> out(static_cast<std::size_t>(values.cols()));
  parallelFor(out.size(), [&](std::size_t c) { out[c] = changesOfColumn(values.col(static_cast<Eigen::Index>(c))); });
  return out;
}

Changes ofAny(const std::vector<Changes>& columns) {
  if (columns.empty()) return {};
  Changes out = columns.front();
  for (const Changes& each : columns)
    std::ranges::transform(out, each, out.begin(), [](char a, char b) { return std::max(a, b); });
  return out;
}

Changes changesOf(const Eigen::Ref<const MatrixXd>& values) { return ofAny(changesOfEach(values)); }

bool everChanges(const Eigen::Ref<const MatrixXd>& values) {
  for (Eigen::Index c = 0; c < values.cols(); ++c)
    for (Eigen::Index k = 1; k < values.rows(); ++k)
      if (values(k, c) != values(k - 1, c)) return true;
  return false;
}

bool everChanges(const Changes& changes) {
  return !changes.empty() && std::any_of(changes.begin() + 1, changes.end(), [](char change) { return change != 0; });
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
  if (postures.rows() == 0 || postures.cols() == 0) return {};
  const Changes changes = changesOf(postures);
  std::vector<FrozenStretch> out = frozenStretches(time, changes, kShortest);
  std::erase_if(out, [&](const FrozenStretch& stretch) { return stretch.to >= postures.rows(); });
  if (out.empty()) return out;
  const auto stepTo = [&](Eigen::Index k) { return (postures.row(k) - postures.row(k - 1)).norm(); };
  std::vector<double> steps;
  for (Eigen::Index k = 1; k < postures.rows(); ++k)
    if (changes[static_cast<std::size_t>(k)] != 0) steps.push_back(stepTo(k));
  const auto ninth = steps.begin() + static_cast<std::ptrdiff_t>(0.9 * static_cast<double>(steps.size() - 1));
  std::nth_element(steps.begin(), ninth, steps.end());
  std::erase_if(out, [&](const FrozenStretch& stretch) { return stepTo(stretch.to) <= kLeap * *ninth; });
  return out;
}

namespace {

/// The value of more than half of the readings, if any has so many (Boyer and Moore 1991).
double majorityOf(const Eigen::Ref<const VectorXd>& readings) {
  double value = 0.0;
  Eigen::Index ahead = 0;
  for (const double reading : readings) {
    if (ahead == 0) value = reading;
    ahead += reading == value ? 1 : -1;
  }
  return value;
}

}  // namespace

std::array<bool, 6> silentChannels(const Eigen::Matrix<double, Eigen::Dynamic, 6>& wrench) {
  constexpr double kHardlyElse = 0.9;
  std::array<bool, 6> out{};
  for (Eigen::Index c = 0; c < 6 && wrench.rows() > 0; ++c) {
    const auto y = wrench.col(c);
    const auto same = (y.array() == majorityOf(y)).count();
    out[static_cast<std::size_t>(c)] = static_cast<double>(same) > kHardlyElse * static_cast<double>(y.size());
  }
  return out;
}

}  // namespace heft
