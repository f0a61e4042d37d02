#include "core/diagnosis/search/null_distribution.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <random>
#include <vector>

#include "core/base/parallel.h"
#include "core/base/say.h"
#include "core/diagnosis/model/linearisation.h"
#include "core/math/linear_algebra.h"

namespace heft::diagnosis {

namespace {

/// A form's whitened signatures where they are not zero, and what turns their products with noise into coordinates of
/// unit variance: of the space that they span beside what bias, payload and known causes can do, or, of a subset, each
/// by itself. Long recordings have thousands of forms that are local, so the columns of the whole are never kept.
struct Direction {
  Eigen::Index from = 0;  ///< Row of the whole that `columns` begin at
  MatrixXd columns;
  MatrixXd turn;  ///< A row a coordinate; none where nothing is left
  double penalty = 0.0;
  bool subset = false;
};

/// `beside`: products of what is known anyway (orthonormal columns) with the direction's.
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
  const MatrixXd basis = explainedSpace(CachedJacobian(signals, fit.model).jacobian(), fit.noise, stretches);
  const Eigen::Index rows = basis.rows();
  std::vector<Direction> directions(bank.size());
  parallelFor(bank.size(), [&](std::size_t i) {
    if (bank[i].form.walk) return;  // Never a verdict.
    Direction& out = directions[i];
    out.penalty = 2.0 * std::log(static_cast<double>(forms.at(bank[i].form.cause)));
    out.subset = bank[i].form.subset;
    out.from = 6 * bank[i].reach.from;
    out.columns = whitened(*bank[i].columns, fit.noise, stretches, bank[i].reach.from);
    out.turn =
        turnOf(out.columns, transposedProduct(basis.middleRows(out.from, out.columns.rows()), out.columns), out.subset);
  });

  Surrogates out;
  constexpr int kBatch = 20;
  std::mt19937_64 random(seed);
  for (int done = 0; done < count && !progress.cancelled(); done += kBatch) {
    progress(static_cast<double>(done) / count, heft::say("Running the search on simulated clean recordings"));
    const int batch = std::min(kBatch, count - done);
    // White innovations: what whitening makes of simulated noise. Box-Muller, the same on every platform.
    MatrixXd noise = MatrixXd::Zero(rows, batch);
    for (Eigen::Index j = 0; j < batch; ++j)
      for (const auto& s : stretches)
        for (Eigen::Index i = 6 * s.from; i < 6 * s.to; i += 2) {
          const double u = (static_cast<double>(random() >> 11) + 0.5) * 0x1p-53;
          const double v = (static_cast<double>(random() >> 11) + 0.5) * 0x1p-53;
          const double r = std::sqrt(-2.0 * std::log(u));
          noise(i, j) = r * std::cos(2.0 * 3.14159265358979323846 * v);
          noise(i + 1, j) = r * std::sin(2.0 * 3.14159265358979323846 * v);
        }
    // What bias, payload and known causes explain of it anyway.
    noise -= product(basis, transposedProduct(basis, noise));
    MatrixXd gains = MatrixXd::Constant(batch, static_cast<Eigen::Index>(directions.size()), -1e300);
    parallelFor(directions.size(), [&](std::size_t i) {
      const Direction& direction = directions[i];
      if (direction.turn.rows() == 0) return;
      const MatrixXd z = direction.turn * transposedProduct(direction.columns,
                                                            noise.middleRows(direction.from, direction.columns.rows()));
      for (Eigen::Index j = 0; j < batch; ++j) {
        double gain = -direction.penalty;
        if (direction.subset) {
          for (Eigen::Index k = 0; k < z.rows(); ++k) gain += std::max(0.0, z(k, j) * z(k, j) - lnN);
        } else {
          const double explained = z.col(j).squaredNorm();
          gain += explained - complexityPenalty(explained, static_cast<double>(z.rows()), lnN);
        }
        if (direction.subset && gain == -direction.penalty) continue;
        gains(j, static_cast<Eigen::Index>(i)) = gain;
      }
    });
    for (Eigen::Index j = 0; j < batch; ++j) out.best.push_back(gains.row(j).maxCoeff());
  }
  std::sort(out.best.begin(), out.best.end());
  if (!out.best.empty())
    out.threshold = std::max(10.0, out.best[static_cast<std::size_t>(0.95 * static_cast<double>(out.best.size() - 1))]);
  return out;
}

}  // namespace heft::diagnosis
