#pragma once
// How often 95 % intervals hold the truth, over simulated recordings of random tools.
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "core/estimation/estimate.h"
#include "core/simulation/simulate.h"

namespace heft::test {

struct CoverageOptions {
  MotionKind motion = MotionKind::free;
  int recordings = 300;
  unsigned seed = 1;
  double speed = 1.0;
  double duration = 20.0;
  bool shape = false;  ///< Give the tool's true bodies as a "good" shape.
  /// White noise of the sensor over that of the default one, 0.05 N and 0.002 N m.
  double noise = 1.0;
  double colour = 1.0;                                  ///< The same of the coloured noise
  double jointNoise = SimulateOptions{}.positionNoise;  ///< [rad]
  double jointStep = 0.0;                               ///< Of an encoder [rad]; 0: none
  bool velocities = true;                               ///< The controller's velocities are recorded
  /// Done to a recording before it is estimated; `random` is the recording's own.
  std::function<void(Recording&, std::mt19937& random)> alter;
  EstimateOptions estimate;
};

/// Intervals of one number or of a group of them.
struct CoverageOf {
  double inside = 0;  ///< Share that holds the truth, all of a group's numbers counted alike.
  double ratio = 0;   ///< Root mean square of error over standard deviation: 1 if honest.
  double width = 0;   ///< Median half width: over the mass, in mm, over the mean moment of inertia.
};

struct CoverageResult {
  int recordings = 0, failed = 0, unphysical = 0;
  CoverageOf mass, com, inertia;
  double joint = 0;              ///< Share of joint 95 % regions of all ten parameters that hold the truth.
  int claims = 0;                ///< Numbers that are labelled "data".
  int beyond4 = 0, beyond5 = 0;  ///< Of those, more than so many standard deviations off.
  double coverageOfClaims = 0;   ///< Share of their intervals that hold.
  /// Medians of the relative errors (seed paper's equation; inertia about the sensor's origin and the centre of mass).
  double massError = 0, comError = 0, inertiaOriginError = 0, inertiaComError = 0;
  double seconds = 0;  ///< Mean time of one estimate.
};

/// Runs on `threads` threads; the result does not depend on their number.
CoverageResult measureCoverage(const CoverageOptions& options, int threads);
/// Recordings of several kinds, counted together.
CoverageResult measureCoverage(const std::vector<CoverageOptions>& kinds, int threads);

}  // namespace heft::test
