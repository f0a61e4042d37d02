#pragma once
// How much evidence pure noise of this recording's own kind lends to the best of all causes.
#include "core/base/progress.h"
#include "core/diagnosis/search/scan.h"

namespace heft::diagnosis {

struct Surrogates {
  std::vector<double> best;  ///< Largest gain of evidence of each simulated clean recording, sorted
  /// max(10, 95th percentile of the largest gains).
  double threshold = 10.0;
  /// Share of the simulated recordings that lend at least this gain, never below 1 / (n + 1).
  double pValue(double gain) const;
};

/// `count` recordings with the fit's motion, payload and noise and nothing else, looked through with `bank`.
/// Deterministic for a seed.
Surrogates surrogates(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& fit,
                      const std::vector<Signature>& bank, int count, unsigned seed, const Progress& progress);

}  // namespace heft::diagnosis
