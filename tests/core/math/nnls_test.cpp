#include "core/math/nnls.h"

#include <gtest/gtest.h>

#include <random>

namespace heft {
namespace {

TEST(Nnls, MeetsTheConditionsOfTheOptimum) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 50; ++trial) {
    const Eigen::MatrixXd A = Eigen::MatrixXd::NullaryExpr(10, trial % 2 ? 6 : 40, [&] { return normal(random); });
    const Eigen::VectorXd b = Eigen::VectorXd::NullaryExpr(10, [&] { return normal(random); });
    const Eigen::VectorXd x = nonNegativeLeastSquares(A, b);
    EXPECT_GE(x.minCoeff(), 0.0);
    const Eigen::VectorXd slope = A.transpose() * (b - A * x);  // Karush-Kuhn-Tucker
    EXPECT_LT(slope.maxCoeff(), 1e-8);
    EXPECT_LT(slope.cwiseProduct(x).cwiseAbs().maxCoeff(), 1e-8);
  }
}

TEST(Nnls, WhatCanBeReachedIsReached) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform;
  const Eigen::MatrixXd A = Eigen::MatrixXd::NullaryExpr(10, 200, [&] { return uniform(random); });
  const Eigen::VectorXd b = A * Eigen::VectorXd::NullaryExpr(200, [&] { return uniform(random); });
  EXPECT_LT((A * nonNegativeLeastSquares(A, b) - b).norm(), 1e-8 * b.norm());
  EXPECT_EQ(nonNegativeLeastSquares(A, Eigen::VectorXd::Zero(10)).norm(), 0.0);
}

}  // namespace
}  // namespace heft
