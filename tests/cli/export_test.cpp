// heft export: frames, what else is mounted, warnings, refusals, and files that are never lost.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "core/payload/inertial_parameters.h"
#include "tests/cli/process.h"

namespace heft::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

Payload tool() {
  Payload payload{0.8, {0.01, -0.02, 0.06}, Matrix3d::Zero()};
  payload.inertiaCom << 1.2e-3, 1e-4, -5e-5, 1e-4, 1.0e-3, 3e-5, -5e-5, 3e-5, 8e-4;
  return payload;
}

Payload adapter() { return {0.35, {0.0, 0.001, 0.012}, Vector3d(2e-4, 2.5e-4, 3e-4).asDiagonal().toDenseMatrix()}; }

void expectSame(const Payload& actual, const Payload& expected) {
  EXPECT_NEAR(actual.mass, expected.mass, 1e-12);
  EXPECT_TRUE(actual.com.isApprox(expected.com, 1e-9)) << actual.com.transpose() << " | " << expected.com.transpose();
  EXPECT_TRUE(actual.inertiaCom.isApprox(expected.inertiaCom, 1e-9)) << actual.inertiaCom << "\n\n"
                                                                     << expected.inertiaCom;
}

class ExportTest : public CliTest {
 protected:
  json result() const {
    const json fromData{{"mass", "data"},
                        {"com", {"data", "data", "data"}},
                        {"inertia", {{"data", "data", "data"}, {"data", "data", "data"}, {"data", "data", "data"}}}};
    return {{"schema", "heft.estimate/1"},
            {"method", "map"},
            {"recording", {{"file", "rec.csv"}}},
            {"sensor_mount", {{"parent", "panda_link8"}, {"xyz_m", {0.01, 0.0, 0.04}}, {"rpy_rad", {0.0, 0.0, -0.5}}}},
            {"payload", toJson(tool())},
            {"interval95", {{"mass_kg", {0.79, 0.81}}}},
            {"physically_consistent", true},
            {"identifiability", fromData}};
  }
  void writeResult(const json& content) const { write("result.json", content.dump()); }

