#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <clocale>
#include <fstream>
#include <locale>

#include "core/robot/robot_model.h"
#include "tests/core/robot/urdf_samples.h"

namespace heft {
namespace {

namespace fs = std::filesystem;
using samples::chain;
using samples::joint;
using samples::kLimit;
using samples::link;
using ::testing::AllOf;
using ::testing::HasSubstr;

const std::string kAxis = "<axis xyz=\"0 0 1\"/>";
const std::string kGood = kAxis + kLimit;

struct Outcome {
  Result<RobotModel> model;
  Findings findings;

  const Finding* find(const std::string& code) const {
    for (const Finding& finding : findings) {
      if (finding.code == code) return &finding;
    }
    return nullptr;
  }
};

Outcome readUrdf(const std::string& text) {
  Findings findings;
  Result<RobotModel> model = RobotModel::fromUrdfText(text, ".", findings);
  return {std::move(model), std::move(findings)};
}

/// An arm of one joint whose inside is given, and of more after it.
std::string oneJoint(const std::string& inside, const std::string& more = "", const std::string& type = "revolute") {
  return samples::robot(link("b") + link("l") + joint("j", type, "b", "l", inside) + more);
}

TEST(Urdf, soundArmGivesNoFinding) {
  const Outcome outcome = readUrdf(samples::robot(link("b") + chain("rrcpr")));
  ASSERT_TRUE(outcome.model) << outcome.model.error().message;
  for (const Finding& finding : outcome.findings) ADD_FAILURE() << toLine(finding);
  EXPECT_EQ(outcome.model->name(), "test");
}

/// What leaves the kinematics unsure: refused, with a finding that says where and what to do.
TEST(Urdf, unusableFilesAreRefusedWithTheirPlace) {
  const std::string twoArms = link("b") + chain("rr");
  const struct {
    const char* code;
    std::string text, message;
  } cases[] = {
      {"axis_zero", oneJoint("<axis xyz=\"0 0 0\"/>" + std::string(kLimit)), "axis of joint \"j\" is zero"},
      {"axis_zero", oneJoint("<axis/>" + std::string(kLimit)), "axis of joint \"j\" has no xyz"},
      {"two_parents", samples::robot(twoArms + joint("again", "fixed", "b", "l2")),
       "link \"l2\" has two parents: joints \"j2\" (line 6) and \"again\""},
      {"two_roots", samples::robot(twoArms + link("lonely")), "\"b\" and \"lonely\" have no parent"},
      {"loop",
       samples::robot(link("a") + link("c") + joint("x", "fixed", "a", "c") + joint("y", "revolute", "c", "a", kGood)),
       "closed loop"},
      {"loop", samples::robot(twoArms + joint("self", "fixed", "l2", "l2")), "joins link \"l2\" to itself"},
      {"unknown_link", samples::robot(twoArms + joint("k", "fixed", "l2", "nowhere")),
       "\"nowhere\", which does not exist"},
      {"no_link",
       samples::robot(link("b") + link("l") + "<joint name=\"j\" type=\"fixed\"><parent link=\"b\"/></joint>"),
       "names no child link"},
      {"duplicate_name", samples::robot(twoArms + link("l1")), "link \"l1\" is already defined in line 3"},
      {"duplicate_name", samples::robot(twoArms + link("x") + joint("j1", "fixed", "b", "x")),
       "joint \"j1\" is already defined"},
      {"joint_type", oneJoint(kGood, "", "rotary"), "unknown type \"rotary\""},
      {"no_limits", oneJoint(kAxis), "revolute joint \"j\" has no limits"},
      {"no_limits", oneJoint(kAxis + "<limit lower=\"-1\" upper=\"1\" velocity=\"1\"/>"), "has no effort"},
      {"bad_number", oneJoint(kGood + "<origin xyz=\"0,5 0 0\"/>"),
       "xyz=\"0,5 0 0\" of <origin> is not 3 finite numbers"},
      {"bad_number", oneJoint(kGood + "<origin xyz=\"0 0\"/>"), "is not 3 finite numbers"},
      {"bad_number", oneJoint(kGood + "<origin rpy=\"nan 0 0\"/>"), "is not 3 finite numbers"},
      {"bad_number", oneJoint(kAxis + R"(<limit lower="-1" upper="inf" velocity="1" effort="1"/>)"),
       "is not a finite number"},
      {"xacro", samples::robot("<xacro:include filename=\"a.xacro\"/>" + twoArms), "<xacro:include> is a xacro macro"},
      {"xacro", samples::robot(link("${prefix}b")), "xacro macro that was not expanded"},
      {"xacro", oneJoint(kGood + "<origin xyz=\"0 0 $(arg height)\"/>"), "xacro"},
      {"not_urdf", "<sdf version=\"1.6\"/>", "this is a sdf file"},
      {"not_urdf", "<html/>", "root element is <html>"},
      {"no_name", "<robot>" + twoArms + "</robot>", "<robot> has no name"},
      {"no_name", samples::robot("<link/>"), "link has no name"},
      {"no_links", samples::robot(""), "has no link"},
      {"version", "<robot name=\"a\" version=\"7.0\">" + twoArms + "</robot>", "version \"7.0\" is not known"},
  };
  for (const auto& test : cases) {
    const Outcome outcome = readUrdf(test.text);
    ASSERT_FALSE(outcome.model) << test.message;
    EXPECT_THAT(outcome.model.error().message, testing::ContainsRegex("^URDF:[0-9]+:[0-9]+: ")) << test.message;
    const Finding* finding = outcome.find(test.code);
    ASSERT_TRUE(finding) << test.message << " / " << outcome.model.error().message;
    EXPECT_EQ(finding->severity, Severity::error);
    EXPECT_THAT(testing::PrintToString(finding->text), AllOf(testing::Not(HasSubstr("\n"))));
    // The first letter may have become a capital.
    EXPECT_THAT(finding->text, HasSubstr(test.message.substr(1)));
  }
}

/// What can be lived with: a warning, and the arm is readUrdf.
TEST(Urdf, oddThingsAreWarnedOf) {
  const auto inertial = [](const std::string& mass, const std::string& moments) {
    return link("heavy", "<inertial><mass value=\"" + mass + "\"/><inertia " + moments + "/></inertial>") +
           joint("h", "fixed", "l", "heavy");
  };
  const auto visual = [](const std::string& inside) {
    return link("seen", "<visual>" + inside + "</visual>") + joint("v", "fixed", "l", "seen");
  };
  const auto shape = [&](const std::string& text) { return visual("<geometry>" + text + "</geometry>"); };
  const std::string sphere = "<geometry><sphere radius=\"1\"/></geometry>";
  const struct {
    const char* code;
    std::string text, message;
  } cases[] = {
      {"axis_not_unit", oneJoint("<axis xyz=\"0 0 2\"/>" + std::string(kLimit)), "has length 2"},
      {"limits_inverted", oneJoint(kAxis + R"(<limit lower="2" upper="-1" velocity="1" effort="1"/>)"),
       "lower 2 above upper -1"},
      {"limits_empty", oneJoint(kAxis + R"(<limit velocity="1" effort="1"/>)"), "has no range"},
      {"limits_in_degrees", oneJoint(kAxis + R"(<limit lower="-170" upper="170" velocity="1" effort="1"/>)"),
       "-170 to 170 rad"},
      {"velocity_limit", oneJoint(kAxis + R"(<limit lower="-1" upper="1" velocity="0" effort="1"/>)"),
       "velocity limit of 0"},
      {"angle_in_degrees", oneJoint(kGood + "<origin rpy=\"90 0 0\"/>"), "rpy of 90 rad"},
      {"origin_in_mm", oneJoint(kGood + "<origin xyz=\"0 0 333\"/>"), "lies 333 m from its parent"},
      {"bad_mimic", oneJoint(kGood, link("m") + joint("k", "revolute", "l", "m", kGood + "<mimic joint=\"none\"/>")),
       "mimics \"none\""},
      {"joint_type", oneJoint(kGood, link("m") + joint("k", "floating", "l", "m")), "is floating"},
      {"detached",
       oneJoint(kGood, link("x") + link("y") + joint("p", "fixed", "x", "y") + joint("q", "fixed", "y", "x")),
       "closed loop that is connected to nothing"},
      {"negative_mass", oneJoint(kGood, inertial("-2", R"(ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0")")),
       "mass of -2 kg"},
      {"unphysical_inertia", oneJoint(kGood, inertial("1", R"(ixx="1" iyy="1" izz="3" ixy="0" ixz="0" iyz="0")")),
       "triangle inequality: 3 > 1 + 1"},
      {"unphysical_inertia", oneJoint(kGood, inertial("1", R"(ixx="1" iyy="1" izz="1" ixy="2" ixz="0" iyz="0")")),
       "negative principal moment, -1 "},
      {"bad_inertial", oneJoint(kGood, inertial("1", R"(ixx="1" iyy="1")")), "missing or bad number"},
      {"bad_inertial",
       oneJoint(kGood, link("h", "<inertial><mass value=\"1\"/></inertial>") + joint("k", "fixed", "l", "h")),
       "lacks its mass or inertia"},
      {"mesh_missing", oneJoint(kGood, shape("<mesh filename=\"package://nobody/a.dae\"/>")),
       "\"package://nobody/a.dae\" of link \"seen\""},
      {"mesh_missing", oneJoint(kGood, shape("<mesh filename=\"none.stl\"/>")), "\"none.stl\""},
      {"bad_visual", oneJoint(kGood, shape("<mesh/>")), "has no filename"},
      {"bad_visual", oneJoint(kGood, shape("<mesh filename=\"a.stl\" scale=\"1 0 1\"/>")), "scale"},
      {"bad_visual", oneJoint(kGood, shape("<box size=\"1 2\"/>")), "needs 3 positive number(s)"},
      {"bad_visual", oneJoint(kGood, shape("<cylinder radius=\"1\"/>")), "needs 2 positive number(s)"},
      {"bad_visual", oneJoint(kGood, shape("<sphere radius=\"-1\"/>")), "needs 1 positive number(s)"},
      {"bad_visual", oneJoint(kGood, visual("")), "has no geometry"},
      {"bad_visual", oneJoint(kGood, visual("<origin xyz=\"a b c\"/>" + sphere)), "three numbers each"},
      {"unknown_geometry", oneJoint(kGood, shape("<capsule radius=\"1\" length=\"2\"/>")), "unknown shape <capsule>"},
      {"bad_colour", oneJoint(kGood, visual(sphere + "<material name=\"teal\"/>")),
       "\"teal\" of link \"seen\" is defined nowhere"},
      {"bad_colour", oneJoint(kGood, visual(sphere + "<material name=\"t\"><color rgba=\"1 0\"/></material>")),
       "not four numbers"},
  };
  for (const auto& test : cases) {
    const Outcome outcome = readUrdf(test.text);
    ASSERT_TRUE(outcome.model) << outcome.model.error().message;
    const Finding* finding = outcome.find(test.code);
    ASSERT_TRUE(finding) << test.message;
    EXPECT_EQ(finding->severity, Severity::warning);
    EXPECT_THAT(finding->text, HasSubstr(test.message));
    EXPECT_FALSE(finding->remedy.empty());
    EXPECT_GT(finding->where.line, 0);
    EXPECT_GT(finding->where.column, 0);
    EXPECT_EQ(outcome.model->dof(), 1);
  }
}

TEST(Urdf, oddLimitsAreRepaired) {
  const auto limitsOf = [](const std::string& limit) {
    const Outcome outcome = readUrdf(oneJoint(kAxis + limit));
    return outcome.model->limits(0);
  };
  const JointLimits inverted = limitsOf(R"(<limit lower="2" upper="-1" velocity="1" effort="1"/>)");
  EXPECT_EQ(inverted.lower, -1.0);
  EXPECT_EQ(inverted.upper, 2.0);
  const JointLimits empty = limitsOf(R"(<limit velocity="-3" effort="1" acceleration="4.5"/>)");
  EXPECT_TRUE(std::isinf(empty.lower) && std::isinf(empty.upper) && std::isinf(empty.velocity));
  EXPECT_EQ(empty.acceleration, 4.5);
}

TEST(Urdf, hugeAxisIsOnlyADirection) {
  const Outcome outcome = readUrdf(oneJoint("<axis xyz=\"0 -3e200 4e200\"/>" + std::string(kLimit)));
  ASSERT_TRUE(outcome.model) << outcome.model.error().message;
  EXPECT_LT((outcome.model->joints()[0].axis - Vector3d(0, -0.6, 0.8)).norm(), 1e-15);
}

TEST(Urdf, severalErrorsAreAllFound) {
  const Outcome outcome =
      readUrdf(samples::robot(link("b") + link("l") + link("l") +
                              joint("j", "revolute", "b", "l", "<axis xyz=\"0 0 0\"/>" + std::string(kLimit))));
  ASSERT_FALSE(outcome.model);
  EXPECT_TRUE(outcome.find("axis_zero"));
  EXPECT_TRUE(outcome.find("duplicate_name"));
  EXPECT_THAT(outcome.model.error().message, HasSubstr("1 more error(s)"));
}

TEST(Urdf, earlierErrorsOfOthersDoNotMatter) {
  Findings findings{{Severity::error, "other", "Something else.", "", {}}};
  EXPECT_TRUE(RobotModel::fromUrdfText(oneJoint(kGood), ".", findings));
}

TEST(Urdf, hostileNamesStayPrintable) {
  const Outcome outcome = readUrdf(samples::robot(link("b") + link("\xFF\x01" + std::string(5000, 'x'))));
  ASSERT_FALSE(outcome.model);
  EXPECT_LT(outcome.model.error().message.size(), 1000u);
  EXPECT_EQ(outcome.model.error().message.find('\xFF'), std::string::npos);
}

TEST(Urdf, commaLocaleChangesNothing) {
  struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
  };
  const std::locale before = std::locale::global(std::locale(std::locale(), new Comma));
  std::setlocale(LC_NUMERIC, "de_DE.UTF-8");  // Where it is installed.
  const Outcome outcome = readUrdf(oneJoint(kGood + "<origin xyz=\"0.25 0 0\" rpy=\"0 0 0.5\"/>"));
  std::setlocale(LC_NUMERIC, "C");
  std::locale::global(before);
  ASSERT_TRUE(outcome.model) << outcome.model.error().message;
  EXPECT_EQ(outcome.model->joints()[0].X_PJ.translation().x(), 0.25);
  EXPECT_LT((outcome.model->joints()[0].X_PJ.linear() - rotationFromRpy({0, 0, 0.5})).norm(), 1e-15);
  EXPECT_EQ(outcome.model->limits(0).upper, 1.0);
}

TEST(Urdf, visualsCarryShapeColourAndPlace) {
  const std::string visuals =
      "<visual><origin xyz=\"1 2 3\" rpy=\"0 0 1.5707963267948966\"/><geometry><box size=\"1 2 3\"/></geometry>"
      "<material name=\"teal\"/></visual>"
      "<visual><geometry><cylinder radius=\"0.1\" length=\"0.5\"/></geometry></visual>"
      "<visual><geometry><sphere radius=\"0.2\"/></geometry><material><color rgba=\"1 0 0 0.5\"/></material></visual>";
  const Outcome outcome =
      readUrdf("<robot name=\"v\"><material name=\"teal\"><color rgba=\"0 0.5 0.5 1\"/></material>" +
               link("b", visuals) + chain("r") + "</robot>");
  ASSERT_TRUE(outcome.model) << outcome.model.error().message;
  for (const Finding& finding : outcome.findings) ADD_FAILURE() << toLine(finding);
  const std::vector<Visual>& found = outcome.model->links()[0].visuals;
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0].kind, Visual::Kind::box);
  EXPECT_EQ(found[0].size, Vector3d(1, 2, 3));
  EXPECT_TRUE(found[0].hasColour);
  EXPECT_EQ(found[0].rgba, Eigen::Vector4d(0, 0.5, 0.5, 1));
  EXPECT_LT((found[0].X_LV * Vector3d(1, 0, 0) - Vector3d(1, 3, 3)).norm(), 1e-12);
  EXPECT_EQ(found[1].kind, Visual::Kind::cylinder);
  EXPECT_EQ(found[1].size.head<2>(), Eigen::Vector2d(0.1, 0.5));
  EXPECT_FALSE(found[1].hasColour);
  EXPECT_EQ(found[2].kind, Visual::Kind::sphere);
  EXPECT_EQ(found[2].rgba, Eigen::Vector4d(1, 0, 0, 0.5));
}

