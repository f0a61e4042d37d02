// Welding and repair of the surface of a body (declared in mesh_volume.h).
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <optional>
#include <set>
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
long makeNeighboursAgree(Surface& surface, const std::vector<HalfEdge>& edges) {
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
std::vector<int> pieces(const Surface& surface, const std::vector<HalfEdge>& edges, int& count) {
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

/// Edges that are run through more often in one direction than in the other, in the direction that a filling triangle
/// needs.
std::vector<std::array<int, 2>> openEdges(const std::vector<HalfEdge>& edges) {
  std::vector<std::array<int, 2>> open;
  forEachEdge(edges, [&](std::size_t i, std::size_t end) {
    int balance = 0;
    for (std::size_t k = i; k < end; ++k) balance += edges[k].forward ? 1 : -1;
    for (; balance > 0; --balance) open.push_back({edges[i].high, edges[i].low});
    for (; balance < 0; ++balance) open.push_back({edges[i].low, edges[i].high});
  });
  return open;
}

/// Closes each group of connected open edges with a fan about its centre. Returns the area of the fans at edges for
/// which isHole(a, b) holds.
template <class IsHole>
double fillHoles(Surface& surface, IsHole isHole) {
  const auto open = openEdges(halfEdges(surface));
  if (open.empty()) return 0.0;
  const auto at = [&](int i) -> const Vector3d& { return surface.vertices[static_cast<std::size_t>(i)]; };
  Sets sets(surface.vertices.size());
  for (const auto& e : open) sets.join(e[0], e[1]);
  struct Hole {
    Vector3d sum = Vector3d::Zero();
    double length = 0.0;
    int center = -1;
  };
  std::unordered_map<int, Hole> holes;
  for (const auto& e : open) {
    Hole& hole = holes[sets.find(e[0])];
    const double length = (at(e[0]) - at(e[1])).norm();
    hole.sum += 0.5 * length * (at(e[0]) + at(e[1]));
    hole.length += length;
  }
  double area = 0.0;
  for (const auto& e : open) {
    Hole& hole = holes[sets.find(e[0])];
    if (hole.center < 0) {
      hole.center = static_cast<int>(surface.vertices.size());
      const Vector3d center = hole.length > 0 ? Vector3d(hole.sum / hole.length) : at(e[0]);
      surface.vertices.push_back(center);
    }
    surface.triangles.push_back({e[0], e[1], hole.center});
    if (isHole(e[0], e[1])) area += areaOf(surface, surface.triangles.back());
  }
  return area;
}

double totalArea(const Surface& surface) {
  double area = 0.0;
  for (const auto& t : surface.triangles) area += areaOf(surface, t);
  return area;
}

/// How often the surface winds around p: solid angle over 4 pi (Van Oosterom and Strackee 1983).
double winding(const Surface& surface, const Vector3d& p) {
  double angle = 0.0;
  for (const auto& t : surface.triangles) {
    const Vector3d a = surface.vertices[static_cast<std::size_t>(t[0])] - p;
    const Vector3d b = surface.vertices[static_cast<std::size_t>(t[1])] - p;
    const Vector3d c = surface.vertices[static_cast<std::size_t>(t[2])] - p;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    angle += 2.0 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return angle / (4.0 * std::numbers::pi);
}

/// A part of a surface with its own vertices, and where they come from.
struct Part {
  Surface surface;
  std::vector<int> origin;  ///< Of each vertex, in the whole surface; fans add vertices without one.
  double holeArea = 0.0;
  double volume = 0.0;
};

std::vector<Part> split(const Surface& surface, const std::vector<int>& label, int count) {
  std::vector<Part> parts(static_cast<std::size_t>(count));
  std::vector<std::vector<std::size_t>> members(parts.size());
  for (std::size_t i = 0; i < label.size(); ++i) members[static_cast<std::size_t>(label[i])].push_back(i);
  std::vector<int> local(surface.vertices.size(), -1);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    Part& part = parts[k];
    for (const std::size_t i : members[k]) {
      std::array<int, 3> triangle{};
      for (std::size_t c = 0; c < 3; ++c) {
        int& number = local[static_cast<std::size_t>(surface.triangles[i][c])];
        if (number < 0) {
          number = static_cast<int>(part.surface.vertices.size());
          part.surface.vertices.push_back(surface.vertices[static_cast<std::size_t>(surface.triangles[i][c])]);
          part.origin.push_back(surface.triangles[i][c]);
        }
        triangle[c] = number;
      }
      part.surface.triangles.push_back(triangle);
    }
    for (const int v : part.origin) local[static_cast<std::size_t>(v)] = -1;
  }
  return parts;
}

/// Joins vertices on open edges that lie closer together than `tolerance` [m]. True if it changed anything.
bool closeSeams(Surface& surface, const std::vector<HalfEdge>& edges, double tolerance) {
  std::vector<char> isOpen(surface.vertices.size(), 0);
  forEachEdge(edges, [&](std::size_t i, std::size_t end) {
    if ((end - i) % 2 == 0) return;
    isOpen[static_cast<std::size_t>(edges[i].low)] = 1;
    isOpen[static_cast<std::size_t>(edges[i].high)] = 1;
  });
  std::vector<int> open;
  for (std::size_t i = 0; i < isOpen.size(); ++i)
    if (isOpen[i]) open.push_back(static_cast<int>(i));
  if (open.empty()) return false;
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
  return true;
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

void append(Surface& surface, const Surface& other) {
  const int offset = static_cast<int>(surface.vertices.size());
  surface.vertices.insert(surface.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto& t : other.triangles) surface.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
}

namespace {

/// Turns pieces that are inside out, and puts cavities into the piece around them.
std::vector<Surface> nested(std::vector<Part> parts, SurfaceReport& report) {
  double total = 0.0;
  for (const Part& part : parts) total += part.volume;
  const auto turnPart = [](Part& part) {
    for (auto& t : part.surface.triangles) turn(t);
    part.volume = -part.volume;
  };
  const bool insideOut = total < 0.0;
  const double sliver = 1e-6 * std::abs(total);  // smaller volumes have no sign worth minding
  if (insideOut)
    for (Part& part : parts) turnPart(part);
  std::vector<std::size_t> outward, inward;
  for (std::size_t k = 0; k < parts.size(); ++k) (parts[k].volume >= -sliver ? outward : inward).push_back(k);
  std::vector<std::vector<std::size_t>> cavities(parts.size());
  if (insideOut) report.turnedBodies = static_cast<long>(parts.size());
  for (const std::size_t k : inward) {
    const auto& t = parts[k].surface.triangles.front();
    Vector3d p = Vector3d::Zero();  // on the piece
    for (const int v : t) p += parts[k].surface.vertices[static_cast<std::size_t>(v)] / 3.0;
    std::optional<std::size_t> around;
    for (const std::size_t other : outward)
      if (parts[other].volume > -parts[k].volume && (!around || parts[other].volume < parts[*around].volume) &&
          winding(parts[other].surface, p) > 0.5)
        around = other;
    if (around) {
      cavities[*around].push_back(k);
      ++report.cavities;
    } else {
      turnPart(parts[k]);
      report.turnedBodies += insideOut ? -1 : 1;
      outward.push_back(k);
    }
  }
  std::vector<Surface> pieces;
  for (const std::size_t k : outward) {
    for (const std::size_t hollow : cavities[k]) append(parts[k].surface, parts[hollow].surface);
    pieces.push_back(std::move(parts[k].surface));
  }
  return pieces;
}

}  // namespace

ClosedPieces closePieces(Surface surface) {
  // More than this share of covers, and a piece is rather a patch of something larger.
  constexpr double kPatch = 0.1;
  ClosedPieces result;
  SurfaceReport& report = result.report;
  auto edges = halfEdges(surface);
  if (closeSeams(surface, edges, 1e-6 * diagonal(surface))) edges = halfEdges(surface);
  report.area = totalArea(surface);
  report.turnedTriangles = makeNeighboursAgree(surface, edges);
  if (report.turnedTriangles > 0) edges = halfEdges(surface);
  forEachEdge(edges, [&](std::size_t i, std::size_t end) {
    if (end - i > 2) ++report.sharedEdges;
  });
  const auto open = openEdges(edges);
  report.openEdges = static_cast<long>(open.size());
  const std::set<std::pair<int, int>> holes = [&] {
    std::set<std::pair<int, int>> all;
    for (const auto& e : open) all.insert(std::minmax(e[0], e[1]));
    return all;
  }();
  const auto close = [&](Part& part) {
    if (open.empty() && report.sharedEdges == 0) return;  // pieces of a closed surface are closed
    part.holeArea = fillHoles(part.surface, [&](int a, int b) {
      return holes.contains(
          std::minmax(part.origin[static_cast<std::size_t>(a)], part.origin[static_cast<std::size_t>(b)]));
    });
  };

  int count = 0;
  auto label = pieces(surface, edges, count);
  std::vector<Part> parts = split(surface, label, count);
  int patches = -1;  // all patches become one piece: only together they can be closed
  std::vector<int> renamed(parts.size());
  int next = 0;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const double area = totalArea(parts[k].surface);
    close(parts[k]);
    const bool patch = parts[k].holeArea > kPatch * area;
    if (patch && patches < 0) patches = next++;
    renamed[k] = patch ? patches : next++;
  }
  if (patches >= 0) {
    for (int& l : label) l = renamed[static_cast<std::size_t>(l)];
    parts = split(surface, label, next);
  }
  for (Part& part : parts) {
    if (patches >= 0) close(part);
    report.holeArea += part.holeArea;
    part.volume = volumeMoments(part.surface)(3, 3);
  }
  report.bodies = static_cast<long>(parts.size());
  result.pieces = nested(std::move(parts), report);
  return result;
}

}  // namespace heft
