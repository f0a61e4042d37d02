#pragma once
// What the residual of a good fit looks like: coloured, correlated between channels, now and then a spike.
#include <array>
#include <cmath>
#include <vector>

#include "core/estimation/linear_problem.h"
#include "core/math/statistics.h"
#include "core/wrench/rows.h"

namespace heft {

/// A contiguous run of blocks that are used: [from, to).
struct Run {
  Eigen::Index from = 0, to = 0;
};

/// One autoregressive model a channel and the correlation of their innovations.
struct NoiseModel {
  std::array<ArModel, 6> channels;
  Matrix6d whitener = Matrix6d::Identity();  ///< L^-1 with L L^T = covariance of the innovations of the six channels
  int order = 0;                             ///< Largest order; that many blocks of each run serve as start values.
};

/// Longest autoregressive memory that is tried [blocks].
constexpr int kMaxArOrder = 8;

/// What a fit has taken from the noise of each channel: 16 independent parts (columns), a row each block; their
/// products are the covariance of what the fitted parameters make of the rows.
using Taken = std::array<MatrixXd, 6>;

/// Fits to residuals (6 x K); `weights` (6 x K in 0..1) leave spikes out. `parameters` is the number of parameters that
/// the residual was fitted with, for the degrees of freedom; with `taken` the noise is that of the residual and of what
/// the fit took together, and they need not be counted. No channel's slow noise is taken to be below `least` [N, N m, a
/// row]: readings that stand still because the sensor's steps are coarse are not exact for it (roundingNoise()).
NoiseModel fitNoise(const Eigen::Matrix<double, 6, Eigen::Dynamic>& residual,
                    const Eigen::Matrix<double, 6, Eigen::Dynamic>& weights, const std::vector<Run>& runs,
                    int parameters, const Taken* taken = nullptr, const Vector6d& least = Vector6d::Zero());

/// Standard deviation that the innovations of `channel` need for slow noise as strong as white noise of `least`.
double leastInnovation(const ArModel& channel, double least);

/// A noise model with the robust weights of the innovations that it was learned with.
struct LearnedNoise {
  NoiseModel noise;
  Eigen::Matrix<double, 6, Eigen::Dynamic> weights;   ///< 0..1
  Eigen::Matrix<double, 6, Eigen::Dynamic> residual;  ///< That it was fitted to
};
/// What is known of the readings before anything is fitted.
struct KnownOfNoise {
  std::array<bool, 6> silent{};       ///< Channels that say nothing
  Vector6d least = Vector6d::Zero();  ///< As in fitNoise()
  bool keepAll = false;               ///< However far off, no row is left out of the noise model.
  /// The same of means of `stride` rows.
  KnownOfNoise at(int stride) const { return {silent, least / std::sqrt(static_cast<double>(stride)), keepAll}; }
};
/// Information about [bias, phi] in whitened rows (16 x 16) with a whisper of a prior's: enough to invert it, far too
/// little to count where the motion tells anything.
MatrixXd informationOf(const Triangle& whitened);

/// Fits payload, noise and weights in turn.
LearnedNoise learnedNoise(const WrenchRows& rows, const std::vector<Run>& runs, const KnownOfNoise& known);

/// Further rounds in which each channel gets back what the fit has taken from its noise, where in the spectrum it was
/// taken (the expectation step of Dempster, Laird and Rubin 1977; its fixed point is Patterson and Thompson's
/// restricted likelihood, 1971): a short recording's fit eats most of the slow noise, and what is left looks too quiet.
/// At the end the noise is scaled to the slow one (scaledToSlowNoise()).
LearnedNoise withTaken(LearnedNoise learned, const WrenchRows& rows, const std::vector<Run>& runs,
                       const KnownOfNoise& known);

/// The same with next to no weight on the channels that are `silent`.
NoiseModel without(const NoiseModel& noise, const std::array<bool, 6>& silent);

/// Innovations of the residual, whitened: standard normal if the model is right. Columns before a run's memory is full
/// are zero.
Eigen::Matrix<double, 6, Eigen::Dynamic> innovations(const NoiseModel& noise,
                                                     const Eigen::Matrix<double, 6, Eigen::Dynamic>& residual,
                                                     const std::vector<Run>& runs);

/// All six rows of a block as [bias | Y | y], white and weighted.
using WhiteRows = Eigen::Matrix<double, 6, kColumns + 1>;

/// The autoregressive filter of a noise model and its whitener, for rows [bias | Y | y]: the biases' columns are the
/// identity in every block, so only the others are filtered.
class RowWhitener {
 public:
  explicit RowWhitener(const NoiseModel& noise);
  int order() const { return static_cast<int>(lags_.size()); }
  /// Innovations of [bias | Y] at block k, not yet whitened; order() blocks of the same run lie before it.
  Eigen::Matrix<double, 6, kColumns> innovations(const WrenchRows& rows, Eigen::Index k) const;
  /// White rows of block k, each times the root of its weight.
  WhiteRows white(const WrenchRows& rows, Eigen::Index k, const Vector6d& weights) const;

