// Numbers, names and remarks in exported files; principal axes.
#include "core/exporters/writing.h"

#include <gtest/gtest.h>

#include <charconv>
#include <limits>

#include "tests/core/exporters/readers.h"

namespace heft {
namespace {

TEST(ExportWriting, NumbersAreShortFixedAndReadBack) {
  EXPECT_EQ(number(0.0), "0");
  EXPECT_EQ(number(-0.0), "0");
  EXPECT_EQ(number(0.057), "0.057");
  EXPECT_EQ(number(1e-7), "0.0000001");
  EXPECT_EQ(number(-12.5), "-12.5");
  for (const double value :
       {1.0 / 3.0, -2.0e-9 / 7.0, std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::max()}) {
    const std::string text = number(value);
    double back = 0.0;
    std::from_chars(text.data(), text.data() + text.size(), back);
    EXPECT_EQ(back, value);
  }
}

TEST(ExportWriting, RoundingGivesTheNearestDecimal) {
  EXPECT_EQ(roundedTo(0.123456789, 4), 0.1235);
  EXPECT_EQ(roundedTo(-1.23456e-5, 8), -1.235e-5);
  EXPECT_EQ(number(roundedTo(2.0 / 3.0, 6)), "0.666667");
  EXPECT_EQ(decimalsFor(0.0031), 8);
  EXPECT_EQ(decimalsFor(3.1), 5);
  EXPECT_EQ(decimalsFor(0.0), 6);
}

TEST(ExportWriting, IdentifiersSuitEveryLanguage) {
  EXPECT_EQ(identifier("Gripper 2"), "Gripper_2");
  EXPECT_EQ(identifier("2nd"), "t2nd");
  EXPECT_EQ(identifier(""), "tool");
  EXPECT_EQ(identifier("\xc3\xa4\xc3\xb6"), "tool");
  EXPECT_LE(identifier(std::string(100, 'x')).size(), 25u);
}

TEST(ExportWriting, PrincipalAxesRebuildTheTensorAndStayNearTheFlange) {
  for (int index = 0; index < 200; ++index) {
    const Matrix3d I = randomPayload(index).inertiaCom;
    const PrincipalAxes axes = principalAxes(I);
    const Matrix3d& R = axes.R_FA;
    EXPECT_LT((R * R.transpose() - Matrix3d::Identity()).norm(), 1e-13);
    EXPECT_NEAR(R.determinant(), 1.0, 1e-13);
    EXPECT_LT((R * axes.moments.asDiagonal() * R.transpose() - I).norm(), 1e-8 * I.norm()) << index;
    EXPECT_GE(axes.moments.sum() - axes.moments.maxCoeff(), axes.moments.maxCoeff() * (1.0 - 1e-15)) << index;
    EXPECT_GT(axes.moments.minCoeff(), 0.0);
  }
  Matrix3d nearly = Vector3d(0.001, 0.003, 0.002).asDiagonal();
  nearly(0, 1) = nearly(1, 0) = 1e-6;
  EXPECT_LT((principalAxes(nearly).R_FA - Matrix3d::Identity()).norm(), 1e-3);
}

}  // namespace
}  // namespace heft
