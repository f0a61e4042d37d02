#include "core/reproduction/reproduction.h"

#include <algorithm>
#include <atomic>
#include <functional>
#include <mutex>
#include <thread>

#include "core/estimation/comparison.h"
#include "core/math/statistics.h"
#include "core/reproduction/scenario.h"

namespace heft {

double Errors::of(Quantity quantity) const {
  return quantity == Quantity::mass ? mass : quantity == Quantity::com ? com : inertia;
}

namespace {

constexpr SensorFaults kAllFaults{true, true, true};

struct NamedFaults {
  const char* name;
  SensorFaults faults;
};
constexpr std::array kCauses{NamedFaults{"noise alone", {}}, NamedFaults{"bias", {true, false, false}},
                             NamedFaults{"delay", {false, true, false}}, NamedFaults{"tilt", {false, false, true}},
                             NamedFaults{"all of them", kAllFaults}};

/// What the paper did: its equation without biases, its smoothing, every sample of the middle 80 %.
EstimateOptions paperOptions(Method method, ParameterSet parameters) {
  EstimateOptions options;
  options.method = method;
  options.parameters = parameters;
  options.bias = false;
  options.segments = SegmentMode::all;
  options.motion.smoothing = SmoothingKind::savitzkyGolay;
  options.motion.order = 3;
  options.motion.window = 10;
  return options;
}

EstimateOptions heftOptions(ParameterSet parameters) {
  EstimateOptions options;
  options.parameters = parameters;
  return options;
}

/// The errors of one recording; arrays follow kParameterSets, pairs validation and measured.
struct ScenarioErrors {
  std::array<std::array<Errors, 3>, 2> ceres, eigenLm, heft;
  std::array<Errors, kCauses.size()> causePaper, causeHeft;
  double inertialTorque = 0.0, torqueBias = 0.0, forceBias = 0.0;
};

Result<Errors> errorsOf(const Recording& recording, const EstimateOptions& options, const Progress& progress) {
  const auto report = estimate(recording, &RobotModel::panda(), options, Progress{progress.stop, {}});
  if (!report) return report.error();
  const RelativeError error = report->relativeError.value_or(RelativeError{});
  return Errors{error.mass, error.com, error.inertiaOrigin};
}

Result<ScenarioErrors> run(const Scenario& scenario, const Progress& progress) {
  const RobotModel& robot = RobotModel::panda();
  const auto simulated = simulate(robot, scenario.payload, scenario.options, Progress{progress.stop, {}});
  if (!simulated) return simulated.error();
  ScenarioErrors out;
  std::optional<Error> failure;
  const auto errors = [&](const Recording& recording, const EstimateOptions& options) {
    if (failure) return Errors{};
    auto result = errorsOf(recording, options, progress);
    if (!result) failure = result.error();
    return result ? *result : Errors{};
  };

  const Recording real = measured(*simulated, kAllFaults);
  auto validation = validationData(real, robot, scenario.payload);
  if (!validation) return validation.error();
  const std::array<const Recording*, 2> data{&*validation, &real};
  for (std::size_t d = 0; d < 2; ++d)
    for (std::size_t p = 0; p < kParameterSets.size(); ++p) {
      out.ceres[d][p] = errors(*data[d], paperOptions(Method::ceres, kParameterSets[p]));
      out.eigenLm[d][p] = errors(*data[d], paperOptions(Method::eigenLm, kParameterSets[p]));
      out.heft[d][p] = errors(*data[d], heftOptions(kParameterSets[p]));
    }
  if (!scenario.handGuided) {
    for (std::size_t c = 0; c < kCauses.size(); ++c) {
      const Recording one = measured(*simulated, kCauses[c].faults);
      out.causePaper[c] = errors(one, paperOptions(Method::ls, ParameterSet::full));
      out.causeHeft[c] = errors(one, heftOptions(ParameterSet::full));
    }
    const auto torque = inertialTorque(real, robot, scenario.payload);
    if (!torque) return torque.error();
    out.inertialTorque = *torque;
    out.torqueBias = simulated->truth.torqueBias.norm();
    out.forceBias = simulated->truth.forceBias.norm();
  }
  if (failure) return *failure;
  return out;
}

/// Mean of one number over the recordings of one kind.
double mean(const std::vector<const ScenarioErrors*>& all, const std::function<double(const ScenarioErrors&)>& number) {
  double sum = 0.0;
  for (const auto* one : all) sum += number(*one);
  return all.empty() ? 0.0 : sum / static_cast<double>(all.size());
}

Errors meanErrors(const std::vector<const ScenarioErrors*>& all,
                  const std::function<const Errors&(const ScenarioErrors&)>& errors) {
  return {mean(all, [&](const auto& one) { return errors(one).mass; }),
          mean(all, [&](const auto& one) { return errors(one).com; }),
          mean(all, [&](const auto& one) { return errors(one).inertia; })};
}

ErrorTable errorTable(const std::vector<const ScenarioErrors*>& all, bool handGuided) {
  ErrorTable table{handGuided, static_cast<int>(all.size()), {}};
  for (const Quantity quantity : {Quantity::mass, Quantity::com, Quantity::inertia})
    for (std::size_t d = 0; d < 2; ++d)
      for (std::size_t p = static_cast<std::size_t>(quantity); p < kParameterSets.size(); ++p) {
        const DataKind data = d == 0 ? DataKind::validation : DataKind::measured;
        ErrorRow row{kParameterSets[p], quantity, data, {}, {}, 0, 0, 0};
        if (!handGuided) {
          row.paperCeres = paperError(Method::ceres, row.estimated, quantity, data);
          row.paperEigenLm = paperError(Method::eigenLm, row.estimated, quantity, data);
        }
        row.ceres = mean(all, [&](const auto& one) { return one.ceres[d][p].of(quantity); });
        row.eigenLm = mean(all, [&](const auto& one) { return one.eigenLm[d][p].of(quantity); });
        row.heft = mean(all, [&](const auto& one) { return one.heft[d][p].of(quantity); });
        table.rows.push_back(row);
      }
  return table;
}

struct Times {
  double solve = 0.0, total = 0.0;
};

Result<Times> timed(const Recording& recording, EstimateOptions options, bool uncompressed, int runs,
                    const Progress& progress) {
  options.uncompressed = uncompressed;
  std::vector<double> solve, total;
  for (int i = 0; i < std::max(1, runs); ++i) {
    const auto report = estimate(recording, &RobotModel::panda(), options, Progress{progress.stop, {}});
    if (!report) return report.error();
    solve.push_back(report->timing.solve);
    total.push_back(report->timing.total);
  }
  return Times{median(solve), median(total)};
}

/// One recording after the other on every core; the order of the results is that of the scenarios.
Result<std::vector<ScenarioErrors>> runAll(const std::vector<Scenario>& scenarios, const Progress& progress) {
  std::vector<std::optional<Result<ScenarioErrors>>> results(scenarios.size());
  std::atomic<std::size_t> next = 0, done = 0;
  std::mutex reporting;
  const auto work = [&] {
    for (std::size_t i = next++; i < scenarios.size(); i = next++) {
      if (progress.cancelled()) return;
      results[i] = run(scenarios[i], progress);
      const std::lock_guard lock(reporting);
      progress(0.9 * static_cast<double>(++done) / static_cast<double>(scenarios.size()), scenarios[i].name);
    }
  };
  {
    const std::size_t cores = std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, scenarios.size());
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < cores; ++i) threads.emplace_back(work);
  }
  std::vector<ScenarioErrors> all;
  for (auto& result : results) {
    if (!result) return Error{"Stopped.", true};
    if (!*result) return result->error();
    all.push_back(std::move(*result).value());
  }
  return all;
}

}  // namespace

