#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "core/estimation/estimate.h"

namespace heft {
namespace {

EstimateReport sample() {
  EstimateReport report;
  report.file = "rec.csv";
  report.samples = 20000;
  report.duration = 20.0;
  report.usedDuration = 16.0;
  report.rateHz = 1000.0;
  report.payload = {0.812, {0.001, -0.002, 0.045}, Vector3d(0.0016, 0.00105, 0.00113).asDiagonal()};
  report.interval95.mass = {0.808, 0.816};
  report.identifiability.mass = Source::data;
  report.identifiability.com.fill(Source::data);
  report.identifiability.conditionNumber = 12.0;
  report.relativeError = RelativeError{0.004, 0.01, 0.2, 0.1, true, true, true};
  report.findings = {{Severity::warning, "misfit", "It misses.", "Look.", {}}};
  report.segments = {{0.0, 20.0, MarkLabel::free, "Marked by you."}};
  return report;
}

TEST(Report, HasTheKeysOfTheContract) {
  const auto json = toJson(sample());
  EXPECT_EQ(json["schema"], "heft.estimate/1");
  EXPECT_EQ(json["method"], "map");
  EXPECT_EQ(json["parameters"], "full");
  for (const char* key : {"file", "samples", "rate_hz", "duration_s", "used_s"})
    EXPECT_TRUE(json["recording"].contains(key)) << key;
  for (const char* part : {"payload", "std", "interval95"})
    for (const char* key : {"mass_kg", "com_m", "inertia_com_kgm2"})
      EXPECT_TRUE(json[part].contains(key)) << part << " " << key;
  EXPECT_EQ(json["interval95"]["mass_kg"][1], 0.816);
  EXPECT_EQ(json["interval95"]["inertia_com_kgm2"][2][1].size(), 2u);
  EXPECT_EQ(json["bias"]["force_n"].size(), 3u);
  EXPECT_TRUE(json["physically_consistent"].is_boolean());
  EXPECT_EQ(json["identifiability"]["mass"], "data");
  EXPECT_EQ(json["identifiability"]["inertia"][1][2], "none");
  EXPECT_EQ(json["identifiability"]["condition_number"], 12.0);
  for (const char* key : {"force_rms_n", "torque_rms_nm", "heldout_force_rms_n", "heldout_torque_rms_nm"})
    EXPECT_TRUE(json["residual"].contains(key)) << key;
  EXPECT_EQ(json["segments"][0]["label"], "free");
  for (const char* key : {"read", "prepare", "solve", "total"}) EXPECT_TRUE(json["timing_s"].contains(key)) << key;
  EXPECT_EQ(json["findings"][0]["severity"], "warning");
  EXPECT_EQ(json["findings"][0]["code"], "misfit");
  for (const char* key : {"mass", "com", "inertia", "inertia_origin", "inertia_com"})
    EXPECT_TRUE(json["relative_error"].contains(key)) << key;
}

TEST(Report, InfinityBecomesNull) {
  auto report = sample();
  report.identifiability.conditionNumber = std::numeric_limits<double>::infinity();
  report.relativeError.reset();
  const auto json = nlohmann::json::parse(toJson(report).dump());
  EXPECT_TRUE(json["identifiability"]["condition_number"].is_null());
  EXPECT_FALSE(json.contains("relative_error"));
}

TEST(Report, PlainWordsComeFirst) {
  auto report = sample();
  EXPECT_THAT(toText(report), testing::StartsWith("Your tool weighs 0.81 kg."));
  report.identifiability.mass = Source::none;
  EXPECT_THAT(toText(report), testing::StartsWith("This motion does not determine the mass of your tool."));
}

TEST(Options, NamesRoundTrip) {
  for (const char* name : {"map", "ls", "wls", "tls", "tls-fast", "tls-exact", "ceres", "eigen-lm", "brute-force"})
    EXPECT_EQ(toString(methodFromString(name).value()), name);
  for (const char* name : {"mass", "mass-com", "full"}) EXPECT_EQ(toString(parameterSetFromString(name).value()), name);
  EXPECT_FALSE(methodFromString("magic"));
}

}  // namespace
}  // namespace heft
