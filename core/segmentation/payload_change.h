#pragma once
// Where the payload changed inside a recording: something was picked up or put down.
#include "core/segmentation/robust_fit.h"

namespace heft {

/// Windows [from, to) that carry one payload.
struct PayloadPart {
  std::size_t from = 0, to = 0;
  FitVector x = FitVector::Zero();  ///< Robust fit to its free windows.
  std::vector<std::size_t> free;    ///< Those windows.
};

/// Splits the windows where a step of the payload (mass and first moments) leaves less than 0.4 of the energy that one
/// payload leaves, less than half of what a drift of the biases leaves, and not much more than a step of the biases.
/// Recursive, so that picking up and putting down both count; a part is at least 2 s long. One part if nothing changed.
std::vector<PayloadPart> payloadParts(const FitWindows& windows, const std::vector<char>& usable,
                                      const FitPrior& prior);

/// Windows [from, to) as one part.
PayloadPart partOf(const FitWindows& windows, const std::vector<char>& usable, const FitPrior& prior, std::size_t from,
                   std::size_t to, int starts);

/// How two parts compare.
struct PayloadStep {
  bool same = true;       ///< One payload and bias explain both.
  bool payload = true;    ///< Clearly the payload; otherwise a step of the biases explains it nearly as well.
  double massStep = 0.0;  ///< [kg] mass of `b` less that of `a`
};
PayloadStep compareParts(const FitWindows& windows, const PayloadPart& a, const PayloadPart& b, const FitPrior& prior);

}  // namespace heft