/// A folder tree with a package, and the environment put back afterwards.
class MeshPaths : public ::testing::Test {
 protected:
  MeshPaths() : root_(fs::temp_directory_path() / ("heft_urdf_" + std::to_string(::getpid()))) {
    ::unsetenv("ROS_PACKAGE_PATH");
    ::unsetenv("AMENT_PREFIX_PATH");
  }
  ~MeshPaths() override {
    fs::remove_all(root_);
    ::unsetenv("ROS_PACKAGE_PATH");
    ::unsetenv("AMENT_PREFIX_PATH");
  }
  fs::path touch(const fs::path& relative) const {
    fs::create_directories((root_ / relative).parent_path());
    std::ofstream(root_ / relative) << "x";
    return root_ / relative;
  }
  /// Where the mesh `uri` of a URDF that lies in `folder` is found; empty if it is not.
  fs::path resolve(const std::string& uri, const fs::path& folder) const {
    const fs::path file = root_ / folder / "arm.urdf";
    fs::create_directories(file.parent_path());
    std::ofstream(file) << samples::robot(link("b", "<visual><geometry><mesh filename=\"" + uri +
                                                        "\" scale=\"0.001 0.001 -0.001\"/></geometry></visual>") +
                                          chain("r"));
    Findings findings;
    const auto model = RobotModel::fromUrdfFile(file, findings);
    if (!model) throw std::runtime_error(model.error().message);
    const auto& visuals = model->links()[0].visuals;
    EXPECT_EQ(visuals.empty(), !findings.empty());
    if (visuals.empty()) return {};
    EXPECT_EQ(visuals[0].size, Vector3d(0.001, 0.001, -0.001));
    return visuals[0].file;
  }
  fs::path root_;
};

