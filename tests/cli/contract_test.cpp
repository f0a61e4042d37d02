// The keys of heft.estimate/1 that other programs rely on, on simulated and, where they are at hand, real recordings.
#include <gmock/gmock.h>

#include <cstdlib>

#include "tests/cli/process.h"

namespace heft::test {
namespace {

using nlohmann::json;

bool isVector(const json& value, std::size_t size = 3) {
  return value.is_array() && value.size() == size &&
         std::all_of(value.begin(), value.end(), [](const json& x) { return x.is_number(); });
}

bool isMatrix(const json& value) {
  return value.is_array() && value.size() == 3 &&
         std::all_of(value.begin(), value.end(), [](const json& row) { return isVector(row); });
}

void expectPayload(const json& payload) {
  EXPECT_TRUE(payload["mass_kg"].is_number()) << payload;
  EXPECT_TRUE(isVector(payload["com_m"])) << payload;
  EXPECT_TRUE(isMatrix(payload["inertia_com_kgm2"])) << payload;
}

bool isSource(const json& value) { return value == "data" || value == "prior" || value == "none"; }

void expectContract(const json& result) {
  EXPECT_EQ(result["schema"], "heft.estimate/1");
  EXPECT_EQ(result["method"], "map");
  EXPECT_EQ(result["parameters"], "full");
  for (const char* key : {"samples", "rate_hz", "duration_s", "used_s"})
    EXPECT_TRUE(result["recording"][key].is_number()) << key << " " << result["recording"];
  EXPECT_TRUE(result["recording"]["file"].is_string());
  expectPayload(result["payload"]);
  expectPayload(result["std"]);
  const json& interval = result["interval95"];
  EXPECT_TRUE(isVector(interval["mass_kg"], 2)) << interval;
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(isVector(interval["com_m"][i], 2)) << interval;
    for (std::size_t j = 0; j < 3; ++j) EXPECT_TRUE(isVector(interval["inertia_com_kgm2"][i][j], 2)) << interval;
  }
  EXPECT_LE(interval["mass_kg"][0], result["payload"]["mass_kg"]);
  EXPECT_GE(interval["mass_kg"][1], result["payload"]["mass_kg"]);
  EXPECT_TRUE(isVector(result["bias"]["force_n"]));
  EXPECT_TRUE(isVector(result["bias"]["torque_nm"]));
  EXPECT_TRUE(result["physically_consistent"].is_boolean());
  const json& identifiability = result["identifiability"];
  EXPECT_TRUE(isSource(identifiability["mass"])) << identifiability;
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(isSource(identifiability["com"][i])) << identifiability;
    for (std::size_t j = 0; j < 3; ++j) EXPECT_TRUE(isSource(identifiability["inertia"][i][j])) << identifiability;
  }
  EXPECT_TRUE(identifiability.contains("condition_number"));
  for (const char* key : {"force_rms_n", "torque_rms_nm", "heldout_force_rms_n", "heldout_torque_rms_nm"})
    EXPECT_TRUE(result["residual"].contains(key)) << key;
  for (const json& segment : result["segments"]) {
    EXPECT_LE(segment["from_s"], segment["to_s"]);
    EXPECT_TRUE(segment["label"] == "free" || segment["label"] == "contact" || segment["label"] == "ignore") << segment;
  }
  for (const char* key : {"read", "prepare", "solve", "total"}) EXPECT_GT(result["timing_s"][key], 0.0) << key;
  const json& timing = result["timing_s"];
  EXPECT_GE(timing["total"].get<double>(),
            timing["read"].get<double>() + timing["prepare"].get<double>() + timing["solve"].get<double>());
  for (const json& finding : result["findings"]) {
    EXPECT_TRUE(finding["severity"] == "info" || finding["severity"] == "warning" || finding["severity"] == "error");
    EXPECT_FALSE(finding["code"].get<std::string>().empty());
    EXPECT_FALSE(finding["text"].get<std::string>().empty());
  }
}

using ContractTest = CliTest;

TEST_F(ContractTest, EveryMotionKind) {
  for (const std::string motion : {"excitation", "pick-and-place", "free"}) {
    SCOPED_TRACE(motion);
    simulate("rec", {"--motion", motion, "--duration", "12", "--rate", "250"});
    const Outcome run = heft({"estimate", "rec.csv", "--json", "-"});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    expectContract(json::parse(run.out));
  }
}

TEST_F(ContractTest, ResultSaysWhereTheSensorSits) {
  simulate("rec", {"--xyz", "0.001,0.002,0.05", "--rpy", "0.1,0.2,0.3", "--duration", "6", "--rate", "250"});
  const json mount = json::parse(heft({"estimate", "rec.csv", "--json", "-"}).out)["sensor_mount"];
  EXPECT_EQ(mount["parent"], "panda_link8");
  EXPECT_EQ(mount["xyz_m"], json({0.001, 0.002, 0.05}));
  EXPECT_EQ(mount["rpy_rad"], json({0.1, 0.2, 0.3}));
}

TEST_F(ContractTest, FindingsOfTheReaderReachTheResult) {
  simulate("rec");
  std::string text = read("rec.csv");
  text.insert(text.find('\n'), ",humidity");
  for (std::size_t at = text.find('\n') + 1; (at = text.find('\n', at)) != std::string::npos; at += 5)
    text.insert(at, ",0.5");
  write("rec.csv", text);
  const json result = json::parse(heft({"estimate", "rec.csv", "--json", "-"}).out);
  EXPECT_THAT(result["findings"].dump(), testing::HasSubstr("humidity"));
}

TEST_F(ContractTest, RealRecordings) {
  const char* given = std::getenv("HEFT_SHARED");
  const std::filesystem::path shared = given ? given : HEFT_SOURCE_DIR "/../shared";
  const auto folder = shared / "realdata";
  if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << "The real recordings are not at hand in " << folder;
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".csv") continue;
    SCOPED_TRACE(entry.path().filename());
    const Outcome run = heft({"estimate", entry.path().string(), "--json", "-"});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    expectContract(json::parse(run.out));
    ++count;
  }
  EXPECT_GE(count, 1);
}

}  // namespace
}  // namespace heft::test
