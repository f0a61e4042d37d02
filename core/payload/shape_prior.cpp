#include "core/payload/shape_prior.h"
#include "core/math/linear_algebra.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace heft {

namespace {

/// Between wood (550) and steel (7850), and wide enough for hollow tools [kg/m3].
constexpr double kMeanDensity = 2500.0;
constexpr double kLevel = 1.0;          ///< s0
constexpr double kBetweenBodies = 0.9;  ///< sb: the standard deviation of the logarithm over common materials
constexpr double kScale = 0.005;        ///< Relative, of a mass that the user states.

struct Entry {
  int row, column;
};
// Where each coordinate stands in V, and the nine of them that move no mass.
constexpr Entry kEntries[10] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}, {0, 3}, {1, 3}, {2, 3}, {3, 3}};
constexpr int kDeformations = 9;

Matrix4d upperFactor(const Matrix4d& P) {
  const Matrix4d reversed = P.reverse();
  const Eigen::LLT<Matrix4d> llt(reversed);
  if (llt.info() != Eigen::Success) throw std::invalid_argument("ShapePrior: a body without extent");
  const Matrix4d L = llt.matrixL();
  return L.reverse();
}

double deformationSd(const ShapeTrust& trust, int k) {
  return k < 3 ? trust.stretch : k < 6 ? trust.shear : trust.shift;
}

/// V of a body with its deformation `d` (standard normal numbers), mass ratio 1.
Matrix4d deformation(const ShapeTrust& trust, const Eigen::Ref<const VectorXd>& d) {
  Matrix4d V = Matrix4d::Identity();
  for (int k = 0; k < kDeformations; ++k) {
    const double value = deformationSd(trust, k) * d(k);
    const auto [r, c] = kEntries[k];
    V(r, c) = r == c ? std::exp(value) : value;
  }
  return V;
}

/// Covariance of the density field between one point and all.
struct Kernel {
  const Eigen::Matrix3Xd& points;
  const Eigen::VectorXi& body;
  const Eigen::VectorXi& part;        ///< Number of (body, piece).
  const std::vector<double>& pieces;  ///< sp of each body
  const std::vector<double>& within;  ///< sg of each body
  double between;                     ///< sb
  double length;                      ///< L [m]

  double variance(Eigen::Index i) const {
    const auto b = static_cast<std::size_t>(body(i));
    return kLevel * kLevel + between * between + pieces[b] * pieces[b] + within[b] * within[b];
  }
  VectorXd column(Eigen::Index i) const {
    const auto b = static_cast<std::size_t>(body(i));
    VectorXd k(points.cols());
    for (Eigen::Index j = 0; j < points.cols(); ++j) {
      const double d2 = (points.col(j) - points.col(i)).squaredNorm();
      k(j) = kLevel * kLevel +
             within[b] * within[static_cast<std::size_t>(body(j))] * std::exp(-0.5 * d2 / (length * length));
      if (body(j) == body(i)) k(j) += between * between;
      if (part(j) == part(i)) k(j) += pieces[b] * pieces[b];
    }
    return k;
  }
};

/// F with F F^T close to the kernel's matrix: Cholesky with pivoting, stopped when what is left of every variance is
/// small.
MatrixXd lowRankFactor(const Kernel& kernel) {
  constexpr double kLeft = 1e-4;
  constexpr Eigen::Index kMost = 160;
  const Eigen::Index n = kernel.points.cols();
  VectorXd left(n);
  for (Eigen::Index i = 0; i < n; ++i) left(i) = kernel.variance(i);
  MatrixXd F(n, std::min(n, kMost));
  Eigen::Index rank = 0;
  while (rank < F.cols()) {
    Eigen::Index pivot = 0;
    const double largest = left.maxCoeff(&pivot);
    if (largest < kLeft) break;
    VectorXd column = kernel.column(pivot);
    column -= F.leftCols(rank) * F.row(pivot).head(rank).transpose();
    F.col(rank) = column / std::sqrt(largest);
    left -= F.col(rank).cwiseAbs2();
    left(pivot) = 0.0;
    ++rank;
  }
  return F.leftCols(rank);
}

}  // namespace

