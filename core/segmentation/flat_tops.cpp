#include "core/segmentation/flat_tops.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/base/parallel.h"
#include "core/base/stop.h"
#include "core/recording/wrench_runs.h"

namespace heft {

namespace {

constexpr double kBeyond = 0.02;  ///< Share of readings that may be spikes
/// A pile: so many readings, so many times as many as at any of the nearest values. The more there are, the less it
/// takes.
struct Pile {
  Eigen::Index fewest;
  double times;
  std::size_t neighbours;
};
constexpr std::size_t kNeighbours = 3;  ///< At most
constexpr Pile kPiles[] = {{8, 4.0, kNeighbours}, {40, 2.0, 1}};
constexpr double kZero = 0.01;  ///< Of what the channel reads: a level so close to zero is none
constexpr double kStill =
    0.5;  ///< Share of readings like the one before: from there on steps are coarser than the noise
constexpr std::size_t kFewLevels = 4;  ///< A channel that has no more is as coarse as that, and cut off nowhere

/// Whether the channel's readings take no more values than that: told by the first few of any finer one.
bool hasFewLevels(const std::vector<double>& values) {
  std::vector<double> known;
  for (const double value : values) {
    if (std::find(known.begin(), known.end(), value) != known.end()) continue;
    known.push_back(value);
    if (known.size() > kFewLevels) return false;
  }
  return true;
}

struct Level {
  double value;
  Eigen::Index count;
};

/// The values from that end on which `further` puts first, level by level: as far as spikes may lie, and the neighbours
/// of what comes next. Only those are sorted, so `values` change their order.
template <class Further>
std::vector<Level> levelsFromEnd(std::vector<double>& values, const Further& further) {
  const double spikes = kBeyond * static_cast<double>(values.size());
  std::vector<Level> out;
  double taken = 0.0;
  stopPoint();
  std::size_t neighbours = kNeighbours;
  auto sorted = values.begin();
  for (auto at = values.begin(); at != values.end(); ++at, taken += 1.0) {
    if (at == sorted) {  // As many again, and at first what may be spikes
      const auto more = std::max<std::ptrdiff_t>(sorted - values.begin(), static_cast<std::ptrdiff_t>(spikes) + 100);
      sorted = values.end() - at > more ? at + more : values.end();
      std::nth_element(at, sorted, values.end(), further);
      std::sort(at, sorted, further);
    }
    if (out.empty() || out.back().value != *at) {
      if (taken > spikes && neighbours-- == 0) break;
      out.push_back({*at, 0});
    }
    ++out.back().count;
  }
  return out;
}

/// Index of the level that readings pile up at, from the front of `levels`, which is the channel's end; or none: -1.
Eigen::Index pileAt(const std::vector<Level>& levels, Eigen::Index readings) {
  Eigen::Index beyond = 0;
  for (std::size_t i = 0; i + 1 < levels.size(); ++i) {
    for (const Pile& pile : kPiles) {
      Eigen::Index beside = beyond;
      for (std::size_t j = i + 1; j < levels.size() && j <= i + pile.neighbours; ++j)
        beside = std::max(beside, levels[j].count);
      if (levels[i].count >= pile.fewest &&
          static_cast<double>(levels[i].count) > pile.times * static_cast<double>(beside))
        return static_cast<Eigen::Index>(i);
    }
    beyond += levels[i].count;
    if (static_cast<double>(beyond) > kBeyond * static_cast<double>(readings)) break;
  }
  return -1;
}

}  // namespace

namespace {

/// Of one channel. `fresh`: the rows that count.
std::vector<FlatTop> flatTopsOf(int channel, const Eigen::Ref<const Eigen::VectorXd>& y,
                                const std::vector<Eigen::Index>& fresh) {
  std::vector<FlatTop> out;
  std::vector<double> values;
  values.reserve(fresh.size());
  for (const Eigen::Index i : fresh) values.push_back(y(i));
  if (hasFewLevels(values)) return out;
  std::vector<double> ends;
  std::vector<double> reordered = values;
  for (const auto& levels : {levelsFromEnd(reordered, std::greater<>{}), levelsFromEnd(reordered, std::less<>{})})
    if (const auto at = pileAt(levels, static_cast<Eigen::Index>(fresh.size())); at >= 0)
      ends.push_back(levels[static_cast<std::size_t>(at)].value);
  // Both ends at once is where a channel stands that hardly changes.
  if (ends.size() == 2 && ends.front() == ends.back()) return out;
  for (const double end : ends) {
    FlatTop found{channel, end, {}};
    if (std::abs(found.level) < kZero * (y.maxCoeff() - y.minCoeff())) continue;
    double still = 0.0, elsewhere = 0.0;
    for (std::size_t i = 1; i < values.size(); ++i) {
      if (std::find(ends.begin(), ends.end(), values[i]) != ends.end()) continue;
      elsewhere += 1.0;
      still += values[i] == values[i - 1] ? 1.0 : 0.0;
    }
    if (still >= kStill * elsewhere) continue;
    for (Eigen::Index i = 0; i < y.size(); ++i) {
      if (y(i) != found.level) continue;
      if (!found.runs.empty() && found.runs.back().second == i)
        ++found.runs.back().second;
      else
        found.runs.push_back({i, i + 1});
    }
    out.push_back(std::move(found));
  }
  return out;
}

}  // namespace

std::vector<FlatTop> flatTops(const Eigen::Matrix<double, Eigen::Dynamic, 6>& wrench) {
  std::vector<Eigen::Index> fresh;
  for (const auto& [from, to] : wrenchRuns(wrench))
    if (!wrench.row(from).isZero(0.0)) fresh.push_back(from);
  std::vector<FlatTop> out;
  if (fresh.size() < 20) return out;
  std::array<std::vector<FlatTop>, 6> found;
  parallelFor(6, [&](std::size_t c) {
    found[c] = flatTopsOf(static_cast<int>(c), wrench.col(static_cast<Eigen::Index>(c)), fresh);
  });
  for (auto& of : found) out.insert(out.end(), of.begin(), of.end());
  return out;
}

std::array<bool, 6> mostlyCutOff(const std::vector<FlatTop>& tops, Eigen::Index rows) {
  std::array<Eigen::Index, 6> cut{};
  for (const FlatTop& top : tops)
    for (const auto& [from, to] : top.runs) cut[static_cast<std::size_t>(top.channel)] += to - from;
  std::array<bool, 6> out{};
  for (std::size_t c = 0; c < 6; ++c) out[c] = 2 * cut[c] > rows;
  return out;
}

}  // namespace heft
