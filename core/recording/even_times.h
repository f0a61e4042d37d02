#pragma once
// How evenly samples are stamped, and whether they were measured more evenly than that.
#include <optional>
#include <vector>

#include "core/recording/recording.h"

namespace heft {

struct StampScatter {
  double off = 0.0;   ///< Standard deviation of the stamps about even ones, by what 9 of 10 keep [s]; 0: not known yet
  double step = 0.0;  ///< The even step [s]
};

/// Of the times between samples that follow each other [s], oldest first; 200 at least are needed. Lost samples are no
/// scatter where the other steps are even; a pause of more than a quarter of a second is none, and what lies before it
/// does not count. A clock that runs too fast or too slow is none.
StampScatter stampScatter(std::vector<double> steps);

/// How far the rows from `from` on lie off the cubic through their two neighbours on both sides, squared and
/// summed over all but the 5 % that are furthest off.
/// `time`: of each row, rising [s]; `motion`: what was measured then, a row each.
double roughness(const VectorXd& time, const MatrixXd& motion, Eigen::Index from = 0);

/// Of two times of the same rows those are believed that make the motion clearly smoother: whose roughness(), which is
/// a square, is below this share of the other's.
constexpr double kClearlySmoother = 0.25;

/// The rows' times where a source measured them at even steps and stamped them when it passed them on: a line through
/// the stamps of each stretch without gaps. Nothing where they are even anyway, where rows that were lost cannot be
/// told from late ones, or where the motion is no smoother then. `scatter`: how far the stamps lie off.
std::optional<VectorXd> evenTimes(const Recording& recording, StampScatter& scatter);

}  // namespace heft
