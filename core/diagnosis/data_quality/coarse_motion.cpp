#include "core/diagnosis/data_quality/coarse_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/base/stop.h"
#include "core/diagnosis/calibration.h"
#include "core/math/statistics.h"
#include "core/recording/steps.h"

namespace heft::diagnosis {

namespace {

/// What is recorded of the motion, a row an instant; steps and corners need not know in which unit.
MatrixXd motionColumns(const Recording& recording) {
  if (recording.q.rows() > 0) return recording.q;
  MatrixXd out = MatrixXd::Zero(recording.rows(), recording.position.cols() + recording.quaternion.cols());
  if (recording.position.rows() > 0) out.leftCols(recording.position.cols()) = recording.position;
  if (recording.quaternion.rows() > 0) out.rightCols(recording.quaternion.cols()) = recording.quaternion;
  return out;
}

/// [s] From corner to corner where the columns are straight lines, as regular as what was interpolated is; else 0.
double cornersEvery(const MatrixXd& columns, double rateHz) {
  constexpr double kCorner = 20.0;  // Times the usual bend from row to row
  const Eigen::Index n = columns.rows();
  if (n < 3) return 0.0;
  std::vector<double> bends;
  Eigen::Index moves = 0;
  for (Eigen::Index i = 1; i + 1 < n; ++i) {
    bends.push_back((columns.row(i + 1) - 2.0 * columns.row(i) + columns.row(i - 1)).norm());
    moves += columns.row(i) == columns.row(i - 1) ? 0 : 1;
  }
  if (static_cast<double>(moves) < kMajority * static_cast<double>(n)) return 0.0;
  const double corner = kCorner * median(bends);
  std::vector<double> corners, apart;
  for (std::size_t i = 0; i < bends.size(); ++i)
    if (bends[i] > corner && (corners.empty() || static_cast<double>(i) > corners.back() + 2.0))
      corners.push_back(static_cast<double>(i));
  if (std::cmp_less(corners.size(), kFewestSamples)) return 0.0;
  for (std::size_t i = 1; i < corners.size(); ++i) apart.push_back(corners[i] - corners[i - 1]);
  const double usual = median(apart);
  const auto regular = std::ranges::count_if(
      apart, [&](double rows) { return std::abs(rows - usual * std::max(1.0, std::round(rows / usual))) < 1.5; });
  if (static_cast<double>(regular) <= kLargeShare * static_cast<double>(apart.size())) return 0.0;
  const double every = usual / rateHz;
  return every > kShortestGap ? every : 0.0;
}

/// The coarsest step of a few columns; 0 where none is regular.
double coarsestOf(const MatrixXd& columns) {
  double out = 0.0;
  for (Eigen::Index c = 0; c < columns.cols(); ++c) {
    stopPoint();
    out = std::max(out, stepOf({columns.col(c).begin(), columns.col(c).end()}).value_or(0.0));
  }
  return out;
}

}  // namespace

std::optional<CoarseMotion> coarseMotion(const Recording& recording) {
  CoarseMotion out;
  if (recording.rateHz() > 0.0) out.every = cornersEvery(motionColumns(recording), recording.rateHz());
  if (recording.q.rows() > 0)
    out.stepAngle = coarsestOf(recording.q);
  else
    out.stepPlace = coarsestOf(recording.position);
  if (out.stepAngle < kFineMotion) out.stepAngle = 0.0;
  if (out.stepPlace < kFineMotion) out.stepPlace = 0.0;
  if (out.every > 0.0 || out.stepAngle > 0.0 || out.stepPlace > 0.0) return out;
  return std::nullopt;
}

}  // namespace heft::diagnosis
