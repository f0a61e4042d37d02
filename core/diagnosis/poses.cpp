#include "core/diagnosis/poses.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

#include "core/base/say.h"
#include "core/base/stop.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/correction/corrected.h"
#include "core/diagnosis/pose_search.h"
#include "core/diagnosis/verdict/description.h"
#include "core/diagnosis/verdict/verdict.h"
#include "core/diagnosis/wording/words.h"
#include "core/math/linear_algebra.h"

namespace heft::diagnosis {

namespace {

/// Half of a 95 % interval over 1.96, for what a deviation from `count` numbers is known to.
double student(double count) { return 1.0 + 1.21 / std::max(1.0, count); }

void setParameters(DiagnosedCause& cause, const PoseFit& fit, double wider) {
  Eigen::Index at = 10;
  for (const auto& [candidate, v] : fit.state.terms) {
    const VectorXd std = wider * fit.covariance.diagonal().segment(at, v.size()).cwiseMax(0.0).cwiseSqrt(),
                   untold = fit.untold.segment(at, v.size());
    at += v.size();
    if (candidate.cause != cause.id) continue;
    if (candidate.form) {
      for (Eigen::Index p = 0; p < v.size(); ++p) {
        const Parameter& parameter = candidate.form->parameters[static_cast<std::size_t>(p)];
        const double scale = parameter.scale;
        if (untold(p) > kUntold) continue;
        cause.parameters.push_back({parameter.name, parameter.unit, scale * v(p), std::abs(scale) * std(p)});
      }
      continue;
    }
    const InOrder& order = candidate.inOrder;
    if (order.course != Course::drift)
      cause.parameters.push_back({"after_pose", "", static_cast<double>(order.from), 0.0});
    if (order.course == Course::load) {
      cause.parameters.push_back({"mass", "g", 1e3 * v(0), 1e3 * std(0)});
      for (int i = 0; i < 3; ++i)
        cause.parameters.push_back({std::string("moment_") + "xyz"[i], "kg m", v(1 + i), std(1 + i)});
      continue;
    }
    constexpr const char* kChannels[] = {"fx", "fy", "fz", "tx", "ty", "tz"};
    for (Eigen::Index c = 0; c < 6; ++c)
      cause.parameters.push_back(
          {kChannels[c], fmt::format("{}{}", c < 3 ? "N" : "N m", order.course == Course::drift ? "/pose" : ""), v(c),
           std(c)});
  }
}

WrenchRms rmsOf(const Wrenches& left, const std::vector<bool>& bad) {
  double f = 0.0, t = 0.0, count = 0.0;
  for (Eigen::Index k = 0; k < left.cols(); ++k) {
    if (bad[static_cast<std::size_t>(k)]) continue;
    f += left.col(k).head<3>().squaredNorm();
    t += left.col(k).tail<3>().squaredNorm();
    count += 3.0;
  }
  WrenchRms out;
  out.force = std::sqrt(f / std::max(1.0, count));
  out.torque = std::sqrt(t / std::max(1.0, count));
  return out;
}

/// The rows that are not bad.
Recording goodRows(const Recording& recording, const std::vector<bool>& bad) {
  Recording out = recording;
  std::vector<Eigen::Index> rows;
  for (Eigen::Index k = 0; k < recording.rows(); ++k)
    if (!bad[static_cast<std::size_t>(k)]) rows.push_back(k);
  const auto keep = [&](auto& series) {
    if (series.rows() > 0) series = series(rows, Eigen::all).eval();
  };
  out.time = recording.time(rows).eval();
  keep(out.q);
  keep(out.dq);
  keep(out.position);
  keep(out.quaternion);
  keep(out.twist);
  keep(out.accelerometer);
  keep(out.gyroscope);
  keep(out.wrench);
  if (!out.labels.empty()) {
    out.labels.clear();
    for (const Eigen::Index k : rows) out.labels.push_back(recording.labels[static_cast<std::size_t>(k)]);
  }
  out.extra.clear();
  return out;
}

/// The deviation is at least `least`.
void grow(double& deviation, Interval& interval, double least) {
  if (!(deviation > 0.0) || !(least > deviation)) return;
  const double factor = least / deviation, middle = 0.5 * (interval.lower + interval.upper);
  interval = {middle + factor * (interval.lower - middle), middle + factor * (interval.upper - middle)};
  deviation = least;
}

void widenMass(EstimateReport& report, double least) { grow(report.std.mass, report.interval95.mass, least); }

void widenBy(EstimateReport& report, const PoseFit& fit, double wider) {
  const double m = std::max(0.02, fit.state.model.x(6));
  grow(report.std.mass, report.interval95.mass, wider * std::sqrt(std::max(0.0, fit.covariance(6, 6))));
  for (int i = 0; i < 3; ++i) {
    const double c = fit.state.model.x(7 + i) / m;
    const double variance =
        fit.covariance(7 + i, 7 + i) - 2.0 * c * fit.covariance(6, 7 + i) + c * c * fit.covariance(6, 6);
    grow(report.std.com(i), report.interval95.com[static_cast<std::size_t>(i)],
         wider * std::sqrt(std::max(0.0, variance)) / m);
  }
}

/// The poses as they are judged, and the mistake that was put right for that.
struct ReadPoses {
  Motion motion;     ///< As the recording states it
  Recording stated;  ///< Without the mistake
  PosesSeen poses;   ///< Of `stated`
  conventions::Report told;
  std::optional<FrameMistake> mistake;
  std::optional<PoseFit> asRecorded;  ///< With the mistake, where there is one
};

Result<ReadPoses> readPoses(const Recording& recording, const RobotModel* robot) {
  auto motion = standingPoses(recording, robot);
  if (!motion) return motion.error();
  if (!recording.hasPosition() && recording.hasOrientation()) motion->originAccelerationKnown = false;
  const auto posesIn = [&](const Recording& of, Motion from) {
    if (of.hasJoints() && !of.hasOrientation()) {
      from.q = of.q.transpose();
      from.dq = from.ddq = MatrixXd::Zero(from.q.rows(), from.q.cols());
    }
    return PosesSeen{signalsOf(of, std::move(from), robot)};
  };
  ReadPoses out{*motion, recording, posesIn(recording, *motion), {}, {}, {}};
  out.told = conventions::check(conventions::questionOf(recording, *motion));
  out.mistake = frameMistake(recording, *motion, out.told);
  if (!out.mistake) return out;
  out.asRecorded = fitted(out.poses, PoseState{});
  auto right = undone(recording, robot, *out.mistake);
  if (!right) return right.error();
  out.stated = std::move(*right);
  auto moved = standingPoses(out.stated, robot);
  if (!moved) return moved.error();
  moved->originAccelerationKnown = motion->originAccelerationKnown;
  out.poses = posesIn(out.stated, std::move(*moved));
  return out;
}

/// What did not fit the other poses: somebody touched the tool there.
DiagnosedCause touchedPoses(const Recording& recording, const PoseFit& fit, const std::vector<bool>& bad) {
  DiagnosedCause out;
  out.id = ids::contact;
  out.direct = true;
  double peak = 0.0;
  for (Eigen::Index k = 0; k < std::ssize(bad); ++k) {
    if (!bad[static_cast<std::size_t>(k)]) continue;
    out.parameters.push_back({fmt::format("pose{}", k + 1), "", static_cast<double>(k + 1), 0.0});
    out.when.emplace_back(recording.time(k), recording.time(k));
    peak = std::max(peak, fit.residual.col(k).head<3>().norm());
  }
  out.parameters.push_back({"peak_force", "N", peak, fit.force});
  return out;
}

/// Adds the causes, the strongest first, with their numbers. `wider`: factor of deviations.
void addCauses(const PoseSearch& search, double wider, std::vector<DiagnosedCause>& causes) {
  for (const NamedSuspect& one : search.named) {
    const auto known = std::ranges::find(causes, one.candidate.cause, &DiagnosedCause::id);
    if (known != causes.end() && !known->direct) {
      known->deltaBic += one.gain;
      continue;
    }
    DiagnosedCause cause;
    cause.id = one.candidate.cause;
    cause.deltaBic = one.gain;
    cause.pValue = std::exp(-0.5 * one.gain);
    cause.alternatives = one.alternatives;
    setParameters(cause, search.fit, wider);
    causes.push_back(std::move(cause));
  }
}

void decide(const ReadPoses& read, const PoseSearch& search, DiagnosisReport& out) {
  out.verdict = out.causes.empty() ? Verdict::clean : Verdict::explained;
  const bool tied =
      std::ranges::any_of(out.causes, [](const DiagnosedCause& c) { return !c.direct && !c.alternatives.empty(); });
  if (tied || (out.mistake && out.mistake->tied)) out.verdict = Verdict::ambiguous;
  if (read.told.verdict == conventions::Verdict::none && search.named.empty()) {
    out.remaining.goesWith = heft::toSay("how the tool is turned");
    out.remaining.gain = 2.0 * read.told.overStated;
    out.verdict = Verdict::unexplained;
  }
}

/// Estimates the payload from the poses as recorded and without the causes.
std::optional<Error> estimateBoth(const Recording& recording, const ReadPoses& read, const RobotModel* robot,
                                  const EstimateOptions& options, const PoseFit& fit, const std::vector<bool>& bad,
                                  double wider, const Progress& progress, DiagnosisReport& out) {
  auto was = estimate(recording, robot, options, progress);
  if (!was) return was.error();
  out.before = std::move(*was);
  out.after = out.before;
  if (out.causes.empty()) return std::nullopt;
  PoseState without = fit.state;
  without.terms.clear();
  Recording clean = read.stated;
  clean.wrench -= (expectedOf(read.poses, fit.state) - expectedOf(read.poses, without)).transpose();
  if (auto is = estimate(goodRows(clean, bad), robot, options, progress)) out.after = std::move(*is);
  widenBy(out.after, fit, wider);
  if (fit.untold(6) <= kUntold) return std::nullopt;
  // As much of the pull may go straight up as shows.
  const Wrenches pull = expectedOf(read.poses, fit.state) - expectedOf(read.poses, without);
  const double size = std::sqrt(pull.topRows<3>().squaredNorm() / static_cast<double>(read.poses.count()));
  widenMass(out.after, size / std::max(1e-9, read.stated.meta.gravity.norm()));
  out.findings.push_back(
      {Severity::warning,
       "mass_not_told",
       heft::say("Something pulls at the tool. How much of that goes straight up or down is unknown, and so is the "
                 "mass, to {:.2g} kg.",
                 1.96 * out.after.std.mass),
       heft::say("Take the pull away and record the poses again."),
       {}});
  return std::nullopt;
}

/// How large each cause that was not named would have to be. `judged`: numbers that the fit leaves.
std::vector<Smallest> smallestInPoses(const PosesSeen& poses, const PoseSearch& search,
                                      const std::vector<DiagnosedCause>& causes, double judged) {
  std::vector<Smallest> out;
  const PoseFit& fit = search.fit;
  for (const Suspect& candidate : search.candidates) {
    if (std::ranges::find(causes, candidate.cause, &DiagnosedCause::id) != causes.end() || !candidate.form ||
        std::ranges::find(out, candidate.cause, &Smallest::cause) != out.end())
      continue;
    PoseState with = fit.state;
    with.add(candidate);
    const MatrixXd C = scalesOf(fit).asDiagonal() * jacobianOf(poses, with).rightCols(candidate.size());
    const MatrixXd Q = orthonormal(fit.jacobian);
    const double seen = (C.col(0) - Q * (Q.transpose() * C.col(0))).norm();
    const Parameter& parameter = candidate.form->parameters.front();
    const double needed = kNeededOfPoses + candidate.price + static_cast<double>(candidate.size()) * std::log(judged);
    out.push_back({candidate.cause, parameter.name, parameter.unit,
                   seen > 1e-9 * C.col(0).norm() ? std::abs(parameter.scale) * std::sqrt(needed) / seen
                                                 : std::numeric_limits<double>::infinity()});
  }
  return out;
}

void addFindings(const ReadPoses& read, DiagnosisReport& out) {
  // A turned sensor is among the causes.
  std::ranges::copy_if(read.told.cautions, std::inserter(out.findings, out.findings.begin()),
                       [](const Finding& caution) { return caution.code != "sensor_turned"; });
  if (out.mistake && !out.mistake->decides.empty())
    out.findings.push_back(
        {Severity::info, "conventions_tied", heft::say("Other conventions fit as well."), out.mistake->decides, {}});
  out.findings.push_back({Severity::info,
                          "poses_cannot_tell",
                          heft::say("Standing poses cannot determine: inertia, delays, friction, a gain that all "
                                    "channels share, a pull straight "
                                    "up or down, or the zero of the first joint."),
                          heft::say("Record a motion with brisk turns for these."),
                          {}});
}

void setSeries(const PosesSeen& poses, const PoseSearch& search, const std::vector<bool>& bad, DiagnosisSeries& out) {
  out.time = VectorXd::LinSpaced(poses.count(), 1.0, static_cast<double>(poses.count()));
  out.measured = poses.signals.measured;
  out.before = poses.signals.measured - search.null.residual;
  out.after = poses.signals.measured - search.fit.residual;
  for (const bool one : bad) out.judged.push_back(!one);
}

}  // namespace

Result<DiagnosisReport> diagnosePoses(const Recording& recording, const RobotModel* robot,
                                      const DiagnoseOptions& options, const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  constexpr Eigen::Index kFewestPoses = 6;
  if (recording.rows() < kFewestPoses)
    return Error{
        heft::say("{} poses are too few to look for causes; record at least {}.", recording.rows(), kFewestPoses)};
  DiagnosisReport out;
  out.file = recording.file;
  out.meta = recording.meta;
  out.ofPoses = recording.hasOrientation();
  progress(0.05, heft::say("Looking at conventions"));
  const auto read = readPoses(recording, robot);
  if (!read) return read.error();
  out.mistake = read->mistake;

  progress(0.2, heft::say("Testing causes"));
  std::vector<std::string> hidden = options.hidden;
  if (out.mistake && out.mistake->has(conventions::Change::turned)) hidden.emplace_back(ids::jointOffset);
  PoseSearch search = searchPoses(read->poses, hidden, progress);
  stopPoint();
  const std::vector<bool> bad = badPoses(read->poses, search.fit);
  const auto badCount = std::ranges::count(bad, true);
  const double judged =
      6.0 * static_cast<double>(read->poses.count() - badCount) - static_cast<double>(search.fit.state.size());
  const double wider = student(judged);

  out.baseline = rmsOf(search.null.residual, bad);
  out.noise = rmsOf(search.fit.residual, bad);
  if (out.mistake) {
    const WrenchRms was = rmsOf(read->asRecorded->residual, std::vector<bool>(bad.size(), false));
    out.causes.push_back(fromMistake(*out.mistake, was, out.baseline));
    out.causes.back().deltaBic = out.mistake->evidence;
    out.baseline = was;
  }
  addCauses(search, wider, out.causes);
  if (badCount > 0) out.causes.push_back(touchedPoses(recording, search.fit, bad));
  decide(*read, search, out);

  progress(0.8, heft::say("Estimating the payload again"));
  if (auto error = estimateBoth(recording, *read, robot, options.estimate, search.fit, bad, wider,
                                Progress{progress.stop, {}}, out))
    return *error;
  out.model = search.fit.state.modelled();
  out.threshold = kNeededOfPoses;
  setSeries(read->poses, search, bad, out.series);
  out.smallest = smallestInPoses(read->poses, search, out.causes, judged);
  addFindings(*read, out);
  putIntoWords(out);
  out.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  progress(1.0, heft::say("Done"));
  return out;
}

}  // namespace heft::diagnosis
