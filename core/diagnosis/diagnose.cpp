#include "core/diagnosis/diagnose.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

#include "core/base/say.h"
#include "core/diagnosis/corrected.h"
#include "core/diagnosis/surrogates.h"
#include "core/diagnosis/time_stamps.h"
#include "core/diagnosis/two_threads.h"
#include "core/diagnosis/wandering.h"
#include "core/diagnosis/words.h"
#include "core/diagnosis/work.h"
#include "core/estimation/prepare.h"

namespace heft {

using namespace diagnosis;

namespace {

constexpr double kUnexplained = 12.0;
constexpr double kGainBesideUnknown = 0.03;  ///< Share of the unseen misfit

WrenchRms rmsOf(const std::vector<Stretch>& stretches, const Wrenches& residual) {
  WrenchRms out;
  double count = 0.0;
  for (const auto& s : stretches)
    for (Eigen::Index n = s.from; n < s.to; ++n) {
      out.force += residual.col(n).head<3>().squaredNorm();
      out.torque += residual.col(n).tail<3>().squaredNorm();
      count += 3.0;
    }
  out.force = std::sqrt(out.force / std::max(1.0, count));
  out.torque = std::sqrt(out.torque / std::max(1.0, count));
  return out;
}

std::vector<CauseParameter> parametersOf(const Fit& fit, std::string_view cause,
                                         std::vector<std::pair<double, double>>& when, const Signals& signals) {
  std::vector<CauseParameter> out;
  const VectorXd std = fit.std();
  Eigen::Index at = kLinear;
  for (const auto& term : fit.model.terms) {
    const Eigen::Index n = term.v.size();
    if (term.form->cause->id() == cause) {
      VectorXd deviation = std.segment(at, n);
      for (Eigen::Index p = 0; p < n; ++p) {
        if (!term.moves(p)) {
          deviation(p) = 0.0;
          continue;
        }
        const Parameter& parameter = term.form->parameters[static_cast<std::size_t>(p)];
        std::string name = parameter.name;
        for (int i = 2; std::any_of(out.begin(), out.end(), [&](const auto& o) { return o.name == name; }); ++i)
          name = fmt::format("{}_{}", parameter.name, i);
        out.push_back({name, parameter.unit, term.v(p) * parameter.scale, deviation(p) * std::abs(parameter.scale)});
      }
      for (const auto& stretch : term.form->cause->when(*term.form, term.v, signals)) when.push_back(stretch);
    }
    at += n;
  }
  return out;
}

DiagnosedCause fromDirect(const Direct& direct) {
  DiagnosedCause out;
  out.id = direct.cause;
  for (const auto& p : direct.parameters) out.parameters.push_back({p.name, p.unit, p.value, p.std});
  out.when = direct.when;
  out.direct = true;
  out.pValue = direct.pValue;
  out.alternatives = direct.alternatives;
  return out;
}

DiagnosedCause fromMistake(const FrameMistake& mistake, const WrenchRms& before, const WrenchRms& after) {
  DiagnosedCause out;
  const double degrees = mistake.angle * 180.0 / 3.14159265358979323846;
  // A half turn is a mix-up of frames; anything else is how somebody bolted the sensor on.
  const bool mount = mistake.kind == FrameMistake::Kind::turned && std::abs(degrees - 180.0) > 4.0;
  out.id = mount ? "sensor_rotation" : "frame_error";
  out.direct = true;
  if (mistake.kind == FrameMistake::Kind::turned) {
    const Vector3d v = vectorFromRotation(mistake.turn) * (180.0 / 3.14159265358979323846);
    out.parameters = {{"rx", "deg", v.x(), 0.5}, {"ry", "deg", v.y(), 0.5}, {"rz", "deg", v.z(), 0.5}};
    out.alternatives = {mount ? "frame_error" : "sensor_rotation"};
  }
  out.gain.forceBefore = before.force;
  out.gain.forceAfter = after.force;
  out.gain.torqueBefore = before.torque;
  out.gain.torqueAfter = after.torque;
  out.gain.explainedFraction = 1.0 - std::pow(after.force / std::max(1e-12, before.force), 2);
  return out;
}

/// Deviations of mass and centre may not be smaller than the joint fit of payload and causes finds them.
void widen(EstimateReport& report, const Fit& fit) {
  const VectorXd std = fit.std();
  const double m = std::max(0.02, std::abs(fit.model.x(6)));
  const auto grow = [](double& deviation, Interval& interval, double least) {
    if (!(deviation < least) || !(deviation > 0.0)) return;
    const double factor = least / deviation, middle = 0.5 * (interval.lower + interval.upper);
    interval = {middle + factor * (interval.lower - middle), middle + factor * (interval.upper - middle)};
    deviation = least;
  };
  grow(report.std.mass, report.interval95.mass, std(6));
  for (int i = 0; i < 3; ++i) {
    const double c = fit.model.x(7 + i) / m;
    const double variance = fit.covariance(7 + i, 7 + i) - 2.0 * c * fit.covariance(6, 7 + i) + c * c * fit.covariance(6, 6);
    grow(report.std.com(i), report.interval95.com[static_cast<std::size_t>(i)], std::sqrt(std::max(0.0, variance)) / m);
  }
}

/// Unseen stretches come out no worse in force and torque, and better in one.
bool predictsBetter(const EstimateReport& is, const EstimateReport& was) {
  return is.heldoutForceRms < 1.02 * was.heldoutForceRms && is.heldoutTorqueRms < 1.02 * was.heldoutTorqueRms &&
         (is.heldoutForceRms < 0.95 * was.heldoutForceRms || is.heldoutTorqueRms < 0.95 * was.heldoutTorqueRms);
}

/// The recording as the sensor and the robot would have told it without the causes.
Result<Recording> freed(const Recording& cleaned, const RobotModel* robot, const Work& work) {
  Recording out = cleaned;
  if (work.mistake) out = undone(std::move(out), *work.mistake);
  if (!work.search.final.model.terms.empty()) {
    auto effect = effectOf(work.search.final.model, out, robot);
    if (!effect) return effect.error();
    out.wrench -= *effect;
  }
  return out;
}

std::string verdictSentence(const DiagnosisReport& report) {
  switch (report.verdict) {
    case Verdict::clean:
      return "The model fits: nothing is left but the sensor's noise.";
    case Verdict::ambiguous: {
      const auto tied = std::find_if(report.causes.begin(), report.causes.end(),
                                     [](const DiagnosedCause& c) { return !c.alternatives.empty(); });
      std::string others;
      for (const auto& other : tied->alternatives)
        others += (others.empty() ? "\"" : ", \"") + causeTitle(other) + "\"";
      return fmt::format("Two causes are possible: \"{}\" or {}. This motion cannot tell them apart.", tied->title, others);
    }
    case Verdict::unexplained:
      return fmt::format("Something unknown is left that goes with {}.", report.remaining.goesWith);
    case Verdict::explained:
      break;
  }
  return report.causes.size() == 1 ? "Cause found: " + report.causes.front().sentence
                                   : fmt::format("{} causes found; the strongest: {}", report.causes.size(),
                                                 report.causes.front().sentence);
}

}  // namespace

std::string_view toString(Verdict verdict) {
  switch (verdict) {
    case Verdict::clean:
      return "clean";
    case Verdict::explained:
      return "explained";
    case Verdict::ambiguous:
      return "ambiguous";
    case Verdict::unexplained:
      return "unexplained";
  }
  return "";
}

Result<DiagnosisReport> diagnose(const Recording& recording, const RobotModel* robot, const DiagnoseOptions& options,
                                 const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  if (recording.meta.kind == RecordingKind::poses)
    return Error{heft::say("Standing poses show too little to look for causes; record a motion.")};
  DiagnosisReport out;
  out.file = recording.file;
  out.meta = recording.meta;
  progress(0.02, heft::say("Looking at single readings"));
  Eigen::Index spikes = 0;
  Recording cleaned = recording;
  cleaned.wrench = withoutSpikes(recording.wrench, spikes);
  const bool evened = std::ranges::find(options.hidden, "jitter") == options.hidden.end();
  if (auto stamps = evened ? unevenStamps(recording) : std::nullopt) cleaned.time = std::move(stamps->even);
  MotionOptions smoothing;
  smoothing.cutoffHz = kDefaultCutoffHz;
  const auto motion = motionOf(cleaned, robot, smoothing);
  if (!motion) return motion.error();
  auto directs = sampleTests(recording, *motion);
  std::erase_if(directs, [&](const Direct& d) {
    return std::find(options.hidden.begin(), options.hidden.end(), d.cause) != options.hidden.end();
  });
  // Velocities that disagree with the angles are not used, here or for the payload.
  if (std::any_of(directs.begin(), directs.end(),
                  [](const Direct& d) { return d.cause == "motion_lag" || d.cause == "derivative_noise"; }))
    cleaned.dq.resize(0, cleaned.dq.cols());
  std::vector<bool> bad;
  for (const auto& direct : directs)
    for (std::size_t i = 0; i < direct.rows.size(); ++i) {
      bad.resize(direct.rows.size(), false);
      bad[i] = bad[i] || direct.rows[i];
    }

  // Accelerations from coarse or late angles are noise above some frequency. Bias and payload alone tell where, unless a
  // cause hides it: then the final model does.
  constexpr std::array<double, 3> kCutoffs{kDefaultCutoffHz, 12.0, 6.0};
  std::vector<Way> ways;
  for (const double cutoff : kCutoffs) {
    auto way = wayOf(recording, cleaned, robot, cutoff, options, bad);
    if (!way) return way.error();
    ways.push_back(std::move(*way));
  }
  const auto best = [](const std::vector<double>& gains, double margin) {
    std::size_t at = 0;
    for (std::size_t i = 1; i < gains.size(); ++i)
      if (gains[i] > gains[at] + (at == 0 ? margin : 10.0)) at = i;
    return at;
  };
  lookForContact(ways.front(), cleaned, options);
  std::size_t way = best(nullEvidence(ways), 30.0);
  const auto searched = [&](std::size_t i, double threshold) {
    lookForContact(ways[i], cleaned, options);
    return worked(ways[i], options, threshold, progress);
  };
  auto found = searched(way, kThreshold);
  if (!found) return found.error();
  if (!progress.cancelled()) {
    std::vector<double> gains(ways.size(), 0.0);
    onTwoThreads(ways.size(), [&](std::size_t i) {
      if (i != way) gains[i] = evidenceAt(ways[i], *found);
    });
    const auto other = static_cast<std::size_t>(std::max_element(gains.begin(), gains.end()) - gains.begin());
    if (gains[other] > 30.0) {
      auto again = searched(other, kThreshold);
      if (again) {
        found = std::move(again);
        way = other;
      }
    }
  }
  if (progress.cancelled()) return Error{"Stopped.", true};

  out.threshold = kThreshold;
  Surrogates chance;
  if (options.surrogates > 0 && !found->search.found.empty()) {
    const auto bank = signaturesOf(found->signals, found->search.null.model, options.hidden);
    // Noise as the final model leaves it, around the motion and payload of the baseline.
    Fit base = found->search.null;
    base.noise = found->search.final.noise;
    chance = surrogates(found->stretches, base, bank, options.surrogates, options.seed, progress);
    out.threshold = chance.threshold;
    out.surrogates = static_cast<int>(chance.best.size());
    const bool weak = std::any_of(found->search.found.begin(), found->search.found.end(),
                                  [&](const Found& f) { return f.gain < out.threshold; });
    if (weak) {
      auto again = searched(way, out.threshold);
      if (again) found = std::move(again);
    }
  }
  if (progress.cancelled()) return Error{"Stopped.", true};
  Work& work = *found;

  progress(0.85, heft::say("Measuring the gain on unseen stretches"));
  // Where something unknown remains, a small gain may be that in disguise: then more is asked of a cause.
  out.remaining = structureIn(work.signals, work.stretches, work.search.final);
  const double needed = out.remaining.gain > kUnexplained ? kGainBesideUnknown : 0.0;
  bool dropped = false;
  // Nested models, in the order of acceptance.
  Wrenches before = heldOutResidual(work.signals, work.stretches, work.search.null);
  out.series.before = work.signals.measured - before;
  out.baseline = rmsOf(work.stretches, work.search.null.residual);
  std::vector<DiagnosedCause> fitted;
  Model nested;
  nested.x = work.search.null.model.x;
  for (const auto& accepted : work.search.found) {
    const bool nuisance = accepted.cause == kWandering || (work.mistake && work.mistake->kind == FrameMistake::Kind::turned &&
                                                           accepted.cause == "sensor_rotation");
    for (const auto& term : work.search.final.model.terms)
      if (term.form->cause->id() == accepted.cause) nested.terms.push_back(term);
    Fit fit = nested.terms.size() == work.search.final.model.terms.size() ? work.search.final
                                                                          : fitModel(work.signals, work.stretches, nested);
    const Wrenches after = heldOutResidual(work.signals, work.stretches, fit);
    if (nuisance) {
      // Part of the model, but no cause that somebody could mend.
      before = after;
      continue;
    }
    const Gain gain = gainOf(work.stretches, fit.noise, before, after);
    const bool local = std::any_of(nested.terms.begin(), nested.terms.end(), [&](const Term& t) {
      return t.form->cause->id() == accepted.cause && t.form->local;
    });
    if (!local && !(gain.explainedFraction > needed && 2 * gain.blocksBetter >= gain.blocks)) {
      // Nothing is gained where it was not fitted: it is no cause.
      nested = without(nested, accepted.cause);
      work.search.final.model = without(work.search.final.model, accepted.cause);
      work.search.final = fitModel(work.signals, work.stretches, work.search.final.model);
      dropped = true;
      continue;
    }
    DiagnosedCause cause;
    cause.id = accepted.cause;
    cause.deltaBic = accepted.gain;
    cause.pValue = chance.best.empty() ? std::exp(-0.5 * accepted.gain) : chance.pValue(accepted.gain);
    cause.gain = gain;
    for (const auto& rival : accepted.rivals) {
      // To whoever mends the rig a wandering zero is one that drifts.
      const std::string other = rival.cause == kWandering ? "bias_drift" : rival.cause;
      if (other != cause.id && std::ranges::find(cause.alternatives, other) == cause.alternatives.end())
        cause.alternatives.push_back(other);
    }
    // A jump is a drift that took no time.
    if (cause.id == "sensor_bias" && std::ranges::find(cause.alternatives, "bias_drift") == cause.alternatives.end())
      cause.alternatives.push_back("bias_drift");
    cause.before = before;
    cause.after = after;
    fitted.push_back(std::move(cause));
    before = after;
  }
  const Fit& final = work.search.final;
  Wrenches steady = final.residual;
  if (Model still = without(final.model, kWandering); still.terms.size() < final.model.terms.size()) {
    steady = fitModel(work.signals, work.stretches, std::move(still)).residual;
    out.findings.push_back({Severity::info, "zero_wanders",
                              heft::say("The sensor's zero wanders slowly during the recording; this is allowed for."),
                              heft::say("Let the sensor warm up, and keep recordings short."), {}});
  }
  for (auto& cause : fitted) cause.parameters = parametersOf(final, cause.id, cause.when, work.signals);

  if (dropped) out.remaining = structureIn(work.signals, work.stretches, final);
  if (const double excess = slowWave(work.signals, work.stretches, steady);
      excess > 1.0 && out.remaining.gain < 2.0 * kUnexplained) {
    out.remaining.goesWith = heft::toSay("a slow wave in time");
    out.remaining.gain = 2.0 * kUnexplained * excess;
  }
  out.noise = rmsOf(work.stretches, final.residual);
  const double quiet = std::sqrt(std::clamp(1.0 - (out.remaining.gain > kUnexplained ? out.remaining.share : 0.0), 0.05, 1.0));
  out.noise.force *= quiet;
  out.noise.torque *= quiet;

  if (work.mistake) {
    const Fit stated = fitModel(work.signals, work.stretches, Model{});
    WrenchRms was = out.baseline;
    was.force = work.mistake->rmsBefore;
    DiagnosedCause cause = fromMistake(*work.mistake, was, rmsOf(work.stretches, stated.residual));
    out.baseline.force = std::max(out.baseline.force, was.force);
    out.causes.push_back(std::move(cause));
  }
  for (const auto& direct : directs) out.causes.push_back(fromDirect(direct));
  if (!work.contacts.empty()) {
    DiagnosedCause cause;
    cause.id = "contact";
    double peak = 0.0, evidence = 0.0;
    for (const auto& contact : work.contacts) {
      cause.when.push_back({contact.from, contact.to});
      peak = std::max(peak, contact.peakForce);
      evidence += contact.evidence;
    }
    cause.parameters = {{"peak_force", "N", peak, out.noise.force}};
    cause.deltaBic = evidence;
    cause.pValue = std::exp(-0.5 * std::min(1000.0, evidence));
    cause.direct = true;
    out.causes.push_back(std::move(cause));
  }
  for (auto& cause : fitted) out.causes.push_back(std::move(cause));
  // Strongest first: what was tested on samples has no evidence to compare and stays in front.
  std::stable_sort(out.causes.begin(), out.causes.end(), [](const DiagnosedCause& a, const DiagnosedCause& b) {
    // Contact belongs to the task more often than to the rig: it comes last.
    const auto rank = [](const DiagnosedCause& c) { return c.id == "contact" ? -1e300 : c.direct ? 1e300 : c.deltaBic; };
    return rank(a) > rank(b);
  });

  double total = 0.0;
  for (const auto& cause : out.causes) total += cause.id == "contact" ? 0.0 : cause.deltaBic;
  const bool left = out.remaining.gain > std::max(kUnexplained, 0.03 * total);
  const bool tied = std::any_of(out.causes.begin(), out.causes.end(),
                                [](const DiagnosedCause& c) { return !c.direct && !c.alternatives.empty(); });
  out.verdict = left ? Verdict::unexplained
                : out.causes.empty() ? Verdict::clean
                : tied ? Verdict::ambiguous
                       : Verdict::explained;

  progress(0.93, heft::say("Estimating the payload again"));
  auto was = estimate(recording, robot, options.estimate, Progress{progress.stop, {}});
  if (!was) return was.error();
  out.before = std::move(*was);
  out.after = out.before;
  if (!out.causes.empty()) {
    auto clean = freed(cleaned, robot, work);
    if (!clean) return clean.error();
    auto is = estimate(*clean, robot, options.estimate, Progress{progress.stop, {}});
    if (is) {
      out.after = std::move(*is);
      widen(out.after, final);
      // Causes that leave an impossible payload explain nothing: they are shown, the payload stays as it was.
      const auto sane = [](const EstimateReport& r) {
        return r.payload.mass > 3.0 * r.std.mass && r.payload.com.norm() < 0.4;
      };
      if (sane(out.before) && !sane(out.after)) {
        out.after = out.before;
        out.verdict = Verdict::unexplained;
        out.findings.push_back({Severity::warning, "causes_not_believable",
                                heft::say("With these causes taken out the payload would be impossible, so it is left as it was."),
                                heft::say("Repeat the recording without touching anything."), {}});
      } else if (out.verdict == Verdict::unexplained && !predictsBetter(out.after, out.before)) {
        out.after = out.before;
        out.findings.push_back({Severity::warning, "payload_left_as_it_was",
                                heft::say("Taking these causes out does not help to predict unseen stretches, so the payload is left as it was."),
                                heft::say("Find what is unknown first: record the motion once more, more slowly."), {}});
      }
    }
  }
  out.model = final.model;
  out.mistake = work.mistake;
  const auto bank = signaturesOf(work.signals, final.model, options.hidden);
  const auto visible = leastVisible(work.stretches, final, bank, out.threshold);
  for (std::size_t b = 0; b < bank.size(); ++b) {
    const Signature& signature = bank[b];
    const std::string id(signature.form.cause->id());
    if (id == kWandering) continue;
    const bool named = std::any_of(out.causes.begin(), out.causes.end(), [&](const auto& c) { return c.id == id; });
    if (named) continue;
    const VectorXd& size = visible[b];
    for (Eigen::Index i = 0; i < size.size(); ++i) {
      const Parameter& p = signature.form.parameters[static_cast<std::size_t>(signature.form.scan[static_cast<std::size_t>(i)])];
      const double value = size(i) * std::abs(p.scale);
      auto known = std::find_if(out.smallest.begin(), out.smallest.end(), [&](const Smallest& s) { return s.cause == id; });
      if (known == out.smallest.end())
        out.smallest.push_back({id, p.name, p.unit, value});
      else if (value < known->value && p.unit == known->unit)
        *known = {id, p.name, p.unit, value};
    }
  }
  out.series.time.resize(work.signals.blocks());
  for (Eigen::Index n = 0; n < work.signals.blocks(); ++n) out.series.time(n) = work.signals.blockTime(n);
  out.series.measured = work.signals.measured;
  out.series.after = work.signals.measured - before;
  out.series.judged = work.signals.usable;
  out.findings.insert(out.findings.begin(), motion->findings.begin(), motion->findings.end());
  for (auto& cause : out.causes) {
    cause.title = causeTitle(cause.id);
    cause.sentence = causeSentence(cause, out.mistake);
    cause.check = causeCheck(cause, out.mistake);
    cause.tellApart = causeDecides(cause.id);
  }
  out.sentence = verdictSentence(out);
  out.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  progress(1.0, "Done");
  return out;
}

}  // namespace heft
