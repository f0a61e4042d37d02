// Welding and repair of the surface of a body (declared in mesh_volume.h).
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <unordered_map>

#include "core/payload/mesh_volume.h"

namespace heft {

namespace {

/// Disjoint sets with path halving.
class Sets {
 public:
  explicit Sets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }
  int find(int i) {
    while (at(i) != i) i = at(i) = at(at(i));
    return i;
  }
  void join(int a, int b) { at(find(a)) = find(b); }

 private:
  int& at(int i) { return parent_[static_cast<std::size_t>(i)]; }
  std::vector<int> parent_;
};

struct HalfEdge {
  int low, high;  ///< Vertices.
  int triangle;
  bool forward;  ///< The triangle runs from low to high.
};

std::vector<HalfEdge> halfEdges(const Surface& surface) {
  std::vector<HalfEdge> edges;
  edges.reserve(3 * surface.triangles.size());
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = surface.triangles[i][k], b = surface.triangles[i][(k + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b), static_cast<int>(i), a < b});
    }
  std::sort(edges.begin(), edges.end(), [](const HalfEdge& x, const HalfEdge& y) {
    if (x.low != y.low) return x.low < y.low;
    if (x.high != y.high) return x.high < y.high;
    return x.triangle < y.triangle;
  });
  return edges;
}

/// Calls visit(first, last) for the half-edges of each edge.
template <class Visit>
void forEachEdge(const std::vector<HalfEdge>& edges, Visit visit) {
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i;
    while (end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high) ++end;
    visit(i, end);
    i = end;
  }
}

void turn(std::array<int, 3>& triangle) { std::swap(triangle[1], triangle[2]); }

void dropLines(Surface& surface) {
  std::erase_if(surface.triangles, [](const auto& t) { return t[0] == t[1] || t[1] == t[2] || t[0] == t[2]; });
}

double areaOf(const Surface& surface, const std::array<int, 3>& t) {
  const Vector3d& a = surface.vertices[static_cast<std::size_t>(t[0])];
  return 0.5 * (surface.vertices[static_cast<std::size_t>(t[1])] - a)
                   .cross(surface.vertices[static_cast<std::size_t>(t[2])] - a)
                   .norm();
}

double diagonal(const Surface& surface) {
  if (surface.vertices.empty()) return 0.0;
  Eigen::Array3d low = surface.vertices.front(), high = low;
  for (const Vector3d& v : surface.vertices) {
    low = low.min(v.array());
    high = high.max(v.array());
  }
  return (high - low).matrix().norm();
}

/// Turns triangles so that the two at each simple edge run through it in opposite directions. Returns how many were
/// turned.
long makeNeighboursAgree(Surface& surface) {
  const auto edges = halfEdges(surface);
  bool agree = true;
  forEachEdge(edges, [&](std::size_t i, std::size_t end) {
    if (end - i == 2 && edges[i].forward == edges[i + 1].forward) agree = false;
  });
  if (agree) return 0;

  struct Neighbour {
    int triangle;
    bool opposite;
  };
  std::vector<std::vector<Neighbour>> neighbours(surface.triangles.size());
  forEachEdge(edges, [&](std::size_t i, std::size_t end) {
    if (end - i != 2) return;
    const bool opposite = edges[i].forward != edges[i + 1].forward;
    neighbours[static_cast<std::size_t>(edges[i].triangle)].push_back({edges[i + 1].triangle, opposite});
    neighbours[static_cast<std::size_t>(edges[i + 1].triangle)].push_back({edges[i].triangle, opposite});
  });
  long turned = 0;
  std::vector<int> state(surface.triangles.size(), 0);  // 0 unseen, 1 keep, -1 turn
  for (std::size_t seed = 0; seed < state.size(); ++seed) {
    if (state[seed] != 0) continue;
    std::vector<std::size_t> piece{seed};
    state[seed] = 1;
    double turnedArea = 0.0, area = 0.0;
    for (std::size_t next = 0; next < piece.size(); ++next) {
      const std::size_t i = piece[next];
      const double a = areaOf(surface, surface.triangles[i]);
      area += a;
      if (state[i] < 0) turnedArea += a;
      for (const Neighbour& n : neighbours[i]) {
        auto& other = state[static_cast<std::size_t>(n.triangle)];
        if (other != 0) continue;
        other = n.opposite ? state[i] : -state[i];
        piece.push_back(static_cast<std::size_t>(n.triangle));
      }
    }
    const int minority = turnedArea <= 0.5 * area ? -1 : 1;
    for (const std::size_t i : piece)
      if (state[i] == minority) {
        turn(surface.triangles[i]);
        ++turned;
      }
  }
  return turned;
}

