#include "core/diagnosis/diagnose.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <utility>

#include "core/base/parallel.h"
#include "core/base/say.h"
#include "core/diagnosis/artefacts/made_by_motion.h"
#include "core/diagnosis/artefacts/noisy_motion.h"
#include "core/diagnosis/artefacts/own_errors.h"
#include "core/diagnosis/artefacts/sharp_motion.h"
#include "core/diagnosis/causes/catalogue.h"
#include "core/diagnosis/causes/common.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/change_detection/ringing.h"
#include "core/diagnosis/correction/corrected.h"
#include "core/diagnosis/correction/re_estimate.h"
#include "core/diagnosis/data_quality/dead_band.h"
#include "core/diagnosis/data_quality/held_rows.h"
#include "core/diagnosis/data_quality/reported_velocities.h"
#include "core/diagnosis/data_quality/sample_tests.h"
#include "core/diagnosis/data_quality/stuck_bit.h"
#include "core/diagnosis/data_quality/time_stamps.h"
#include "core/diagnosis/pipeline/hypothesis_search.h"
#include "core/diagnosis/pipeline/set_aside.h"
#include "core/diagnosis/poses.h"
#include "core/diagnosis/search/evidence.h"
#include "core/diagnosis/search/null_distribution.h"
#include "core/diagnosis/verdict/confirmation.h"
#include "core/diagnosis/verdict/description.h"
#include "core/diagnosis/verdict/unknown.h"
#include "core/diagnosis/verdict/verdict.h"
#include "core/diagnosis/wording/words.h"

