#pragma once
// What of a recorded position or velocity is motion and what is noise, told by its own spectrum.
#include "core/motion/low_pass.h"

namespace heft {

/// A Wiener filter without phase for each channel (Wiener 1949), gain 1 - N/S where the spectrum S of the recording
/// stands out of the white noise N under it and 0 elsewhere: keeps what a hand trembles at 10 Hz and drops the noise
/// between that and the guided motion, which no corner frequency does.
class Denoiser {
 public:
  /// `signal`: as sampled, uniform at `rateHz`. Where it is too short or too slow to tell noise from motion (below 8 s
  /// or 120 Hz), everything is kept.
  Denoiser(const Channels& signal, double rateHz);

  /// Filters channels of the same motion in place. What is beyond the lines at which noise is told is dropped.
  void apply(Channels& signal) const;

  /// The highest frequency that any channel keeps nearly whole [Hz]; infinite where everything is kept.
  double keptHz() const;

 private:
  double rateHz_;
  MatrixXd gains_;  ///< Channels x lines at 0, 1/T, 2/T, ..; empty: everything is kept
};

}  // namespace heft