  /// Exports with these further arguments and reads the payload from the summary, which is not rounded.
  Payload exported(std::vector<std::string> arguments = {}) const {
    std::vector<std::string> all{"export",    "result.json", "--format", "json", "-o",
                                 "tool.json", "--force",     "--json",   "-"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const Outcome run = heft(all);
    EXPECT_EQ(run.exitCode, 0) << run.err;
    auto payload = payloadFromJson(json::parse(run.out), "exported");
    auto file = payloadFromJson(readJson("tool.json"), "tool.json");
    EXPECT_TRUE(payload.ok());
    EXPECT_TRUE(file.ok());
    EXPECT_LT((file->com - payload->com).norm(), 1e-5);  // the file's last digit
    return *payload;
  }
};

TEST_F(ExportTest, TurnsSensorAxesIntoFlangeAxes) {
  writeResult(result());
  expectSame(exported(), transformed(tool(), poseFromXyzRpy({0.01, 0.0, 0.04}, {0.0, 0.0, -0.5})));
}

TEST_F(ExportTest, OptionsOverrideTheMount) {
  writeResult(result());
  expectSame(exported({"--xyz", "0,0.02,0.03"}), transformed(tool(), poseFromXyzRpy({0, 0.02, 0.03}, {0, 0, -0.5})));
  expectSame(exported({"--rpy", "0.3,-0.2,1"}), transformed(tool(), poseFromXyzRpy({0.01, 0, 0.04}, {0.3, -0.2, 1})));
  write("rec.meta.json",
        R"({"sensor": {"mount": {"parent": "panda_link8", "xyz_m": [0, 0, 0.1], "rpy_rad": [0.1, 0, 0]}}})");
  expectSame(exported({"--mount", "rec.meta.json"}), transformed(tool(), poseFromXyzRpy({0, 0, 0.1}, {0.1, 0, 0})));
}

TEST_F(ExportTest, MountOnAnotherLinkOfTheArmIsCarriedToTheFlange) {
  json content = result();
  content["sensor_mount"] = {{"parent", "panda_link7"}, {"xyz_m", {0.0, 0.0, 0.147}}, {"rpy_rad", {0.0, 0.0, 0.0}}};
  writeResult(content);
  expectSame(exported(), transformed(tool(), poseFromXyzRpy({0, 0, 0.04}, {0, 0, 0})));  // the flange is at 0.107 m

  content["sensor_mount"]["parent"] = "panda_link3";
  writeResult(content);
  EXPECT_TRUE(failedWithOneSentence(heft({"export", "result.json", "--format", "json"}), "panda_link3"));
}

TEST_F(ExportTest, UnknownParentLinkIsSaid) {
  json content = result();
  content["sensor_mount"]["parent"] = "gripper_base";
  writeResult(content);
  EXPECT_THAT(heft({"export", "result.json", "--format", "json"}).err, HasSubstr("gripper_base"));
}

TEST_F(ExportTest, AddsWhatElseIsMounted) {
  writeResult(result());
  write("adapter.json", toJson(adapter()).dump());
  write("sensor.json",
        json{{"payload", toJson(Payload{0.2, {0, 0, 0.02}, Matrix3d(1e-4 * Matrix3d::Identity())})}}.dump());
  const Payload atFlange = transformed(tool(), poseFromXyzRpy({0.01, 0.0, 0.04}, {0.0, 0.0, -0.5}));
  const Payload both =
      composed(composed(atFlange, adapter()), {0.2, {0, 0, 0.02}, Matrix3d(1e-4 * Matrix3d::Identity())});
  expectSame(exported({"--add", "adapter.json", "--add", "sensor.json"}), both);
}

TEST_F(ExportTest, BarePayloadIsAlreadyInTheFlangeFrame) {
  writeResult(toJson(tool()));
  expectSame(exported(), tool());
  expectSame(exported({"--xyz", "0,0,0.04"}), transformed(tool(), poseFromXyzRpy({0, 0, 0.04}, {0, 0, 0})));
}

TEST_F(ExportTest, ItsOwnJsonGoesThroughUnchanged) {
  writeResult(result());
  static_cast<void>(exported());
  const std::string first = read("tool.json");
  write("result.json", first);
  static_cast<void>(exported());
  EXPECT_EQ(readJson("tool.json")["com_m"], json::parse(first)["com_m"]);
  EXPECT_EQ(readJson("tool.json")["inertia_com_kgm2"], json::parse(first)["inertia_com_kgm2"]);
}

TEST_F(ExportTest, WarnsOfNumbersThatNobodyMeasured) {
  json content = result();
  writeResult(content);
  EXPECT_THAT(heft({"export", "result.json", "--format", "json"}).err, Not(HasSubstr("warning")));

  content["identifiability"]["com"][1] = "prior";
  content["identifiability"]["inertia"][0][2] = "none";
  content["physically_consistent"] = true;
  writeResult(content);
  const Outcome run = heft({"export", "result.json", "--format", "json"});
  EXPECT_EQ(run.exitCode, 0);
  EXPECT_THAT(run.err, HasSubstr("Not known from this motion"));
  EXPECT_THAT(run.err, HasSubstr("inertia xz"));
  EXPECT_THAT(run.err, HasSubstr("not measured: centre of mass y"));
  EXPECT_THAT(run.err, Not(HasSubstr("inertia xx")));
}

TEST_F(ExportTest, WarnsWhereTheMountIsUnknown) {
  json content = result();
  content.erase("sensor_mount");
  writeResult(content);
  EXPECT_THAT(heft({"export", "result.json", "--format", "json"}).err,
              HasSubstr("does not state where the sensor is mounted"));
  EXPECT_THAT(heft({"export", "result.json", "--format", "json", "--xyz", "0,0,0"}).err,
              Not(HasSubstr("where the sensor")));
}

TEST_F(ExportTest, RefusesWhatCannotExist) {
  json content = result();
  content["payload"]["inertia_com_kgm2"] = {
      {1e-3, 0, 0}, {0, 1e-4, 0}, {0, 0, 1e-4}};  // breaks the triangle inequality
  writeResult(content);
  EXPECT_TRUE(failedWithOneSentence(heft({"export", "result.json", "--format", "urdf", "-o", "t.urdf"}), ""));
  EXPECT_FALSE(exists("t.urdf"));
}

TEST_F(ExportTest, NeverOverwritesSilently) {
  writeResult(result());
  write("tool.urdf", "mine");
  const Outcome run = heft({"export", "result.json", "--format", "urdf", "-o", "tool.urdf"});
  EXPECT_TRUE(failedWithOneSentence(run, "--force"));
  EXPECT_EQ(read("tool.urdf"), "mine");
  ASSERT_EQ(heft({"export", "result.json", "--format", "urdf", "-o", "tool.urdf", "--force"}).exitCode, 0);
  EXPECT_THAT(read("tool.urdf"), HasSubstr("<inertia"));
  // The same bytes once more lose nothing.
  EXPECT_EQ(heft({"export", "result.json", "--format", "urdf", "-o", "tool.urdf"}).exitCode, 0);
}

TEST_F(ExportTest, EveryFormatThatHelpNamesIsWritten) {
  writeResult(result());
  const std::string help = heft({"export", "--help"}).out;
  std::istringstream lines(help.substr(help.find("Formats:\n") + 9));
  int count = 0;
  for (std::string line; std::getline(lines, line) && line.starts_with("  "); ++count) {
    const std::string id = line.substr(2, line.find(' ', 2) - 2);
    const Outcome run = heft({"export", "result.json", "--format", id, "-o", "out-" + id});
    EXPECT_EQ(run.exitCode, 0) << id << ": " << run.err;
    EXPECT_THAT(run.out, HasSubstr("out-" + id));
    EXPECT_THAT(read("out-" + id), HasSubstr("0.8")) << id;  // the mass
  }
  EXPECT_GE(count, 4);
}

TEST_F(ExportTest, ToolCentrePointStandsInDesksFile) {
  writeResult(result());
  const Outcome run = heft({"export", "result.json", "--format", "franka-desk", "--tcp", "0,0.01,0.1034"});
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const json transformation = json::parse(run.out)["transformation"];
  EXPECT_EQ(transformation[13], 0.01);
  EXPECT_EQ(transformation[14], 0.1034);
}

TEST_F(ExportTest, SummaryAsJson) {
  writeResult(result());
  const Outcome run = heft({"export", "result.json", "--format", "franka-desk", "-o", "tool.json", "--json", "-"});
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const json summary = json::parse(run.out);
  EXPECT_EQ(summary["schema"], "heft.export/1");
  EXPECT_EQ(summary["file"], "tool.json");
  EXPECT_DOUBLE_EQ(summary["payload"]["mass_kg"].get<double>(), 0.8);
}

TEST_F(ExportTest, BrokenResultsAreOneSentence) {
  const auto run = [&] { return heft({"export", "result.json", "--format", "json"}); };
  EXPECT_TRUE(failedWithOneSentence(run(), "result.json"));
  write("result.json", "{\"payload\": {\"mass_kg\": 1,,}}");
  EXPECT_TRUE(failedWithOneSentence(run(), "result.json:1:"));
  write("result.json", "[1, 2, 3]");
  EXPECT_TRUE(failedWithOneSentence(run(), "result.json"));
  write("result.json", "{\"schema\": \"heft.convert/1\"}");
  EXPECT_TRUE(failedWithOneSentence(run(), "heft estimate"));
  json content = result();
  content["payload"]["com_m"] = {1, 2};
  writeResult(content);
  EXPECT_TRUE(failedWithOneSentence(run(), "com_m"));
  content = result();
  content["sensor_mount"]["xyz_m"] = {0, "a", 0};
  writeResult(content);
  EXPECT_TRUE(failedWithOneSentence(run(), "xyz_m"));
  writeResult(result());
  EXPECT_TRUE(
      failedWithOneSentence(heft({"export", "result.json", "--format", "json", "--add", "none.json"}), "none.json"));
  EXPECT_TRUE(
      failedWithOneSentence(heft({"export", "result.json", "--format", "json", "-o", "no/such/tool.json"}), "no/such"));
}

TEST_F(ExportTest, RefusesWhatIsNotTrusted) {
  json content = result();
  content["trust"] = "none";
  writeResult(content);
  const std::vector<std::string> plain{"export", "result.json", "--format", "json", "-o", "tool.json"};
  EXPECT_TRUE(failedWithOneSentence(heft(plain), "are not reliable"));
  EXPECT_FALSE(exists("tool.json"));
  auto forced = plain;
  forced.push_back("--force");
  EXPECT_EQ(heft(forced).exitCode, 0);
  for (const char* trust : {"good", "low"}) {
    content["trust"] = trust;
    writeResult(content);
    EXPECT_NO_FATAL_FAILURE(exported());
  }
}

}  // namespace
}  // namespace heft::test