ShapeTrust trustIn(Certainty certainty, BodyKind kind, int parts) {
  const bool mesh = kind == BodyKind::mesh;
  const double within = parts > 1 ? 0.2 : 0.6;
  switch (certainty) {
    case Certainty::rough:
      return mesh ? ShapeTrust{0.10, 0.05, 0.10, 0.8, within, 0.10} : ShapeTrust{0.20, 0.10, 0.15, 0.8, within, 0.10};
    case Certainty::good:
      return mesh ? ShapeTrust{0.02, 0.01, 0.02, 0.5, 0.5 * within, 0.03}
                  : ShapeTrust{0.04, 0.02, 0.05, 0.5, 0.5 * within, 0.03};
    case Certainty::exact:
      return mesh ? ShapeTrust{0.002, 0.001, 0.002, 0.05, 0.02, 0.01}
                  : ShapeTrust{0.004, 0.002, 0.005, 0.05, 0.02, 0.01};
  }
  throw std::logic_error("trustIn: unknown certainty");
}

ShapePrior::ShapePrior(const Shape& shape, const std::vector<BodySamples>& samples) {
  if (samples.empty() || samples.size() != shape.bodies.size())
    throw std::invalid_argument("ShapePrior: one set of samples is expected for each body");
  Eigen::Index count = 0;
  int parts = 0;
  double volume = 0.0;
  Matrix4d whole = Matrix4d::Zero();
  for (const BodySamples& body : samples) {
    count += body.points.cols();
    parts += body.piece.size() > 0 ? body.piece.maxCoeff() + 1 : 1;
    volume += body.volume;
    whole += body.volume * body.unitPseudoInertia;
  }
  Eigen::Matrix3Xd points(3, count);
  Eigen::VectorXi bodyOf(count), partOf(count);
  std::vector<double> pieces, within;
  basis_.resize(10, count);
  logMass_.resize(count);
  Eigen::Index next = 0;
  int part = 0;
  for (std::size_t b = 0; b < samples.size(); ++b) {
    const BodySamples& body = samples[b];
    const ShapeBody& stated = shape.bodies[b];
    Body own;
    own.first = next;
    own.count = body.points.cols();
    // Stretches and shears along the axes of the body, not of the sensor.
    const Matrix4d X_SB = stated.X_SB.matrix(), X_BS = stated.X_SB.inverse().matrix();
    own.U = X_SB * upperFactor(X_BS * body.unitPseudoInertia * X_BS.transpose());
    own.inverseU = inverse(own.U);
    own.trust = trustIn(shape.certainty, stated.kind, parts);
    const int bodyPieces = body.piece.size() > 0 ? body.piece.maxCoeff() + 1 : 1;
    for (Eigen::Index i = 0; i < own.count; ++i, ++next) {
      points.col(next) = body.points.col(i);
      bodyOf(next) = static_cast<int>(b);
      partOf(next) = part + (body.piece.size() > 0 ? body.piece(i) : 0);
      logMass_(next) = std::log(kMeanDensity * body.volume * body.weights(i));
      const Eigen::Vector4d x = body.points.col(i).homogeneous();
      basis_.col(next) = parametersFromPseudoInertia(x * x.transpose());
    }
    part += bodyPieces;
    // A single piece has no neighbour to differ from: that is what the level of its body is for.
    pieces.push_back(bodyPieces > 1 ? own.trust.pieces : 0.0);
    within.push_back(own.trust.within);
    if (body.mass)
      observations_.push_back({static_cast<int>(b), std::log(*body.mass), stated.mass ? kScale : own.trust.density});
    bodies_.push_back(own);
  }
  if (shape.totalMass) observations_.push_back({-1, std::log(*shape.totalMass), kScale});

  const Vector3d center = whole.topRightCorner<3, 1>() / volume;
  const double gyration = std::sqrt(whole.topLeftCorner<3, 3>().trace() / volume - center.squaredNorm());
  field_ = lowRankFactor({points, bodyOf, partOf, pieces, within, samples.size() > 1 ? kBetweenBodies : 0.0, gyration});
  modes_ = field_.cols();
}

