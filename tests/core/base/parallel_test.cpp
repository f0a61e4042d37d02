// Pieces of work on two threads: each is done once, whoever asks, and what goes wrong is told.
#include "core/base/parallel.h"

#include <gtest/gtest.h>

#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

namespace heft::test {
namespace {

TEST(ParallelFor, DoesEachPieceOnce) {
  for (const std::size_t count : {0U, 1U, 2U, 3U, 1000U}) {
    std::vector<std::atomic<int>> done(count);
    parallelFor(count, [&](std::size_t i) { ++done[i]; });
    for (const auto& times : done) EXPECT_EQ(times, 1);
  }
}

TEST(ParallelFor, PiecesMayHavePiecesOfTheirOwn) {
  std::vector<std::atomic<int>> done(64);
  parallelFor(8, [&](std::size_t i) { parallelFor(8, [&](std::size_t j) { ++done[8 * i + j]; }); });
  for (const auto& times : done) EXPECT_EQ(times, 1);
}

TEST(ParallelFor, SeveralMayAskAtATime) {
  std::vector<std::atomic<int>> done(4 * 500);
  {
    std::vector<std::jthread> asking;
    for (std::size_t a = 0; a < 4; ++a)
      asking.emplace_back([&done, a] {
        for (std::size_t round = 0; round < 50; ++round)
          parallelFor(10, [&](std::size_t i) { ++done[500 * a + 10 * round + i]; });
      });
  }
  for (const auto& times : done) EXPECT_EQ(times, 1);
}

TEST(ParallelFor, ExceptionsReachWhoAsksAndTheNextIsDoneAsEver) {
  for (std::size_t bad = 0; bad < 20; ++bad)
    EXPECT_THROW(parallelFor(20,
                             [&](std::size_t i) {
                               if (i == bad) throw std::runtime_error("bad");
                             }),
                 std::runtime_error);
  std::atomic<int> sum{0};
  parallelFor(100, [&](std::size_t) { ++sum; });
  EXPECT_EQ(sum, 100);
}

TEST(ParallelFor, StaysOnItsThreadWhileAScopeSaysSo) {
  const auto elsewhere = [] {
    std::atomic<int> count{0};
    const auto here = std::this_thread::get_id();
    parallelFor(100, [&](std::size_t) {
      std::this_thread::sleep_for(std::chrono::microseconds(100));
      if (std::this_thread::get_id() != here) ++count;
    });
    return count.load();
  };
  {
    const OneThreadScope alone;
    { const OneThreadScope again; }
    EXPECT_EQ(elsewhere(), 0);
  }
  EXPECT_GT(elsewhere(), 0);
}

}  // namespace
}  // namespace heft::test
