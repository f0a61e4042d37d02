#include "core/collision/hull.h"

#include <cstdio>
#include <memory>
#include <vector>

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

#include "core/base/say.h"
#include "core/math/linear_algebra.h"

namespace heft {

namespace {

constexpr double kThickness = 0.0005;  ///< Of what is flat [m]: a sheet of paper is 0.1 mm

/// `points` about their mean, and copies beside them along the axes in which they have no extent.
Eigen::Matrix3Xd thickened(const Eigen::Matrix3Xd& points) {
  const Vector3d mean = points.rowwise().mean();
  Eigen::Matrix3Xd out = points.colwise() - mean;
  const MatrixXd axes = symmetricEigen(Matrix3d(out * out.transpose())).vectors;
  for (int i = 0; i < 3; ++i) {
    const Vector3d axis = axes.col(i);
    const Eigen::RowVectorXd along = axis.transpose() * out;
    if (along.maxCoeff() - along.minCoeff() >= 0.2 * kThickness) continue;
    Eigen::Matrix3Xd both(3, 2 * out.cols());
    both << out.colwise() + Vector3d(0.5 * kThickness * axis), out.colwise() - Vector3d(0.5 * kThickness * axis);
    out = both;
  }
  return out.colwise() + mean;
}

/// Qhull's state, given back when it goes.
struct Qhull {
  qhT state{};
  Qhull() { qh_zero(&state, nullptr); }
  ~Qhull() {
    qh_freeqhull(&state, !qh_ALL);
    int kept = 0, total = 0;
    qh_memfreeshort(&state, &kept, &total);
  }
  Qhull(const Qhull&) = delete;
  Qhull& operator=(const Qhull&) = delete;
};

}  // namespace

bool ConvexHull::contains(const Vector3d& point) const {
  return faces.cols() > 0 && ((faces.topRows<3>().transpose() * point + faces.row(3).transpose()).array() <= 0.0).all();
}

Eigen::Matrix3Xd columnsOf(const std::vector<Vector3d>& points) {
  Eigen::Matrix3Xd out(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) out.col(static_cast<Eigen::Index>(i)) = points[i];
  return out;
}

Eigen::Matrix3Xd boxCorners(const Vector3d& size) {
  Eigen::Matrix3Xd out(3, 8);
  for (int i = 0; i < 8; ++i)
    out.col(i) = 0.5 * size.cwiseProduct(Vector3d(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
  return out;
}

Result<ConvexHull> convexHull(const Eigen::Matrix3Xd& points) {
  if (points.cols() == 0) return Error{heft::say("There are no points to build a hull from.")};
  Eigen::Matrix3Xd given = thickened(points);
  const std::unique_ptr<FILE, int (*)(FILE*)> silent(std::fopen("/dev/null", "w"), &std::fclose);
  Qhull hull;
  // Qt: triangles only; Pp: no word about precision.
  char options[] = "qhull Qt Pp";
  if (qh_new_qhull(&hull.state, 3, static_cast<int>(given.cols()), given.data(), False, options, silent.get(),
                   silent.get()) != 0)
    return Error{heft::say("The hull of {} points cannot be computed.", given.cols())};
  ConvexHull out;
  std::vector<int> number(static_cast<std::size_t>(given.cols()), -1);
  std::vector<Vector3d> vertices;
  std::vector<Eigen::Vector4d> faces;
  qhT* const qh = &hull.state;  // Qhull's macros ask for this name
  facetT* facet = nullptr;
  FORALLfacets {
    std::array<int, 3> triangle{};
    std::size_t corner = 0;
    vertexT *vertex = nullptr, **vertexp = nullptr;
    FOREACHvertex_(facet->vertices) {
      const auto point = static_cast<std::size_t>(qh_pointid(qh, vertex->point));
      if (number[point] < 0) {
        number[point] = static_cast<int>(vertices.size());
        vertices.emplace_back(vertex->point[0], vertex->point[1], vertex->point[2]);
      }
      if (corner < 3) triangle[corner++] = number[point];
    }
    if (corner < 3) continue;
    const Vector3d normal(facet->normal[0], facet->normal[1], facet->normal[2]);
    const auto at = [&](std::size_t i) { return vertices[static_cast<std::size_t>(triangle[i])]; };
    if ((at(1) - at(0)).cross(at(2) - at(0)).dot(normal) < 0.0) std::swap(triangle[1], triangle[2]);
    out.triangles.push_back(triangle);
    faces.emplace_back(normal.x(), normal.y(), normal.z(), facet->offset);
  }
  out.vertices = columnsOf(vertices);
  out.faces.resize(4, static_cast<Eigen::Index>(faces.size()));
  for (std::size_t i = 0; i < faces.size(); ++i) out.faces.col(static_cast<Eigen::Index>(i)) = faces[i];
  return out;
}

}  // namespace heft
