#include "core/estimation/estimate.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>

#include "core/base/remedy.h"
#include "core/base/say.h"
#include "core/estimation/configured.h"
#include "core/estimation/estimate_prepared.h"
#include "core/estimation/inside_shape.h"
#include "core/estimation/judgement.h"
#include "core/estimation/linear_estimate.h"
#include "core/estimation/map.h"
#include "core/estimation/prior.h"
#include "core/estimation/triangle.h"
#include "core/estimation/uncertainty.h"
#include "core/math/linear_algebra.h"

namespace heft {

namespace {

using Clock = std::chrono::steady_clock;
double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

bool isMapFull(const EstimateOptions& options) {
  return options.method == Method::map && options.parameters == ParameterSet::full;
}

std::vector<Triangle> without(const std::vector<Triangle>& folds, std::size_t fold) {
  std::vector<Triangle> rest;
  for (std::size_t i = 0; i < folds.size(); ++i)
    if (i != fold) rest.push_back(folds[i]);
  return rest;
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

/// What needs no solving.
EstimateReport reportOf(const Recording& recording, const Prepared& prepared, const EstimateOptions& options) {
  const bool poses = recording.meta.kind == RecordingKind::poses;
  EstimateReport report;
  report.method = options.method;
  report.parameters = options.parameters;
  report.file = recording.file;
  report.mount = recording.meta.mount;
  report.configured = recording.configured;
  report.samples = recording.rows();
  report.rateHz = poses ? 0.0 : recording.rateHz();
  report.duration = poses ? 0.0 : recording.duration();

  report.usedDuration = prepared.usedDuration;
  report.segments = prepared.segments;
  if (prepared.conventions) report.conventions = *prepared.conventions;
  report.readAsSuggested = prepared.readAsSuggested;
  report.motionFromJoints = !recording.hasOrientation();
  report.findings = prepared.findings;
  report.findings.insert(report.findings.end(), prepared.motion.findings.begin(), prepared.motion.findings.end());
  return report;
}

PartialPayload knownPayload(const Recording& recording, const EstimateOptions& options) {
  PartialPayload known = recording.meta.knownPayload;
  if (options.known.mass) known.mass = options.known.mass;
  if (options.known.com) known.com = options.known.com;
  if (options.known.inertiaCom) known.inertiaCom = options.known.inertiaCom;
  return known;
}

/// Without a known centre of mass the mass alone cannot be had; the centre is then estimated along and not reported as
/// such. Says what is assumed.
void settleParameters(const PartialPayload& known, bool inertiaTold, bool poses, EstimateOptions& options,
                      Findings& findings) {
  if (options.parameters == ParameterSet::mass && !known.com) {
    options.parameters = ParameterSet::massCom;
    findings.push_back({Severity::info,
                        "com_estimated_along",
                        heft::say("The centre of mass is not given, so it was estimated together with the mass."),
                        remedy(Remedy::giveCentre),
                        {}});
  }
  if (options.parameters != ParameterSet::full && !known.inertiaCom && !inertiaTold && !poses)
    findings.push_back(
        {Severity::info,
         "inertia_assumed",
         heft::say("The inertia is neither estimated nor given; a typical tool size was assumed for it."),
         remedy(Remedy::giveInertia),
         {}});
}

Finding heldInside(double moved) {
  return {moved > 3.0 ? Severity::warning : Severity::info,
          "held_inside_shape",
          moved > 0.05 ? heft::say("Without the bound some mass would lie outside the shape; keeping it inside shifted "
                                   "the result by {:.1f} standard deviations.",
                                   moved)
                       : heft::say("The mass lies inside the shape even without the bound."),
          moved > 3.0 ? heft::say("The shape seems too small or misplaced: check it, or leave the bound out.")
                      : std::string(),
          {}};
}

/// The numbers of the chosen method, and what the same method needs to be repeated on a part of the data.
struct Solved {
  SolverSolution solution;
  Vector6d weights = Vector6d::Ones();
  ColumnNoise noise = ColumnNoise::Ones();
  std::vector<Triangle> folds;
  Triangle believed;  ///< The prior as rows, for map with fewer than all parameters
};

/// `fixed`: what is not estimated.
Solved solveBy(const EstimateOptions& options, const Prepared& prepared, const Triangle& whitened,
               const MapPrior& prior, const MapSolution& map, const Payload& fixed) {
  Solved out;
  out.folds = prepared.folds;
  out.believed = priorRows(prior, map.v);
  if (isMapFull(options)) {
    out.solution = {map.phi, map.bias, map.converged, map.iterations,
                    map.converged ? heft::say("Converged: the gradient vanished.")
                                  : heft::say("Stopped before the gradient vanished.")};
    return out;
  }
  if (options.method == Method::map) {
    const Triangle both = merged({whitened, out.believed});
    out.solution = solveWithKnown(Method::map, &both, nullptr, options, fixed, out.noise);
    return out;
  }
  if (options.method == Method::wls || options.method == Method::tls)
    for (int c = 0; c < 6; ++c)
      out.weights(c) = 1.0 / std::max(1e-9, prepared.noise.channels[static_cast<std::size_t>(c)].sigma);
  out.noise = columnNoise(prepared.blocks, out.weights);
  const AllRows all = collectRows(prepared, out.weights, options.uncompressed);
  out.folds = all.folds;
  if (options.uncompressed) {
    out.solution = solveWithKnown(options.method, nullptr, &all.rows, options, fixed, out.noise);
  } else {
    const Triangle triangle = merged(all.folds);
    out.solution = solveWithKnown(options.method, &triangle, nullptr, options, fixed, out.noise);
  }
  return out;
}

void takeSolution(const SolverSolution& solution, EstimateReport& report) {
  report.payload = fromParameters(solution.phi);
  report.payload.inertiaCom = 0.5 * (report.payload.inertiaCom + report.payload.inertiaCom.transpose()).eval();
  report.forceBias = solution.bias.head<3>();
  report.torqueBias = solution.bias.tail<3>();
  report.physicallyConsistent = checkPhysical(report.payload).physical;
  report.termination = {solution.usable, solution.why, solution.iterations};
}

Triangle joinedWith(const Triangle& own, const std::vector<Triangle>& others) {
  std::vector<Triangle> all{own};
  all.insert(all.end(), others.begin(), others.end());
  return merged(all);
}

/// What was not estimated is known from elsewhere, or not at all.
void markFixed(const EstimateOptions& options, bool inertiaKnown, Identifiability& identifiability) {
  for (auto& row : identifiability.inertia) row.fill(inertiaKnown ? Source::prior : Source::none);
  if (options.parameters == ParameterSet::mass) identifiability.com.fill(Source::prior);
}

/// Of mass, centre and inertia about it, by a method other than the full map.
Matrix10d componentCovariance(const EstimateOptions& options, const Prepared& prepared, const Triangle& whitened,
                              const Payload& fixed, const Solved& solved) {
  const Matrix10d J = componentsJacobian(solved.solution.phi);
  Matrix10d covariance =
      J *
      (options.method == Method::map ? covarianceOf(merged({whitened, solved.believed}), options, fixed)
                                     : sandwich(prepared, options, fixed, solved.weights)) *
      J.transpose();
  // The inertia about the centre of mass is known, not derived, where it is not estimated.
  if (options.parameters != ParameterSet::full) {
    covariance.bottomRows<6>().setZero();
    covariance.rightCols<6>().setZero();
  }
  return covariance;
}

/// By the full map.
Matrix10d componentCovariance(const MapPrior& prior, const MapSolution& map) {
  return congruence(product(componentsJacobian(map.phi), parametersJacobian(prior, map.v)), map.covariance);
}

/// With their intervals, or those of a normal distribution.
void takeCovariance(const Matrix10d& covariance, const PayloadInterval* intervals, EstimateReport& report) {
  report.interval95 = intervals ? *intervals : intervalsFromCovariance(componentsOf(report.payload), covariance);
  report.std = standardDeviations(report.interval95);
  report.correlation = correlationFrom(covariance);
}

/// A fit to all folds but one: what it takes is the rest's triangle.
using FitWithout = std::function<SolverSolution(const Triangle& rest)>;

struct HeldOut {
  Residuals residuals;
  Unseen unseen;
};

/// Every fifth of the used time predicted by a fit to the other four; by the whole fit where there are no folds.
HeldOut predictHeldOut(const Prepared& prepared, const Solved& solved, const std::vector<Triangle>& added,
                       const FitWithout& fit) {
  std::vector<SolverSolution> parts;
  for (std::size_t fold = 0; fold < solved.folds.size(); ++fold) {
    std::vector<Triangle> rest = without(solved.folds, fold);
    rest.insert(rest.end(), added.begin(), added.end());
    parts.push_back(fit(merged(rest)));
  }
  const auto solutionOf = [&](Eigen::Index block) -> const SolverSolution& {
    return parts.empty() ? solved.solution : parts[static_cast<std::size_t>(prepared.foldOf(block))];
  };
  return {residualsOver(prepared, solutionOf), unseenOver(prepared, solutionOf)};
}

}  // namespace

Result<Prepared> prepareFor(const Recording& recording, const RobotModel* robot, const EstimateOptions& requested,
                            const Progress& progress) {
  EstimateOptions options = requested;
  if (!(options.trim >= 0.0 && options.trim < 0.5))
    return Error{
        heft::say("The trim is a fraction of the duration at each end, from 0 to below 0.5, not {}.", options.trim)};
  if (options.insideShape && !(isMapFull(options) && options.shape))
    return Error{heft::say("Holding the mass inside the shape needs a shape, the method map and the parameters full.")};
  const bool paperMethod = options.method != Method::map;
  if (paperMethod && recording.meta.kind != RecordingKind::poses)
    options.motion.outputRateHz = 0.0;  // they see every sample
  options.motion.payloadOnly = true;
  return prepare(recording, robot, options, progress, true);
}

Result<EstimateReport> estimate(const Recording& recording, const RobotModel* robot, const EstimateOptions& options,
                                const Progress& progress) {
  const auto begin = Clock::now();
  const auto prepared = prepareFor(recording, robot, options, progress);
  if (!prepared) return prepared.error();
  return estimatePrepared(recording, *prepared, options, {}, secondsSince(begin), progress);
}

Result<EstimateReport> estimatePrepared(const Recording& recording, const Prepared& prepared,
                                        const EstimateOptions& requested, const std::vector<Triangle>& others,
                                        double prepareSeconds, const Progress& progress) {
  const auto begin = Clock::now();
  EstimateOptions options = requested;
  const bool poses = recording.meta.kind == RecordingKind::poses;
  EstimateReport report = reportOf(recording, prepared, options);
  const Triangle whitened = others.empty() ? prepared.whitened : joinedWith(prepared.whitened, others);
  const PartialPayload known = knownPayload(recording, options);

  auto priorResult = priorFor(options, whitened, report.findings);
  if (!priorResult) return priorResult.error();
  const auto& [prior, start, told, priorAlone, boundPoints] = *priorResult;
  report.timing.prepare = prepareSeconds + secondsSince(begin);

  progress(0.8, "Estimating");
  const auto solveBegin = Clock::now();
  // The map solution is always computed: it says what this motion can tell, whichever method gives the numbers.
  const MapSolution unbounded = solveMap(whitened, prior, options.bias, start);
  MapSolution map = unbounded;
  std::optional<ShapeCone> cone;
  std::function<Vector10d(const Vector10d&)> bound;
  if (options.insideShape && boundPoints.cols() > 0) {
    cone.emplace(boundPoints);
    const InsideSolution inside = solveInside(whitened, prior, options.bias, unbounded, *cone);
    map = inside.map;
    bound = [&cone, root = inside.root](const Vector10d& phi) { return cone->nearest(root, phi); };
    report.findings.push_back(heldInside(inside.moved));
  }
  const Payload mapPayload = fromParameters(map.phi);
  // What is not estimated is known; where it is not, the map solution (that is, the shape) stands in.
  const Payload fixed{known.mass.value_or(mapPayload.mass), known.com.value_or(mapPayload.com),
                      known.inertiaCom.value_or(mapPayload.inertiaCom)};
  settleParameters(known, told.inertia, poses, options, report.findings);
  const Solved solved = solveBy(options, prepared, whitened, prior, map, fixed);
  const SolverSolution& solution = solved.solution;
  report.timing.solve = secondsSince(solveBegin);
  if (progress.cancelled()) return Error{"Stopped.", true};

  takeSolution(solution, report);
  const PayloadInterval mapIntervals = intervalsFromV(whitened, prior, options.bias, unbounded, bound);
  takeCovariance(isMapFull(options) ? componentCovariance(prior, map)
                                    : componentCovariance(options, prepared, whitened, fixed, solved),
                 isMapFull(options) ? &mapIntervals : nullptr, report);

  report.identifiability = assess(whitened, prior, map, standardDeviations(mapIntervals), told);
  if (report.parameters != ParameterSet::full)
    markFixed(options, known.inertiaCom || told.inertia, report.identifiability);
  if (!poses)
    report.identifiability.weakDirections =
        weakDirections(report.identifiability, prepared.motion, mapPayload, prepared.silent);
  report.evidence = evidenceOf(whitened, options.bias, map.phi, priorAlone, told);

  const Residuals inSample = residualsOver(prepared, [&](Eigen::Index) -> const SolverSolution& { return solution; });
  report.forceRms = inSample.force;
  report.torqueRms = inSample.torque;

  std::vector<Triangle> added = others;
  if (options.method == Method::map && !isMapFull(options)) added.insert(added.begin(), solved.believed);
  const auto [heldout, unseen] =
      predictHeldOut(prepared, solved, added, [&, &given = prior](const Triangle& rest) -> SolverSolution {
        if (!isMapFull(options)) return solveWithKnown(options.method, &rest, nullptr, options, fixed, solved.noise);
        MapSolution part = solveMap(rest, given, options.bias, unbounded.v);
        if (cone) part = solveInside(rest, given, options.bias, part, *cone).map;
        return {part.phi, part.bias, part.converged, part.iterations, ""};
      });
  report.heldoutForceRms = heldout.force;
  report.heldoutTorqueRms = heldout.torque;

  if (!known.empty()) report.relativeError = relativeErrors(report.payload, known);
  fillSeries(prepared, solution.phi, solution.bias, report.series);
  report.noiseStd = scatterOf((report.series.measured - report.series.simulated).transpose());
  judgeFit(prepared, heldout, unseen, report);
  compareWithKnown(known, report);
  addFindings(report);
  judgeTrust(unseen, report);
  compareWithConfigured(report);
  progress(1.0, "Done");
  report.timing.total = prepareSeconds + secondsSince(begin);
  return report;
}

}  // namespace heft
