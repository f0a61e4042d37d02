#include "resources/robots/panda/generator/panda_files.h"

#include <fmt/format.h>

#include <array>

#include "resources/robots/panda/generator/links.h"

namespace heft::panda_maker {
namespace {

/// A row of the manufacturer's Denavit-Hartenberg table (Craig's convention) with the joint's limits. Numbers are
/// written out as they stand here.
struct Row {
  const char* a;             ///< [m]
  const char* d;             ///< [m]
  int quarterTurns;          ///< alpha in units of pi / 2
  const char* lower;         ///< [rad]
  const char* upper;         ///< [rad]
  const char* velocity;      ///< [rad/s]
  const char* acceleration;  ///< [rad/s2]
  const char* effort;        ///< [N m]
};

constexpr std::array<Row, 7> kRows{{{"0", "0.333", 0, "-2.8973", "2.8973", "2.175", "15", "87"},
                                    {"0", "0", -1, "-1.7628", "1.7628", "2.175", "7.5", "87"},
                                    {"0", "0.316", 1, "-2.8973", "2.8973", "2.175", "10", "87"},
                                    {"0.0825", "0", 1, "-3.0718", "-0.0698", "2.175", "12.5", "87"},
                                    {"-0.0825", "0.384", -1, "-2.8973", "2.8973", "2.61", "15", "12"},
                                    {"0", "0", 1, "-0.0175", "3.7525", "2.61", "20", "12"},
                                    {"0.088", "0", 1, "-2.8973", "2.8973", "2.61", "20", "12"}}};

/// Mass [kg], centre of mass [m] and inertia about it (xx, xy, xz, yy, yz, zz) [kg m2] of the links that move, as
/// identified by Gaz, Cognetti, Oliva, Robuffo Giordano, De Luca (2019, doi 10.1109/LRA.2019.2931248): the manufacturer
/// publishes none.
struct MassRow {
  const char* mass;
  const char* com;
  std::array<const char*, 6> inertia;
};

constexpr std::array<MassRow, 7> kMasses{
    {{"4.970684",
      "0.003875 0.002081 -0.04762",
      {"0.70337", "-0.000139", "0.006772", "0.70661", "0.019169", "0.009117"}},
     {"0.646926",
      "-0.003141 -0.02872 0.003495",
      {"0.007962", "-0.003925", "0.010254", "0.02811", "0.000704", "0.025995"}},
     {"3.228604",
      "0.027518 0.039252 -0.066502",
      {"0.037242", "-0.004761", "-0.011396", "0.036155", "-0.012805", "0.01083"}},
     {"3.587895",
      "-0.05317 0.104419 0.027454",
      {"0.025853", "0.007796", "-0.001332", "0.019552", "0.008641", "0.028323"}},
     {"1.225946",
      "-0.011953 0.041065 -0.038437",
      {"0.035549", "-0.002117", "-0.004037", "0.029474", "0.000229", "0.008627"}},
     {"1.666555",
      "0.060149 -0.014117 -0.010517",
      {"0.001964", "0.000109", "-0.001158", "0.004354", "0.000341", "0.005433"}},
     {"0.735522",
      "0.010517 -0.004252 0.061597",
      {"0.012516", "-0.000428", "-0.001196", "0.010027", "-0.000741", "0.004815"}}}};

std::string inertial(const MassRow& row) {
  const auto& i = row.inertia;
  return fmt::format(
      "    <inertial><origin xyz=\"{}\" rpy=\"0 0 0\"/><mass value=\"{}\"/>\n"
      "      <inertia ixx=\"{}\" ixy=\"{}\" ixz=\"{}\" iyy=\"{}\" iyz=\"{}\" izz=\"{}\"/></inertial>\n",
      row.com, row.mass, i[0], i[1], i[2], i[3], i[4], i[5]);
}

std::string negated(const std::string& number) {
  if (number == "0") return number;
  return number.front() == '-' ? number.substr(1) : "-" + number;
}

/// Rx(alpha) Tz(d) in the parent's axes: (0, -d sin alpha, d cos alpha).
std::string origin(const Row& row) {
  const std::string d = row.d;
  const std::string y = row.quarterTurns == 0 ? "0" : row.quarterTurns > 0 ? negated(d) : d;
  const std::string z = row.quarterTurns == 0 ? d : "0";
  const char* const alpha = row.quarterTurns == 0   ? "0"
                            : row.quarterTurns == 1 ? "1.5707963267948966"
                                                    : "-1.5707963267948966";
  return fmt::format("<origin xyz=\"{} {} {}\" rpy=\"{} 0 0\"/>", row.a, y, z, alpha);
}

std::string link(const std::string& name, const std::string& mesh, const std::string& place = "",
                 const std::string& mass = "") {
  if (mesh.empty()) return fmt::format("  <link name=\"panda_{}\"/>\n", name);
  return fmt::format(
      "  <link name=\"panda_{}\">\n    <visual>{}<geometry><mesh filename=\"meshes/{}.glb\"/></geometry></visual>\n"
      "{}  </link>\n",
      name, place, mesh, mass);
}

std::string fixedJoint(const std::string& name, const std::string& parent, const std::string& child,
                       const std::string& place) {
  return fmt::format(
      "  <joint name=\"panda_{}\" type=\"fixed\">\n    <parent link=\"panda_{}\"/>\n    <child link=\"panda_{}\"/>\n"
      "    <origin {}/>\n  </joint>\n",
      name, parent, child, place);
}

}  // namespace

std::string pandaUrdf() {
  std::string out =
      "<?xml version=\"1.0\"?>\n"
      "<!-- Written by make_panda from the manufacturer's published table of joints; the meshes are our own drawing.\n"
      "     The links' masses were identified by Gaz et al. (2019, doi 10.1109/LRA.2019.2931248). Frames and names "
      "are\n"
      "     the manufacturer's. The force/torque sensor sits between flange and hand: the hand's frame stays on the\n"
      "     flange, as everywhere, and only its mesh is drawn 40 mm further out. -->\n"
      "<robot name=\"panda\">\n";
  for (std::size_t k = 0; k <= 7; ++k)
    out += link(fmt::format("link{}", k), fmt::format("link{}", k), "", k > 0 ? inertial(kMasses[k - 1]) : "");
  out +=
      link("link8", "") + link("sensor", "sensor") + link("hand", "hand", "<origin xyz=\"0 0 0.04\" rpy=\"0 0 0\"/>");
  for (std::size_t k = 0; k < kRows.size(); ++k) {
    const Row& row = kRows[k];
    out += fmt::format(
        "  <joint name=\"panda_joint{}\" type=\"revolute\">\n    <parent link=\"panda_link{}\"/>\n"
        "    <child link=\"panda_link{}\"/>\n    {}\n    <axis xyz=\"0 0 1\"/>\n"
        "    <limit lower=\"{}\" upper=\"{}\" velocity=\"{}\" acceleration=\"{}\" effort=\"{}\"/>\n  </joint>\n",
        k + 1, k, k + 1, origin(row), row.lower, row.upper, row.velocity, row.acceleration, row.effort);
  }
  out += fixedJoint("joint8", "link7", "link8", "xyz=\"0 0 0.107\" rpy=\"0 0 0\"");
  out += fixedJoint("sensor_joint", "link8", "sensor", "xyz=\"0 0 0\" rpy=\"0 0 0\"");
  out += fixedJoint("hand_joint", "link8", "hand", "xyz=\"0 0 0\" rpy=\"0 0 -0.7853981633974483\"");
  return out + "</robot>\n";
}

std::map<std::string, std::string> pandaFiles() {
  std::map<std::string, std::string> files{{"panda.urdf", pandaUrdf()}};
  for (const LinkShape& shape : allLinks()) files["meshes/" + shape.name + ".glb"] = glb(shape.name, shape.parts);
  return files;
}

}  // namespace heft::panda_maker
