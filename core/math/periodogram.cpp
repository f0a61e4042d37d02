#include "core/math/periodogram.h"

#include <cmath>
#include <numbers>

#include "core/base/stop.h"

namespace heft {

Eigen::MatrixXd taperedPower(const Eigen::MatrixXd& x, Eigen::Index lines) {
  const Eigen::Index length = x.cols();
  const double turn = 2.0 * std::numbers::pi / static_cast<double>(length);
  Eigen::RowVectorXd taper(length);
  Eigen::VectorXd cosine(length), sine(length);  // Of a whole turn: every line's phases are among these
  for (Eigen::Index n = 0; n < length; ++n) {
    taper(n) = 0.5 - 0.5 * std::cos(turn * (static_cast<double>(n) + 0.5));
    cosine(n) = std::cos(turn * static_cast<double>(n));
    sine(n) = std::sin(turn * static_cast<double>(n));
  }
  const Eigen::MatrixXd tapered = ((x.colwise() - x.rowwise().mean()).array().rowwise() * taper.array()).matrix();
  Eigen::MatrixXd out(x.rows(), lines);
  Eigen::VectorXd c(length), s(length);
  for (Eigen::Index k = 1; k <= lines; ++k) {
    stopPoint();
    for (Eigen::Index n = 0, at = 0; n < length; ++n) {
      c(n) = cosine(at);
      s(n) = sine(at);
      for (at += k; at >= length;) at -= length;
    }
    out.col(k - 1) = (tapered * c).cwiseAbs2() + (tapered * s).cwiseAbs2();
  }
  return out / taper.squaredNorm();
}

}  // namespace heft
