#pragma once
// Independent pieces of work on two threads: the machines at a robot have that many to spare.
#include <cstddef>
#include <future>

namespace heft::diagnosis {

/// Calls work(i) for i in [0, count): even numbers here, odd ones on another thread. Exceptions reach the caller.
template <class Work>
void onTwoThreads(std::size_t count, const Work& work) {
  const auto every = [&](std::size_t first) {
    for (std::size_t i = first; i < count; i += 2) work(i);
  };
  auto other = std::async(std::launch::async, every, std::size_t{1});
  every(0);
  other.get();
}

}  // namespace heft::diagnosis
