#include "core/estimation/map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/estimation/triangle.h"
#include "core/math/linear_algebra.h"

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

/// Pseudo-inertia of a body with this mass, centre and covariance of its mass.
Matrix4d bodyOf(double mass, const Vector3d& com, const Matrix3d& spread) {
  Matrix4d P;
  P.topLeftCorner<3, 3>() = mass * (spread + com * com.transpose());
  P.topRightCorner<3, 1>() = mass * com;
  P.bottomLeftCorner<1, 3>() = mass * com.transpose();
  P(3, 3) = mass;
  return P;
}

/// d as the square root of half its entropic divergence, (exp(2 d) - 2 d - 1) / 2, with its sign; and the derivative.
std::pair<double, double> entropicRoot(double d) {
  if (std::abs(d) < 1e-4) return {d * (1.0 + d / 3.0), 1.0 + 2.0 * d / 3.0};
  const double size = std::sqrt(0.5 * (std::expm1(2.0 * d) - 2.0 * d));
  const double root = d > 0.0 ? size : -size;
  return {root, 0.5 * std::expm1(2.0 * d) / root};
}

/// The ten numbers of a stated payload at U = U0 V, and their derivatives by v.
Vector10d residualsOf(const StatedTerm& term, const Matrix4d& U0, const Vector10d& v, Matrix10d& jacobian) {
  const Matrix4d left = term.inverseU * U0;
  const Matrix4d V = matrixV(v), W = left * V;
  Vector10d residual = Vector10d::Zero();
  jacobian.setZero();
  for (int i = 0; i < 10; ++i) {
    if (term.weight(i) == 0.0) continue;
    const auto [r, c] = kEntries[i];
    // Derivative of an entry of W by coordinate k: column c_k of W moves by left's column r_k.
    const auto entry = [&](int row, int column, int k) {
      const auto [rk, ck] = kEntries[k];
      return column == ck ? left(row, rk) * (rk == ck ? V(rk, rk) : 1.0) : 0.0;
    };
    if (r == c) {
      const double d = std::log(W(r, r)) - (r < 3 ? std::log(W(3, 3)) : 0.0);
      const auto [root, slope] = entropicRoot(d);
      residual(i) = term.weight(i) * root;
      for (int k = 0; k < 10; ++k)
        jacobian(i, k) = term.weight(i) * slope * (entry(r, r, k) / W(r, r) - (r < 3 ? entry(3, 3, k) / W(3, 3) : 0.0));
    } else {
      residual(i) = term.weight(i) * W(r, c) / W(3, 3);
      for (int k = 0; k < 10; ++k)
        jacobian(i, k) = term.weight(i) * (entry(r, c, k) - W(r, c) / W(3, 3) * entry(3, 3, k)) / W(3, 3);
    }
  }
  return residual;
}

}  // namespace

StatedTerm termFrom(const StatedPayload& stated) {
  const double mass = stated.mass.value_or(1.0);
  const Vector3d com = stated.com.value_or(Vector3d::Zero());
  const Matrix3d spread = stated.spread.value_or(kUsualRadius * kUsualRadius * Matrix3d::Identity());
  StatedTerm term;
  term.inverseU = inverse(upperFactor(bodyOf(mass, com, spread)));
  if (stated.spread) term.weight.head<6>().setConstant(1.0 / stated.shapeStd);
  if (stated.com) term.weight.segment<3>(6).setConstant(1.0 / stated.centreStd);
  if (stated.mass) term.weight(9) = 2.0 / stated.massStd;
  return term;
}

LinearTerm linearised(const StatedTerm& term, const Vector10d& phi) {
  MapPrior here;
  here.U0 = upperFactor(pseudoInertia(phi));
  Matrix10d byV;
  const Vector10d residual = residualsOf(term, here.U0, Vector10d::Zero(), byV);
  const Matrix10d A = product(byV, inverse(parametersJacobian(here, Vector10d::Zero())));
  return {A, A * phi - residual};
}

Matrix10d MapPrior::statedInformation(const Vector10d& v, Vector10d* halfGradient) const {
  Matrix10d sum = Matrix10d::Zero(), J;
  for (const auto& term : stated) {
    const Vector10d residual = residualsOf(term, U0, v, J);
    sum += transposedProduct(J, J);
    if (halfGradient) *halfGradient += J.transpose() * residual;
  }
  return sum;
}

double MapPrior::cost(const Vector10d& v) const {
  double sum = 0.0;
  Matrix10d unused;
  for (const auto& term : stated) sum += residualsOf(term, U0, v, unused).squaredNorm();
  const Vector10d d = v - mean;
  if (form == PriorForm::normal) return sum + d.dot(information * d);
  for (int i = 0; i < 10; ++i) {
    const double w = information(i, i);
    sum += kEntries[i].row == kEntries[i].column ? 0.5 * w * (std::expm1(2.0 * d(i)) - 2.0 * d(i)) : w * d(i) * d(i);
  }
  return sum;
}

