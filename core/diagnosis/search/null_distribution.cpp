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
#include "core/math/linear_algebra.h"

namespace heft::diagnosis {

namespace {

/// What turns products of whitened signatures with noise into coordinates of unit variance, a row a coordinate: of the
/// space that they span beside what bias, payload and known causes can do, or, of a subset, each by itself; no row
/// where nothing is left. `beside`: products of what is known anyway (orthonormal columns) with `columns`.
MatrixXd turnOf(const MatrixXd& columns, const MatrixXd& beside, bool subset) {
  constexpr double kLeft = 1e-3;      // Of a column's length; less is rounding of what is known anyway
  constexpr double kDistinct = 1e-9;  // Of the largest eigenvalue; less is a direction twice
  const MatrixXd own = transposedProduct(columns, columns), G = own - transposedProduct(beside, beside);
  std::vector<Eigen::Index> keep;
  for (Eigen::Index j = 0; j < G.cols(); ++j)
    if (own(j, j) > 0.0 && G(j, j) > kLeft * kLeft * own(j, j)) keep.push_back(j);
  MatrixXd unit = MatrixXd::Zero(std::ssize(keep), columns.cols());  // Selects and scales
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
  for (Eigen::Index j = 0; j < count; ++j)
    for (const auto& s : stretches)
      for (Eigen::Index i = 6 * s.from; i < 6 * s.to; i += 2) {
        const double u = (static_cast<double>(random() >> 11) + 0.5) * 0x1p-53;
        const double v = (static_cast<double>(random() >> 11) + 0.5) * 0x1p-53;
        const double r = std::sqrt(-2.0 * std::log(u));
        noise(i, j) = r * std::cos(2.0 * std::numbers::pi * v);
        noise(i + 1, j) = r * std::sin(2.0 * std::numbers::pi * v);
      }
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
  const MatrixXd basis = explainedSpace(CachedJacobian(signals, fit.model).columns(), fit.noise, stretches);
  // Long recordings have thousands of forms: whitened columns are made for one at a time, once a batch.
  constexpr Eigen::Index kMostNumbers = 12'000'000;  // Of noise at a time, 96 MB
  const auto batch = std::max<Eigen::Index>(1, kMostNumbers / std::max<Eigen::Index>(1, basis.rows()));
  std::mt19937_64 random(seed);
  Surrogates out;
  for (Eigen::Index done = 0; done < count && !progress.cancelled(); done += batch) {
    progress(static_cast<double>(done) / count, heft::say("Running the search on simulated clean recordings"));
    MatrixXd noise = whiteNoise(basis.rows(), stretches, std::min<Eigen::Index>(batch, count - done), random);
    // What bias, payload and known causes explain of it anyway.
    noise -= product(basis, transposedProduct(basis, noise));
    VectorXd best = VectorXd::Constant(noise.cols(), -1e300);
    std::mutex mutex;
    parallelFor(bank.size(), [&](std::size_t i) {
      const Signature& signature = bank[i];
      if (signature.form.walk || progress.cancelled()) return;  // A walk is never a verdict.
      const Eigen::Index from = 6 * signature.reach.from;
      const MatrixXd columns = whitened(signature.columns->dense(), fit.noise, stretches, signature.reach.from);
      const MatrixXd turn =
          turnOf(columns, transposedProduct(basis.middleRows(from, columns.rows()), columns), signature.form.subset);
      if (turn.rows() == 0) return;
      const MatrixXd z = turn * transposedProduct(columns, noise.middleRows(from, columns.rows()));
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
