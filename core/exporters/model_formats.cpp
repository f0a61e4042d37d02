// Robot models and Heft's own payload file. In each the body's frame is the flange.
#include <fmt/format.h>

#include "core/exporters/writing.h"

namespace heft {

namespace {

const std::string kFlangeFrame = "The link's frame is the robot's flange; inertia about the centre of mass. SI units.";

}  // namespace

std::string writeUrdf(const ExportInput& input) {
  const Payload& payload = input.payload;
  const Matrix3d& I = payload.inertiaCom;
  const std::string name = xmlEscaped(input.name);
  return "<?xml version=\"1.0\"?>\n" + xmlComment(remarksOf(input, {kFlangeFrame})) +
         fmt::format(
             "<robot name=\"{}\">\n"
             "  <link name=\"{}\">\n"
             "    <inertial>\n"
             "      <origin xyz=\"{}\" rpy=\"0 0 0\"/>\n"
             "      <mass value=\"{}\"/>\n"
             "      <inertia ixx=\"{}\" ixy=\"{}\" ixz=\"{}\" iyy=\"{}\" iyz=\"{}\" izz=\"{}\"/>\n"
             "    </inertial>\n"
             "  </link>\n"
             "</robot>\n",
             name, name, list(payload.com, " "), number(payload.mass), number(I(0, 0)), number(I(0, 1)),
             number(I(0, 2)), number(I(1, 1)), number(I(1, 2)), number(I(2, 2)));
}

std::string writeSdf(const ExportInput& input) {
  const Payload& payload = input.payload;
  // Principal axes leave no product of inertia, about whose sign readers disagree.
  const PrincipalAxes axes = principalAxes(payload.inertiaCom);
  const Vector3d rpy = rpyFromRotation(axes.R_FA).unaryExpr([](double v) { return roundedTo(v, 9); });
  const std::string name = xmlEscaped(input.name);
  return "<?xml version=\"1.0\"?>\n" +
         xmlComment(remarksOf(input, {kFlangeFrame, "The pose turns the flange's axes into the principal axes."})) +
         fmt::format(
             "<sdf version=\"1.6\">\n"
             "  <model name=\"{}\">\n"
             "    <link name=\"{}\">\n"
             "      <inertial>\n"
             "        <pose>{} {}</pose>\n"
             "        <mass>{}</mass>\n"
             "        <inertia>\n"
             "          <ixx>{}</ixx>\n"
             "          <ixy>0</ixy>\n"
             "          <ixz>0</ixz>\n"
             "          <iyy>{}</iyy>\n"
             "          <iyz>0</iyz>\n"
             "          <izz>{}</izz>\n"
             "        </inertia>\n"
             "      </inertial>\n"
             "    </link>\n"
             "  </model>\n"
             "</sdf>\n",
             name, name, list(payload.com, " "), list(rpy, " "), number(payload.mass), number(axes.moments.x()),
             number(axes.moments.y()), number(axes.moments.z()));
}

std::string writeMjcf(const ExportInput& input) {
  const Payload& payload = input.payload;
  const Matrix3d& I = payload.inertiaCom;
  const std::string name = xmlEscaped(input.name);
  return xmlComment(remarksOf(input, {kFlangeFrame})) +
         fmt::format(
             "<mujoco model=\"{}\">\n"
             "  <worldbody>\n"
             "    <body name=\"{}\">\n"
             "      <inertial pos=\"{}\" mass=\"{}\" fullinertia=\"{}\"/>\n"
             "    </body>\n"
             "  </worldbody>\n"
             "</mujoco>\n",
             name, name, list(payload.com, " "), number(payload.mass),
             list({I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)}, " "));
}

std::string writeJson(const ExportInput& input) {
  const Payload& payload = input.payload;
  const Matrix3d& I = payload.inertiaCom;
  std::string cautions;
  for (const std::string& caution : input.cautions) cautions += (cautions.empty() ? "" : ", ") + jsonString(caution);
  if (!cautions.empty()) cautions = ",\n  \"cautions\": [" + cautions + "]";
  return fmt::format(
      "{{\n"
      "  \"schema\": \"heft.payload/1\",\n"
      "  \"name\": {},\n"
      "  \"frame\": \"flange\",\n"
      "  \"mass_kg\": {},\n"
      "  \"com_m\": [{}],\n"
      "  \"inertia_com_kgm2\": [[{}], [{}], [{}]],\n"
      "  \"provenance\": {},\n"
      "  \"uncertainty\": {}{}\n"
      "}}\n",
      jsonString(input.name), number(payload.mass), list(payload.com), list(Vector3d(I.row(0))),
      list(Vector3d(I.row(1))), list(Vector3d(I.row(2))), jsonString(input.provenance), jsonString(input.uncertainty),
      cautions);
}

}  // namespace heft
