#pragma once
// Independent pieces of work on two threads: the machines at a robot have that many to spare.
#include <atomic>
#include <cstddef>
#include <future>

namespace heft::diagnosis {

/// Calls work(i) for each i in [0, count), the next one on whichever thread is free. Exceptions reach the caller.
template <class Work>
void onTwoThreads(std::size_t count, const Work& work) {
  std::atomic<std::size_t> next{0};
  const auto some = [&] {
    for (std::size_t i = next++; i < count; i = next++) work(i);
  };
  auto other = std::async(std::launch::async, some);
  some();
  other.get();
}

}  // namespace heft::diagnosis
