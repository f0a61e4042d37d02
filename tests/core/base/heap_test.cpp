#include "core/base/heap.h"

#include <gtest/gtest.h>
#include <malloc.h>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>

namespace heft {
namespace {

/// Heaps that the process has, as glibc lists them.
int heaps() {
  char* text = nullptr;
  std::size_t size = 0;
  std::FILE* const file = open_memstream(&text, &size);
  malloc_info(0, file);
  std::fclose(file);
  int out = 0;
  const std::string all(text, size);
  for (std::size_t at = all.find("<heap nr="); at != std::string::npos; at = all.find("<heap nr=", at + 1)) ++out;
  std::free(text);
  return out;
}

/// What heaps() says after two more threads have allocated.
int heapsOfThreeThreads() {
  const auto work = [] {
    useLargePagesInThread();
    void* const some = std::malloc(100'000);
    std::thread([] { std::free(std::malloc(200'000)); }).join();
    std::free(some);
  };
  std::thread(work).join();
  return heaps();
}

/// In a process of its own: how many heaps there may be is settled by its first thread.
class Heap : public testing::Test {
 protected:
  void SetUp() override {
#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
    GTEST_SKIP() << "The sanitizer's heap is another.";
#endif
#endif
    GTEST_FLAG_SET(death_test_style, "threadsafe");
  }
};

TEST_F(Heap, IsOneForAllThreads) {
  EXPECT_EXIT(
      {
        keepFreedMemory();
        std::_Exit(heapsOfThreeThreads());
      },
      testing::ExitedWithCode(1), "");
}

TEST_F(Heap, AreTwoWhereThreadsWouldWait) {
  EXPECT_EXIT(
      {
        keepFreedMemory();
        useTwoHeaps();
        std::_Exit(heapsOfThreeThreads());
      },
      testing::ExitedWithCode(2), "");
}

}  // namespace
}  // namespace heft
