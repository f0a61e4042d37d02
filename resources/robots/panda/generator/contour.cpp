#include "resources/robots/panda/generator/contour.h"

#include <map>

namespace heft::panda_maker {
namespace {

/// Cosines of angles between normals: within a cell, and between the corners that meet at a vertex.
struct Thresholds {
  double rim, split;
};
constexpr Thresholds kSoft{0.80, 0.75};    ///< 37 and 41 degrees
constexpr Thresholds kCrisp{0.975, 0.95};  ///< 13 and 18 degrees

constexpr double kHiddenDepth = 0.001;  ///< [m]

Vec gradient(const Field& f, Vec p) {
  constexpr double h = 2e-5;
  return unit({f({p.x + h, p.y, p.z}) - f({p.x - h, p.y, p.z}), f({p.x, p.y + h, p.z}) - f({p.x, p.y - h, p.z}),
               f({p.x, p.y, p.z + h}) - f({p.x, p.y, p.z - h})});
}

struct Crossing {
  Vec point, normal;
};

Crossing cross(const Field& f, Vec a, double fa, Vec b, double fb) {
  for (int step = 0; step < 12; ++step) {  // Secant steps kept inside by a little bisection.
    const double s = std::clamp(fa / (fa - fb), 0.05, 0.95);
    const Vec m = a + s * (b - a);
    const double fm = f(m);
    if ((fm < 0.0) == (fa < 0.0)) {
      a = m;
      fa = fm;
    } else {
      b = m;
      fb = fm;
    }
  }
  const Vec p = a + (fa / (fa - fb)) * (b - a);
  return {p, gradient(f, p)};
}

/// The point that is closest to all tangent planes, drawn a little to their mean so that it always exists.
Vec featurePoint(const std::vector<Crossing>& crossings, Vec mean) {
  constexpr double kPull = 0.02;
  double m[3][4] = {};
  for (const Crossing& c : crossings) {
    const double n[3] = {c.normal.x, c.normal.y, c.normal.z};
    const double d = dot(c.normal, c.point - mean);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) m[i][j] += n[i] * n[j];
      m[i][3] += n[i] * d;
    }
  }
  for (int i = 0; i < 3; ++i) m[i][i] += kPull;
  for (int i = 0; i < 3; ++i) {  // Symmetric and positive definite: no pivoting is needed.
    for (int j = i + 1; j < 3; ++j) {
      const double factor = m[j][i] / m[i][i];
      for (int k = i; k < 4; ++k) m[j][k] -= factor * m[i][k];
    }
  }
  double x[3];
  for (int i = 2; i >= 0; --i) {
    x[i] = m[i][3];
    for (int j = i + 1; j < 3; ++j) x[i] -= m[i][j] * x[j];
    x[i] /= m[i][i];
  }
  return mean + Vec{x[0], x[1], x[2]};
}

Vec ontoSurface(const Field& f, Vec p, double limit) {
  for (int step = 0; step < 4; ++step) {
    const Vec n = gradient(f, p);
    constexpr double h = 1e-5;
    const double slope = (f(p + h * n) - f(p - h * n)) / (2 * h);
    if (slope < 0.1) break;
    p = p - std::clamp(f(p) / slope, -limit, limit) * n;
  }
  return p;
}

class Contourer {
 public:
  Contourer(const Field& solid, const Box& box, double cell, double rimCosine)
      : f_(solid), low_(box.low), cell_(cell), rimCosine_(rimCosine) {
    n_[0] = cells(box.low.x, box.high.x);
    n_[1] = cells(box.low.y, box.high.y);
    n_[2] = cells(box.low.z, box.high.z);
    values_.resize(static_cast<std::size_t>(n_[0] + 1) * (n_[1] + 1) * (n_[2] + 1));
    for (int k = 0; k <= n_[2]; ++k) {
      for (int j = 0; j <= n_[1]; ++j) {
        for (int i = 0; i <= n_[0]; ++i) values_[corner(i, j, k)] = f_(position(i, j, k));
      }
    }
    cellCrossings_.resize(static_cast<std::size_t>(n_[0]) * n_[1] * n_[2]);
  }

  void run() {
    findCrossings();
    placeVertices();
    relax();
  }

  std::vector<Vec> vertices;
  std::vector<char> sharp;
  std::vector<std::array<int, 4>> quads;

