#include "core/diagnosis/pose_fit.h"

#include <algorithm>
#include <cmath>

#include "core/math/linear_algebra.h"

namespace heft::diagnosis {

namespace {

constexpr double kNu = 4.0;  ///< Degrees of freedom of the t-distribution

}  // namespace

Wrenches expectedOf(const PosesSeen& poses, const PoseState& state) {
  Wrenches out = predicted(poses.signals, state.modelled());
  for (const auto& [candidate, v] : state.terms) {
    if (candidate.form) continue;
    const InOrder& order = candidate.inOrder;
    for (Eigen::Index k = 0; k < poses.count(); ++k) {
      if (order.course == Course::drift) {
        out.col(k) += (static_cast<double>(k) - 0.5 * static_cast<double>(poses.count() - 1)) * v;
      } else if (k >= order.from && order.course == Course::jump) {
        out.col(k) += v;
      } else if (k >= order.from) {
        const Vector3d s = poses.signals.kinematics.specificForce.col(k);
        out.col(k).head<3>() += v(0) * s;
        out.col(k).tail<3>() += Vector3d(v.tail<3>()).cross(s);
      }
    }
  }
  return out;
}

MatrixXd jacobianOf(const PosesSeen& poses, const PoseState& state) {
  const VectorXd at = state.packed();
  VectorXd step = VectorXd::Constant(at.size(), 1e-4);
  Eigen::Index i = 10;
  for (const auto& [candidate, v] : state.terms)
    for (Eigen::Index p = 0; p < v.size(); ++p, ++i)
      if (candidate.form) step(i) = 1e-3 * candidate.form->parameters[static_cast<std::size_t>(p)].size;
  MatrixXd out(6 * poses.count(), at.size());
  PoseState moved = state;
  for (i = 0; i < at.size(); ++i) {
    VectorXd x = at;
    x(i) = at(i) + step(i);
    moved.unpack(x);
    const Wrenches up = expectedOf(poses, moved);
    x(i) = at(i) - step(i);
    moved.unpack(x);
    out.col(i) = flat(Wrenches((up - expectedOf(poses, moved)) / (2.0 * step(i))));
  }
  return out;
}

VectorXd scalesOf(const PoseFit& fit) {
  VectorXd out(fit.residual.size());
  for (Eigen::Index k = 0; k < fit.residual.cols(); ++k) {
    const double root = std::sqrt(fit.weights(k));
    out.segment<3>(6 * k).setConstant(root / fit.force);
    out.segment<3>(6 * k + 3).setConstant(root / fit.torque);
  }
  return out;
}

VectorXd solved(const MatrixXd& J, const VectorXd& r) {
  const VectorXd norms = J.colwise().norm().transpose().cwiseMax(1e-12);
  return norms.cwiseInverse().cwiseProduct(shortestLeastSquares(J * norms.cwiseInverse().asDiagonal(), r, 1e-7));
}

PoseFit fitted(const PosesSeen& poses, PoseState state, const VectorXd& used) {
  constexpr int kRounds = 25;
  constexpr double kLeast = 1e-6;  // [N], [N m]: simulated without noise
  const Eigen::Index K = poses.count();
  const auto rows = 3.0 * static_cast<double>(K);
  PoseFit fit;
  fit.weights = used.size() > 0 ? used : VectorXd(VectorXd::Ones(K));
  double last = -1e300;
  for (int round = 0;; ++round) {
    fit.residual = poses.signals.measured - expectedOf(poses, state);
    double f = 0.0, t = 0.0;
    for (Eigen::Index k = 0; k < K; ++k) {
      f += fit.weights(k) * fit.residual.col(k).head<3>().squaredNorm();
      t += fit.weights(k) * fit.residual.col(k).tail<3>().squaredNorm();
    }
    // Half of the parameters are told by the force, half by the torque.
    const double judged =
        used.size() > 0 ? std::max(1.0, 3.0 * used.sum() - 0.5 * static_cast<double>(state.size())) : rows;
    fit.force = std::max(kLeast, std::sqrt(f / judged));
    fit.torque = std::max(kLeast, std::sqrt(t / judged));
    double likelihood = -rows * 2.0 * (std::log(fit.force) + std::log(fit.torque));
    for (Eigen::Index k = 0; k < K; ++k) {
      const double d = fit.residual.col(k).head<3>().squaredNorm() / (fit.force * fit.force) +
                       fit.residual.col(k).tail<3>().squaredNorm() / (fit.torque * fit.torque);
      likelihood -= (kNu + 6.0) * std::log1p(d / kNu);
      if (used.size() == 0) fit.weights(k) = (kNu + 6.0) / (kNu + d);
    }
    fit.evidence = likelihood - static_cast<double>(state.size() - 10) * std::log(2.0 * rows);
    fit.state = state;
    if (round == kRounds || (round > 3 && std::abs(likelihood - last) < 1e-3)) break;
    last = likelihood;
    const VectorXd scale = scalesOf(fit);
    fit.jacobian = jacobianOf(poses, state);
    const VectorXd step = solved(scale.asDiagonal() * fit.jacobian, scale.cwiseProduct(flat(fit.residual)));
    state.unpack(state.packed() + step);
  }
  const VectorXd scale = scalesOf(fit);
  fit.jacobian = scale.asDiagonal() * jacobianOf(poses, fit.state);
  const MatrixXd& J = fit.jacobian;
  const VectorXd norms = J.colwise().norm().transpose().cwiseMax(1e-12);
  MatrixXd N = norms.cwiseInverse().asDiagonal() * (J.transpose() * J) * norms.cwiseInverse().asDiagonal();
  // A pull straight up is a smaller mass, exactly: of such pairs neither is told, and as little is made of it as can
  // be.
  constexpr double kTold = 1e-9;
  const auto [values, V] = symmetricEigen(N);
  const auto isTold = values.array() > kTold * values(values.size() - 1);
  const VectorXd inverse = isTold.select(values.cwiseMax(1e-300).cwiseInverse(), 0.0),
                 untold = isTold.select(VectorXd::Zero(values.size()), 1.0);
  fit.covariance =
      norms.cwiseInverse().asDiagonal() * V * inverse.asDiagonal() * V.transpose() * norms.cwiseInverse().asDiagonal();
  fit.untold = V.cwiseAbs2() * untold;
  return fit;
}

}  // namespace heft::diagnosis
