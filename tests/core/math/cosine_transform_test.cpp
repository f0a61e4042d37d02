#include "core/math/cosine_transform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace heft {
namespace {

using Eigen::MatrixXd;

MatrixXd cosinesOver(Eigen::Index count) {
  MatrixXd out(count, count);
  for (Eigen::Index k = 0; k < count; ++k)
    for (Eigen::Index n = 0; n < count; ++n)
      out(n, k) = std::sqrt((k == 0 ? 1.0 : 2.0) / static_cast<double>(count)) *
                  std::cos(std::numbers::pi * static_cast<double>(k) * (static_cast<double>(n) + 0.5) /
                           static_cast<double>(count));
  return out;
}

TEST(CosineTransform, IsTheProductWithTheMatrixOfCosines) {
  for (const Eigen::Index count : {1, 2, 3, 8, 97, 360}) {
    const MatrixXd samples = MatrixXd::Random(count, 6), cosines = cosinesOver(count);
    const CosineTransform transform(count);
    EXPECT_LT((transform.forward(samples) - cosines.transpose() * samples).cwiseAbs().maxCoeff(), 1e-12) << count;
    EXPECT_LT((transform.inverse(samples) - cosines * samples).cwiseAbs().maxCoeff(), 1e-12) << count;
  }
}

TEST(CosineTransform, OfAnHourInTenthsOfASecondComesBack) {
  const MatrixXd samples = MatrixXd::Random(35999, 2);  // The length is prime
  const CosineTransform transform(samples.rows());
  const MatrixXd waves = transform.forward(samples);
  EXPECT_NEAR(waves.norm(), samples.norm(), 1e-9 * samples.norm());
  EXPECT_LT((transform.inverse(waves) - samples).cwiseAbs().maxCoeff(), 1e-9);
}

}  // namespace
}  // namespace heft
