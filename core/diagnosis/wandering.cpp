#include "core/diagnosis/wandering.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace heft::diagnosis {

namespace {

constexpr int kWaves = 14;

/// Cosines with k half waves over the recording, k = 1 .. count, in the judged blocks of each channel.
struct CosineWaves {
  MatrixXd amplitudes;  ///< count x 6
  VectorXd unsure;      ///< count: variances of them where blocks were left out, over those where none are
};

CosineWaves cosineWaves(const Signals& signals, const std::vector<Stretch>& stretches, const Wrenches& residual, int count) {
  MatrixXd A = MatrixXd::Zero(count + 1, count + 1), b = MatrixXd::Zero(count + 1, 6);
  VectorXd row(count + 1);
  const double n = static_cast<double>(signals.blocks());
  for (const auto& s : stretches)
    for (Eigen::Index i = s.from; i < s.to; ++i) {
      for (int k = 0; k <= count; ++k) row(k) = std::cos(std::numbers::pi * k * (static_cast<double>(i) + 0.5) / n);
      A += row * row.transpose();
      b += row * residual.col(i).transpose();
    }
  A.diagonal().array() += 1e-6 * A(0, 0);
  const Eigen::LDLT<MatrixXd> solver(A);
  const MatrixXd inverse = solver.solve(MatrixXd::Identity(count + 1, count + 1));
  return {solver.solve(b).bottomRows(count), 0.5 * n * inverse.diagonal().tail(count)};
}

}  // namespace

bool jumpStandsOut(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& without, const Fit& with) {
  const Term& term = with.model.terms.back();
  const auto window = static_cast<Eigen::Index>(0.4 * signals.blockRate());
  for (Eigen::Index c = 0; c < 6; ++c) {
    std::vector<double> steps;
    double atJump = 0.0;
    for (const auto& s : stretches)
      for (Eigen::Index i = s.from; i + 2 * window <= s.to; i += window / 2) {
        const double step = without.residual.row(c).segment(i + window, window).mean() -
                            without.residual.row(c).segment(i, window).mean();
        if (std::abs(signals.blockTime(i + window) - term.v(0)) < 0.45)
          atJump = std::max(atJump, std::abs(step));
        else
          steps.push_back(step);
      }
    if (steps.size() > 8 && atJump > 5.0 * robustStd(steps)) return true;
  }
  return false;
}

double slowWave(const Signals& signals, const std::vector<Stretch>& stretches, const Wrenches& residual) {
  constexpr int kAll = 3 * kWaves;
  constexpr double kBelow = 0.6;   // [Hz]; faster ones are looked for elsewhere
  constexpr double kLimit = 74.0;  // squared deviations of two neighbours in all channels: 12 on average
  const CosineWaves waves = cosineWaves(signals, stretches, residual, kAll);
  VectorXd together = VectorXd::Zero(kAll);
  for (Eigen::Index c = 0; c < 6; ++c) {
    const VectorXd power = waves.amplitudes.col(c).cwiseAbs2();
    // A walk on top of noise, fitted so that single waves that stand out count little (Student's t, three degrees).
    const auto spectrum = [&](double floor, double walk, int k) { return floor * (waves.unsure(k - 1) + walk / (k * k)); };
    double best = -1e300, floor = 0.0, walk = 0.0;
    const double lowest = std::max(1e-18, 0.1 * power.cwiseQuotient(waves.unsure).tail(2 * kWaves).mean());
    for (double f = lowest; f < 20.0 * lowest; f *= 1.3)
      for (double a = 0.0; a < 1e6; a = a == 0.0 ? 0.3 : 1.6 * a) {
        double sum = 0.0;
        for (int k = 1; k <= kAll; ++k) {
          const double variance = spectrum(f, a, k);
          sum -= std::log(variance) + 4.0 * std::log1p(power(k - 1) / (3.0 * variance));
        }
        if (sum > best) {
          best = sum;
          floor = f;
          walk = a;
        }
      }
    for (int k = 1; k <= kAll; ++k) together(k - 1) += power(k - 1) / spectrum(floor, walk, k);
  }
  // Half a wave over the recording is what a drift looks like. A wave that fits no whole number of times shows in two.
  double excess = 0.0;
  for (int k = 2; k < kAll && 0.5 * k < kBelow * signals.duration(); ++k)
    excess = std::max(excess, (together(k - 1) + together(k)) / kLimit);
  return excess;
}

}  // namespace heft::diagnosis
