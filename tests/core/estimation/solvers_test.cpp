#include "core/estimation/solvers.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <memory>
#include <new>

#include "core/estimation/triangle.h"
#include "tests/support/random_payload.h"

namespace heft {
namespace {

/// Rows of well excited motion; `noise` on the wrench.
Rows randomRows(std::mt19937& random, const Payload& truth, const Vector6d& bias, int samples, double noise) {
  std::normal_distribution<double> normal;
  Rows rows(6 * samples, kColumns + 1);
  for (int k = 0; k < samples; ++k) {
    const WrenchState state{test::randomRotation(random) * Vector3d(0, 0, 9.81), test::randomVector(random, 3.0),
                            test::randomVector(random, 20.0)};
    const Regressor Y = regressor(state);
    const Vector6d F = predictWrench(truth, state) + bias;
    for (int c = 0; c < 6; ++c) {
      rows.row(6 * k + c).setZero();
      rows(6 * k + c, c) = 1.0;
      rows.row(6 * k + c).segment<10>(6) = Y.row(c);
      rows(6 * k + c, kColumns) = F(c) + noise * normal(random) * (c < 3 ? 1.0 : 0.05);
    }
  }
  return rows;
}

Triangle compress(const Rows& rows) {
  TriangleBuilder builder;
  for (Eigen::Index i = 0; i < rows.rows(); ++i) builder.add(rows.row(i));
  EXPECT_EQ(builder.rows(), rows.rows());
  return builder.finish();
}

SolverProblem uncompressed(const Rows& rows, ParameterSet set, bool bias, const Payload& known) {
  return {rows.leftCols<kColumns>(), rows.col(kColumns), set, bias, known};
}

const Vector6d kBias = (Vector6d() << 2.0, -1.0, 3.0, 0.1, -0.2, 0.05).finished();
const Eigen::Matrix<double, 11, 1> kEvenNoise = Eigen::Matrix<double, 11, 1>::Ones();

struct NamedSolver {
  const char* name;
  SolverSolution (*solve)(const SolverProblem&);
  double tolerance;  ///< Relative to exact data.
};

const NamedSolver kSolvers[] = {
    {"ls", solveLeastSquares, 1e-9},
    {"tls", [](const SolverProblem& p) { return solveScaledTls(p, kEvenNoise); }, 1e-9},
    {"tls-exact", solveTls, 1e-9},
    {"ceres", solveCeres, 1e-7},
    {"eigen-lm", solveEigenLm, 1e-7},
    {"brute-force", solveBruteForce, 1e-4},
};

TEST(Triangle, HoldsTheWholeProblem) {
  std::mt19937 random(1);
  const Rows rows = randomRows(random, test::randomPayload(random), kBias, 700, 0.1);
  const Triangle R = compress(rows);
  EXPECT_TRUE(R.isUpperTriangular());
  EXPECT_LT((R.transpose() * R - rows.transpose() * rows).norm(), 1e-12 * (rows.transpose() * rows).norm());
}

/// Its loads of four rows at once must not count on more than the type's own alignment.
TEST(Triangle, IsTheSameWhereverItsBuilderLies) {
  std::mt19937 random(3);
  const Rows rows = randomRows(random, test::randomPayload(random), kBias, 100, 0.1);
  const Triangle expected = compress(rows);
  constexpr std::size_t kStep = alignof(TriangleBuilder), kSteps = 64 / kStep;
  struct alignas(64) Place {
    std::byte bytes[sizeof(TriangleBuilder) + 64];
  };
  const auto place = std::make_unique<Place>();
  for (std::size_t step = 0; step < kSteps; ++step) {
    auto* const builder = new (place->bytes + step * kStep) TriangleBuilder;
    for (Eigen::Index i = 0; i < rows.rows(); ++i) builder->add(rows.row(i));
    EXPECT_EQ(builder->finish(), expected) << step * kStep << " bytes beyond a multiple of 64";
    std::destroy_at(builder);
  }
}

TEST(Solvers, RecoverExactDataForEverySetOfParameters) {
  std::mt19937 random(2);
  for (int trial = 0; trial < 5; ++trial) {
    const Payload truth = test::randomPayload(random);
    const Triangle R = compress(randomRows(random, truth, kBias, 200, 0.0));
    const Vector10d phi = toParameters(truth);
    for (const auto set : {ParameterSet::mass, ParameterSet::massCom, ParameterSet::full})
      for (const auto& solver : kSolvers) {
        const SolverSolution solution = solver.solve(problemFrom(R, set, true, truth));
        EXPECT_TRUE(solution.usable) << solver.name << ": " << solution.why;
        EXPECT_FALSE(solution.why.empty());
        EXPECT_LT((solution.phi - phi).norm(), solver.tolerance * phi.norm()) << solver.name << " " << toString(set);
        EXPECT_LT((solution.bias - kBias).norm(), solver.tolerance * 100) << solver.name << " " << toString(set);
      }
  }
}

TEST(Solvers, TheTriangleIsExactNotApproximate) {
  std::mt19937 random(3);
  const Payload truth = test::randomPayload(random);
  const Rows rows = randomRows(random, truth, kBias, 2000, 0.2);
  const Triangle R = compress(rows);
  for (const auto set : {ParameterSet::mass, ParameterSet::massCom, ParameterSet::full})
    for (const bool bias : {true, false})
      for (const auto& solver : kSolvers) {
        const Vector10d small = solver.solve(problemFrom(R, set, bias, truth)).phi;
        const Vector10d large = solver.solve(uncompressed(rows, set, bias, truth)).phi;
        // Numerical differentiation and sampling stop where their own steps end; everything else agrees to rounding.
        const bool searching = std::string_view(solver.name) == "eigen-lm" ||
                               std::string_view(solver.name) == "brute-force" ||
                               std::string_view(solver.name) == "ceres";
        EXPECT_LT((small - large).norm(), (searching ? 1e-5 : 1e-9) * small.norm())
            << solver.name << " " << toString(set) << " " << bias;
      }
}

TEST(Solvers, NonlinearOnesFindTheLeastSquaresMinimum) {
  std::mt19937 random(4);
  const Payload truth = test::randomPayload(random);
  const Triangle R = compress(randomRows(random, truth, kBias, 1000, 0.5));
  for (const auto set : {ParameterSet::mass, ParameterSet::massCom, ParameterSet::full}) {
    const Vector10d ls = solveLeastSquares(problemFrom(R, set, true, truth)).phi;
    EXPECT_LT((solveCeres(problemFrom(R, set, true, truth)).phi - ls).norm(), 1e-6 * ls.norm());
    EXPECT_LT((solveEigenLm(problemFrom(R, set, true, truth)).phi - ls).norm(), 1e-6 * ls.norm());
    EXPECT_LT((solveBruteForce(problemFrom(R, set, true, truth)).phi - ls).norm(), 1e-4 * ls.norm());
  }
}

TEST(Solvers, ReturnTheCentreOfMassNotTheFirstMoment) {
  std::mt19937 random(5);
  Payload truth = test::randomPayload(random);
  truth.com = {0.1, -0.05, 0.2};
  const auto solution = solveLeastSquares(
      problemFrom(compress(randomRows(random, truth, kBias, 100, 0.0)), ParameterSet::full, true, truth));
  EXPECT_LT((fromParameters(solution.phi).com - truth.com).norm(), 1e-9);
}

TEST(Solvers, TlsBeatsLeastSquaresWhereTheRegressorIsNoisy) {
  std::mt19937 random(6);
  std::normal_distribution<double> normal;
  const Payload truth = test::randomPayload(random);
  Rows rows = randomRows(random, truth, Vector6d::Zero(), 4000, 0.0);
  Eigen::Matrix<double, 11, 1> noise = Eigen::Matrix<double, 11, 1>::Constant(3.0);
  noise(10) = 1e-3;
  for (Eigen::Index i = 0; i < rows.rows(); ++i)
    for (int c = 6; c < 16; ++c) rows(i, c) += 3.0 * normal(random);
  const SolverProblem problem = problemFrom(compress(rows), ParameterSet::full, true, truth);
  const Vector10d phi = toParameters(truth);
  EXPECT_LT((solveScaledTls(problem, noise).phi - phi).norm(), 0.3 * (solveLeastSquares(problem).phi - phi).norm());
}

TEST(Solvers, SayWhenMotionTellsNothing) {
  Rows rows(600, kColumns + 1);
  rows.setZero();
  for (Eigen::Index i = 0; i < 600; ++i) {
    rows(i, i % 6) = 1.0;
    rows(i, kColumns) = 1.0;
  }
  const auto solution = solveLeastSquares(problemFrom(compress(rows), ParameterSet::full, true, {}));
  EXPECT_FALSE(solution.usable);
  EXPECT_NE(solution.why.find("without any information"), std::string::npos);
}

}  // namespace
}  // namespace heft