TEST_F(MeshPaths, packageAboveTheUrdf) {
  const fs::path mesh = touch("ws/src/arm_description/meshes/a.stl");
  EXPECT_EQ(resolve("package://arm_description/meshes/a.stl", "ws/src/arm_description/urdf"), mesh);
  EXPECT_EQ(resolve("model://arm_description/meshes/a.stl", "ws/src/arm_description"), mesh);
  EXPECT_EQ(resolve("package://arm_description/meshes/a.stl", "ws/src/other/urdf"), mesh);
  EXPECT_EQ(resolve("package://arm_description/meshes/b.stl", "ws/src/arm_description/urdf"), fs::path());
  EXPECT_EQ(resolve("package://arm_description", "ws/src/arm_description/urdf"), fs::path());
  EXPECT_EQ(resolve("package:///meshes/a.stl", "ws/src/arm_description/urdf"), fs::path());
}

TEST_F(MeshPaths, packageInARenamedFolder) {
  const fs::path mesh = touch("arm_description-main/meshes/a.stl");
  EXPECT_EQ(resolve("package://arm_description/meshes/a.stl", "arm_description-main/urdf"), mesh);
}

TEST_F(MeshPaths, packageByRosPackagePath) {
  const fs::path mesh = touch("ros/repository/arm_description/a.stl");
  EXPECT_EQ(resolve("package://arm_description/a.stl", "x"), fs::path());
  ::setenv("ROS_PACKAGE_PATH", ("/nowhere::" + (root_ / "ros").string()).c_str(), 1);
  EXPECT_EQ(resolve("package://arm_description/a.stl", "x"), mesh);
  ::setenv("ROS_PACKAGE_PATH", (root_ / "ros/repository").c_str(), 1);
  EXPECT_EQ(resolve("package://arm_description/a.stl", "x"), mesh);
  ::setenv("ROS_PACKAGE_PATH", (root_ / "ros/repository/arm_description").c_str(), 1);
  EXPECT_EQ(resolve("package://arm_description/a.stl", "x"), mesh);
}

