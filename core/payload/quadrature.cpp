#include "core/payload/quadrature.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace heft {

namespace {

using Moments = Eigen::Matrix<double, 9, 1>;

Moments momentsOf(const Vector3d& y) {
  Moments b;
  b << y, y.x() * y.x(), y.y() * y.y(), y.z() * y.z(), y.x() * y.y(), y.x() * y.z(), y.y() * y.z();
  return b;
}

using Iterator = std::vector<Eigen::Index>::iterator;

struct Splitter {
  const WeightedPoints& fine;
  std::vector<std::pair<Iterator, Iterator>> cells;

  void split(Iterator first, Iterator last, int count) {
    if (count <= 1 || last - first <= 1) {
      if (first != last) cells.emplace_back(first, last);
      return;
    }
    Eigen::Array3d low = fine.points.col(*first), high = low;
    double total = 0.0;
    for (auto it = first; it != last; ++it) {
      low = low.min(fine.points.col(*it).array());
      high = high.max(fine.points.col(*it).array());
      total += fine.weights[*it];
    }
    int axis = 0;
    (high - low).maxCoeff(&axis);
    const auto before = [&](Eigen::Index a, Eigen::Index b) {
      const double xa = fine.points(axis, a), xb = fine.points(axis, b);
      return xa < xb || (xa == xb && a < b);
    };
    // Weighted quickselect: `middle` ends where the left share of the weight is reached.
    const int left = count / 2;
    double wanted = total * left / count;
    auto from = first, to = last;
    while (to - from > 1) {
      const auto half = from + (to - from) / 2;
      std::nth_element(from, half, to, before);
      double sum = 0.0;
      for (auto it = from; it != half; ++it) sum += fine.weights[*it];
      if (sum <= wanted) {
        wanted -= sum;
        from = half;
      } else {
        to = half;
      }
    }
    const auto middle = wanted > 0.5 * fine.weights[*from] ? from + 1 : from;
    split(first, middle, left);
    split(middle, last, count - left);
  }
};

}  // namespace

Vector3d evenPoint(long index) {
  constexpr std::array<long, 3> kBases{2, 3, 5};
  Vector3d x = Vector3d::Zero();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double digit = 1.0;
    for (long rest = index + 1; rest > 0; rest /= kBases[axis]) {
      digit /= static_cast<double>(kBases[axis]);
      x[static_cast<Eigen::Index>(axis)] += digit * static_cast<double>(rest % kBases[axis]);
    }
  }
  return x;
}

Matrix4d pseudoInertiaOf(const WeightedPoints& samples) {
  Matrix4d P = Matrix4d::Zero();
  const Eigen::Matrix3Xd weighted = samples.points * samples.weights.asDiagonal();
  P.topLeftCorner<3, 3>() = weighted * samples.points.transpose();
  P.topRightCorner<3, 1>() = weighted.rowwise().sum();
  P.bottomLeftCorner<1, 3>() = P.topRightCorner<3, 1>().transpose();
  P(3, 3) = samples.weights.sum();
  return P;
}

WeightedPoints thinned(const WeightedPoints& fine, int count) {
  const Eigen::Index n = fine.points.cols();
  const double total = fine.weights.sum();
  if (n <= count) return {fine.points, fine.weights / total};

  const Vector3d center = fine.points * fine.weights / total;
  const Eigen::Matrix3Xd centred = fine.points.colwise() - center;
  const Vector3d spread = (centred.array().square().matrix() * fine.weights / total)
                              .cwiseSqrt()
                              .cwiseMax(std::numeric_limits<double>::min());

  std::vector<Eigen::Index> order(static_cast<std::size_t>(n));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  Splitter splitter{fine, {}};
  splitter.split(order.begin(), order.end(), count);

  WeightedPoints result{Eigen::Matrix3Xd(3, splitter.cells.size()), VectorXd(splitter.cells.size())};
  Moments error = Moments::Zero();  // of what is chosen so far, against the cells it stands for
  Eigen::Index next = 0;
  for (const auto& [first, last] : splitter.cells) {
    Moments sum = Moments::Zero();
    double weight = 0.0;
    for (auto it = first; it != last; ++it) {
      sum += fine.weights[*it] * momentsOf(centred.col(*it).cwiseQuotient(spread));
      weight += fine.weights[*it];
    }
    double best = std::numeric_limits<double>::infinity();
    Eigen::Index chosen = *first;
    for (auto it = first; it != last; ++it) {
      const double cost = (error + weight * momentsOf(centred.col(*it).cwiseQuotient(spread)) - sum).squaredNorm();
      if (cost < best) {
        best = cost;
        chosen = *it;
      }
    }
    error += weight * momentsOf(centred.col(chosen).cwiseQuotient(spread)) - sum;
    result.points.col(next) = fine.points.col(chosen);
    result.weights[next++] = weight / total;
  }
  return result;
}

bool matchMoments(WeightedPoints& samples, const Matrix4d& unit) {
  samples.weights /= samples.weights.sum();
  const Vector3d wanted = unit.topRightCorner<3, 1>() / unit(3, 3);
  const Matrix3d wantedCov = unit.topLeftCorner<3, 3>() / unit(3, 3) - wanted * wanted.transpose();
  const Vector3d mean = samples.points * samples.weights;
  samples.points.colwise() -= mean;
  const Matrix3d cov = samples.points * samples.weights.asDiagonal() * samples.points.transpose();
  const Eigen::LLT<Matrix3d> from(cov), to(wantedCov);
  if (from.info() != Eigen::Success || to.info() != Eigen::Success) return false;
  const Matrix3d map = to.matrixL() * from.matrixL().solve(Matrix3d::Identity());
  if (!map.allFinite()) return false;
  samples.points = (map * samples.points).colwise() + wanted;
  return true;
}

}  // namespace heft
