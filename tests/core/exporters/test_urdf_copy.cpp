// The payload in a copy of a robot's own URDF: every other byte stays.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <urdf_parser/urdf_parser.h>

#include <nlohmann/json.hpp>

#include "core/exporters/urdf_copy.h"
#include "tests/core/exporters/readers.h"

namespace heft {
namespace {

using ::testing::HasSubstr;

const std::string kArm =
    "<?xml version=\"1.0\"?>\r\n"
    "<!-- <link name='tool0'> is below; 3 > 2 -->\r\n"
    "<robot name=\"arm\">\r\n"
    "\t<link name=\"base\"/>\r\n"
    "\t<link name=\"wrist\" >\r\n"
    "\t\t<!-- </inertial> --><inertial><origin xyz=\"0 0 0\"/><mass value=\"0.37\"/>"
    "<inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" izz=\"1\"/><!-- </inertial> --></inertial><visual>"
    "<geometry><box size=\"1 1 1\"/></geometry></visual>\r\n"
    "\t</link>\r\n"
    "\t<link name='tool0' />\r\n"
    "\t<link name=\"camera\"></link>\r\n"
    "\t<joint name=\"j\" type=\"continuous\"><parent link=\"base\"/><child link=\"wrist\"/><axis xyz=\"0 0 "
    "1\"/></joint>\r\n"
    "\t<joint name=\"f\" type=\"fixed\"><parent link=\"wrist\"/><child link=\"tool0\"/>"
    "<origin xyz=\"0 0.1 0\" rpy=\"-1.5707963267948966 0 0\"/></joint>\r\n"
    "\t<joint name=\"c\" type=\"fixed\"><parent link=\"base\"/><child link=\"camera\"/></joint>\r\n"
    "</robot>\r\n";

/// A result whose sensor sits 40 mm before tool0 of the arm above.
FlangePayload onTool0() {
  const nlohmann::json result = {
      {"payload",
       {{"mass_kg", 0.8},
        {"com_m", {0.01, 0.02, 0.05}},
        {"inertia_com_kgm2", {{0.002, 0, 0}, {0, 0.0025, 0}, {0, 0, 0.0015}}}}},
      {"sensor_mount", {{"parent", "tool0"}, {"xyz_m", {0, 0, 0.04}}, {"rpy_rad", {0, 0, 0}}}}};
  return toFlange(result, "result.json", {}).value();
}

/// `copy` without what it has more than `original`, which must be one piece.
std::string insertedInto(const std::string& original, const std::string& copy) {
  std::size_t before = 0;
  while (before < original.size() && original[before] == copy[before]) ++before;
  std::size_t behind = 0;
  while (behind < original.size() - before && original[original.size() - 1 - behind] == copy[copy.size() - 1 - behind])
    ++behind;
  EXPECT_LE(original.size() - before - behind, 3u);  // " />" becomes "> ... </link>"
  return copy.substr(before, copy.size() - before - behind);
}

urdf::InertialSharedPtr inertialOf(const std::string& text, const std::string& link) {
  const auto model = urdf::parseURDF(text);
  if (!model || !model->getLink(link)) return nullptr;
  return model->getLink(link)->inertial;
}

TEST(UrdfCopy, AnEmptyLinkIsGivenTheInertialAndNothingElseChanges) {
  for (const std::string link : {"tool0", "camera"}) {
    Findings findings;
    FlangePayload payload = onTool0();
    if (link == "camera") payload.mount.reset();
    const auto copy = payloadIntoUrdf(kArm, "arm.urdf", link, payload, findings);
    ASSERT_TRUE(copy.ok()) << copy.error().message;
    const std::string piece = insertedInto(kArm, *copy);
    EXPECT_THAT(piece, HasSubstr("\r\n\t  <inertial>\r\n"));
    EXPECT_EQ(piece.find("\n") == std::string::npos, false);
    const auto inertial = inertialOf(*copy, link);
    ASSERT_TRUE(inertial);
    EXPECT_DOUBLE_EQ(inertial->mass, 0.8);
    EXPECT_DOUBLE_EQ(inertial->origin.position.z, 0.09);
    EXPECT_EQ(findings.size(), link == "camera" ? 1u : 0u);  // taken for the flange
  }
}

TEST(UrdfCopy, IntoAnotherLinkThePayloadIsTurnedAndItsOldInertialReplaced) {
  Findings findings;
  const auto copy = payloadIntoUrdf(kArm, "arm.urdf", "wrist", onTool0(), findings);
  ASSERT_TRUE(copy.ok()) << copy.error().message;
  const auto inertial = inertialOf(*copy, "wrist");
  ASSERT_TRUE(inertial);
  // tool0's z is the wrist's y, and its y the wrist's -z.
  EXPECT_NEAR(inertial->origin.position.x, 0.01, 1e-12);
  EXPECT_NEAR(inertial->origin.position.y, 0.1 + 0.09, 1e-12);
  EXPECT_NEAR(inertial->origin.position.z, -0.02, 1e-12);
  EXPECT_NEAR(inertial->iyy, 0.0015, 1e-12);
  EXPECT_NEAR(inertial->izz, 0.0025, 1e-12);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].code, "inertial_replaced");
  EXPECT_THAT(findings[0].text, HasSubstr("0.37"));
  EXPECT_THAT(*copy, HasSubstr("\t\t<!-- </inertial> --><inertial>\r\n"));
  EXPECT_THAT(*copy, HasSubstr("</inertial><visual>"));
  EXPECT_EQ(copy->substr(0, 150), kArm.substr(0, 150));
}

TEST(UrdfCopy, ALinkThatMovesOrIsNotThereIsRefused) {
  Findings findings;
  const auto moving = payloadIntoUrdf(kArm, "arm.urdf", "base", onTool0(), findings);
  ASSERT_FALSE(moving.ok());
  EXPECT_THAT(moving.error().message, HasSubstr("moves against \"tool0\""));
  const auto missing = payloadIntoUrdf(kArm, "arm.urdf", "hand", onTool0(), findings);
  ASSERT_FALSE(missing.ok());
  EXPECT_THAT(missing.error().message, HasSubstr("base, wrist, tool0, camera"));
  EXPECT_FALSE(payloadIntoUrdf("no xml", "arm.urdf", "base", onTool0(), findings).ok());
}

TEST(UrdfCopy, AByteOrderMarkAndOneLongLineAreNoHindrance) {
  const std::string text = "\xEF\xBB\xBF<robot name=\"a\"><link name=\"b\"><visual/></link></robot>";
  Findings findings;
  const auto copy = payloadIntoUrdf(text, "a.urdf", "b", onTool0(), findings);
  ASSERT_TRUE(copy.ok()) << copy.error().message;
  EXPECT_THAT(*copy, ::testing::StartsWith("\xEF\xBB\xBF<robot name=\"a\"><link name=\"b\">\n  <inertial>"));
  EXPECT_THAT(*copy, ::testing::EndsWith("</inertial><visual/></link></robot>"));
}

}  // namespace
}  // namespace heft
