#include "core/recording/held.h"

#include <algorithm>
#include <cstdlib>

#include "core/recording/wrench_runs.h"

namespace heft {

HeldValues heldValues(const VectorXd& time, const Eigen::Matrix<double, Eigen::Dynamic, 6>& wrench) {
  constexpr std::size_t kFewest = 20;  // Readings
  constexpr double kRegular = 0.9;
  std::vector<Eigen::Index> starts;
  for (const auto& run : wrenchRuns(wrench)) starts.push_back(run.first);
  if (starts.size() < kFewest) return {};
  std::vector<Eigen::Index> lengths;
  for (std::size_t i = 1; i < starts.size(); ++i) lengths.push_back(starts[i] - starts[i - 1]);
  std::vector<Eigen::Index> ordered = lengths;
  std::nth_element(ordered.begin(), ordered.begin() + static_cast<std::ptrdiff_t>(ordered.size() / 2), ordered.end());
  const Eigen::Index usual = ordered[ordered.size() / 2];
  const auto alike = std::ranges::count_if(lengths, [&](Eigen::Index n) { return std::abs(n - usual) <= 1; });
  if (usual < 2 || static_cast<double>(alike) < kRegular * static_cast<double>(lengths.size())) return {};
  HeldValues out;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const Eigen::Index readings = std::max<Eigen::Index>(1, (lengths[i] + usual / 2) / usual);
    for (Eigen::Index j = 0; j < readings; ++j) out.rows.push_back(starts[i] + j * lengths[i] / readings);
  }
  out.rows.push_back(starts.back());
  out.period = (time(out.rows.back()) - time(out.rows.front())) / static_cast<double>(out.rows.size() - 1);
  return out;
}

}  // namespace heft