 private:
  Regressor filtered(const WrenchRows& rows, Eigen::Index k) const;
  std::vector<Vector6d> lags_;  ///< Coefficients of the six channels, one vector a lag
  Vector6d atRest_;             ///< What the filter leaves of a constant
  Matrix6d whitener_, whiteBias_;
};

/// Whitened rows of the given runs as triangles, one for each of `folds` consecutive parts (for held-out checks); their
/// merger is the whole problem. `weights` are those of the innovations (robust fit).
std::vector<Triangle> whitenedTriangles(const WrenchRows& rows, const NoiseModel& noise,
                                        const Eigen::Matrix<double, 6, Eigen::Dynamic>& weights,
                                        const std::vector<Run>& runs, int folds);

/// The noise model with each channel's memory shortened until slow noise is at most `kLargestGain` times stronger than
/// the fast one. Whitening by a near unit root would throw away the slow band, where gravity tells most, and trust the
/// fast one, where a delay or noisy accelerations tell lies: what looks like such noise is mostly misfit.
constexpr double kLargestGain = 2.5;
NoiseModel bounded(const NoiseModel& noise);

/// The score equations of rows whitened by `weighting`, with the covariance of their error under the noise that was
/// found.
struct ScoreEquations {
  Triangle whitened;  ///< The rows as they are weighted, merged
  /// Of the error of whitened.leftCols<16>()^T whitened.col(16)
  Eigen::Matrix<double, kColumns, kColumns> covariance = Eigen::Matrix<double, kColumns, kColumns>::Zero();
};
ScoreEquations scoreEquations(const WrenchRows& rows, const NoiseModel& noise, const NoiseModel& weighting,
                              const Eigen::Matrix<double, 6, Eigen::Dynamic>& weights, const std::vector<Run>& runs);

/// Least squares of rows whitened by `weighting`, judged by the noise that was found: score equations H x = g whose
/// error has the covariance M. Returned as a triangle R with R^T R = H M^-1 H, so that a fit to R has honest variances;
/// where both models agree it is the merged whitened triangle itself. `motionNoise` is taken off the payload's part of
/// H, and `more` is added to M.
Triangle honestTriangle(const ScoreEquations& scoresOfRows, const Matrix10d& motionNoise = Matrix10d::Zero(),
                        const Matrix10d& more = Matrix10d::Zero());
Triangle honestTriangle(const WrenchRows& rows, const NoiseModel& noise, const NoiseModel& weighting,
                        const Eigen::Matrix<double, 6, Eigen::Dynamic>& weights, const std::vector<Run>& runs);

/// Covariance of A^T W e for the found noise e, when A are the unwhitened rows of the runs (16 x 16) and W the
/// channels' row weights: the middle of the sandwich for estimators that ignore the noise's colour.
Eigen::Matrix<double, kColumns, kColumns> scoreCovariance(const WrenchRows& rows, const NoiseModel& noise,
                                                          const Vector6d& channelWeights, const std::vector<Run>& runs);

}  // namespace heft