namespace heft {

using namespace diagnosis;

namespace {

bool contains(const std::vector<std::string>& list, std::string_view id) {
  return std::ranges::find(list, id) != list.end();
}

/// What single readings say, and the recording without what they spoil.
struct Readings {
  std::optional<FrameMistake> mistake;  ///< Put right before anything else is made of the readings
  Recording stated;                     ///< The recording without it
  Recording cleaned;
  Motion motion;
  std::vector<Direct> directs;
  Vector6d steps = Vector6d::Zero();  ///< As of CoarseReadings
  std::vector<DeadBand> deadBands;
  std::vector<StuckBit> stuckBits;
  std::optional<FrozenChannel> frozen;
  std::vector<bool> bad;   ///< Rows that are not judged: one a row, or none
  Eigen::Index leaps = 0;  ///< Rows that leap and are neither spikes nor of a stuck bit
  bool cutsMost = false;   ///< Readings are cut off flat most of the time: those rows are judged, too
};

/// Marks the rows that dead bands leave nothing of as bad, unless hardly any others are left.
void setAside(const std::vector<DeadBand>& bands, std::vector<bool>& bad, Eigen::Index rows) {
  constexpr double kMostRows = 0.6;  // Share of them
  if (bands.empty()) return;
  std::vector<bool> all = bad;
  all.resize(static_cast<std::size_t>(rows), false);
  for (const DeadBand& band : bands)
    for (const auto& [from, to] : band.runs) std::fill(all.begin() + from, all.begin() + to, true);
  if (static_cast<double>(std::ranges::count(all, true)) < kMostRows * static_cast<double>(rows)) bad = std::move(all);
}

/// Undoes the mistake in the recordings, and learns what is told of it: how much it left over, and a mount's turn to a
/// fraction of a degree.
std::optional<Error> putRight(Readings& readings, const RobotModel* robot, const DiagnoseOptions& options) {
  FrameMistake& mistake = *readings.mistake;
  MotionOptions smoothing;
  smoothing.cutoffHz = kDefaultCutoffHz;
  smoothing.twicing = true;
  const Recording cleaned = readings.cleaned;
  const auto wayIn = [&](const Recording& recording) {
    return smoothingCandidateOf(recording, recording, robot, smoothing, options, {});
  };
  if (const auto stated = wayIn(cleaned)) {
    const auto stretches = stretchesOf(stated->signals.usable);
    if (!stretches.empty())
      mistake.forceBefore = rmsOf(stretches, fitModel(stated->signals, stretches, Model{}).residual).force;
  }
  const bool mirrored = mistake.has(conventions::Change::wrenchSign);  // Then it is exact, or beside the axes anyway
  if (mistake.has(conventions::Change::turned) && !mirrored) {
    const auto right = undone(cleaned, robot, mistake);
    if (!right) return right.error();
    if (auto candidate = wayIn(*right)) {
      lookForContact(*candidate, *right, options);
      refineTurn(mistake, candidate->signals, untouched(candidate->signals, *candidate));
    }
  }
  auto stated = undone(std::move(readings.stated), robot, mistake);
  if (!stated) return stated.error();
  auto right = undone(cleaned, robot, mistake);
  if (!right) return right.error();
  readings.stated = std::move(*stated);
  readings.cleaned = std::move(*right);
  return std::nullopt;
}

/// `asStated`: whatever the conventions are.
Result<Readings> readingsOf(const Recording& recording, const RobotModel* robot, const DiagnoseOptions& options,
                            bool asStated = false) {
  RowFacts facts = rowFactsOf(recording);
  if (const auto channel = stuckChannel(facts.coarse))
    return Error{
        heft::say("{} stays the same in nearly all rows: it was not measured, or a threshold in the sensor's driver "
                  "hides what is small. Mend that and record once more.",
                  channelName(*channel))};
  Readings out;
  out.cleaned = recording;
  out.cleaned.wrench = std::move(facts.restored);
  if (facts.stamps && !contains(options.hidden, ids::jitter)) out.cleaned.time = facts.stamps->even;
  refresh(out.cleaned, recording, facts.stale, facts.held);
  bridge(out.cleaned, facts.held, facts.motionHeld);
  MotionOptions smoothing;
  smoothing.cutoffHz = kDefaultCutoffHz;
  auto motion = motionOf(out.cleaned, robot, smoothing);
  if (!motion) return motion.error();
  out.stated = recording;
  if (!asStated)
    out.mistake = frameMistake(out.cleaned, *motion, conventions::check(conventions::questionOf(out.cleaned, *motion)));
  if (out.mistake) {
    if (auto error = putRight(out, robot, options)) return *error;
    motion = motionOf(out.cleaned, robot, smoothing);
    if (!motion) return motion.error();
  }
  out.motion = std::move(*motion);
  out.directs = sampleTests(out.stated, out.motion, facts);
  out.stuckBits = stuckBits(out.stated);
  if (out.stuckBits.empty() &&
      std::ranges::none_of(out.directs, [](const Direct& d) { return d.cause == ids::spikes; }))
    out.leaps = facts.spikes;
  if (facts.deadBands.empty()) out.frozen = frozenChannel(recording, facts.tops, facts.coarse.steps);
  std::erase_if(out.directs, [&](const Direct& d) {
    // Where a bit of a converter is stuck, readings leap again and again.
    return contains(options.hidden, d.cause) || (d.cause == ids::spikes && !out.stuckBits.empty());
  });
  for (const auto& direct : out.directs) {
    // Velocities that disagree with the angles or poses are not used, here or for the payload.
    if (direct.ofVelocities) dropReportedVelocities(out.cleaned);
    // Cut off flat for so long that nothing else would be left to judge: then those rows are better than none.
    constexpr double kLeast = 3.0;  // [s]
    const auto cut = std::ranges::count(direct.rows, true), judged = std::ssize(direct.rows) - cut;
    if (direct.cause == ids::saturation && judged < cut && static_cast<double>(judged) < kLeast * recording.rateHz()) {
      out.cutsMost = true;
      continue;
    }
    for (std::size_t i = 0; i < direct.rows.size(); ++i) {
      out.bad.resize(direct.rows.size(), false);
      out.bad[i] = out.bad[i] || direct.rows[i];
    }
  }
  out.steps = facts.coarse.steps;
  out.deadBands = std::move(facts.deadBands);
  setAside(out.deadBands, out.bad, recording.rows());
  return out;
}

/// Whether the motion was only recorded every now and then, and straight lines drawn in between.
bool hasLongLines(const Direct& direct) {
  constexpr double kLong = 80.0;  // [ms]
  return std::ranges::any_of(direct.parameters, [](const auto& p) { return p.name == "line" && p.value > kLong; });
}

bool wasHeld(const Readings& readings) {
  return std::ranges::any_of(readings.directs, [](const Direct& direct) { return direct.cause == ids::dropouts; });
}

/// A search, and the chance of finding something where nothing is.
struct Searched {
  Hypothesis hypothesis;
  double threshold = kThreshold;
  Surrogates chance;  ///< Empty where none were asked for, or nothing was found
  std::optional<NoisyMotion> noisy;
  double cutoffHz = 0.0;  ///< Of the smoothing of the motion
};

/// Accelerations from coarse or late angles are noise above some frequency. Bias and payload alone tell where, unless a
/// cause hides it: then the final model does.
Result<Searched> searched(const Recording& recording, const Readings& readings, const RobotModel* robot,
                          DiagnoseOptions options, const Progress& progress) {
  const auto named = [&](std::string_view id) {
    return std::ranges::find(readings.directs, id, &Direct::cause) != readings.directs.end();
  };
  // Readings that are cut off flat are dealt with.
  if (!readings.cutsMost && named(ids::saturation)) options.hidden.emplace_back(ids::saturation);
  // A motion of straight lines has no swings that are faster than these are long.
  if (std::ranges::any_of(readings.directs, hasLongLines))
    for (const std::string_view swings : {ids::looseMass, ids::flexibleMount}) options.hidden.emplace_back(swings);
  struct Smoothing {
    double place;  ///< Among those that smooth less and those that smooth more
    MotionOptions options;
  };
  // Twicing lets more noise through: not where noise asks for a low corner, and at 12 Hz either may be the better.
  // A hand that trembles fast shakes the tool faster than the usual corner, and an arm may report it.
  constexpr std::array<Smoothing, 8> kSmoothings{
      {{-1.0, {.cutoffHz = 55.0, .twicing = true}},
       {0.0, {.cutoffHz = kDefaultCutoffHz, .twicing = true}},
       {1.0, {.cutoffHz = 17.0, .twicing = true}},
       {1.5, {.cutoffHz = kDefaultCutoffHz, .twicing = true, .denoise = true}},
       {2.0, {.cutoffHz = 12.0, .twicing = true}},
       {3.0, {.cutoffHz = 12.0}},
       {4.0, {.cutoffHz = 8.5}},
       {5.0, {.cutoffHz = 6.0}}}};
  // Too noisy to judge anything on, but a knock at the arm is there as it was.
  constexpr MotionOptions kSharper{.cutoffHz = 110.0, .twicing = true};
  constexpr double kClearly = 30.0;  // Evidence for another way than this one
  std::array<std::optional<Result<SmoothingCandidate>>, kSmoothings.size() + 1> smoothed;
  parallelFor(smoothed.size(), [&](std::size_t i) {
    smoothed[i] =
        smoothingCandidateOf(recording, readings.cleaned, robot,
                             i < kSmoothings.size() ? kSmoothings[i].options : kSharper, options, readings.bad);
  });
  std::vector<SmoothingCandidate> candidates;
  for (auto& candidate : smoothed) {
    if (!*candidate) return candidate->error();
    candidates.push_back(std::move(**candidate));
    candidates.back().mountTurnReported = readings.mistake && readings.mistake->has(conventions::Change::turned);
  }
  const SmoothingCandidate sharper = std::move(candidates.back());
  candidates.pop_back();
  SmoothingCandidate& usual = candidates[kUsualSmoothing];
  lookForContact(usual, readings.cleaned, options);
  weighSharpMotion(candidates, sharper, wasHeld(readings));
  std::size_t at = kUsualSmoothing;
  // The way that leaves most of the motion among those that are next to best.
  const auto leastSmoothed = [&](const std::vector<double>& evidence) {
    constexpr double kSlightly = 10.0;
    const double best = *std::ranges::max_element(evidence);
    return static_cast<std::size_t>(std::ranges::find_if(evidence, [&](double e) { return e > best - kSlightly; }) -
                                    evidence.begin());
  };
  const std::vector<double> plain = nullEvidence(candidates);
  Searched out;
  if (*std::ranges::max_element(plain) > plain[at] + kClearly) {
    at = leastSmoothed(plain);
    if (at > kUsualSmoothing && !contains(options.hidden, ids::derivativeNoise))
      out.noisy = noisyMotion(readings.cleaned, usual, candidates[at], plain[at] - plain[kUsualSmoothing]);
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      candidates[i].signals.noisyMotion = out.noisy.has_value();
      if (i > kUsualSmoothing) candidates[i].signals.smoothedAway = std::max(0.0, plain[i] - plain[kUsualSmoothing]);
    }
    if (out.noisy && !out.noisy->plain) out.noisy.reset();
    if (out.noisy) options.hidden.emplace_back(ids::derivativeNoise);
  }
  const auto searchedOn = [&](std::size_t i, double threshold, const StopsEarly& stopsEarly = {}) {
    lookForContact(candidates[i], readings.cleaned, options);
    return hypothesisOn(candidates[i], options, threshold, progress, stopsEarly);
  };
  // Whether what was found speaks clearly for another way: then that one is next. Where neither neighbour is better,
  // none is.
  const auto betterBy = [&](const auto& evidenceOf) {
    std::vector<double> gains(candidates.size(), 0.0);
    const auto ask = [&](bool neighbours) {
      parallelFor(candidates.size(), [&](std::size_t i) {
        const bool beside = std::abs(kSmoothings[i].place - kSmoothings[at].place) <= 1.0;
        if (i != at && beside == neighbours) gains[i] = evidenceOf(candidates[i]);
      });
      return *std::ranges::max_element(gains) > kClearly;
    };
    if (!ask(true)) return false;
    ask(false);
    at = leastSmoothed(gains);
    return true;
  };
  const auto betterElsewhere = [&](const Hypothesis& hypothesis) {
    return betterBy([&](const SmoothingCandidate& candidate) { return evidenceAt(candidate, hypothesis); });
  };
  const bool smooth = at > kUsualSmoothing;
  auto found = searchedOn(at, kThreshold, [&](const Hypothesis& hypothesis, SearchStage soFar) {
    if (soFar == SearchStage::anotherCause) return false;
    return smooth && soFar == SearchStage::firstCause ? betterBy([&](const SmoothingCandidate& candidate) {
      return evidenceAfresh(candidate, hypothesis, options);
    })
                                                      : betterElsewhere(hypothesis);
  });
  if (found && found->search.givenUp) found = searchedOn(at, kThreshold);
  if (!found) return found.error();
  if (const std::size_t was = at; !progress.cancelled() && betterElsewhere(*found)) {
    auto again = searchedOn(at, kThreshold);
    at = again ? at : was;
    if (again) found = std::move(again);
  }
  if (progress.cancelled()) return Error{"Stopped.", true};
  if (options.surrogates > 0 && !found->search.found.empty()) {
    const auto bank = found->bank.around(found->signals, found->search.null.model);
    // Noise as the final model leaves it, around the motion and payload of the baseline.
    Fit base = found->search.null;
    base.noise = found->search.final.noise;
    out.chance = surrogates(found->signals, found->stretches, base, bank, options.surrogates, options.seed, progress);
    out.threshold = out.chance.threshold;
    if (std::ranges::any_of(found->search.found, [&](const Found& f) { return f.gain < out.threshold; })) {
      auto again = searchedOn(at, out.threshold);
      if (again) found = std::move(again);
    }
  }
  if (progress.cancelled()) return Error{"Stopped.", true};
  out.hypothesis = std::move(*found);
  out.cutoffHz = candidates[at].cutoffHz;
  out.hypothesis.motionArtefacts = motionArtefacts(out.hypothesis, candidates, at);
  if (!contains(options.hidden, ids::flexibleMount)) setRingingAside(out.hypothesis, usual);
  return out;
}

/// What pulls at the tool hard may look like a sensor that is turned or a sign mixed up: where causes explain more
/// without a mistake, there is none.
void unlessCausesExplainMore(const Recording& recording, const RobotModel* robot, DiagnoseOptions options,
                             const Progress& progress, Readings& readings, Searched& found) {
  constexpr double kClearly = 30.0;  ///< Evidence without a mistake over that with it
  // Numbers in other units have another likelihood.
  if (!readings.mistake || readings.mistake->has(conventions::Change::unit)) return;
  auto stated = readingsOf(recording, robot, options, true);
  if (!stated) return;
  const int surrogates = std::exchange(options.surrogates, 0);
  auto plain = searched(stated->stated, *stated, robot, options, progress);
  if (!plain || !believable(plain->hypothesis.search.final)) return;
  const auto perBlock = [](const Hypothesis& of) { return of.search.final.evidence / blocksIn(of.stretches); };
  if ((perBlock(plain->hypothesis) - perBlock(found.hypothesis)) * blocksIn(found.hypothesis.stretches) < kClearly)
    return;
  if (surrogates > 0) {
    options.surrogates = surrogates;
    plain = searched(stated->stated, *stated, robot, options, progress);
    if (!plain) return;
  }
  readings = std::move(*stated);
  found = std::move(*plain);
}

/// Whether single readings that are wrong may be all that there is in stretches that were set aside: coarse steps are
/// not where far more than a step is left.
bool mayBeAllThatIsOdd(const Direct& direct, const Hypothesis& hypothesis) {
  constexpr double kMostSteps = 3.0;
  if (direct.cause != ids::quantisation) return true;
  const auto stepOf = [&](std::string_view name) {
    const auto step = std::ranges::find_if(direct.parameters, [&](const auto& p) { return p.name == name; });
    return step == direct.parameters.end() ? 0.0 : step->value;
  };
  const double force = kMostSteps * stepOf("step_force"), torque = kMostSteps * stepOf("step_torque");
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
      const double value = size(i) * std::abs(p.scale);
      const auto known = std::ranges::find_if(out, [&](const Smallest& s) { return s.cause == id; });
      if (known == out.end())
        out.push_back({id, p.name, p.unit, value});
      else if (value < known->value && p.unit == known->unit)
        *known = {id, p.name, p.unit, value};
    }
  }
  return out;
}

}  // namespace

