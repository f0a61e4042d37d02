#include "core/math/statistics.h"

#include <algorithm>
#include <cmath>

#include "core/math/column_products.h"
#include "core/math/linear_algebra.h"

namespace heft {

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

double robustStd(const std::vector<double>& values) {
  const double centre = median(values);
  std::vector<double> deviations(values.size());
  std::transform(values.begin(), values.end(), deviations.begin(),
                 [centre](double value) { return std::abs(value - centre); });
  return 1.4826 * median(std::move(deviations));
}

double shareAlongOneDirection(const Eigen::MatrixXd& power) {
  const VectorXd values = symmetricEigen(power).values;
  const double all = values.sum();
  return all > 0.0 ? values.maxCoeff() / all : 0.0;
}

void AutoCovariance::add(const Eigen::Ref<const Eigen::VectorXd>& noise,
                         const Eigen::Ref<const Eigen::VectorXd>& weights) {
  addTaken(noise, weights);
  count_ += weights.sum();
}

void AutoCovariance::addTaken(const Eigen::Ref<const Eigen::VectorXd>& taken,
                              const Eigen::Ref<const Eigen::VectorXd>& weights) {
  const Eigen::VectorXd weighted = taken.cwiseProduct(weights);
  addLaggedProducts(weighted, sums_);
}

void AutoCovariance::add(const Eigen::Ref<const Eigen::VectorXd>& noise) {
  addLaggedProducts(noise, sums_);
  count_ += static_cast<double>(noise.size());
}

ArModel AutoCovariance::fit(int beyond) const {
  ArModel white;
  if (count_ < 2.0 || !(sums_(0) > 0.0)) return white;
  double variance = sums_(0) / count_;
  white.sigma = std::sqrt(variance);
  std::vector<ArModel> models{white};
  std::size_t best = 0;
  double bestScore = count_ * std::log(variance);
  Eigen::VectorXd a;
  const auto maxOrder = std::min<Eigen::Index>(sums_.size() - 1, static_cast<Eigen::Index>(count_ / 10));
  for (Eigen::Index p = 1; p <= maxOrder; ++p) {
    double acc = sums_(p) / count_;
    for (Eigen::Index i = 1; i < p; ++i) acc -= a(i - 1) * sums_(p - i) / count_;
    const double reflection = std::clamp(acc / variance, -0.9999, 0.9999);
    Eigen::VectorXd next(p);
    for (Eigen::Index i = 1; i < p; ++i) next(i - 1) = a(i - 1) - reflection * a(p - i - 1);
    next(p - 1) = reflection;
    a = next;
    variance *= 1.0 - reflection * reflection;
    if (!(variance > 0.0)) break;
    models.push_back({a, std::sqrt(variance)});
    const double score = count_ * std::log(variance) + static_cast<double>(p) * std::log(count_);
    if (score < bestScore) {
      bestScore = score;
      best = static_cast<std::size_t>(p);
    }
  }
  // Samples without neighbours, as standing poses are, have no memory to be told.
  if (models.size() < 2 || sums_(1) == 0.0) return white;
  return models[std::min(best + static_cast<std::size_t>(beyond), models.size() - 1)];
}

}  // namespace heft
