#pragma once
// What a solution is judged by, and what the user should know about it.
#include <algorithm>
#include <functional>

#include "core/estimation/estimate.h"
#include "core/estimation/prepare.h"
#include "core/estimation/solvers.h"

namespace heft {

/// Root mean squares of measured minus predicted wrench [N], [N m].
struct Residuals {
  double force = 0, torque = 0;
  Vector6d channels = Vector6d::Zero();
};

/// Over the samples of the used blocks, channels that say nothing left out of the means; each block is predicted by its
/// own solution (held-out checks).
Residuals residualsOver(const Prepared& prepared,
                        const std::function<const SolverSolution&(Eigen::Index block)>& solutionOf);

/// Scatter from one sample to the next, one a channel: a robust standard deviation of the steps (6 x N). What is slow,
/// such as a misfit, does not count.
Vector6d scatterOf(const Eigen::Matrix<double, 6, Eigen::Dynamic>& samples);

/// How far an estimate stays from readings that it has not seen, beside what the motion made of the payload.
struct Unseen {
  Vector6d left = Vector6d::Zero();   ///< Beyond noise, root mean square [N], [N m]
  Vector6d noise = Vector6d::Zero();  ///< Of averages over 80 ms, from how they scatter [N], [N m]
  Vector6d load = Vector6d::Zero();   ///< Standard deviation of the predicted wrench [N], [N m]
  double force = 0.0, torque = 0.0;   ///< The worst channel's `left` over the load of a channel of its kind
  /// The same of channels where it is more than the noise that was learned, and that the intervals count, leaves.
  double forceBeyond = 0.0, torqueBeyond = 0.0;
  double worst() const { return std::max(force, torque); }
};
Unseen unseenOver(const Prepared& prepared, const std::function<const SolverSolution&(Eigen::Index block)>& solutionOf);

/// Longest memory of a channel's noise that is taken for a sensor's: long-run over fast standard deviation.
constexpr double kMostMemory = 8.0;

/// Says where values that the user knows lie far outside the intervals of what was measured.
void compareWithKnown(const PartialPayload& known, EstimateReport& report);

/// What a finding doubts is not called measured. Comes after every finding that may doubt.
void doubtLabels(EstimateReport& report);

/// Says where a rigid tool does not explain the data, in numbers that need no statistics.
void judgeFit(const Prepared& prepared, const Residuals& heldout, const Unseen& unseen, EstimateReport& report);

/// What is not known, not physical or not usable.
void addFindings(EstimateReport& report);

/// What takes all trust from the numbers, and the next step.
struct NoTrust {
  std::string what, next;
};
void loseTrust(EstimateReport& report, const NoTrust& why);

/// Puts what was said when the file was read before the other findings: numbers that rest on a guess of the robot
/// deserve little trust.
void addReadingFindings(const Findings& read, EstimateReport& report);

/// Sets `trust` and what follows from it; comes last. Without trust no label is "data", and what the findings say about
/// numbers or about how to move is withheld: it would lead away from what is wrong.
void judgeTrust(const Unseen& unseen, EstimateReport& report);

}  // namespace heft
