#pragma once
// Savitzky-Golay smoothing and differentiation: least-squares polynomials over a sliding window (Savitzky, Golay 1964).
#include "core/motion/low_pass.h"

namespace heft {

/// Filters for one window and polynomial order; any derivative up to the order.
class SavitzkyGolay {
 public:
  /// `window` samples (an even one is widened by one so that it has a centre), polynomial `order` < window.
  /// Throws std::invalid_argument with the values otherwise.
  SavitzkyGolay(int order, int window);

  int window() const { return window_; }
  int order() const { return order_; }

  /// Weights of the window's samples for the `derivative`-th derivative at `offset` samples from the window's centre
  /// (0: the usual filter; +-half: at the ends). In units of samples: multiply by rate^derivative.
  VectorXd weights(int derivative, int offset = 0) const;

  /// Derivative of every channel; the first and last half window are evaluated on the polynomial of the first and last
  /// full window. Needs at least `window` rows (throws std::invalid_argument).
  Channels apply(const Channels& signal, int derivative, double rateHz) const;

 private:
  int order_;
  int window_;
  MatrixXd projection_;  ///< (order + 1) x window: polynomial coefficients from samples.
};

}  // namespace heft
