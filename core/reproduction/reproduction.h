#pragma once
// The seed paper's two tables beside ours, on recordings like the paper's, and why the paper saw what it saw.
#include <array>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/reproduction/bar_chart.h"
#include "core/reproduction/paper.h"

namespace heft {

inline constexpr std::array kParameterSets{ParameterSet::mass, ParameterSet::massCom, ParameterSet::full};

struct ReproductionOptions {
  std::uint64_t seed = 1;
  int repeats = 3;            ///< Times the paper's five recordings are made, each with other seeds.
  bool uncompressed = false;  ///< Time the methods on all rows too.
  double scale = 1.0;         ///< Of all durations; below 1 for tests.
  double rateHz = 1000.0;
  int timingRuns = 3;  ///< The median of these is the runtime.
};

/// Relative errors |p_e - p_gt| / |p_gt|, inertia about the sensor's origin; means over recordings.
struct Errors {
  double mass = 0.0, com = 0.0, inertia = 0.0;
  double of(Quantity quantity) const;
};

/// One line of the paper's Table 1.
struct ErrorRow {
  ParameterSet estimated = ParameterSet::full;
  Quantity quantity = Quantity::mass;
  DataKind data = DataKind::measured;
  std::optional<double> paperCeres, paperEigenLm;  ///< The paper prints numbers for the predefined motion only.
  double ceres = 0.0, eigenLm = 0.0;               ///< The paper's equation, smoothing and unweighted rows, no bias.
  double heft = 0.0;                               ///< Heft's default on the same recordings.
};

struct ErrorTable {
  bool handGuided = false;
  int recordings = 0;
  std::vector<ErrorRow> rows;
};

/// One line of the paper's Table 2; arrays follow kParameterSets.
struct RuntimeRow {
  Method method = Method::map;
  std::array<std::optional<PaperTime>, 3> paper;
  std::array<double, 3> solve{};                      ///< From the prepared motion to the numbers [s]
  std::array<double, 3> total{};                      ///< With motion, smoothing, checks, held-out fits [s]
  std::array<std::optional<double>, 3> uncompressed;  ///< As solve, on all rows
};

/// Errors on the predefined motion, all ten parameters estimated, with noise and the named faults.
struct CauseRow {
  std::string cause;  ///< "noise alone", "bias", "delay", "tilt", "all of them"
  Errors paper, heft;
};

struct Reproduction {
  ReproductionOptions options;
  std::vector<ErrorTable> errors;  ///< Predefined, then hand-guided motion.
  std::vector<RuntimeRow> runtimes;
  std::vector<CauseRow> causes;
  double inertialTorque = 0.0;  ///< Mean over the predefined motions of its root mean square [N m]
  double torqueBias = 0.0;      ///< Mean of the simulated sensors' |torque bias| [N m]
  double forceBias = 0.0;       ///< Mean of the simulated sensors' |force bias| [N]
  long rows = 0;                ///< Of the problem whose solution was timed.
};

/// Makes the recordings and runs everything, on all cores except for the timing. Deterministic except for runtimes.
Result<Reproduction> reproducePaper(const ReproductionOptions& options, const Progress& progress = {});

/// Why the numbers are as they are: sentences that follow from the numbers.
std::vector<std::string> explain(const Reproduction& reproduction);

std::string toText(const Reproduction& reproduction);
std::string toMarkdown(const Reproduction& reproduction);
/// One number a line: table,estimated,quantity,data,cause,source,method,value,unit.
std::string toCsv(const Reproduction& reproduction);
nlohmann::json toJson(const Reproduction& reproduction);  ///< heft.reproduce/1

struct NamedChart {
  std::string_view file;  ///< "errors-predefined.svg"
  BarChart chart;
};
std::vector<NamedChart> chartsOf(const Reproduction& reproduction);
/// The files that chartsOf() will name.
std::vector<std::string_view> chartFiles();

}  // namespace heft
