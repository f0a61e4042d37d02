#include "core/conventions/fit.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/conventions/fit_prior.h"
#include "core/math/linear_algebra.h"

namespace heft::conventions {
namespace {

/// Degrees of freedom of the t-distribution. With 6 rows a block, up to 6 / (6 + 2) of the blocks may be pushed without
/// the scale following them.
constexpr double kTailFreedom = 2.0;

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

/// The rows of robustFit(), and where it has got to.
struct RobustFit {
  RobustFit(const Blocks& theBlocks, const Way& theWay, Free theFree, const Place& start, const Vector3d& stated)
      : blocks(theBlocks), way(theWay), free(theFree), gravity(stated) {
    readingsOf(blocks, way, readF, readT);
    out.place = start;
    if (out.place.gravity.squaredNorm() == 0.0) out.place.gravity = gravity;
    stackInto(blocks.force, F.leftCols<4>());
    stackInto(blocks.torque, T.leftCols<9>());
    for (Eigen::Index c = 0; c < 3; ++c) {
      F.block(c * K, 4 + c, K, 1).setOnes();
      T.block(c * K, 9 + c, K, 1).setOnes();
    }
    precision << payloadAndBiasPrecision(), VectorXd::Constant(extra, 1e-6);
    for (Eigen::Index i = 0; i < 4; ++i) toF.push_back(i);
    for (Eigen::Index i = 1; i < 10; ++i) toT.push_back(i);
    for (Eigen::Index i = 0; i < 3; ++i) {
      toF.push_back(10 + i);
      toT.push_back(13 + i);
    }
    for (Eigen::Index c = 0; c < 3; ++c) {
      if (!blocks.silent[static_cast<std::size_t>(c)]) heardF += 1.0;
      if (!blocks.silent[static_cast<std::size_t>(3 + c)]) heardT += 1.0;
    }
    for (Eigen::Index i = 0; i < extra; ++i) {
      toF.push_back(16 + i);
      toT.push_back(16 + i);
    }
  }

  Fit run(int rounds) {
    for (int round = 0; round <= rounds; ++round) {
      placeGravity();
      placeReadings();
      leaveOutSilent();
      if (round == 0) startScales();
      solve(round == 0 ? 3 : 1);
      settle();
      if (round < rounds) move(round);
    }
    return result();
  }

  void placeGravity() {
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
  }

