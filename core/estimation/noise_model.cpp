#include "core/estimation/noise_model.h"

#include <algorithm>
#include <cmath>

#include "core/estimation/noise_certainty.h"
#include "core/math/linear_algebra.h"

namespace heft {

namespace {

using Wrenches = Eigen::Matrix<double, 6, Eigen::Dynamic>;

/// White and coloured noise together need an order more than BIC sees in twenty seconds: without it the slow torque
/// noise, against which the inertia is measured, comes out some 5 % too weak.
constexpr int kBeyondBic = 1;

/// Innovation of channel c at block k of a run that has enough blocks before it.
template <class Row>
auto predictionError(const ArModel& model, Eigen::Index k, const Row& at) {
  auto error = at(k);
  for (int i = 0; i < model.order(); ++i) error -= model.coefficients(i) * at(k - 1 - i);
  return error;
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
  for (int c = 0; c < 6; ++c) {
    MatrixXd& z = out[static_cast<std::size_t>(c)];
    z.resize(rows.size(), kColumns);
    for (Eigen::Index k = 0; k < rows.size(); ++k)
      z.row(k).noalias() = rows.Y[static_cast<std::size_t>(k)].row(c) * back.bottomRows<10>();
    z.rowwise() += back.row(c);
  }
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
  for (int c = 0; c < 6; ++c) {
    AutoCovariance sums(kMaxArOrder);
    for (const auto& run : runs) {
      const VectorXd weight = weights.row(c).segment(run.from, run.to - run.from).transpose();
      sums.add(residual.row(c).segment(run.from, run.to - run.from).transpose(), weight);
      for (Eigen::Index i = 0; taken && i < kColumns; ++i)
        sums.addTaken((*taken)[static_cast<std::size_t>(c)].col(i).segment(run.from, run.to - run.from), weight);
    }
    noise.channels[static_cast<std::size_t>(c)] = sums.fit(kBeyondBic);
    noise.order = std::max(noise.order, noise.channels[static_cast<std::size_t>(c)].order());
    const ArModel& channel = noise.channels[static_cast<std::size_t>(c)];
    used += sums.count();
    // Slow noise repeats itself: as far as the slow band goes, so many samples of a channel are worth one.
    independent += sums.count() / std::max(1.0, channel.gain() * channel.gain());
    estimated += channel.order();
  }
  // The fitted parameters took their share of the residual's energy, and the noise model is itself only an estimate:
  // Akaike's final prediction error, with the number of independent samples.
  independent = std::max(independent, 3.0 * estimated);
  const double freedom = used > 0.0 ? (independent + estimated) / (independent - estimated) : 1.0;
  Matrix6d covariance = Matrix6d::Zero();
  double count = 0.0;
  for (const auto& run : runs) {
    for (Eigen::Index k = run.from + noise.order; k < run.to; ++k) {
      Vector6d e;
      for (int c = 0; c < 6; ++c)
        e(c) = predictionError(noise.channels[static_cast<std::size_t>(c)], k,
                               [&](Eigen::Index j) { return residual(c, j); }) *
               weights(c, k);
      covariance += e * e.transpose();
      if (taken) {
        Eigen::Matrix<double, 6, kColumns> part;
        for (int c = 0; c < 6; ++c) {
          const MatrixXd& z = (*taken)[static_cast<std::size_t>(c)];
          const ArModel& model = noise.channels[static_cast<std::size_t>(c)];
          part.row(c) = z.row(k);
          for (int i = 0; i < model.order(); ++i) part.row(c) -= model.coefficients(i) * z.row(k - 1 - i);
          part.row(c) *= weights(c, k);
        }
        covariance += part * part.transpose();
      }
      count += 1.0;
    }
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
  for (const auto& run : runs)
    for (Eigen::Index k = run.from + noise.order; k < run.to; ++k) {
      Vector6d e;
      for (int c = 0; c < 6; ++c)
        e(c) = predictionError(noise.channels[static_cast<std::size_t>(c)], k,
                               [&](Eigen::Index j) { return residual(c, j); });
      out.col(k) = noise.whitener * e;
    }
  return out;
}

std::vector<WhiteRows> whitenedRows(const WrenchRows& rows, const NoiseModel& noise, const Wrenches& weights,
                                    const Run& run) {
  std::vector<WhiteRows> blocks, out;
  for (Eigen::Index k = run.from; k < run.to; ++k) blocks.push_back(blockRows(rows, k));
  WhiteRows E;
  for (Eigen::Index k = noise.order; k < run.to - run.from; ++k) {
    for (int c = 0; c < 6; ++c) {
      const ArModel& model = noise.channels[static_cast<std::size_t>(c)];
      E.row(c) = blocks[static_cast<std::size_t>(k)].row(c);
      for (int i = 0; i < model.order(); ++i)
        E.row(c) -= model.coefficients(i) * blocks[static_cast<std::size_t>(k - 1 - i)].row(c);
    }
    out.push_back(weights.col(run.from + k).cwiseSqrt().asDiagonal() * (noise.whitener * E));
  }
  return out;
}

std::vector<Triangle> whitenedTriangles(const WrenchRows& rows, const NoiseModel& noise, const Wrenches& weights,
                                        const std::vector<Run>& runs, int folds) {
  Eigen::Index total = 0;
  for (const auto& run : runs) total += std::max<Eigen::Index>(0, run.to - run.from - noise.order);
  std::vector<TriangleBuilder> builders(static_cast<std::size_t>(folds));
  Eigen::Index seen = 0;
  for (const auto& run : runs)
    for (const WhiteRows& white : whitenedRows(rows, noise, weights, run)) {
      auto& builder = builders[static_cast<std::size_t>(
          std::min<Eigen::Index>(folds - 1, seen * folds / std::max<Eigen::Index>(1, total)))];
      builder.add(white);
      ++seen;
    }
  std::vector<Triangle> triangles;
  for (auto& builder : builders) triangles.push_back(builder.finish());
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

Triangle honestTriangle(const WrenchRows& rows, const NoiseModel& noise, const NoiseModel& weighting,
                        const Wrenches& weights, const std::vector<Run>& runs, const Matrix10d& motionNoise,
                        const Matrix10d& more) {
  const Triangle plain = merged(whitenedTriangles(rows, weighting, weights, runs, 1));
  // With z = Wt Fb F^-1 L u (u white; F, Fb the autoregressive filters of noise and weighting, Wt = L^-1 the whitener)
  // the scores are sum_k A_k^T w z_k, so their covariance is that of the rows sent backwards through the same filters.
  const Matrix6d L = inverse(noise.whitener);
  Eigen::Matrix<double, kColumns, kColumns> M = Eigen::Matrix<double, kColumns, kColumns>::Zero();
  for (const auto& run : runs) {
    const Eigen::Index n = run.to - run.from;
    if (n <= weighting.order) continue;
    std::array<MatrixXd, 6> B;
    for (auto& channel : B) channel = MatrixXd::Zero(n, kColumns);
    std::vector<Eigen::Matrix<double, 6, kColumns + 1>> blocks;
    for (Eigen::Index k = run.from; k < run.to; ++k) blocks.push_back(blockRows(rows, k));
    Eigen::Matrix<double, 6, kColumns> E;
    for (Eigen::Index k = weighting.order; k < n; ++k) {
      for (int c = 0; c < 6; ++c) {
        const ArModel& model = weighting.channels[static_cast<std::size_t>(c)];
        E.row(c) = blocks[static_cast<std::size_t>(k)].row(c).head<kColumns>();
        for (int i = 0; i < model.order(); ++i)
          E.row(c) -= model.coefficients(i) * blocks[static_cast<std::size_t>(k - 1 - i)].row(c).head<kColumns>();
      }
      const Eigen::Matrix<double, 6, kColumns> back =
          weighting.whitener.transpose() * weights.col(run.from + k).asDiagonal() * weighting.whitener * E;
      for (int c = 0; c < 6; ++c) B[static_cast<std::size_t>(c)].row(k) = back.row(c);
    }
    for (int c = 0; c < 6; ++c) {
      const ArModel& found = noise.channels[static_cast<std::size_t>(c)];
      const ArModel& used = weighting.channels[static_cast<std::size_t>(c)];
      MatrixXd& G = B[static_cast<std::size_t>(c)];
      MatrixXd X = G;
      for (Eigen::Index k = 0; k < n; ++k)
        for (int i = 0; i < used.order() && k + 1 + i < n; ++i) X.row(k) -= used.coefficients(i) * G.row(k + 1 + i);
      for (Eigen::Index k = n - 1; k >= 0; --k) {
        G.row(k) = X.row(k);
        for (int i = 0; i < found.order() && k + 1 + i < n; ++i) G.row(k) += found.coefficients(i) * G.row(k + 1 + i);
      }
    }
    for (Eigen::Index k = 0; k < n; ++k) {
      Eigen::Matrix<double, 6, kColumns> G;
      for (int c = 0; c < 6; ++c) G.row(c) = B[static_cast<std::size_t>(c)].row(k);
      const Eigen::Matrix<double, 6, kColumns> v = L.transpose() * G;
      M.noalias() += v.transpose() * v;
    }
  }
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
