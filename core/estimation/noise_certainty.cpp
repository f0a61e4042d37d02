#include "core/estimation/noise_certainty.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/estimation/normal_draws.h"
#include "core/estimation/triangle.h"
#include "core/math/linear_algebra.h"

namespace heft {

namespace {

using Noise = Eigen::Matrix<double, 6, Eigen::Dynamic>;

/// Length of a window [s]: a sum over it sees frequencies below 2.5 Hz, at which hands guide an arm.
constexpr double kWindow = 0.2;
/// Fewer degrees of freedom tell no scale.
constexpr double kFewestFreedom = 3.0;
/// Blocks from which on the noise model is certain enough: with 1600 of them standard deviations are 1.2 % too small.
constexpr Eigen::Index kCertain = 1500;
/// Rows that are drawn in all, at least and at most so many recordings: what is sought is small where they are long.
constexpr Eigen::Index kDrawnRows = 6000, kFewestDraws = 6, kMostDraws = 24;

/// Sums of the whitened, weighted rows over the windows of all runs, over the root of the blocks in each.
std::vector<WhiteRows> windowSums(const WrenchRows& rows, const NoiseModel& noise, const Noise& weights,
                                  const std::vector<Run>& runs) {
  std::vector<WhiteRows> out;
  const RowWhitener whitener(noise);
  const double length = rows.rateHz > 0.0 ? std::max(1.0, kWindow * rows.rateHz) : 1.0;
  for (const auto& run : runs) {
    const Eigen::Index begin = run.from + noise.order, count = run.to - begin;
    if (count <= 0) continue;
    const auto windows = std::max<Eigen::Index>(1, std::lround(static_cast<double>(count) / length));
    for (Eigen::Index w = 0; w < windows; ++w) {
      const Eigen::Index first = w * count / windows, last = (w + 1) * count / windows;
      WhiteRows sum = WhiteRows::Zero();
      for (Eigen::Index k = first; k < last; ++k) sum += whitener.white(rows, begin + k, weights.col(begin + k));
      out.push_back(sum / std::sqrt(static_cast<double>(last - first)));
    }
  }
  return out;
}

/// Noise of the model in every run, from a start long before it.
Noise drawn(const NoiseModel& noise, const std::vector<Run>& runs, Eigen::Index size, NormalDraws& normal) {
  constexpr Eigen::Index kBefore = 50;
  const Matrix6d L = inverse(noise.whitener);
  Noise out = Noise::Zero(6, size);
  for (const auto& run : runs) {
    const Eigen::Index before = noise.order > 0 ? kBefore : 0;
    Noise e(6, before + run.to - run.from);
    for (Eigen::Index k = 0; k < e.cols(); ++k) {
      Vector6d u;
      for (auto& value : u) value = normal.normalPair().first;
      e.col(k) = L * u;
      for (int c = 0; c < 6; ++c) {
        const ArModel& model = noise.channels[static_cast<std::size_t>(c)];
        for (int i = 0; i < model.order() && k - 1 - i >= 0; ++i) e(c, k) += model.coefficients(i) * e(c, k - 1 - i);
      }
    }
    out.middleCols(run.from, run.to - run.from) = e.rightCols(run.to - run.from);
  }
  return out;
}

/// 95 % quantile of ten times Fisher's F with 10 and `freedom` degrees of freedom over that of chi-squared with 10: its
/// expansion in 1 / freedom, within 5 % down to 5 degrees.
double fisherOverChiSquared(double oneOverFreedom) {
  const double x = std::min(oneOverFreedom, 0.2);
  return 1.0 + (5.15 + 11.4 * x) * x;
}

/// Chi-squared of the payload zero.
double chiSquared(const Triangle& whitened) {
  const auto A = whitened.bottomRightCorner<11, 11>().leftCols<10>();
  const VectorXd y = whitened.bottomRightCorner<11, 11>().col(10);
  const VectorXd x = leastSquares(MatrixXd(A), y).x;
  return (A * x).squaredNorm();
}

}  // namespace

NoiseModel scaledToSlowNoise(NoiseModel noise, const WrenchRows& rows, const Noise& weights,
                             const std::vector<Run>& runs, const KnownOfNoise& known) {
  const Triangle whitened = merged(whitenedTriangles(rows, noise, weights, runs, 1));
  const MatrixXd L = choleskyFactor(informationOf(whitened));
  const MatrixXd back = L.triangularView<Eigen::Lower>().solve(MatrixXd::Identity(kColumns, kColumns));
  const VectorXd x =
      back.transpose() * (back * transposedProduct(whitened.leftCols<kColumns>(), whitened.col(kColumns)));
  // Forces and torques: what an amplifier does to one axis it does to its neighbours.
  double left[2] = {0.0, 0.0}, freedom[2] = {0.0, 0.0};
  for (const WhiteRows& window : windowSums(rows, noise, weights, runs))
    for (int c = 0; c < 6; ++c) {
      if (known.silent[static_cast<std::size_t>(c)]) continue;
      const Eigen::Matrix<double, kColumns, 1> row = window.row(c).head<kColumns>().transpose();
      const double residual = window(c, kColumns) - row.dot(x);
      left[c / 3] += residual * residual;
      freedom[c / 3] += std::max(0.0, 1.0 - (back * row).squaredNorm());
    }
  for (int c = 0; c < 6; ++c) {
    if (known.silent[static_cast<std::size_t>(c)] || freedom[c / 3] < kFewestFreedom) continue;
    ArModel& channel = noise.channels[static_cast<std::size_t>(c)];
    const double scale =
        std::max(std::sqrt(left[c / 3] / freedom[c / 3]), leastInnovation(channel, known.least(c)) / channel.sigma);
    channel.sigma *= scale;
    noise.whitener.row(c) /= scale;
  }
  return noise;
}

double shortfallOfLearning(const WrenchRows& rows, const NoiseModel& noise, const std::vector<Run>& runs,
                           const KnownOfNoise& known) {
  Eigen::Index used = 0;
  for (const auto& run : runs) used += run.to - run.from;
  if (used == 0 || used >= kCertain) return 1.0;
  const Eigen::Index draws = std::clamp(kDrawnRows / used, kFewestDraws, kMostDraws);
  const NoiseModel weighting = bounded(noise);
  const Noise ones = Noise::Ones(6, rows.size());
  NormalDraws normal;
  std::vector<Noise> made;
  for (Eigen::Index draw = 0; draw < draws; ++draw) made.push_back(drawn(noise, runs, rows.size(), normal));
  // What of the scores is the same whatever was drawn.
  const ScoreEquations ofModel = scoreEquations(rows, noise, weighting, ones, runs);
  std::vector<double> expected(made.size()), found(made.size());
  parallelFor(made.size(), [&](std::size_t draw) {
    WrenchRows of = rows;
    of.wrench = std::move(made[draw]);
    const ScoreEquations ofDraw{merged(whitenedTriangles(of, weighting, ones, runs, 1)), ofModel.covariance};
    expected[draw] = chiSquared(honestTriangle(ofDraw));
    const LearnedNoise learned = withTaken(learnedNoise(of, runs, known), of, runs, known);
    found[draw] = chiSquared(honestTriangle(of, learned.noise, bounded(learned.noise), learned.weights, runs));
  });
  double sum = 0.0, squares = 0.0, count = 0.0;
  for (std::size_t draw = 0; draw < made.size(); ++draw) {
    if (!(expected[draw] > 0.0 && found[draw] > 0.0)) continue;
    const double logRatio = std::log(found[draw] / expected[draw]);
    sum += logRatio;
    squares += logRatio * logRatio;
    count += 1.0;
  }
  if (count < 2.0) return 1.0;
  const double mean = sum / count;
  const double oneOverFreedom = 0.5 * std::max(0.0, (squares - count * mean * mean) / (count - 1.0));
  return std::sqrt(std::exp(mean) * fisherOverChiSquared(oneOverFreedom));
}

}  // namespace heft
