#pragma once
// How much evidence is enough, in units of twice the log-likelihood (Kass & Raftery 1995: 10 is very strong).
#include <cstddef>
#include <string_view>

namespace heft::diagnosis {

/// Gain of evidence (difference of BIC) that a cause needs at least to be part of the model.
constexpr double kThreshold = 10.0;

/// The same for one that is named. In 1400 recordings of four simulators that are not Heft's, the name was wrong each
/// of the nine times that it was less; right ones began at 23.
constexpr double kNamed = 20.0;

/// The same for a drift that takes any course. Noise that is slow takes some course, too: of 22 drifts that took any,
/// the faintest had 230; of three clean recordings with slow noise that had one, the strongest 160.
constexpr double kAnyCourse = 200.0;

/// Evidence within which two causes are equal.
constexpr double kTie = 10.0;

/// Evidence below which simplicity alone does not name a cause.
constexpr double kFaint = 50.0;

/// Causes that make a patchwork: of 640 recordings five had so many, and what was wrong with these was unknown.
constexpr std::ptrdiff_t kOverfitted = 4;

/// Masses that swing in one model at most; more are a patchwork, too.
constexpr std::ptrdiff_t kMasses = 2;

constexpr double kBesideRandomWalk =
    30.0;  ///< More evidence: what a few slow waves leave of a wandering zero is no cause
/// By how much a jump must be more than a walk of the zero: one that walks makes steps, too. Of 60 zeros that walked,
/// a jump was 21 less in the nearest; of 21 plain jumps it was 8 more in the nearest, of three faint ones 8 to 16 less.
constexpr double kJump = 5.0;

constexpr double kOfOneCourse = 0.5;  ///< Share of what the walk explains that a drift in its place must

/// Readings late or smoothed, or the recorded motion.
bool lags(std::string_view cause);

/// Makes fast forces larger than the motion says.
bool enlarges(std::string_view cause);

/// Whether a cause that goes on all the time and is no drift explains so much of what a walk of the zero does that it
/// is named instead. In 98 recordings whose zero walked, none came to half of it.
bool isMoreThanWalk(std::string_view cause, double gain, double walk);

constexpr std::size_t kRivals = 5;    ///< Causes that get a fit in the place of another
constexpr std::size_t kFinished = 4;  ///< Of these, how many are fitted to the end

}  // namespace heft::diagnosis
