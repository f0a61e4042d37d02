// How long each estimator takes on one simulated recording of 20 s at 1 kHz: 20,000 samples, 120,000 rows of sixteen
// unknowns and the wrench. The yardstick is Eigen's bare Householder QR of the same 120,000 x 17 matrix in float64,
// timed in the same run; the counter "x_bare_QR" is the processor time of all threads over the yardstick's.
//   bench_solvers [--benchmark_filter=REGEX ...]
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <functional>
#include <string>
#include <system_error>

#include "core/estimation/estimate.h"
#include "core/estimation/map.h"
#include "core/estimation/solvers.h"
#include "core/estimation/triangle.h"
#include "core/motion/motion.h"
#include "core/recording/csv_reader.h"
#include "core/simulation/simulate.h"
#include "core/wrench/rows.h"

namespace heft {
namespace {

/// Processor time of all threads of this program, which other programs disturb little.
template <class Work>
double processorSeconds(const Work& work) {
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

struct Problem {
  Payload truth;
  Recording recording;
  Rows rows;             ///< 120,000 x 17
  MatrixXd columnMajor;  ///< The same for the yardstick: Eigen's QR works on columns.
  double bareQr = 0;     ///< [s]

  Problem() {
    truth.mass = 0.8;
    truth.com = {0.01, -0.005, 0.06};
    truth.inertiaCom = Vector3d(0.002, 0.0018, 0.001).asDiagonal();
    const RobotModel& panda = RobotModel::panda();
    SimulateOptions options;
    options.seed = 3;
    recording = simulate(panda, truth, options)->recording;
    recording.meta.knownPayload = {truth.mass, truth.com, truth.inertiaCom};
    MotionOptions everySample;
    everySample.outputRateHz = 0.0;
    const WrenchRows samples = rowsOf(*motionOf(recording, &panda, everySample), 0.0);
    rows.resize(6 * samples.size(), kColumns + 1);
    for (Eigen::Index k = 0; k < samples.size(); ++k) rows.middleRows<6>(6 * k) = blockRows(samples, k);
    columnMajor = rows;
    bareQr = INFINITY;
    for (int i = 0; i < 15; ++i)
      bareQr = std::min(
          bareQr, processorSeconds([&] { benchmark::DoNotOptimize(Eigen::HouseholderQR<MatrixXd>(columnMajor)); }));
  }
};

const Problem& problem() {
  static const Problem instance;
  return instance;
}

/// Runs `work` and states its processor time, alone and in yardsticks: the quickest runs, since other programs only
/// add.
void measure(benchmark::State& state, const std::function<void()>& work) {
  const double yardstick = problem().bareQr;
  double best = INFINITY;
  for (auto _ : state) best = std::min(best, processorSeconds(work));
  state.counters["all_threads_ms"] = 1e3 * best;
  state.counters["x_bare_QR"] = best / yardstick;
}

Triangle compressed() {
  TriangleBuilder builder;
  builder.add(problem().rows);
  return builder.finish();
}

void bareQr(benchmark::State& state) {
  measure(state, [] { benchmark::DoNotOptimize(Eigen::HouseholderQR<MatrixXd>(problem().columnMajor)); });
}
BENCHMARK(bareQr)->Unit(benchmark::kMillisecond);

void compression(benchmark::State& state) {
  measure(state, [] { benchmark::DoNotOptimize(compressed()); });
}
BENCHMARK(compression)->Unit(benchmark::kMillisecond);

/// Compression of all rows and the solver on the triangle.
void compressAndSolve(benchmark::State& state, SolverSolution (*solve)(const SolverProblem&), ParameterSet set) {
  Payload start = problem().truth;
  start.mass *= 1.1;
  start.com += Vector3d(0.005, 0.005, -0.01);
  start.inertiaCom *= 1.3;
  bool usable = true;
  measure(state, [&] { usable = usable && solve(problemFrom(compressed(), set, true, start)).usable; });
  if (!usable) state.SkipWithError("no usable solution");
}

SolverSolution tls(const SolverProblem& p) { return solveScaledTls(p, Eigen::Matrix<double, 11, 1>::Ones()); }

#define HEFT_BENCH_SOLVER(name, solve, set) \
  BENCHMARK_CAPTURE(compressAndSolve, name, solve, ParameterSet::set)->Unit(benchmark::kMillisecond)
HEFT_BENCH_SOLVER(ls_full, solveLeastSquares, full);
HEFT_BENCH_SOLVER(tls_full, tls, full);
HEFT_BENCH_SOLVER(tls_exact_full, solveTls, full);
HEFT_BENCH_SOLVER(ceres_full, solveCeres, full);
HEFT_BENCH_SOLVER(eigen_lm_full, solveEigenLm, full);
HEFT_BENCH_SOLVER(brute_force_mass, solveBruteForce, mass);
HEFT_BENCH_SOLVER(brute_force_mass_com, solveBruteForce, massCom);
HEFT_BENCH_SOLVER(brute_force_full, solveBruteForce, full);
#undef HEFT_BENCH_SOLVER

void compressAndSolveMap(benchmark::State& state) {
  const MapPrior prior = vaguePrior(1.0, Vector3d::Zero());
  Vector6d whitening;
  whitening << Vector3d::Constant(1 / 0.05), Vector3d::Constant(1 / 0.002);
  bool converged = true;
  measure(state, [&] {
    // All rows of a channel are weighted alike here, which is done while they are handed over.
    TriangleBuilder builder;
    Eigen::Matrix<double, 6, kColumns + 1> six;
    const Rows& rows = problem().rows;
    for (Eigen::Index k = 0; k < rows.rows(); k += 6) {
      six = whitening.asDiagonal() * rows.middleRows<6>(k);
      builder.add(six);
    }
    converged = converged && solveMap(builder.finish(), prior, true, Vector10d::Zero()).converged;
  });
  if (!converged) state.SkipWithError("not converged");
}
BENCHMARK(compressAndSolveMap)->Unit(benchmark::kMillisecond);

void motionOfRecording(benchmark::State& state) {
  MotionOptions options;
  options.outputRateHz = static_cast<double>(state.range(0));
  measure(state,
          [&] { benchmark::DoNotOptimize(motionOf(problem().recording, &RobotModel::panda(), options)->size()); });
}
BENCHMARK(motionOfRecording)->ArgName("output_Hz")->Arg(200)->Arg(0)->Unit(benchmark::kMillisecond);

/// Everything after reading: motion at up to four cutoffs, segments, noise, solution, intervals, held-out residual.
void wholeEstimate(benchmark::State& state, Method method) {
  EstimateOptions options;
  options.method = method;
  measure(state, [&] {
    if (!estimate(problem().recording, &RobotModel::panda(), options)) state.SkipWithError("no estimate");
  });
}
BENCHMARK_CAPTURE(wholeEstimate, map, Method::map)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(wholeEstimate, ls, Method::ls)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(wholeEstimate, tls_exact, Method::tlsExact)->Unit(benchmark::kMillisecond);

/// Reading the file (five megabytes from the page cache, every bit of every number), alone and with the estimate.
void readFile(benchmark::State& state, bool andEstimate) {
  const auto file =
      std::filesystem::temp_directory_path() / ("heft_bench_solvers_" + std::to_string(::getpid()) + ".csv");
  if (!writeRecording(problem().recording, file)) state.SkipWithError("not written");
  measure(state, [&] {
    const auto read = readRecording(file);
    if (!read || (andEstimate && !estimate(read->recording, &RobotModel::panda(), {}))) state.SkipWithError("failed");
  });
  std::error_code ignored;
  std::filesystem::remove(file, ignored);
  std::filesystem::remove(metaFileOf(file), ignored);
}
BENCHMARK_CAPTURE(readFile, alone, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(readFile, and_estimate, true)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace heft