TEST_F(MeshPaths, packageByAmentPrefix) {
  const fs::path mesh = touch("install/arm/share/arm_description/a.stl");
  ::setenv("AMENT_PREFIX_PATH", ((root_ / "install/none").string() + ":" + (root_ / "install/arm").string()).c_str(),
           1);
  EXPECT_EQ(resolve("package://arm_description/a.stl", "x"), mesh);
}

TEST_F(MeshPaths, relativeAbsoluteAndFile) {
  const fs::path mesh = touch("x/meshes/a b.stl");
  EXPECT_EQ(resolve("meshes/a b.stl", "x"), mesh);
  EXPECT_EQ(resolve("../x/meshes/a b.stl", "x"), mesh);
  EXPECT_EQ(resolve(mesh.string(), "x"), mesh);
  std::string encoded = mesh.string();
  encoded.replace(encoded.find(' '), 1, "%20");
  EXPECT_EQ(resolve("file://" + encoded, "x"), mesh);
  EXPECT_EQ(resolve("meshes", "x"), fs::path());  // A folder is no mesh.
}

TEST(UrdfFile, missingFileIsNamed) {
  Findings findings;
  const auto model = RobotModel::fromUrdfFile("/nowhere/arm.urdf", findings);
  ASSERT_FALSE(model);
  EXPECT_THAT(model.error().message, HasSubstr("/nowhere/arm.urdf"));
}

}  // namespace
}  // namespace heft
