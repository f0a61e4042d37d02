#include "core/motion/savitzky_golay.h"
#include "core/math/linear_algebra.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace heft {

SavitzkyGolay::SavitzkyGolay(int order, int window) : order_(order), window_(window % 2 == 0 ? window + 1 : window) {
  if (order < 0 || window_ <= order)
    throw std::invalid_argument("Savitzky-Golay: order " + std::to_string(order) + " needs a window of more than " +
                                std::to_string(order) + " samples, not " + std::to_string(window) + ".");
  const int half = window_ / 2;
  // Positions scaled to [-1, 1]: monomials of raw sample numbers lose all digits at high orders.
  const double scale = half > 0 ? half : 1.0;
  MatrixXd vandermonde(window_, order_ + 1);
  for (int i = 0; i < window_; ++i)
    for (int j = 0; j <= order_; ++j) vandermonde(i, j) = std::pow((i - half) / scale, j);
  projection_ = pseudoInverse(vandermonde);
}

VectorXd SavitzkyGolay::weights(int derivative, int offset) const {
  const int half = window_ / 2;
  const double scale = half > 0 ? half : 1.0;
  VectorXd weights = VectorXd::Zero(window_);
  for (int j = derivative; j <= order_; ++j) {
    double factor = 1.0;
    for (int i = 0; i < derivative; ++i) factor *= (j - i) / scale;
    weights += factor * std::pow(offset / scale, j - derivative) * projection_.row(j).transpose();
  }
  return weights;
}

Channels SavitzkyGolay::apply(const Channels& signal, int derivative, double rateHz) const {
  const Eigen::Index n = signal.rows();
  if (n < window_)
    throw std::invalid_argument("Savitzky-Golay: a window of " + std::to_string(window_) +
                                " samples needs as many rows, not " + std::to_string(n) + ".");
  const int half = window_ / 2;
  const double unit = std::pow(rateHz, derivative);
  Channels out(n, signal.cols());
  const VectorXd centre = weights(derivative) * unit;
  for (Eigen::Index k = half; k < n - half; ++k)
    out.row(k).noalias() = centre.transpose() * signal.middleRows(k - half, window_);
  for (int i = 0; i < half; ++i) {
    out.row(i).noalias() = unit * weights(derivative, i - half).transpose() * signal.topRows(window_);
    out.row(n - 1 - i).noalias() = unit * weights(derivative, half - i).transpose() * signal.bottomRows(window_);
  }
  return out;
}

}  // namespace heft
