#include "core/diagnosis/noise.h"

#include <cmath>

namespace heft::diagnosis {

namespace {

constexpr int kMaxOrder = 8;
constexpr Eigen::Index kShortest = 12;

Noise fitted(const Wrenches& residual, const std::vector<Stretch>& stretches, int maxOrder) {
  Noise out;
  for (int c = 0; c < 6; ++c) {
    AutoCovariance sums(maxOrder);
    for (const auto& s : stretches) {
      const VectorXd part = residual.row(c).segment(s.from, s.to - s.from).transpose();
      sums.add(part, VectorXd::Ones(part.size()));
    }
    ArModel model = sums.fit();
    model.sigma = std::max(model.sigma, 1e-9);
    out.evidence -= sums.count() * 2.0 * std::log(model.sigma) + model.order() * std::log(std::max(2.0, sums.count()));
    out.samples += sums.count();
    out.channels[static_cast<std::size_t>(c)] = model;
  }
  return out;
}

}  // namespace

std::vector<Stretch> stretchesOf(const std::vector<bool>& usable) {
  std::vector<Stretch> out;
  const auto n = static_cast<Eigen::Index>(usable.size());
  for (Eigen::Index k = 0; k < n; ++k) {
    if (!usable[static_cast<std::size_t>(k)]) continue;
    const Eigen::Index from = k;
    while (k < n && usable[static_cast<std::size_t>(k)]) ++k;
    if (k - from >= kShortest) out.push_back({from, k});
  }
  return out;
}

Noise fitNoise(const Wrenches& residual, const std::vector<Stretch>& stretches) {
  return fitted(residual, stretches, kMaxOrder);
}

Noise white(const Wrenches& residual, const std::vector<Stretch>& stretches) { return fitted(residual, stretches, 0); }

MatrixXd whitened(const MatrixXd& columns, const Noise& noise, const std::vector<Stretch>& stretches) {
  MatrixXd out = MatrixXd::Zero(columns.rows(), columns.cols());
  for (int c = 0; c < 6; ++c) {
    const ArModel& model = noise.channels[static_cast<std::size_t>(c)];
    const Eigen::Index order = model.order();
    const double scale = 1.0 / model.sigma;
    for (const auto& s : stretches) {
      const Eigen::Index count = s.to - s.from - order;
      if (count <= 0) continue;
      for (Eigen::Index j = 0; j < columns.cols(); ++j) {
        const auto at = [&](Eigen::Index first) {
          return Eigen::Map<const VectorXd, 0, Eigen::InnerStride<6>>(columns.col(j).data() + 6 * first + c, count);
        };
        VectorXd e = at(s.from + order);
        for (Eigen::Index i = 0; i < order; ++i) e -= model.coefficients(i) * at(s.from + order - 1 - i);
        Eigen::Map<VectorXd, 0, Eigen::InnerStride<6>>(out.col(j).data() + 6 * (s.from + order) + c, count) = scale * e;
      }
    }
  }
  return out;
}

}  // namespace heft::diagnosis