Result<DiagnosisReport> diagnose(const Recording& recording, const RobotModel* robot, const DiagnoseOptions& options,
                                 const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  if (recording.meta.kind == RecordingKind::poses) return diagnosePoses(recording, robot, options, progress);
  DiagnosisReport out;
  out.file = recording.file;
  out.meta = recording.meta;
  out.ofPoses = recording.hasOrientation();
  progress(0.02, heft::say("Looking at single readings"));
  auto readings = readingsOf(recording, robot, options);
  if (!readings) return readings.error();
  auto found = searched(readings->stated, *readings, robot, options, progress);
  if (!found) return found.error();
  unlessCausesExplainMore(recording, robot, options, Progress{progress.stop, {}}, *readings, *found);
  if (progress.cancelled()) return Error{"Stopped.", true};
  Hypothesis& hypothesis = found->hypothesis;
  out.threshold = found->threshold;
  out.surrogates = static_cast<int>(found->chance.best.size());

  progress(0.85, heft::say("Measuring the gain on unseen stretches"));
  Confirmed fitted = confirmed(hypothesis, found->chance, readings->steps, wasHeld(*readings));
  const Fit& final = hypothesis.search.final;
  out.baseline = rmsOf(hypothesis.stretches, hypothesis.search.null.residual);
  out.noise = rmsOf(hypothesis.stretches, final.residual);
  ByReadings by;
  by.withinSteps = isWithinSteps(out.noise, readings->steps);
  const Structure structure = by.withinSteps ? Structure{} : fitted.remaining;
  const double quiet = std::sqrt(std::clamp(1.0 - (structure.gain > kUnexplained ? structure.share : 0.0), 0.05, 1.0));
  out.noise.force *= quiet;
  out.noise.torque *= quiet;
  by.known = std::ranges::any_of(readings->directs, [&](const Direct& d) { return mayBeAllThatIsOdd(d, hypothesis); });
  by.deadBands = readings->deadBands;
  by.stuckBits = readings->stuckBits;
  by.frozen = readings->frozen;
  by.leaps = readings->leaps;
  WhatRemains remains = whatRemains(hypothesis, readings->cleaned, by, structure);
  out.findings = std::move(remains.findings);
  sayOwnErrors(fitted.own, out);

  out.mistake = readings->mistake;
  if (out.mistake) {
    WrenchRms was = out.baseline;
    was.force = out.mistake->forceBefore.value_or(was.force);
    out.causes.push_back(fromMistake(*out.mistake, was, out.baseline));
    out.baseline.force = std::max(out.baseline.force, was.force);
  }
  // Coarse angles or poses say why their accelerations are noisy.
  const bool coarse = std::ranges::any_of(
      readings->directs, [](const Direct& d) { return d.cause == ids::derivativeNoise && !d.ofVelocities; });
  if (found->noisy && !coarse)
    out.causes.push_back(fromNoisyMotion(*found->noisy));
  else if (!coarse)
    saySmoothing(found->cutoffHz, hypothesis.signals.smoothedAway, out);
  const auto isFitted = [&](std::string_view id) {
    return std::ranges::find(fitted.causes, id, &DiagnosedCause::id) != fitted.causes.end();
  };
  if (hypothesis.ringing && !isFitted(ids::flexibleMount)) out.causes.push_back(fromRinging(*hypothesis.ringing));
  if (hypothesis.carriedLoad) out.causes.push_back(fromCarriedLoad(*hypothesis.carriedLoad));
  for (const auto& direct : readings->directs)
    if (!isFitted(direct.cause)) out.causes.push_back(fromDirect(direct));
  FaintTouches faint;
  if (!hypothesis.contacts.empty()) faint = faintTouches(hypothesis, fitted.causes, remains.structure);
  if (faint.areFaint) {
    out.findings.push_back(std::move(faint.finding));
  } else if (!hypothesis.contacts.empty()) {
    const bool named = contains(final.model, hypothesis.contactAlternative);
    out.causes.push_back(fromContacts(hypothesis.contacts, final.residual,
                                      named ? std::string() : hypothesis.contactAlternative, out.noise.force));
  }
  for (auto& cause : fitted.causes) out.causes.push_back(std::move(cause));
  sortByStrength(out.causes);
  out.findings.insert(out.findings.begin(), readings->motion.findings.begin(), readings->motion.findings.end());
  giveVerdict(hypothesis, faint.remaining.value_or(remains.structure), out);
  const bool compared = faint.remaining || !remains.seen;
  if (out.verdict == Verdict::unexplained && compared) dropBesideUnknown(out);

  progress(0.93, heft::say("Estimating the payload again"));
  if (auto error = estimateAgain(out, recording, readings->cleaned, robot, hypothesis, options.estimate,
                                 Progress{progress.stop, {}}))
    return *error;
  out.model = final.model;
  out.smallest = smallestVisible(hypothesis, out.causes, std::max(kNamed, out.threshold));
  out.series.time.resize(hypothesis.signals.blocks());
  for (Eigen::Index n = 0; n < hypothesis.signals.blocks(); ++n) out.series.time(n) = hypothesis.signals.blockTime(n);
  out.series.measured = hypothesis.signals.measured;
  out.series.before = hypothesis.signals.measured - fitted.first;
  out.series.after = hypothesis.signals.measured - fitted.last;
  out.series.judged = hypothesis.signals.usable;
  putIntoWords(out);
  out.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  progress(1.0, "Done");
  return out;
}

}  // namespace heft
