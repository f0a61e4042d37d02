#include "core/payload/mesh_volume.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace heft {

namespace {

/// Twice the signed area of (a, b, p), with the same rounding for (b, a, p) up to the sign: two triangles that share an
/// edge never both claim or both miss a point.
class EdgeSide {
 public:
  EdgeSide(const Eigen::Vector2d& a, const Eigen::Vector2d& b, int idA, int idB)
      : from_(idA < idB ? a : b), along_((idA < idB ? b : a) - from_), sign_(idA < idB ? 1.0 : -1.0) {}
  double value(double x, double y) const {
    return sign_ * (along_.x() * (y - from_.y()) - along_.y() * (x - from_.x()));
  }
  /// +1 or -1, never 0: points on the line belong to the side that the lower-numbered vertex calls left.
  int side(double value) const { return value != 0.0 ? (value > 0 ? 1 : -1) : (sign_ > 0 ? 1 : -1); }

 private:
  Eigen::Vector2d from_, along_;
  double sign_;
};

struct Crossing {
  std::uint32_t column;
  float sign;
  double height;
};

struct Columns {
  double spacing = 0.0;
  Eigen::Vector2d origin;
  long nx = 0, ny = 0;
  std::vector<Crossing> crossings;
};

/// Where the rays along the third axis through a square grid cross the surface, sorted by ray and height.
Columns castRays(const Surface& surface, const std::vector<Vector3d>& v, double spacing) {
  Columns c;
  Eigen::Array3d low = v.front(), high = low;
  for (const Vector3d& p : v) {
    low = low.min(p.array());
    high = high.max(p.array());
  }
  c.spacing = spacing;
  // Off-grid start: symmetric bodies would put whole rows of rays exactly through their edges.
  c.origin = low.head<2>().matrix() + Eigen::Vector2d(0.5017, 0.4989) * spacing;
  c.nx = std::max(1L, static_cast<long>(std::ceil((high.x() - low.x()) / spacing)));
  c.ny = std::max(1L, static_cast<long>(std::ceil((high.y() - low.y()) / spacing)));
  for (const auto& t : surface.triangles) {
    const Vector3d &p0 = v[static_cast<std::size_t>(t[0])], &p1 = v[static_cast<std::size_t>(t[1])],
                   &p2 = v[static_cast<std::size_t>(t[2])];
    const auto first = [&](int axis) {
      return static_cast<long>(std::ceil((std::min({p0[axis], p1[axis], p2[axis]}) - c.origin[axis]) / spacing));
    };
    const auto last = [&](int axis) {
      return static_cast<long>(std::floor((std::max({p0[axis], p1[axis], p2[axis]}) - c.origin[axis]) / spacing));
    };
    const long x0 = std::max(0L, first(0)), x1 = std::min(c.nx - 1, last(0));
    const long y0 = std::max(0L, first(1)), y1 = std::min(c.ny - 1, last(1));
    if (x0 > x1 || y0 > y1) continue;
    const EdgeSide e0(p1.head<2>(), p2.head<2>(), t[1], t[2]), e1(p2.head<2>(), p0.head<2>(), t[2], t[0]),
        e2(p0.head<2>(), p1.head<2>(), t[0], t[1]);
    for (long iy = y0; iy <= y1; ++iy) {
      const double y = c.origin.y() + static_cast<double>(iy) * spacing;
      for (long ix = x0; ix <= x1; ++ix) {
        const double x = c.origin.x() + static_cast<double>(ix) * spacing;
        const double w0 = e0.value(x, y), w1 = e1.value(x, y), w2 = e2.value(x, y);
        const int s = e0.side(w0);
        if (e1.side(w1) != s || e2.side(w2) != s) continue;
        const double sum = w0 + w1 + w2;
        const double z =
            sum != 0.0 ? (w0 * p0.z() + w1 * p1.z() + w2 * p2.z()) / sum : (p0.z() + p1.z() + p2.z()) / 3.0;
        // A triangle that is counter-clockwise seen from above bounds the material from above.
        c.crossings.push_back({static_cast<std::uint32_t>(iy * c.nx + ix), static_cast<float>(s), z});
      }
    }
  }
  std::sort(c.crossings.begin(), c.crossings.end(), [](const Crossing& a, const Crossing& b) {
    return a.column < b.column || (a.column == b.column && a.height < b.height);
  });
  return c;
}

struct Span {
  std::uint32_t column;
  double from, to;
  double layers;  ///< How often the surface winds around these points.
};

std::vector<Span> spansOf(const Columns& columns) {
  std::vector<Span> spans;
  const auto& all = columns.crossings;
  for (std::size_t i = 0; i < all.size();) {
    std::size_t end = i;
    double balance = 0.0;
    while (end < all.size() && all[end].column == all[i].column) balance += static_cast<double>(all[end++].sign);
    if (balance == 0.0) {
      double layers = 0.0;
      for (std::size_t k = i; k + 1 < end; ++k) {
        layers -= static_cast<double>(all[k].sign);
        if (layers > 0.0 && all[k + 1].height > all[k].height)
          spans.push_back({all[k].column, all[k].height, all[k + 1].height, layers});
      }
    }
    i = end;
  }
  return spans;
}

/// Rays run along the shortest principal axis: flat bodies are hit by many rays, and turning a body turns its points.
struct RayFrame {
  Vector3d center;
  Matrix3d axes;                   ///< Columns: longest, middle, shortest.
  std::vector<Vector3d> vertices;  ///< In these axes.
  Eigen::Array3d size;             ///< Extent along them [m].
};

RayFrame rayFrame(const Surface& surface, const Matrix4d& moments) {
  RayFrame frame;
  frame.center = moments.topRightCorner<3, 1>() / moments(3, 3);
  const Matrix3d cov = moments.topLeftCorner<3, 3>() / moments(3, 3) - frame.center * frame.center.transpose();
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(cov);
  frame.axes << solver.eigenvectors().col(2), solver.eigenvectors().col(1),
      solver.eigenvectors().col(2).cross(solver.eigenvectors().col(1));
  frame.vertices.reserve(surface.vertices.size());
  Eigen::Array3d low = Eigen::Array3d::Constant(1e300), high = -low;
  for (const Vector3d& p : surface.vertices) {
    frame.vertices.push_back(frame.axes.transpose() * (p - frame.center));
    low = low.min(frame.vertices.back().array());
    high = high.max(frame.vertices.back().array());
  }
  frame.size = high - low;
  return frame;
}

}  // namespace