VectorXd ShapePrior::masses(const VectorXd& q) const {
  // Beyond e^50 no tool is meant; the bound only keeps a wild step of the solver finite.
  return (logMass_ + field_ * q.head(modes_)).cwiseMax(-50.0).cwiseMin(50.0).array().exp();
}

Vector10d ShapePrior::parameters(const VectorXd& q, MatrixXd* jacobian) const {
  const VectorXd mass = masses(q);
  if (jacobian) jacobian->setZero(10, size());
  Vector10d phi = Vector10d::Zero();
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const Body& body = bodies_[b];
    const Eigen::Index offset = modes_ + kDeformations * static_cast<Eigen::Index>(b);
    const auto basis = basis_.middleCols(body.first, body.count);
    const auto own = mass.segment(body.first, body.count);
    const Matrix4d P = pseudoInertia(basis * own);
    const Matrix4d V = deformation(body.trust, q.segment(offset, kDeformations));
    const Matrix4d T = body.U * V * body.inverseU;
    phi += parametersFromPseudoInertia(T * P * T.transpose());
    if (!jacobian) continue;
    // phi of T P T^T is linear in phi of P.
    Matrix10d turn;
    for (int k = 0; k < 10; ++k)
      turn.col(k) = parametersFromPseudoInertia(T * pseudoInertia(Vector10d::Unit(k)) * T.transpose());
    const MatrixXd masses = own.asDiagonal() * field_.middleRows(body.first, body.count);
    jacobian->leftCols(modes_) += product(turn, product(basis, masses));
    for (int k = 0; k < kDeformations; ++k) {
      const auto [r, c] = kEntries[k];
      const double scale = deformationSd(body.trust, k) * (r == c ? V(r, c) : 1.0);
      const Matrix4d dT = scale * body.U.col(r) * body.inverseU.row(c);
      const Matrix4d half = dT * P * T.transpose();
      jacobian->col(offset + k) = parametersFromPseudoInertia(half + half.transpose());
    }
  }
  return phi;
}

void ShapePrior::observe(const VectorXd& q, VectorXd& residuals, MatrixXd* jacobian) const {
  const auto count = static_cast<Eigen::Index>(observations_.size());
  residuals.resize(count);
  if (jacobian) jacobian->setZero(count, size());
  const VectorXd mass = masses(q);
  for (Eigen::Index i = 0; i < count; ++i) {
    const MassObservation& seen = observations_[static_cast<std::size_t>(i)];
    const bool all = seen.body < 0;
    const Eigen::Index first = all ? 0 : bodies_[static_cast<std::size_t>(seen.body)].first;
    const Eigen::Index n = all ? mass.size() : bodies_[static_cast<std::size_t>(seen.body)].count;
    const double sum = mass.segment(first, n).sum();
    residuals(i) = (std::log(sum) - seen.value) / seen.sd;
    if (jacobian)
      jacobian->row(i).head(modes_) =
          mass.segment(first, n).transpose() * field_.middleRows(first, n) / (sum * seen.sd);
  }
}

namespace {

/// d phi / d v at v = 0, with the upper factor that v multiplies.
Matrix10d directionsAt(const Vector10d& phi, Matrix4d& U0) {
  U0 = upperFactor(pseudoInertia(phi));
  Matrix10d G;
  for (int k = 0; k < 10; ++k) {
    const auto [r, c] = kEntries[k];
    const Matrix4d half = U0.col(r) * U0.col(c).transpose();
    G.col(k) = parametersFromPseudoInertia(half + half.transpose());
  }
  return G;
}

}  // namespace

