// Robots and exports as people have them: ../shared/cases with the right answers, skipped where that folder is absent.
#include <gmock/gmock.h>

#include <cstdlib>

#include "core/exporters/exporter.h"
#include "tests/cli/process.h"

namespace heft::test {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;
using nlohmann::json;

class RobotCases : public CliTest {
 protected:
  /// A copy of one folder of the shared cases; false where they are absent.
  bool enter(const std::string& name) {
    const char* given = std::getenv("HEFT_SHARED");
    const fs::path shared = (given ? fs::path(given) : fs::path(HEFT_SOURCE_DIR "/../shared")) / "cases" / name;
    if (!fs::is_directory(shared)) return false;
    folder_ = path(name);
    fs::create_directories(folder_);
    fs::copy(shared, folder_, fs::copy_options::recursive);
    for (const auto& entry : fs::directory_iterator(folder_))
      fs::permissions(entry.path(), fs::perms::owner_all, fs::perm_options::add);
    return true;
  }
  Outcome run(const std::vector<std::string>& arguments,
              const std::vector<std::pair<std::string, std::string>>& environment = {}) const {
    return runHeft(arguments, folder_, environment);
  }
  /// Mass within 0.5 % and centre within 0.6 mm of the truth of these folders.
  void expectTruth(const Outcome& outcome, const std::string& what) const {
    ASSERT_EQ(outcome.exitCode, 0) << what << ": " << outcome.err;
    const json result = json::parse(outcome.out);
    EXPECT_NE(result["trust"], "none") << what;
    EXPECT_NEAR(result["payload"]["mass_kg"].get<double>(), 1.234, 0.006) << what;
    const std::vector<double> com{0.012, -0.021, 0.071};
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(result["payload"]["com_m"][i].get<double>(), com[i], 6e-4) << what << " axis " << i;
  }

 private:
  fs::path folder_;
};

TEST_F(RobotCases, TheChainLeadsToTheLinkThatCarriesTheSensor) {
  if (!enter("28-urdf-quirks")) GTEST_SKIP() << "../shared/cases is not at hand";
  for (const std::string name : {"fingers", "sensor_link", "dual_right", "prefixed"})
    expectTruth(run({"estimate", name + ".mcap", "--json", "-"}), name);
}

TEST_F(RobotCases, PackagesAreFoundByRosPathsAndToldWhereTheyAreNot) {
  if (!enter("28-urdf-quirks")) GTEST_SKIP() << "../shared/cases is not at hand";
  const auto missing = run({"estimate", "package.mcap"});
  EXPECT_EQ(missing.exitCode, 1);
  EXPECT_THAT(missing.err, HasSubstr("\"package://ur_description/urdf/ur5e.urdf\" was not found"));
  EXPECT_THAT(missing.err, HasSubstr("ROS_PACKAGE_PATH"));
  // The links of prefixed.urdf and those of a UR differ in the prefix alone.
  std::string urdf = read("28-urdf-quirks/prefixed.urdf");
  const std::string tip = readJson("28-urdf-quirks/prefixed.meta.json")["sensor"]["mount"]["parent"];
  const std::string prefix = tip.substr(0, tip.size() - std::string("tool0").size());
  for (auto at = urdf.find(prefix); at != std::string::npos; at = urdf.find(prefix)) urdf.erase(at, prefix.size());
  const std::vector<std::array<std::string, 3>> ways = {
      {"ROS_PACKAGE_PATH", "ros1/src", "ros1/src/ur_description/urdf"},
      {"AMENT_PREFIX_PATH", "ros2", "ros2/share/ur_description/urdf"}};
  for (const auto& [variable, root, folder] : ways) {
    fs::create_directories(path(folder));
    write(folder + "/ur5e.urdf", urdf);
    expectTruth(run({"estimate", "package.mcap", "--json", "-"}, {{variable, path(root).string()}}), variable);
  }
}

TEST_F(RobotCases, OtherUrdfsAreReadOrToldPlainly) {
  if (!enter("38-fr3-and-urdfs")) GTEST_SKIP() << "../shared/cases is not at hand";
  expectTruth(run({"estimate", "fr3.mcap", "--json", "-"}), "fr3");
  expectTruth(run({"estimate", "bom.csv", "--json", "-"}), "bom");
  EXPECT_TRUE(failedWithOneSentence(run({"estimate", "nolink.csv"}), "ft_sensor_link"));
  EXPECT_TRUE(failedWithOneSentence(run({"estimate", "nolimits.csv"}), "has no limits"));
}

TEST_F(RobotCases, EveryFormatIsWrittenFromAResult) {
  if (!enter("15-wall-mount")) GTEST_SKIP() << "../shared/cases is not at hand";
  ASSERT_EQ(run({"estimate", "gravity_in_meta.csv", "--json", "result.json"}).exitCode, 0);
  for (const auto& format : exportFormats())
    EXPECT_EQ(run({"export", "result.json", "--format", std::string(format.id)}).exitCode, 0) << format.id;
}

TEST_F(RobotCases, ARodKeepsItsAxesInSdfAndItsMassBelowARootLink) {
  if (!enter("d06-sdf-dart")) GTEST_SKIP() << "../shared/cases is not at hand";
  const auto sdf = run({"export", "rod.json", "--format", "sdf"});
  EXPECT_THAT(sdf.out, HasSubstr("<pose>0.05 0.05 0.03 0 0 0</pose>"));
  EXPECT_THAT(sdf.out, HasSubstr("<ixy>-0.0019</ixy>"));
  EXPECT_THAT(run({"export", "rod.json", "--format", "urdf"}).out, HasSubstr("give a root link no weight"));
  EXPECT_THAT(run({"export", "rod.json", "--format", "urdf", "--parent", "flange"}).out,
              HasSubstr("<link name=\"flange\"/>"));
}

}  // namespace
}  // namespace heft::test
