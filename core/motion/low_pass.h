#pragma once
// Zero-phase low-pass filtering and differentiation of uniformly sampled channels.
#include <vector>

#include "core/math/rigid.h"

namespace heft {

/// Samples in rows, channels in columns, row-major so that all channels of an instant are worked on together.
using Channels = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Second-order section b0 + b1 z^-1 + b2 z^-2 over 1 + a1 z^-1 + a2 z^-2.
struct Biquad {
  double b0, b1, b2, a1, a2;
};

/// Butterworth low-pass of even order by the bilinear transform, corner `cutoffHz` (-3 dB in one pass).
std::vector<Biquad> butterworthLowPass(int order, double cutoffHz, double rateHz);

/// Extends every channel at its ends by so many samples, mirrored through its end value (odd reflection), so that
/// filters start without a jump in value or slope.
Channels padded(const Channels& signal, Eigen::Index before, Eigen::Index after);
inline Channels padded(const Channels& signal, Eigen::Index pad) { return padded(signal, pad, pad); }

/// Runs the sections forward and backward over `signal` in place: no phase shift, |H|^2.
void filterForwardBackward(const std::vector<Biquad>& sections, Channels& signal);

/// Weights of the 2 `reach` + 1 samples about the middle one for its first (1) or second (2) derivative: central
/// differences of order 2 `reach`. With a reach of 4 the relative error is below 1e-4 up to a tenth of the sampling
/// rate.
VectorXd centralDifferenceKernel(int derivative, double rateHz, int reach = 4);

/// The weights that do what `a` and `b` do one after the other.
VectorXd convolved(const VectorXd& a, const VectorXd& b);

/// Weights of a centred average over `stride` sampling intervals: stride + 1 samples for an even stride (halves at the
/// ends), stride samples for an odd one. Sums to 1.
VectorXd averagingKernel(int stride);

}  // namespace heft