ShapeFit ShapePrior::fit(const MatrixXd& A, const VectorXd& y) const {
  if (A.cols() != 10 || A.rows() != y.size() || !A.allFinite() || !y.allFinite())
    throw std::invalid_argument("ShapePrior::fit: A must be m x 10, y of length m, both finite");
  VectorXd q = VectorXd::Zero(size()), seen;
  const auto cost = [&](const VectorXd& x) {
    VectorXd r;
    observe(x, r, nullptr);
    return (A * parameters(x) - y).squaredNorm() + r.squaredNorm() + x.squaredNorm();
  };
  ShapeFit result;
  MatrixXd J, dSeen, prior;
  Vector10d phi;
  VectorXd gradient;
  const auto linearise = [&] {
    phi = parameters(q, &J);
    observe(q, seen, &dSeen);
    prior = transposedProduct(dSeen, dSeen);
    prior.diagonal().array() += 1.0;
  };
  double best = cost(q), damping = 1e-3;
  for (result.iterations = 0; result.iterations < 200; ++result.iterations) {
    linearise();
    const MatrixXd AJ = product(A, J);
    const MatrixXd H = prior + transposedProduct(AJ, AJ);
    gradient = AJ.transpose() * (A * phi - y) + dSeen.transpose() * seen + q;
    const double slope = std::sqrt(std::max(0.0, gradient.dot(solveSymmetric(H, gradient))));
    if (slope < 1e-7) {
      result.converged = true;
      break;
    }
    bool improved = false;
    for (int attempt = 0; attempt < 30 && !improved; ++attempt) {
      MatrixXd damped = H;
      damped.diagonal() += damping * prior.diagonal();
      VectorXd step = -solveSymmetric(damped, gradient);
      // The exponentials are trusted over two standard deviations at a time.
      const double longest = step.cwiseAbs().maxCoeff();
      if (longest > 2.0) step *= 2.0 / longest;
      const double value = cost(q + step);
      if (std::isfinite(value) && value < best) {
        improved = true;
        best = value;
        q += step;
        damping = std::max(1e-12, damping * 0.1);
      } else {
        damping *= 5.0;
      }
    }
    if (!improved) {
      result.converged = slope < 1e-3;  // rounding, not a slope, stops it
      break;
    }
  }

  linearise();
  const MatrixXd AJ = product(A, J);
  const SymmetricSolver posterior(prior + transposedProduct(AJ, AJ)), priorOnly(prior);
  result.phi = phi;
  result.covariance = product(J, posterior.solveAll(J.transpose()));
  result.priorCovariance = product(J, priorOnly.solveAll(J.transpose()));
  result.conflict = q.squaredNorm() + seen.squaredNorm();

  const Matrix10d G = directionsAt(phi, result.U0);
  const MatrixXd toV = product(inverse(G), J);
  result.information =
      SymmetricSolver(product(toV, priorOnly.solveAll(toV.transpose()))).solveAll(Matrix10d::Identity());
  result.information = 0.5 * (result.information + result.information.transpose()).eval();
  // The prior's own Gauss-Newton step from here leads to its mean.
  result.mean = -toV * priorOnly.solve(q + dSeen.transpose() * seen);
  weighBodies(q, posterior, result);
  return result;
}

void ShapePrior::weighBodies(const VectorXd& q, const SymmetricSolver& posterior, ShapeFit& result) const {
  const VectorXd mass = masses(q);
  for (const Body& body : bodies_) {
    const VectorXd own = mass.segment(body.first, body.count);
    VectorXd slope = VectorXd::Zero(size());
    slope.head(modes_) = field_.middleRows(body.first, body.count).transpose() * own;
    result.bodyMass.push_back(own.sum());
    result.bodyMassStd.push_back(std::sqrt(std::max(0.0, slope.dot(posterior.solve(slope)))));
  }
}

}  // namespace heft
