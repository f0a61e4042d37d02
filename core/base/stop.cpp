#include "core/base/stop.h"

#include <utility>

namespace heft {

namespace {

thread_local const StopScope* innermost = nullptr;

}  // namespace

StopScope::StopScope(std::stop_token stop) : stop_(std::move(stop)), before_(innermost) { innermost = this; }

StopScope::~StopScope() { innermost = before_; }

std::stop_token StopScope::current() { return innermost != nullptr ? innermost->stop_ : std::stop_token(); }

std::atomic<void (*)(const void*)> stopObserver = nullptr;

void stopPoint() {
  if (const auto observer = stopObserver.load(std::memory_order_relaxed)) observer(__builtin_return_address(0));
  if (innermost != nullptr && innermost->asked()) throw Stopped{};
}

}  // namespace heft
