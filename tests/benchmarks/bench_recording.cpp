// How long reading and writing a recording takes: 20 s at 1 kHz, 20,000 rows of 21 columns (time, 7 joints with
// velocities, wrench), as a logger prints it (6 decimals) and with every bit (17 digits). The file lies in the page
// cache.
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <unistd.h>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

#include "core/base/json_file.h"
#include "core/recording/csv_reader.h"

namespace {

constexpr int kRows = 20000;

std::string recordingText(bool everyBit) {
  std::string text = "time,q1,q2,q3,q4,q5,q6,q7,dq1,dq2,dq3,dq4,dq5,dq6,dq7,fx,fy,fz,tx,ty,tz\n";
  std::mt19937 random(1);
  std::normal_distribution<double> noise;
  const auto put = [&](double value) { text += everyBit ? fmt::format("{},", value) : fmt::format("{:.6f},", value); };
  for (int k = 0; k < kRows; ++k) {
    const double t = 1e-3 * k;
    put(t);
    for (int j = 0; j < 7; ++j) put(0.8 * std::sin(0.9 * t + j));
    for (int j = 0; j < 7; ++j) put(0.8 * 0.9 * std::cos(0.9 * t + j));
    for (int i = 0; i < 6; ++i) put(5.0 * std::sin(t + i) + 0.1 * noise(random));
    text.back() = '\n';
  }
  return text;
}

/// A recording file that lives as long as the benchmark.
class TemporaryRecording {
 public:
  explicit TemporaryRecording(bool everyBit)
      : file_(std::filesystem::temp_directory_path() / fmt::format("heft_bench_{}.csv", ::getpid())) {
    std::ofstream(file_, std::ios::binary) << recordingText(everyBit);
    std::ofstream(heft::metaFileOf(file_)) << R"({"robot": "panda"})";
  }
  ~TemporaryRecording() {
    std::error_code ec;
    std::filesystem::remove(file_, ec);
    std::filesystem::remove(heft::metaFileOf(file_), ec);
  }
  TemporaryRecording(const TemporaryRecording&) = delete;
  TemporaryRecording& operator=(const TemporaryRecording&) = delete;
  const std::filesystem::path& file() const { return file_; }

 private:
  std::filesystem::path file_;
};

void readsRecording(benchmark::State& state) {
  const TemporaryRecording recording(state.range(0) != 0);
  for (auto _ : state) {
    auto result = heft::readRecording(recording.file());
    if (!result || result->recording.rows() != kRows) {
      state.SkipWithError("not read");
      break;
    }
    benchmark::DoNotOptimize(result);
  }
}
BENCHMARK(readsRecording)->ArgName("every_bit")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

/// The floor: every number by from_chars, one after the other, kept nowhere.
void parsesNumbersOnly(benchmark::State& state) {
  const auto text = recordingText(state.range(0) != 0);
  for (auto _ : state) {
    const char* at = text.data() + text.find('\n') + 1;
    const char* const end = text.data() + text.size();
    double sum = 0.0;
    while (at < end) {
      double value = 0.0;
      at = std::from_chars(at, end, value).ptr + 1;
      sum += value;
    }
    benchmark::DoNotOptimize(sum);
  }
}
BENCHMARK(parsesNumbersOnly)->ArgName("every_bit")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

void readsFileOnly(benchmark::State& state) {
  const TemporaryRecording recording(state.range(0) != 0);
  for (auto _ : state) benchmark::DoNotOptimize(heft::readTextFile(recording.file()));
}
BENCHMARK(readsFileOnly)->ArgName("every_bit")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

void writesRecording(benchmark::State& state) {
  const TemporaryRecording recording(true);
  const auto result = heft::readRecording(recording.file());
  for (auto _ : state) {
    const auto written = heft::writeRecording(result->recording, recording.file());
    if (!written) state.SkipWithError("not written");
  }
}
BENCHMARK(writesRecording)->Unit(benchmark::kMillisecond);

}  // namespace
