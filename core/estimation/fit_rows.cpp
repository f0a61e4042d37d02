#include "core/estimation/fit_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "core/base/stop.h"
#include "core/estimation/noise_certainty.h"
#include "core/math/linear_algebra.h"

namespace heft {

namespace {

constexpr int kStrides[] = {1, 2, 4, 8};
/// How much of the motion's noise may differ from white noise of the power between 30 and 45 Hz.
constexpr double kNoiseUnknown = 0.25;
/// A bias, in standard deviations, that needs no narrower band: what of it is not known costs no coverage.
constexpr double kSmallBias = 0.2;
constexpr Eigen::Index kFewestRows = kMaxArOrder + 4;  // Of a run: some more than start values
/// Bands that agree to so many standard deviations of the narrower one are believed alike.
constexpr double kAgree = 3.0;
/// Share of the information in any direction that may come from the motion's noise and be taken off again.
constexpr double kMostNoise = 0.3;
/// Share of the noise that the motion's may be: it grows with the fourth power of frequency, and an autoregressive
/// model of noise that it rules tells little of the slow noise below, against which a weight is told.
constexpr double kMostNoiseShare = 0.1;
constexpr double kHopeless = 1e3;  // Score of a band that is noise
constexpr int kFewestEquations = 4 * kColumns;

std::vector<double> hannKernel(int stride) {
  std::vector<double> kernel;
  for (int i = 1 - stride; i < stride; ++i)
    kernel.push_back((0.5 + 0.5 * std::cos(std::numbers::pi * i / stride)) / stride);
  return kernel;
}

/// What is known of the payload by rows that are no better than that (a hand-held tool): keeps what the motion does not
/// excite from counting.
const Vector10d& usualSizes() {
  static const Vector10d kSizes = (Vector10d() << 3.0, Vector3d::Constant(0.3), VectorXd::Constant(6, 0.1)).finished();
  return kSizes;
}

struct Fit {
  Vector10d phi, std;
};

Fit fitOf(const Triangle& whitened) {
  const Matrix10d R = whitened.block<10, 10>(kBiasColumns, kBiasColumns);
  Matrix10d H = transposedProduct(R, R);
  H.diagonal() += usualSizes().cwiseAbs2().cwiseInverse();
  const Matrix10d covariance = inverse(H);
  Fit out;
  out.phi = covariance * (R.transpose() * whitened.block<10, 1>(kBiasColumns, kColumns));
  out.std = covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
  return out;
}

/// Rows that a run has in a narrower band; none of a run that is too short.
Eigen::Index rowsIn(const Run& run, int stride) {
  const Eigen::Index taps = 2 * stride - 1;
  const Eigen::Index rows = run.to - run.from < taps ? 0 : (run.to - run.from - taps) / stride + 1;
  return rows < kFewestRows ? 0 : rows;
}

}  // namespace

WrenchRows narrowed(const WrenchRows& blocks, int stride, std::vector<Run>& runs) {
  if (stride <= 1) return blocks;
  const std::vector<double> kernel = hannKernel(stride);
  const auto taps = static_cast<Eigen::Index>(kernel.size());
  WrenchRows out;
  out.startTime = blocks.startTime;
  out.rateHz = blocks.rateHz / stride;
  out.samplesPerBlock = blocks.samplesPerBlock * stride;
  std::vector<Run> kept;
  Eigen::Index count = 0;
  for (const auto& run : runs) {
    const Eigen::Index n = rowsIn(run, stride);
    if (n == 0) continue;
    kept.push_back({count, count + n});
    count += n;
  }
  out.wrench.setZero(6, count);
  out.Y.assign(static_cast<std::size_t>(count), Regressor::Zero());
  auto at = kept.begin();
  for (const auto& run : runs) {
    const Eigen::Index n = rowsIn(run, stride);
    if (n == 0) continue;
    for (Eigen::Index j = 0; j < n; ++j)
      for (Eigen::Index i = 0; i < taps; ++i) {
        const Eigen::Index from = run.from + j * stride + i;
        out.wrench.col(at->from + j) += kernel[static_cast<std::size_t>(i)] * blocks.wrench.col(from);
        out.Y[static_cast<std::size_t>(at->from + j)] +=
            kernel[static_cast<std::size_t>(i)] * blocks.Y[static_cast<std::size_t>(from)];
      }
    ++at;
  }
  runs = std::move(kept);
  return out;
}

namespace {

FitRows rowsAt(int stride, const FitRowsQuestion& of) {
  FitRows out;
  out.stride = stride;
  out.runs = of.runs;
  out.rows = narrowed(of.blocks, stride, out.runs);
  stopPoint();
  const KnownOfNoise known = of.known.at(stride);
  LearnedNoise learned = withTaken(stride == 1 && of.learned ? *of.learned : learnedNoise(out.rows, out.runs, known),
                                   out.rows, out.runs, known);
  out.noise = std::move(learned.noise);
  out.weights = std::move(learned.weights);
  out.weighting = bounded(out.noise);
  stopPoint();
  const ScoreEquations scores = scoreEquations(out.rows, out.noise, out.weighting, out.weights, out.runs);
  out.asWeighted = scores.whitened;
  out.whitened = honestTriangle(scores);
  stopPoint();
  if (!of.motionNoise) return out;
  std::vector<Run> same = of.runs;
  const Triangle noise =
      whitenedTriangles(narrowed(of.motionNoise->rows, stride, same), out.weighting, out.weights, out.runs, 1).front();
  const auto Y = noise.middleCols<10>(kBiasColumns);  // Noise does not reach the columns of the sensor's biases
  out.motionNoise = transposedProduct(Y, Y) / of.motionNoise->share;
  const Fit with = fitOf(out.whitened);
  out.whitened = honestTriangle(scores, out.motionNoise);
  const Fit without = fitOf(out.whitened);
  const Vector10d unknown = kNoiseUnknown * (out.motionNoise * without.phi);
  out.whitened = honestTriangle(scores, out.motionNoise, unknown * unknown.transpose());
  const double rows = static_cast<double>(6 * out.rows.size());
  out.share = without.phi.dot(out.motionNoise * without.phi) / rows;
  out.bias = (with.phi - without.phi).cwiseQuotient(without.std).cwiseAbs().maxCoeff();
  return out;
}

/// Whether what the motion's noise adds to the information is small beside it in every direction.
bool mostlyMotion(const FitRows& band) {
  const Matrix10d R = band.asWeighted.block<10, 10>(kBiasColumns, kBiasColumns);
  Matrix10d H = transposedProduct(R, R);
  H.diagonal() += usualSizes().cwiseAbs2().cwiseInverse();
  return generalizedEigen(band.motionNoise, H).values.maxCoeff() < kMostNoise;
}

/// With standard deviations that hold although the noise was learned from the same rows.
FitRows asCertain(FitRows band, const FitRowsQuestion& of) {
  stopPoint();
  band.shortfall =
      of.shortfall ? *of.shortfall : shortfallOfLearning(band.rows, band.noise, band.runs, of.known.at(band.stride));
  band.whitened /= band.shortfall;
  return band;
}

}  // namespace

FitRows fitRowsOf(const FitRowsQuestion& of) {
  const auto enough = [&](int stride) {
    Eigen::Index rows = 0;
    for (const Run& run : of.runs) rows += rowsIn(run, stride);
    return stride == 1 || 6 * rows >= kFewestEquations;
  };
  int predicts = std::max(of.predicts, of.atLeast);
  while (!enough(predicts)) predicts = std::max(1, predicts / 2);
  if (!of.motionNoise || of.fixed) return asCertain(rowsAt(predicts, of), of);
  std::vector<FitRows> bands;
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (const int stride : kStrides) {
    if (!enough(stride)) break;
    bands.push_back(rowsAt(stride, of));
    const FitRows& band = bands.back();
    const bool believed = stride >= of.atLeast && band.share < kMostNoiseShare && mostlyMotion(band);
    const double score = believed ? fitOf(band.whitened).std.array().log().sum() : kHopeless - stride;
    if (score < least) {
      least = score;
      best = bands.size() - 1;
    }
    if (believed && band.bias < kSmallBias && stride >= predicts) break;
  }
  // Noise of another kind than white may be there: then a narrower band predicts better, and finds something else.
  const Fit chosen = fitOf(bands[best].whitened);
  for (std::size_t i = best + 1; i < bands.size(); ++i) {
    if (bands[i].stride != predicts) continue;
    const Fit other = fitOf(bands[i].whitened);
    if ((chosen.phi - other.phi).cwiseQuotient(other.std).cwiseAbs().maxCoeff() > kAgree) best = i;
  }
  return asCertain(std::move(bands[best]), of);
}

}  // namespace heft
