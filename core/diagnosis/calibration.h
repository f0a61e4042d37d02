#pragma once
// What the diagnosis was calibrated with: every number that several of its rules share, by meaning. A number that one
// rule alone has stands with that rule.
//
// Units: evidence is twice the natural logarithm of a Bayes factor; shares are of 1. Names of numbers that are only a
// size of an array, a unit or a limit to how long a computation runs are no calibration and stand where they are used.
//
// How these are recounted: `diagnosis_study write FOLDER 20 SEED`, `diagnosis_answers.sh`, `diagnosis_study score
// FOLDER` (tests/benchmarks/README.md). Seeds 515151 and 97201 are held out: they are scored by class, and no single
// recording of them is looked at. Other seeds may be looked into.
#include <cstddef>

namespace heft::diagnosis {

// Evidence. Kass and Raftery (1995): 6 is strong, above 10 very strong. The steps above that are not about chance,
// which 10 excludes, but about models that are all a little wrong: how much an imperfect model of something else may
// gain.

/// A cause is part of the model from here on: very strong.
constexpr double kThreshold = 10.0;
/// Two explanations that differ by less are tied.
constexpr double kTie = kThreshold;
/// Twice very strong: a cause is named, and a form is believed that needs more than others, because things are seldom
/// like that or because it takes a little of anything.
constexpr double kNamed = 2.0 * kThreshold;
/// One explanation is clearly better than another that was taken first; also beside a zero that wanders, whose waves
/// leave a little of anything.
constexpr double kClearEvidence = 30.0;
/// Below this, simplicity alone names no cause; above it, nobody would call it noise, though no cause has its form.
constexpr double kFaint = 50.0;
/// What no imperfect model of something else gains, nor slow noise a drift that takes any course.
constexpr double kOverwhelming = 300.0;
/// Given to what is seen without comparing likelihoods.
constexpr double kSeenDirectly = 1e3;
/// Given to what is ruled out.
constexpr double kNever = 1e9;
/// What the flexible dictionary must gain for something unknown to be left: more than in the noise of clean recordings
/// (its null distribution is drawn in residual_analysis/structure.cpp).
constexpr double kUnexplained = kNamed;
/// A jump of the zero gains this over a zero that walks: one that walks makes steps, too.
constexpr double kJump = 5.0;
/// Below this, twice the log-likelihood sets no two explanations apart.
constexpr double kSameLikelihood = 4.0;

// Model discrepancy (Kennedy and O'Hagan 2001): a form is right only to a share of what it explains, which others can
// take.

/// Of any form, or between two that act alike on the same forces, such as two that smooth them.
constexpr double kFormError = 0.03;
/// Between forms whose difference is a moment or a place.
constexpr double kEventError = 0.1;
/// Of what has no one form: a zero that wanders, something that lasts, the strongest of several causes at once.
constexpr double kBroadError = 0.2;

// Deviations.

/// A number is known to differ from another.
constexpr double kDeviations = 3.0;
/// It differs for certain, whatever the model leaves out; times the usual size, or what something else explains.
constexpr double kStandsOut = 5.0;

// Shares and counts in words.

constexpr double kTinyShare = 0.05, kSmallShare = 0.1, kMinorShare = 0.2, kThird = 0.3, kMajority = 0.5,
                 kLargeShare = 0.8, kNearlyAll = 0.9, kNearlyWhole = 0.95;
/// Too little to be told, or to be told from nothing.
constexpr double kHardlyAny = 0.01;
/// Times the usual power: more than noise varies; what noise never reaches.
constexpr double kLoudPower = 2.0, kLoud = 7.0, kFarOut = 50.0;
/// As often, it is no chance.
constexpr std::size_t kAgainAndAgain = 3;
/// As often, it is a pattern.
constexpr std::size_t kPattern = 5;
/// As few have no usual value.
constexpr std::ptrdiff_t kFewestSamples = 20;

/// Causes, ties or touches that nobody has at once: crutches for something unknown. Masses that swing, at most.
constexpr std::ptrdiff_t kOverfitted = 4, kMasses = 2;

// Time and place.

/// [s] What happens within this happens at one moment; the same in blocks, of which a second has 50.
constexpr double kMoment = 0.1;
constexpr auto kMomentBlocks = static_cast<std::ptrdiff_t>(kMoment * 50);
static_assert(kMomentBlocks == 5);
/// [s] A knock lasts no longer, what a blow sets ringing has died away, the next event is another one; what lasts no
/// longer than the last is brief.
constexpr double kEvent = 0.3, kBriefly = 3.0;
/// [s] Shorter gaps in the rows are bridged: a tool hardly changes its acceleration meanwhile.
constexpr double kShortestGap = 0.015;
/// [s] Longer recordings are searched in parts; it is as much of them as one question is asked of.
constexpr double kLongRecording = 150.0;
/// [m] How far from the sensor a tool reaches that a hand guides.
constexpr double kToolReach = 0.5;
/// [m/s], [rad/s] What is slower stands still.
constexpr double kStillSpeed = 0.03, kStillTurning = 0.1;
/// [Hz] The softest mount; what swings slower is a part of the tool. The stiffest that shows.
constexpr double kSoftestMountHz = 11.0, kStiffestMountHz = 70.0;
/// A swing's frequency is not known better than to this share: no mount or part is a spring that is the same however
/// far it gives.
constexpr double kFrequencyError = 0.004;
/// [m] About where a hand holds a tool, from the sensor: as far, a force of 1 N is a torque of 0.1 N m.
constexpr double kGrip = 0.1;
/// [m] Places that are closer are the same.
constexpr double kSamePlace = 0.005;
/// [rad], [m] What motion is told to: robots report angles to a few thousandths of a degree at worst, trackers places
/// to a tenth of a millimetre; what is coarser or noisier is so for a cause.
constexpr double kFineMotion = 2e-4;

}  // namespace heft::diagnosis
