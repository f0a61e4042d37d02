#include "core/diagnosis/model/channel_columns.h"

#include <gtest/gtest.h>

#include <cmath>

namespace heft::diagnosis {
namespace {

constexpr Eigen::Index kBlocks = 90;

/// Numbers without a pattern; column 1 is about channel 2 alone, column 2 about nothing, column 4 about blocks 30
/// to 50.
MatrixXd someColumns() {
  MatrixXd out(6 * kBlocks, 5);
  for (Eigen::Index i = 0; i < out.size(); ++i) out(i) = std::sin(1.7 * static_cast<double>(i) * (i % 5 + 1) + 0.3);
  for (Eigen::Index i = 0; i < out.rows(); ++i)
    if (i % 6 != 2) out(i, 1) = 0.0;
  out.col(2).setZero();
  out.col(4).head(6 * 30).setZero();
  out.col(4).tail(6 * 40).setZero();
  return out;
}

/// Of an order that is another in each channel, with blocks that are louder than others.
Noise someNoise() {
  Noise out;
  for (std::size_t c = 0; c < 6; ++c) {
    out.channels[c].sigma = 0.5 + 0.1 * static_cast<double>(c);
    out.channels[c].coefficients = VectorXd::LinSpaced(static_cast<Eigen::Index>(c), 0.4, -0.2);
  }
  NoiseScale::Blocks times = NoiseScale::Blocks::Zero(6, kBlocks);
  for (Eigen::Index n = 10; n < 40; ++n) times.col(n).setConstant(static_cast<double>(n % 7));
  out.noiseScale = std::make_shared<const NoiseScale>(times);
  out.level = &out.noiseScale->levels()[2];
  return out;
}

const std::vector<Stretch> kStretches{{3, 20}, {28, 60}, {61, 64}, {70, 90}};

TEST(ChannelColumns, AreTheColumnsThatTheyWereMadeOf) {
  const MatrixXd dense = someColumns();
  const ChannelColumns columns(dense);
  EXPECT_EQ(columns.dense(), dense);
  EXPECT_TRUE(columns.column(1).isZero(0) && !columns.column(1).isZero(2));
  const Stretch acts = ChannelColumns(dense.rightCols(1)).support();
  EXPECT_EQ(acts.from, 30);
  EXPECT_EQ(acts.to, 50);
  EXPECT_EQ(columns.middle({20, 55}).dense(), dense.middleRows(6 * 20, 6 * 35));
  const VectorXd v = VectorXd::LinSpaced(5, -1.0, 2.0);
  EXPECT_LT((columns.times(v) - dense * v).norm(), 1e-12);
}

TEST(WhitenedColumns, AreTheDenseOnesWhitened) {
  const MatrixXd dense = someColumns();
  for (const bool loud : {false, true}) {
    Noise noise = someNoise();
    if (!loud) noise.level = nullptr;
    const MatrixXd J = whitened(dense, noise, kStretches);
    const WhitenedColumns columns(ChannelColumns(dense), noise, kStretches);
    const VectorXd v = VectorXd::LinSpaced(5, -1.0, 2.0);
    EXPECT_LT((columns.gram() - J.transpose() * J).norm(), 1e-10);
    EXPECT_LT((columns.times(v) - J * v).norm(), 1e-10);
    EXPECT_LT((columns.transposeTimes(J.leftCols(2)) - J.transpose() * J.leftCols(2)).norm(), 1e-10);
  }
}

/// Those of some blocks alone, which are zero outside, as all of them.
TEST(WhitenedColumns, OfPartOfTheBlocksAreThoseOfAllOfThem) {
  const MatrixXd dense = someColumns();
  const Noise noise = someNoise();
  const Stretch reach = reachOf({30, 50}, kBlocks);
  const WhitenedColumns columns(ChannelColumns(dense), noise, kStretches),
      whole(ChannelColumns(dense.rightCols(1)), noise, kStretches),
      part(ChannelColumns(dense.rightCols(1)).middle(reach), noise, kStretches, reach.from);
  EXPECT_NEAR(part.gram()(0, 0), whole.gram()(0, 0), 1e-10);
  EXPECT_LT((columns.transposeTimes(part) - columns.transposeTimes(whole)).norm(), 1e-10);
  EXPECT_GT(columns.transposeTimes(whole).norm(), 1.0);
}

}  // namespace
}  // namespace heft::diagnosis
