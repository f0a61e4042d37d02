#include "core/estimation/estimate.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <functional>

#include "core/estimation/map.h"
#include "core/estimation/prepare.h"
#include "core/estimation/prior.h"
#include "core/estimation/solvers.h"

namespace heft {

namespace {

using Clock = std::chrono::steady_clock;
double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

bool isMapFull(const EstimateOptions& options) {
  return options.method == Method::map && options.parameters == ParameterSet::full;
}

/// Rows for the paper's estimators: every sample of the motion inside the used blocks, each channel times its weight.
struct AllRows {
  std::vector<Triangle> folds;
  Rows rows;  ///< Only filled when the solver runs uncompressed.
  Eigen::Index count = 0;
};

AllRows collectRows(const Prepared& prepared, const Vector6d& weights, bool keepRows) {
  const WrenchRows samples = rowsOf(prepared.motion, 0.0);
  const int perBlock = prepared.blocks.samplesPerBlock;
  std::vector<TriangleBuilder> builders(kFolds);
  AllRows out;
  if (keepRows) out.rows.resize(6 * prepared.usedBlocks * perBlock, kColumns + 1);
  for (const auto& run : prepared.runs) {
    for (Eigen::Index block = run.from; block < run.to; ++block) {
      auto& builder = builders[static_cast<std::size_t>(prepared.foldOf(block))];
      for (Eigen::Index k = block * perBlock; k < (block + 1) * perBlock; ++k) {
        const Eigen::Matrix<double, 6, kColumns + 1> six = weights.asDiagonal() * blockRows(samples, k);
        if (keepRows) {
          out.rows.middleRows<6>(out.count) = six;
        } else {
          builder.add(six);
        }
        out.count += 6;
      }
    }
  }
  if (!keepRows)
    for (auto& builder : builders) out.folds.push_back(builder.finish());
  return out;
}

/// Noise of each regressor column and of the wrench, from steps between neighbouring blocks: what the motion and the
/// sensor change between two blocks bounds their noise from above.
Eigen::Matrix<double, 11, 1> columnNoise(const WrenchRows& blocks, const Vector6d& weights) {
  Eigen::Matrix<double, 11, 1> sum = Eigen::Matrix<double, 11, 1>::Zero();
  double count = 0.0;
  for (Eigen::Index k = 1; k + 1 < blocks.size(); ++k) {
    const auto at = [&](Eigen::Index j) { return static_cast<std::size_t>(j); };
    const Regressor second = blocks.Y[at(k - 1)] - 2.0 * blocks.Y[at(k)] + blocks.Y[at(k + 1)];
    const Vector6d wrench = blocks.wrench.col(k - 1) - 2.0 * blocks.wrench.col(k) + blocks.wrench.col(k + 1);
    sum.head<10>() += (weights.asDiagonal() * second).colwise().squaredNorm().transpose();
    sum(10) += weights.cwiseProduct(wrench).squaredNorm();
    count += 36.0;
  }
  return (sum / std::max(1.0, count)).cwiseSqrt();
}

SolverSolution runSolver(Method method, const SolverProblem& problem, const Eigen::Matrix<double, 11, 1>& noise) {
  switch (method) {
    case Method::tls:
      return solveScaledTls(problem, noise);
    case Method::tlsFast:
      return solveTls(problem, SvdKind::divideAndConquer);
    case Method::tlsExact:
      return solveTls(problem, SvdKind::jacobi);
    case Method::ceres:
      return solveCeres(problem);
    case Method::eigenLm:
      return solveEigenLm(problem);
    case Method::bruteForce:
      return solveBruteForce(problem);
    case Method::map:
    case Method::ls:
    case Method::wls:
      return solveLeastSquares(problem);
  }
  return {};
}

/// Solves, and where the known inertia is about the centre of mass that is itself being estimated, repeats with the
/// inertia moved to it: the shift is of second order, so a few rounds settle it.
SolverSolution solveWithKnown(Method method, const Triangle* triangle, const Rows* rows, const EstimateOptions& options,
                              Payload known, const Eigen::Matrix<double, 11, 1>& noise) {
  SolverProblem problem = triangle ? problemFrom(*triangle, options.parameters, options.bias, known)
                                   : SolverProblem{rows->leftCols<kColumns>(), rows->col(kColumns), options.parameters,
                                                   options.bias, known};
  SolverSolution solution = runSolver(method, problem, noise);
  if (options.parameters != ParameterSet::massCom) return solution;
  for (int round = 0; round < 5 && solution.usable && solution.phi(0) > 0.0; ++round) {
    problem.known.mass = solution.phi(0);
    problem.known.com = solution.phi.segment<3>(1) / solution.phi(0);
    const Vector10d before = solution.phi;
    solution = runSolver(method, problem, noise);
    if ((solution.phi - before).head<4>().norm() < 1e-10 * before.head<4>().norm()) break;
  }
  return solution;
}

std::vector<Triangle> without(const std::vector<Triangle>& folds, std::size_t fold) {
  std::vector<Triangle> rest;
  for (std::size_t i = 0; i < folds.size(); ++i)
    if (i != fold) rest.push_back(folds[i]);
  return rest;
}

/// Covariance of phi for a linear estimator with row weights, noise coloured as found.
Matrix10d sandwich(const Prepared& prepared, const EstimateOptions& options, const Payload& known,
                   const Vector6d& weights) {
  const auto [map, offset] = selectionFor(options.parameters, options.bias, known);
  Eigen::Matrix<double, kColumns, kColumns> bread = Eigen::Matrix<double, kColumns, kColumns>::Zero();
  const Vector6d W = weights.cwiseAbs2();
  for (const auto& run : prepared.runs)
    for (Eigen::Index k = run.from; k < run.to; ++k) {
      const Eigen::Matrix<double, 6, kColumns> A = blockRows(prepared.blocks, k).leftCols<kColumns>();
      bread.noalias() += A.transpose() * W.asDiagonal() * A;
    }
  const MatrixXd H = map.transpose() * bread * map;
  const MatrixXd meat = map.transpose() * scoreCovariance(prepared.blocks, prepared.noise, W, prepared.runs) * map;
  const VectorXd scale = H.diagonal().cwiseSqrt().cwiseMax(1e-300).cwiseInverse();
  const MatrixXd inverse =
      scale.asDiagonal() *
      MatrixXd(scale.asDiagonal() * H * scale.asDiagonal()).completeOrthogonalDecomposition().pseudoInverse() *
      scale.asDiagonal();
  return (map * inverse * meat * inverse * map.transpose()).bottomRightCorner<10, 10>();
}

/// What a solution is judged by: the wrench it predicts against the measured one.
struct Residuals {
  double force = 0, torque = 0;
  Vector6d channels = Vector6d::Zero();
};

Residuals residualsOver(const Prepared& prepared,
                        const std::function<const SolverSolution&(Eigen::Index block)>& solutionOf) {
  Vector6d sum = Vector6d::Zero();
  double count = 0.0;
  const int perBlock = prepared.blocks.samplesPerBlock;
  for (const auto& run : prepared.runs)
    for (Eigen::Index block = run.from; block < run.to; ++block) {
      const SolverSolution& solution = solutionOf(block);
      for (Eigen::Index k = block * perBlock; k < (block + 1) * perBlock; ++k) {
        const Motion& m = prepared.motion;
        const Vector6d predicted =
            regressor({m.specificForce.col(k), m.omega.col(k), m.alpha.col(k)}) * solution.phi + solution.bias;
        sum += (m.wrench.col(k) - predicted).cwiseAbs2();
        count += 1.0;
      }
    }
  sum /= std::max(1.0, count);
  return {std::sqrt(sum.head<3>().mean()), std::sqrt(sum.tail<3>().mean()), sum.cwiseSqrt()};
}

double relative(double error, double size) { return size > 0.0 ? error / size : error; }

RelativeError relativeErrors(const Payload& estimate, const PartialPayload& truth) {
  RelativeError out;
  if (truth.mass) {
    out.hasMass = true;
    out.mass = relative(std::abs(estimate.mass - *truth.mass), *truth.mass);
  }
  if (truth.com) {
    out.hasCom = true;
    out.com = relative((estimate.com - *truth.com).norm(), truth.com->norm());
  }
  if (truth.mass && truth.com && truth.inertiaCom) {
    out.hasInertia = true;
    out.inertiaCom = relative((estimate.inertiaCom - *truth.inertiaCom).norm(), truth.inertiaCom->norm());
    const Matrix3d origin = inertiaAboutOrigin({*truth.mass, *truth.com, *truth.inertiaCom});
    out.inertiaOrigin = relative((inertiaAboutOrigin(estimate) - origin).norm(), origin.norm());
  }
  return out;
}

void fillSeries(const Prepared& prepared, const Vector10d& phi, const Vector6d& bias, WrenchSeries& series) {
  const Motion& m = prepared.motion;
  series.time.resize(m.size());
  series.measured = m.wrench.transpose();
  series.simulated.resize(m.size(), 6);
  for (Eigen::Index k = 0; k < m.size(); ++k) {
    series.time(k) = m.time(k);
    series.simulated.row(k) =
        (regressor({m.specificForce.col(k), m.omega.col(k), m.alpha.col(k)}) * phi + bias).transpose();
  }
}

/// Says where a rigid tool does not explain the data, in numbers that need no statistics.
void judgeFit(const Prepared& prepared, const Residuals& heldout, EstimateReport& report) {
  double contact = 0.0;
  std::string where;
  int listed = 0;
  for (const auto& segment : report.segments) {
    if (segment.label != MarkLabel::contact) continue;
    contact += segment.to - segment.from;
    if (++listed > 6) continue;
    where += fmt::format("{}{:.1f} to {:.1f} s", where.empty() ? "" : ", ", std::max(0.0, segment.from), segment.to);
  }
  if (listed > 6) where += fmt::format(" and {} more", listed - 6);
  const bool mostlyContact = contact > 0.3 * report.duration;
  if (contact > 0.0)
    report.findings.push_back(
        {mostlyContact ? Severity::warning : Severity::info,
         "contact_left_out",
         fmt::format("{:.1f} s of {:.1f} s looked like contact and were left out: {}.", contact, report.duration,
                     where),
         mostlyContact ? "Trust is low with so little free motion: check the marks, or record a longer free part."
                       : "Mark them by hand if that is wrong.",
         {}});

  // What is slow and strong in the residual is no sensor noise. Long memory of a channel shows it, and so does a
  // residual far above the scatter between neighbouring samples.
  double memory = 0.0;
  for (const auto& channel : prepared.noise.channels)
    memory = std::max(memory, channel.gain() > 0.0 ? channel.gain() : 1e3);
  std::array<double, 6> floor{};
  for (int c = 0; c < 6; ++c) {
    std::vector<double> steps;
    for (Eigen::Index k = 1; k < prepared.motion.size(); ++k)
      if (const double d = prepared.motion.wrench(c, k) - prepared.motion.wrench(c, k - 1); d != 0.0)
        steps.push_back(d);
    floor[static_cast<std::size_t>(c)] = robustStd(steps) / std::sqrt(2.0);
  }
  const double forceFloor = std::sqrt((floor[0] * floor[0] + floor[1] * floor[1] + floor[2] * floor[2]) / 3.0);
  const bool strong = heldout.force > 3.0 * forceFloor && heldout.force > 0.01 * report.payload.mass * 9.81;
  const bool slow = memory > 8.0 && heldout.force > 1.3 * forceFloor;
  if (prepared.usedDuration > 0.0 && (strong || slow))
    report.findings.push_back(
        {Severity::warning,
         "misfit",
         fmt::format(
             "On stretches that were not used for fitting, the model misses the measured force by {:.2g} N, where the "
             "sensor's own scatter is {:.2g} N: something besides a rigid tool is at work (contact, drift, delay, a "
             "cable, a poorly calibrated sensor).",
             heldout.force, forceFloor),
         "Trust is low: the true values may lie outside the intervals. Look at where the difference is large.",
         {}});

  // A clearly negative mass is the other sign of the wrench. Linear fits say it; the map estimate cannot.
  if (report.identifiability.mass == Source::data || report.payload.mass < 0.0) {
    const MatrixXd A = prepared.whitened.leftCols<kColumns>();
    const VectorXd x = A.colPivHouseholderQr().solve(prepared.whitened.col(kColumns));
    const double mass = x(kBiasColumns);
    const double sd = (A.transpose() * A)
                          .completeOrthogonalDecomposition()
                          .pseudoInverse()
                          .diagonal()
                          .cwiseMax(0.0)
                          .cwiseSqrt()(kBiasColumns);
    if (mass < -6.0 * sd && mass < -0.02)
      report.findings.push_back(
          {Severity::warning,
           "wrench_sign",
           fmt::format("A plain fit gives a mass of {:.2f} kg: the wrench seems to have the opposite sign.", mass),
           "Set sensor.wrench_sign in the meta file to the other convention (sensor_on_payload or "
           "payload_on_sensor).",
           {}});
  }

  // Values that the user gave and the data contradict.
  if (report.relativeError && report.relativeError->hasMass && report.identifiability.mass == Source::data &&
      report.relativeError->mass > 0.03 && report.relativeError->mass * report.payload.mass > 4.0 * report.std.mass)
    report.findings.push_back(
        {Severity::warning,
         "known_disagrees",
         fmt::format("The estimated mass is {:.0f} % away from the known one, far outside its interval.",
                     100.0 * report.relativeError->mass),
         "Either the known value is of another tool, or the sensor's calibration is off: trust is low.",
         {}});
}

void addFindings(EstimateReport& report) {
  const auto count = [](const auto& sources, Source wanted) {
    return std::count(sources.begin(), sources.end(), wanted);
  };
  const Identifiability& id = report.identifiability;
  if (id.mass == Source::none)
    report.findings.push_back({Severity::warning,
                               "mass_not_known",
                               "This motion cannot tell the mass; the number is a placeholder.",
                               "Tilt the tool into several directions.",
                               {}});
  if (count(id.com, Source::none) > 0)
    report.findings.push_back(
        {Severity::warning,
         "com_not_known",
         "This motion cannot tell the whole centre of mass; what is marked \"none\" is a placeholder.",
         "Tilt the tool about more axes.",
         {}});
  int unknown = 0;
  for (std::size_t i = 0; i < 3; ++i) unknown += id.inertia[i][i] == Source::none ? 1 : 0;
  if (unknown > 0 && report.parameters == ParameterSet::full)
    report.findings.push_back(
        {Severity::warning,
         "inertia_not_known",
         fmt::format("This motion cannot tell {} of the three moments of inertia; they are placeholders with wide "
                     "intervals.",
                     unknown),
         "Turn the tool faster, or give its shape.",
         {}});
  if (!report.physicallyConsistent)
    report.findings.push_back({Severity::warning,
                               "not_physical",
                               "No real body has these numbers: " + checkPhysical(report.payload).reason,
                               "Use the method map, which always gives a possible payload.",
                               {}});
  if (!report.termination.usable)
    report.findings.push_back({Severity::warning,
                               "solver_not_usable",
                               "The solver did not reach a trustworthy solution: " + report.termination.why,
                               "Use the method map.",
                               {}});
  for (const auto& words : id.weakDirections)
    report.findings.push_back({Severity::info, "weak_direction", words, "", {}});
}

}  // namespace

Result<EstimateReport> estimate(const Recording& recording, const RobotModel* robot, const EstimateOptions& requested,
                                const Progress& progress) {
  const auto begin = Clock::now();
  EstimateOptions options = requested;
  const bool poses = recording.meta.kind == RecordingKind::poses;
  if (!(options.trim >= 0.0 && options.trim < 0.5))
    return Error{
        fmt::format("The trim is a fraction of the duration at each end, from 0 to below 0.5, not {}.", options.trim)};
  const bool paperMethod = options.method != Method::map;
  if (paperMethod && !poses) options.motion.outputRateHz = 0.0;  // they see every sample

  EstimateReport report;
  report.method = options.method;
  report.parameters = options.parameters;
  report.file = recording.file;
  report.mount = recording.meta.mount;
  report.samples = recording.rows();
  report.rateHz = poses ? 0.0 : recording.rateHz();
  report.duration = poses ? 0.0 : recording.duration();

  auto preparedResult = prepare(recording, robot, options, progress);
  if (!preparedResult) return preparedResult.error();
  const Prepared& prepared = *preparedResult;
  report.usedDuration = prepared.usedDuration;
  report.segments = prepared.segments;
  report.findings = prepared.findings;
  report.findings.insert(report.findings.end(), prepared.motion.findings.begin(), prepared.motion.findings.end());
  const Triangle& whitened = prepared.whitened;

  PartialPayload known = recording.meta.knownPayload;
  if (options.known.mass) known.mass = options.known.mass;
  if (options.known.com) known.com = options.known.com;
  if (options.known.inertiaCom) known.inertiaCom = options.known.inertiaCom;

  auto priorResult = priorFor(options, whitened, report.findings);
  if (!priorResult) return priorResult.error();
  const auto& [prior, start, userPrior] = *priorResult;
  report.timing.prepare = secondsSince(begin);

  progress(0.8, "Estimating");
  const auto solveBegin = Clock::now();
  // The map solution is always computed: it says what this motion can tell, whichever method gives the numbers.
  const MapSolution map = solveMap(whitened, prior, options.bias, start);
  const Payload mapPayload = fromParameters(map.phi);
  // What is not estimated is known; where it is not, the map solution (that is, the shape) stands in.
  Payload fixed{known.mass.value_or(mapPayload.mass), known.com.value_or(mapPayload.com),
                known.inertiaCom.value_or(mapPayload.inertiaCom)};
  // Without a known centre of mass the mass alone cannot be had; the centre is then estimated along and not reported as
  // such.
  if (options.parameters == ParameterSet::mass && !known.com) {
    options.parameters = ParameterSet::massCom;
    report.findings.push_back({Severity::info,
                               "com_estimated_along",
                               "The centre of mass is not given, so it was estimated together with the mass.",
                               "Give it with --known to hold it fixed.",
                               {}});
  }
  if (options.parameters != ParameterSet::full && !known.inertiaCom && !options.shape && !poses)
    report.findings.push_back({Severity::info,
                               "inertia_assumed",
                               "The inertia is neither estimated nor given; a tool of usual size was assumed for it.",
                               "Give it with --known, or a shape with --shape.",
                               {}});

  SolverSolution solution;
  Vector6d weights = Vector6d::Ones();
  AllRows all;
  Eigen::Matrix<double, 11, 1> noise = Eigen::Matrix<double, 11, 1>::Ones();
  std::vector<Triangle> folds = prepared.folds;
  if (isMapFull(options)) {
    solution = {map.phi, map.bias, map.converged, map.iterations,
                map.converged ? "Converged: the gradient vanished." : "Stopped before the gradient vanished."};
  } else if (options.method == Method::map) {
    solution = solveWithKnown(Method::map, &whitened, nullptr, options, fixed, noise);
  } else {
    if (options.method == Method::wls || options.method == Method::tls)
      for (int c = 0; c < 6; ++c)
        weights(c) = 1.0 / std::max(1e-9, prepared.noise.channels[static_cast<std::size_t>(c)].sigma);
    noise = columnNoise(prepared.blocks, weights);
    all = collectRows(prepared, weights, options.uncompressed);
    folds = all.folds;
    if (options.uncompressed) {
      solution = solveWithKnown(options.method, nullptr, &all.rows, options, fixed, noise);
    } else {
      const Triangle triangle = merged(all.folds);
      solution = solveWithKnown(options.method, &triangle, nullptr, options, fixed, noise);
    }
  }
  report.timing.solve = secondsSince(solveBegin);
  if (progress.cancelled()) return Error{"Stopped.", true};

  report.payload = fromParameters(solution.phi);
  report.payload.inertiaCom = 0.5 * (report.payload.inertiaCom + report.payload.inertiaCom.transpose()).eval();
  report.forceBias = solution.bias.head<3>();
  report.torqueBias = solution.bias.tail<3>();
  report.physicallyConsistent = checkPhysical(report.payload).physical;
  report.termination = {solution.usable, solution.why, solution.iterations};
  const PayloadInterval mapIntervals = intervalsFromV(whitened, prior, options.bias, map);
  if (isMapFull(options)) {
    report.interval95 = mapIntervals;
  } else {
    Vector6d rowWeights = weights;
    if (options.method == Method::map)
      for (int c = 0; c < 6; ++c)
        rowWeights(c) = 1.0 / std::max(1e-9, prepared.noise.channels[static_cast<std::size_t>(c)].sigma);
    const Matrix10d J = componentsJacobian(solution.phi);
    Matrix10d covariance = J * sandwich(prepared, options, fixed, rowWeights) * J.transpose();
    // The inertia about the centre of mass is known, not derived, where it is not estimated.
    if (options.parameters != ParameterSet::full) {
      covariance.bottomRows<6>().setZero();
      covariance.rightCols<6>().setZero();
    }
    report.interval95 = intervalsFromCovariance(componentsOf(report.payload), covariance);
  }
  report.std = standardDeviations(report.interval95);

  report.identifiability = assess(whitened, prior, map, standardDeviations(mapIntervals), userPrior);
  if (report.parameters != ParameterSet::full) {
    for (auto& row : report.identifiability.inertia)
      row.fill(known.inertiaCom || options.shape ? Source::prior : Source::none);
    if (options.parameters == ParameterSet::mass) report.identifiability.com.fill(Source::prior);
  }
  if (!poses) report.identifiability.weakDirections = weakDirections(report.identifiability, prepared.motion);

  const Residuals inSample = residualsOver(prepared, [&](Eigen::Index) -> const SolverSolution& { return solution; });
  report.forceRms = inSample.force;
  report.torqueRms = inSample.torque;
  report.noiseStd = inSample.channels;

  // Held out: every fifth of the used time predicted by a fit to the other four.
  Residuals heldout = inSample;
  if (!folds.empty()) {
    std::vector<SolverSolution> heldoutSolutions;
    for (std::size_t fold = 0; fold < folds.size(); ++fold) {
      const Triangle rest = merged(without(folds, fold));
      if (isMapFull(options)) {
        const MapSolution part = solveMap(rest, prior, options.bias, map.v);
        heldoutSolutions.push_back({part.phi, part.bias, part.converged, part.iterations, ""});
      } else {
        heldoutSolutions.push_back(solveWithKnown(options.method, &rest, nullptr, options, fixed, noise));
      }
    }
    heldout = residualsOver(prepared, [&](Eigen::Index block) -> const SolverSolution& {
      return heldoutSolutions[static_cast<std::size_t>(prepared.foldOf(block))];
    });
  }
  report.heldoutForceRms = heldout.force;
  report.heldoutTorqueRms = heldout.torque;

  if (!known.empty()) report.relativeError = relativeErrors(report.payload, known);
  fillSeries(prepared, solution.phi, solution.bias, report.series);
  judgeFit(prepared, heldout, report);
  addFindings(report);
  progress(1.0, "Done");
  report.timing.total = secondsSince(begin);
  return report;
}

}  // namespace heft
