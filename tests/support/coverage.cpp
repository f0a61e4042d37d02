#include "tests/support/coverage.h"

#include <atomic>
#include <cmath>
#include <thread>

#include "core/estimation/estimate_prepared.h"
#include "core/estimation/map.h"
#include "core/estimation/prior.h"
#include "core/estimation/uncertainty.h"
#include "core/math/statistics.h"
#include "tests/support/random_tool.h"

namespace heft::test {

namespace {

constexpr double kChiSquared95 = 18.307;  // Ten degrees of freedom

struct Trial {
  bool ok = false, physical = false;
  double joint = 0.0;
  Vector10d inside = Vector10d::Zero(), ratio = Vector10d::Zero(), width = Vector10d::Zero();
  std::array<bool, 10> data{};
  RelativeError error;
  double seconds = 0;
};

std::array<bool, 10> claimed(const Identifiability& id) {
  const auto isData = [](Source source) { return source == Source::data; };
  const auto& I = id.inertia;
  return {isData(id.mass), isData(id.com[0]), isData(id.com[1]), isData(id.com[2]), isData(I[0][0]),
          isData(I[0][1]), isData(I[0][2]),   isData(I[1][1]),   isData(I[1][2]),   isData(I[2][2])};
}

/// Whether the posterior's density at the truth is as high as it is for 95 % of a normal distribution.
bool jointRegionHolds(const Prepared& prepared, const EstimateOptions& options, const Payload& truth) {
  Findings findings;
  const auto chosen = priorFor(options, prepared.whitened, findings);
  if (!chosen) return false;
  const MapSolution solution = solveMap(prepared.whitened, chosen->prior, options.bias, chosen->start);
  const MapCost cost(prepared.whitened, chosen->prior, options.bias);
  return cost(vFromParameters(chosen->prior, toParameters(truth))) - cost(solution.v) < kChiSquared95;
}

Trial run(const CoverageOptions& options, int index) {
  Trial trial;
  std::mt19937 random(options.seed * 100003u + static_cast<unsigned>(index));
  const RandomTool tool = randomTool(random);
  SimulateOptions simulation;
  simulation.motion = options.motion;
  simulation.seed = random();
  simulation.speed = options.speed;
  simulation.duration = options.duration;
  simulation.sensor.forceNoise *= options.noise;
  simulation.sensor.torqueNoise *= options.noise;
  simulation.sensor.colouredForce *= options.colour;
  simulation.sensor.colouredTorque *= options.colour;
  simulation.positionNoise = options.jointNoise;
  simulation.positionStep = options.jointStep;
  auto simulated = simulate(RobotModel::panda(), tool.payload, simulation);
  if (!simulated) return trial;
  Recording& recording = simulated->recording;
  if (!options.velocities) recording.dq.resize(0, recording.dq.cols());
  if (options.alter) options.alter(recording, random);
  EstimateOptions estimateOptions = options.estimate;
  if (options.shape) estimateOptions.shape = tool.shape;
  recording.meta.knownPayload = {tool.payload.mass, tool.payload.com, tool.payload.inertiaCom};
  const auto prepared = prepareFor(recording, &RobotModel::panda(), estimateOptions, {});
  if (!prepared) return trial;
  const auto report = estimatePrepared(recording, *prepared, estimateOptions, {}, 0.0, {});
  if (!report) return trial;
  trial.ok = true;
  trial.physical = report->physicallyConsistent;
  trial.error = *report->relativeError;
  trial.seconds = report->timing.total;
  trial.joint = jointRegionHolds(*prepared, estimateOptions, tool.payload) ? 1.0 : 0.0;
  trial.data = claimed(report->identifiability);
  const Vector10d truth = componentsOf(tool.payload), value = componentsOf(report->payload),
                  std = componentsOf(report->std);
  const auto& i95 = report->interval95;
  const auto& I = i95.inertiaCom;
  const Interval intervals[10] = {i95.mass, i95.com[0], i95.com[1], i95.com[2], I[0][0],
                                  I[0][1],  I[0][2],    I[1][1],    I[1][2],    I[2][2]};
  for (int k = 0; k < 10; ++k) {
    trial.inside(k) = truth(k) >= intervals[k].lower && truth(k) <= intervals[k].upper ? 1.0 : 0.0;
    trial.ratio(k) = (value(k) - truth(k)) / std(k);
    trial.width(k) = 0.5 * (intervals[k].upper - intervals[k].lower);
  }
  trial.width(0) /= truth(0);
  trial.width.segment<3>(1) *= 1e3;
  trial.width.tail<6>() *= 3.0 / tool.payload.inertiaCom.trace();
  return trial;
}

CoverageOf groupOf(const std::vector<Trial>& trials, int first, int count) {
  CoverageOf out;
  std::vector<double> widths;
  double n = 0.0;
  for (const auto& trial : trials) {
    if (!trial.ok) continue;
    out.inside += trial.inside.segment(first, count).mean();
    out.ratio += trial.ratio.segment(first, count).cwiseAbs2().mean();
    widths.push_back(trial.width.segment(first, count).mean());
    n += 1.0;
  }
  out.inside /= std::max(1.0, n);
  out.ratio = std::sqrt(out.ratio / std::max(1.0, n));
  out.width = median(std::move(widths));
  return out;
}

CoverageResult counted(const std::vector<Trial>& trials) {
  CoverageResult out;
  std::vector<double> mass, com, origin, inertia;
  for (const auto& trial : trials) {
    if (!trial.ok) {
      ++out.failed;
      continue;
    }
    ++out.recordings;
    out.unphysical += trial.physical ? 0 : 1;
    out.joint += trial.joint;
    for (int k = 0; k < 10; ++k) {
      if (!trial.data[static_cast<std::size_t>(k)]) continue;
      ++out.claims;
      out.coverageOfClaims += trial.inside(k);
      out.beyond4 += std::abs(trial.ratio(k)) > 4.0 ? 1 : 0;
      out.beyond5 += std::abs(trial.ratio(k)) > 5.0 ? 1 : 0;
    }
    mass.push_back(trial.error.mass);
    com.push_back(trial.error.com);
    origin.push_back(trial.error.inertiaOrigin);
    inertia.push_back(trial.error.inertiaCom);
    out.seconds += trial.seconds;
  }
  const double n = std::max(1, out.recordings);
  out.mass = groupOf(trials, 0, 1);
  out.com = groupOf(trials, 1, 3);
  out.inertia = groupOf(trials, 4, 6);
  out.joint /= n;
  out.coverageOfClaims /= std::max(1, out.claims);
  out.seconds /= n;
  out.massError = median(mass);
  out.comError = median(com);
  out.inertiaOriginError = median(origin);
  out.inertiaComError = median(inertia);
  return out;
}

}  // namespace

CoverageResult measureCoverage(const CoverageOptions& options, int threads) {
  return measureCoverage(std::vector<CoverageOptions>{options}, threads);
}

CoverageResult measureCoverage(const std::vector<CoverageOptions>& kinds, int threads) {
  std::vector<std::pair<const CoverageOptions*, int>> all;
  for (const auto& kind : kinds)
    for (int i = 0; i < kind.recordings; ++i) all.emplace_back(&kind, i);
  std::vector<Trial> trials(all.size());
  std::atomic<std::size_t> next{0};
  {
    std::vector<std::jthread> workers;
    for (int t = 0; t < threads; ++t)
      workers.emplace_back([&] {
        for (std::size_t i = next++; i < all.size(); i = next++) trials[i] = run(*all[i].first, all[i].second);
      });
  }
  return counted(trials);
}

}  // namespace heft::test