 private:
  int cells(double low, double high) const { return static_cast<int>((high - low) / cell_) + 1; }
  std::size_t corner(int i, int j, int k) const {
    return (static_cast<std::size_t>(k) * (n_[1] + 1) + j) * (n_[0] + 1) + i;
  }
  std::size_t cellAt(int i, int j, int k) const { return (static_cast<std::size_t>(k) * n_[1] + j) * n_[0] + i; }
  Vec position(int i, int j, int k) const { return low_ + cell_ * Vec{double(i), double(j), double(k)}; }

  void findCrossings() {
    for (int k = 0; k <= n_[2]; ++k) {
      for (int j = 0; j <= n_[1]; ++j) {
        for (int i = 0; i <= n_[0]; ++i) {
          const int at[3] = {i, j, k};
          for (int axis = 0; axis < 3; ++axis) edge(at, axis);
        }
      }
    }
  }

  /// The grid edge from corner `at` along `axis`, with the four cells around it.
  void edge(const int (&at)[3], int axis) {
    if (at[axis] >= n_[axis]) return;
    int to[3] = {at[0], at[1], at[2]};
    ++to[axis];
    const double fa = values_[corner(at[0], at[1], at[2])], fb = values_[corner(to[0], to[1], to[2])];
    if ((fa < 0.0) == (fb < 0.0)) return;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    if (at[u] == 0 || at[v] == 0 || at[u] >= n_[u] || at[v] >= n_[v]) return;  // The box holds the solid: never.
    const Crossing crossing = cross(f_, position(at[0], at[1], at[2]), fa, position(to[0], to[1], to[2]), fb);
    std::array<std::size_t, 4> around{};
    constexpr int kTurn[4][2] = {{-1, -1}, {0, -1}, {0, 0}, {-1, 0}};
    for (int k = 0; k < 4; ++k) {
      int cell[3] = {at[0], at[1], at[2]};
      cell[u] += kTurn[k][0];
      cell[v] += kTurn[k][1];
      around[k] = cellAt(cell[0], cell[1], cell[2]);
      cellCrossings_[around[k]].push_back(crossing);
    }
    if (fa >= 0.0) std::swap(around[1], around[3]);  // Seen from outside, counter-clockwise.
    cellQuads_.push_back(around);
  }

  void placeVertices() {
    std::vector<int> index(cellCrossings_.size(), -1);
    for (std::size_t cell = 0; cell < cellCrossings_.size(); ++cell) {
      const std::vector<Crossing>& crossings = cellCrossings_[cell];
      if (crossings.empty()) continue;
      Vec mean, normal;
      for (const Crossing& c : crossings) {
        mean = mean + c.point;
        normal = normal + c.normal;
      }
      mean = mean * (1.0 / static_cast<double>(crossings.size()));
      normal = unit(normal);
      bool rim = false;
      for (const Crossing& c : crossings) rim = rim || dot(c.normal, normal) < rimCosine_;
      Vec p = rim ? featurePoint(crossings, mean) : ontoSurface(f_, mean, cell_);
      const int i = static_cast<int>(cell % n_[0]), j = static_cast<int>(cell / n_[0] % n_[1]),
                k = static_cast<int>(cell / n_[0] / n_[1]);
      const Vec from = position(i, j, k), to = position(i + 1, j + 1, k + 1);
      p = {std::clamp(p.x, from.x, to.x), std::clamp(p.y, from.y, to.y), std::clamp(p.z, from.z, to.z)};
      index[cell] = static_cast<int>(vertices.size());
      vertices.push_back(p);
      sharp.push_back(rim);
    }
    for (const auto& quad : cellQuads_) {
      quads.push_back({index[quad[0]], index[quad[1]], index[quad[2]], index[quad[3]]});
    }
  }

  /// Evens out the smooth part: towards the neighbours' mean, then back onto the surface.
  void relax() {
    for (int round = 0; round < 3; ++round) {
      std::vector<Vec> sum(vertices.size());
      std::vector<int> count(vertices.size(), 0);
      for (const auto& quad : quads) {
        for (int k = 0; k < 4; ++k) {
          sum[quad[k]] = sum[quad[k]] + vertices[quad[(k + 1) % 4]] + vertices[quad[(k + 3) % 4]];
          count[quad[k]] += 2;
        }
      }
      for (std::size_t k = 0; k < vertices.size(); ++k) {
        if (sharp[k] || count[k] == 0) continue;
        const Vec moved = 0.5 * vertices[k] + (0.5 / count[k]) * sum[k];
        vertices[k] = ontoSurface(f_, moved, 0.5 * cell_);
      }
    }
  }

