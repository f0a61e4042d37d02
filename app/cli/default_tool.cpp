#include "app/cli/default_tool.h"

namespace heft::cli {
namespace {

Payload box(double mass, const Vector3d& size, const Vector3d& centre) {
  const Vector3d s2 = size.cwiseAbs2();
  const Vector3d moments(s2.y() + s2.z(), s2.x() + s2.z(), s2.x() + s2.y());
  return {mass, centre, Matrix3d((mass / 12.0 * moments).asDiagonal())};
}

Payload cylinder(double mass, double radius, double height, const Vector3d& centre) {
  const double across = mass * (3.0 * radius * radius + height * height) / 12.0;
  return {mass, centre, Matrix3d(Vector3d(across, across, mass * radius * radius / 2.0).asDiagonal())};
}

}  // namespace

Payload defaultTool() {
  const Payload body = cylinder(0.52, 0.035, 0.080, {0.0, 0.0, 0.040});
  const Payload camera = box(0.14, {0.030, 0.070, 0.025}, {0.048, 0.012, 0.045});
  const Payload fingerLeft = box(0.07, {0.020, 0.015, 0.060}, {0.0, 0.030, 0.110});
  const Payload fingerRight = box(0.07, {0.020, 0.015, 0.060}, {0.0, -0.030, 0.110});
  return composed(composed(body, camera), composed(fingerLeft, fingerRight));
}

}  // namespace heft::cli
