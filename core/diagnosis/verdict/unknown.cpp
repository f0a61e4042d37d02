#include "core/diagnosis/verdict/unknown.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/base/say.h"
#include "core/diagnosis/causes/catalogue.h"
#include "core/diagnosis/causes/common.h"
#include "core/diagnosis/change_detection/knocks.h"
#include "core/diagnosis/model/hum.h"
#include "core/diagnosis/model/step_candidates.h"
#include "core/diagnosis/residual_analysis/band_excess.h"
#include "core/diagnosis/search/random_walk.h"
#include "core/diagnosis/wording/words.h"

namespace heft::diagnosis {

namespace {

constexpr double kSeen = 1e3;  ///< Gain of what is seen without comparing likelihoods
/// Of what the load was before, beyond what has waves for anything slow. Of 100 walks one came 30 beyond, the others
/// hardly; what was hidden went 90 and more, a leak of a minute 41.
constexpr double kBeyond = 60.0;
constexpr double kBeyondCourse = 30.0;  ///< The same for a drift of any course: of three one came 15 beyond, a leak 40

/// What remains where its share of the energy was not worked out.
Structure seen(std::string goesWith, double gain = kSeen) { return {std::move(goesWith), gain, 0.0, 0.0, 0.0}; }

/// A walk has waves for anything that is slow. What swings, or goes with the motion, beyond what the walk explains is
/// none.
void sayHiddenInTime(const Work& work, DiagnosisReport& out) {
  constexpr std::size_t kFewestLeaps = 6;
  constexpr std::ptrdiff_t kFewestFar = 2;
  /// Leap::size, and where nothing else was found: of 504 clean recordings one had three above 30, seven had one, one
  /// had one above 40. What else is named may leave some.
  constexpr double kFar = 80.0, kFarAlone = 40.0;
  constexpr double kSlower = 0.4;  ///< [s] Smaller leaps need longer means
  const Fit& final = work.search.final;
  const bool wanders = walks(final.model);
  const Fit steady = wanders ? fitModel(work.signals, work.stretches, without(final.model, kWandering)) : final;
  const Wrenches residual = evenWrench(steady.residual, steady.noise);
  bool hides = false;
  auto leaps = leapsIn(work.signals, work.stretches, residual);
  const auto far = [&](double size) {
    return std::ranges::count_if(leaps, [&](const Leap& leap) { return leap.size > size; }) >= kFewestFar;
  };
  const bool alone = without(final.model, kWandering).terms.empty();
  bool switches = leaps.size() >= kFewestLeaps || far(alone ? kFarAlone : kFar);
  if (alone && !switches) {
    leaps = leapsIn(work.signals, work.stretches, residual, kSlower);
    switches = far(kFarAlone);
  }
  if (out.remaining.gain <= kUnexplained && switches) {
    out.findings.push_back({Severity::warning,
                            "switches",
                            heft::say("Something on the tool changes at once {} times, first at {:.1f} s.",
                                      std::ssize(leaps), leaps.front().time),
                            heft::say("Look at what switches there: a gripper, a valve, a part that slides."),
                            {}});
    out.remaining = seen(heft::toSay("sudden changes"));
    hides = true;
  }
  if (const double excess = slowWave(work.signals, work.stretches, residual);
      excess > 1.0 && out.remaining.gain < 2.0 * kUnexplained) {
    out.remaining = seen(heft::toSay("a slow wave in time"), 2.0 * kUnexplained * excess);
    hides = true;
  }
  const bool onlyZero = std::ranges::all_of(
      steady.model.terms, [](const Term& t) { return causeOf(t) == "bias_drift" || causeOf(t) == "sensor_bias"; });
  if (onlyZero && out.remaining.gain <= kUnexplained && isUneven(work.signals, work.stretches, residual)) {
    out.remaining = seen(heft::toSay("some channels of the sensor alone, slowly"));
    hides = true;
  }
  if (!wanders) return;
  if (out.remaining.gain <= kUnexplained) {
    const double enough = final.evidence - steady.evidence + kBeyond;
    const Structure hidden = structureBehindWalk(work.signals, work.stretches, steady, enough);
    hides = hidden.gain > enough;
    if (hides) out.remaining = hidden;
  }
  if (hides) return;
  out.findings.push_back({Severity::info,
                          "zero_wanders",
                          heft::say("The sensor's zero wanders slowly during the recording; this is allowed for."),
                          heft::say("Let the sensor warm up, and keep recordings short."),
                          {}});
}

/// A drift in place of what goes with the motion: where that explains as much as the drift and the walk together,
/// neither is known.
void sayHiddenByDrift(const Work& work, DiagnosisReport& out) {
  constexpr double kAsMuch = 10.0;  ///< Less than the drift; of 27 that were one none came nearer than 40
  constexpr double kPlain = 60.0;
  const Fit& final = work.search.final;
  Model bare = without(final.model, "bias_drift");
  if (out.remaining.gain > kUnexplained || bare.terms.size() == final.model.terms.size()) return;
  // Of any course, it has waves for anything slow as a walk has: then what the load was before is asked for, too, and
  // must explain more than everything that was named.
  if (takesAnyCourse(final.model)) {
    const Fit& null = work.search.null;
    const double all = final.evidence - null.evidence + kBeyondCourse;
    const Structure hidden = structureBehindWalk(work.signals, work.stretches, null, all);
    if (hidden.gain > all) out.remaining = hidden;
    return;
  }
  const Fit fit = fitModel(work.signals, work.stretches, without(bare, kWandering));
  const double enough = std::max(kPlain, final.evidence - fit.evidence - kAsMuch);
  const Structure hidden = structureIn(work.signals, work.stretches, fit, enough);
  if (hidden.gain > enough) out.remaining = hidden;
}

/// What was set aside and is no contact is unknown, unless single readings are `known` to be wrong all over.
void saySomethingOdd(const Work& work, bool known, DiagnosisReport& out) {
  const double evidence = evidenceOf(work.odd), lasts = durationOf(work.odd);
  out.findings.push_back(
      {Severity::warning,
       "odd_stretches",
       work.odd.size() == 1
           ? heft::say("A stretch of {:.1f} s was left out: what acts there goes with {} and is no touch.", lasts,
                       goesWithWords(work.oddGoesWith))
           : heft::say("{} stretches, {:.1f} s in all, were left out: what acts there goes with {} and is no touch.",
                       std::ssize(work.odd), lasts, goesWithWords(work.oddGoesWith)),
       heft::say("Look at what switches, shakes or turns on the tool at these moments."),
       {}});
  if ((known && work.oddGoesWith != kOneChannel) || out.remaining.gain > evidence) return;
  out.remaining = seen(work.oddGoesWith, evidence);
}

/// Whether what remains is `hum` as blocks show it, folded down by their rate.
bool isFolded(const Hum& hum, double blockRate, const Structure& remaining) {
  const double folded = std::abs(hum.frequencyHz - blockRate * std::round(hum.frequencyHz / blockRate));
  return remaining.highHz > 0.0 && folded > remaining.lowHz - 1.0 && folded < remaining.highHz + 1.0;
}

/// A line in the spectrum is said; one that makes up much of what is fast is unknown to the catalogue.
void sayHum(const Hum& hum, double blockRate, DiagnosisReport& out) {
  constexpr double kMuch = 0.2;
  const bool unknown = hum.share > kMuch;
  out.findings.push_back(
      {unknown ? Severity::warning : Severity::info,
       "readings_hum",
       heft::say("The readings hum at {:.0f} Hz, by {:.2g} N and {:.2g} N m.", hum.frequencyHz, hum.force, hum.torque),
       hum.mains ? heft::say("That is the mains: check the sensor's shield and earth.")
                 : heft::say("Switch off what runs nearby, such as a fan or a motor, and record once more."),
       {}});
  if (!unknown || (out.remaining.gain > kUnexplained && !isFolded(hum, blockRate, out.remaining))) return;
  out.remaining = {fmt::format("a rhythm of {:.0f} Hz", hum.frequencyHz), kSeen, hum.share, hum.frequencyHz,
                   hum.frequencyHz};
}

/// What knocks again and again is no noise; a mass that swings may knock at its stops, and what rubs may stick and
/// slip.
void sayKnocks(const Work& work, DiagnosisReport& out) {
  constexpr std::size_t kFewest = 3;
  const Model& final = work.search.final.model;
  if (work.ringing || contains(final, "loose_mass") || contains(final, "coulomb_friction")) return;
  const auto knocks = knocksIn(work.signals, work.stretches, final);
  if (knocks.size() < kFewest) return;
  out.findings.push_back(
      {Severity::warning,
       "knocks",
       heft::say("Something knocks {} times, first at {:.1f} s.", std::ssize(knocks), knocks.front()),
       heft::say("Shake the tool by hand and listen: is a part of it loose?"),
       {}});
  if (out.remaining.gain > kUnexplained) return;
  out.remaining = seen(heft::toSay("short knocks"));
}

/// Nor is noise that is many times louder again and again.
void sayBursts(const Work& work, DiagnosisReport& out) {
  constexpr std::size_t kFewest = 3;
  if (work.ringing || out.remaining.gain > kUnexplained) return;
  const Fit& fit = work.search.final;
  const auto bursts = burstsIn(work.signals, work.stretches, fit);
  const bool some = bursts.size() >= kFewest;
  if (!some && !noiseSwitches(work.signals, work.stretches, fit)) return;
  out.findings.push_back(
      {Severity::warning,
       "bursts",
       some ? heft::say("The readings shake for a moment {} times, first at {:.1f} s.", std::ssize(bursts),
                        bursts.front())
            : heft::say("The readings shake in some parts of the recording, and not in others that move alike."),
       heft::say("Look at what switches, shakes or turns on the tool at these moments."),
       {}});
  out.remaining = seen(heft::toSay("noise that comes and goes"));
}

/// Where nothing else was found, one moment at which a reading is plainly wrong is no noise.
void sayGlitch(const Work& work, DiagnosisReport& out) {
  if (out.remaining.gain > kUnexplained || !work.contacts.empty() ||
      !without(work.search.final.model, kWandering).terms.empty())
    return;
  const auto at = glitchIn(work.signals, work.stretches, work.search.final);
  if (!at) return;
  out.findings.push_back({Severity::warning,
                          "glitch",
                          heft::say("At {:.2f} s the readings leap to where no load takes them and back.", *at),
                          heft::say("Check the sensor's cable and plug; mark the moment as \"ignore\"."),
                          {}});
  out.remaining = seen(heft::toSay("a few moments alone"));
}

/// Stretches in which a cause did once more what it does elsewhere.
void sayAgain(const std::vector<Contact>& again, DiagnosisReport& out) {
  for (const Contact& contact : again)
    out.findings.push_back({Severity::info,
                            "cause_again",
                            heft::say("From {:.1f} to {:.1f} s the zero or the load was another one once more; that "
                                      "stretch was left out.",
                                      contact.from, contact.to),
                            {},
                            {}});
}

/// What rings harder than the motion can set it off was struck by something, and whether that is what carries the tool
/// or the ground no recording tells.
void sayStruck(const Ringing& ringing, DiagnosisReport& out) {
  out.findings.push_back({Severity::warning,
                          "struck",
                          heft::say("Something struck the tool or the ground, first at {:.1f} s: the motion alone sets "
                                    "nothing ringing so hard.",
                                    ringing.when.front().first),
                          heft::say("Find out what knocks, and record once more without it."),
                          {}});
  if (out.remaining.gain < ringing.evidence) out.remaining = seen(heft::toSay("blows from outside"), ringing.evidence);
}

}  // namespace

void sayWhatElse(const Work& work, const Recording& cleaned, const ByReadings& by, DiagnosisReport& out) {
  if (!by.withinSteps) {
    sayHiddenInTime(work, out);
    sayHiddenByDrift(work, out);
  }
  if (!work.odd.empty()) saySomethingOdd(work, by.known, out);
  sayAgain(work.again, out);
  if (work.ringing && work.ringing->struck) sayStruck(*work.ringing, out);
  // Readings that were held, lost or late have lines of their own.
  if (by.known) return;
  if (const auto hum = humIn(cleaned, work.signals)) sayHum(*hum, work.signals.blockRate(), out);
  sayKnocks(work, out);
  sayBursts(work, out);
  sayGlitch(work, out);
}

bool sayFaintTouches(const Work& work, const std::vector<DiagnosedCause>& fitted, DiagnosisReport& out) {
  // Of 30 recordings in which something was touched, the faintest touch had 479, at a third of the visible size; of 47
  // in which nothing was, 32 had less than this.
  constexpr double kTouch = 350.0;
  /// The same of one stretch beside which nothing is left: of 960 recordings two had such a one with less than kTouch,
  /// 162 and 248, and both had been touched.
  constexpr double kAlone = 150.0;
  constexpr double kLittle = 0.15;  ///< Of the evidence of the other causes: what their forms do not quite have
  constexpr double kNoise = 75.0;   ///< With nothing else, chance: of 190 clean recordings one had 60
  const double evidence = evidenceOf(work.contacts), lasts = durationOf(work.contacts);
  double others = 0.0;
  if (evidence >= kTouch) return false;
  const bool alone = fitted.empty() && work.contacts.size() == 1 && out.remaining.gain <= kUnexplained;
  if (alone && evidence >= kAlone) return false;
  for (const DiagnosedCause& cause : fitted) others += cause.deltaBic;
  const bool counts = evidence > (fitted.empty() ? kNoise : kLittle * others);
  out.findings.push_back(
      {counts ? Severity::warning : Severity::info,
       "faint_stretches",
       work.contacts.size() == 1
           ? heft::say(
                 "A stretch of {:.1f} s was left out: something acts there, too faint to tell a touch from anything "
                 "else.",
                 lasts)
           : heft::say("{} stretches, {:.1f} s in all, were left out: something acts there, too faint to tell a touch "
                       "from anything else.",
                       std::ssize(work.contacts), lasts),
       heft::say("Record the motion once more and keep clear of everything."),
       {}});
  if (counts && evidence > out.remaining.gain) out.remaining = seen(heft::toSay("a few moments alone"), evidence);
  return true;
}

void sayDeadBands(const std::vector<DeadBand>& bands, DiagnosisReport& out) {
  for (const DeadBand& band : bands)
    out.findings.push_back(
        {Severity::warning,
         "dead_band",
         heft::say("{} reads exactly {:.4g} {} wherever it would be less than {:.2g} away from that: {:.0f} % of its "
                   "readings.",
                   channelName(band.channel), band.reads, band.channel < 3 ? "N" : "N m", band.width,
                   100.0 * band.share),
         heft::say("Switch off the threshold or dead band in the sensor's driver and record once more."),
         {}});
  if (bands.empty()) return;
  out.remaining = seen(heft::toSay("readings that stick at one value"));
}

void sayFrozen(const FrozenChannel& frozen, DiagnosisReport& out) {
  out.findings.push_back({Severity::warning,
                          "channel_stands_still",
                          heft::say("{} stands still from {:.1f} to {:.1f} s, while the others go on.",
                                    channelName(frozen.channel), frozen.from, frozen.to),
                          heft::say("Check that channel's cable and plug; mark the stretch as \"ignore\"."),
                          {}});
  out.remaining = seen(heft::toSay("readings that stick at one value"));
}

void sayLeaps(Eigen::Index rows, DiagnosisReport& out) {
  if (rows == 0) return;
  out.findings.push_back(
      {Severity::info,
       "few_leaps",
       rows == 1
           ? heft::say("One reading leaps for a single row. It was replaced by what lies beside it.")
           : heft::say("{} readings leap for a single row, too few to tell what makes them. They were replaced by "
                       "what lies beside them.",
                       rows),
       heft::say("Look for what knocks or jerks, and check the sensor's plug, if there are more next time."),
       {}});
}

void sayStuckBits(const std::vector<StuckBit>& bits, DiagnosisReport& out) {
  for (const StuckBit& bit : bits)
    out.findings.push_back(
        {Severity::warning,
         "stuck_bit",
         heft::say("{} leaves out every other step of {:.2g} {}: a bit of its converter never changes.",
                   channelName(bit.channel), bit.worth, bit.channel < 3 ? "N" : "N m"),
         heft::say("Restart the sensor's electronics; if that does not help, have them mended."),
         {}});
  if (bits.empty()) return;
  out.remaining = seen(heft::toSay("steps that a channel never reads"));
}

}  // namespace heft::diagnosis
