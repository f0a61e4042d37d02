// Live listening for an hour: the virtual arm wanders at 1 kHz, its samples go through the session (and onto the disk
// if a folder is given) and the learner, and the window's snapshot is made once a second. Prints every ten minutes the
// processor time of each part as share of one core, what one snapshot costs, and the memory the process holds.
//   bench_live [MINUTES] [FOLDER]
#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>

#include "core/live/session.h"
#include "core/live/virtual_source.h"
#include "ui/live/live_learner.h"

namespace {

double processor() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Resident memory of this process [MB].
double residentMegabytes() {
  std::ifstream file("/proc/self/statm");
  double total = 0, resident = 0;
  file >> total >> resident;
  return resident * 4096.0 / 1e6;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace heft;
  const int minutes = argc > 1 ? std::max(1, std::atoi(argv[1])) : 60;
  VirtualRigOptions options;
  options.payload = practiceTool(1);
  auto owned = VirtualSource::create(RobotModel::panda(), options, VirtualSource::Pace::stepped);
  if (!owned) return fmt::print(stderr, "{}\n", owned.error().message), 1;
  VirtualSource& arm = **owned;
  LiveSession session(30'000);
  session.addSource(std::move(*owned));
  const RecordingMeta meta = VirtualRig::metaFor(options);
  if (argc > 2) {
    const auto file = std::filesystem::path(argv[2]) / "bench_live.csv";
    if (auto recorded = session.record(file, meta); !recorded)
      return fmt::print(stderr, "{}\n", recorded.error().message), 1;
  }
  if (auto started = session.start(); !started) return fmt::print(stderr, "{}\n", started.error().message), 1;
  arm.guide([](GuidedArm& guided) { guided.wander(); });
  auto learner = LiveLearner::create(
      {meta, std::shared_ptr<const RobotModel>(std::shared_ptr<void>(), &RobotModel::panda()), std::nullopt, false});
  if (!learner) return fmt::print(stderr, "{}\n", learner.error().message), 1;

  fmt::print("minute  arm+disk %  learning %  15 snapshots/s %  snapshot ms  memory MB  points  mass kg\n");
  std::vector<LiveSample> fresh;
  double making = 0.0, learning = 0.0, showing = 0.0;
  LiveView view;
  for (int second = 1; second <= 60 * minutes; ++second) {
    const double a = processor();
    arm.advance(1.0);
    const double b = processor();
    session.takeNew(fresh);
    for (const LiveSample& sample : fresh) (*learner)->add(sample);
    const double c = processor();
    view = (*learner)->view();
    const double d = processor();
    making += b - a, learning += c - b, showing += d - c;
    if (second % 600 != 0 && second != 60 && second != 60 * minutes) continue;
    fmt::print("{:6}  {:10.2f}  {:10.2f}  {:16.2f}  {:11.2f}  {:9.0f}  {:6}  {:.4f}\n", second / 60,
               100 * making / second, 100 * learning / second, 1500 * showing / second, 1000 * showing / second,
               residentMegabytes(), view.traces->timesWithin(0, 1e9).size(), view.state.payload.mass);
    std::fflush(stdout);
  }
  session.stop();
  const auto status = session.status();
  fmt::print("samples {}, lost {}, hidden mass {:.4f} kg\n", status.samples, 60000ull * minutes - status.samples,
             options.payload.mass);
  return 0;
}
