#include "core/payload/shape_moments.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace heft {

namespace {

constexpr double kPi = std::numbers::pi;

/// Moments of a body with this volume, centre height and central second moments.
Matrix4d moments(double volume, double centerZ, const Vector3d& secondMoments) {
  Matrix4d M = Matrix4d::Zero();
  M.diagonal() << volume * secondMoments, volume;
  M(2, 2) += volume * centerZ * centerZ;
  M(2, 3) = M(3, 2) = volume * centerZ;
  return M;
}

Matrix4d solidMoments(const ShapeBody& body) {
  const auto& d = body.dims;
  switch (body.kind) {
    case BodyKind::box:
    case BodyKind::plate:
      return moments(d[0] * d[1] * d[2], 0.0, Vector3d(d[0] * d[0], d[1] * d[1], d[2] * d[2]) / 12.0);
    case BodyKind::cylinder:
      return moments(kPi * d[0] * d[0] * d[1], 0.0, {d[0] * d[0] / 4, d[0] * d[0] / 4, d[1] * d[1] / 12});
    case BodyKind::tube: {
      const double sum = d[0] * d[0] + d[1] * d[1];
      return moments(kPi * (d[0] - d[1]) * (d[0] + d[1]) * d[2], 0.0, {sum / 4, sum / 4, d[2] * d[2] / 12});
    }
    case BodyKind::sphere:
      return moments(4.0 / 3.0 * kPi * d[0] * d[0] * d[0], 0.0, Vector3d::Constant(d[0] * d[0] / 5));
    case BodyKind::cone:
      return moments(kPi / 3.0 * d[0] * d[0] * d[1], d[1] / 4,
                     {3 * d[0] * d[0] / 20, 3 * d[0] * d[0] / 20, 3 * d[1] * d[1] / 80});
    case BodyKind::capsule: {
      // The caps are a sphere cut in half and pulled apart by the length; each half's centre is 3/8 r from the cut.
      const double r2 = d[0] * d[0], l = d[1];
      const double capsZ = r2 / 5 + 2 * (3.0 / 8.0 * d[0]) * (l / 2) + l * l / 4;
      return moments(kPi * r2 * l, 0.0, {r2 / 4, r2 / 4, l * l / 12}) +
             moments(4.0 / 3.0 * kPi * r2 * d[0], 0.0, {r2 / 5, r2 / 5, capsZ});
    }
    case BodyKind::mesh:
      break;
  }
  return Matrix4d::Zero();
}

bool insideSolid(const ShapeBody& body, const Vector3d& p) {
  const auto& d = body.dims;
  const double r2 = p.x() * p.x() + p.y() * p.y(), z = p.z();
  switch (body.kind) {
    case BodyKind::box:
    case BodyKind::plate:
      return std::abs(p.x()) <= d[0] / 2 && std::abs(p.y()) <= d[1] / 2 && std::abs(z) <= d[2] / 2;
    case BodyKind::cylinder:
      return r2 <= d[0] * d[0] && std::abs(z) <= d[1] / 2;
    case BodyKind::tube:
      return r2 <= d[0] * d[0] && r2 >= d[1] * d[1] && std::abs(z) <= d[2] / 2;
    case BodyKind::sphere:
      return r2 + z * z <= d[0] * d[0];
    case BodyKind::cone: {
      const double r = d[0] * (1 - z / d[1]);
      return z >= 0 && z <= d[1] && r2 <= r * r;
    }
    case BodyKind::capsule: {
      const double beyond = std::max(0.0, std::abs(z) - d[1] / 2);
      return r2 + beyond * beyond <= d[0] * d[0];
    }
    case BodyKind::mesh:
      break;
  }
  return false;
}

/// Lowest and highest z of a primitive.
std::pair<double, double> heightRange(const ShapeBody& body) {
  const auto& d = body.dims;
  switch (body.kind) {
    case BodyKind::box:
    case BodyKind::plate:
    case BodyKind::tube:
      return {-d[2] / 2, d[2] / 2};
    case BodyKind::cylinder:
      return {-d[1] / 2, d[1] / 2};
    case BodyKind::cone:
      return {0.0, d[1]};
    case BodyKind::sphere:
      return {-d[0], d[0]};
    case BodyKind::capsule:
      return {-d[1] / 2 - d[0], d[1] / 2 + d[0]};
    case BodyKind::mesh:
      break;
  }
  return {0.0, 0.0};
}

}  // namespace

