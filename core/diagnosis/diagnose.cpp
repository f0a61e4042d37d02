#include "core/diagnosis/diagnose.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>

#include "core/base/say.h"
#include "core/base/stop.h"
#include "core/diagnosis/artefacts/own_errors.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/causes/catalogue.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/correction/re_estimate.h"
#include "core/diagnosis/long_recording.h"
#include "core/diagnosis/poses.h"
#include "core/diagnosis/readings.h"
#include "core/diagnosis/verdict/confirmation.h"
#include "core/diagnosis/verdict/description.h"
#include "core/diagnosis/verdict/faint_touches.h"
#include "core/diagnosis/verdict/unknown.h"
#include "core/diagnosis/verdict/verdict.h"

namespace heft {

using namespace diagnosis;

namespace {

/// Whether single readings that are wrong may be all that there is in stretches that were set aside: coarse steps are
/// not where far more than a step is left.
bool mayBeAllThatIsOdd(const Direct& direct, const Hypothesis& hypothesis) {
  if (direct.cause != ids::quantisation) return true;
  const auto stepOf = [&](std::string_view name) {
    const auto step = std::ranges::find_if(direct.parameters, [&](const auto& p) { return p.name == name; });
    return step == direct.parameters.end() ? 0.0 : step->value;
  };
  const double force = kStandsOut * stepOf("step_force"), torque = kStandsOut * stepOf("step_torque");
  return std::ranges::all_of(blocksOf(hypothesis.unexplained), [&](const Stretch& s) {
    const auto left = hypothesis.search.final.residual.middleCols(s.from, s.to - s.from);
    return left.topRows<3>().cwiseAbs().maxCoeff() < force || left.bottomRows<3>().cwiseAbs().maxCoeff() < torque;
  });
}

/// Whether no more is `left` than steps leave of themselves, so that nothing can be said of it.
bool isWithinSteps(const WrenchRms& left, const Vector6d& steps) {
  const double force = steps.head<3>().maxCoeff(), torque = steps.tail<3>().maxCoeff();
  return left.force < force / std::sqrt(12.0) && left.torque < torque / std::sqrt(12.0);
}

/// Whether hardly any reading is a spike: what knocks makes a few.
bool hardlySpikes(const DiagnosedCause& cause) {
  constexpr double kFew = 0.05;  // [%]
  const CauseParameter* share = cause.id == ids::spikes ? findParameter(cause.parameters, "share") : nullptr;
  return share != nullptr && share->value < kFew;
}

/// Strongest first. What was tested on samples has no evidence to compare and stays in front, but for readings in
/// coarse steps and a few that are spikes: these add a little noise and no more. Contact belongs to the task more often
/// than to the rig: it comes last.
void sortByStrength(std::vector<DiagnosedCause>& causes) {
  const auto rank = [](const DiagnosedCause& c) {
    return c.id == ids::contact                           ? -1e300
           : c.id == ids::quantisation || hardlySpikes(c) ? 0.0
           : c.direct && c.deltaBic == 0.0                ? 1e300
                                                          : c.deltaBic;
  };
  std::ranges::stable_sort(causes, [&](const DiagnosedCause& a, const DiagnosedCause& b) { return rank(a) > rank(b); });
}

/// How large each cause that was not named would have to be, with this motion and noise.
std::vector<Smallest> smallestVisible(Hypothesis& hypothesis, const std::vector<DiagnosedCause>& named,
                                      double threshold) {
  constexpr double kClearlyLess = 1.0 - 1e-6;  // By more than rounding: two forms may have one parameter
  std::vector<Smallest> out;
  const auto bank = hypothesis.bank.around(hypothesis.signals, hypothesis.search.final.model);
  const auto visible = leastVisible(hypothesis.signals, hypothesis.stretches, hypothesis.search.final, bank, threshold);
  for (std::size_t b = 0; b < bank.size(); ++b) {
    const Signature& signature = bank[b];
    const std::string id(signature.form.cause->id());
    if (id == kRandomWalk || std::ranges::any_of(named, [&](const auto& c) { return c.id == id; })) continue;
    const VectorXd& size = visible[b];
    for (Eigen::Index i = 0; i < size.size(); ++i) {
      const Parameter& p =
          signature.form.parameters[static_cast<std::size_t>(signature.form.scan[static_cast<std::size_t>(i)])];
      if (!p.saysHowMuch) continue;
      // What passes for our own alignment of two clocks is not seen at all.
      VectorXd parameters = signature.form.start;
      parameters(signature.form.scan[static_cast<std::size_t>(i)]) = size(i);
      if (signature.form.cause->mayBeAlignment(signature.form, parameters, hypothesis.signals)) continue;
      const double value = size(i) * std::abs(p.scale);
      const auto known = std::ranges::find_if(out, [&](const Smallest& s) { return s.cause == id; });
      if (known == out.end())
        out.push_back({id, p.name, p.unit, value});
      else if (value < kClearlyLess * known->value && p.unit == known->unit)
        *known = {id, p.name, p.unit, value};
    }
  }
  return out;
}

/// The same of causes that were looked for in a part of the recording alone.
void addSmallest(Searched& part, DiagnosisReport& out) {
  for (Smallest& one : smallestVisible(part.hypothesis, out.causes, std::max(kNamed, out.threshold)))
    if (std::ranges::find(out.smallest, one.cause, &Smallest::cause) == out.smallest.end())
      out.smallest.push_back(std::move(one));
}

/// What holds of what was found. Of a long recording, what is left is told by the part if that leaves more; where only
/// the whole leaves something unknown, another part is searched.
Result<Confirmed> confirmedAtAnyLength(const Recording& recording, const Readings& readings, const RobotModel* robot,
                                       const DiagnoseOptions& options, const Progress& progress,
                                       SearchedInParts& searches) {
  const auto judge = [&](Searched& found) {
    return confirmed(found.hypothesis, found.chance, readings.steps, readings.have(ids::dropouts));
  };
  Confirmed out = judge(searches.whole);
  if (searches.parts.empty()) return out;
  Structure& inPart = searches.parts.front().remaining;
  inPart = judge(searches.parts.front().found).remaining;
  if (out.remaining.gain > kUnexplained && inPart.gain <= kUnexplained) {
    const Recording& stated = readings.asRead(recording);
    if (auto error = searchWorstPart(stated, readings, robot, options, progress, searches)) return *error;
    out = judge(searches.whole);
  }
  if (searches.parts.front().remaining.gain > out.remaining.gain) out.remaining = searches.parts.front().remaining;
  return out;
}

/// Of a long recording, what is fast is asked of its part.
WhatRemains whatRemainsAtAnyLength(const Readings& readings, ByReadings by, const Structure& structure,
                                   const SearchedInParts& searches) {
  by.coarse = !searches.parts.empty();
  WhatRemains out = whatRemains(searches.whole.hypothesis, readings.cleaned, by, structure);
  if (!by.coarse) return out;
  const SearchedPart& part = searches.parts.front();
  ByReadings fine;
  fine.known = by.known;
  fine.withinSteps = by.withinSteps;
  WhatRemains there = whatRemains(part.found.hypothesis, part.cleaned, fine, part.remaining);
  for (Finding& finding : there.findings)
    if (std::ranges::find(out.findings, finding.code, &Finding::code) == out.findings.end())
      out.findings.push_back(std::move(finding));
  if (there.structure.gain <= out.structure.gain) return out;
  out.structure = there.structure;
  out.claimed = there.claimed;
  out.seen = there.seen;
  return out;
}

/// What single readings tell of what the final model leaves.
ByReadings byReadings(const Readings& readings, const Hypothesis& hypothesis, const WrenchRms& left) {
  ByReadings out;
  out.withinSteps = isWithinSteps(left, readings.steps);
  out.known = std::ranges::any_of(readings.directs, [&](const Direct& d) { return mayBeAllThatIsOdd(d, hypothesis); });
  out.deadBands = readings.deadBands;
  out.stuckBits = readings.stuckBits;
  out.frozen = readings.frozen;
  out.leaps = readings.leaps;
  return out;
}

/// Sets misfit and noise floor, which is without what goes with the motion.
void setMisfit(const Hypothesis& hypothesis, const Structure& structure, DiagnosisReport& out) {
  out.baseline = rmsOf(hypothesis.stretches, hypothesis.search.null.residual);
  out.noise = rmsOf(hypothesis.stretches, hypothesis.search.final.residual);
  const double quiet = std::sqrt(std::clamp(1.0 - (structure.gain > kUnexplained ? structure.share : 0.0), 0.05, 1.0));
  out.noise.force *= quiet;
  out.noise.torque *= quiet;
}

/// What was seen without fitting a cause: the mistake, the motion's noise, ringing, a load carried for a while, tests
/// of single readings.
void addSeen(const Readings& readings, const Searched& found, const std::vector<DiagnosedCause>& fitted,
             DiagnosisReport& out) {
  const Hypothesis& hypothesis = found.hypothesis;
  out.mistake = readings.mistake;
  if (out.mistake) {
    WrenchRms was = out.baseline;
    was.force = out.mistake->forceBefore.value_or(was.force);
    out.causes.push_back(fromMistake(*out.mistake, was, out.baseline));
    out.baseline.force = std::max(out.baseline.force, was.force);
  }
  // Coarse angles or poses say why their accelerations are noisy.
  const bool coarse = std::ranges::any_of(
      readings.directs, [](const Direct& d) { return d.cause == ids::derivativeNoise && !d.ofVelocities; });
  if (found.noisy && !coarse)
    out.causes.push_back(fromNoisyMotion(*found.noisy));
  else if (!coarse)
    saySmoothing(found.cutoffHz, hypothesis.signals.smoothedAway, out);
  const auto isFitted = [&](std::string_view id) {
    return std::ranges::find(fitted, id, &DiagnosedCause::id) != fitted.end();
  };
  if (hypothesis.ringing && !isFitted(ids::flexibleMount)) out.causes.push_back(fromRinging(*hypothesis.ringing));
  if (hypothesis.carriedLoad) out.causes.push_back(fromCarriedLoad(*hypothesis.carriedLoad));
  for (const auto& direct : readings.directs)
    if (!isFitted(direct.cause)) out.causes.push_back(fromDirect(direct));
}

/// Adds the contacts, or says that they are too faint for a name. What remains then, if that counts.
std::optional<Structure> addContacts(const Hypothesis& hypothesis, const std::vector<DiagnosedCause>& fitted,
                                     const Structure& remaining, DiagnosisReport& out) {
  if (hypothesis.contacts.empty()) return std::nullopt;
  FaintTouches faint = faintTouches(hypothesis, fitted, remaining);
  if (faint.areFaint) {
    out.findings.push_back(std::move(faint.finding));
    return faint.remaining;
  }
  const Fit& final = hypothesis.search.final;
  const bool named = contains(final.model, hypothesis.contactAlternative);
  out.causes.push_back(fromContacts(hypothesis.contacts, final.residual,
                                    named ? std::string() : hypothesis.contactAlternative, out.noise.force));
  return std::nullopt;
}

void setSeries(const Hypothesis& hypothesis, const Confirmed& fitted, DiagnosisSeries& out) {
  const Signals& signals = hypothesis.signals;
  out.time.resize(signals.blocks());
  for (Eigen::Index n = 0; n < signals.blocks(); ++n) out.time(n) = signals.blockTime(n);
  out.measured = signals.measured;
  out.before = signals.measured - fitted.first;
  out.after = signals.measured - fitted.last;
  out.judged = signals.usable;
}

Result<DiagnosisReport> diagnosed(const Recording& recording, const RobotModel* robot, const DiagnoseOptions& options,
                                  const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  if (recording.meta.kind == RecordingKind::poses) return diagnosePoses(recording, robot, options, progress);
  DiagnosisReport out;
  out.file = recording.file;
  out.meta = recording.meta;
  out.ofPoses = recording.hasOrientation();
  auto readings = readingsOf(recording, robot, options, progress);
  if (!readings) return readings.error();
  auto searches = searchedAtAnyLength(readings->asRead(recording), *readings, robot, options, progress);
  if (!searches) return searches.error();
  const Progress quiet{progress.stop, {}};
  if (readings->mistake) {
    progress(0.8, heft::say("Comparing with the conventions as stated"));
    unlessCausesExplainMore(recording, robot, options, quiet, *readings, *searches);
  }
  progress(0.85, heft::say("Measuring the improvement on held-out segments"));
  auto judged = confirmedAtAnyLength(recording, *readings, robot, options, quiet, *searches);
  if (!judged) return judged.error();
  Confirmed& fitted = *judged;
  Searched& found = searches->whole;
  Hypothesis& hypothesis = found.hypothesis;
  out.threshold = found.threshold;
  out.surrogates = static_cast<int>(found.chance.best.size());

  const ByReadings by =
      byReadings(*readings, hypothesis, rmsOf(hypothesis.stretches, hypothesis.search.final.residual));
  const Structure structure = by.withinSteps ? Structure{} : fitted.remaining;
  setMisfit(hypothesis, structure, out);
  WhatRemains remains = whatRemainsAtAnyLength(*readings, by, structure, *searches);
  out.findings = std::move(remains.findings);
  sayOwnErrors(fitted.own, out);
  sayAlignment(fitted.aligned, hypothesis.signals.clockAlignmentStd.value_or(0.0), out);
  addSeen(*readings, found, fitted.causes, out);
  const std::optional<Structure> faint = addContacts(hypothesis, fitted.causes, remains.structure, out);
  std::ranges::move(fitted.causes, std::back_inserter(out.causes));
  sortByStrength(out.causes);
  out.findings.insert(out.findings.begin(), readings->motion.findings.begin(), readings->motion.findings.end());
  giveVerdict(hypothesis, faint.value_or(remains.structure), out);
  if (out.verdict == Verdict::unexplained && (faint || !remains.seen)) dropBesideUnknown(out);

  progress(0.9, heft::say("Computing detection limits"));
  out.model = hypothesis.search.final.model;
  out.smallest = smallestVisible(hypothesis, out.causes, std::max(kNamed, out.threshold));
  if (!searches->parts.empty()) addSmallest(searches->parts.front().found, out);
  std::ranges::move(findingsOf(*searches), std::back_inserter(out.findings));
  setSeries(hypothesis, fitted, out.series);
  // Of minutes, each of these is as large as all that an estimate needs.
  searches->parts.clear();
  hypothesis.bank = {};
  Recording cleaned = std::move(readings->cleaned);
  readings = Readings{};
  progress(0.93, heft::say("Estimating the payload again"));
  if (auto error = estimateAgain(out, recording, std::move(cleaned), robot, hypothesis, options.estimate, quiet))
    return *error;
  putIntoWords(out);
  out.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  progress(1.0, heft::say("Done"));
  return out;
}

}  // namespace

Result<DiagnosisReport> diagnose(const Recording& recording, const RobotModel* robot, const DiagnoseOptions& options,
                                 const Progress& progress) {
  // Searches begin anew, and so would the bar.
  double most = 0.0;
  const Progress onward{progress.stop, [&](double fraction, std::string_view what) {
                          most = std::max(most, fraction);
                          progress(most, what);
                          stopPoint();
                        }};
  return stoppable(progress.stop, [&] { return diagnosed(recording, robot, options, onward); });
}

}  // namespace heft
