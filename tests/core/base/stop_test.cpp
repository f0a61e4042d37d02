// Long work ends at its next stopPoint(), on both threads, and only where it was asked to.
#include "core/base/stop.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stop_token>

#include "core/base/parallel.h"

namespace heft::test {
namespace {

TEST(Stop, NobodyAskedMeansNothing) {
  std::stop_source stop;
  stop.request_stop();
  stopPoint();
  const StopScope scope(std::stop_token{});
  EXPECT_NO_THROW(stopPoint());
}

TEST(Stop, AScopeObeysItsTokenAsLongAsItLives) {
  std::stop_source stop;
  {
    const StopScope scope(stop.get_token());
    EXPECT_NO_THROW(stopPoint());
    stop.request_stop();
    EXPECT_THROW(stopPoint(), Stopped);
    {
      const StopScope inner(std::stop_token{});
      EXPECT_NO_THROW(stopPoint());
    }
    EXPECT_THROW(stopPoint(), Stopped);
  }
  EXPECT_NO_THROW(stopPoint());
}

TEST(Stop, BecomesACancelledError) {
  std::stop_source stop;
  const auto work = [&]() -> Result<int> {
    stopPoint();
    stop.request_stop();
    stopPoint();
    return 1;
  };
  const auto result = stoppable(stop.get_token(), work);
  ASSERT_FALSE(result.ok());
  EXPECT_TRUE(result.error().cancelled);
  EXPECT_EQ(stoppable(std::stop_token{}, work).value(), 1);
}

TEST(Stop, ReachesBothThreadsOfParallelWork) {
  std::stop_source stop;
  std::atomic<int> begun{0};
  const auto result = stoppable(stop.get_token(), [&]() -> Result<int> {
    parallelFor(1000, [&](std::size_t) {
      ++begun;
      stop.request_stop();
    });
    return 1;
  });
  ASSERT_FALSE(result.ok());
  EXPECT_LE(begun, 2);
}

}  // namespace
}  // namespace heft::test
