#include "core/diagnosis/search/random_walk.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/parallel.h"
#include "core/base/stop.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/causes/catalogue.h"
#include "core/math/linear_algebra.h"
#include "core/math/statistics.h"

namespace heft::diagnosis {

namespace {

/// A residual in parts of `seconds` each, without its mean, turned so that both a random walk and white noise are
/// independent from row to row. Parts of which less than half is judged are not there.
struct Turned {
  MatrixXd y;     ///< M x 6
  VectorXd walk;  ///< M: variances of a walk that goes as far as one white reading scatters over the recording
  MatrixXd from;  ///< M x (M + 1): what turns a function of the parts' times likewise
  VectorXd time;  ///< M + 1 [s]
};

Turned turned(const Signals& signals, const std::vector<Stretch>& stretches, const Wrenches& residual, double seconds) {
  const auto length = std::max<Eigen::Index>(1, static_cast<Eigen::Index>(std::lround(seconds * signals.blockRate())));
  const Eigen::Index parts = signals.blocks() / length;
  MatrixXd sums = MatrixXd::Zero(parts, 6);
  VectorXd times = VectorXd::Zero(parts), counts = VectorXd::Zero(parts);
  for (const auto& s : stretches)
    for (Eigen::Index n = s.from; n < std::min(s.to, parts * length); ++n) {
      sums.row(n / length) += residual.col(n).transpose();
      times(n / length) += signals.blockTime(n);
      counts(n / length) += 1.0;
    }
  std::vector<Eigen::Index> in;
  for (Eigen::Index i = 0; i < parts; ++i)
    if (2.0 * counts(i) >= static_cast<double>(length)) in.push_back(i);
  Turned out;
  const auto count = std::ssize(in);
  if (count < 3) return out;
  out.time.resize(count);
  stopPoint();
  MatrixXd y(count, 6), K(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Index at = in[static_cast<std::size_t>(i)];
    y.row(i) = sums.row(at) / counts(at);
    out.time(i) = times(at) / counts(at) - signals.startTime;
  }
  for (Eigen::Index i = 0; i < count; ++i)
    for (Eigen::Index j = 0; j < count; ++j) K(i, j) = std::min(out.time(i), out.time(j)) / signals.duration();
  K.rowwise() -= K.colwise().mean().eval();
  K.colwise() -= K.rowwise().mean().eval();
  stopPoint();
  // The smallest is the mean's: nothing of it is left.
  const auto [values, vectors] = symmetricEigen(K);
  out.from = vectors.rightCols(count - 1).transpose();
  out.walk = values.tail(count - 1).cwiseMax(0.0);
  out.y = product(out.from, y);
  return out;
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
  constexpr double kBelow = 0.6;  // [Hz]; faster ones are looked for elsewhere
  // Of 120 recordings with and without a walk the highest was 48; waves of 20 deviations began at 71
  constexpr double kLimit = 70.0;
  constexpr double kMostParts = 400.0;
  const double part = std::max(0.2, signals.duration() / kMostParts);
  const Turned at = turned(signals, stretches, residual, part);
  const Eigen::Index count = at.y.rows();
  if (count < 8) return 0.0;
  stopPoint();
  std::vector<VectorXd> weights{VectorXd::Ones(count)};
  for (double a = 0.1; a < 1e4; a *= 1.6) weights.push_back((1.0 + a * at.walk.array()).inverse().matrix());
  // Twice the log-likelihood of a channel as a walk of any size on noise of any size, with the wave `X` or, where that
  // is empty, without.
  const auto likelihood = [&](Eigen::Index channel, const VectorXd& weight, const MatrixXd& X) {
    const auto y = at.y.col(channel);
    double left = weight.dot(y.cwiseAbs2());
    if (X.cols() > 0) {
      const MatrixXd W = weight.asDiagonal() * X;
      const VectorXd b = W.transpose() * y;
      left -= b.dot(solveSymmetric(transposedProduct(X, W) + 1e-9 * MatrixXd::Identity(2, 2), b));
    }
    return weight.array().log().sum() - static_cast<double>(count) * std::log(std::max(1e-300, left));
  };
  const auto best = [&](const MatrixXd& X) {
    Vector6d out = Vector6d::Constant(-1e300);
    for (const VectorXd& weight : weights)
      for (Eigen::Index c = 0; c < 6; ++c) out(c) = std::max(out(c), likelihood(c, weight, X));
    return out.sum();
  };
  // Less than a whole wave over the recording is what a drift looks like.
  const double step = 0.15 / signals.duration(), none = best({});
  std::vector<double> frequencies;
  for (double f = 1.0 / signals.duration(); f < std::min(kBelow, 0.25 / part); f += step) frequencies.push_back(f);
  std::vector<double> gains(frequencies.size(), 0.0);
  parallelFor(frequencies.size(), [&](std::size_t i) {
    const Eigen::ArrayXd phase = 2.0 * std::numbers::pi * frequencies[i] * at.time.array();
    MatrixXd wave(at.time.size(), 2);
    wave << phase.cos().matrix(), phase.sin().matrix();
    gains[i] = best(at.from * wave) - none;
  });
  return gains.empty() ? 0.0 : *std::ranges::max_element(gains) / kLimit;
}

bool isOneCourse(const Model& model) {
  // Strongest course's share of the longest waves, each in units of what a walk makes of it. Of 24 walks of six
  // channels it had 0.62 at most, of 24 drifts of all channels at once 0.76 or more, but for a faint one.
  constexpr double kShare = 0.7;
  constexpr Eigen::Index kLongest = 6;
  const auto walk = std::ranges::find_if(model.terms, [](const Term& t) { return t.form->walk; });
  if (walk == model.terms.end() || walk->walk.minCoeff() <= 0.0) return false;
  MatrixXd waves(6, kLongest);
  for (Eigen::Index k = 0; k < kLongest; ++k)
    waves.col(k) = static_cast<double>(k + 1) * walk->v.segment<6>(6 * k).cwiseQuotient(walk->walk.cwiseSqrt());
  return shareAlongOneDirection(waves * waves.transpose()) > kShare;
}

bool isCourseOfTheZero(std::string_view cause) { return infoOf(cause).zeroMoves; }

}  // namespace heft::diagnosis
