#include "core/diagnosis/search/null_distribution.h"
#include "core/diagnosis/model/linearisation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "core/base/parallel.h"
#include "core/base/say.h"
#include "core/math/linear_algebra.h"

namespace heft::diagnosis {

namespace {

/// Orthonormal columns of a form's whitened signatures, without what bias and payload can do.
struct Direction {
  MatrixXd Q;
  double penalty = 0.0;
  bool subset = false;
};

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
    MatrixXd C = MatrixXd::Zero(rows, bank[i].columns->cols());
    C.middleRows(6 * bank[i].reach.from, bank[i].columns->rows()) =
        whitened(*bank[i].columns, fit.noise, stretches, bank[i].reach.from);
    const VectorXd own = C.colwise().norm().transpose();
    C -= basis * (basis.transpose() * C);
    std::vector<Eigen::Index> keep;
    for (Eigen::Index j = 0; j < C.cols(); ++j)
      if (own(j) > 0.0 && C.col(j).norm() > 1e-3 * own(j)) keep.push_back(j);
    MatrixXd kept(rows, static_cast<Eigen::Index>(keep.size()));
    for (std::size_t j = 0; j < keep.size(); ++j) kept.col(static_cast<Eigen::Index>(j)) = C.col(keep[j]).normalized();
    Direction& out = directions[i];
    if (bank[i].form.walk) return;  // Never a verdict.
    out.penalty = 2.0 * std::log(static_cast<double>(forms.at(bank[i].form.cause)));
    out.subset = bank[i].form.subset;
    if (keep.empty()) return;
    // A free choice of columns needs them one by one; otherwise the space they span.
    if (out.subset) {
      out.Q = kept;
    } else {
      out.Q = orthonormal(kept);
    }
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
    MatrixXd gains = MatrixXd::Constant(batch, static_cast<Eigen::Index>(directions.size()), -1e300);
    parallelFor(directions.size(), [&](std::size_t i) {
      const Direction& direction = directions[i];
      if (direction.Q.cols() == 0) return;
      const MatrixXd z = direction.Q.transpose() * noise;
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