Vector10d MapPrior::halfGradient(const Vector10d& v) const {
  Vector10d sum = Vector10d::Zero();
  if (!stated.empty()) statedInformation(v, &sum);
  Vector10d d = v - mean;
  if (form == PriorForm::normal) return sum + information * d;
  for (int i = 0; i < 10; ++i) {
    if (kEntries[i].row == kEntries[i].column) d(i) = 0.5 * std::expm1(2.0 * d(i));
    d(i) *= information(i, i);
  }
  return sum + d;
}

Matrix10d MapPrior::curvature(const Vector10d& v) const {
  if (form == PriorForm::normal) return normalInformation(v);
  Vector10d diagonal = information.diagonal();
  for (int i = 0; i < 10; ++i)
    if (kEntries[i].row == kEntries[i].column) diagonal(i) *= std::exp(2.0 * (v(i) - mean(i)));
  return Matrix10d(diagonal.asDiagonal()) + statedInformation(v, nullptr);
}

Matrix10d MapPrior::normalInformation(const Vector10d& v) const { return information + statedInformation(v, nullptr); }

Matrix4d upperFactor(const Matrix4d& P) {
  // Cholesky of the matrix with rows and columns in reverse order gives an upper factor in the usual order.
  const Matrix4d reversed = P.reverse();
  const Eigen::LLT<Matrix4d> llt(reversed);
  if (llt.info() != Eigen::Success || !P.allFinite())
    throw std::invalid_argument("upperFactor: the pseudo-inertia is not positive definite");
  const Matrix4d L = llt.matrixL();
  return L.reverse();
}

MapPrior vaguePrior(double mass, const Vector3d& com, const Matrix3d& spread) {
  MapPrior prior;
  prior.U0 = upperFactor(bodyOf(mass, com, spread));
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

MapSolution solutionAt(const Triangle& R, const MapPrior& prior, bool bias, const Vector10d& v) {
  MapSolution solution;
  solution.v = v;
  const MatrixXd AJ = product(MapCost(R, prior, bias).A(), parametersJacobian(prior, v));
  solution.dataInformation = transposedProduct(AJ, AJ);
  solution.covariance = inverse(solution.dataInformation + prior.curvature(v));
  solution.phi = parametersFromV(prior, v);
  if (bias)
    solution.bias = solveUpper(R.topLeftCorner<6, 6>(),
                               R.block<6, 1>(0, kColumns) - R.block<6, 10>(0, kBiasColumns) * solution.phi);
  return solution;
}

MapSolution solveMap(const Triangle& R, const MapPrior& prior, bool bias, const Vector10d& start) {
  const MapCost cost(R, prior, bias);
  const MatrixXd& A = cost.A();
  const VectorXd& y = cost.y();
  MapSolution solution;
  solution.v = start;
  double best = cost(start);
  double damping = 1e-6;
  double slope = std::numeric_limits<double>::infinity();  // Gradient in units of the posterior's standard deviations
  Matrix10d J, data;
  for (solution.iterations = 0; solution.iterations < 1000; ++solution.iterations) {
    J = parametersJacobian(prior, solution.v);
    const MatrixXd AJ = product(A, J);
    data = transposedProduct(AJ, AJ);
    const Matrix10d H = data + prior.curvature(solution.v);
    const Vector10d gradient =
        AJ.transpose() * (A * parametersFromV(prior, solution.v) - y) + prior.halfGradient(solution.v);
    slope = std::sqrt(std::max(0.0, gradient.dot(solveSymmetric(H, gradient))));
    if (slope < 1e-7) {
      solution.converged = true;
      break;
    }
    bool improved = false;
    for (int attempt = 0; attempt < 30 && !improved; ++attempt) {
      Matrix10d damped = H;
      damped.diagonal() *= 1.0 + damping;
      Vector10d step = -solveSymmetric(damped, gradient);
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
    if (!improved) break;
  }
  // Where rounding or a long bent valley stops it, a hundredth of a standard deviation is near enough.
  solution.converged = solution.converged || slope < 1e-2;
  MapSolution found = solutionAt(R, prior, bias, solution.v);
  found.iterations = solution.iterations;
  found.converged = solution.converged;
  return found;
}

Triangle priorRows(const MapPrior& prior, const Vector10d& v) {
  const MatrixXd L = choleskyFactor(prior.curvature(v));
  Eigen::Matrix<double, 10, kColumns + 1> rows;
  rows.setZero();
  const Matrix10d A = transposedProduct(L, inverse(parametersJacobian(prior, v)));
  rows.middleCols<10>(kBiasColumns) = A;
  rows.col(kColumns) = A * parametersFromV(prior, v) - L.triangularView<Eigen::Lower>().solve(prior.halfGradient(v));
  TriangleBuilder builder;
  builder.add(rows);
  return builder.finish();
}

}  // namespace heft
