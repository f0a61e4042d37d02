#include "core/math/linear_algebra.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/math/column_products.h"

namespace heft {
namespace {

/// Numbers without any pattern that a decomposition could profit from, the same everywhere.
MatrixXd scattered(Eigen::Index rows, Eigen::Index cols) {
  MatrixXd out(rows, cols);
  for (Eigen::Index i = 0; i < out.size(); ++i) out(i) = std::sin(1.7 * static_cast<double>(i) * (i % 5 + 1) + 0.3);
  return out;
}

bool near(const MatrixXd& a, const MatrixXd& b) { return (a - b).norm() < 1e-10 * (1.0 + b.norm()); }

TEST(LinearAlgebra, ProductsTakeBlocksAndFixedSizes) {
  const MatrixXd A = scattered(9, 4), B = scattered(4, 7);
  const Matrix3d C = scattered(3, 3);
  EXPECT_TRUE(near(product(A, B), A * B));
  EXPECT_TRUE(near(product(A.leftCols(3), C), A.leftCols(3) * C));
  EXPECT_TRUE(near(transposedProduct(A, A), A.transpose() * A));
  EXPECT_TRUE(near(congruence(A.leftCols(3), C), A.leftCols(3) * C * A.leftCols(3).transpose()));
}

/// Of any number of rows and columns, in the middle of others, as Eigen has them.
TEST(ColumnProducts, AreThoseOfEigen) {
  for (const Eigen::Index rows : {1, 3, 4, 7, 255, 256, 258, 1300})
    for (const Eigen::Index cols : {1, 2, 5, 11}) {
      const MatrixXd A = scattered(rows, cols), B = scattered(rows + 2, cols + 1);
      EXPECT_TRUE(near(columnProducts(A), A.transpose() * A)) << rows << " x " << cols;
      EXPECT_TRUE(near(columnProducts(A, B.middleRows(1, rows)), A.transpose() * B.middleRows(1, rows)))
          << rows << " x " << cols;
      std::vector<const double*> columns;
      std::vector<double> times;
      for (Eigen::Index i = 0; i < cols; ++i) {
        columns.push_back(A.col(i).data());
        times.push_back(0.5 - static_cast<double>(i));
      }
      VectorXd sum(rows);
      sumOfColumns(columns, times, sum);
      VectorXd lagged = VectorXd::Ones(cols), expected = lagged;
      addLaggedProducts(A.col(0), lagged);
      for (Eigen::Index lag = 0; lag < cols && lag < rows; ++lag)
        expected(lag) += A.col(0).head(rows - lag).dot(A.col(0).tail(rows - lag));
      EXPECT_TRUE(near(lagged, expected)) << rows << ", " << cols << " lags";
      EXPECT_TRUE(near(sum, A * Eigen::Map<const VectorXd>(times.data(), cols))) << rows << " x " << cols;
    }
}

TEST(LinearAlgebra, LeastSquaresLeavesAResidualThatNoColumnSees) {
  const MatrixXd A = scattered(20, 6);
  const VectorXd y = scattered(20, 2).col(1);
  const auto [x, fullRank] = leastSquares(A, y);
  EXPECT_TRUE(fullRank);
  EXPECT_LT((A.transpose() * (y - A * x)).norm(), 1e-10);
  EXPECT_TRUE(near(shortestLeastSquares(A, y), x));
  EXPECT_TRUE(near(pseudoInverse(A) * y, x));
  const MatrixXd R = upperTriangle(A);
  EXPECT_TRUE(near(R.transpose() * R, A.transpose() * A));
  EXPECT_TRUE(near(R * solveUpper(R, x), x));
}

TEST(LinearAlgebra, ColumnsThatRepeatTakeRankAndLengthAway) {
  MatrixXd A = scattered(12, 4);
  A.col(3) = A.col(0);
  const VectorXd y = A.col(0);
  EXPECT_FALSE(leastSquares(A, y).fullRank);
  const VectorXd x = shortestLeastSquares(A, y);  // Half of it from each of the two
  EXPECT_NEAR(x(0), 0.5, 1e-10);
  EXPECT_NEAR(x(3), 0.5, 1e-10);
  EXPECT_EQ(columnSpace(A).cols(), 3);
  EXPECT_EQ(orthonormal(A).cols(), 4);
  // Nearly the same column, up to a millionth: one below this threshold, two without.
  A.col(3) += 1e-6 * scattered(12, 5).col(4);
  EXPECT_NEAR(shortestLeastSquares(A, y, 1e-4)(0), 0.5, 1e-4);
  EXPECT_NEAR(shortestLeastSquares(A, y)(0), 1.0, 1e-6);
}

TEST(LinearAlgebra, SymmetricMatrices) {
  const MatrixXd A = scattered(15, 5), M = A.transpose() * A;
  const VectorXd g = A.row(2).transpose();
  EXPECT_TRUE(near(M * solveSymmetric(M, g), g));
  EXPECT_TRUE(near(M * SymmetricSolver(M).solveAll(A.transpose()), A.transpose()));
  EXPECT_TRUE(near(M * inverse(M), MatrixXd::Identity(5, 5)));
  const MatrixXd L = choleskyFactor(M), W = whitenerOf(M);
  EXPECT_TRUE(near(L * L.transpose(), M));
  EXPECT_TRUE(near(W * M * W.transpose(), MatrixXd::Identity(5, 5)));
  const auto [values, vectors] = symmetricEigen(M);
  EXPECT_TRUE(near(vectors * values.asDiagonal() * vectors.transpose(), M));
  for (Eigen::Index i = 1; i < 5; ++i) EXPECT_GE(values(i), values(i - 1));
  const MatrixXd B = M + MatrixXd::Identity(5, 5);
  const auto [ratios, directions] = generalizedEigen(M, B);
  EXPECT_TRUE(near(M * directions, B * directions * ratios.asDiagonal()));
}

TEST(LinearAlgebra, SingularValuesFallAndPutTheMatrixTogether) {
  const MatrixXd A = scattered(9, 4);
  const auto [U, values, V] = thinSvd(A);
  EXPECT_TRUE(near(U * values.asDiagonal() * V.transpose(), A));
  EXPECT_TRUE(near(singularValues(A), values));
  EXPECT_NEAR((A * V.col(3)).norm(), values(3), 1e-10);
}

}  // namespace
}  // namespace heft
