#pragma once
// How far a noise model is to be believed that was learned from the rows whose error it tells.
#include "core/estimation/noise_model.h"

namespace heft {

/// The noise model with its forces and its torques scaled to what is left over in windows as long as a hand's movement.
/// An autoregressive model is learned from all frequencies, most of which are faster than any hand: of slow noise under
/// a loud white one it sees little. So the sums of whitened residuals over windows are compared with what they would be
/// if the model were right, 1 - leverage each: restricted likelihood for one scale (Patterson and Thompson 1971, doi
/// 10.1093/biomet/58.3.545). `rows` and `weights` (6 x K) are those that `noise` was learned from; no
/// channel's slow noise comes below `known.least`.
NoiseModel scaledToSlowNoise(NoiseModel noise, const WrenchRows& rows,
                             const Eigen::Matrix<double, 6, Eigen::Dynamic>& weights, const std::vector<Run>& runs,
                             const KnownOfNoise& known);

/// How many times too small standard deviations come out because the noise is learned from few rows: a parametric
/// bootstrap (Efron and Tibshirani 1993, chapter 6). Noise of the model `noise` is drawn for the same motion, the noise
/// is learned from it as from the recording, and the payload's chi-squared under the learned model is compared with
/// that under the one it was drawn from. The mean of their ratio counts what the noise model's own parameters cost and
/// what the fit takes from the noise; its scatter makes the 95 % region of all ten numbers one of Fisher's F instead of
/// chi-squared. About 1 for a long recording. The same rows give the same number.
double shortfallOfLearning(const WrenchRows& rows, const NoiseModel& noise, const std::vector<Run>& runs,
                           const KnownOfNoise& known);

}  // namespace heft
