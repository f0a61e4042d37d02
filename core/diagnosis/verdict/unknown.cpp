#include "core/diagnosis/verdict/unknown.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include "core/base/say.h"
#include "core/base/stop.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/causes/catalogue.h"
#include "core/diagnosis/causes/common.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/change_detection/knocks.h"
#include "core/diagnosis/model/hum.h"
#include "core/diagnosis/model/step_candidates.h"
#include "core/diagnosis/residual_analysis/band_excess.h"
#include "core/diagnosis/search/random_walk.h"

namespace heft::diagnosis {

namespace {

/// What remains where its share of the energy was not worked out.
Structure seen(Correlate goesWith, double gain = kSeenDirectly) { return {goesWith, gain, 0.0, 0.0, 0.0}; }

/// What a question of the table is about.
struct Asked {
  const Hypothesis& hypothesis;
  const Recording& cleaned;
  const ByReadings& by;
  // Of the final model without a zero that walks, all blocks made equally loud; only where more than the readings'
  // steps is left.
  Fit steady;
  Wrenches residual;
  bool walks = false;  ///< The zero does, in the final model

  Asked(const Hypothesis& h, const Recording& recording, const ByReadings& readings)
      : hypothesis(h), cleaned(recording), by(readings) {
    const Fit& final = h.search.final;
    if (by.withinSteps) return;
    walks = hasRandomWalk(final.model);
    steady = walks ? fitModel(h.signals, h.stretches, without(final.model, kRandomWalk)) : final;
    residual = evenWrench(steady.residual, steady.noise);
  }
};

/// The answer: what would remain, if anything, and what is said of it.
struct Claim {
  std::optional<Structure> remaining = {};
  Findings findings = {};
};

Finding warning(const char* code, std::string text, std::string remedy) {
  return {Severity::warning, code, std::move(text), std::move(remedy), {}};
}
Finding info(const char* code, std::string text, std::string remedy) {
  return {Severity::info, code, std::move(text), std::move(remedy), {}};
}

/// A walk has waves for anything that is slow, and the model for little else: what changes at once is neither.
Claim suddenChanges(const Asked& asked, const WhatRemains&) {
  constexpr std::ptrdiff_t kFewestFar = 2;
  /// StepCandidate::size, and where nothing else was found: of 504 clean recordings one had three above 30, seven had
  /// one, one had one above 40. What else is named may leave some.
  constexpr double kFarAlone = 40.0, kFar = 2.0 * kFarAlone;
  constexpr double kSlower = 0.4;  ///< [s] Smaller steps need longer means
  const Hypothesis& h = asked.hypothesis;
  auto steps = stepCandidatesIn(h.signals, h.stretches, asked.residual);
  const auto far = [&](double size) {
    return std::ranges::count_if(steps, [&](const StepCandidate& step) { return step.size > size; }) >= kFewestFar;
  };
  const bool alone = without(h.search.final.model, kRandomWalk).terms.empty();
  bool switches = steps.size() >= kPattern || far(alone ? kFarAlone : kFar);
  if (alone && !switches) {
    steps = stepCandidatesIn(h.signals, h.stretches, asked.residual, kSlower);
    switches = far(kFarAlone);
  }
  if (!switches) return {};
  return {seen(heft::toSay("sudden changes")),
          {warning("switches",
                   heft::say("Something on the tool changes at once {} times, first at {:.1f} s.", std::ssize(steps),
                             steps.front().time),
                   heft::say("Look at what switches there: a gripper, a valve, a part that slides."))}};
}

Claim slowWaveInTime(const Asked& asked, const WhatRemains&) {
  const double excess = slowWave(asked.hypothesis.signals, asked.hypothesis.stretches, asked.residual);
  if (excess <= 1.0) return {};
  return {seen(heft::toSay("a slow wave in time"), 2.0 * kUnexplained * excess)};
}

Claim unevenChannels(const Asked& asked, const WhatRemains&) {
  const bool onlyZero = std::ranges::all_of(
      asked.steady.model.terms, [](const Term& t) { return t.form->cause->info().family == Family::sensorZero; });
  if (!onlyZero || !isUneven(asked.hypothesis.signals, asked.hypothesis.stretches, asked.residual)) return {};
  return {seen(heft::toSay("some channels of the sensor alone, slowly"))};
}

/// What goes with the motion, beyond what the walk explains.
Claim hiddenByTheWalk(const Asked& asked, const WhatRemains&) {
  if (!asked.walks) return {};
  const Hypothesis& h = asked.hypothesis;
  const double enough = h.search.final.evidence - asked.steady.evidence + kFaint;
  const Structure hidden = structureBehindWalk(h.signals, h.stretches, asked.steady, enough);
  return hidden.gain > enough ? Claim{hidden} : Claim{};
}

/// Where nothing hides behind it, the walk is said.
Claim theWalkItself(const Asked& asked, const WhatRemains& soFar) {
  if (!asked.walks || soFar.claimed) return {};
  return {{},
          {info("zero_wanders", heft::say("The sensor zero drifts slowly; this is compensated."),
                heft::say("Let the sensor warm up, and keep recordings short."))}};
}

/// A drift in place of what goes with the motion: where that explains as much as the drift and the walk together,
/// neither is known.
Claim hiddenByADrift(const Asked& asked, const WhatRemains&) {
  const Hypothesis& h = asked.hypothesis;
  const Fit& final = h.search.final;
  Model bare = without(final.model, ids::biasDrift);
  if (bare.terms.size() == final.model.terms.size()) return {};
  // Of any course, it has waves for anything slow as a walk has: then what the load was before is asked for, too, and
  // must explain more than everything that was named.
  if (takesAnyCourse(final.model)) {
    const Fit& null = h.search.null;
    const double all = final.evidence - null.evidence + kClearEvidence;
    const Structure hidden = structureBehindWalk(h.signals, h.stretches, null, all);
    return hidden.gain > all ? Claim{hidden} : Claim{};
  }
  const Fit fit = fitModel(h.signals, h.stretches, without(bare, kRandomWalk));
  const double enough = std::max(kFaint, final.evidence - fit.evidence - kTie);
  const Structure hidden = structureIn(h.signals, h.stretches, fit, enough);
  return hidden.gain > enough ? Claim{hidden} : Claim{};
}

/// What was set aside and is no contact is unknown, unless single readings are known to be wrong all over.
Claim segmentsSetAside(const Asked& asked, const WhatRemains&) {
  const Hypothesis& h = asked.hypothesis;
  if (h.unexplained.empty()) return {};
  const double evidence = evidenceOf(h.unexplained), lasts = durationOf(h.unexplained);
  const std::string correlate = h.unexplainedCorrelate.words();
  Claim out;
  out.findings.push_back(warning(
      "odd_stretches",
      h.unexplained.size() == 1
          ? heft::say("A segment of {:.1f} s was excluded: what acts there is related to {} and is not contact.", lasts,
                      correlate)
          : heft::say(
                "{} segments, {:.1f} s in total, were excluded: what acts there is related to {} and is not contact.",
                std::ssize(h.unexplained), lasts, correlate),
      heft::say("Check what switches, vibrates or rotates on the tool at these times.")));
  if (!asked.by.known || h.unexplainedCorrelate == kOneChannel) out.remaining = seen(h.unexplainedCorrelate, evidence);
  return out;
}

/// Stretches in which a cause did once more what it does elsewhere.
Claim recurrences(const Asked& asked, const WhatRemains&) {
  Claim out;
  for (const Contact& contact : asked.hypothesis.recurrences)
    out.findings.push_back(
        info("cause_again",
             heft::say("From {:.1f} to {:.1f} s the zero or the load was different again; that segment was excluded.",
                       contact.from, contact.to),
             {}));
  return out;
}

/// What rings harder than the motion can set it off was struck by something, and whether that is what carries the tool
/// or the ground no recording tells.
Claim blows(const Asked& asked, const WhatRemains&) {
  const auto& ringing = asked.hypothesis.ringing;
  if (!ringing || !ringing->struck) return {};
  return {seen(heft::toSay("blows from outside"), ringing->evidence),
          {warning("struck",
                   heft::say("Something struck the tool or the ground, first at {:.1f} s: the motion alone would not "
                             "cause such strong ringing.",
                             ringing->when.front().first),
                   heft::say("Find out what knocks, and record again without it."))}};
}

/// Whether what remains is `hum` as blocks show it, folded down by their rate.
bool isFolded(const Hum& hum, double blockRate, const Structure& remaining) {
  const double folded = std::abs(hum.frequencyHz - blockRate * std::round(hum.frequencyHz / blockRate));
  return remaining.highHz > 0.0 && folded > remaining.lowHz - 1.0 && folded < remaining.highHz + 1.0;
}

/// A line in the spectrum is said; one that makes up much of what is fast is unknown to the catalogue.
Claim aHum(const Asked& asked, const WhatRemains& soFar) {
  const auto hum = humIn(asked.cleaned, asked.hypothesis.signals);
  if (!hum) return {};
  const bool unknown = hum->share > kMinorShare;
  Claim out;
  out.findings.push_back({unknown ? Severity::warning : Severity::info,
                          "readings_hum",
                          heft::say("The readings hum at {:.0f} Hz, by {:.2g} N and {:.2g} N m.", hum->frequencyHz,
                                    hum->force, hum->torque),
                          hum->mains
                              ? heft::say("That is the mains: check the sensor's shield and earth.")
                              : heft::say("Switch off what runs nearby, such as a fan or a motor, and record again."),
                          {}});
  const bool free = soFar.structure.gain <= kUnexplained;
  if (unknown && (free || isFolded(*hum, asked.hypothesis.signals.blockRate(), soFar.structure)))
    out.remaining =
        Structure{Correlate::rhythm(hum->frequencyHz), kSeenDirectly, hum->share, hum->frequencyHz, hum->frequencyHz};
  return out;
}

/// What knocks again and again is no noise; a mass that swings may knock at its stops, and what rubs may stick and
/// slip.
Claim knocks(const Asked& asked, const WhatRemains& soFar) {
  const Hypothesis& h = asked.hypothesis;
  const Model& final = h.search.final.model;
  if (h.ringing || contains(final, ids::looseMass) || contains(final, ids::coulombFriction)) return {};
  const auto at = knocksIn(h.signals, h.stretches, final);
  if (at.size() < kAgainAndAgain) return {};
  Claim out{{},
            {warning("knocks", heft::say("Something knocks {} times, first at {:.1f} s.", std::ssize(at), at.front()),
                     heft::say("Shake the tool by hand and listen: is a part of it loose?"))}};
  if (soFar.structure.gain <= kUnexplained) out.remaining = seen(heft::toSay("short knocks"));
  return out;
}

/// Nor is noise that is many times louder again and again.
Claim bursts(const Asked& asked, const WhatRemains&) {
  const Hypothesis& h = asked.hypothesis;
  if (h.ringing) return {};
  const Fit& fit = h.search.final;
  const auto at = burstsIn(h.signals, h.stretches, fit);
  const bool some = at.size() >= kAgainAndAgain;
  if (!some && !noiseSwitches(h.signals, h.stretches, fit)) return {};
  return {seen(heft::toSay("noise that comes and goes")),
          {warning("bursts",
                   some ? heft::say("The readings shake for a moment {} times, first at {:.1f} s.", std::ssize(at),
                                    at.front())
                        : heft::say("The readings shake in some parts of the recording, and not in others that move "
                                    "alike."),
                   heft::say("Check what switches, vibrates or rotates on the tool at these times."))}};
}

/// Where nothing else was found, one moment at which a reading is plainly wrong is no noise.
Claim oneGlitch(const Asked& asked, const WhatRemains&) {
  const Hypothesis& h = asked.hypothesis;
  if (!h.contacts.empty() || !without(h.search.final.model, kRandomWalk).terms.empty()) return {};
  const auto at = glitchIn(h.signals, h.stretches, h.search.final);
  if (!at) return {};
  return {seen(heft::toSay("a few moments alone")),
          {warning("glitch", heft::say("At {:.2f} s the readings jump briefly to implausible values.", *at),
                   heft::say("Check the sensor's cable and plug; mark the moment as \"ignore\"."))}};
}

Claim deadBandsOf(const Asked& asked, const WhatRemains&) {
  Claim out;
  for (const DeadBand& band : asked.by.deadBands)
    out.findings.push_back(warning(
        "dead_band",
        heft::say("{} reads exactly {:.4g} {} wherever it is within {:.2g} of that value: {:.0f} % of its readings.",
                  channelName(band.channel), band.reads, band.channel < 3 ? "N" : "N m", band.width,
                  100.0 * band.share),
        heft::say("Switch off the threshold or dead band in the sensor's driver and record again.")));
  if (!asked.by.deadBands.empty()) out.remaining = seen(heft::toSay("readings that stick at one value"));
  return out;
}

Claim stuckBitsOf(const Asked& asked, const WhatRemains&) {
  Claim out;
  for (const StuckBit& bit : asked.by.stuckBits)
    out.findings.push_back(
        warning("stuck_bit",
                heft::say("{} uses only every other step of {:.2g} {}: one bit of its converter appears to be stuck.",
                          channelName(bit.channel), bit.worth, bit.channel < 3 ? "N" : "N m"),
                heft::say("Restart the sensor's electronics; if that does not help, have them repaired.")));
  if (!asked.by.stuckBits.empty()) out.remaining = seen(heft::toSay("steps that a channel never reads"));
  return out;
}

Claim fewLeaps(const Asked& asked, const WhatRemains&) {
  const Eigen::Index rows = asked.by.leaps;
  if (rows == 0) return {};
  return {
      {},
      {info(
          "few_leaps",
          rows == 1
              ? heft::say("One reading jumps for a single row. It was replaced by interpolation.")
              : heft::say(
                    "{} readings jump for a single row, too few to determine why. They were replaced by interpolation.",
                    rows),
          heft::say("Look for what knocks or jerks, and check the sensor's plug, if there are more next time."))}};
}

Claim frozenChannelOf(const Asked& asked, const WhatRemains&) {
  const auto& frozen = asked.by.frozen;
  if (!frozen) return {};
  return {seen(heft::toSay("readings that stick at one value")),
          {warning("channel_stands_still",
                   heft::say("{} is frozen from {:.1f} to {:.1f} s, while the others go on.",
                             channelName(frozen->channel), frozen->from, frozen->to),
                   heft::say("Check that channel's cable and plug; mark the segment as \"ignore\"."))}};
}

/// When a question is asked.
enum class If {
  always,
  aboveSteps,     ///< More is left than the steps of the readings
  readingsRight,  ///< No test of single readings found anything that has lines or leaps of its own
};

/// How a claim competes.
enum class Weighs {
  byEvidence,  ///< The largest evidence is told
  alone,       ///< It needs no model, so that it replaces whatever a model makes of it
  /// It is asked where nothing remains so far: a strong cause whose form is not quite right leaves as much where it
  /// acts
  ifNothingElse,
};

struct Unknown {
  If asked;
  Weighs weighs;
  Claim (*claim)(const Asked& asked, const WhatRemains& soFar);
};

/// Hypotheses about what the catalogue lacks, one line each. Those that weigh by evidence compete, in no order but that
/// a walk is said once it is known that nothing hides behind it; what single readings show stands last.
constexpr std::array kUnknowns{Unknown{If::aboveSteps, Weighs::ifNothingElse, suddenChanges},
                               Unknown{If::aboveSteps, Weighs::byEvidence, slowWaveInTime},
                               Unknown{If::aboveSteps, Weighs::ifNothingElse, unevenChannels},
                               Unknown{If::aboveSteps, Weighs::byEvidence, hiddenByTheWalk},
                               Unknown{If::aboveSteps, Weighs::byEvidence, theWalkItself},
                               Unknown{If::aboveSteps, Weighs::byEvidence, hiddenByADrift},
                               Unknown{If::always, Weighs::byEvidence, segmentsSetAside},
                               Unknown{If::always, Weighs::byEvidence, recurrences},
                               Unknown{If::always, Weighs::byEvidence, blows},
                               Unknown{If::readingsRight, Weighs::alone, aHum},
                               Unknown{If::readingsRight, Weighs::alone, knocks},
                               Unknown{If::readingsRight, Weighs::ifNothingElse, bursts},
                               Unknown{If::readingsRight, Weighs::ifNothingElse, oneGlitch},
                               Unknown{If::always, Weighs::alone, deadBandsOf},
                               Unknown{If::always, Weighs::alone, stuckBitsOf},
                               Unknown{If::always, Weighs::alone, fewLeaps},
                               Unknown{If::always, Weighs::alone, frozenChannelOf}};

bool isAsked(const Unknown& unknown, const ByReadings& by, double gain) {
  if (unknown.asked == If::aboveSteps && by.withinSteps) return false;
  if (unknown.asked == If::readingsRight && (by.known || by.coarse)) return false;
  return unknown.weighs != Weighs::ifNothingElse || gain <= kUnexplained;
}

}  // namespace

WhatRemains whatRemains(const Hypothesis& hypothesis, const Recording& cleaned, const ByReadings& by,
                        const Structure& structure) {
  WhatRemains out{structure, {}};
  const Asked asked(hypothesis, cleaned, by);
  for (const Unknown& unknown : kUnknowns) {
    if (!isAsked(unknown, by, out.structure.gain)) continue;
    stopPoint();
    Claim claim = unknown.claim(asked, out);
    std::ranges::move(claim.findings, std::back_inserter(out.findings));
    if (!claim.remaining) continue;
    if (unknown.weighs != Weighs::alone && claim.remaining->gain < out.structure.gain) continue;
    out.structure = *claim.remaining;
    out.claimed = true;
    out.seen = out.structure.gain == kSeenDirectly;
  }
  return out;
}

}  // namespace heft::diagnosis
