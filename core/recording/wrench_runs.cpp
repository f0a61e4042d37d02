#include "core/recording/wrench_runs.h"

namespace heft {

Runs wrenchRuns(const Eigen::Matrix<double, Eigen::Dynamic, 6>& wrench) {
  Runs out;
  for (Eigen::Index i = 0; i < wrench.rows(); ++i) {
    if (i == 0 || wrench.row(i) != wrench.row(i - 1)) out.push_back({i, i});
    out.back().second = i + 1;
  }
  return out;
}

void straightOver(const Runs& runs, const Eigen::VectorXd& time, Eigen::Ref<Eigen::MatrixXd> readings) {
  for (const auto& [from, to] : runs) {
    if (from == 0 || to == readings.rows()) continue;
    const double start = time(from - 1), lasts = time(to) - start;
    for (Eigen::Index i = from; i < to; ++i) {
      const double share = (time(i) - start) / lasts;
      readings.row(i) = (1.0 - share) * readings.row(from - 1) + share * readings.row(to);
    }
  }
}

}  // namespace heft