double inradius(const ShapeBody& body) {
  const auto& d = body.dims;
  switch (body.kind) {
    case BodyKind::box:
    case BodyKind::plate:
      return std::min({d[0], d[1], d[2]}) / 2;
    case BodyKind::cylinder:
      return std::min(d[0], d[1] / 2);
    case BodyKind::tube:
      return std::min((d[0] - d[1]) / 2, d[2] / 2);
    case BodyKind::cone:
      return d[0] * d[1] / (d[0] + std::hypot(d[0], d[1]));
    case BodyKind::sphere:
    case BodyKind::capsule:
      return d[0];
    case BodyKind::mesh:
      break;
  }
  return 0.0;
}

ShapeBody cavityOf(const ShapeBody& body) {
  ShapeBody cavity = body;
  cavity.wall.reset();
  cavity.X_SB.setIdentity();
  const double t = body.wall.value_or(0.0);
  auto& d = cavity.dims;
  switch (body.kind) {
    case BodyKind::box:
    case BodyKind::plate:
      for (double& x : d) x -= 2 * t;
      break;
    case BodyKind::cylinder:
      d[0] -= t;
      d[1] -= 2 * t;
      break;
    case BodyKind::sphere:
    case BodyKind::capsule:
      d[0] -= t;
      break;
    case BodyKind::cone: {
      // Every face moves inwards by t: a smaller cone of the same angle that shares the inscribed sphere's centre.
      const double scale = 1 - t / inradius(body);
      d[0] *= scale;
      d[1] *= scale;
      cavity.X_SB.translation().z() = t;
      break;
    }
    case BodyKind::tube:
    case BodyKind::mesh:
      break;
  }
  return cavity;
}

Matrix4d primitiveMoments(const ShapeBody& body) {
  Matrix4d M = solidMoments(body);
  if (body.wall) {
    const ShapeBody cavity = cavityOf(body);
    M -= cavity.X_SB.matrix() * solidMoments(cavity) * cavity.X_SB.matrix().transpose();
  }
  return M;
}

bool insidePrimitive(const ShapeBody& body, const Vector3d& p) {
  if (!insideSolid(body, p)) return false;
  if (!body.wall) return true;
  const ShapeBody cavity = cavityOf(body);
  return !insideSolid(cavity, p - cavity.X_SB.translation());
}

WeightedPoints primitivePoints(const ShapeBody& body) {
  constexpr long kWanted = 16384, kTrials = 4'000'000;
  const auto& d = body.dims;
  const bool round = body.kind != BodyKind::box && body.kind != BodyKind::plate;
  const double inner = body.kind == BodyKind::tube ? d[1] : 0.0;
  const auto [low, high] = heightRange(body);
  const ShapeBody cavity = cavityOf(body);

  WeightedPoints result;
  result.points.resize(3, kWanted);
  Eigen::Index n = 0;
  for (long trial = 0; trial < kTrials && n < kWanted; ++trial) {
    const Vector3d u = evenPoint(trial);
    Vector3d p;
    if (round) {
      const double r = std::sqrt(inner * inner + u.x() * (d[0] * d[0] - inner * inner));
      p << r * std::cos(2 * kPi * u.y()), r * std::sin(2 * kPi * u.y()), low + u.z() * (high - low);
    } else {
      p << (u.x() - 0.5) * d[0], (u.y() - 0.5) * d[1], (u.z() - 0.5) * d[2];
    }
    if (body.kind != BodyKind::tube && !insideSolid(body, p)) continue;
    if (body.wall && insideSolid(cavity, p - cavity.X_SB.translation())) continue;
    result.points.col(n++) = p;
  }
  result.points.conservativeResize(3, n);
  result.weights = VectorXd::Constant(n, n > 0 ? 1.0 / static_cast<double>(n) : 0.0);
  return result;
}

}  // namespace heft
