#include "core/diagnosis/poses.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <utility>

#include "core/base/say.h"
#include "core/diagnosis/causes/catalogue.h"
#include "core/diagnosis/correction/corrected.h"
#include "core/diagnosis/pose_fit.h"
#include "core/diagnosis/search/search.h"
#include "core/diagnosis/verdict/description.h"
#include "core/diagnosis/verdict/verdict.h"
#include "core/diagnosis/wording/words.h"
#include "core/math/linear_algebra.h"

namespace heft::diagnosis {

namespace {

/// Everything that poses may show.
std::vector<Suspect> suspectsFor(const PosesSeen& poses, const std::vector<std::string>& hidden) {
  constexpr std::pair<const char*, bool> kForms[] = {
      {"sensor_rotation", false}, {"gravity_tilt", false}, {"constant_pull", false}, {"cable_pull", false},
      {"gain_error", true},       {"crosstalk", true},     {"joint_offset", true}};
  std::vector<Suspect> out;
  const auto isHidden = [&](std::string_view id) { return std::ranges::find(hidden, id) != hidden.end(); };
  const auto price = [&](std::size_t from) {
    const auto count = static_cast<double>(out.size() - from);
    for (std::size_t i = from; i < out.size(); ++i) out[i].price = 2.0 * std::log(count);
  };
  for (const auto& [id, several] : kForms) {
    if (isHidden(id)) continue;
    const std::size_t from = out.size();
    const std::vector<Form> forms = findCause(id)->forms(poses.signals);
    for (const Form& form : forms) {
      // The simple ones: a spring towards one spot, one channel's gain, one joint's zero.
      const bool simple =
          !form.local && !form.later && !form.guide && !form.rare &&
          (several ? form.parameters.size() == 1 && form.name != "all forces" : &form == &forms.front());
      if (!simple || (form.cause->id() == "cable_pull" && !poses.signals.positionKnown)) continue;
      out.push_back({id, std::make_shared<const Form>(form), {}});
    }
    price(from);
  }
  constexpr Eigen::Index kBeside = 3;  // Poses on either side of a change
  if (!isHidden("bias_drift")) out.push_back({"bias_drift", nullptr, {Course::drift, 0, {}}});
  for (const auto& [id, course] : {std::pair{"sensor_bias", Course::jump}, {"payload_change", Course::load}}) {
    if (isHidden(id)) continue;
    const std::size_t from = out.size();
    for (Eigen::Index k = kBeside; k + kBeside <= poses.count(); ++k) out.push_back({id, nullptr, {course, k, {}}});
    price(from);
  }
  return out;
}

struct PoseTrial {
  const Suspect* candidate;
  double promise = 0.0;
  std::optional<PoseFit> fit;
  double gain = 0.0, plain = 0.0;  ///< Evidence with prices, and without
};

/// The few candidates that promise most beside `base`, fitted, best first.
std::vector<PoseTrial> trialsBeside(const PosesSeen& poses, const PoseFit& base,
                                    const std::vector<Suspect>& candidates) {
  constexpr std::size_t kTried = 14, kOfOne = 3;
  const VectorXd scale = scalesOf(base), r = scale.cwiseProduct(flat(base.residual));
  const MatrixXd Q = orthonormal(base.jacobian);
  const double n = static_cast<double>(r.size()), all = r.squaredNorm();
  std::vector<PoseTrial> out;
  for (const Suspect& candidate : candidates) {
    const bool known = std::ranges::any_of(base.state.terms, [&](const auto& term) {
      return term.first.cause == candidate.cause && (candidate.form == nullptr || term.first.form == candidate.form);
    });
    if (known) continue;
    PoseState with = base.state;
    with.add(candidate);
    MatrixXd C = scale.asDiagonal() * jacobianOf(poses, with).rightCols(candidate.size());
    const VectorXd norms = C.colwise().norm().transpose();
    C -= Q * (Q.transpose() * C);
    // What mass, centre and zero do as well, nobody sees.
    if (!((C.colwise().norm().transpose() - 1e-4 * norms).maxCoeff() > 0.0)) continue;
    const double left = (r - C * solved(C, r)).squaredNorm();
    const double promise = n * std::log(all / std::max(1e-12 * all, left)) -
                           static_cast<double>(candidate.size()) * std::log(n) - candidate.price;
    out.push_back({&candidate, promise, {}});
  }
  std::ranges::sort(out, std::greater{}, &PoseTrial::promise);
  std::map<std::string, std::size_t> tried;
  std::erase_if(out, [&](const PoseTrial& trial) { return tried[trial.candidate->cause]++ >= kOfOne; });
  if (out.size() > kTried) out.resize(kTried);
  for (PoseTrial& trial : out) {
    PoseState with = base.state;
    with.add(*trial.candidate);
    trial.fit = fitted(poses, std::move(with));
    // What is fitted leaves fewer numbers to judge by: that counts where the poses are few.
    const double numbers = static_cast<double>(trial.candidate->size()),
                 left = std::max(1.0, n - static_cast<double>(trial.fit->state.size()));
    trial.plain = left / n * (trial.fit->evidence - base.evidence + numbers * std::log(n));
    trial.gain = trial.plain - numbers * std::log(n) - trial.candidate->price;
  }
  std::ranges::sort(out, std::greater{}, &PoseTrial::gain);
  return out;
}

bool isBelievable(const PoseFit& fit) {
  for (const auto& [candidate, v] : fit.state.terms)
    for (Eigen::Index p = 0; candidate.form && p < v.size(); ++p) {
      const Parameter& parameter = candidate.form->parameters[static_cast<std::size_t>(p)];
      if (!(v(p) > parameter.lower && v(p) < parameter.upper)) return false;
    }
  return fit.state.model.x(6) > 0.0;
}

struct NamedSuspect {
  Suspect candidate;
  double gain = 0.0;
  std::vector<std::string> alternatives;
};

/// Poses that do not fit the others, by least squares on these.
std::vector<bool> badPoses(const PosesSeen& poses, PoseFit& fit) {
  constexpr double kChance = 1e-4;  // Of one in a whole recording by chance
  constexpr int kRounds = 5;
  const Eigen::Index K = poses.count();
  // The median of |e|^2 of three normal numbers is 2.366.
  const auto scale = [&](bool torque) {
    std::vector<double> squares;
    for (Eigen::Index k = 0; k < K; ++k)
      squares.push_back((torque ? fit.residual.col(k).tail<3>() : fit.residual.col(k).head<3>()).squaredNorm());
    std::ranges::nth_element(squares, squares.begin() + K / 2);
    return std::max(1e-6, std::sqrt(squares[static_cast<std::size_t>(K / 2)] / 2.366));
  };
  double force = scale(false), torque = scale(true);
  std::vector<bool> bad(static_cast<std::size_t>(K), false);
  for (int round = 0; round < kRounds; ++round) {
    VectorXd used = VectorXd::Ones(K);
    for (Eigen::Index k = 0; k < K; ++k) {
      const double x = fit.residual.col(k).head<3>().squaredNorm() / (force * force) +
                       fit.residual.col(k).tail<3>().squaredNorm() / (torque * torque);
      // Of six normal numbers.
      if (static_cast<double>(K) * std::exp(-0.5 * x) * (1.0 + 0.5 * x + 0.125 * x * x) < kChance) used(k) = 0.0;
    }
    // Where more than a third does not fit, nobody knows which poses are bad.
    if (3.0 * used.sum() < 2.0 * static_cast<double>(K)) used.setOnes();
    std::vector<bool> now;
    for (Eigen::Index k = 0; k < K; ++k) now.push_back(used(k) == 0.0);
    fit = fitted(poses, fit.state, used);
    force = fit.force;
    torque = fit.torque;
    if (round > 0 && now == bad) break;
    bad = std::move(now);
  }
  return bad;
}

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

}  // namespace

Result<DiagnosisReport> diagnosePoses(const Recording& recording, const RobotModel* robot,
                                      const DiagnoseOptions& options, const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  constexpr Eigen::Index kLeast = 6;
  if (recording.rows() < kLeast)
    return Error{heft::say("{} poses are too few to look for causes; record at least {}.", recording.rows(), kLeast)};
  DiagnosisReport out;
  out.file = recording.file;
  out.meta = recording.meta;
  out.ofPoses = recording.hasOrientation();
  progress(0.05, heft::say("Looking at conventions"));
  auto motion = standingPoses(recording, robot);
  if (!motion) return motion.error();
  if (!recording.hasPosition() && recording.hasOrientation()) motion->originAccelerationKnown = false;
  const conventions::Report told = conventions::check(conventions::questionOf(recording, *motion));
  out.mistake = frameMistake(recording, *motion, told);
  Recording stated = recording;
  const auto posesIn = [&](const Recording& of, Motion from) {
    if (of.hasJoints() && !of.hasOrientation()) {
      from.q = of.q.transpose();
      from.dq = from.ddq = MatrixXd::Zero(from.q.rows(), from.q.cols());
    }
    return PosesSeen{signalsOf(of, from, robot)};
  };
  PosesSeen poses = posesIn(recording, *motion);
  std::optional<PoseFit> before;
  if (out.mistake) {
    before = fitted(poses, PoseState{});
    auto right = undone(recording, robot, *out.mistake);
    if (!right) return right.error();
    stated = std::move(*right);
    auto moved = standingPoses(stated, robot);
    if (!moved) return moved.error();
    moved->originAccelerationKnown = motion->originAccelerationKnown;
    poses = posesIn(stated, std::move(*moved));
  }

  progress(0.2, heft::say("Trying causes"));
  std::vector<std::string> hidden = options.hidden;
  if (out.mistake && out.mistake->has(conventions::Change::turned)) hidden.emplace_back("joint_offset");
  const std::vector<Suspect> candidates = suspectsFor(poses, hidden);
  // Ten for a cause, as for motions, and for as many kinds as there are.
  constexpr double kNeeded = 10.0 + 4.6, kTied = 6.0;
  constexpr std::size_t kMost = 3;
  const PoseFit null = fitted(poses, PoseState{});
  PoseFit fit = null;
  std::vector<NamedSuspect> named;
  while (named.size() < kMost && !progress.cancelled() && fit.state.size() + 8 < 3 * poses.count()) {
    auto trials = trialsBeside(poses, fit, candidates);
    std::erase_if(trials, [](const PoseTrial& trial) { return !isBelievable(*trial.fit); });
    if (trials.empty() || trials.front().gain < kNeeded) break;
    const PoseTrial& best = trials.front();
    NamedSuspect next{*best.candidate, best.gain, {}};
    for (const PoseTrial& other : trials) {
      const std::string& id = other.candidate->cause;
      // More numbers always fit as well; as many or fewer say that the poses do not tell.
      const bool ties = best.gain - other.gain < kTied || best.plain - other.plain < kTied;
      if (id != next.candidate.cause && ties && std::ranges::find(next.alternatives, id) == next.alternatives.end())
        next.alternatives.push_back(id);
    }
    named.push_back(std::move(next));
    fit = *trials.front().fit;
  }
  if (progress.cancelled()) return Error{"Stopped.", true};
  PoseFit first = null;
  const std::vector<bool> bad = badPoses(poses, fit);
  const auto badCount = std::ranges::count(bad, true);
  const double judged = 6.0 * static_cast<double>(poses.count() - badCount) - static_cast<double>(fit.state.size());
  const double wider = student(judged);

  out.baseline = rmsOf(first.residual, bad);
  out.noise = rmsOf(fit.residual, bad);
  if (out.mistake) {
    WrenchRms was = rmsOf(before->residual, std::vector<bool>(bad.size(), false));
    out.causes.push_back(fromMistake(*out.mistake, was, out.baseline));
    out.causes.back().deltaBic = out.mistake->evidence;
    out.baseline = was;
  }
  for (const NamedSuspect& one : named) {
    const auto known = std::ranges::find(out.causes, one.candidate.cause, &DiagnosedCause::id);
    if (known != out.causes.end() && !known->direct) {
      known->deltaBic += one.gain;
      continue;
    }
    DiagnosedCause cause;
    cause.id = one.candidate.cause;
    cause.deltaBic = one.gain;
    cause.pValue = std::exp(-0.5 * one.gain);
    cause.alternatives = one.alternatives;
    setParameters(cause, fit, wider);
    out.causes.push_back(std::move(cause));
  }
  if (badCount > 0) {
    DiagnosedCause touched;
    touched.id = "contact";
    touched.direct = true;
    double peak = 0.0;
    for (Eigen::Index k = 0; k < poses.count(); ++k) {
      if (!bad[static_cast<std::size_t>(k)]) continue;
      touched.parameters.push_back({fmt::format("pose{}", k + 1), "", static_cast<double>(k + 1), 0.0});
      touched.when.emplace_back(recording.time(k), recording.time(k));
      peak = std::max(peak, fit.residual.col(k).head<3>().norm());
    }
    touched.parameters.push_back({"peak_force", "N", peak, fit.force});
    out.causes.push_back(std::move(touched));
  }

  out.verdict = out.causes.empty() ? Verdict::clean : Verdict::explained;
  const bool tied =
      std::ranges::any_of(out.causes, [](const DiagnosedCause& c) { return !c.direct && !c.alternatives.empty(); });
  if (tied || (out.mistake && out.mistake->tied)) out.verdict = Verdict::ambiguous;
  if (told.verdict == conventions::Verdict::none && named.empty()) {
    out.remaining.goesWith = heft::toSay("how the tool is turned");
    out.remaining.gain = 2.0 * told.overStated;
    out.verdict = Verdict::unexplained;
  }

  progress(0.8, heft::say("Estimating the payload again"));
  auto was = estimate(recording, robot, options.estimate, Progress{progress.stop, {}});
  if (!was) return was.error();
  out.before = std::move(*was);
  out.after = out.before;
  if (!out.causes.empty()) {
    PoseState without = fit.state;
    without.terms.clear();
    Recording clean = stated;
    clean.wrench -= (expectedOf(poses, fit.state) - expectedOf(poses, without)).transpose();
    if (auto is = estimate(goodRows(clean, bad), robot, options.estimate, Progress{progress.stop, {}}))
      out.after = std::move(*is);
    widenBy(out.after, fit, wider);
    if (fit.untold(6) > kUntold) {
      // As much of the pull may go straight up as shows.
      const Wrenches pull = expectedOf(poses, fit.state) - expectedOf(poses, without);
      const double size = std::sqrt(pull.topRows<3>().squaredNorm() / static_cast<double>(poses.count()));
      widenMass(out.after, size / std::max(1e-9, stated.meta.gravity.norm()));
      out.findings.push_back(
          {Severity::warning,
           "mass_not_told",
           heft::say("Something pulls at the tool. How much of that goes straight up or down is unknown, and so is the "
                     "mass, to {:.2g} kg.",
                     1.96 * out.after.std.mass),
           heft::say("Take the pull away and record the poses again."),
           {}});
    }
  }
  out.model = fit.state.modelled();
  out.threshold = kNeeded;
  out.series.time = VectorXd::LinSpaced(poses.count(), 1.0, static_cast<double>(poses.count()));
  out.series.measured = poses.signals.measured;
  out.series.before = poses.signals.measured - first.residual;
  out.series.after = poses.signals.measured - fit.residual;
  for (const bool one : bad) out.series.judged.push_back(!one);
  for (const Suspect& candidate : candidates) {
    if (std::ranges::find(out.causes, candidate.cause, &DiagnosedCause::id) != out.causes.end() || !candidate.form ||
        std::ranges::find(out.smallest, candidate.cause, &Smallest::cause) != out.smallest.end())
      continue;
    PoseState with = fit.state;
    with.add(candidate);
    const MatrixXd C = scalesOf(fit).asDiagonal() * jacobianOf(poses, with).rightCols(candidate.size());
    const MatrixXd Q = orthonormal(fit.jacobian);
    const double seen = (C.col(0) - Q * (Q.transpose() * C.col(0))).norm();
    const Parameter& parameter = candidate.form->parameters.front();
    const double needed = kNeeded + candidate.price + static_cast<double>(candidate.size()) * std::log(judged);
    out.smallest.push_back({candidate.cause, parameter.name, parameter.unit,
                            seen > 1e-9 * C.col(0).norm() ? std::abs(parameter.scale) * std::sqrt(needed) / seen
                                                          : std::numeric_limits<double>::infinity()});
  }
  // A turned sensor is among the causes.
  std::ranges::copy_if(told.cautions, std::inserter(out.findings, out.findings.begin()),
                       [](const Finding& caution) { return caution.code != "sensor_turned"; });
  if (out.mistake && !out.mistake->decides.empty())
    out.findings.push_back(
        {Severity::info, "conventions_tied", heft::say("Other conventions fit as well."), out.mistake->decides, {}});
  out.findings.push_back(
      {Severity::info,
       "poses_cannot_tell",
       heft::say(
           "Standing poses cannot tell: inertia, delays, friction, a gain that all channels share, a pull straight "
           "up or down, or the zero of the first joint."),
       heft::say("Record a motion with brisk turns for these."),
       {}});
  putIntoWords(out);
  out.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  progress(1.0, "Done");
  return out;
}

}  // namespace heft::diagnosis
