#include "core/recording/number.h"

#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>

namespace heft::csv {
namespace {

/// Characters taken, value in `value`.
std::ptrdiff_t take(std::string_view text, double& value) {
  return parseNumber(text.data(), text.data() + text.size(), value) - text.data();
}

double valueOf(std::string_view text) {
  double value = -999.0;
  EXPECT_EQ(take(text, value), static_cast<std::ptrdiff_t>(text.size())) << text;
  return value;
}

TEST(Number, ReadsTheUsualForms) {
  EXPECT_EQ(valueOf("0"), 0.0);
  EXPECT_EQ(valueOf("-0.25"), -0.25);
  EXPECT_EQ(valueOf("+12."), 12.0);
  EXPECT_EQ(valueOf(".5"), 0.5);
  EXPECT_EQ(valueOf("-.5"), -0.5);
  EXPECT_EQ(valueOf("1e3"), 1000.0);
  EXPECT_EQ(valueOf("-2.5E-3"), -0.0025);
  EXPECT_EQ(valueOf("+1e3"), 1000.0);
  EXPECT_EQ(valueOf("000123.500"), 123.5);
  EXPECT_TRUE(std::signbit(valueOf("-0")));
}

TEST(Number, SpecialValues) {
  EXPECT_TRUE(std::isnan(valueOf("nan")));
  EXPECT_TRUE(std::isnan(valueOf("NaN")));
  EXPECT_EQ(valueOf("-inf"), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(valueOf("+Infinity"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(valueOf("1e999"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(valueOf("-1e999"), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(valueOf("1e-999"), 0.0);
  EXPECT_EQ(valueOf("0." + std::string(400, '0') + "1"), 0.0);
  EXPECT_EQ(valueOf(std::string(400, '9')), std::numeric_limits<double>::infinity());
}

TEST(Number, StopsWhereTheNumberEnds) {
  double value = 0.0;
  EXPECT_EQ(take("1.5,2", value), 3);
  EXPECT_EQ(value, 1.5);
  EXPECT_EQ(take("7abc", value), 1);
  EXPECT_EQ(take("3e", value), 1);
  for (const char* text : {"", "-", "+", ".", "-.", "e5", "abc", "--1", "+-1", "-+1", " 1"})
    EXPECT_EQ(take(text, value), 0) << text;
}

TEST(Number, AgreesWithFromCharsToTheLastBit) {
  std::mt19937_64 random(11);
  for (int round = 0; round < 200000; ++round) {
    char buffer[64];
    char* end = buffer;
    if (round % 2 == 0) {
      double value = std::bit_cast<double>(random());
      if (!std::isfinite(value)) continue;
      end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
    } else {  // decimals of every length around the limits of the fast path
      const auto digits = 1 + random() % 22;
      const auto point = random() % (digits + 1);
      if (random() % 2 == 0) *end++ = '-';
      for (std::uint64_t d = 0; d < digits; ++d) {
        if (d == point) *end++ = '.';
        *end++ = static_cast<char>('0' + random() % 10);
      }
    }
    double expected = 0.0;
    double got = 1.0;
    std::from_chars(buffer, end, expected);
    ASSERT_EQ(parseNumber(buffer, end, got), end) << std::string(buffer, end);
    ASSERT_EQ(std::bit_cast<std::uint64_t>(got), std::bit_cast<std::uint64_t>(expected)) << std::string(buffer, end);
  }
}

}  // namespace
}  // namespace heft::csv