Matrix4d volumeMoments(const Surface& surface) {
  if (surface.triangles.empty()) return Matrix4d::Zero();
  Vector3d reference = Vector3d::Zero();  // close to the body: far tetrahedra would cancel digits
  for (const Vector3d& v : surface.vertices) reference += v;
  reference /= static_cast<double>(surface.vertices.size());
  double volume = 0.0;
  Vector3d first = Vector3d::Zero();
  Matrix3d second = Matrix3d::Zero();
  for (const auto& t : surface.triangles) {
    const Vector3d a = surface.vertices[static_cast<std::size_t>(t[0])] - reference;
    const Vector3d b = surface.vertices[static_cast<std::size_t>(t[1])] - reference;
    const Vector3d c = surface.vertices[static_cast<std::size_t>(t[2])] - reference;
    const double v6 = a.dot(b.cross(c));
    const Vector3d s = a + b + c;
    volume += v6 / 6.0;
    first += v6 / 24.0 * s;
    second += v6 / 120.0 * (s * s.transpose() + a * a.transpose() + b * b.transpose() + c * c.transpose());
  }
  Matrix4d M;
  M << second, first, first.transpose(), volume;
  Matrix4d X = Matrix4d::Identity();
  X.topRightCorner<3, 1>() = reference;
  return X * M * X.transpose();
}

Matrix4d sheetMoments(const Surface& surface, double thickness) {
  Matrix4d M = Matrix4d::Zero();
  for (const auto& t : surface.triangles) {
    const Vector3d &a = surface.vertices[static_cast<std::size_t>(t[0])],
                   &b = surface.vertices[static_cast<std::size_t>(t[1])],
                   &c = surface.vertices[static_cast<std::size_t>(t[2])];
    const Vector3d cross = (b - a).cross(c - a);
    const double area = 0.5 * cross.norm();
    if (!(area > 0.0)) continue;
    const Vector3d s = a + b + c, n = cross / (2.0 * area);
    M.topLeftCorner<3, 3>() +=
        area / 12.0 * (s * s.transpose() + a * a.transpose() + b * b.transpose() + c * c.transpose()) +
        area * thickness * thickness / 12.0 * n * n.transpose();
    M.topRightCorner<3, 1>() += area / 3.0 * s;
    M(3, 3) += area;
  }
  M.bottomLeftCorner<1, 3>() = M.topRightCorner<3, 1>().transpose();
  return M * thickness;
}