/// Piece number of each triangle: triangles that share a simple edge belong together. Bodies that only touch along
/// edges with four triangles stay apart.
std::vector<int> pieces(const Surface& surface, int& count) {
  const auto edges = halfEdges(surface);
  Sets sets(surface.triangles.size());
  forEachEdge(edges, [&](std::size_t i, std::size_t end) {
    if (end - i == 2) sets.join(edges[i].triangle, edges[i + 1].triangle);
  });
  std::vector<int> label(surface.triangles.size(), -1), result(surface.triangles.size());
  count = 0;
  for (std::size_t i = 0; i < result.size(); ++i) {
    int& root = label[static_cast<std::size_t>(sets.find(static_cast<int>(i)))];
    if (root < 0) root = count++;
    result[i] = root;
  }
  return result;
}

/// How often the surface winds around p: solid angle over 4 pi (Van Oosterom and Strackee 1983).
double winding(const Surface& surface, const std::vector<int>& label, const std::vector<char>& use, const Vector3d& p) {
  double angle = 0.0;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    if (!use[static_cast<std::size_t>(label[i])]) continue;
    const auto& t = surface.triangles[i];
    const Vector3d a = surface.vertices[static_cast<std::size_t>(t[0])] - p;
    const Vector3d b = surface.vertices[static_cast<std::size_t>(t[1])] - p;
    const Vector3d c = surface.vertices[static_cast<std::size_t>(t[2])] - p;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    angle += 2.0 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return angle / (4.0 * std::numbers::pi);
}

/// Closes each group of connected open edges with a fan about its centre.
void fillHoles(Surface& surface, SurfaceReport& report) {
  const auto edges = halfEdges(surface);
  std::vector<std::array<int, 2>> open;  // in the direction that a filling triangle has to run
  forEachEdge(edges, [&](std::size_t i, std::size_t end) {
    int balance = 0;
    for (std::size_t k = i; k < end; ++k) balance += edges[k].forward ? 1 : -1;
    for (; balance > 0; --balance) open.push_back({edges[i].high, edges[i].low});
    for (; balance < 0; ++balance) open.push_back({edges[i].low, edges[i].high});
  });
  report.openEdges = static_cast<long>(open.size());
  if (open.empty()) return;
  Sets sets(surface.vertices.size());
  for (const auto& e : open) sets.join(e[0], e[1]);
  struct Hole {
    Vector3d sum = Vector3d::Zero();
    double length = 0.0;
    int center = -1;
  };
  std::unordered_map<int, Hole> holes;
  for (const auto& e : open) {
    const Vector3d &a = surface.vertices[static_cast<std::size_t>(e[0])],
                   &b = surface.vertices[static_cast<std::size_t>(e[1])];
    Hole& hole = holes[sets.find(e[0])];
    const double length = (a - b).norm();
    hole.sum += 0.5 * length * (a + b);
    hole.length += length;
  }
  for (const auto& e : open) {
    Hole& hole = holes[sets.find(e[0])];
    if (hole.center < 0) {
      hole.center = static_cast<int>(surface.vertices.size());
      surface.vertices.push_back(hole.length > 0 ? Vector3d(hole.sum / hole.length)
                                                 : surface.vertices[static_cast<std::size_t>(e[0])]);
    }
    surface.triangles.push_back({e[0], e[1], hole.center});
    report.holeArea += areaOf(surface, surface.triangles.back());
  }
}

}  // namespace

Surface weld(const Mesh& mesh, double unit, long* dropped) {
  struct Key {
    std::array<std::uint32_t, 3> bits;
    bool operator==(const Key&) const = default;
  };
  struct Hash {
    std::size_t operator()(const Key& k) const {
      std::uint64_t h = k.bits[0] * 0x9E3779B97F4A7C15ull;
      h = (h ^ (h >> 29) ^ k.bits[1]) * 0xBF58476D1CE4E5B9ull;
      h = (h ^ (h >> 32) ^ k.bits[2]) * 0x94D049BB133111EBull;
      return h ^ (h >> 31);
    }
  };
  Surface surface;
  std::unordered_map<Key, int, Hash> known;
  std::size_t vertexCount = 0;
  for (const MeshPart& part : mesh.parts) vertexCount += part.vertices.size();
  known.reserve(vertexCount);
  surface.triangles.reserve(mesh.triangleCount());
  long bad = 0;
  for (const MeshPart& part : mesh.parts) {
    std::vector<int> number(part.vertices.size(), -1);
    for (std::size_t i = 0; i < part.vertices.size(); ++i) {
      const Eigen::Vector3f v = part.vertices[i] + Eigen::Vector3f::Zero();  // -0 becomes +0
      if (!v.allFinite()) continue;
      const Key key{{std::bit_cast<std::uint32_t>(v.x()), std::bit_cast<std::uint32_t>(v.y()),
                     std::bit_cast<std::uint32_t>(v.z())}};
      const auto [it, isNew] = known.try_emplace(key, static_cast<int>(surface.vertices.size()));
      if (isNew) surface.vertices.push_back(v.cast<double>() * unit);
      number[i] = it->second;
    }
    for (const auto& t : part.triangles) {
      std::array<int, 3> triangle{-1, -1, -1};
      for (std::size_t k = 0; k < 3; ++k)
        if (t[k] < number.size()) triangle[k] = number[t[k]];
      if (*std::min_element(triangle.begin(), triangle.end()) < 0)
        ++bad;
      else
        surface.triangles.push_back(triangle);
    }
  }
  dropLines(surface);
  if (dropped) *dropped = bad;
  return surface;
}

