// Forearm, wrist, head, flange, sensor and hand.
#include "resources/robots/panda/generator/housings.h"
#include "resources/robots/panda/generator/links.h"

namespace heft::panda_maker {
namespace {

double forearmShell(Vec p) {
  const double rho = length2(p.x, p.y), t = p.z;
  const double tube = roundedEnd(length2(p.x + 0.0825, p.z), 0.105 - p.y, kTube, 0.093);
  const double housing = std::max(elbowHousing(rho, t), kHalfGap - t);
  const double body = smoothMin(smoothMax(tube, -elbowClearance(rho, t), 0.004), housing, 0.040);
  return std::max(body, p.y - (kSeam45 - kHalfGap));
}

// Link 5: z runs to the wrist, joint 6 turns about y. Seen along x the arm runs between two curves y(z); its section
// changes from round to almost rectangular.
double wristArm(Vec p) {
  static const Curve inner({{-0.2500, -kTube},
                            {-0.2150, -0.0500},
                            {-0.1860, -0.0240},
                            {-0.1600, 0.0240},
                            {-0.1340, 0.0570},
                            {-0.1000, 0.0665},
                            {-0.0300, 0.0790}});
  static const Curve outer(
      {{-0.2500, kTube}, {-0.2200, 0.0625}, {-0.1900, 0.0780}, {-0.1500, 0.0890}, {-0.0300, 0.1080}});
  static const Curve half(
      {{-0.2500, kTube}, {-0.2150, 0.0500}, {-0.1880, 0.0405}, {-0.1500, 0.0320}, {-0.0800, 0.0300}});
  static const Curve square({{-0.2300, 0.0}, {-0.1500, 1.0}});
  const auto section = [](Vec at) {
    const double low = inner(at.z), high = outer(at.z), m = square(at.z);
    const double a = at.x / half(at.z), b = (at.y - 0.5 * (low + high)) / (0.5 * (high - low));
    return (1.0 - m) * length2(a, b) + m * std::sqrt(length2(a * a, b * b)) - 1.0;
  };
  return std::max(perSlope(section, p), p.z + 0.0100);
}

double wristShell(Vec p) {
  const double rho = length2(p.x, p.z);
  const double housing = cylinder(rho, p.y, kWrist, kSeam56 + kHalfGap, 0.0880);
  const double body = smoothMin(wristArm(p), housing, 0.024);
  return std::max(body, kSeam45 - 0.3840 + kHalfGap - p.z);
}

/// Outline of the dark cover on the outer side of link 5, seen along y; `inset` shrinks it.
double wristOutline(Vec p, double inset) {
  const double head = length2(p.x, p.z) - 0.0500 + inset;
  const double strip = taperedStadium(p.x, p.z, 0.0, -0.010, 0.0345 - inset, 0.0, -0.1880, 0.0315 - inset);
  return smoothMin(head, strip, 0.045);
}

/// Outer face of the cover: leans with the arm, ends upright, falls away above the joint.
double wristFace(Vec p) {
  const double leaning = (p.y - 0.1185 - 0.175 * p.z) * 0.985;
  const double falling = (p.z - 0.0300) * 0.55 + (p.y - 0.1210) * 0.835;
  return smoothMax(smoothMax(leaning, p.y - 0.1210, 0.006), falling, 0.010);
}

double wristCover(Vec p) {
  static const Curve inside({{-0.2200, 0.0660}, {-0.1000, 0.0850}, {-0.0500, 0.0890}, {0.0, 0.0790}, {0.0500, 0.0640}});
  const double face = wristFace(p), outline = wristOutline(p, 0.0);
  const double bevel = (outline + 0.0080) * 0.64 + face * 0.77;
  return std::max(std::max(outline, bevel), std::max(face, (inside(p.z) - p.y) * 0.97));
}

double wristInsert(Vec p) {
  const double r = (p.x * p.x + p.z * p.z) * (1.0 / (0.036 * 0.036)), dome = std::max(1.0 - r, 0.0);
  const double outline = wristOutline(p, 0.0180);
  return std::max(std::max(wristFace(p) - 0.0009 - 0.0055 * dome * dome, outline), 0.1080 + 0.175 * p.z - p.y);
}

// Link 6: joint 6 turns about z, the head lies along y at x = 88 mm around joint 7.
double headTube(Vec p) {
  static const Curve radius({{-0.0600, 0.0428},
                             {-0.0460, 0.0430},
                             {-0.0180, 0.0415},
                             {0.0120, 0.0432},
                             {0.0360, 0.0440},
                             {0.0560, 0.0418},
                             {0.0700, 0.0385}});
  return std::max(lathe(length2(p.x - 0.0880, p.z), p.y, radius), p.y - 0.0660);
}

double headShell(Vec p) {
  const double outline = taperedStadium(p.x, p.y, 0.0, 0.0, kWrist, 0.0880, 0.0080, 0.0400);
  const double lobe = std::max(smoothMax(outline, p.z - 0.0330 - 0.04 * p.x, 0.010), kSeam56Link6 - p.z);
  const double beyond = std::max(lobe, p.x - 0.0900);  // The head is round on its far side.
  // The transition narrows towards the seam: a lip there would reach over link 5.
  const double rise = std::clamp((p.z - kSeam56Link6) / 0.022, 0.0, 1.0);
  const double body = smoothMin(headTube(p), beyond, 0.002 + 0.026 * rise * rise * (3.0 - 2.0 * rise));
  return std::max(body, kHalfGap - 0.0515 - p.y);
}

double headCoverOutline(Vec p, double inset) {
  const double sides = taperedStadium(p.x, p.y, 0.0, 0.0, kWrist + 0.0008 - inset, 0.0900, 0.0, 0.0310 - inset);
  return smoothMax(sides, p.x - 0.0640 + inset, 0.020);
}

double headCover(Vec p) {
  const double outline = headCoverOutline(p, 0.0);
  const double top = length3(p.x - 0.010, p.y, p.z + 0.2450) - 0.3000;
  const double bevel = (outline + 0.0090) * 0.80 + (p.z - 0.0530) * 0.60;
  return std::max(std::max(outline, bevel), std::max(top, 0.0270 + 0.06 * p.x - p.z));
}

double headInsert(Vec p) {
  const double top = length3(p.x - 0.010, p.y, p.z + 0.2450) - 0.3008;
  return std::max(std::max(headCoverOutline(p, 0.0245), -0.0185 - p.x), std::max(top, 0.0500 - p.z));
}

double headBadge(Vec p) {
  const double top = length3(p.x - 0.010, p.y, p.z + 0.2450) - 0.3014;
  return std::max(std::max(length2(p.x - 0.0020, p.y) - 0.0150, top), 0.0510 - p.z);
}

/// The dark end of the head with its keys.
double headPanel(Vec p) {
  const double rho = length2(p.x - 0.0880, p.z);
  const double side = (rho - 0.0405 + 0.30 * (p.y - 0.0640)) * 0.958,
               bevel = (rho - 0.0325) * 0.55 + (p.y - 0.0782) * 0.835;
  return std::max(std::max(side, bevel), std::max(0.0640 - p.y, p.y - 0.0795));
}

double headKeys(Vec p) {
  const double x = p.x - 0.0880;
  double all = length2(x, p.z) - 0.0070;
  all = std::min(all, length2(std::abs(x) - 0.0180, p.z) - 0.0050);
  all = std::min(all, length2(x, std::abs(p.z) - 0.0180) - 0.0050);
  return std::max(all, std::max(0.0770 - p.y, p.y - 0.0803));
}

double flangeBody(Vec p) {
  const double rho = length2(p.x, p.y);
  const double drum = cylinder(rho, p.z, 0.0440, 0.0515 + kHalfGap, 0.0975);
  const double face = cylinder(rho, p.z, 0.0315, 0.0900, 0.1070);
  return std::min(drum, face);
}

/// The pilot grip on link 7, along (1, 1) in its xy plane: u outwards, v across.
struct Grip {
  double u, v;
};
Grip gripAxes(Vec p) {
  constexpr double kHalf = 0.70710678118654752;
  return {kHalf * (p.x + p.y), kHalf * (p.y - p.x)};
}

double flangeGrip(Vec p) {
  static const Curve half({{0.0200, 0.0400}, {0.0360, 0.0350}, {0.0500, 0.0302}, {0.0620, 0.0290}, {0.0950, 0.0290}});
  const auto [u, v] = gripAxes(p);
  const double end = length2(u + 0.0600, v) - 0.1490, sides = (std::abs(v) - half(u)) * 0.97;
  const double top = p.z - 0.0950, bottom = (0.0620 + 0.32 * (u - 0.0440) - p.z) * 0.952;
  const double block = smoothMax(smoothMax(end, sides, 0.018), smoothMax(top, bottom, 0.010), 0.014);
  return std::max(block, std::max(0.0405 - length2(p.x, p.y), 0.0150 - u));
}

double flangeButtons(Vec p) {
  const auto [u, v] = gripAxes(p);
  return extrude(roundedRectangle(u - 0.0630, p.z - 0.0815, 0.0110, 0.0080, 0.0060), std::abs(v), 0.0200, 0.0302, 0.0);
}

double sensorBody(Vec p) {
  const double rho = length2(p.x, p.y);
  const double drum = cylinder(rho, p.z, 0.0377, 0.0070, 0.0330);
  const double connector =
      extrude(roundedRectangle(p.y, p.z - 0.0190, 0.0130, 0.0080, 0.0), p.x, -0.0460, -0.0300, 0.0);
  return std::min(drum, connector);
}

double sensorPlug(Vec p) { return cylinder(length2(p.y, p.z - 0.0190), -p.x, 0.0055, 0.0440, 0.0540); }

double sensorPlates(Vec p) {
  const double rho = length2(p.x, p.y);
  return std::min(cylinder(rho, p.z, 0.0360, 0.0002, 0.0085), cylinder(rho, p.z, 0.0345, 0.0310, 0.0400));
}

double handShell(Vec p) {
  const double y = std::abs(p.y);
  // The body leans out towards the fingers along y and narrows along x.
  const double side = (y - 0.0930 - 0.14 * p.z) * 0.99, face = (std::abs(p.x) - 0.0310 + 0.16 * p.z) * 0.987;
  const double ends = std::max(p.z - 0.0660, 0.0040 - p.z);
  return smoothMax(smoothMax(side, ends, 0.024), face, 0.018);
}

double handRail(Vec p) { return extrude(roundedRectangle(p.x, p.y, 0.0100, 0.0860, 0.0), p.z, 0.0500, 0.0664, 0.0); }

double handPlate(Vec p) { return cylinder(length2(p.x, p.y), p.z, 0.0400, 0.0002, 0.0085); }

double handFingers(Vec p) {
  const double y = std::abs(p.y);
  const double carriage = extrude(roundedRectangle(p.x, y - 0.0270, 0.0095, 0.0120, 0.0), p.z, 0.0600, 0.0810, 0.0);
  const double finger = extrude(roundedRectangle(p.x, y - 0.0220, 0.0090, 0.0070, 0.0), p.z, 0.0760, 0.1120, 0.0);
  const double tip = (p.z - 0.1020) * 0.6 + (y - 0.0260) * 0.8;
  return std::min(carriage, std::max(finger, tip));
}

}  // namespace

LinkShape forearmLink() {
  const Field shell = forearmShell;
  const Field cap = [](Vec p) { return elbowCap(length2(p.x, p.y), p.z); };
  const Field lens = [](Vec p) { return elbowLens(length2(p.x, p.y), p.z); };
  const Field ring = [](Vec p) { return groove(length2(p.x + 0.0825, p.z), p.y, kSeam45); };
  const Field core = [](Vec p) {
    return std::min(seamCore(length2(p.x + 0.0825, p.z), p.y, kSeam45), seamCore(length2(p.x, p.y), p.z, 0.0));
  };
  const Box box{{-0.15, -0.075, -0.075}, {0.075, 0.145, 0.13}};
  return {"link4",
          {{Material::shell, contour(shell, box, kCoarse, Edges::soft, hiddenBy({cap, core}))},
           {Material::shell, contour(lens, box, 0.0056, Edges::crisp, cap)},
           {Material::dark, contour(cap, box, 0.0056, Edges::crisp, hiddenBy({shell, lens}))},
           {Material::dark, contour(ring, box, kCoarse, Edges::crisp, hiddenBy({shell, core}))}}};
}

LinkShape wristArmLink() {
  const Field shell = wristShell, cover = wristCover, insert = wristInsert;
  const Field ring = [](Vec p) { return groove(length2(p.x, p.z), p.y, kSeam56, kWrist); };
  const Field core = [](Vec p) {
    return std::min(seamCore(length2(p.x, p.z), p.y, kSeam56, kWrist),
                    seamCore(length2(p.x, p.y), p.z, kSeam45 - 0.3840));
  };
  const Box box{{-0.075, -0.075, -0.28}, {0.075, 0.15, 0.075}};
  return {"link5",
          {{Material::shell, contour(shell, box, 0.0062, Edges::soft, hiddenBy({cover, core}))},
           {Material::shell, contour(insert, box, 0.0046, Edges::crisp, cover)},
           {Material::dark, contour(cover, box, 0.0050, Edges::crisp, hiddenBy({shell, insert}))},
           {Material::dark, contour(ring, box, kCoarse, Edges::crisp, hiddenBy({shell, core}))}}};
}

LinkShape headLink() {
  const Field shell = headShell, cover = headCover, insert = headInsert, badge = headBadge, panel = headPanel,
              keys = headKeys;
  const Field ring = [](Vec p) { return groove(length2(p.x - 0.0880, p.z), -p.y, 0.0515, 0.0430); };
  const Field core = [](Vec p) {
    return std::min(seamCore(length2(p.x - 0.0880, p.z), -p.y, 0.0515, 0.0430),
                    seamCore(length2(p.x, p.y), p.z, -0.0160, kWrist));
  };
  const Box box{{-0.065, -0.075, -0.065}, {0.15, 0.1, 0.07}};
  return {"link6",
          {{Material::shell, contour(shell, box, 0.0056, Edges::soft, hiddenBy({cover, panel, core}))},
           {Material::shell, contour(insert, box, 0.0044, Edges::crisp, hiddenBy({cover, badge}))},
           {Material::dark, contour(cover, box, 0.0050, Edges::crisp, hiddenBy({shell, insert}))},
           {Material::dark, contour(badge, box, 0.0040, Edges::crisp, insert)},
           {Material::dark, contour(panel, box, 0.0050, Edges::crisp, hiddenBy({shell, keys}))},
           {Material::metal, contour(keys, box, 0.0030, Edges::crisp, panel)},
           {Material::dark, contour(ring, box, 0.0062, Edges::crisp, hiddenBy({shell, core}))}}};
}

LinkShape flangeLink() {
  const Field body = flangeBody, grip = flangeGrip, buttons = flangeButtons;
  const Field core = [](Vec p) { return seamCore(length2(p.x, p.y), p.z, 0.0515, 0.0440); };
  const Box box{{-0.06, -0.06, 0.04}, {0.1, 0.1, 0.12}};
  return {"link7",
          {{Material::metal, contour(body, box, 0.0060, Edges::crisp, hiddenBy({core, grip}))},
           {Material::shell, contour(grip, box, 0.0040, Edges::soft, body)},
           {Material::dark, contour(buttons, box, 0.0038, Edges::crisp, grip)}}};
}

LinkShape sensorLink() {
  const Field body = sensorBody, plates = sensorPlates, plug = sensorPlug;
  const Box box{{-0.06, -0.06, -0.01}, {0.06, 0.06, 0.06}};
  return {"sensor",
          {{Material::sensor, contour(body, box, 0.0050, Edges::crisp, plates)},
           {Material::metal, contour(plates, box, 0.0054, Edges::crisp)},
           {Material::metal, contour(plug, box, 0.0036, Edges::crisp, body)}}};
}

LinkShape handLink() {
  const Field shell = handShell, rail = handRail, plate = handPlate, fingers = handFingers;
  const Box box{{-0.06, -0.13, -0.01}, {0.06, 0.13, 0.13}};
  return {"hand",
          {{Material::shell, contour(shell, box, 0.0064, Edges::soft, hiddenBy({rail, plate}))},
           {Material::dark, contour(rail, box, 0.0056, Edges::crisp, hiddenBy({shell, fingers}))},
           {Material::metal, contour(plate, box, 0.0054, Edges::crisp)},
           {Material::metal, contour(fingers, box, 0.0040, Edges::crisp, rail)}}};
}

std::vector<LinkShape> allLinks() {
  return {baseLink(),     shoulderLink(1), shoulderLink(2), elbowLink(),  forearmLink(),
          wristArmLink(), headLink(),      flangeLink(),    sensorLink(), handLink()};
}

}  // namespace heft::panda_maker
