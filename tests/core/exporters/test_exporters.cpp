// Refusals, warnings, rounding.
#include "core/exporters/exporter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <locale>
#include <nlohmann/json.hpp>

#include "core/exporters/flange.h"
#include "tests/core/exporters/readers.h"

namespace heft {
namespace {

using testing::HasSubstr;
using testing::Not;

bool hasFinding(const Findings& findings, std::string_view code) {
  return std::any_of(findings.begin(), findings.end(), [&](const Finding& f) { return f.code == code; });
}

TEST(Exporters, EveryFormatOfTheContractIsThere) {
  for (const char* id :
       {"franka-desk", "franka-profile", "libfranka", "franka-ros", "franka-ros2", "urdf", "sdf", "mjcf", "ur", "kuka",
        "abb", "fanuc", "json", "xarm", "ros2-control", "force-torque-tools", "mc-rtc"}) {
    const ExportFormat* format = findExportFormat(id);
    ASSERT_NE(format, nullptr) << id;
    EXPECT_EQ(format->id, id);
    EXPECT_FALSE(format->title.empty());
    EXPECT_EQ(format->extension.front(), '.');
  }
  EXPECT_EQ(findExportFormat("doosan"), nullptr);
  EXPECT_EQ(findExportFormat(""), nullptr);
}

TEST(Exporters, WhatSpeaksAgainstTheNumbersStandsInTheFile) {
  const nlohmann::json result = {
      {"schema", "heft.estimate/1"},
      {"trust", "low"},
      {"payload",
       {{"mass_kg", 0.8}, {"com_m", {0, 0, 0.06}}, {"inertia_com_kgm2", {{2e-3, 0, 0}, {0, 2e-3, 0}, {0, 0, 1e-3}}}}},
      {"sensor_mount", {{"parent", "panda_link8"}, {"xyz_m", {0, 0, 0.04}}, {"rpy_rad", {0, 0, 0}}}},
      {"findings",
       {{{"severity", "warning"}, {"code", "misfit"}, {"text", "The model misses 0.9 N."}, {"remedy", "Look at it."}},
        {{"severity", "info"}, {"code", "contact_left_out"}, {"text", "1 s was left out."}},
        {{"severity", "warning"}, {"code", "weak_direction"}, {"text", "Turn it faster."}}}}};
  FlangeOptions options;
  options.cautions = {"A hose pulls."};
  auto payload = toFlange(result, "r.json", options);
  ASSERT_TRUE(payload.ok()) << payload.error().message;
  EXPECT_EQ(std::count_if(payload->findings.begin(), payload->findings.end(),
                          [](const Finding& f) { return f.code == "doubtful"; }),
            2);
  for (const char* id : {"kuka", "urdf", "libfranka", "json"}) {
    const auto text = exportPayload(*findExportFormat(id), payload->input, payload->findings);
    ASSERT_TRUE(text.ok()) << id;
    EXPECT_THAT(*text, HasSubstr("The model misses 0.9 N.")) << id;
    EXPECT_THAT(*text, HasSubstr("A hose pulls.")) << id;
    EXPECT_THAT(*text, Not(HasSubstr("left out"))) << id;
  }
  options.cautions.clear();
  nlohmann::json well = result;
  well["findings"] = nlohmann::json::array();
  payload = toFlange(well, "r.json", options);
  ASSERT_TRUE(payload.ok());
  EXPECT_THAT(*exportPayload(*findExportFormat("kuka"), payload->input, payload->findings), Not(HasSubstr("CAUTION")));
}

TEST(Exporters, UnphysicalPayloadsAreRefusedWithTheReason) {
  struct Case {
    const char* reason;
    void (*spoil)(Payload&);
  };
  const Case cases[] = {
      {"mass", [](Payload& p) { p.mass = -0.3; }},
      {"mass", [](Payload& p) { p.mass = 0.0; }},
      {"principal moment", [](Payload& p) { p.inertiaCom(2, 2) = -0.001; }},
      {"triangle inequality", [](Payload& p) { p.inertiaCom = Vector3d(0.001, 0.001, 0.0025).asDiagonal(); }},
      {"symmetric", [](Payload& p) { p.inertiaCom(0, 1) += 0.0005; }},
      {"", [](Payload& p) { p.com.x() = std::numeric_limits<double>::quiet_NaN(); }},
      {"", [](Payload& p) { p.inertiaCom(0, 0) = std::numeric_limits<double>::infinity(); }},
  };
  for (const ExportFormat& format : exportFormats()) {
    for (const Case& spoilt : cases) {
      ExportInput input = goldenInput();
      spoilt.spoil(input.payload);
      Findings findings;
      const auto text = exportPayload(format, input, findings);
      ASSERT_FALSE(text.ok()) << format.id << ", " << spoilt.reason;
      EXPECT_THAT(text.error().message, HasSubstr(spoilt.reason));
      EXPECT_THAT(text.error().message, HasSubstr(std::string(format.id)));
    }
  }
}

TEST(Exporters, AMirroredToolFrameIsRefused) {
  ExportInput input = goldenInput();
  input.X_FE.linear().col(0) *= -1.0;
  Findings findings;
  EXPECT_FALSE(exportPayload(*findExportFormat("franka-desk"), input, findings).ok());
}

TEST(Exporters, WarnsAboveThreeKilogramsForFrankaOnly) {
  ExportInput input = goldenInput();
  for (const double mass : {2.9, 3.2}) {
    input.payload.mass = mass;
    for (const ExportFormat& format : exportFormats()) {
      Findings findings;
      ASSERT_TRUE(exportPayload(format, input, findings).ok());
      EXPECT_FALSE(hasErrors(findings));
      const bool franka = format.id.find("franka") != std::string_view::npos;
      EXPECT_EQ(hasFinding(findings, "payload_limit"), franka && mass > 3.0) << format.id << " " << mass;
    }
  }
}

TEST(Exporters, SaysWhatAFormatCannotHoldOrWhatIsUnverified) {
  const auto findingsOf = [](const char* id, const ExportInput& input) {
    Findings findings;
    EXPECT_TRUE(exportPayload(*findExportFormat(id), input, findings).ok());
    return findings;
  };
  ExportInput input = goldenInput();
  EXPECT_TRUE(hasFinding(findingsOf("fanuc", input), "products_of_inertia_lost"));
  EXPECT_TRUE(hasFinding(findingsOf("franka-profile", input), "tool_rotation_lost"));
  EXPECT_FALSE(hasFinding(findingsOf("franka-desk", input), "tool_centre_unset"));
  input.X_FE.setIdentity();
  EXPECT_TRUE(hasFinding(findingsOf("franka-desk", input), "tool_centre_unset"));
  EXPECT_FALSE(hasFinding(findingsOf("franka-profile", input), "tool_rotation_lost"));
  for (const char* id : {"franka-profile", "franka-ros2", "kuka", "fanuc"})
    EXPECT_TRUE(hasFinding(findingsOf(id, input), "format_unverified")) << id;
  for (const char* id : {"franka-desk", "libfranka", "franka-ros", "urdf", "sdf", "mjcf", "ur", "abb", "json"})
    EXPECT_FALSE(hasFinding(findingsOf(id, input), "format_unverified")) << id;
  for (const char* id : {"xarm", "ros2-control", "force-torque-tools", "mc-rtc"})
    EXPECT_TRUE(hasFinding(findingsOf(id, input), "inertia_left_out")) << id;
  EXPECT_TRUE(hasFinding(findingsOf("mc-rtc", input), "bias_unknown"));
  EXPECT_TRUE(hasFinding(findingsOf("ros2-control", input), "sensor_frame_unset"));
  EXPECT_FALSE(hasFinding(findingsOf("sdf", input), "inertia_left_out"));
  input.payload.inertiaCom *= 1e5;
  EXPECT_TRUE(hasFinding(findingsOf("ur", input), "inertia_limit"));
  EXPECT_FALSE(hasFinding(findingsOf("urdf", input), "inertia_limit"));
  input.payload = {1.0, Vector3d::Zero(), Vector3d(0.001, 0.001, 0.001).asDiagonal()};
  EXPECT_FALSE(hasFinding(findingsOf("fanuc", input), "products_of_inertia_lost"));
}

TEST(Exporters, ProvenanceAndUncertaintyStandWhereCommentsArePossible) {
  const ExportInput input = goldenInput();
  for (const ExportFormat& format : exportFormats()) {
    Findings findings;
    const std::string text = exportPayload(format, input, findings).value();
    const bool pure = format.id == "franka-desk" || format.id == "franka-profile";
    EXPECT_EQ(text.find("demo.csv") != std::string::npos, !pure) << format.id;
    EXPECT_EQ(text.find("mass 0.7521 to 0.7547 kg") != std::string::npos, !pure) << format.id;
    EXPECT_EQ(text.back(), '\n') << format.id;
  }
}

TEST(Exporters, HostileRemarksAndNamesStayInsideTheirPlace) {
  ExportInput input = goldenInput();
  input.name = "a\"b<c>&\n\xff\\";
  input.provenance = "line one\nset_target_payload(99) --> */ ] \x01 \\";
  input.uncertainty = "ends in a backslash \\";
  const Payload expected = roundedForExport(input.payload);
  for (const ExportFormat& format : exportFormats()) {
    Findings findings;
    const std::string text = exportPayload(format, input, findings).value();
    EXPECT_EQ(readBack(format.id, text).mass, expected.mass) << format.id;
    EXPECT_EQ(text.find('\x01'), std::string::npos) << format.id;
    EXPECT_EQ(text.find('\xff'), std::string::npos) << format.id;
    // A C++ comment that ends in a backslash would swallow the next line.
    if (format.id == "libfranka") {
      EXPECT_EQ(text.find("\\\n"), std::string::npos);
    }
  }
}

TEST(Exporters, RoundedPayloadsAreShortAndAlwaysPossible) {
  for (int index = 0; index < 1000; ++index) {
    const Payload payload = randomPayload(index);
    const Payload rounded = roundedForExport(payload);
    ASSERT_TRUE(checkPhysical(rounded).physical) << index << ": " << checkPhysical(rounded).reason;
    const Vector3d moments = Eigen::SelfAdjointEigenSolver<Matrix3d>(rounded.inertiaCom).eigenvalues();
    // Without any tolerance, but for the eigenvalues' own last bits.
    EXPECT_GE(moments(0) + moments(1), moments(2) * (1.0 - 2e-15)) << index;
    EXPECT_LT((rounded.inertiaCom - payload.inertiaCom).cwiseAbs().maxCoeff(),
              6e-6 * payload.inertiaCom.cwiseAbs().maxCoeff());
    EXPECT_EQ(rounded.inertiaCom, rounded.inertiaCom.transpose());
  }
  const Payload golden = roundedForExport(goldenPayload());
  EXPECT_EQ(golden.mass, 0.753422);
  EXPECT_EQ(golden.com.x(), 0.012346);
}

class CommaPunctuation : public std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(Exporters, ALocaleWithDecimalCommasChangesNothing) {
  Findings findings;
  std::vector<std::string> before;
  for (const ExportFormat& format : exportFormats())
    before.push_back(exportPayload(format, goldenInput(), findings).value());
  const std::locale old = std::locale::global(std::locale(std::locale::classic(), new CommaPunctuation));
  std::size_t i = 0;
  for (const ExportFormat& format : exportFormats())
    EXPECT_EQ(exportPayload(format, goldenInput(), findings).value(), before[i++]) << format.id;
  std::locale::global(old);
}

}  // namespace
}  // namespace heft
