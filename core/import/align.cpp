#include "core/import/align.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/math/linear_algebra.h"
#include "core/math/statistics.h"

namespace heft {

namespace {

constexpr double kCoarseStep = 0.05;   ///< [s]
constexpr double kFineStep = 0.004;    ///< [s]
constexpr double kSmoothing = 0.1;     ///< [s] Both are averaged over it: what interpolation takes away is then gone.
constexpr double kLeastOverlap = 0.5;  ///< Of the shorter recording.
constexpr double kGridError = 5e-4;    ///< [s] What is left at offsets that are known, rms of 16 motions.
constexpr double kFarAway = 0.5;       ///< [s] Another peak, not the same one's flank.
constexpr double kLeftUnexplained = 5.0;  ///< So many times more at every other offset
constexpr double kLeastSpan = 8.0;        ///< [s] In less any two smooth motions look alike.

/// Uniform samples of some channels.
struct Track {
  double start = 0.0;
  double step = 1.0;
  MatrixXd values;

  double end() const { return start + step * static_cast<double>(values.cols() - 1); }
  Vector3d at(double time) const {  // of three
    const double position = std::clamp((time - start) / step, 0.0, static_cast<double>(values.cols() - 1));
    const auto below = std::min<Eigen::Index>(static_cast<Eigen::Index>(position), values.cols() - 2);
    const double share = position - static_cast<double>(below);
    return (1.0 - share) * values.col(below) + share * values.col(below + 1);
  }
};

struct Fit {
  double explained = 0.0;
  Eigen::Index samples = 0;
  MatrixXd map;  ///< From the motion's channels and a constant to the force's.
};

/// Share of the force's variance in [from, to] of the motion's time that the motion explains, the force being `offset`
/// late; by a map of its own, or one that is given.
Fit fitAt(const Track& motion, const Track& force, double offset, double from, double to,
          const MatrixXd* given = nullptr) {
  const Eigen::Index columns = motion.values.rows() + 1;
  MatrixXd gram = MatrixXd::Zero(columns, columns);
  MatrixXd product = MatrixXd::Zero(columns, 3);
  Vector3d sum = Vector3d::Zero();
  double squares = 0.0;
  Fit fit;
  const double first = std::max({from, motion.start, force.start + offset});
  const double last = std::min({to, motion.end(), force.end() + offset});
  const auto k0 = static_cast<Eigen::Index>(std::ceil((first - motion.start) / motion.step - 1e-9));
  const auto k1 = static_cast<Eigen::Index>(std::floor((last - motion.start) / motion.step + 1e-9));
  VectorXd x(columns);
  for (Eigen::Index k = std::max<Eigen::Index>(k0, 0); k <= std::min(k1, motion.values.cols() - 1); ++k) {
    x << motion.values.col(k), 1.0;
    const Vector3d y = force.at(motion.start + static_cast<double>(k) * motion.step - offset);
    gram += x * x.transpose();
    product += x * y.transpose();
    sum += y;
    squares += y.squaredNorm();
    ++fit.samples;
  }
  if (fit.samples < 20) return fit;
  const double total = squares - sum.squaredNorm() / static_cast<double>(fit.samples);
  gram.diagonal().array() += 1e-9 * gram.trace();  // a motion about one axis only
  fit.map = given ? *given : SymmetricSolver(gram).solveAll(product);
  const double residual =
      squares - 2.0 * product.cwiseProduct(fit.map).sum() + (gram * fit.map).cwiseProduct(fit.map).sum();
  if (total > 1e-12) fit.explained = std::clamp(1.0 - residual / total, 0.0, 1.0);
  return fit;
}

Track thinned(const Track& track, double step) {
  const auto block = std::max<Eigen::Index>(1, std::lround(step / track.step));
  Track out;
  out.step = track.step * static_cast<double>(block);
  out.start = track.start + 0.5 * track.step * static_cast<double>(block - 1);
  out.values.resize(track.values.rows(), std::max<Eigen::Index>(track.values.cols() / block, 0));
  for (Eigen::Index k = 0; k < out.values.cols(); ++k)
    out.values.col(k) = track.values.middleCols(k * block, block).rowwise().mean();
  return out;
}

/// Offset of the best fit near `centre`, refined by a parabola.
double refine(const Track& motion, const Track& force, double centre, double reach, double from, double to,
              const MatrixXd* map = nullptr) {
  std::vector<double> explained;
  const auto half = static_cast<int>(std::ceil(reach / kFineStep));
  for (int i = -half; i <= half; ++i)
    explained.push_back(fitAt(motion, force, centre + kFineStep * i, from, to, map).explained);
  const auto best = static_cast<int>(std::max_element(explained.begin(), explained.end()) - explained.begin());
  double shift = 0.0;
  if (best > 0 && best + 1 < static_cast<int>(explained.size())) {
    const auto at = [&](int i) { return explained[static_cast<std::size_t>(i)]; };
    const double bend = at(best - 1) - 2.0 * at(best) + at(best + 1);
    if (bend < 0.0) shift = 0.5 * (at(best - 1) - at(best + 1)) / bend;
  }
  return centre + kFineStep * (best - half + shift);
}

}  // namespace

double accelerometerDelay(const VectorXd& time, const Eigen::Ref<const Eigen::MatrixX3d>& readings,
                          const VectorXd& forceTime, const Eigen::Ref<const Eigen::MatrixX3d>& force) {
  constexpr double kReach = 0.05, kStep = 0.001;  // [s]
  constexpr double kClearlyLess = 0.9;
  const auto within = [&](double t) {
    return t - kReach >= forceTime(0) && t + kReach <= forceTime(forceTime.size() - 1);
  };
  std::vector<Eigen::Index> rows;
  std::vector<double> steps;
  for (Eigen::Index k = 0; k < time.size(); ++k) {
    if (within(time(k))) rows.push_back(k);
    if (k > 0) steps.push_back(time(k) - time(k - 1));
  }
  if (rows.size() < 100) return 0.0;
  const double width = median(std::move(steps));
  MatrixXd A(static_cast<Eigen::Index>(rows.size()), 4);
  A.leftCols<3>() = readings(rows, Eigen::all);
  A.col(3).setOnes();
  const VectorXd at = time(rows);
  const Eigen::Matrix4d normal = A.transpose() * A + 1e-9 * Eigen::Matrix4d::Identity();
  const Eigen::LDLT<Eigen::Matrix4d> solver(normal);
  const auto leftAt = [&](double delay) {
    MatrixXd y = averageAt(forceTime, force, at.array() + delay, width);
    y.rowwise() -= y.colwise().mean().eval();
    const Eigen::Matrix<double, 4, 3> product = A.transpose() * y;
    const Eigen::Matrix<double, 4, 3> map = solver.solve(product);
    return y.squaredNorm() - product.cwiseProduct(map).sum();
  };
  std::vector<double> left;
  const int each = static_cast<int>(std::lround(kReach / kStep)) - static_cast<int>(std::ceil(0.5 * width / kStep));
  for (int i = -each; i <= each; ++i) left.push_back(leftAt(kStep * i));
  if (each < 2) return 0.0;
  const auto best = std::min_element(left.begin(), left.end()) - left.begin();
  if (best == 0 || best == 2 * each ||
      left[static_cast<std::size_t>(best)] > kClearlyLess * left[static_cast<std::size_t>(each)])
    return 0.0;
  const double a = left[static_cast<std::size_t>(best - 1)], b = left[static_cast<std::size_t>(best)],
               c = left[static_cast<std::size_t>(best + 1)];
  const double curve = a - 2.0 * b + c;
  return kStep * (static_cast<double>(best - each) + (curve > 0.0 ? 0.5 * (a - c) / curve : 0.0));
}

MatrixXd averageAt(const VectorXd& time, const Eigen::Ref<const MatrixXd>& values, const VectorXd& at, double width) {
  const auto last = time.size() - 1;
  // Running integral of the values between samples.
  MatrixXd integral;
  if (width > 0.0) {
    integral = MatrixXd::Zero(values.rows(), values.cols());
    for (Eigen::Index k = 1; k <= last; ++k)
      integral.row(k) = integral.row(k - 1) + 0.5 * (time(k) - time(k - 1)) * (values.row(k) + values.row(k - 1));
  }
  const auto before = [&](double t) {
    const auto found = std::upper_bound(time.begin(), time.end(), t) - time.begin();
    return std::clamp<Eigen::Index>(found - 1, 0, std::max<Eigen::Index>(last - 1, 0));
  };
  const auto valueAt = [&](double t, Eigen::Index k) -> Eigen::RowVectorXd {
    const double share = std::clamp((t - time(k)) / (time(k + 1) - time(k)), 0.0, 1.0);
    return (1.0 - share) * values.row(k) + share * values.row(k + 1);
  };
  const auto integralAt = [&](double t) -> Eigen::RowVectorXd {
    const auto k = before(t);
    return integral.row(k) + 0.5 * (t - time(k)) * (values.row(k) + valueAt(t, k));
  };
  MatrixXd out(at.size(), values.cols());
  for (Eigen::Index i = 0; i < at.size(); ++i) {
    // At the ends the window shrinks evenly, so that it stays around its time.
    const double half = std::min({0.5 * width, at(i) - time(0), time(last) - at(i)});
    if (half <= 0.0)
      out.row(i) = valueAt(at(i), before(at(i)));
    else
      out.row(i) = (integralAt(at(i) + half) - integralAt(at(i) - half)) / (2.0 * half);
  }
  return out;
}

OffsetEstimate findOffset(const Eigen::Ref<const MatrixXd>& given, double start, double rateHz,
                          const VectorXd& forceTime, const Eigen::Ref<const Eigen::MatrixX3d>& force, double from,
                          double to) {
  OffsetEstimate out;
  if (forceTime.size() < 20 || given.cols() < 20) return out;
  const double motionEnd = start + static_cast<double>(given.cols() - 1) / rateHz;
  const VectorXd motionTime = VectorXd::LinSpaced(given.cols(), start, motionEnd);
  const Track whole{start, 1.0 / rateHz, averageAt(motionTime, given.transpose(), motionTime, kSmoothing).transpose()};
  const Track motion{whole.start, whole.step, whole.values.topRows<3>()};
  Track wrench;
  wrench.step = motion.step;
  wrench.start = forceTime(0);
  const auto count = static_cast<Eigen::Index>((forceTime(forceTime.size() - 1) - forceTime(0)) / wrench.step);
  if (count < 20) return out;
  const VectorXd grid =
      VectorXd::LinSpaced(count, wrench.start, wrench.start + wrench.step * static_cast<double>(count - 1));
  wrench.values = averageAt(forceTime, force, grid, kSmoothing).transpose();

  const Track coarseMotion = thinned(motion, kCoarseStep);
  const Track coarseForce = thinned(wrench, kCoarseStep);
  const auto shorter = static_cast<double>(std::min(coarseMotion.values.cols(), coarseForce.values.cols()));
  const double farBack = -1e12;
  const double farAhead = 1e12;
  std::vector<std::pair<double, double>> curve;
  for (double offset = from; offset <= to + 1e-9; offset += kCoarseStep) {
    const Fit fit = fitAt(coarseMotion, coarseForce, offset, farBack, farAhead);
    if (static_cast<double>(fit.samples) >= kLeastOverlap * shorter) curve.emplace_back(fit.explained, offset);
  }
  if (curve.empty()) return out;
  const auto best = *std::max_element(curve.begin(), curve.end());
  out.seconds = refine(whole, wrench, best.second, 2.0 * kCoarseStep, farBack, farAhead);
  out.explained = fitAt(motion, wrench, out.seconds, farBack, farAhead).explained;
  for (const auto& [explained, offset] : curve)
    if (std::abs(offset - out.seconds) > kFarAway) out.runnerUp = std::max(out.runnerUp, explained);

  const double first = std::max(motion.start, wrench.start + out.seconds);
  const double last = std::min(motion.end(), wrench.end() + out.seconds);
  const MatrixXd map = fitAt(whole, wrench, out.seconds, farBack, farAhead).map;
  std::array<double, 4> parts{};
  double mean = 0.0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const double quarter = (last - first) / static_cast<double>(parts.size());
    parts[i] = refine(whole, wrench, out.seconds, 2.0 * kCoarseStep, first + quarter * static_cast<double>(i),
                      first + quarter * static_cast<double>(i + 1), &map);
    mean += parts[i] / static_cast<double>(parts.size());
  }
  double squares = 0.0;
  for (const double part : parts) squares += (part - mean) * (part - mean);
  out.std = std::hypot(std::sqrt(squares / 3.0 / 4.0), kGridError);
  const bool inside = out.seconds > from + kCoarseStep && out.seconds < to - kCoarseStep;
  // Slow tilting looks alike at many offsets; what is left unexplained then tells the right one.
  const bool alone =
      out.explained - out.runnerUp > 0.1 || 1.0 - out.runnerUp > kLeftUnexplained * (1.0 - out.explained);
  out.sure = last - first > kLeastSpan && inside && out.explained > 0.5 && alone && out.std < 0.03;
  return out;
}

}  // namespace heft
