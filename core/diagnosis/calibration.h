#pragma once
// What the diagnosis was calibrated with: every number that several of its rules share, by meaning. A number that one
// rule alone has stands with that rule.
//
// Units: evidence is twice the natural logarithm of a Bayes factor; shares are of 1. Names of numbers that are only a
// size of an array, a unit or a limit to how long a computation runs are no calibration and stand where they are used.
//
// How these are recounted: `diagnosis_study write FOLDER 20 SEED`, `diagnosis_answers.sh`, `diagnosis_study score FOLDER`
// (tests/benchmarks/README.md). Seeds up to 99 are for training; 515151, 97201 and those above are held out: they are
// scored by class, and no single recording of them is looked at.
#include <cstddef>

namespace heft::diagnosis {

// Evidence. Kass and Raftery (1995): 6 is strong, above 10 very strong. The steps above that are not about chance, which
// 10 excludes, but about models that are all a little wrong: how much an imperfect model of something else may gain.

/// A cause is part of the model from here on: very strong.
constexpr double kThreshold = 10.0;
/// Two explanations that differ by less are tied.
constexpr double kTie = 10.0;
/// Twice very strong: a cause is named, and what needs more doubt than others is believed.
constexpr double kNamed = 20.0;
/// What a form needs beyond others because things are seldom like that, or because it takes a little of anything.
constexpr double kUnusual = 20.0;
/// One explanation is clearly better than another that was taken first; also beside a zero that wanders, whose waves
/// leave a little of anything.
constexpr double kClearly = 30.0;
/// Below this, simplicity alone names no cause.
constexpr double kFaint = 50.0;
/// What nobody would call noise, though no cause has its form.
constexpr double kPlain = 60.0;
/// For a drift that takes any course: noise that is slow takes some course, too.
constexpr double kAnyCourse = 200.0;
/// What no imperfect model of something else gains.
constexpr double kOverwhelming = 300.0;
/// Given to what is seen without comparing likelihoods.
constexpr double kSeen = 1e3;
/// Given to what is ruled out.
constexpr double kNever = 1e9;
/// The flexible dictionary must gain this for something unknown to be left: the 99.9 % quantile of what it gains in
/// noise of the residual's own colour (residual_analysis/structure.cpp draws it).
constexpr double kUnexplained = 18.5;
/// Below this, twice the log-likelihood sets no two explanations apart.
constexpr double kSame = 4.0;

// Model discrepancy (Kennedy and O'Hagan 2001): a form is right only to a share of what it explains, which others can
// take.

/// Of any form.
constexpr double kFormError = 0.03;
/// Between forms that act alike on the same forces, such as two that smooth them.
constexpr double kTwinError = 0.05;
/// Between forms whose difference is a moment or a place.
constexpr double kEventError = 0.1;

// Deviations.

/// A number is known to differ from another.
constexpr double kDeviations = 3.0;
/// It differs for certain, whatever the model leaves out.
constexpr double kManyDeviations = 5.0;

// Shares and counts in words.

constexpr double kHardlyAny = 0.05, kLittle = 0.1, kSome = 0.25, kMajority = 0.5, kMost = 0.8, kNearlyAll = 0.95;
/// As often, it is no chance.
constexpr std::size_t kAgainAndAgain = 3;

// Time and place.

/// [s] What happens within this happens at one moment; blocks are 20 ms.
constexpr double kMoment = 0.1;
constexpr std::ptrdiff_t kMomentBlocks = 5;
/// [s] From one event to the next.
constexpr double kApart = 0.3;
/// [s] Shorter gaps in the rows are bridged: a tool hardly changes its acceleration meanwhile.
constexpr double kShortestGap = 0.015;
/// [m] How far from the sensor a tool reaches that a hand guides.
constexpr double kReach = 0.5;
/// [m/s], [rad/s] What is slower stands still.
constexpr double kStill = 0.03, kStillTurning = 0.1;
/// [Hz] The softest mount; what swings slower is a part of the tool.
constexpr double kSoftestMountHz = 11.0;

}  // namespace heft::diagnosis
