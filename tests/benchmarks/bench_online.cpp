// What the on-line estimator costs: a recording of 60 s fed sample by sample, the state read at 25 Hz as a display
// would, in microseconds a sample and as share of one core at the recording's own rate. The longest single add() with
// state() is the time for which a loop that also reads the sensor would have to buffer: by the clock, and in processor
// time, which other programs do not stretch.
//   bench_online [--benchmark_filter=REGEX ...]
#include <benchmark/benchmark.h>

#include <chrono>
#include <ctime>

#include "core/estimation/estimate.h"
#include "tests/core/online/feed.h"

namespace heft {
namespace {

double processorTime() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

const Recording& recording() {
  static const Recording instance = test::simulated(MotionKind::free, test::onlineTool(), 3, 60.0);
  return instance;
}

void online(benchmark::State& state, const OnlineOptions& options) {
  const Recording& data = recording();
  double longest = 0.0, longestProcessor = 0.0, processor = 0.0, samples = 0.0;
  for (auto _ : state) {
    OnlineEstimator estimator = test::estimatorFor(data, options);
    const std::clock_t start = std::clock();
    for (Eigen::Index k = 0; k < data.rows(); ++k) {
      const auto before = std::chrono::steady_clock::now();
      const double processorBefore = processorTime();
      if (estimator.add(sampleOf(data, k))) benchmark::DoNotOptimize(estimator.state());
      longestProcessor = std::max(longestProcessor, processorTime() - processorBefore);
      longest = std::max(longest, std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count());
    }
    processor += static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    samples += static_cast<double>(data.rows());
  }
  state.counters["us_a_sample"] = 1e6 * processor / samples;
  state.counters["core_percent"] = 100.0 * processor / samples * 1000.0;
  state.counters["longest_ms"] = 1e3 * longest;
  state.counters["longest_processor_ms"] = 1e3 * longestProcessor;
}

void fixedSmoothing(benchmark::State& state) {
  OnlineOptions options;
  options.cutoffHz = 25.0;
  online(state, options);
}
void automaticSmoothing(benchmark::State& state) { online(state, {}); }

/// The same recording by the batch estimator, for a ratio: what one look at the whole costs.
void batchEstimate(benchmark::State& state) {
  const Recording& data = recording();
  double processor = 0.0;
  for (auto _ : state) {
    const std::clock_t start = std::clock();
    benchmark::DoNotOptimize(estimate(data, &RobotModel::panda(), {}));
    processor += static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  }
  state.counters["core_percent"] = 100.0 * processor / (60.0 * static_cast<double>(state.iterations()));
}

BENCHMARK(fixedSmoothing)->Unit(benchmark::kMillisecond);
BENCHMARK(automaticSmoothing)->Unit(benchmark::kMillisecond);
BENCHMARK(batchEstimate)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace heft
