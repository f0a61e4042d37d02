// Robot models and Heft's own payload file. In each the body's frame is the flange.
#include <fmt/format.h>

#include "core/exporters/writing.h"

namespace heft {

namespace {

const std::string kFlangeFrame = "The link's frame is the robot's flange; inertia about the centre of mass. SI units.";

}  // namespace

std::string urdfInertial(const Payload& payload, const std::string& indent, const std::string& newline) {
  const Matrix3d& I = payload.inertiaCom;
  return fmt::format(
      "{0}<inertial>{1}"
      "{0}  <origin xyz=\"{2}\" rpy=\"0 0 0\"/>{1}"
      "{0}  <mass value=\"{3}\"/>{1}"
      "{0}  <inertia ixx=\"{4}\" ixy=\"{5}\" ixz=\"{6}\" iyy=\"{7}\" iyz=\"{8}\" izz=\"{9}\"/>{1}"
      "{0}</inertial>{1}",
      indent, newline, list(payload.com, " "), number(payload.mass), number(I(0, 0)), number(I(0, 1)), number(I(0, 2)),
      number(I(1, 1)), number(I(1, 2)), number(I(2, 2)));
}

std::string writeUrdf(const ExportInput& input) {
  const std::string name = xmlEscaped(input.name);
  const std::string tool =
      fmt::format("  <link name=\"{}\">\n{}  </link>\n", name, urdfInertial(input.payload, "    ", "\n"));
  std::vector<std::string> remarks{kFlangeFrame};
  std::string above;
  if (input.parentLink.empty()) {
    remarks.push_back(
        "KDL and MuJoCo give a root link no weight: there, fix this link to your arm's flange, or write it with a "
        "parent.");
  } else {
    const std::string parent = xmlEscaped(input.parentLink);
    remarks.push_back(
        "The joint is fixed and the link above it has no mass. MuJoCo would merge both into the world "
        "and lose the mass, which its own element forbids; other readers pass over that element.");
    above = fmt::format(
        "  <mujoco>\n"
        "    <compiler fusestatic=\"false\"/>\n"
        "  </mujoco>\n"
        "  <link name=\"{0}\"/>\n"
        "  <joint name=\"{0}_to_{1}\" type=\"fixed\">\n"
        "    <parent link=\"{0}\"/>\n"
        "    <child link=\"{1}\"/>\n"
        "  </joint>\n",
        parent, name);
  }
  return "<?xml version=\"1.0\"?>\n" + xmlComment(remarksOf(input, remarks)) +
         fmt::format("<robot name=\"{}\">\n{}{}</robot>\n", name, above, tool);
}

std::string writeSdf(const ExportInput& input) {
  const Payload& payload = input.payload;
  const Matrix3d& I = payload.inertiaCom;
  const std::string name = xmlEscaped(input.name);
  // DART leaves out a rotation of the inertial's pose, so that the inertia stands in the link's axes.
  return "<?xml version=\"1.0\"?>\n" + xmlComment(remarksOf(input, {kFlangeFrame})) +
         fmt::format(
             "<sdf version=\"1.6\">\n"
             "  <model name=\"{}\">\n"
             "    <link name=\"{}\">\n"
             "      <inertial>\n"
             "        <pose>{} 0 0 0</pose>\n"
             "        <mass>{}</mass>\n"
             "        <inertia>\n"
             "          <ixx>{}</ixx>\n"
             "          <ixy>{}</ixy>\n"
             "          <ixz>{}</ixz>\n"
             "          <iyy>{}</iyy>\n"
             "          <iyz>{}</iyz>\n"
             "          <izz>{}</izz>\n"
             "        </inertia>\n"
             "      </inertial>\n"
             "    </link>\n"
             "  </model>\n"
             "</sdf>\n",
             name, name, list(payload.com, " "), number(payload.mass), number(I(0, 0)), number(I(0, 1)),
             number(I(0, 2)), number(I(1, 1)), number(I(1, 2)), number(I(2, 2)));
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
