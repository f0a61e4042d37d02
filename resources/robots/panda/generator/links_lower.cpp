// Base, shoulder, elbow: tubes of 55 mm radius that bend into the housings of the joints.
#include "resources/robots/panda/generator/dimensions.h"
#include "resources/robots/panda/generator/housings.h"
#include "resources/robots/panda/generator/links.h"

namespace heft::panda_maker {
namespace {

double baseShell(Vec p) {
  static const Curve flare({{0.0, 0.0735}, {0.03, 0.0660}, {0.065, 0.0580}, {0.095, kTube}, {0.2, kTube}});
  const double column = lathe(length2(p.x, p.y), p.z, flare);
  // The connector box behind: its walls draw in towards the rear and the top, its roof falls to the rear.
  const double sides = (std::abs(p.y) - (0.0740 + 0.24 * (p.x + 0.030) - 0.05 * p.z)) * 0.96;
  const double rear = -0.1165 + 0.10 * p.z - p.x;
  const double roof = (p.z - (0.0920 + 0.50 * (p.x + 0.030))) * 0.894;
  const double plan = smoothMax(smoothMax(sides, rear, 0.040), p.x - 0.010, 0.030);
  const double box = smoothMax(plan, roof, 0.034);
  double body = smoothMin(column, box, 0.034);
  body = std::max(body, p.z - (kSeam01 - kHalfGap));
  return std::max(body, 0.0005 - p.z);
}

double basePlate(Vec p) {
  const double sides = (std::abs(p.y) - (0.0945 + 0.20 * p.x)) * 0.98;
  const double rear = length2(p.x - 0.15, p.y) - 0.2870;
  const double outline = smoothMax(smoothMax(sides, rear, 0.024), p.x - 0.022, 0.030);
  return std::max(outline, std::abs(p.z - 0.0045) - 0.0040);
}

struct Connector {
  double x, z, radius, reach;
};
constexpr Connector kConnectors[3] = {
    {-0.036, 0.036, 0.0068, 0.0770}, {-0.036, 0.060, 0.0068, 0.0760}, {-0.072, 0.044, 0.0098, 0.0680}};

double baseSockets(Vec p) {
  double all = 1.0;
  for (const Connector& c : kConnectors) {
    all = std::min(all, cylinder(length2(p.x - c.x, p.z - c.z), std::abs(p.y), c.radius, 0.045, c.reach));
  }
  return all;
}

double basePins(Vec p) {
  double all = 1.0;
  for (const Connector& c : kConnectors) {
    all = std::min(all, cylinder(length2(p.x - c.x, p.z - c.z), std::abs(p.y), c.radius - 0.0025, c.reach - 0.004,
                                 c.reach + 0.0006));
  }
  return all;
}

double baseScrews(Vec p) {
  double all = 1.0;
  const double y = std::abs(p.y);
  for (const Vec at : {Vec{-0.002, 0.0825, 0.0}, Vec{-0.070, 0.0700, 0.0}, Vec{-0.122, 0.0350, 0.0}}) {
    all = std::min(all, cylinder(length2(p.x - at.x, y - at.y), p.z, 0.0050, 0.004, 0.0092));
  }
  return all;
}

/// Links 1 and 2 in link 1's axes: the tube stands on z = -reach, the housing lies along y from -131 mm to 0. Seen
/// along x, the tube runs between two curves y(z): its back swings out under the housing, its front steps back for the
/// next link's housing.
double shoulderTube(Vec p) {
  static const Curve back({{-0.150, -kTube}, {-0.108, -0.0610}, {-0.066, -0.0860}, {-0.020, -0.1180}});
  static const Curve front({{-0.130, kTube}, {-0.106, 0.0465}, {-0.084, 0.0135}, {-0.062, -0.0085}, {-0.035, -0.0120}});
  static const Curve half({{-0.110, kTube}, {-0.050, 0.0520}, {0.010, 0.0420}});
  const auto section = [](Vec at) {
    const double low = back(at.z), high = front(at.z);
    return length2(at.x / half(at.z), (at.y - 0.5 * (low + high)) / (0.5 * (high - low))) - 1.0;
  };
  return smoothMax(perSlope(section, p), p.z - 0.0150, 0.040);  // Ends deep in the housing.
}

double shoulderShell(Vec p, double reach) {
  const double rho = length2(p.x, p.z);
  const double housing = std::max(roundedEnd(rho, -p.y - 0.052, kTube, 0.079), p.y + kHalfGap);
  const double clear = cylinder(rho, p.y, kTube + 0.0030, -0.0005, 0.2);
  const double tube = smoothMax(shoulderTube(p), -clear, 0.006);
  const double body = smoothMin(tube, housing, 0.022);
  return std::max(body, -(reach - kHalfGap) - p.z);
}

double shoulderRings(Vec p, double reach) {
  return std::min(groove(length2(p.x, p.z), p.y, 0.0), groove(length2(p.x, p.y), p.z, -reach));
}

double shoulderCore(Vec p, double reach) {
  return std::min(seamCore(length2(p.x, p.z), p.y, 0.0), seamCore(length2(p.x, p.y), p.z, -reach));
}

double elbowShell(Vec p) {
  const double tube = roundedEnd(length2(p.x, p.y), p.z + 0.120, kTube, 0.106);
  const double rho = length2(p.x - 0.0825, p.z), t = p.y;
  const double housing = std::max(elbowHousing(rho, t), kHalfGap - t);
  const double body = smoothMin(smoothMax(tube, -elbowClearance(rho, t), 0.004), housing, 0.035);
  return std::max(body, -(0.1215 - kHalfGap) - p.z);
}

}  // namespace

LinkShape baseLink() {
  const Field shell = baseShell, plate = basePlate, sockets = baseSockets, pins = basePins, screws = baseScrews;
  const Field ring = [](Vec p) { return groove(length2(p.x, p.y), p.z, kSeam01); };
  const Field core = [](Vec p) { return seamCore(length2(p.x, p.y), p.z, kSeam01); };
  const Field below = [](Vec p) { return p.z - 0.0060 + 0.5 * std::max(length2(p.x + 0.02, p.y) - 0.05, 0.0); };
  const Box low{{-0.16, -0.12, -0.01}, {0.1, 0.12, 0.02}}, side{{-0.1, -0.1, 0.02}, {0.0, 0.1, 0.09}};
  return {"link0",
          {{Material::shell, contour(shell, {{-0.15, -0.11, -0.01}, {0.1, 0.11, 0.16}}, kCoarse, Edges::soft,
                                     hiddenBy({plate, core, below}))},
           {Material::shell, contour(plate, low, 0.0056, Edges::crisp, hiddenBy({shell, below}))},
           {Material::dark, contour(ring, {{-0.07, -0.07, 0.125}, {0.07, 0.07, 0.155}}, kCoarse, Edges::crisp,
                                    hiddenBy({shell, core}))},
           {Material::metal, contour(sockets, side, 0.0036, Edges::crisp, shell)},
           {Material::dark, contour(pins, side, 0.0036, Edges::crisp, sockets)},
           {Material::metal, contour(screws, low, 0.0036, Edges::crisp, plate)}}};
}

LinkShape shoulderLink(int number) {
  const double reach = number == 1 ? 0.1920 : 0.1945;
  const auto turned = [number](Vec p) { return number == 1 ? p : Vec{p.x, -p.z, p.y}; };
  const Field shell = [=](Vec p) { return shoulderShell(turned(p), reach); };
  const Field rings = [=](Vec p) { return shoulderRings(turned(p), reach); };
  const Field core = [=](Vec p) { return shoulderCore(turned(p), reach); };
  const Box box =
      number == 1 ? Box{{-0.07, -0.145, -0.21}, {0.07, 0.07, 0.07}} : Box{{-0.07, -0.21, -0.07}, {0.07, 0.07, 0.145}};
  return {"link" + std::to_string(number),
          {{Material::shell, contour(shell, box, kCoarse, Edges::soft, core)},
           {Material::dark, contour(rings, box, kCoarse, Edges::crisp, hiddenBy({shell, core}))}}};
}

LinkShape elbowLink() {
  const Field shell = elbowShell;
  const Field cap = [](Vec p) { return elbowCap(length2(p.x - 0.0825, p.z), p.y); };
  const Field lens = [](Vec p) { return elbowLens(length2(p.x - 0.0825, p.z), p.y); };
  const Field ring = [](Vec p) { return groove(length2(p.x - 0.0825, p.z), p.y, 0.0); };
  const Field core = [](Vec p) {
    return std::min(seamCore(length2(p.x - 0.0825, p.z), p.y, 0.0), seamCore(length2(p.x, p.y), p.z, -0.1215));
  };
  const Box box{{-0.075, -0.075, -0.14}, {0.155, 0.13, 0.075}};
  return {"link3",
          {{Material::shell, contour(shell, box, kCoarse, Edges::soft, hiddenBy({cap, core}))},
           {Material::shell, contour(lens, box, 0.0056, Edges::crisp, cap)},
           {Material::dark, contour(cap, box, 0.0056, Edges::crisp, hiddenBy({shell, lens}))},
           {Material::dark, contour(ring, box, kCoarse, Edges::crisp, hiddenBy({shell, core}))}}};
}

}  // namespace heft::panda_maker
