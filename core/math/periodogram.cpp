#include "core/math/periodogram.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>
#include <vector>

#include "core/base/stop.h"

namespace heft {

Eigen::MatrixXd taperedPower(const Eigen::MatrixXd& x, Eigen::Index lines) {
  const Eigen::Index length = x.cols();
  const double turn = 2.0 * std::numbers::pi / static_cast<double>(length);
  const Eigen::ArrayXd taper =
      0.5 - 0.5 * (turn * (Eigen::ArrayXd::LinSpaced(length, 0.0, static_cast<double>(length - 1)) + 0.5)).cos();
  Eigen::MatrixXd out(x.rows(), lines);
  Eigen::FFT<double> transform;
  std::vector<double> tapered(static_cast<std::size_t>(length));
  std::vector<std::complex<double>> waves;
  for (Eigen::Index c = 0; c < x.rows(); ++c) {
    stopPoint();
    const double mean = x.row(c).mean();
    for (Eigen::Index n = 0; n < length; ++n) tapered[static_cast<std::size_t>(n)] = taper(n) * (x(c, n) - mean);
    transform.fwd(waves, tapered);
    for (Eigen::Index k = 1; k <= lines; ++k) out(c, k - 1) = std::norm(waves[static_cast<std::size_t>(k)]);
  }
  return out / taper.square().sum();
}

Eigen::MatrixXcd paddedSpectrum(const Eigen::MatrixXd& columns, Eigen::Index length) {
  Eigen::MatrixXcd out(length, columns.cols());
  Eigen::FFT<double> transform;
  std::vector<double> padded(static_cast<std::size_t>(length));
  std::vector<std::complex<double>> waves;
  for (Eigen::Index c = 0; c < columns.cols(); ++c) {
    stopPoint();
    std::copy(columns.col(c).begin(), columns.col(c).end(), padded.begin());
    transform.fwd(waves, padded);
    out.col(c) = Eigen::Map<const Eigen::VectorXcd>(waves.data(), length);
  }
  return out;
}

Eigen::Index lengthOfEasyFactors(Eigen::Index least) {
  for (Eigen::Index length = std::max<Eigen::Index>(1, least);; ++length) {
    Eigen::Index rest = length;
    for (const Eigen::Index factor : {2, 3, 5})
      while (rest % factor == 0) rest /= factor;
    if (rest == 1) return length;
  }
}

}  // namespace heft
