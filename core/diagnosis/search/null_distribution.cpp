#include "core/diagnosis/search/null_distribution.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>
#include <random>
#include <vector>

#include "core/base/parallel.h"
#include "core/base/say.h"
#include "core/diagnosis/model/linearisation.h"
#include "core/math/column_products.h"
#include "core/math/linear_algebra.h"

namespace heft::diagnosis {

namespace {

/// What turns products of whitened signatures with noise into coordinates of unit variance, a row a coordinate: of the
/// space that they span beside what bias, payload and known causes can do, or, of a subset, each by itself; no row
/// where nothing is left. `own`: the signatures' products with each other; `beside`: those of what is known anyway
/// (orthonormal columns) with them.
MatrixXd turnOf(const MatrixXd& own, const MatrixXd& beside, bool subset) {
  constexpr double kLeft = 1e-3;      // Of a column's length; less is rounding of what is known anyway
  constexpr double kDistinct = 1e-9;  // Of the largest eigenvalue; less is a direction twice
  const MatrixXd G = own - columnProducts(beside);
  std::vector<Eigen::Index> keep;
  for (Eigen::Index j = 0; j < G.cols(); ++j)
    if (own(j, j) > 0.0 && G(j, j) > kLeft * kLeft * own(j, j)) keep.push_back(j);
  MatrixXd unit = MatrixXd::Zero(std::ssize(keep), own.cols());  // Selects and scales
  for (std::size_t k = 0; k < keep.size(); ++k)
    unit(static_cast<Eigen::Index>(k), keep[k]) = 1.0 / std::sqrt(G(keep[k], keep[k]));
  if (subset || keep.empty()) return unit;
  const auto [values, vectors] = symmetricEigen(congruence(unit, G));
  const Eigen::Index first = (values.array() <= kDistinct * values(values.size() - 1)).count();
  const Eigen::Index count = values.size() - first;
  const VectorXd scale = values.tail(count).cwiseSqrt().cwiseInverse();
  return scale.asDiagonal() * transposedProduct(vectors.rightCols(count), unit);
}

/// Gain of evidence by recording (column) of coordinates of unit variance.
VectorXd gainsOf(const MatrixXd& z, bool subset, double lnN) {
  constexpr double kNothing = -1e300;
  VectorXd out(z.cols());
  for (Eigen::Index j = 0; j < z.cols(); ++j) {
    if (subset) {
      const double gain = (z.col(j).array().square() - lnN).cwiseMax(0.0).sum();
      out(j) = gain > 0.0 ? gain : kNothing;
    } else {
      const double explained = z.col(j).squaredNorm();
      out(j) = explained - complexityPenalty(explained, static_cast<double>(z.rows()), lnN);
    }
  }
  return out;
}

/// White innovations, a recording a column: what whitening makes of simulated noise. Box-Muller, the same on every
/// platform.
MatrixXd whiteNoise(Eigen::Index rows, const std::vector<Stretch>& stretches, Eigen::Index count,
                    std::mt19937_64& random) {
  MatrixXd noise = MatrixXd::Zero(rows, count);
  const auto uniform = [&] { return (static_cast<double>(random() >> 11) + 0.5) * 0x1p-53; };
  for (Eigen::Index j = 0; j < count; ++j)
    for (const auto& s : stretches)
      for (Eigen::Index i = 6 * s.from; i < 6 * s.to; ++i) noise(i, j) = uniform();
  parallelFor(static_cast<std::size_t>(count), [&](std::size_t j) {
    auto column = noise.col(static_cast<Eigen::Index>(j));
    for (const auto& s : stretches)
      for (Eigen::Index i = 6 * s.from; i < 6 * s.to; i += 2) {
        const double r = std::sqrt(-2.0 * std::log(column(i))), angle = 2.0 * std::numbers::pi * column(i + 1);
        column(i) = r * std::cos(angle);
        column(i + 1) = r * std::sin(angle);
      }
  });
  return noise;
}

}  // namespace

double Surrogates::pValue(double gain) const {
  const auto above = best.end() - std::lower_bound(best.begin(), best.end(), gain);
  return (static_cast<double>(above) + 1.0) / (static_cast<double>(best.size()) + 1.0);
}

Surrogates surrogates(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& fit,
                      const std::vector<Signature>& bank, int count, unsigned seed, const Progress& progress) {
  const double lnN = std::log(std::max(2.0, fit.noise.samples));
  std::map<const Cause*, int> forms;
  for (const auto& signature : bank) ++forms[signature.form.cause];
  const MatrixXd known = explainedSpace(CachedJacobian(signals, fit.model).columns(), fit.noise, stretches);
  const auto basis = WhitenedColumns::ofWhite(known, fit.noise, stretches);
  // Long recordings have thousands of forms: whitened columns are made for one at a time, once a batch.
  constexpr Eigen::Index kMostNumbers = 4'000'000;  // Of noise at a time, 32 MB
  const auto batch = std::max<Eigen::Index>(1, kMostNumbers / std::max<Eigen::Index>(1, known.rows()));
  std::mt19937_64 random(seed);
  Surrogates out;
  for (Eigen::Index done = 0; done < count && !progress.cancelled(); done += batch) {
    progress(static_cast<double>(done) / count, heft::say("Running the search on simulated clean recordings"));
    const auto noise = WhitenedColumns::ofWhite(
        whiteNoise(known.rows(), stretches, std::min<Eigen::Index>(batch, count - done), random), fit.noise, stretches);
    // What bias, payload and known causes explain of it anyway.
    const MatrixXd explained = basis.transposeTimes(noise);
    VectorXd best = VectorXd::Constant(noise.cols(), -1e300);
    std::mutex mutex;
    parallelFor(bank.size(), [&](std::size_t i) {
      const Signature& signature = bank[i];
      if (signature.form.walk || progress.cancelled()) return;  // A walk is never a verdict.
      const WhitenedColumns columns(*signature.columns, fit.noise, stretches, signature.reach.from);
      const MatrixXd beside = basis.transposeTimes(columns),
                     turn = turnOf(columns.gram(), beside, signature.form.subset);
      if (turn.rows() == 0) return;
      const MatrixXd z = turn * (noise.transposeTimes(columns) - columnProducts(explained, beside)).transpose();
      const VectorXd gains = gainsOf(z, signature.form.subset, lnN).array() -
                             2.0 * std::log(static_cast<double>(forms.at(signature.form.cause)));
      const std::lock_guard lock(mutex);
      best = best.cwiseMax(gains);
    });
    if (!progress.cancelled()) out.best.insert(out.best.end(), best.begin(), best.end());
  }
  std::sort(out.best.begin(), out.best.end());
  if (!out.best.empty())
    out.threshold = std::max(10.0, out.best[static_cast<std::size_t>(0.95 * static_cast<double>(out.best.size() - 1))]);
  return out;
}

}  // namespace heft::diagnosis
