#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "core/base/say.h"
#include "core/estimation/solvers.h"

namespace heft {

namespace {

/// The cost of the free payload parameters once the best biases are put in: |T w - t|^2.
struct Eliminated {
  MatrixXd T;
  VectorXd t;
  double cost(const VectorXd& w) const { return (T * w - t).squaredNorm(); }
};

constexpr int kGridPoints = 7;      // per dimension and level
constexpr double kShrink = 0.45;    // region of the next level
constexpr double kSmallest = 1e-7;  // relative size of the last region
constexpr int kSamples = 600;       // draws a level with ten unknowns
constexpr int kElite = 40;

VectorXd gridSearch(const Eliminated& problem, VectorXd centre, VectorXd half, int& evaluations) {
  const Eigen::Index d = centre.size();
  const VectorXd stop = kSmallest * half;
  const auto total = static_cast<long>(std::pow(kGridPoints, static_cast<double>(d)));
  while ((half.array() > stop.array()).all()) {
    double best = problem.cost(centre);
    VectorXd bestPoint = centre;
    VectorXd w(d);
    for (long i = 0; i < total; ++i) {
      long rest = i;
      for (Eigen::Index k = 0; k < d; ++k, rest /= kGridPoints)
        w(k) = centre(k) + half(k) * (2.0 * static_cast<double>(rest % kGridPoints) / (kGridPoints - 1) - 1.0);
      if (const double cost = problem.cost(w); cost < best) {
        best = cost;
        bestPoint = w;
      }
      ++evaluations;
    }
    // A best point at the region's edge asks for a move, not for a smaller region.
    const bool atEdge = ((bestPoint - centre).cwiseAbs().array() > 0.99 * half.array()).any();
    centre = bestPoint;
    if (!atEdge) half *= kShrink;
  }
  return centre;
}

/// Samples about the mean of the best few, with their covariance: the region shrinks along the valley of the cost.
VectorXd sampleSearch(const Eliminated& problem, VectorXd centre, const VectorXd& half, int& evaluations) {
  const Eigen::Index d = centre.size();
  std::mt19937_64 random(7);
  const auto normal = [&] {  // sum of twelve uniforms: the shape of the tails does not matter here
    double sum = -6.0;
    for (int i = 0; i < 12; ++i) sum += static_cast<double>(random() >> 11) * 0x1.0p-53;
    return sum;
  };
  MatrixXd spread = half.asDiagonal();
  std::vector<VectorXd> points(kSamples, VectorXd(d));
  std::vector<double> costs(kSamples);
  std::vector<int> order(kSamples);
  VectorXd best = centre;
  double bestCost = problem.cost(centre);
  for (int level = 0; level < 150; ++level) {
    for (int i = 0; i < kSamples; ++i) {
      VectorXd z(d);
      for (Eigen::Index k = 0; k < d; ++k) z(k) = normal();
      const auto at = static_cast<std::size_t>(i);
      points[at] = centre + spread * z;
      costs[at] = problem.cost(points[at]);
    }
    evaluations += kSamples;
    std::iota(order.begin(), order.end(), 0);
    std::partial_sort(order.begin(), order.begin() + kElite, order.end(), [&](int a, int b) {
      return costs[static_cast<std::size_t>(a)] < costs[static_cast<std::size_t>(b)];
    });
    const auto first = static_cast<std::size_t>(order[0]);
    if (costs[first] < bestCost) {
      bestCost = costs[first];
      best = points[first];
    }
    VectorXd mean = VectorXd::Zero(d);
    for (int i = 0; i < kElite; ++i)
      mean += points[static_cast<std::size_t>(order[static_cast<std::size_t>(i)])] / kElite;
    MatrixXd covariance = MatrixXd::Zero(d, d);
    for (int i = 0; i < kElite; ++i) {
      const VectorXd e = points[static_cast<std::size_t>(order[static_cast<std::size_t>(i)])] - centre;
      covariance += e * e.transpose() / kElite;
    }
    centre = mean;
    covariance.diagonal() += VectorXd((1e-18 * half.cwiseAbs2()));
    spread = choleskyFactor(covariance);
    if ((spread.rowwise().norm().array() < kSmallest * half.array()).all()) break;
  }
  return problem.cost(centre) < bestCost ? centre : best;
}

}  // namespace

SolverSolution solveBruteForce(const SolverProblem& problem) {
  const auto [map, offset] = selectionFor(problem.parameters, problem.bias, problem.known);
  const Eigen::Index d = map.cols();
  const Eigen::Index biases = problem.bias ? kBiasColumns : 0;
  const Eigen::Index free = d - biases;
  MatrixXd augmented(problem.A.rows(), d + 1);
  augmented.leftCols(d) = product(problem.A, map);
  augmented.col(d) = problem.y - problem.A * offset;
  const MatrixXd R = upperTriangle(augmented);
  const Eliminated eliminated{R.block(biases, biases, free + 1, free), R.col(d).tail(free + 1)};

  // The region: mass by half, centre of mass by 10 cm, inertia by the known one's own size, around the known values.
  const Vector10d known = toParameters(problem.known);
  VectorXd half(10);
  half << 0.5 * problem.known.mass, Vector3d::Constant(0.1 * problem.known.mass),
      VectorXd::Constant(6, std::max(1e-4, inertiaAboutOrigin(problem.known).trace()));
  SolverSolution solution;
  const VectorXd w = free <= 4 ? gridSearch(eliminated, known.head(free), half.head(free), solution.iterations)
                               : sampleSearch(eliminated, known.head(free), half.head(free), solution.iterations);
  VectorXd z(d);
  z.tail(free) = w;
  z.head(biases) =
      solveUpper(R.topLeftCorner(biases, biases), R.col(d).head(biases) - R.block(0, biases, biases, free) * w);
  const VectorXd x = offset + map * z;
  solution.bias = x.head<6>();
  solution.phi = x.tail<10>();
  solution.usable = x.allFinite();
  solution.why = heft::say("The searched region shrank to nothing.");
  return solution;
}

}  // namespace heft
