// What the on-line estimator costs: a recording of 60 s fed sample by sample, the state read at 25 Hz as a display
// would, in microseconds a sample and as share of one core at the recording's own rate. The longest single add() with
// state() is the time for which a loop that also reads the sensor would have to buffer: by the clock, and in processor
// time, which other programs do not stretch. Fed as fast as it goes, a step also waits for what is learned beside it;
// inRealTime does not feed faster than a sensor would.
//   bench_online [--benchmark_filter=REGEX ...]
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <chrono>
#include <ctime>
#include <fstream>
#include <thread>

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

/// The first 40 s sample by sample when they are due, as a sensor would send them: how long a refresh keeps the reader
/// of the sensor, and how long after the one before it comes.
void inRealTime(benchmark::State& state) {
  const Recording& data = recording();
  for (auto _ : state) {
    OnlineEstimator estimator = test::estimatorFor(data, {});
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t processor = std::clock();
    const double readerStart = processorTime();
    double inSteps = 0.0;
    auto shown = start;
    std::vector<double> steps, apart;
    const Eigen::Index rows = std::min<Eigen::Index>(data.rows(), 40'000);
    for (Eigen::Index k = 0; k < rows; ++k) {
      std::this_thread::sleep_until(start + std::chrono::duration<double>(data.time(k) - data.time(0)));
      const auto before = std::chrono::steady_clock::now();
      const double processorBefore = processorTime();
      const bool news = estimator.add(sampleOf(data, k));
      if (news) benchmark::DoNotOptimize(estimator.state());
      inSteps += processorTime() - processorBefore;
      if (!news) continue;
      const auto now = std::chrono::steady_clock::now();
      steps.push_back(1e3 * std::chrono::duration<double>(now - before).count());
      apart.push_back(1e3 * std::chrono::duration<double>(now - shown).count());
      shown = now;
    }
    std::sort(steps.begin(), steps.end());
    std::sort(apart.begin() + 1, apart.end());
    state.counters["refreshes_a_second"] = static_cast<double>(steps.size()) / (1e-3 * static_cast<double>(rows));
    state.counters["step_ms_99"] = steps[steps.size() * 99 / 100];
    state.counters["step_ms_longest"] = steps.back();
    state.counters["apart_ms_99"] = apart[apart.size() * 99 / 100];
    state.counters["apart_ms_longest"] = apart.back();
    // Without what waking up for every sample costs the reader.
    const double waiting = processorTime() - readerStart - inSteps;
    state.counters["core_percent"] = 100.0 *
                                     (static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC - waiting) /
                                     (1e-3 * static_cast<double>(rows));
  }
}

/// Resident memory of this process [MB].
double residentMegabytes() {
  std::ifstream file("/proc/self/statm");
  double total = 0.0, resident = 0.0;
  file >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

/// Half an hour at 1 kHz as fast as it goes: the recording again and again, with half a second's pause each time. The
/// memory after two minutes, the largest after that, and that at the end.
void halfAnHour(benchmark::State& state) {
  const Recording& data = recording();
  for (auto _ : state) {
    OnlineEstimator estimator = test::estimatorFor(data, {});
    double early = 0.0, largest = 0.0;
    for (int minute = 0; minute < 30; ++minute) {
      for (Eigen::Index k = 0; k < data.rows(); ++k) {
        OnlineSample sample = sampleOf(data, k);
        sample.time += 60.5 * minute;
        if (estimator.add(sample)) benchmark::DoNotOptimize(estimator.state());
      }
      const double now = residentMegabytes();
      if (minute == 1) early = now;
      largest = std::max(largest, now);
    }
    state.counters["samples"] = static_cast<double>(estimator.state().samples);
    state.counters["used_s"] = estimator.state().usedDuration;
    state.counters["MB_after_2_min"] = early;
    state.counters["MB_largest"] = largest;
    state.counters["MB_at_end"] = residentMegabytes();
  }
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
BENCHMARK(inRealTime)->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK(halfAnHour)->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK(batchEstimate)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace heft
