#pragma once
// Samples of a source, kept for a test.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <mutex>
#include <vector>

#include "core/live/source.h"
#include "tests/support/live_servers.h"

namespace heft::testing_support {

class Collected {
 public:
  SampleSink sink() {
    return [this](const LiveSample& sample) {
      const std::lock_guard lock(mutex_);
      samples_.push_back(sample);
    };
  }
  std::vector<LiveSample> samples() const {
    const std::lock_guard lock(mutex_);
    return samples_;
  }
  bool reach(std::size_t count) const {
    return eventually([&] {
      const std::lock_guard lock(mutex_);
      return samples_.size() >= count;
    });
  }

 private:
  mutable std::mutex mutex_;
  std::vector<LiveSample> samples_;
};

}  // namespace heft::testing_support
