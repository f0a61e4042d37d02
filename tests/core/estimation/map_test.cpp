#include "core/estimation/map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/estimation/triangle.h"
#include "core/estimation/uncertainty.h"
#include "tests/support/random_payload.h"

namespace heft {
namespace {

/// A whitened triangle of random motion with `scale` times unit noise information.
Triangle randomTriangle(std::mt19937& random, const Payload& truth, double scale, double alpha) {
  std::normal_distribution<double> normal;
  TriangleBuilder builder;
  const Vector10d phi = toParameters(truth);
  for (int k = 0; k < 200; ++k) {
    WrenchState state{test::randomRotation(random) * Vector3d(0, 0, 9.81), test::randomVector(random, alpha / 4),
                      test::randomVector(random, alpha)};
    const Regressor Y = regressor(state);
    const Vector6d F = Y * phi;
    for (int c = 0; c < 6; ++c) {
      Eigen::Matrix<double, 1, kColumns + 1> row;
      row.setZero();
      row(c) = 1.0;
      row.segment<10>(6) = Y.row(c);
      row(kColumns) = F(c) + normal(random) / (c < 3 ? scale : 20.0 * scale);
      builder.add(row * (c < 3 ? scale : 20.0 * scale));
    }
  }
  return builder.finish();
}

TEST(Map, UpperFactorAndCoordinatesRoundTrip) {
  std::mt19937 random(1);
  for (int i = 0; i < 50; ++i) {
    const Vector10d phi = toParameters(test::randomPayload(random));
    const Matrix4d U = upperFactor(pseudoInertia(phi));
    EXPECT_LT((U * U.transpose() - pseudoInertia(phi)).norm(), 1e-15);
    EXPECT_EQ(U(1, 0), 0.0);
    const MapPrior prior = vaguePrior(0.7, {0.01, 0.02, 0.05});
    EXPECT_LT((parametersFromV(prior, vFromParameters(prior, phi)) - phi).norm(), 1e-13);
  }
  EXPECT_THROW(upperFactor(-Matrix4d::Identity()), std::invalid_argument);
}

TEST(Map, TheJacobianIsTheDerivative) {
  std::mt19937 random(2);
  const MapPrior prior = vaguePrior(0.7, {0.01, 0.02, 0.05});
  const Vector10d v = 0.3 * Vector10d::Random();
  const Matrix10d J = parametersJacobian(prior, v);
  for (int i = 0; i < 10; ++i) {
    Vector10d up = v, down = v;
    up(i) += 1e-6;
    down(i) -= 1e-6;
    EXPECT_LT((J.col(i) - (parametersFromV(prior, up) - parametersFromV(prior, down)) / 2e-6).norm(), 1e-8);
    EXPECT_NEAR(prior.halfGradient(v)(i), (prior.cost(up) - prior.cost(down)) / 4e-6, 1e-6 * prior.information(i, i));
  }
}

TEST(Map, TheLastCoordinatesAreCentreAndMass) {
  const MapPrior prior = vaguePrior(0.5, {0.0, 0.0, 0.1});
  Vector10d v = Vector10d::Zero();
  v(9) = 0.5 * std::log(3.0);  // half the logarithm of the mass ratio
  EXPECT_NEAR(parametersFromV(prior, v)(0), 1.5, 1e-12);
  v.setZero();
  v(6) = 1.0;  // one standard deviation of the body (5 cm) along x
  EXPECT_NEAR(fromParameters(parametersFromV(prior, v)).com.x(), 0.05, 1e-12);
}

TEST(Map, EveryValueOfVIsPhysical) {
  std::mt19937 random(3);
  const MapPrior prior = vaguePrior(0.5, {0.0, 0.0, 0.1});
  for (int i = 0; i < 500; ++i)
    EXPECT_TRUE(checkPhysical(fromParameters(parametersFromV(prior, 2.0 * Vector10d::Random()))).physical);
}

TEST(Map, ConvergesToTheSamePointFromAnywhere) {
  std::mt19937 random(4);
  for (int trial = 0; trial < 20; ++trial) {
    const Payload truth = test::randomPayload(random);
    const Triangle R = randomTriangle(random, truth, trial % 2 ? 10.0 : 0.5, trial % 3 ? 2.0 : 0.1);
    const MapPrior prior = vaguePrior(1.0, {0.0, 0.0, 0.05});
    const MapSolution first = solveMap(R, prior, true, Vector10d::Zero());
    ASSERT_TRUE(first.converged);
    for (int start = 0; start < 5; ++start) {
      const MapSolution other = solveMap(R, prior, true, 0.7 * Vector10d::Random());
      EXPECT_TRUE(other.converged);
      EXPECT_LT((other.phi - first.phi).norm(), 1e-5 * first.phi.norm()) << trial << " " << start;
    }
  }
}

/// The same cost in the entries of P, where it is convex (least squares is quadratic in phi, the entropic term is
/// tr(P0^-1 P)
/// - ln|P|): Newton's method there has no local optimum to be caught in.
Vector10d convexOptimum(const Triangle& R, const Matrix4d& P0, double gamma) {
  const MatrixXd A = R.block<11, 10>(kBiasColumns, kBiasColumns);
  const VectorXd y = R.block<11, 1>(kBiasColumns, kColumns);
  const Matrix4d inverse0 = P0.inverse();
  const auto cost = [&](const Vector10d& phi) {
    const Matrix4d P = pseudoInertia(phi);
    const Eigen::LLT<Matrix4d> llt(P);
    if (llt.info() != Eigen::Success) return std::numeric_limits<double>::infinity();
    const Matrix4d L = llt.matrixL();
    return (A * phi - y).squaredNorm() + gamma * ((inverse0 * P).trace() - 2.0 * L.diagonal().array().log().sum());
  };
  Vector10d phi = parametersFromPseudoInertia(P0);
  for (int iteration = 0; iteration < 500; ++iteration) {
    const Matrix4d inverse = pseudoInertia(phi).inverse();
    Vector10d gradient = 2.0 * A.transpose() * (A * phi - y);
    Matrix10d H = 2.0 * A.transpose() * A;
    std::array<Matrix4d, 10> E;
    for (int i = 0; i < 10; ++i) E[static_cast<std::size_t>(i)] = pseudoInertia(Vector10d::Unit(i));
    for (int i = 0; i < 10; ++i) {
      const Matrix4d& Ei = E[static_cast<std::size_t>(i)];
      gradient(i) += gamma * ((inverse0 - inverse) * Ei).trace();
      for (int j = 0; j < 10; ++j) H(i, j) += gamma * (inverse * Ei * inverse * E[static_cast<std::size_t>(j)]).trace();
    }
    const VectorXd scale = H.diagonal().cwiseSqrt().cwiseInverse();
    const Vector10d step =
        -(scale.asDiagonal() *
          (scale.asDiagonal() * H * scale.asDiagonal()).eval().ldlt().solve(VectorXd(scale.cwiseProduct(gradient))));
    double length = 1.0;
    while (length > 1e-12 && !(cost(phi + length * step) < cost(phi))) length *= 0.5;
    if (length <= 1e-12) break;
    phi += length * step;
    if (-gradient.dot(step) < 1e-18) break;
  }
  return phi;
}

TEST(Map, IsTheGlobalOptimumOfTheConvexProblem) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 15; ++trial) {
    const Payload truth = test::randomPayload(random);
    const Triangle R = randomTriangle(random, truth, trial % 2 ? 5.0 : 0.3, trial % 3 ? 3.0 : 0.2);
    const double gamma = trial % 2 ? 1.0 : 20.0;
    MapPrior prior = vaguePrior(0.8, {0.01, 0.0, 0.06});
    prior.form = PriorForm::entropic;
    // Equal weights: cost = gamma D. In V the squares of off-diagonals carry gamma, the exponentials 2 gamma / 2.
    Vector10d weights;
    weights << 2, 2, 2, 1, 1, 1, 1, 1, 1, 2;
    prior.information = (gamma * weights).asDiagonal();
    const MapSolution map = solveMap(R, prior, true, Vector10d::Zero());
    ASSERT_TRUE(map.converged);
    const Vector10d convex = convexOptimum(R, prior.U0 * prior.U0.transpose(), gamma);
    EXPECT_LT((map.phi - convex).norm(), 1e-5 * convex.norm())
        << "map    " << map.phi.transpose() << "\nconvex " << convex.transpose();
  }
}