void closeSeams(Surface& surface, double tolerance) {
  if (!(tolerance > 0.0)) return;
  const auto edges = halfEdges(surface);
  std::vector<char> isOpen(surface.vertices.size(), 0);
  forEachEdge(edges, [&](std::size_t i, std::size_t end) {
    if ((end - i) % 2 == 0) return;
    isOpen[static_cast<std::size_t>(edges[i].low)] = 1;
    isOpen[static_cast<std::size_t>(edges[i].high)] = 1;
  });
  std::vector<int> open;
  for (std::size_t i = 0; i < isOpen.size(); ++i)
    if (isOpen[i]) open.push_back(static_cast<int>(i));
  if (open.empty()) return;
  const auto at = [&](int i) -> const Vector3d& { return surface.vertices[static_cast<std::size_t>(i)]; };
  std::sort(open.begin(), open.end(),
            [&](int a, int b) { return at(a).x() < at(b).x() || (at(a).x() == at(b).x() && a < b); });
  Sets sets(surface.vertices.size());
  for (std::size_t i = 0; i < open.size(); ++i)
    for (std::size_t k = i + 1; k < open.size() && at(open[k]).x() - at(open[i]).x() <= tolerance; ++k)
      if ((at(open[k]) - at(open[i])).squaredNorm() <= tolerance * tolerance) sets.join(open[k], open[i]);
  for (auto& t : surface.triangles)
    for (int& v : t)
      if (isOpen[static_cast<std::size_t>(v)]) v = sets.find(v);
  dropLines(surface);
}

SurfaceReport repair(Surface& surface) {
  SurfaceReport report;
  closeSeams(surface, 1e-6 * diagonal(surface));
  for (const auto& t : surface.triangles) report.area += areaOf(surface, t);
  report.turnedTriangles = makeNeighboursAgree(surface);
  forEachEdge(halfEdges(surface), [&](std::size_t i, std::size_t end) {
    if (end - i > 2) ++report.sharedEdges;
  });

  // Volume of each piece about its own centre, so that an open piece far from the origin is not misjudged.
  int count = 0;
  const auto label = pieces(surface, count);
  report.bodies = count;
  std::vector<Vector3d> center(static_cast<std::size_t>(count), Vector3d::Zero());
  std::vector<double> corners(center.size(), 0.0), volume(center.size(), 0.0);
  for (std::size_t i = 0; i < label.size(); ++i)
    for (const int v : surface.triangles[i]) {
      center[static_cast<std::size_t>(label[i])] += surface.vertices[static_cast<std::size_t>(v)];
      corners[static_cast<std::size_t>(label[i])] += 1.0;
    }
  for (std::size_t k = 0; k < center.size(); ++k) center[k] /= corners[k];
  for (std::size_t i = 0; i < label.size(); ++i) {
    const auto k = static_cast<std::size_t>(label[i]);
    const auto& t = surface.triangles[i];
    const Vector3d a = surface.vertices[static_cast<std::size_t>(t[0])] - center[k];
    const Vector3d b = surface.vertices[static_cast<std::size_t>(t[1])] - center[k];
    const Vector3d c = surface.vertices[static_cast<std::size_t>(t[2])] - center[k];
    volume[k] += a.dot(b.cross(c)) / 6.0;
  }
  const bool insideOut = std::accumulate(volume.begin(), volume.end(), 0.0) < 0.0;
  std::vector<char> turnPiece(volume.size(), 0), outward(volume.size(), 0);
  if (insideOut) {
    for (auto& t : surface.triangles) turn(t);
    for (double& v : volume) v = -v;
  }
  for (std::size_t k = 0; k < volume.size(); ++k) outward[k] = volume[k] > 0.0;
  for (std::size_t k = 0; k < volume.size(); ++k) {
    if (volume[k] >= 0.0) continue;
    const auto i = static_cast<std::size_t>(std::find(label.begin(), label.end(), static_cast<int>(k)) - label.begin());
    Vector3d p = Vector3d::Zero();  // on the piece
    for (const int v : surface.triangles[i]) p += surface.vertices[static_cast<std::size_t>(v)] / 3.0;
    if (winding(surface, label, outward, p) > 0.5)
      ++report.cavities;
    else
      turnPiece[k] = 1;
  }
  for (std::size_t i = 0; i < label.size(); ++i)
    if (turnPiece[static_cast<std::size_t>(label[i])]) turn(surface.triangles[i]);
  for (std::size_t k = 0; k < volume.size(); ++k)
    report.turnedBodies += turnPiece[k] != static_cast<char>(insideOut) && volume[k] != 0.0;
  fillHoles(surface, report);
  return report;
}

}  // namespace heft
