#pragma once
// Random tools as a hand would hold them: a body on the flange with something at its end.
#include <random>

#include "core/payload/inertial_parameters.h"
#include "core/payload/shape.h"

namespace heft::test {

/// A homogeneous box of mass `mass` [kg], edges `size` [m], centre at `centre`.
inline Payload boxPayload(double mass, const Vector3d& size, const Vector3d& centre) {
  const Vector3d s = size.cwiseAbs2();
  return {mass, centre,
          (mass / 12.0) * Vector3d(s.y() + s.z(), s.x() + s.z(), s.x() + s.y()).asDiagonal().toDenseMatrix()};
}

struct RandomTool {
  Payload payload;
  Shape shape;  ///< The two boxes that it is made of, densities unknown.
};

/// Mass log-uniform in 0.2-1.5 kg; two boxes, the second beyond the first and turned.
inline RandomTool randomTool(std::mt19937& random) {
  const auto uniform = [&random](double low, double high) {
    return low + (high - low) * (static_cast<double>(random()) + 0.5) / 4294967296.0;
  };
  // Each number is a statement of its own: the arguments of a call come in an order that compilers choose. The last
  // axis is drawn first, as it was for the seeds that tests and studies name.
  const auto edges = [&](const Vector3d& least, const Vector3d& most) {
    Vector3d out;
    for (const int axis : {2, 1, 0}) out(axis) = uniform(least(axis), most(axis));
    return out;
  };
  const auto about = [&](double aside, double z) {
    const double y = uniform(-aside, aside), x = uniform(-aside, aside);
    return Vector3d(x, y, z);
  };
  const double mass = 0.2 * std::pow(7.5, uniform(0.0, 1.0));
  const double share = uniform(0.3, 0.7);
  const Vector3d first = edges({0.04, 0.04, 0.03}, {0.10, 0.12, 0.08});
  const Vector3d second = edges({0.03, 0.03, 0.04}, {0.12, 0.15, 0.12});
  const Vector3d c1 = about(0.015, 0.02 + 0.5 * first.z());
  Isometry3d X = Isometry3d::Identity();
  X.linear() = rotationFromRpy({uniform(-0.4, 0.4), uniform(-0.4, 0.4), uniform(-1.5, 1.5)});
  X.translation() = about(0.03, 0.02 + first.z() + 0.5 * second.z());
  RandomTool tool;
  tool.payload = composed(boxPayload(share * mass, first, c1),
                          transformed(boxPayload((1.0 - share) * mass, second, Vector3d::Zero()), X));
  ShapeBody a, b;
  a.kind = b.kind = BodyKind::box;
  a.dims = {first.x(), first.y(), first.z()};
  a.X_SB.translation() = c1;
  b.dims = {second.x(), second.y(), second.z()};
  b.X_SB = X;
  tool.shape.bodies = {a, b};
  tool.shape.certainty = Certainty::good;
  return tool;
}

}  // namespace heft::test