  const Field& f_;
  Vec low_;
  double cell_, rimCosine_;
  int n_[3];
  std::vector<double> values_;
  std::vector<std::vector<Crossing>> cellCrossings_;
  std::vector<std::array<std::size_t, 4>> cellQuads_;
};

/// Splits vertices where the surface has a rim and gathers the result.
class Assembler {
 public:
  Assembler(const Field& f, const std::vector<Vec>& vertices, const std::vector<char>& sharp, double splitCosine)
      : f_(f), vertices_(vertices), sharp_(sharp), splitCosine_(splitCosine), copies_(vertices.size()) {}

  void add(const std::array<int, 3>& corners) {
    const Vec a = vertices_[corners[0]], b = vertices_[corners[1]], c = vertices_[corners[2]];
    const Vec facet = cross(b - a, c - a);
    if (length(facet) < 1e-12) return;
    const Vec centre = (1.0 / 3.0) * (a + b + c);
    std::array<unsigned, 3> triangle{};
    for (int k = 0; k < 3; ++k) {
      const Vec p = vertices_[corners[k]];
      if (!sharp_[corners[k]]) {
        if (copies_[corners[k]].empty()) newCopy(corners[k], gradient(f_, p));
        triangle[k] = copies_[corners[k]].front();
        continue;
      }
      // Just inside the triangle: on a rim each side has its own normal there.
      Vec normal = gradient(f_, p + 0.25 * (centre - p));
      if (dot(normal, facet) <= 0.0) normal = unit(facet);
      triangle[k] = copyOf(corners[k], normal);
    }
    result_.triangles.push_back(triangle);
  }

  Surface finish() {
    for (std::size_t k = 0; k < sums_.size(); ++k) {
      const Vec n = unit(sums_[k]);
      result_.normals.push_back({static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)});
    }
    return std::move(result_);
  }

 private:
  unsigned copyOf(int vertex, Vec normal) {
    for (const unsigned copy : copies_[vertex]) {
      if (dot(unit(sums_[copy]), normal) < splitCosine_) continue;
      sums_[copy] = sums_[copy] + normal;
      return copy;
    }
    return newCopy(vertex, normal);
  }

  unsigned newCopy(int vertex, Vec normal) {
    const auto copy = static_cast<unsigned>(sums_.size());
    const Vec p = vertices_[vertex];
    copies_[vertex].push_back(copy);
    sums_.push_back(normal);
    result_.vertices.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
    return copy;
  }

  const Field& f_;
  const std::vector<Vec>& vertices_;
  const std::vector<char>& sharp_;
  double splitCosine_;
  std::vector<std::vector<unsigned>> copies_;
  std::vector<Vec> sums_;
  Surface result_;
};

}  // namespace

Surface contour(const Field& solid, const Box& box, double cell, Edges edges, const Field& hidden) {
  const Thresholds& thresholds = edges == Edges::soft ? kSoft : kCrisp;
  Contourer contourer(solid, box, cell, thresholds.rim);
  contourer.run();
  const std::vector<Vec>& v = contourer.vertices;
  std::vector<char> covered(v.size(), 0);
  if (hidden) {
    for (std::size_t k = 0; k < v.size(); ++k) covered[k] = hidden(v[k]) < -kHiddenDepth;
  }
  Assembler assembler(solid, v, contourer.sharp, thresholds.split);
  for (const auto& q : contourer.quads) {
    if (covered[q[0]] && covered[q[1]] && covered[q[2]] && covered[q[3]]) continue;
    // A quad is cut along the diagonal that keeps rims whole, else along the shorter one.
    const int rim02 = contourer.sharp[q[0]] + contourer.sharp[q[2]],
              rim13 = contourer.sharp[q[1]] + contourer.sharp[q[3]];
    const bool first = rim02 != rim13 ? rim02 > rim13 : length(v[q[0]] - v[q[2]]) <= length(v[q[1]] - v[q[3]]);
    if (first) {
      assembler.add({q[0], q[1], q[2]});
      assembler.add({q[0], q[2], q[3]});
    } else {
      assembler.add({q[0], q[1], q[3]});
      assembler.add({q[1], q[2], q[3]});
    }
  }
  return assembler.finish();
}

}  // namespace heft::panda_maker
