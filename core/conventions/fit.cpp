#include "core/conventions/fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/conventions/fit_prior.h"
#include "core/math/linear_algebra.h"

namespace heft::conventions {

namespace {

using Sixteen = Eigen::Matrix<double, 16, 1>;
using Nine = Eigen::Matrix<double, 9, 1>;
using Nine9 = Eigen::Matrix<double, 9, 9>;

/// What of everything seen, component 0, is force and what is torque.
void coefficientsOf(const Way& way, Eigen::Matrix<double, 8, 1>& force, Eigen::Matrix<double, 8, 1>& torque) {
  force.setZero();
  torque.setZero();
  if (way.axes == kStated) {
    force(2 * kStated) = 1.0;
    torque(2 * kStated + 1) = 1.0;
    return;
  }
  const int f = way.torqueFirst ? 1 : 0, t = 1 - f;
  force(2 * way.axes + f) = way.forceSi;
  torque(2 * way.axes + t) = way.torqueSign * way.torqueSi;
  if (way.aboutBase) torque(2 * kCrossed + f) -= way.forceSi;
}

}  // namespace

void readingsOf(const Blocks& blocks, const Way& way, MatrixXd& force, MatrixXd& torque) {
  Eigen::Matrix<double, 8, 1> f, t;
  coefficientsOf(way, f, t);
  force.setZero(blocks.size(), 3);
  torque.setZero(blocks.size(), 3);
  for (int g = 0; g < 2 * kSeen; ++g) {
    if (f(g) != 0.0) force += f(g) * blocks.seen.middleCols<3>(3 * g);
    if (t(g) != 0.0) torque += t(g) * blocks.seen.middleCols<3>(3 * g);
  }
  if (way.mirror >= 0) {
    force.col(way.mirror) *= -1.0;
    torque.col(way.mirror) *= -1.0;
  }
}

double lastingOf(const MatrixXd& left) {
  constexpr Eigen::Index kLongest = 25;
  double out = 1.0;
  const double square = left.squaredNorm();
  for (Eigen::Index lag = 1; lag <= kLongest && lag + 1 < left.rows() && square > 0.0; ++lag) {
    const Eigen::Index n = left.rows() - lag;
    const double r = left.topRows(n).cwiseProduct(left.bottomRows(n)).sum() / square;
    if (r <= 0.0) break;
    out += 2.0 * r;
  }
  return out;
}

Scan::Scan(const Blocks& blocks, const VectorXd& weights) {
  const Eigen::Index K = blocks.size();
  const VectorXd w = weights.size() == K ? weights : VectorXd(VectorXd::Ones(K));
  const VectorXd root = w.cwiseSqrt();
  const double sum = std::max(1e-12, w.sum());
  rows_ = 3.0 * sum;
  // Centring takes the bias out: it is one constant a component.
  const auto centred = [&](const MatrixXd& x) {
    const Eigen::RowVectorXd mean = (w.transpose() * x) / sum;
    return MatrixXd(root.asDiagonal() * (x.rowwise() - mean));
  };
  const MatrixXd seen = centred(blocks.seen);
  forceGram_.setZero();
  torqueGram_.setZero();
  for (std::size_t c = 0; c < 3; ++c) {
    const MatrixXd f = centred(blocks.force[c]), t = centred(blocks.torque[c]);
    forceGram_ += transposedProduct(f, f);
    torqueGram_ += transposedProduct(t, t);
    cross_[c].topRows<4>() = transposedProduct(f, seen);
    cross_[c].bottomRows<9>() = transposedProduct(t, seen);
  }
  seen_ = transposedProduct(seen, seen);
  // To begin with force and torque are fitted by themselves.
  const Sixteen precision = payloadAndBiasPrecision();
  forceInverse_ = inverse(forceGram_ + Eigen::Matrix4d((1e-6 * precision.head<4>()).asDiagonal()));
  torqueInverse_ = inverse(torqueGram_ + Eigen::Matrix<double, 9, 9>((1e-6 * precision.segment<9>(1)).asDiagonal()));
}

namespace {

/// Joint fit of payload to force and torque columns given their Gram matrices; scales free.
struct ScaledFit {
  Vector10d phi;
  double force, torque;  ///< Scales
};

ScaledFit scaledFit(const Eigen::Matrix4d& Af, const Eigen::Matrix<double, 9, 9>& At, const Eigen::Vector4d& bf,
                    const Eigen::Matrix<double, 9, 1>& bt, double ff, double tt, double rows, double force,
                    double torque) {
  const Vector10d precision = payloadAndBiasPrecision().head<10>();
  ScaledFit out{Vector10d::Zero(), force, torque};
  constexpr int kRounds = 3;
  for (int round = 0; round < kRounds; ++round) {
    const double wf = 1.0 / (out.force * out.force), wt = 1.0 / (out.torque * out.torque);
    Eigen::Matrix<double, 10, 10> A = precision.asDiagonal();
    A.topLeftCorner<4, 4>() += wf * Af;
    A.bottomRightCorner<9, 9>() += wt * At;
    Vector10d b = Vector10d::Zero();
    b.head<4>() += wf * bf;
    b.tail<9>() += wt * bt;
    out.phi = solveSymmetric(A, b);
    const Eigen::Vector4d pf = out.phi.head<4>();
    const Eigen::Matrix<double, 9, 1> pt = out.phi.tail<9>();
    const double rf = ff - 2.0 * pf.dot(bf) + pf.dot(Af * pf), rt = tt - 2.0 * pt.dot(bt) + pt.dot(At * pt);
    out.force = std::sqrt(std::max(rf / rows, kRounding * kRounding * ff / rows) + 1e-24);
    out.torque = std::sqrt(std::max(rt / rows, kRounding * kRounding * tt / rows) + 1e-24);
  }
  return out;
}

}  // namespace

Scan::Products Scan::productsOf(const Way& way) const {
  Eigen::Matrix<double, 8, 1> f, t;
  coefficientsOf(way, f, t);
  Products out;
  out.force.setZero();
  out.torque.setZero();
  for (int d = 0; d < 3; ++d) {
    const double sign = d == way.mirror ? -1.0 : 1.0;
    for (int g = 0; g < 2 * kSeen; ++g) {
      if (f(g) == 0.0 && t(g) == 0.0) continue;
      for (int c = 0; c < 3; ++c) {
        const auto& cross = cross_[static_cast<std::size_t>(c)];
        if (f(g) != 0.0) out.force.col(3 * d + c) += sign * f(g) * cross.col(3 * g + d).head<4>();
        if (t(g) != 0.0) out.torque.col(3 * d + c) += sign * t(g) * cross.col(3 * g + d).tail<9>();
      }
      for (int h = 0; h < 2 * kSeen; ++h) {
        const double product = seen_(3 * g + d, 3 * h + d);
        out.forceSquare += f(g) * f(h) * product;
        out.torqueSquare += t(g) * t(h) * product;
      }
    }
  }
  return out;
}

std::pair<double, double> Scan::alone(const Products& products, const Nine& q) const {
  const Eigen::Vector4d bf = products.force * q;
  const Nine bt = products.torque * q;
  const auto scale = [&](double square, double explained) {
    return std::sqrt(std::max(square - explained, kRounding * kRounding * square) / rows_ + 1e-24);
  };
  return {scale(products.forceSquare, bf.dot(forceInverse_ * bf)),
          scale(products.torqueSquare, bt.dot(torqueInverse_ * bt))};
}

namespace {

Nine asColumn(const Matrix3d& Q) { return Eigen::Map<const Nine>(Q.data()); }

}  // namespace

Scan::Found Scan::of(const Way& way, const Matrix3d& turn) const {
  const Products products = productsOf(way);
  const Nine q = asColumn(turn);
  const auto [force, torque] = alone(products, q);
  const ScaledFit fit = scaledFit(forceGram_, torqueGram_, products.force * q, products.torque * q,
                                  products.forceSquare, products.torqueSquare, rows_, force, torque);
  return {-2.0 * rows_ * (std::log(fit.force / way.forceSi) + std::log(fit.torque / way.torqueSi)), fit.phi(0)};
}

double Scan::bound(const Way& way) const {
  const auto [force, torque] = alone(productsOf(way), asColumn(Matrix3d::Identity()));
  return -2.0 * rows_ * (std::log(force / way.forceSi) + std::log(torque / way.torqueSi));
}

Matrix3d Scan::bestTurn(const Way& way) const {
  const Products products = productsOf(way);
  // What is explained of the squares of the readings is q^T force q and q^T torque q.
  const Nine9 force = products.force.transpose() * forceInverse_ * products.force;
  const Nine9 torque = products.torque.transpose() * torqueInverse_ * products.torque;
  const auto quality = [&](const Matrix3d& Q) {
    const auto [f, t] = alone(products, asColumn(Q));
    return -std::log(f) - std::log(t);
  };
  /// Climbs q^T H q: as H is positive semidefinite, the rotation nearest to H q is never worse than q.
  const auto climb = [&](Matrix3d Q, double forceScale, double torqueScale) {
    constexpr int kSteps = 30;
    constexpr double kRests = 1e-4;  // [rad]; the robust fit goes on from there
    const Nine9 H = force / (forceScale * forceScale) + torque / (torqueScale * torqueScale);
    for (int step = 0; step < kSteps; ++step) {
      const Nine slope = H * asColumn(Q);
      const Matrix3d G = Eigen::Map<const Matrix3d>(slope.data());
      const Eigen::JacobiSVD<Matrix3d> svd(G, Eigen::ComputeFullU | Eigen::ComputeFullV);
      Matrix3d next = svd.matrixU() * svd.matrixV().transpose();
      if (next.determinant() < 0.0) next = svd.matrixU() * Vector3d(1, 1, -1).asDiagonal() * svd.matrixV().transpose();
      const double moved = (next - Q).norm();
      Q = next;
      if (moved < kRests) break;
    }
    return Q;
  };
  const double forceSpread = std::sqrt(products.forceSquare / rows_) + 1e-12;
  const double torqueSpread = std::sqrt(products.torqueSquare / rows_) + 1e-12;
  std::vector<std::pair<double, Matrix3d>> found;
  for (int a = 0; a < 3; ++a)
    for (const double sa : {1.0, -1.0})
      for (int b = 0; b < 3; ++b)
        for (const double sb : {1.0, -1.0}) {
          if (a == b) continue;
          Matrix3d Q;
          Q.col(0) = sa * Vector3d::Unit(a);
          Q.col(1) = sb * Vector3d::Unit(b);
          Q.col(2) = Q.col(0).cross(Q.col(1));
          Q = climb(Q, forceSpread, torqueSpread);
          const bool known = std::any_of(found.begin(), found.end(),
                                         [&Q](const auto& other) { return (other.second - Q).norm() < 0.1; });
          if (!known) found.emplace_back(quality(Q), Q);
        }
  std::sort(found.begin(), found.end(), [](const auto& x, const auto& y) { return x.first > y.first; });
  std::pair<double, Matrix3d> best = found.front();
  constexpr std::size_t kRefined = 3;
  for (std::size_t i = 0; i < std::min(kRefined, found.size()); ++i) {
    Matrix3d Q = found[i].second;
    for (int round = 0; round < 3; ++round) {
      const auto [f, t] = alone(products, asColumn(Q));
      Q = climb(Q, f, t);
    }
    const double value = quality(Q);
    if (value > best.first) best = {value, Q};
  }
  return best.second;
}

}  // namespace heft::conventions
