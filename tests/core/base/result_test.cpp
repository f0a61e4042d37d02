#include "core/base/result.h"

#include <gtest/gtest.h>

#include <memory>

namespace heft {
namespace {

TEST(Result, HoldsAValue) {
  Result<int> result = 3;
  ASSERT_TRUE(result.ok());
  EXPECT_TRUE(result);
  EXPECT_EQ(*result, 3);
  *result = 4;
  EXPECT_EQ(result.value(), 4);
}

TEST(Result, HoldsAnError) {
  const Result<int> result = Error{"rec.csv: no such file."};
  EXPECT_FALSE(result);
  EXPECT_EQ(result.error().message, "rec.csv: no such file.");
}

TEST(Result, ReadingTheValueOfAFailureIsABugThatNamesTheFailure) {
  const Result<int> result = Error{"why"};
  try {
    static_cast<void>(result.value());
    FAIL() << "no exception";
  } catch (const std::logic_error& error) {
    EXPECT_NE(std::string(error.what()).find("why"), std::string::npos);
  }
}

TEST(Result, MovesWhatCannotBeCopied) {
  Result<std::unique_ptr<int>> result = std::make_unique<int>(5);
  const auto moved = std::move(result).value();
  EXPECT_EQ(*moved, 5);
}

}  // namespace
}  // namespace heft