TEST(Map, WithoutDataItIsThePrior) {
  const MapPrior prior = vaguePrior(0.8, {0.01, 0.0, 0.06});
  const MapSolution map = solveMap(Triangle::Zero(), prior, true, 0.3 * Vector10d::Ones());
  EXPECT_TRUE(map.converged);
  EXPECT_LT((map.phi - parametersFromV(prior, prior.mean)).norm(), 1e-6);
}

TEST(Uncertainty, IntervalsOfWideDistributionsStayPositive) {
  const MapPrior prior = vaguePrior(0.8, {0.01, 0.0, 0.06});
  const MapSolution map = solveMap(Triangle::Zero(), prior, true, Vector10d::Zero());
  const PayloadInterval intervals = intervalsFromV(Triangle::Zero(), prior, true, map);
  EXPECT_GT(intervals.mass.lower, 0.0);
  EXPECT_LT(intervals.mass.lower, 0.2);
  EXPECT_GT(intervals.mass.upper, 3.0);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_GT(intervals.inertiaCom[i][i].lower, 0.0);
}

TEST(Uncertainty, NarrowDistributionsAgreeWithLinearPropagation) {
  std::mt19937 random(6);
  const Payload truth = test::randomPayload(random);
  const Triangle R = randomTriangle(random, truth, 100.0, 5.0);
  const MapPrior prior = vaguePrior(0.8, {0.01, 0.0, 0.06});
  const MapSolution map = solveMap(R, prior, true, Vector10d::Zero());
  const PayloadInterval drawn = intervalsFromV(R, prior, true, map);
  const Matrix10d J = componentsJacobian(map.phi) * parametersJacobian(prior, map.v);
  const PayloadInterval linear =
      intervalsFromCovariance(componentsOf(fromParameters(map.phi)), J * map.covariance * J.transpose());
  EXPECT_NEAR(drawn.mass.upper - drawn.mass.lower, linear.mass.upper - linear.mass.lower,
              0.06 * (linear.mass.upper - linear.mass.lower));
  const auto& a = drawn.inertiaCom[1][2];
  const auto& b = linear.inertiaCom[1][2];
  EXPECT_NEAR(a.upper - a.lower, b.upper - b.lower, 0.06 * (b.upper - b.lower));
  EXPECT_NEAR(componentsOf(payloadFromComponents(Vector10d::LinSpaced(1, 10)))(7), 8.0, 1e-15);
}

