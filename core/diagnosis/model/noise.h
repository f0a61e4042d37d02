#pragma once
// What is left when a model is right: autoregressive noise in each channel, and how probable it makes a residual.
#include <array>
#include <memory>

#include "core/diagnosis/signals/signals.h"
#include "core/math/statistics.h"

namespace heft::diagnosis {

/// A stretch of usable blocks: [from, to).
struct Stretch {
  Eigen::Index from = 0, to = 0;
};

/// Stretches of at least 12 usable blocks.
std::vector<Stretch> stretchesOf(const std::vector<bool>& usable);

/// Root mean squares per component.
struct WrenchRms {
  double force = 0.0, torque = 0.0;  ///< [N], [N m]
};

/// Of the blocks in `stretches`; `residual` 6 x N.
WrenchRms rmsOf(const std::vector<Stretch>& stretches, const Wrenches& residual);

struct Noise {
  std::array<ArModel, 6> channels;               ///< Of what is left once all blocks are made equally loud
  std::shared_ptr<const NoiseScale> noiseScale;  ///< As Signals::noiseScale
  const NoiseScale::Level* level = nullptr;      ///< Of it that the residual shows; null: none
  /// Twice the log-likelihood of the residual it was fitted to, minus ln n for each coefficient of the noise.
  double evidence = 0.0;
  double samples = 0.0;  ///< n: numbers judged, all channels together
};

/// `noiseScale`: as Signals::noiseScale; how much of it there is, is learned, too.
Noise fitNoise(const Wrenches& residual, const std::vector<Stretch>& stretches,
               const std::shared_ptr<const NoiseScale>& noiseScale);

/// The same sizes without memory.
Noise white(const Wrenches& residual, const std::vector<Stretch>& stretches,
            const std::shared_ptr<const NoiseScale>& noiseScale);

/// Columns of 6N rows with all blocks made equally loud: what `noise.channels` are about.
MatrixXd even(const MatrixXd& columns, const Noise& noise);
/// The same of a wrench a block, 6 x N.
Wrenches evenWrench(const Wrenches& wrench, const Noise& noise);

using ByChannel = Eigen::Matrix<double, Eigen::Dynamic, 6>;  ///< A column a channel

/// 6 rows a block (row 6 n + channel) of the blocks from `first` on, by channel, all blocks made equally loud.
void evenByChannel(const Eigen::Ref<const VectorXd>& rows, const Noise& noise, Eigen::Index first, ByChannel& out);

/// Unit innovations of one channel, all blocks made equally loud: `x` is of the blocks from `first` on, `out` as long;
/// zero where nothing is judged.
void innovate(const Eigen::Ref<const VectorXd>& x, const Noise& noise, std::size_t channel,
              const std::vector<Stretch>& stretches, Eigen::Index first, Eigen::Ref<VectorXd> out);

/// The same of `count` values from `x` on, all of them judged, which as many as the noise remembers stand before.
void innovate(const double* x, const ArModel& noise, Eigen::Index count, double* out);

/// The transpose of innovate(), of all blocks, on `e`: what multiplies a channel's values, made equally loud, to the
/// product of their innovations with `e`.
VectorXd innovateTransposed(const Eigen::Ref<const VectorXd>& e, const Noise& noise, std::size_t channel,
                            const std::vector<Stretch>& stretches);

/// Columns of 6N rows (row 6 n + channel) turned into unit innovations; rows that are not judged become zero.
MatrixXd whitened(const MatrixXd& columns, const Noise& noise, const std::vector<Stretch>& stretches);

/// The blocks where innovations of columns that are zero outside of `acts` may differ from zero.
Stretch reachOf(Stretch acts, Eigen::Index blocks);
/// whitened() of rows of the blocks from `first` on alone: such columns' own and as many as the noise remembers.
MatrixXd whitened(const MatrixXd& rows, const Noise& noise, const std::vector<Stretch>& stretches, Eigen::Index first);

}  // namespace heft::diagnosis