  void placeReadings() {
    force = readF * out.place.turn.transpose();
    torque = readT * out.place.turn.transpose();
    // Turned by d and read as `turn`: d x reading more; about a point r: f x r more (column a: f x e_a).
    const auto crossColumns = [this](const MatrixXd& v, auto&& into) {
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
    if (free == Free::origin)
      for (Eigen::Index c = 0; c < 3; ++c)
        F.block(c * K, 7, K, 3) = blocks.force[static_cast<std::size_t>(c)].middleCols<3>(1);
    F.rightCols<1>() = Eigen::Map<const VectorXd>(force.data(), 3 * K);
    T.rightCols<1>() = Eigen::Map<const VectorXd>(torque.data(), 3 * K);
  }

  /// Rows without a column and without a reading: nothing is left there, whatever is fitted.
  void leaveOutSilent() {
    for (Eigen::Index c = 0; c < 3; ++c) {
      if (blocks.silent[static_cast<std::size_t>(c)]) F.middleRows(c * K, K).setZero();
      if (blocks.silent[static_cast<std::size_t>(3 + c)]) T.middleRows(c * K, K).setZero();
    }
  }

  void startScales() {
    const auto spread = [&](const MatrixXd& v, double count) {
      return std::sqrt((v.rowwise() - v.colwise().mean()).squaredNorm() / count) + 1e-12;
    };
    out.force = spread(force, countF());
    out.torque = spread(torque, countT());
    floorF = kRounding * out.force;
    floorT = kRounding * out.torque;
  }

  /// So many times: scales first from the weighted rows as they are, then with the payload that they lead to.
  void solve(int times) {
    const VectorXd root = weights.cwiseSqrt();
    for (Eigen::Index c = 0; c < 3; ++c) {
      Fw.middleRows(c * K, K).noalias() = root.asDiagonal() * F.middleRows(c * K, K);
      Tw.middleRows(c * K, K).noalias() = root.asDiagonal() * T.middleRows(c * K, K);
    }
    const MatrixXd GF = Fw.transpose() * Fw, GT = Tw.transpose() * Tw;
    for (int inner = 0; inner < times; ++inner) {
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
      out.force = std::max(floorF, std::sqrt(weights.dot(squareF) / countF()));
      out.torque = std::max(floorT, std::sqrt(weights.dot(squareT) / countT()));
      distance = squareF / (out.force * out.force) + squareT / (out.torque * out.torque);
    }
  }

  /// Scale and weights settle together.
  void settle() {
    for (int inner = 0; inner < 4; ++inner) {
      const double heard = heardF + heardT;
      weights = distance.unaryExpr([heard](double d) { return (kTailFreedom + heard) / (kTailFreedom + d); });
      const VectorXd squareF = leftF.rowwise().squaredNorm(), squareT = leftT.rowwise().squaredNorm();
      out.force = std::max(floorF, std::sqrt(weights.dot(squareF) / countF()));
      out.torque = std::max(floorT, std::sqrt(weights.dot(squareT) / countT()));
      distance = squareF / (out.force * out.force) + squareT / (out.torque * out.torque);
    }
  }

  void move(int round) {
    if (free == Free::mount) out.place.turn = rotationFromVector(x.tail<3>()) * out.place.turn;
    if (free == Free::gravity && round > 0) {
      const Vector3d moved = out.place.gravity + basis * x.tail<2>();
      out.place.gravity = gravity.norm() * moved.normalized();
    }
    if (free == Free::point) out.place.point = x.tail<3>();
    if (free == Free::origin) out.place.point = x.tail<3>() / x(0);
  }

  Fit result() {
    out.x = x.head<16>();
    const double count = countF() + countT();
    const double freedom = count / std::max(1.0, count - static_cast<double>(unknowns));
    const double lasts = blocks.rateHz > 0.0 ? std::max(lastingOf(leftF), lastingOf(leftT)) : 1.0;
    const MatrixXd covariance = freedom * lasts * inverse(A);
    out.covariance = covariance.topLeftCorner<16, 16>();
    if (extra > 0) {
      const MatrixXd ofFree = covariance.bottomRightCorner(extra, extra), shared = covariance.topRightCorner(10, extra);
      out.fromFree = shared * inverse(ofFree) * shared.transpose();
      const MatrixXd axes = free == Free::gravity ? MatrixXd(basis / gravity.norm()) : MatrixXd(Matrix3d::Identity());
      if (free == Free::mount || free == Free::gravity) out.turnCovariance = axes * ofFree * axes.transpose();
    }
    double sum = 0.0;
    for (Eigen::Index k = 0; k < K; ++k) sum += std::log1p(distance(k) / kTailFreedom);
    out.evidence =
        -2.0 * (countF() * std::log(out.force / way.forceSi) + countT() * std::log(out.torque / way.torqueSi)) -
        (kTailFreedom + heardF + heardT) * sum - static_cast<double>(extra) * std::log(count);
    out.weights = weights / weights.maxCoeff();
    out.left.resize(6, K);
    out.left << leftF.transpose(), leftT.transpose();
    const VectorXd loadF = F.leftCols<4>() * out.x.head<4>(), loadT = T.leftCols<9>() * out.x.segment<9>(1);
    out.load.resize(6, K);
    out.load << Eigen::Map<const MatrixXd>(loadF.data(), K, 3).transpose(),
        Eigen::Map<const MatrixXd>(loadT.data(), K, 3).transpose();
    return out;
  }

  const Blocks& blocks;
  const Way& way;
  const Free free;
  const Vector3d gravity;  ///< As stated
  const Eigen::Index K = blocks.size();
  const Eigen::Index extra = free == Free::nothing ? 0 : free == Free::gravity ? 2 : 3;
  /// Readings of force, and of torque.
  double countF() const { return std::max(1.0, heardF * static_cast<double>(K)); }
  double countT() const { return std::max(1.0, heardT * static_cast<double>(K)); }
  double heardF = 0.0, heardT = 0.0;  ///< Channels that are not silent
  // Columns of force: m h | bias | free | reading; of torque: h I | bias | free | reading.
  const Eigen::Index nf = 4 + 3 + extra + 1, nt = 9 + 3 + extra + 1, unknowns = 16 + extra;
  std::vector<Eigen::Index> toF, toT;  ///< Which unknown each of these columns is of
  MatrixXd readF, readT, force, torque;
  MatrixXd F = MatrixXd::Zero(3 * K, nf), T = MatrixXd::Zero(3 * K, nt);
  MatrixXd Fw = MatrixXd(3 * K, nf), Tw = MatrixXd(3 * K, nt);
  VectorXd weights = VectorXd::Ones(K), precision = VectorXd(unknowns);
  VectorXd x = VectorXd::Zero(unknowns), distance = VectorXd(K);
  MatrixXd A = MatrixXd(unknowns, unknowns), leftF, leftT;
  double floorF = 0.0, floorT = 0.0;  ///< Scales are no less: rounding
  Eigen::Matrix<double, 3, 2> basis = Eigen::Matrix<double, 3, 2>::Zero();
  Fit out;
};

}  // namespace

Fit robustFit(const Blocks& blocks, const Way& way, Free free, const Place& start, const Vector3d& gravity,
              int rounds) {
  return RobustFit(blocks, way, free, start, gravity).run(rounds);
}

}  // namespace heft::conventions