Result<Reproduction> reproducePaper(const ReproductionOptions& options, const Progress& progress) {
  const auto scenarios = paperScenarios(options.seed, std::max(1, options.repeats), options.scale, options.rateHz);
  auto results = runAll(scenarios, progress);
  if (!results) return results.error();
  std::vector<const ScenarioErrors*> predefined, guided;
  for (std::size_t i = 0; i < scenarios.size(); ++i)
    (scenarios[i].handGuided ? guided : predefined).push_back(&(*results)[i]);

  Reproduction out;
  out.options = options;
  out.errors = {errorTable(predefined, false), errorTable(guided, true)};
  for (std::size_t c = 0; c < kCauses.size(); ++c)
    out.causes.push_back({kCauses[c].name,
                          meanErrors(predefined, [c](const auto& one) -> const Errors& { return one.causePaper[c]; }),
                          meanErrors(predefined, [c](const auto& one) -> const Errors& { return one.causeHeft[c]; })});
  out.inertialTorque = mean(predefined, [](const auto& one) { return one.inertialTorque; });
  out.torqueBias = mean(predefined, [](const auto& one) { return one.torqueBias; });
  out.forceBias = mean(predefined, [](const auto& one) { return one.forceBias; });

  const auto simulated = simulate(RobotModel::panda(), scenarios[0].payload, scenarios[0].options);
  if (!simulated) return simulated.error();
  const Recording recording = measured(*simulated, kAllFaults);
  out.rows = 6 * static_cast<long>(recording.rows());
  for (const Method method : kAllMethods) {
    progress(0.9 + 0.1 * static_cast<double>(out.runtimes.size()) / kAllMethods.size(), "Runtimes");
    RuntimeRow row;
    row.method = method;
    for (std::size_t p = 0; p < kParameterSets.size(); ++p) {
      const EstimateOptions each =
          method == Method::map ? heftOptions(kParameterSets[p]) : paperOptions(method, kParameterSets[p]);
      row.paper[p] = paperTime(method, kParameterSets[p]);
      const auto times = timed(recording, each, false, options.timingRuns, progress);
      if (!times) return times.error();
      row.solve[p] = times->solve;
      row.total[p] = times->total;
      if (!options.uncompressed || method == Method::map) continue;  // map has no other form
      const auto allRows = timed(recording, each, true, 1, progress);
      if (!allRows) return allRows.error();
      row.uncompressed[p] = allRows->solve;
    }
    out.runtimes.push_back(row);
  }
  progress(1.0, "Done");
  return out;
}

}  // namespace heft
