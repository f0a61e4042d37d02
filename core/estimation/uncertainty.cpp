#include "core/estimation/uncertainty.h"
#include "core/math/linear_algebra.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace heft {

namespace {

constexpr double kNormal95 = 1.959963984540054;
constexpr int kPairs = 2000;

/// Standard normal draws, the same on every platform and in every run.
const std::vector<Vector10d>& draws() {
  static const std::vector<Vector10d> kDraws = [] {
    std::mt19937_64 random(42);
    const auto uniform = [&] { return (static_cast<double>(random() >> 11) + 0.5) * 0x1.0p-53; };
    std::vector<Vector10d> out(kPairs);
    for (auto& z : out)
      for (int i = 0; i < 10; i += 2) {
        const double radius = std::sqrt(-2.0 * std::log(uniform()));
        const double angle = 2.0 * std::numbers::pi * uniform();
        z(i) = radius * std::cos(angle);
        z(i + 1) = radius * std::sin(angle);
      }
    return out;
  }();
  return kDraws;
}

PayloadInterval fromArrays(const std::array<Interval, 10>& i) {
  PayloadInterval out;
  out.mass = i[0];
  out.com = {i[1], i[2], i[3]};
  out.inertiaCom = {{{i[4], i[5], i[6]}, {i[5], i[7], i[8]}, {i[6], i[8], i[9]}}};
  return out;
}

}  // namespace

Vector10d componentsOf(const Payload& payload) {
  const Matrix3d& I = payload.inertiaCom;
  Vector10d out;
  out << payload.mass, payload.com, I(0, 0), I(0, 1), I(0, 2), I(1, 1), I(1, 2), I(2, 2);
  return out;
}

Payload payloadFromComponents(const Vector10d& x) { return {x(0), x.segment<3>(1), inertiaTensor(x)}; }

Matrix10d componentsJacobian(const Vector10d& phi) {
  Matrix10d J;
  for (int i = 0; i < 10; ++i) {
    const double step = 1e-6 * std::max({std::abs(phi(i)), 1e-3 * std::abs(phi(0)), 1e-9});
    Vector10d up = phi, down = phi;
    up(i) += step;
    down(i) -= step;
    J.col(i) = (componentsOf(fromParameters(up)) - componentsOf(fromParameters(down))) / (2.0 * step);
  }
  return J;
}

PlainFit plainFit(const Triangle& R, bool bias) {
  constexpr double kFarTooWide = 100.0;
  const int first = bias ? kBiasColumns : 0;
  const MatrixXd A = R.block(first, kBiasColumns, kColumns + 1 - first, 10);
  Matrix10d information = transposedProduct(A, A);
  information.diagonal().array() += 1.0 / (kFarTooWide * kFarTooWide);
  const Matrix10d covariance = inverse(information);
  return {covariance * (A.transpose() * R.col(kColumns).tail(kColumns + 1 - first)), covariance};
}

Triangle lessSure(const Triangle& R, const Matrix10d& more) {
  const Matrix10d A = R.block<10, 10>(kBiasColumns, kBiasColumns);
  const Matrix10d information = transposedProduct(A, A);
  // (information^-1 + L L^T)^-1, also where the rows tell nothing of some direction.
  const auto [variances, axes] = symmetricEigen(more);
  const Matrix10d L = axes * variances.cwiseMax(0.0).cwiseSqrt().asDiagonal();
  const Matrix10d IL = information * L;
  const Matrix10d left = information - IL * inverse(Matrix10d::Identity() + L.transpose() * IL) * IL.transpose();
  const auto [sizes, directions] = symmetricEigen(left);
  const Matrix10d root = sizes.cwiseMax(0.0).cwiseSqrt().asDiagonal() * directions.transpose();
  Triangle rows = R;
  rows.block<10, 10>(kBiasColumns, kBiasColumns) = root;
  rows.block<10, 1>(kBiasColumns, kColumns) = root * plainFit(R, true).phi;
  TriangleBuilder builder;
  builder.add(rows);
  return builder.finish();
}

PayloadInterval intervalsFromV(const Triangle& R, const MapPrior& prior, bool bias, const MapSolution& solution,
                               const std::function<Vector10d(const Vector10d&)>& bound) {
  const MapCost cost(R, prior, bias);
  // The draws come from the curvature of the data and of the prior as a normal distribution: an entropic prior is
  // nearly flat far below its mean, and draws by its curvature there would miss everything else.
  const Matrix10d information = solution.dataInformation + prior.normalInformation(solution.v);
  const Matrix10d L = choleskyFactor(inverse(information));
  const double best = cost(solution.v);
  struct Draw {
    Vector10d components;
    double weight;
  };
  std::vector<Draw> sample;
  sample.reserve(2 * kPairs);
  std::vector<double> excess;
  // Moving a draw to a bound costs a small optimisation: a quarter of them must do.
  const std::size_t stride = bound ? 4 : 1;
  for (std::size_t k = 0; k < draws().size(); k += stride)
    for (const double sign : {1.0, -1.0}) {
      const Vector10d& z = draws()[k];
      const Vector10d v = solution.v + sign * (L * z);
      const Vector10d phi = parametersFromV(prior, v);
      sample.push_back({componentsOf(fromParameters(bound ? bound(phi) : phi)), 0.0});
      excess.push_back(0.5 * (z.squaredNorm() - (cost(v) - best)));
    }
  // A few draws far out in the tail must not carry everything: weights are cut at twenty times their mean.
  const double top = *std::max_element(excess.begin(), excess.end());
  double sum = 0.0;
  for (std::size_t i = 0; i < sample.size(); ++i) sum += sample[i].weight = std::exp(excess[i] - top);
  const double largest = 20.0 * sum / static_cast<double>(sample.size());
  sum = 0.0;
  for (auto& draw : sample) sum += draw.weight = std::min(draw.weight, largest);

  std::array<Interval, 10> intervals;
  std::vector<std::pair<double, double>> ordered(sample.size());
  for (std::size_t i = 0; i < 10; ++i) {
    for (std::size_t k = 0; k < sample.size(); ++k)
      ordered[k] = {sample[k].components(static_cast<Eigen::Index>(i)), sample[k].weight};
    std::sort(ordered.begin(), ordered.end());
    double seen = 0.0;
    intervals[i] = {ordered.front().first, ordered.back().first};
    bool lowerFound = false;
    for (const auto& [value, weight] : ordered) {
      seen += weight;
      if (!lowerFound && seen >= 0.025 * sum) {
        intervals[i].lower = value;
        lowerFound = true;
      }
      if (seen >= 0.975 * sum) {
        intervals[i].upper = value;
        break;
      }
    }
  }
  return fromArrays(intervals);
}

PayloadInterval intervalsFromCovariance(const Vector10d& components, const Matrix10d& covariance) {
  std::array<Interval, 10> intervals;
  for (std::size_t i = 0; i < 10; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    const double half = kNormal95 * std::sqrt(std::max(0.0, covariance(k, k)));
    intervals[i] = {components(k) - half, components(k) + half};
  }
  return fromArrays(intervals);
}

Payload standardDeviations(const PayloadInterval& intervals) {
  const auto std = [](const Interval& i) { return (i.upper - i.lower) / (2.0 * kNormal95); };
  Payload out;
  out.mass = std(intervals.mass);
  for (std::size_t r = 0; r < 3; ++r) {
    out.com(static_cast<Eigen::Index>(r)) = std(intervals.com[r]);
    for (std::size_t c = 0; c < 3; ++c)
      out.inertiaCom(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c)) = std(intervals.inertiaCom[r][c]);
  }
  return out;
}

}  // namespace heft
