#pragma once
// Independent pieces of work on two threads: the machines at a robot have that many to spare.
#include <atomic>
#include <cstddef>
#include <functional>

#include "core/base/stop.h"

namespace heft {

namespace detail {

/// Runs `some` here and, if it is free, on a thread that is kept for that, at once; only here where either of them
/// asks for it. Exceptions of both reach the caller, those of this thread first.
void onBoth(const std::function<void()>& some);

}  // namespace detail

/// While one lives, this thread's parallelFor() stays on it: where each is done sooner than another thread wakes up.
class OneThreadScope {
 public:
  OneThreadScope();
  ~OneThreadScope();
  OneThreadScope(const OneThreadScope&) = delete;
  OneThreadScope& operator=(const OneThreadScope&) = delete;

 private:
  bool before_;
};

/// Calls work(i) for each i in [0, count), the next one on whichever thread is free. Exceptions reach the caller.
/// Before each is a stopPoint().
template <class Work>
void parallelFor(std::size_t count, const Work& work) {
  std::atomic<std::size_t> next{0};
  const std::stop_token stop = StopScope::current();
  const auto some = [&] {
    const StopScope scope(stop);
    for (std::size_t i = next++; i < count; i = next++) {
      stopPoint();
      work(i);
    }
  };
  count > 1 ? detail::onBoth(some) : some();
}

}  // namespace heft
