#include "core/math/cosine_transform.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <unsupported/Eigen/FFT>

namespace heft {

namespace {

/// exp(-i pi k / 2N)
std::complex<double> quarterTurns(std::size_t k, std::size_t count) {
  return std::polar(1.0, -0.5 * std::numbers::pi * static_cast<double>(k % (4 * count)) / static_cast<double>(count));
}

double size(std::size_t k, std::size_t count) { return std::sqrt((k == 0 ? 1.0 : 2.0) / static_cast<double>(count)); }

}  // namespace

CosineTransform::CosineTransform(Eigen::Index count) : count_(static_cast<std::size_t>(count)), chirp_(count_) {
  if (count_ == 0) return;
  std::vector<Complex> ring(std::bit_ceil(2 * count_), 0.0);
  for (std::size_t n = 0; n < count_; ++n) {
    chirp_[n] = quarterTurns(n * n, count_);
    ring[n] = std::conj(chirp_[n]);
    if (n > 0) ring[ring.size() - n] = ring[n];
  }
  Eigen::FFT<double> transform;
  transform.fwd(spectrum_, ring);
}

std::vector<CosineTransform::Complex> CosineTransform::halfTurns(const std::vector<Complex>& values) const {
  // m k = (m^2 + k^2 - (k - m)^2) / 2
  std::vector<Complex> ring(spectrum_.size(), 0.0), product;
  for (std::size_t n = 0; n < count_; ++n) ring[n] = values[n] * chirp_[n];
  Eigen::FFT<double> transform;
  transform.fwd(product, ring);
  for (std::size_t k = 0; k < product.size(); ++k) product[k] *= spectrum_[k];
  transform.inv(ring, product);
  ring.resize(count_);
  for (std::size_t k = 0; k < count_; ++k) ring[k] *= chirp_[k];
  return ring;
}

Eigen::MatrixXd CosineTransform::forward(const Eigen::MatrixXd& samples) const {
  Eigen::MatrixXd out(samples.rows(), samples.cols());
  for (Eigen::Index c = 0; c < samples.cols(); ++c) {
    const auto turned = halfTurns({samples.col(c).begin(), samples.col(c).end()});
    for (std::size_t k = 0; k < count_; ++k)
      out(static_cast<Eigen::Index>(k), c) = size(k, count_) * std::real(turned[k] * quarterTurns(k, count_));
  }
  return out;
}

Eigen::MatrixXd CosineTransform::inverse(const Eigen::MatrixXd& waves) const {
  Eigen::MatrixXd out(waves.rows(), waves.cols());
  std::vector<Complex> values(count_);
  for (Eigen::Index c = 0; c < waves.cols(); ++c) {
    for (std::size_t k = 0; k < count_; ++k)
      values[k] = size(k, count_) * waves(static_cast<Eigen::Index>(k), c) * quarterTurns(k, count_);
    const auto turned = halfTurns(values);
    for (std::size_t n = 0; n < count_; ++n) out(static_cast<Eigen::Index>(n), c) = turned[n].real();
  }
  return out;
}

}  // namespace heft
