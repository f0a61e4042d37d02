#include "core/conventions/fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/math/linear_algebra.h"

namespace heft::conventions {

namespace {

/// Degrees of freedom of the t-distribution. With 6 rows a block, up to 6 / (6 + 2) of the blocks may be pushed without
/// the scale following them.
constexpr double kTailFreedom = 2.0;
/// A whisper of prior information, as wide as any payload on any arm: m, h, I, bias.
constexpr double kMassSd = 30.0, kFirstMomentSd = 3.0, kInertiaSd = 1.0, kBiasSd = 1e4;
/// Below this share of the readings nothing is noise: rounding of the numbers in a file.
constexpr double kRounding = 1e-6;

using Sixteen = Eigen::Matrix<double, 16, 1>;
using Nine = Eigen::Matrix<double, 9, 1>;
using Nine9 = Eigen::Matrix<double, 9, 9>;

Sixteen payloadAndBiasPrecision() {
  Sixteen sd;
  sd << kMassSd, Vector3d::Constant(kFirstMomentSd), Vector6d::Constant(kInertiaSd), Vector6d::Constant(kBiasSd);
  return sd.cwiseInverse().cwiseAbs2();
}

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

namespace {

/// Two directions across `g`.
Eigen::Matrix<double, 3, 2> across(const Vector3d& g) {
  const Vector3d a = g.unitOrthogonal();
  Eigen::Matrix<double, 3, 2> out;
  out << a, g.normalized().cross(a);
  return out;
}

/// Stacks three components.
template <class Columns>
void stackInto(const std::array<MatrixXd, 3>& columns, Columns&& into) {
  const Eigen::Index K = columns[0].rows();
  for (Eigen::Index c = 0; c < 3; ++c) into.middleRows(c * K, K) = columns[static_cast<std::size_t>(c)];
}

}  // namespace

Fit robustFit(const Blocks& blocks, const Way& way, Free free, const Place& start, const Vector3d& gravity,
              int rounds) {
  const Eigen::Index K = blocks.size();
  const Eigen::Index extra = free == Free::nothing ? 0 : free == Free::gravity ? 2 : 3;
  MatrixXd readF, readT;
  readingsOf(blocks, way, readF, readT);
  Fit out;
  out.place = start;
  if (out.place.gravity.squaredNorm() == 0.0) out.place.gravity = gravity;
  const double count = 3.0 * static_cast<double>(K);
  // Columns of force: m h | bias | free | reading; of torque: h I | bias | free | reading.
  const Eigen::Index nf = 4 + 3 + extra + 1, nt = 9 + 3 + extra + 1, unknowns = 16 + extra;
  MatrixXd F = MatrixXd::Zero(3 * K, nf), T = MatrixXd::Zero(3 * K, nt);
  stackInto(blocks.force, F.leftCols<4>());
  stackInto(blocks.torque, T.leftCols<9>());
  for (Eigen::Index c = 0; c < 3; ++c) {
    F.block(c * K, 4 + c, K, 1).setOnes();
    T.block(c * K, 9 + c, K, 1).setOnes();
  }
  MatrixXd Fw(3 * K, nf), Tw(3 * K, nt);
  VectorXd weights = VectorXd::Ones(K), precision(unknowns);
  precision << payloadAndBiasPrecision(), VectorXd::Constant(extra, 1e-6);
  std::vector<Eigen::Index> toF, toT;
  for (Eigen::Index i = 0; i < 4; ++i) toF.push_back(i);
  for (Eigen::Index i = 1; i < 10; ++i) toT.push_back(i);
  for (Eigen::Index i = 0; i < 3; ++i) {
    toF.push_back(10 + i);
    toT.push_back(13 + i);
  }
  for (Eigen::Index i = 0; i < extra; ++i) {
    toF.push_back(16 + i);
    toT.push_back(16 + i);
  }
  VectorXd x = VectorXd::Zero(unknowns), distance(K);
  MatrixXd A(unknowns, unknowns), leftF, leftT;
  double floorF = 0.0, floorT = 0.0;
  Eigen::Matrix<double, 3, 2> basis;
  for (int round = 0; round <= rounds; ++round) {
    // What depends on where the free part is.
    if (free == Free::gravity || (out.place.gravity - gravity).norm() > 0.0) {
      const Vector3d change = gravity - out.place.gravity;  // s becomes s + R^T change
      basis = across(out.place.gravity);
      MatrixXd Rg(K, 3);
      for (Eigen::Index c = 0; c < 3; ++c) Rg.col(c) = blocks.R_SB[static_cast<std::size_t>(c)] * change;
      const Vector3d h = x.segment<3>(1);
      for (Eigen::Index c = 0; c < 3; ++c) {
        const auto i = static_cast<std::size_t>(c), j = (i + 1) % 3, l = (i + 2) % 3;
        F.block(c * K, 0, K, 1) = blocks.force[i].col(0) + Rg.col(c);
        // tau += h x (R^T change): component i = h_j s_l - h_l s_j.
        T.middleRows(c * K, K).leftCols<9>() = blocks.torque[i];
        T.block(c * K, static_cast<Eigen::Index>(j), K, 1) += Rg.col(static_cast<Eigen::Index>(l));
        T.block(c * K, static_cast<Eigen::Index>(l), K, 1) -= Rg.col(static_cast<Eigen::Index>(j));
        if (free != Free::gravity) continue;
        F.block(c * K, 7, K, 2) = -x(0) * blocks.R_SB[i] * basis;
        T.block(c * K, 12, K, 2) =
            -(h(static_cast<Eigen::Index>(j)) * blocks.R_SB[l] - h(static_cast<Eigen::Index>(l)) * blocks.R_SB[j]) *
            basis;
      }
    }
    const MatrixXd force = readF * out.place.turn.transpose();
    const MatrixXd torque = readT * out.place.turn.transpose();
    // Turned by d and read as `turn`: d x reading more; about a point r: f x r more (column a: f x e_a).
    const auto crossColumns = [K](const MatrixXd& v, auto&& into) {
      // (v x e_a)_c = skew(v)_ca
      for (Eigen::Index c = 0; c < 3; ++c) {
        const Eigen::Index j = (c + 1) % 3, l = (c + 2) % 3;
        into.block(c * K, c, K, 1).setZero();
        into.block(c * K, j, K, 1) = -v.col(l);
        into.block(c * K, l, K, 1) = v.col(j);
      }
    };
    if (free == Free::mount) {
      crossColumns(force, F.middleCols(7, 3));
      crossColumns(torque, T.middleCols(12, 3));
    }
    if (free == Free::point) crossColumns(force, T.middleCols(12, 3));
    F.rightCols<1>() = Eigen::Map<const VectorXd>(force.data(), 3 * K);
    T.rightCols<1>() = Eigen::Map<const VectorXd>(torque.data(), 3 * K);
    if (round == 0) {
      const auto spread = [&](const MatrixXd& v) {
        return std::sqrt((v.rowwise() - v.colwise().mean()).squaredNorm() / count) + 1e-12;
      };
      out.force = spread(force);
      out.torque = spread(torque);
      floorF = kRounding * out.force;
      floorT = kRounding * out.torque;
    }

    const VectorXd root = weights.cwiseSqrt();
    for (Eigen::Index c = 0; c < 3; ++c) {
      Fw.middleRows(c * K, K).noalias() = root.asDiagonal() * F.middleRows(c * K, K);
      Tw.middleRows(c * K, K).noalias() = root.asDiagonal() * T.middleRows(c * K, K);
    }
    const MatrixXd GF = Fw.transpose() * Fw, GT = Tw.transpose() * Tw;
    // Scales first from the weighted rows as they are, then with the payload that they lead to.
    for (int inner = 0; inner < (round == 0 ? 3 : 1); ++inner) {
      const double wf = 1.0 / (out.force * out.force), wt = 1.0 / (out.torque * out.torque);
      A = precision.asDiagonal();
      VectorXd b = VectorXd::Zero(unknowns);
      for (std::size_t i = 0; i < toF.size(); ++i) {
        for (std::size_t j = 0; j < toF.size(); ++j)
          A(toF[i], toF[j]) += wf * GF(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
        b(toF[i]) += wf * GF(static_cast<Eigen::Index>(i), nf - 1);
      }
      for (std::size_t i = 0; i < toT.size(); ++i) {
        for (std::size_t j = 0; j < toT.size(); ++j)
          A(toT[i], toT[j]) += wt * GT(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
        b(toT[i]) += wt * GT(static_cast<Eigen::Index>(i), nt - 1);
      }
      x = solveSymmetric(A, b);
      VectorXd xf(nf - 1), xt(nt - 1);
      for (std::size_t i = 0; i < toF.size(); ++i) xf(static_cast<Eigen::Index>(i)) = x(toF[i]);
      for (std::size_t i = 0; i < toT.size(); ++i) xt(static_cast<Eigen::Index>(i)) = x(toT[i]);
      const VectorXd rf = F.rightCols<1>() - F.leftCols(nf - 1) * xf, rt = T.rightCols<1>() - T.leftCols(nt - 1) * xt;
      leftF = Eigen::Map<const MatrixXd>(rf.data(), K, 3);
      leftT = Eigen::Map<const MatrixXd>(rt.data(), K, 3);
      const VectorXd squareF = leftF.rowwise().squaredNorm(), squareT = leftT.rowwise().squaredNorm();
      out.force = std::max(floorF, std::sqrt(weights.dot(squareF) / count));
      out.torque = std::max(floorT, std::sqrt(weights.dot(squareT) / count));
      distance = squareF / (out.force * out.force) + squareT / (out.torque * out.torque);
    }
    // Scale and weights settle together.
    for (int inner = 0; inner < 4; ++inner) {
      weights = distance.unaryExpr([](double d) { return (kTailFreedom + 6.0) / (kTailFreedom + d); });
      const VectorXd squareF = leftF.rowwise().squaredNorm(), squareT = leftT.rowwise().squaredNorm();
      out.force = std::max(floorF, std::sqrt(weights.dot(squareF) / count));
      out.torque = std::max(floorT, std::sqrt(weights.dot(squareT) / count));
      distance = squareF / (out.force * out.force) + squareT / (out.torque * out.torque);
    }
    if (round == rounds) break;
    if (free == Free::mount) out.place.turn = rotationFromVector(x.tail<3>()) * out.place.turn;
    if (free == Free::gravity && round > 0) {
      const Vector3d moved = out.place.gravity + basis * x.tail<2>();
      out.place.gravity = gravity.norm() * moved.normalized();
    }
    if (free == Free::point) out.place.point = x.tail<3>();
  }
  out.x = x.head<16>();
  const double freedom = 2.0 * count / std::max(1.0, 2.0 * count - static_cast<double>(unknowns));
  const double lasts = blocks.rateHz > 0.0 ? std::max(lastingOf(leftF), lastingOf(leftT)) : 1.0;
  const MatrixXd covariance = freedom * lasts * inverse(A);
  out.covariance = covariance.topLeftCorner<16, 16>();
  if (extra > 0) {
    const MatrixXd ofFree = covariance.bottomRightCorner(extra, extra), shared = covariance.topRightCorner(10, extra);
    out.fromFree = shared * inverse(ofFree) * shared.transpose();
    const MatrixXd axes = free == Free::gravity ? MatrixXd(basis / gravity.norm()) : MatrixXd(Matrix3d::Identity());
    if (free != Free::point) out.turnCovariance = axes * ofFree * axes.transpose();
  }
  double sum = 0.0;
  for (Eigen::Index k = 0; k < K; ++k) sum += std::log1p(distance(k) / kTailFreedom);
  out.evidence = -2.0 * count * (std::log(out.force / way.forceSi) + std::log(out.torque / way.torqueSi)) -
                 (kTailFreedom + 6.0) * sum - static_cast<double>(extra) * std::log(2.0 * count);
  out.weights = weights / weights.maxCoeff();
  out.left.resize(6, K);
  out.left << leftF.transpose(), leftT.transpose();
  const VectorXd loadF = F.leftCols<4>() * out.x.head<4>(), loadT = T.leftCols<9>() * out.x.segment<9>(1);
  out.load.resize(6, K);
  out.load << Eigen::Map<const MatrixXd>(loadF.data(), K, 3).transpose(),
      Eigen::Map<const MatrixXd>(loadT.data(), K, 3).transpose();
  return out;
}

}  // namespace heft::conventions
