#include <algorithm>
#include <cmath>

#include "ui/robot_view/robot_view.h"
#include "ui/robot_view/scene_state.h"

namespace heft {

PayloadLook payloadLook(const EstimateReport& report) {
  PayloadLook look;
  look.com = report.payload.com;
  // 95 % of a three-dimensional normal distribution lie within 2.80 standard deviations.
  look.region = 2.7955 * report.std.com.cwiseAbs();
  const double largest = look.region.maxCoeff();
  // Larger than this it says nothing but "not known", and would stand about the whole arm.
  constexpr double kLargest = 0.25;  // [m]
  if (!std::isfinite(largest) || largest <= 0 || largest > kLargest) {
    look.region.setZero();
    look.centreKnown = largest <= kLargest;
  } else {
    // Flatter than this it would be drawn as a disc without a body.
    look.region = look.region.cwiseMax(0.08 * largest);
    for (const double factor : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0}) {
      look.enlargement = factor;
      if (2.0 * factor * largest > 0.036) break;
    }
    // A region so small that even enlarged the ball would hide it is said, not drawn.
    if (look.enlargement * largest < 0.015) look.region.setZero();
  }
  bool inertiaKnown = report.physicallyConsistent && report.payload.mass > 0;
  for (int i = 0; i < 3; ++i) inertiaKnown = inertiaKnown && report.identifiability.inertia[i][i] != Source::none;
  if (inertiaKnown) {
    const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(report.payload.inertiaCom);
    const Vector3d moments = solver.eigenvalues();
    Vector3d edges;
    for (int i = 0; i < 3; ++i) {
      const double squared = 6.0 / report.payload.mass * (moments.sum() - 2.0 * moments(i));
      edges(i) = std::sqrt(std::max(0.0, squared));
    }
    look.boxEdges = edges;
    look.R_SBox = solver.eigenvectors();
    if (look.R_SBox.determinant() < 0) look.R_SBox.col(0) *= -1.0;
  }
  return look;
}

}  // namespace heft