WeightedPoints volumePoints(const Surface& surface, const Matrix4d& moments, double rays) {
  const double wantedSpans = rays / 4;
  WeightedPoints result;
  result.points.resize(3, 0);
  if (surface.triangles.empty()) return result;

  const RayFrame frame = rayFrame(surface, moments);
  const auto& v = frame.vertices;
  double spacing = std::sqrt(frame.size.x() * frame.size.y() / rays);
  if (!(spacing > 0.0)) return result;

  Columns columns;
  std::vector<Span> spans;
  for (int attempt = 0; attempt < 4; ++attempt) {  // thin-walled bodies need a finer grid
    columns = castRays(surface, v, spacing);
    spans = spansOf(columns);
    if (static_cast<double>(spans.size()) >= wantedSpans) break;
    spacing /= std::clamp(std::sqrt(1.3 * wantedSpans / (static_cast<double>(spans.size()) + 1.0)), 1.5, 4.0);
  }

  std::vector<Vector3d> points;
  std::vector<double> weights;
  long number = 0;
  double total = 0.0;
  for (const Span& span : spans) total += span.to - span.from;
  const double step = std::max(columns.spacing, total / (2.0 * rays));
  for (const Span& span : spans) {
    const double length = span.to - span.from;
    const long pieces = std::max(2L, std::lround(length / step));
    const double x = columns.origin.x() + columns.spacing * static_cast<double>(span.column % columns.nx);
    const double y = columns.origin.y() + columns.spacing * static_cast<double>(span.column / columns.nx);
    for (long k = 0; k < pieces; ++k) {
      const Vector3d u = evenPoint(number++);
      const double z = span.from + length * (static_cast<double>(k) + u.z()) / static_cast<double>(pieces);
      points.emplace_back(x, y, z);
      weights.push_back(length * span.layers / static_cast<double>(pieces) * columns.spacing * columns.spacing);
    }
  }
  result.points.resize(3, static_cast<Eigen::Index>(points.size()));
  result.weights.resize(static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    result.points.col(static_cast<Eigen::Index>(i)) = frame.center + frame.axes * points[i];
    result.weights[static_cast<Eigen::Index>(i)] = weights[i];
  }
  return result;
}

double overlapShare(const Surface& surface, const Matrix4d& moments) {
  const RayFrame frame = rayFrame(surface, moments);
  const double spacing = std::sqrt(frame.size.x() * frame.size.y() / 6000);
  if (!(spacing > 0.0)) return 0.0;
  double once = 0.0, all = 0.0;
  for (const Span& span : spansOf(castRays(surface, frame.vertices, spacing))) {
    once += span.to - span.from;
    all += (span.to - span.from) * span.layers;
  }
  return all > 0.0 ? (all - once) / all : 0.0;
}

WeightedPoints sheetPoints(const Surface& surface, double thickness) {
  constexpr long kWanted = 16384;
  double total = 0.0;
  std::vector<double> ends;
  ends.reserve(surface.triangles.size());
  const auto corner = [&](const std::array<int, 3>& t, int i) -> const Vector3d& {
    return surface.vertices[static_cast<std::size_t>(t[static_cast<std::size_t>(i)])];
  };
  for (const auto& t : surface.triangles) {
    total += 0.5 * (corner(t, 1) - corner(t, 0)).cross(corner(t, 2) - corner(t, 0)).norm();
    ends.push_back(total);
  }
  WeightedPoints result{Eigen::Matrix3Xd(3, kWanted), VectorXd::Constant(kWanted, 1.0 / kWanted)};
  std::size_t k = 0;
  for (long i = 0; i < kWanted; ++i) {
    const double wanted = total * (static_cast<double>(i) + 0.5) / kWanted;
    while (k + 1 < ends.size() && ends[k] < wanted) ++k;
    const auto& t = surface.triangles[k];
    const Vector3d u = evenPoint(i);
    const double root = std::sqrt(u.x());
    const Vector3d cross = (corner(t, 1) - corner(t, 0)).cross(corner(t, 2) - corner(t, 0));
    result.points.col(i) = (1 - root) * corner(t, 0) + root * (1 - u.y()) * corner(t, 1) + root * u.y() * corner(t, 2) +
                           (u.z() - 0.5) * thickness * cross.normalized();
  }
  return result;
}

}  // namespace heft
