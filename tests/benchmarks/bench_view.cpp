// How long a frame of the 3D view takes under a private X server, that is with software rendering: the arm in motion as
// in playback (no smoothing), and the smooth frame when it rests. 1000 x 500 pixels.
#include <benchmark/benchmark.h>

#include <QApplication>
#include <cstdio>

#include "core/simulation/simulate.h"
#include "ui/offscreen/private_display.h"
#include "ui/robot_view/graphics_setup.h"
#include "ui/robot_view/robot_view.h"
#include "ui/theme/theme.h"

namespace heft {
namespace {

struct View {
  RobotView view;

  View() {
    Payload payload;
    payload.mass = 0.8;
    payload.com = {0, 0, 0.05};
    payload.inertiaCom = Vector3d(0.001, 0.001, 0.0006).asDiagonal();
    SimulateOptions options;
    options.duration = 8.0;
    auto simulated = simulate(RobotModel::panda(), payload, options);
    Findings findings;
    view.resize(1000, 500);
    view.showRecording(std::make_shared<const Recording>(simulated->recording),
                       std::make_shared<const RobotModel>(RobotModel::panda()), pandaLook(findings));
    auto report = std::make_shared<EstimateReport>();
    report->payload = payload;
    report->std.com = {0.001, 0.001, 0.001};
    view.showReport(report);
    view.show();
    QApplication::processEvents();
  }
};

/// The whole turn: poses, shadow, rendering, labels, compositing.
void playback(benchmark::State& state) {
  View v;
  double time = 0;
  for (auto _ : state) {
    v.view.showTime(time = time > 7 ? 0 : time + 0.033);
    QApplication::processEvents();
  }
  state.counters["render_ms"] = v.view.lastFrameMilliseconds();
}
BENCHMARK(playback)->Unit(benchmark::kMillisecond);

void smoothFrame(benchmark::State& state) {
  View v;
  for (auto _ : state) v.view.renderNow();
  state.counters["render_ms"] = v.view.lastFrameMilliseconds();
}
BENCHMARK(smoothFrame)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace heft

int main(int argc, char** argv) {
  auto display = heft::PrivateDisplay::start(1200, 800);
  if (!display) {
    std::fprintf(stderr, "%s\n", display.error().message.c_str());
    return 1;
  }
  heft::prepareGraphics();
  QApplication application(argc, argv);
  heft::applyTheme(application, heft::ThemeKind::light);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
