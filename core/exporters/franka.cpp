// Formats of the Franka world: SI units, flange frame, inertia about the centre of mass, column-major.
#include <fmt/format.h>

#include "core/exporters/writing.h"

namespace heft {

namespace {

const std::string kCountedTwice =
    "This is a load. A tool that Desk already knows as end effector would be counted twice.";

}  // namespace

std::string writeFrankaDesk(const ExportInput& input) {
  const Matrix4d X = input.X_FE.matrix();
  std::vector<double> pose;
  for (int i = 0; i < 16; ++i) pose.push_back(roundedTo(X.data()[i], i < 12 ? 12 : 6));
  const Payload& payload = input.payload;
  return fmt::format(
      "{{\n  \"mass\": {},\n  \"centerOfMass\": [{}],\n  \"transformation\": [{}],\n  \"inertia\": [{}]\n}}\n",
      number(payload.mass), list(payload.com), list(std::span<const double>(pose)), columnMajor(payload.inertiaCom));
}

std::string writeFrankaProfile(const ExportInput& input) {
  const Payload& payload = input.payload;
  const Matrix3d& I = payload.inertiaCom;
  const Vector3d p = input.X_FE.translation().unaryExpr([](double v) { return roundedTo(v, 6); });
  return fmt::format(
      "{{\n"
      "  \"id\": {},\n"
      "  \"name\": {},\n"
      "  \"deviceId\": \"\",\n"
      "  \"inertial\": {{\n"
      "    \"mass\": {},\n"
      "    \"centerOfMass\": {{\"x\": {}, \"y\": {}, \"z\": {}}},\n"
      "    \"inertia\": {{\"x11\": {}, \"x12\": {}, \"x13\": {}, \"x22\": {}, \"x23\": {}, \"x33\": {}}}\n"
      "  }},\n"
      "  \"tcp\": {{\n"
      "    \"translation\": {{\"x\": {}, \"y\": {}, \"z\": {}}},\n"
      "    \"rotation\": {{\"roll\": 0, \"pitch\": 0, \"yaw\": 0}}\n"
      "  }}\n"
      "}}\n",
      jsonString(identifier(input.name)), jsonString(input.name), number(payload.mass), number(payload.com.x()),
      number(payload.com.y()), number(payload.com.z()), number(I(0, 0)), number(I(0, 1)), number(I(0, 2)),
      number(I(1, 1)), number(I(1, 2)), number(I(2, 2)), number(p.x()), number(p.y()), number(p.z()));
}

std::string writeLibfranka(const ExportInput& input) {
  const Payload& payload = input.payload;
  std::string text = "#pragma once\n";
  text += comment(remarksOf(input, {kCountedTwice}), "//");
  text += fmt::format(
      "#include <franka/robot.h>\n\n"
      "#include <array>\n\n"
      "inline void setPayload(franka::Robot& robot) {{\n"
      "  const double load_mass = {};  // [kg]\n"
      "  const std::array<double, 3> F_x_Cload{{{{{}}}}};  // flange to centre of mass, flange axes [m]\n"
      "  // About the centre of mass, flange axes, column-major [kg m2]\n"
      "  const std::array<double, 9> load_inertia{{{{{}}}}};\n"
      "  robot.setLoad(load_mass, F_x_Cload, load_inertia);\n"
      "}}\n",
      number(payload.mass), list(payload.com), columnMajor(payload.inertiaCom));
  return text;
}

std::string writeFrankaRos(const ExportInput& input) {
  const Payload& payload = input.payload;
  return comment(remarksOf(input, {kCountedTwice, "Request for the service franka_control/set_load (SetLoad.srv).",
                                   "The robot rejects it while a controller runs."}),
                 "#") +
         fmt::format("mass: {}\nF_x_center_load: [{}]\nload_inertia: [{}]\n", number(payload.mass), list(payload.com),
                     columnMajor(payload.inertiaCom));
}

std::string writeFrankaRos2(const ExportInput& input) {
  const Payload& payload = input.payload;
  return comment(remarksOf(input, {kCountedTwice,
                                   "Request for SetLoad, usually at /service_server/set_load. That name is not "
                                   "verified: see `ros2 service list`."}),
                 "#") +
         fmt::format("mass: {}\ncenter_of_mass: [{}]\nload_inertia: [{}]\n", number(payload.mass), list(payload.com),
                     columnMajor(payload.inertiaCom));
}

}  // namespace heft
