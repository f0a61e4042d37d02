#pragma once
// How often 95 % intervals hold the truth, over simulated recordings of random tools.
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
  EstimateOptions estimate;
};

struct CoverageResult {
  int recordings = 0, failed = 0, unphysical = 0;
  /// Share of intervals that hold the truth: all of a group's numbers counted alike.
  double mass = 0, com = 0, inertia = 0;
  /// Medians of the relative errors (seed paper's equation; inertia about the sensor's origin and the centre of mass).
  double massError = 0, comError = 0, inertiaOriginError = 0, inertiaComError = 0;
  /// Root mean square of error over standard deviation: 1 if honest.
  double massRatio = 0, comRatio = 0, inertiaRatio = 0;
  double seconds = 0;  ///< Mean time of one estimate.
};

/// Runs on `threads` threads; the result does not depend on their number.
CoverageResult measureCoverage(const CoverageOptions& options, int threads);

}  // namespace heft::test
