#include "core/estimation/noise_model.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/estimation/noise_certainty.h"
#include "core/estimation/triangle.h"
#include "core/math/linear_algebra.h"

namespace heft {

namespace {

using Wrenches = Eigen::Matrix<double, 6, Eigen::Dynamic>;

/// White and coloured noise together need an order more than BIC sees in twenty seconds: without it the slow torque
/// noise, against which the inertia is measured, comes out some 5 % too weak.
constexpr int kBeyondBic = 1;

/// Coefficients of the six channels, one vector a lag: what a filter of blocks multiplies with.
std::vector<Vector6d> lagsOf(const NoiseModel& noise) {
  std::vector<Vector6d> lags(static_cast<std::size_t>(noise.order), Vector6d::Zero());
  for (int c = 0; c < 6; ++c) {
    const ArModel& model = noise.channels[static_cast<std::size_t>(c)];
    for (int i = 0; i < model.order(); ++i) lags[static_cast<std::size_t>(i)](c) = model.coefficients(i);
  }
  return lags;
}

/// Standard deviations of [bias, phi] before the data, in N, N m, kg, kg m, kg m2: far above any tool's.
VectorXd whisper() {
  VectorXd sd(kColumns);
  sd << VectorXd::Constant(6, 1e4), 30.0, VectorXd::Constant(3, 3.0), VectorXd::Constant(6, 1.0);
  return sd;
}

/// What the fit of `whitened` takes from the noise of the rows.
Taken takenBy(const Triangle& whitened, const WrenchRows& rows) {
  // information = L L^T, its inverse L^-T L^-1: rows x L^-T.
  const MatrixXd L = choleskyFactor(informationOf(whitened));
  const MatrixXd back = L.triangularView<Eigen::Lower>().solve(MatrixXd::Identity(kColumns, kColumns)).transpose();
  Taken out;
  parallelFor(out.size(), [&](std::size_t channel) {
    const auto c = static_cast<Eigen::Index>(channel);
    Eigen::Matrix<double, Eigen::Dynamic, 10> Y(rows.size(), 10);
    for (Eigen::Index k = 0; k < rows.size(); ++k) Y.row(k) = rows.Y[static_cast<std::size_t>(k)].row(c);
    MatrixXd& z = out[channel];
    z = product(Y, back.bottomRows<10>());
    z.rowwise() += back.row(c);
  });
  return out;
}

/// The blocks' residual under a linear fit with a whisper of prior information: enough to keep what the motion does not
/// excite near zero, far too little to bend what it does.
Wrenches noiseResidualOf(const WrenchRows& blocks, const Triangle& whitened) {
  MatrixXd A(2 * kColumns + 1, kColumns);
  VectorXd y = VectorXd::Zero(2 * kColumns + 1);
  A.topRows<kColumns + 1>() = whitened.leftCols<kColumns>();
  y.head<kColumns + 1>() = whitened.col(kColumns);
  A.bottomRows<kColumns>() = whisper().cwiseInverse().asDiagonal();
  const VectorXd x = leastSquares(A, y).x;
  Wrenches residual(6, blocks.size());
  for (Eigen::Index k = 0; k < blocks.size(); ++k)
    residual.col(k) = blocks.wrench.col(k) - x.head<6>() - blocks.Y[static_cast<std::size_t>(k)] * x.tail<10>();
  return residual;
}

/// A noise model to begin with: white, with forces a hundred times noisier than torques in SI units.
NoiseModel firstGuess() {
  NoiseModel noise;
  Vector6d whitener;
  whitener << Vector3d::Constant(10.0), Vector3d::Constant(500.0);
  noise.whitener = whitener.asDiagonal();
  return noise;
}

}  // namespace

MatrixXd informationOf(const Triangle& whitened) {
  const MatrixXd R = whitened.leftCols<kColumns>();
  MatrixXd information = transposedProduct(R, R);
  information.diagonal() += whisper().cwiseAbs2().cwiseInverse();
  return information;
}

double leastInnovation(const ArModel& channel, double least) { return least / std::max(1.0, channel.gain()); }

NoiseModel fitNoise(const Wrenches& residual, const Wrenches& weights, const std::vector<Run>& runs, int parameters,
                    const Taken* taken, const Vector6d& least) {
  NoiseModel noise;
  double used = 0.0, independent = 0.0, estimated = taken ? 0.0 : parameters;
  std::vector<AutoCovariance> sums(6, AutoCovariance(kMaxArOrder));
  parallelFor(sums.size(), [&](std::size_t channel) {
    const auto c = static_cast<Eigen::Index>(channel);
    for (const auto& run : runs) {
      const VectorXd weight = weights.row(c).segment(run.from, run.to - run.from).transpose();
      sums[channel].add(residual.row(c).segment(run.from, run.to - run.from).transpose(), weight);
      for (Eigen::Index i = 0; taken && i < kColumns; ++i)
        sums[channel].addTaken((*taken)[channel].col(i).segment(run.from, run.to - run.from), weight);
    }
    noise.channels[channel] = sums[channel].fit(kBeyondBic);
  });
  for (std::size_t c = 0; c < sums.size(); ++c) {
    const ArModel& channel = noise.channels[c];
    noise.order = std::max(noise.order, channel.order());
    used += sums[c].count();
    // Slow noise repeats itself: as far as the slow band goes, so many samples of a channel are worth one.
    independent += sums[c].count() / std::max(1.0, channel.gain() * channel.gain());
    estimated += channel.order();
  }
  // The fitted parameters took their share of the residual's energy, and the noise model is itself only an estimate:
  // Akaike's final prediction error, with the number of independent samples.
  independent = std::max(independent, 3.0 * estimated);
  const double freedom = used > 0.0 ? (independent + estimated) / (independent - estimated) : 1.0;
  Matrix6d covariance = Matrix6d::Zero();
  double count = 0.0;
  for (const auto& run : runs) {
    const Eigen::Index n = run.to - run.from - noise.order;
    if (n <= 0) continue;
    Eigen::Matrix<double, Eigen::Dynamic, 6> errors(n, 6);  // Innovations, one channel a column
    const auto addInnovations = [&](const auto& signalOf) {
      for (int c = 0; c < 6; ++c) {
        const ArModel& model = noise.channels[static_cast<std::size_t>(c)];
        const auto signal = signalOf(c);
        errors.col(c) = signal.segment(run.from + noise.order, n);
        for (int i = 0; i < model.order(); ++i)
          errors.col(c) -= model.coefficients(i) * signal.segment(run.from + noise.order - 1 - i, n);
        errors.col(c).array() *= weights.row(c).segment(run.from + noise.order, n).transpose().array();
      }
      covariance.noalias() += errors.transpose() * errors;
    };
    addInnovations([&](int c) { return residual.row(c).transpose(); });
    for (Eigen::Index i = 0; taken && i < kColumns; ++i)
      addInnovations([&](int c) { return (*taken)[static_cast<std::size_t>(c)].col(i); });
    count += static_cast<double>(n);
  }
  covariance *= freedom / std::max(1.0, count);
  // Correlations need many samples; with few the channels are taken as independent.
  Vector6d variance = covariance.diagonal().cwiseMax(Vector6d::Constant(1e-16));
  for (int c = 0; c < 6; ++c) {
    const double slowest = leastInnovation(noise.channels[static_cast<std::size_t>(c)], least(c));
    variance(c) = std::max(variance(c), slowest * slowest);
  }
  covariance *= count / (count + 60.0);
  covariance.diagonal() = variance;
  for (int c = 0; c < 6; ++c) noise.channels[static_cast<std::size_t>(c)].sigma = std::sqrt(variance(c));
  noise.whitener = whitenerOf(covariance);
  return noise;
}

namespace {

/// One round of fitting payload, noise and weights; the rows that `keep` zero are left out of the noise.
void learnRound(LearnedNoise& out, Wrenches& keep, const WrenchRows& rows, const std::vector<Run>& runs,
                const KnownOfNoise& known, bool withTaken) {
  // The bounded model weights the fit from which the next noise model is learned, as it will weight the last one.
  const auto whitened = merged(whitenedTriangles(rows, bounded(out.noise), out.weights, runs, 1));
  out.residual = noiseResidualOf(rows, whitened);
  if (withTaken) {
    const Taken taken = takenBy(whitened, rows);
    out.noise = fitNoise(out.residual, keep, runs, kColumns, &taken, known.least);
  } else {
    out.noise = fitNoise(out.residual, keep, runs, kColumns, nullptr, known.least);
  }
  if (std::ranges::find(known.silent, true) != known.silent.end()) out.noise = without(out.noise, known.silent);
  const Wrenches u = innovations(out.noise, out.residual, runs);
  // Huber weights: beyond three standard deviations an innovation counts with its sign only. What lies beyond five is
  // no part of the noise and leaves the noise model.
  out.weights = u.unaryExpr([](double e) { return std::abs(e) > 3.0 ? 3.0 / std::abs(e) : 1.0; });
  if (!known.keepAll) keep = u.unaryExpr([](double e) { return std::abs(e) > 5.0 ? 0.0 : 1.0; });
}

}  // namespace

LearnedNoise learnedNoise(const WrenchRows& rows, const std::vector<Run>& runs, const KnownOfNoise& known) {
  constexpr int kRounds = 4;
  LearnedNoise out;
  out.noise = firstGuess();
  out.weights = Wrenches::Ones(6, rows.size());
  Wrenches keep = out.weights;
  for (int round = 0; round < kRounds; ++round) learnRound(out, keep, rows, runs, known, false);
  return out;
}

LearnedNoise withTaken(LearnedNoise learned, const WrenchRows& rows, const std::vector<Run>& runs,
                       const KnownOfNoise& known) {
  constexpr int kRounds = 2;
  Wrenches keep = learned.weights.unaryExpr([&](double w) { return !known.keepAll && w < 3.0 / 5.0 ? 0.0 : 1.0; });
  for (int round = 0; round < kRounds; ++round) learnRound(learned, keep, rows, runs, known, true);
  learned.noise = scaledToSlowNoise(std::move(learned.noise), rows, learned.weights, runs, known);
  return learned;
}

NoiseModel without(const NoiseModel& noise, const std::array<bool, 6>& silent) {
  constexpr double kHuge = 1e4;  // [N, N m]
  NoiseModel out = noise;
  const Matrix6d L = inverse(noise.whitener);
  Matrix6d covariance = L * L.transpose();
  for (Eigen::Index c = 0; c < 6; ++c) {
    if (!silent[static_cast<std::size_t>(c)]) continue;
    covariance.row(c).setZero();
    covariance.col(c).setZero();
    covariance(c, c) = kHuge * kHuge;
    ArModel& channel = out.channels[static_cast<std::size_t>(c)];
    channel.coefficients.setZero();
    channel.sigma = kHuge;
  }
  out.whitener = whitenerOf(covariance);
  return out;
}

Wrenches innovations(const NoiseModel& noise, const Wrenches& residual, const std::vector<Run>& runs) {
  Wrenches out = Wrenches::Zero(6, residual.cols());
  const std::vector<Vector6d> lags = lagsOf(noise);
  for (const auto& run : runs)
    for (Eigen::Index k = run.from + noise.order; k < run.to; ++k) {
      Vector6d e = residual.col(k);
      for (std::size_t i = 0; i < lags.size(); ++i)
        e -= lags[i].cwiseProduct(residual.col(k - 1 - static_cast<Eigen::Index>(i)));
      out.col(k) = noise.whitener * e;
    }
  return out;
}

RowWhitener::RowWhitener(const NoiseModel& noise)
    : lags_(lagsOf(noise)), atRest_(Vector6d::Ones()), whitener_(noise.whitener) {
  for (const auto& lag : lags_) atRest_ -= lag;
  whiteBias_ = whitener_ * atRest_.asDiagonal();
}

Regressor RowWhitener::filtered(const WrenchRows& rows, Eigen::Index k) const {
  Regressor out = rows.Y[static_cast<std::size_t>(k)];
  for (std::size_t i = 0; i < lags_.size(); ++i)
    out.noalias() -= lags_[i].asDiagonal() * rows.Y[static_cast<std::size_t>(k) - 1 - i];
  return out;
}

Eigen::Matrix<double, 6, kColumns> RowWhitener::innovations(const WrenchRows& rows, Eigen::Index k) const {
  Eigen::Matrix<double, 6, kColumns> out;
  out.leftCols<6>() = atRest_.asDiagonal();
  out.rightCols<10>() = filtered(rows, k);
  return out;
}

WhiteRows RowWhitener::white(const WrenchRows& rows, Eigen::Index k, const Vector6d& weights) const {
  Vector6d y = rows.wrench.col(k);
  for (std::size_t i = 0; i < lags_.size(); ++i)
    y -= lags_[i].cwiseProduct(rows.wrench.col(k - 1 - static_cast<Eigen::Index>(i)));
  const Vector6d root = weights.cwiseSqrt();
  const Matrix6d whitener = root.asDiagonal() * whitener_;
  const Regressor Y = filtered(rows, k);
  WhiteRows out;
  out.leftCols<6>() = root.asDiagonal() * whiteBias_;
  out.middleCols<10>(6) = whitener.lazyProduct(Y);
  out.col(kColumns) = whitener * y;
  return out;
}

std::vector<Triangle> whitenedTriangles(const WrenchRows& rows, const NoiseModel& noise, const Wrenches& weights,
                                        const std::vector<Run>& runs, int folds) {
  constexpr Eigen::Index kPiece = 8192;  // Blocks that one thread takes at once
  Eigen::Index total = 0;
  for (const auto& run : runs) total += std::max<Eigen::Index>(0, run.to - run.from - noise.order);
  std::vector<Eigen::Index> blocks;
  blocks.reserve(static_cast<std::size_t>(total));
  for (const auto& run : runs)
    for (Eigen::Index k = run.from + noise.order; k < run.to; ++k) blocks.push_back(k);
  const auto foldBegin = [&](Eigen::Index fold) { return (fold * total + folds - 1) / folds; };
  std::vector<Run> pieces;  // Of `blocks`, each within one fold
  std::vector<std::size_t> foldOf;
  for (Eigen::Index fold = 0; fold < folds; ++fold)
    for (Eigen::Index from = foldBegin(fold), end = foldBegin(fold + 1); from < end; from += kPiece) {
      pieces.push_back({from, std::min(end, from + kPiece)});
      foldOf.push_back(static_cast<std::size_t>(fold));
    }
  std::vector<Triangle> ofPieces(pieces.size());
  const RowWhitener whitener(noise);
  parallelFor(pieces.size(), [&](std::size_t i) {
    TriangleBuilder builder;
    for (Eigen::Index at = pieces[i].from; at < pieces[i].to; ++at) {
      const Eigen::Index k = blocks[static_cast<std::size_t>(at)];
      builder.add(whitener.white(rows, k, weights.col(k)));
    }
    ofPieces[i] = builder.finish();
  });
  std::vector<std::vector<Triangle>> ofFolds(static_cast<std::size_t>(folds));
  for (std::size_t i = 0; i < pieces.size(); ++i) ofFolds[foldOf[i]].push_back(ofPieces[i]);
  std::vector<Triangle> triangles;
  for (const auto& each : ofFolds) triangles.push_back(each.size() == 1 ? each.front() : merged(each));
  return triangles;
}

NoiseModel bounded(const NoiseModel& noise) {
  NoiseModel out = noise;
  for (auto& channel : out.channels) {
    const auto shortened = [&channel](double factor) {
      ArModel model = channel;
      double power = 1.0;
      for (Eigen::Index i = 0; i < model.coefficients.size(); ++i) model.coefficients(i) *= (power *= factor);
      return model;
    };
    const auto tooSlow = [](const ArModel& model) { return !(model.gain() > 0.0 && model.gain() <= kLargestGain); };
    if (!tooSlow(channel)) continue;
    double low = 0.0, high = 1.0;
    for (int i = 0; i < 40; ++i) (tooSlow(shortened(0.5 * (low + high))) ? high : low) = 0.5 * (low + high);
    channel = shortened(low);
  }
  return out;
}

ScoreEquations scoreEquations(const WrenchRows& rows, const NoiseModel& noise, const NoiseModel& weighting,
                              const Wrenches& weights, const std::vector<Run>& runs) {
  ScoreEquations out;
  out.whitened = merged(whitenedTriangles(rows, weighting, weights, runs, 1));
  // With z = Wt Fb F^-1 L u (u white; F, Fb the autoregressive filters of noise and weighting, Wt = L^-1 the whitener)
  // the scores are sum_k A_k^T w z_k, so their covariance is that of the rows sent backwards through the same filters.
  using Six = Eigen::Matrix<double, 6, kColumns>;
  const Matrix6d L = inverse(noise.whitener);
  const RowWhitener whitener(weighting);
  const std::vector<Vector6d> used = lagsOf(weighting), found = lagsOf(noise);
  const std::size_t lags = std::max(used.size(), found.size());
  Eigen::Matrix<double, Eigen::Dynamic, kColumns> chunk(120, kColumns);
  Eigen::Index filled = 0;
  const auto addUp = [&] {
    out.covariance.noalias() += chunk.topRows(filled).transpose() * chunk.topRows(filled);
    filled = 0;
  };
  // Of the blocks after this one, in rings: `newest` is where that of the block right after it lies.
  std::vector<Six> later(lags), filteredLater(lags);
  std::size_t newest = 0;
  for (const auto& run : runs) {
    if (run.to - run.from <= weighting.order) continue;
    std::ranges::fill(later, Six::Zero());
    std::ranges::fill(filteredLater, Six::Zero());
    for (Eigen::Index k = run.to - 1; k >= run.from; --k) {
      Six back = Six::Zero();
      if (k >= run.from + weighting.order) {
        const Matrix6d middle = weighting.whitener.transpose() * weights.col(k).asDiagonal() * weighting.whitener;
        back = middle.lazyProduct(whitener.innovations(rows, k));
      }
      Six G = back;
      for (std::size_t i = 0; i < used.size(); ++i) G.noalias() -= used[i].asDiagonal() * later[(newest + i) % lags];
      for (std::size_t i = 0; i < found.size(); ++i)
        G.noalias() += found[i].asDiagonal() * filteredLater[(newest + i) % lags];
      if (lags > 0) {
        newest = (newest + lags - 1) % lags;
        later[newest] = back;
        filteredLater[newest] = G;
      }
      chunk.middleRows<6>(filled) = L.transpose().lazyProduct(G);
      if ((filled += 6) == chunk.rows()) addUp();
    }
  }
  addUp();
  return out;
}

Triangle honestTriangle(const ScoreEquations& scoresOfRows, const Matrix10d& motionNoise, const Matrix10d& more) {
  const Triangle& plain = scoresOfRows.whitened;
  Eigen::Matrix<double, kColumns, kColumns> M = scoresOfRows.covariance;
  M.bottomRightCorner<10, 10>() += more;
  const Eigen::Matrix<double, kColumns, kColumns> A = plain.topLeftCorner<kColumns, kColumns>();
  const VectorXd scale = A.colwise().norm().transpose().cwiseMax(1e-12).cwiseInverse();
  const MatrixXd scaled = scale.asDiagonal() * M * scale.asDiagonal();
  const auto [values, vectors] = symmetricEigen(scaled);
  // Directions without any motion have neither score nor variance.
  const VectorXd inverseRoot = values.unaryExpr(
      [top = values.maxCoeff()](double value) { return value > 1e-11 * top ? 1.0 / std::sqrt(value) : 0.0; });
  const MatrixXd left = inverseRoot.asDiagonal() * vectors.transpose() * scale.asDiagonal();
  TriangleBuilder builder;
  MatrixXd scores = transposedProduct(A, plain.topRows<kColumns>());
  scores.block<10, 10>(kBiasColumns, kBiasColumns) -= motionNoise;
  const MatrixXd system = product(left, scores);
  builder.add(system);
  return builder.finish();
}

Triangle honestTriangle(const WrenchRows& rows, const NoiseModel& noise, const NoiseModel& weighting,
                        const Wrenches& weights, const std::vector<Run>& runs) {
  return honestTriangle(scoreEquations(rows, noise, weighting, weights, runs));
}

Eigen::Matrix<double, kColumns, kColumns> scoreCovariance(const WrenchRows& rows, const NoiseModel& noise,
                                                          const Vector6d& channelWeights,
                                                          const std::vector<Run>& runs) {
  // e = F u with F the autoregressive filter and u white: cov(A^T e) = (F^T A)^T (F^T A) sigma^2, and F^T runs
  // backwards in time. Correlations between channels are neglected here.
  Eigen::Matrix<double, kColumns, kColumns> sum = Eigen::Matrix<double, kColumns, kColumns>::Zero();
  for (int c = 0; c < 6; ++c) {
    const ArModel& model = noise.channels[static_cast<std::size_t>(c)];
    for (const auto& run : runs) {
      const Eigen::Index n = run.to - run.from;
      MatrixXd G(n, kColumns);
      for (Eigen::Index k = n - 1; k >= 0; --k) {
        G.row(k).setZero();
        G(k, c) = 1.0;
        G.row(k).segment<10>(6) = rows.Y[static_cast<std::size_t>(run.from + k)].row(c);
        for (int i = 0; i < model.order() && k + 1 + i < n; ++i) G.row(k) += model.coefficients(i) * G.row(k + 1 + i);
      }
      const double scale = model.sigma * channelWeights(c);
      sum += scale * scale * transposedProduct(G, G);
    }
  }
  return sum;
}

}  // namespace heft
