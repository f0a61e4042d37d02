#pragma once
// Parts of the housings that links of both source files use.
#include "resources/robots/panda/generator/dimensions.h"
#include "resources/robots/panda/generator/field.h"

namespace heft::panda_maker {

/// Dark ring that shows in the groove between two links, on an axis at height `at`.
inline double groove(double rho, double t, double at, double radius = kTube) {
  return cylinder(rho, t, radius - kGrooveDepth, at - 0.004, at + 0.004);
}

/// What nobody sees of the flat faces at a seam: it lies inside the ring.
inline double seamCore(double rho, double t, double at, double radius = kTube) {
  return cylinder(rho, t, radius - 0.0060, at - 0.0065, at + 0.0065);
}

/// The half of the elbow that links 3 and 4 share: a housing that narrows a little from the seam at t = 0 and
/// disappears in its dark cap; `rho` is the distance from the elbow's axis.
inline double elbowHousing(double rho, double t) {
  static const Curve radius({{0.0, kTube}, {0.03, 0.0546}, {0.066, 0.0530}});
  return std::max(lathe(rho, t, radius), t - 0.0700);
}

/// A dark cone with a wide bevel.
inline double elbowCap(double rho, double t) {
  const double side = (rho - 0.0536 + 0.07 * (t - 0.0640)) * 0.9976;
  const double bevel = (rho - 0.0522) * 0.70 + (t - 0.0870) * 0.714;
  return std::max(std::max(side, bevel), std::max(0.0640 - t, t - 0.1030));
}

/// The light lens in the cap's middle.
inline double elbowLens(double rho, double t) {
  return std::max(std::max(length2(rho, t - 0.0395) - 0.0725, rho - 0.0335), 0.0980 - t);
}

/// Clearance for the other half of the elbow.
inline double elbowClearance(double rho, double t) { return cylinder(rho, t, kTube + 0.0030, -0.2, 0.0005); }

/// What covers, for leaving out hidden triangles.
inline Field hiddenBy(std::vector<Field> covers) {
  return [covers = std::move(covers)](Vec p) {
    double least = 1.0;
    for (const Field& cover : covers) least = std::min(least, cover(p));
    return least;
  };
}

}  // namespace heft::panda_maker
