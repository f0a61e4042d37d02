// Industrial controllers, each with its own units and its own idea of a tensor.
#include <fmt/format.h>

#include <numbers>

#include "core/exporters/writing.h"

namespace heft {

namespace {

constexpr double kMillimetres = 1000.0;
constexpr double kCentimetres = 100.0;
constexpr double kKilogramForce = 9.80665;  // [N]
/// 1 kg m2 in kgf cm s2: (N m s2) * 100 cm/m / 9.80665 N/kgf = 10.197.
constexpr double kKgfCmS2 = kCentimetres / kKilogramForce;

Vector3d scaled(const Vector3d& v, double factor, int decimals) {
  return (v * factor).unaryExpr([&](double x) { return roundedTo(x, decimals); });
}

}  // namespace

std::string writeUr(const ExportInput& input) {
  const Payload& payload = input.payload;
  const Matrix3d& I = payload.inertiaCom;
  return comment(remarksOf(input, {"Mass [kg], centre of gravity from the tool flange [m], inertia about it in flange "
                                   "axes [Ixx, Iyy, Izz, Ixy, Ixz, Iyz] [kg m2], transition time [s].",
                                   "It also zeroes the reading of the robot's own force/torque sensor."}),
                 "#") +
         fmt::format("set_target_payload({}, [{}], [{}], 0)\n", number(payload.mass), list(payload.com),
                     list({I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)}));
}

std::string writeKuka(const ExportInput& input) {
  const Payload& payload = input.payload;
  const PrincipalAxes axes = principalAxes(payload.inertiaCom);
  // A, B, C turn about Z, then the new Y, then the new X: yaw, pitch and roll about fixed axes in reverse order.
  const Vector3d angles = scaled(rpyFromRotation(axes.R_FA), 180.0 / std::numbers::pi, 7);
  const Vector3d com = scaled(payload.com, kMillimetres, 3);
  return comment(remarksOf(input,
                           {"M [kg]; CM from the flange [mm], A B C: principal axes [deg]; J: principal moments "
                            "about the centre of mass [kg m2].",
                            "The syntax of this line is not verified: compare it with one that your controller wrote, "
                            "and change the index to your tool's."}),
                 ";") +
         fmt::format("LOAD_DATA[1]={{M {},CM {{X {},Y {},Z {},A {},B {},C {}}},J {{X {},Y {},Z {}}}}}\n",
                     number(payload.mass), number(com.x()), number(com.y()), number(com.z()), number(angles.z()),
                     number(angles.y()), number(angles.x()), number(axes.moments.x()), number(axes.moments.y()),
                     number(axes.moments.z()));
}

std::string writeAbb(const ExportInput& input) {
  const Payload& payload = input.payload;
  const PrincipalAxes axes = principalAxes(payload.inertiaCom);
  Quaterniond q(axes.R_FA);
  if (q.w() < 0.0) q.coeffs() *= -1.0;
  const auto part = [](double v) { return roundedTo(v, 9); };
  const Vector3d com = scaled(payload.com, kMillimetres, 3);
  const std::string name = identifier(input.name);
  return fmt::format("MODULE heft_{}\n", name) +
         comment(remarksOf(input, {"loaddata: mass [kg], centre of gravity from the flange [mm], principal axes "
                                   "[q1..q4, q1 real], principal moments about the centre of gravity [kg m2]."}),
                 "  !") +
         fmt::format("  PERS loaddata load_{} := [{},[{}],[{}],{}];\nENDMODULE\n", name, number(payload.mass),
                     list(com, ","), list({part(q.w()), part(q.x()), part(q.y()), part(q.z())}, ","),
                     list(axes.moments, ","));
}

std::string writeFanuc(const ExportInput& input) {
  const Payload& payload = input.payload;
  const Vector3d com = scaled(payload.com, kCentimetres, 4);
  const Vector3d moments = payload.inertiaCom.diagonal() * kKgfCmS2;
  const int decimals = decimalsFor(moments.maxCoeff());
  const Vector3d rounded = scaled(moments, 1.0, decimals);
  return comment(remarksOf(input, {"To type in on the payload screen. Axes of the faceplate.",
                                   "The unit of the inertia is not verified: about the centre of mass, kgf cm s2, "
                                   "1 kg m2 = 10.197 kgf cm s2. Products of inertia have no place here."}),
                 "#") +
         fmt::format(
             "PAYLOAD [kg] = {}\n"
             "PAYLOAD CENTER X [cm] = {}\n"
             "PAYLOAD CENTER Y [cm] = {}\n"
             "PAYLOAD CENTER Z [cm] = {}\n"
             "PAYLOAD INERTIA X [kgf cm s2] = {}\n"
             "PAYLOAD INERTIA Y [kgf cm s2] = {}\n"
             "PAYLOAD INERTIA Z [kgf cm s2] = {}\n",
             number(payload.mass), number(com.x()), number(com.y()), number(com.z()), number(rounded.x()),
             number(rounded.y()), number(rounded.z()));
}

}  // namespace heft
