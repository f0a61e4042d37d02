#include "core/segmentation/wrench_runs.h"

namespace heft {

std::vector<std::pair<Eigen::Index, Eigen::Index>> wrenchRuns(const Eigen::Matrix<double, Eigen::Dynamic, 6>& wrench) {
  std::vector<std::pair<Eigen::Index, Eigen::Index>> out;
  for (Eigen::Index i = 0; i < wrench.rows(); ++i) {
    if (i == 0 || wrench.row(i) != wrench.row(i - 1)) out.push_back({i, i});
    out.back().second = i + 1;
  }
  return out;
}

}  // namespace heft
