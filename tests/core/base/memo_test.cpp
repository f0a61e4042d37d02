#include "core/base/memo.h"

#include <gtest/gtest.h>

namespace heft {
namespace {

TEST(Memo, KeepsTheLatestAnswersUntilItForgets) {
  Memo<int, int> memo(2);
  int made = 0;
  const auto squareOf = [&](int question) {
    return *memo.answer(question, [&](int asked) {
      ++made;
      return asked * asked;
    });
  };
  EXPECT_EQ(squareOf(3), 9);
  EXPECT_EQ(squareOf(4), 16);
  EXPECT_EQ(squareOf(3), 9);
  EXPECT_EQ(made, 2);
  EXPECT_EQ(squareOf(5), 25);  // In the place of 4, which was asked for longest ago
  EXPECT_EQ(squareOf(3), 9);
  EXPECT_EQ(made, 3);
  EXPECT_EQ(squareOf(4), 16);
  EXPECT_EQ(made, 4);
  memo.forget();
  EXPECT_EQ(squareOf(4), 16);
  EXPECT_EQ(made, 5);
}

}  // namespace
}  // namespace heft
