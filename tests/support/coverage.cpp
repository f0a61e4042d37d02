#include "tests/support/coverage.h"

#include <atomic>
#include <cmath>
#include <thread>

#include "core/math/statistics.h"
#include "tests/support/random_tool.h"

namespace heft::test {

namespace {

struct Trial {
  bool ok = false, physical = false;
  Vector10d inside = Vector10d::Zero(), ratio = Vector10d::Zero();
  RelativeError error;
  double seconds = 0;
};

Trial run(const CoverageOptions& options, int index) {
  Trial trial;
  std::mt19937 random(options.seed * 100003u + static_cast<unsigned>(index));
  const RandomTool tool = randomTool(random);
  SimulateOptions simulation;
  simulation.motion = options.motion;
  simulation.seed = random();
  simulation.speed = options.speed;
  simulation.duration = options.duration;
  auto simulated = simulate(RobotModel::panda(), tool.payload, simulation);
  if (!simulated) return trial;
  EstimateOptions estimateOptions = options.estimate;
  if (options.shape) estimateOptions.shape = tool.shape;
  simulated->recording.meta.knownPayload = {tool.payload.mass, tool.payload.com, tool.payload.inertiaCom};
  const auto report = estimate(simulated->recording, &RobotModel::panda(), estimateOptions);
  if (!report) return trial;
  trial.ok = true;
  trial.physical = report->physicallyConsistent;
  trial.error = *report->relativeError;
  trial.seconds = report->timing.total;
  const Vector10d truth = componentsOf(tool.payload), value = componentsOf(report->payload),
                  std = componentsOf(report->std);
  const auto& i95 = report->interval95;
  const auto& I = i95.inertiaCom;
  const Interval intervals[10] = {i95.mass, i95.com[0], i95.com[1], i95.com[2], I[0][0],
                                  I[0][1],  I[0][2],    I[1][1],    I[1][2],    I[2][2]};
  for (int k = 0; k < 10; ++k) {
    trial.inside(k) = truth(k) >= intervals[k].lower && truth(k) <= intervals[k].upper ? 1.0 : 0.0;
    trial.ratio(k) = (value(k) - truth(k)) / std(k);
  }
  return trial;
}

}  // namespace

CoverageResult measureCoverage(const CoverageOptions& options, int threads) {
  std::vector<Trial> trials(static_cast<std::size_t>(options.recordings));
  std::atomic<int> next{0};
  {
    std::vector<std::jthread> workers;
    for (int t = 0; t < threads; ++t)
      workers.emplace_back([&] {
        for (int i = next++; i < options.recordings; i = next++) trials[static_cast<std::size_t>(i)] = run(options, i);
      });
  }
  CoverageResult out;
  std::vector<double> mass, com, origin, inertia;
  Vector10d inside = Vector10d::Zero(), squares = Vector10d::Zero();
  for (const auto& trial : trials) {
    if (!trial.ok) {
      ++out.failed;
      continue;
    }
    ++out.recordings;
    out.unphysical += trial.physical ? 0 : 1;
    inside += trial.inside;
    squares += trial.ratio.cwiseAbs2();
    mass.push_back(trial.error.mass);
    com.push_back(trial.error.com);
    origin.push_back(trial.error.inertiaOrigin);
    inertia.push_back(trial.error.inertiaCom);
    out.seconds += trial.seconds;
  }
  const double n = std::max(1, out.recordings);
  inside /= n;
  squares /= n;
  out.seconds /= n;
  out.mass = inside(0);
  out.com = inside.segment<3>(1).mean();
  out.inertia = inside.tail<6>().mean();
  out.massRatio = std::sqrt(squares(0));
  out.comRatio = std::sqrt(squares.segment<3>(1).mean());
  out.inertiaRatio = std::sqrt(squares.tail<6>().mean());
  out.massError = median(mass);
  out.comError = median(com);
  out.inertiaOriginError = median(origin);
  out.inertiaComError = median(inertia);
  return out;
}

}  // namespace heft::test