/// A second's motion, noisy enough that what the readings alone say is no body that can exist.
Triangle besideTheEdge(std::mt19937& random) {
  for (;;) {
    const Triangle R = randomTriangle(random, test::randomPayload(random), 3.0, 2.0);
    if (!checkPhysical(fromParameters(plainFit(R, true).phi)).physical) return R;
  }
}

// Beside the edge of what can exist the posterior is no normal distribution, and few draws of one hit it: the intervals
// of the inertia are those of a long walk all the same.
TEST(Uncertainty, IntervalsBesideTheEdgeAreThoseOfALongWalk) {
  std::mt19937 random(31);
  for (int i = 0; i < 3; ++i) {
    const Triangle R = besideTheEdge(random);
    const PlainFit plain = plainFit(R, true);
    const MapPrior prior = vaguePrior(0.8, {0.01, 0.0, 0.06});
    const MapSolution map = solveMap(R, prior, true, Vector10d::Zero());
    const PayloadInterval intervals = intervalsFromV(R, prior, true, map);

    const MapCost cost(R, prior, true);
    const Matrix10d L = map.covariance.llt().matrixL();
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform;
    std::array<std::vector<double>, 10> walked;
    Vector10d v = map.v;
    double here = cost(v);
    for (int k = 0; k < 300000; ++k) {
      Vector10d z;
      for (int j = 0; j < 10; ++j) z(j) = normal(random);
      const Vector10d next = v + (k % 2 ? 0.6 : 0.15) * (L * z);
      const double there = cost(next);
      if (2.0 * std::log(uniform(random)) < here - there) v = next, here = there;
      if (k < 30000 || k % 20) continue;
      const Vector10d x = componentsOf(fromParameters(parametersFromV(prior, v)));
      for (std::size_t j = 0; j < 10; ++j) walked[j].push_back(x(static_cast<Eigen::Index>(j)));
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      auto& x = walked[axis == 0 ? 4 : axis == 1 ? 7 : 9];
      std::ranges::sort(x);
      const double lower = x[x.size() / 40], upper = x[x.size() - 1 - x.size() / 40];
      EXPECT_NEAR(intervals.inertiaCom[axis][axis].lower, lower, 0.15 * (upper - lower));
      EXPECT_NEAR(intervals.inertiaCom[axis][axis].upper, upper, 0.15 * (upper - lower));
    }
    // Mass and centre are not believed to be surer than the readings make them.
    const Vector10d alone =
        (componentsJacobian(map.phi) * plain.covariance * componentsJacobian(map.phi).transpose()).diagonal();
    for (std::size_t axis = 0; axis < 3; ++axis)
      EXPECT_GT(intervals.com[axis].upper - intervals.com[axis].lower,
                0.9 * 2.0 * 1.96 * std::sqrt(alone(static_cast<Eigen::Index>(axis) + 1)));
  }
}

// What was found in the same readings and is not sure widens phi's covariance by as much, and moves nothing.
TEST(Map, LessSureAddsToTheCovariance) {
  std::mt19937 random(5);
  const Triangle R = randomTriangle(random, test::randomPayload(random), 10.0, 4.0);
  const PlainFit before = plainFit(R, true);
  Matrix10d L = Matrix10d::Zero();
  for (int i = 0; i < 10; ++i)
    for (int k = 0; k < 3; ++k) L(i, k) = 0.01 * test::randomVector(random, 1.0).x();
  const Matrix10d more = L * L.transpose();
  const PlainFit after = plainFit(lessSure(R, more), true);
  EXPECT_LT((after.phi - before.phi).norm(), 1e-6 * before.phi.norm());
  EXPECT_LT((after.covariance - before.covariance - more).norm(), 1e-6 * (before.covariance + more).norm());
}

}  // namespace
}  // namespace heft
