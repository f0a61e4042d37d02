#include "core/estimation/uncertainty.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "core/estimation/normal_draws.h"
#include "core/estimation/triangle.h"
#include "core/math/linear_algebra.h"

namespace heft {

namespace {

constexpr double kNormal95 = 1.959963984540054;
constexpr int kPairs = 2000;

/// Standard normal draws, the same on every platform and in every run.
const std::vector<Vector10d>& draws() {
  static const std::vector<Vector10d> kDraws = [] {
    NormalDraws random;
    std::vector<Vector10d> out(kPairs);
    for (auto& z : out)
      for (int i = 0; i < 10; i += 2) std::tie(z(i), z(i + 1)) = random.normalPair();
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

namespace {

struct WeightedV {
  Vector10d v;
  double weight = 1.0;
};

/// Importance sampling: draws of the normal distribution N(mode, L L^T), weighted by the posterior. Nothing where the
/// weights leave too few effective draws (Kish 1965) to read 95 % intervals from: the posterior is not shaped like it.
std::vector<WeightedV> importanceSample(const MapCost& cost, const Vector10d& mode, const Matrix10d& L,
                                        std::size_t stride) {
  constexpr double kFewestEffective = 400.0;  // The ends of a 95 % interval are then sure to 7 % of it (one sd)
  const double best = cost(mode);
  std::vector<WeightedV> sample;
  sample.reserve(std::size_t{2} * kPairs);
  for (std::size_t k = 0; k < draws().size(); ++k)
    for (const double sign : {1.0, -1.0}) {
      const Vector10d& z = draws()[k];
      const Vector10d v = mode + sign * (L * z);
      sample.push_back({v, 0.5 * (z.squaredNorm() - (cost(v) - best))});
    }
  // A few draws far out in the tail must not carry everything: weights are cut at twenty times their mean.
  const double top = std::ranges::max(sample, {}, &WeightedV::weight).weight;
  double sum = 0.0, squares = 0.0;
  for (auto& draw : sample) {
    draw.weight = std::exp(draw.weight - top);
    sum += draw.weight;
    squares += draw.weight * draw.weight;
  }
  if (sum * sum < kFewestEffective * squares) return {};
  const double largest = 20.0 * sum / static_cast<double>(sample.size());
  for (auto& draw : sample) draw.weight = std::min(draw.weight, largest);
  // Every stride-th pair where each draw is dear to work out
  std::vector<WeightedV> out;
  for (std::size_t k = 0; k < sample.size(); k += 2 * stride) out.insert(out.end(), {sample[k], sample[k + 1]});
  return out;
}

/// Random-walk Metropolis whose steps are learned from its own first walk (Haario, Saksman and Tamminen 2001): for
/// posteriors that no normal distribution resembles, such as those of a second's motion beside the edge of what a body
/// can be. Deterministic.
std::vector<WeightedV> walkedSample(const MapCost& cost, const Vector10d& mode, const Matrix10d& L, std::size_t count) {
  constexpr int kLearning = 20000, kWalk = 60000;
  constexpr double kSteps[] = {0.1, 0.3, 0.75};  // Times the spread; 2.4 / sqrt(10) is best for a normal one
  NormalDraws random;
  Vector10d v = mode;
  double here = cost(v);
  const auto walk = [&](const Matrix10d& spread, int steps, const auto& visit) {
    for (int k = 0; k < steps; ++k) {
      const Vector10d& z = draws()[random.bits() % draws().size()];
      const double size = kSteps[k % 3] * (random.bits() % 2 ? 1.0 : -1.0);
      const Vector10d next = v + size * (spread * z);
      const double there = cost(next);
      if (2.0 * std::log(random.uniform()) < here - there) {
        v = next;
        here = there;
      }
      visit(k);
    }
  };
  Vector10d sum = Vector10d::Zero();
  Matrix10d squares = Matrix10d::Zero();
  walk(L, kLearning, [&](int) {
    sum += v - mode;
    squares += (v - mode) * (v - mode).transpose();
  });
  sum /= kLearning;
  const Matrix10d learned = squares / kLearning - sum * sum.transpose();
  const int every = kWalk / static_cast<int>(count);
  std::vector<WeightedV> out;
  walk(choleskyFactor(learned + 1e-6 * L * L.transpose()), kWalk, [&](int k) {
    if (k % every == 0) out.push_back({v});
  });
  return out;
}

/// That bodies end where a moment of inertia would be negative narrows the inertia rightly, and mass and centre with it
/// only where the inertia is right: theirs are no narrower than what the readings and the prior tell as normal
/// distributions of phi, the prior about its own mean.
void widenToData(std::array<Interval, 10>& intervals, const Triangle& R, const MapPrior& prior, bool bias,
                 const Vector10d& phi) {
  const Matrix10d byPhi = inverse(parametersJacobian(prior, prior.mean));
  const int first = bias ? kBiasColumns : 0;
  const MatrixXd A = R.block(first, kBiasColumns, kColumns + 1 - first, 10);
  const Matrix10d information =
      transposedProduct(A, A) + byPhi.transpose() * prior.normalInformation(prior.mean) * byPhi;
  const Vector10d variance = congruence(componentsJacobian(phi), inverse(information)).diagonal();
  const Vector10d value = componentsOf(fromParameters(phi));
  constexpr std::size_t kMassAndCentre = 4;
  for (std::size_t i = 0; i < kMassAndCentre; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    const double half = kNormal95 * std::sqrt(std::max(0.0, variance(k)));
    const double lowest = i == 0 ? value(k) * std::exp(-half / value(k)) : value(k) - half;  // A mass is positive
    intervals[i].lower = std::min(intervals[i].lower, lowest);
    intervals[i].upper = std::max(intervals[i].upper, value(k) + half);
  }
}

}  // namespace

PayloadInterval intervalsFromV(const Triangle& R, const MapPrior& prior, bool bias, const MapSolution& solution,
                               const std::function<Vector10d(const Vector10d&)>& bound) {
  const MapCost cost(R, prior, bias);
  // The draws come from the curvature of the data and of the prior as a normal distribution: an entropic prior is
  // nearly flat far below its mean, and draws by its curvature there would miss everything else.
  const Matrix10d information = solution.dataInformation + prior.normalInformation(solution.v);
  const Matrix10d L = choleskyFactor(inverse(information));
  // Moving a draw to a bound costs a small optimisation: a quarter of them must do.
  const std::size_t stride = bound ? 4 : 1;
  std::vector<WeightedV> drawn = importanceSample(cost, solution.v, L, stride);
  if (drawn.empty()) drawn = walkedSample(cost, solution.v, L, std::size_t{2} * kPairs / stride);
  struct Draw {
    Vector10d components;
    double weight;
  };
  std::vector<Draw> sample;
  sample.reserve(drawn.size());
  double sum = 0.0;
  for (const auto& [v, weight] : drawn) {
    const Vector10d phi = parametersFromV(prior, v);
    sample.push_back({componentsOf(fromParameters(bound ? bound(phi) : phi)), weight});
    sum += weight;
  }

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
  widenToData(intervals, R, prior, bias, solution.phi);
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

Matrix10d correlationFrom(const Matrix10d& covariance) {
  const Vector10d std = covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
  const Vector10d scale = (std.array() > 0.0).select(std.cwiseInverse(), 0.0);
  Matrix10d out = scale.asDiagonal() * covariance * scale.asDiagonal();
  out = out.cwiseMin(1.0).cwiseMax(-1.0).eval();
  out.diagonal().setOnes();
  return out;
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
