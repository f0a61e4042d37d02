#pragma once
// Long work that ends within a moment of being asked to, however deep inside it is.
#include <atomic>
#include <stop_token>

#include "core/base/result.h"

namespace heft {

/// Thrown by stopPoint(); stoppable() makes an error of it.
struct Stopped {};

/// While it lives, stopPoint() obeys `stop` on this thread; parallelFor() takes it along to the other one.
class StopScope {
 public:
  explicit StopScope(std::stop_token stop);
  ~StopScope();
  StopScope(const StopScope&) = delete;
  StopScope& operator=(const StopScope&) = delete;

  bool asked() const { return stop_.stop_requested(); }
  /// Of the innermost one here; without any, one that never stops.
  static std::stop_token current();

 private:
  std::stop_token stop_;
  const StopScope* before_;
};

/// Steps of a loop, each of some microseconds, after which it has another stopPoint().
constexpr int kRowsBetweenStops = 4096;

/// Throws Stopped where the work is to stop. Costs some nanoseconds; stands wherever a tenth of a second may pass.
void stopPoint();

/// Told of each stopPoint() and the place of its call; null unless a benchmark measures how far apart they are.
extern std::atomic<void (*)(const void* place)> stopObserver;

/// What `work` returns, a Result, with stopPoint() obeying `stop`; the error "Stopped." where it did.
template <class Work>
auto stoppable(const std::stop_token& stop, const Work& work) -> decltype(work()) {
  const StopScope scope(stop);
  try {
    return work();
  } catch (const Stopped&) {
    return Error{"Stopped.", true};
  }
}

}  // namespace heft
