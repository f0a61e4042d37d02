#include "core/diagnosis/data_quality/time_stamps.h"

#include <algorithm>
#include <cmath>

#include "core/diagnosis/calibration.h"

namespace heft::diagnosis {

namespace {

constexpr Eigen::Index kBlock = 200;  ///< Rows over whose mean lateness comes and goes

/// How far each row lies off the line between its neighbours, as a sum of squares over all columns.
double roughness(const MatrixXd& rows, const VectorXd& time) {
  double sum = 0.0;
  for (Eigen::Index i = 1; i + 1 < rows.rows(); ++i) {
    const double share = (time(i) - time(i - 1)) / (time(i + 1) - time(i - 1));
    sum += (rows.row(i) - (1.0 - share) * rows.row(i - 1) - share * rows.row(i + 1)).squaredNorm();
  }
  return sum;
}

/// Deviation of the means over kBlock rows.
double slowPart(const VectorXd& off) {
  double sum = 0.0;
  const Eigen::Index blocks = std::max<Eigen::Index>(1, off.size() / kBlock), length = off.size() / blocks;
  for (Eigen::Index b = 0; b < blocks; ++b) sum += std::pow(off.segment(b * length, length).mean(), 2);
  return std::sqrt(sum / static_cast<double>(blocks));
}

}  // namespace

std::optional<UnevenStamps> unevenStamps(const Recording& recording) {
  const VectorXd& time = recording.time;
  const Eigen::Index n = time.size();
  const MatrixXd& moved = recording.q.rows() == n ? MatrixXd(recording.q) : MatrixXd(recording.position);
  if (n < 100 || moved.rows() != n) return std::nullopt;
  // The line through (row, stamp).
  const VectorXd row = VectorXd::LinSpaced(n, -0.5 * static_cast<double>(n - 1), 0.5 * static_cast<double>(n - 1));
  const double middle = time.mean(), step = row.dot(time) / row.squaredNorm();
  if (!(step > 0.0)) return std::nullopt;
  UnevenStamps out;
  out.even = (step * row).array() + middle;
  const VectorXd off = time - out.even;
  const double deviation = std::sqrt(off.squaredNorm() / static_cast<double>(n));
  // A real-time logger stays below by far; where such means have more, rows are missing or the clock drifts.
  if (deviation < kTinyShare * step || slowPart(off) > kMajority * deviation) return std::nullopt;
  if (roughness(moved, out.even) > kLargeShare * roughness(moved, time)) return std::nullopt;
  out.spread = off.maxCoeff() - off.minCoeff();
  return out;
}

}  // namespace heft::diagnosis
