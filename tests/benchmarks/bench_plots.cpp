// How long a frame of the plots takes with ten minutes at 1 kHz: 600,000 samples of six channels, measured, simulated
// and difference. Draws into a widget of 1000 x 400 pixels on Qt's offscreen platform; says nothing about compositing.
#include <benchmark/benchmark.h>

#include <QApplication>
#include <QElapsedTimer>
#include <cmath>
#include <random>

#include "ui/theme/theme.h"
#include "ui/timeline/playback.h"
#include "ui/wrench_plots/recording_pane.h"
#include "ui/wrench_plots/wrench_plots.h"

namespace heft {
namespace {

struct Long {
  Recording recording;
  EstimateReport report;

  Long() {
    constexpr Eigen::Index kRows = 600000;
    std::mt19937 random(1);
    std::normal_distribution<double> noise(0.0, 0.05);
    recording.time = VectorXd::LinSpaced(kRows, 0.0, 599.999);
    recording.wrench.resize(kRows, 6);
    report.series.time = recording.time;
    report.series.simulated.resize(kRows, 6);
    for (Eigen::Index i = 0; i < kRows; ++i) {
      for (int c = 0; c < 6; ++c) {
        report.series.simulated(i, c) = 8 * std::sin(recording.time(i) * (0.7 + 0.2 * c));
        recording.wrench(i, c) = report.series.simulated(i, c) + noise(random);
      }
    }
    report.series.measured = recording.wrench;
    report.noiseStd.setConstant(0.05);
  }
};

const Long& longRecording() {
  static const Long data;
  return data;
}

struct Pane {
  Playback playback;
  RecordingPane pane{&playback};

  Pane() {
    pane.resize(1000, 400);
    pane.setRecording(std::make_shared<const Recording>(longRecording().recording),
                      std::make_shared<const EstimateReport>(longRecording().report));
    pane.setSegments(longRecording().report.segments, {});
    pane.show();
    while (pane.jobs()->running()) QApplication::processEvents(QEventLoop::WaitForMoreEvents, 20);
  }
};

void prepareTraces(benchmark::State& state) {
  for (auto _ : state) {
    const WrenchTraces traces(longRecording().recording, &longRecording().report);
    benchmark::DoNotOptimize(traces.lastTime());
  }
}
BENCHMARK(prepareTraces)->Unit(benchmark::kMillisecond);

/// Between almost everything and everything, so that each frame differs.
void zoomFullRange(benchmark::State& state) {
  Pane p;
  int i = 0;
  for (auto _ : state) {
    p.pane.timeAxis()->show(0.0 + (++i % 7), 599.0);
    QApplication::processEvents();
  }
}
BENCHMARK(zoomFullRange)->Unit(benchmark::kMillisecond);

void panOneMinute(benchmark::State& state) {
  Pane p;
  p.pane.timeAxis()->show(100, 160);
  int i = 0;
  for (auto _ : state) {
    const double from = 100 + (++i % 300);
    p.pane.timeAxis()->show(from, from + 60);
    QApplication::processEvents();
  }
}
BENCHMARK(panOneMinute)->Unit(benchmark::kMillisecond);

void panOneSecond(benchmark::State& state) {
  Pane p;
  p.pane.timeAxis()->show(100, 101);
  int i = 0;
  for (auto _ : state) {
    const double from = 100 + 0.01 * (++i % 300);
    p.pane.timeAxis()->show(from, from + 1);
    QApplication::processEvents();
  }
}
BENCHMARK(panOneSecond)->Unit(benchmark::kMillisecond);

/// The smooth frame a moment after the last zoom or pan, for a window of so many tenths of a second.
void settledFrame(benchmark::State& state) {
  Pane p;
  const double span = 0.1 * static_cast<double>(state.range(0));
  int i = 0;
  for (auto _ : state) {
    const double from = 0.001 * (++i % 300);
    p.pane.timeAxis()->show(from, from + span);
    QApplication::processEvents();
    // The longest turn of the event loop within the waiting time is the one that draws.
    QElapsedTimer wait, turn;
    double longest = 0.0;
    for (wait.start(); wait.elapsed() < 220;) {
      turn.start();
      QApplication::processEvents();
      longest = std::max(longest, static_cast<double>(turn.nsecsElapsed()) * 1e-9);
    }
    state.SetIterationTime(longest);
  }
}
BENCHMARK(settledFrame)
    ->Arg(4)
    ->Arg(20)
    ->Arg(200)
    ->Arg(5990)
    ->UseManualTime()
    ->Iterations(8)
    ->Unit(benchmark::kMillisecond);

void moveCursor(benchmark::State& state) {
  Pane p;
  int i = 0;
  for (auto _ : state) {
    p.playback.setTime(100 + 0.33 * (++i % 1000));
    QApplication::processEvents();
  }
}
BENCHMARK(moveCursor)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace heft

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  QApplication application(argc, argv);
  heft::applyTheme(application, heft::ThemeKind::light);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
