#include "core/estimation/map.h"

#include <cmath>
#include <stdexcept>

namespace heft {

namespace {

struct Entry {
  int row, column;
};
// Where each coordinate stands in V.
constexpr Entry kEntries[10] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}, {0, 3}, {1, 3}, {2, 3}, {3, 3}};

Matrix4d matrixV(const Vector10d& v) {
  Matrix4d V = Matrix4d::Zero();
  for (int i = 0; i < 10; ++i) {
    const auto [r, c] = kEntries[i];
    V(r, c) = r == c ? std::exp(v(i)) : v(i);
  }
  return V;
}

}  // namespace

double MapPrior::cost(const Vector10d& v) const {
  const Vector10d d = v - mean;
  if (form == PriorForm::normal) return d.dot(information * d);
  double sum = 0.0;
  for (int i = 0; i < 10; ++i) {
    const double w = information(i, i);
    sum += kEntries[i].row == kEntries[i].column ? 0.5 * w * (std::expm1(2.0 * d(i)) - 2.0 * d(i)) : w * d(i) * d(i);
  }
  return sum;
}

Vector10d MapPrior::halfGradient(const Vector10d& v) const {
  Vector10d d = v - mean;
  if (form == PriorForm::normal) return information * d;
  for (int i = 0; i < 10; ++i) {
    if (kEntries[i].row == kEntries[i].column) d(i) = 0.5 * std::expm1(2.0 * d(i));
    d(i) *= information(i, i);
  }
  return d;
}

Matrix10d MapPrior::curvature(const Vector10d& v) const {
  if (form == PriorForm::normal) return information;
  Vector10d diagonal = information.diagonal();
  for (int i = 0; i < 10; ++i)
    if (kEntries[i].row == kEntries[i].column) diagonal(i) *= std::exp(2.0 * (v(i) - mean(i)));
  return diagonal.asDiagonal();
}

Matrix4d upperFactor(const Matrix4d& P) {
  // Cholesky of the matrix with rows and columns in reverse order gives an upper factor in the usual order.
  const Matrix4d reversed = P.reverse();
  const Eigen::LLT<Matrix4d> llt(reversed);
  if (llt.info() != Eigen::Success || !P.allFinite())
    throw std::invalid_argument("upperFactor: the pseudo-inertia is not positive definite");
  const Matrix4d L = llt.matrixL();
  return L.reverse();
}

MapPrior vaguePrior(double mass, const Vector3d& com) {
  constexpr double kRadius = 0.05;  // [m] in each axis
  Matrix4d P0;
  P0.topLeftCorner<3, 3>() = mass * (kRadius * kRadius * Matrix3d::Identity() + com * com.transpose());
  P0.topRightCorner<3, 1>() = mass * com;
  P0.bottomLeftCorner<1, 3>() = mass * com.transpose();
  P0(3, 3) = mass;
  MapPrior prior;
  prior.U0 = upperFactor(P0);
  Vector10d sd;
  sd << 0.8, 0.8, 0.8, 0.6, 0.6, 0.6, 3.0, 3.0, 3.0, 0.75;
  prior.information = sd.cwiseAbs2().cwiseInverse().asDiagonal();
  prior.form = PriorForm::entropic;
  return prior;
}

Vector10d parametersFromV(const MapPrior& prior, const Vector10d& v) {
  const Matrix4d U = prior.U0 * matrixV(v);
  return parametersFromPseudoInertia(U * U.transpose());
}

Matrix10d parametersJacobian(const MapPrior& prior, const Vector10d& v) {
  const Matrix4d U = prior.U0 * matrixV(v);
  Matrix10d J;
  for (int i = 0; i < 10; ++i) {
    const auto [r, c] = kEntries[i];
    const double scale = r == c ? std::exp(v(i)) : 1.0;
    // dP = (U0 E_rc) U^T + its transpose, with E_rc the unit matrix entry.
    const Matrix4d half = scale * prior.U0.col(r) * U.col(c).transpose();
    J.col(i) = parametersFromPseudoInertia(half + half.transpose());
  }
  return J;
}

Vector10d vFromParameters(const MapPrior& prior, const Vector10d& phi) {
  const Matrix4d V = prior.U0.triangularView<Eigen::Upper>().solve(upperFactor(pseudoInertia(phi)));
  Vector10d v;
  for (int i = 0; i < 10; ++i) {
    const auto [r, c] = kEntries[i];
    v(i) = r == c ? std::log(V(r, c)) : V(r, c);
  }
  return v;
}

// Rows below the biases are the problem with the biases already eliminated. Without biases their columns drop out and
// all rows count.
MapCost::MapCost(const Triangle& R, const MapPrior& prior, bool bias)
    : prior_(prior),
      A_(R.block(bias ? kBiasColumns : 0, kBiasColumns, bias ? 11 : 17, 10)),
      y_(R.col(kColumns).tail(bias ? 11 : 17)) {}

double MapCost::operator()(const Vector10d& v) const {
  return (A_ * parametersFromV(prior_, v) - y_).squaredNorm() + prior_.cost(v);
}

MapSolution solveMap(const Triangle& R, const MapPrior& prior, bool bias, const Vector10d& start) {
  const MapCost cost(R, prior, bias);
  const MatrixXd& A = cost.A();
  const VectorXd& y = cost.y();
  MapSolution solution;
  solution.v = start;
  double best = cost(start);
  double damping = 1e-6;
  Matrix10d J, data;
  for (solution.iterations = 0; solution.iterations < 1000; ++solution.iterations) {
    J = parametersJacobian(prior, solution.v);
    const MatrixXd AJ = A * J;
    data = AJ.transpose() * AJ;
    const Matrix10d H = data + prior.curvature(solution.v);
    const Vector10d gradient =
        AJ.transpose() * (A * parametersFromV(prior, solution.v) - y) + prior.halfGradient(solution.v);
    // Gradient in units of the posterior's own standard deviations.
    const double slope = std::sqrt(std::max(0.0, gradient.dot(H.ldlt().solve(gradient))));
    if (slope < 1e-7) {
      solution.converged = true;
      break;
    }
    bool improved = false;
    for (int attempt = 0; attempt < 30 && !improved; ++attempt) {
      Matrix10d damped = H;
      damped.diagonal() *= 1.0 + damping;
      Vector10d step = -damped.ldlt().solve(gradient);
      // The exponentials are trusted over a factor of two at a time.
      const double longest = step.cwiseAbs().maxCoeff();
      if (longest > 2.0) step *= 2.0 / longest;
      const double next = cost(solution.v + step);
      if (std::isfinite(next) && next < best) {
        improved = true;
        best = next;
        solution.v += step;
        damping = std::max(1e-12, damping * 0.1);
      } else {
        damping *= 10.0;
      }
    }
    if (!improved) {
      solution.converged = slope < 1e-2;  // rounding, not a slope, stops it
      break;
    }
  }
  J = parametersJacobian(prior, solution.v);
  const MatrixXd AJ = A * J;
  solution.dataInformation = AJ.transpose() * AJ;
  solution.covariance = (solution.dataInformation + prior.curvature(solution.v)).inverse();
  solution.phi = parametersFromV(prior, solution.v);
  if (bias)
    solution.bias = R.topLeftCorner<6, 6>().triangularView<Eigen::Upper>().solve(
        R.block<6, 1>(0, kColumns) - R.block<6, 10>(0, kBiasColumns) * solution.phi);
  return solution;
}

}  // namespace heft
