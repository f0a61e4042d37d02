// `heft simulate --like FOUND`.
#include <gmock/gmock.h>

#include "tests/cli/process.h"

namespace heft::test {
namespace {

using testing::HasSubstr;

class TwinCommandTest : public CliTest {};

TEST_F(TwinCommandTest, MakesRecordingsWithTheCausesThatWereFound) {
  simulate("late",
           {"--motion", "free", "--duration", "15", "--rate", "250", "--seed", "31", "--effect", "time_offset=15"});
  ASSERT_EQ(heft({"diagnose", "late.csv", "--surrogates", "0", "--json", "found.json"}).exitCode, 0);
  ASSERT_EQ(readJson("found.json")["causes"][0]["cause"], "time_offset");
  const std::vector<std::string> like{"simulate", "--like", "found.json", "--duration",
                                      "3",        "--rate", "250",        "--force"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), like.begin(), like.end());
    return heft(more);
  };
  const Outcome twin = with({"--fixed", "-o", "twin.csv", "--truth", "truth.json"});
  ASSERT_EQ(twin.exitCode, 0) << twin.err;
  EXPECT_THAT(twin.out, HasSubstr("free hand guiding"));
  EXPECT_THAT(twin.out, HasSubstr("  time_offset  delay "));
  const auto truth = readJson("truth.json");
  EXPECT_NEAR(truth["effects"][0]["parameters"]["delay"].get<double>(), 15.0, 1.0);
  EXPECT_EQ(truth["payload"]["mass_kg"], readJson("found.json")["payload_after"]["mass_kg"]);

  const Outcome off = with({"--without", "time_offset", "--motion", "excitation", "-o", "off.csv"});
  ASSERT_EQ(off.exitCode, 0) << off.err;
  EXPECT_THAT(off.out, HasSubstr("time_offset is left out: It is switched off."));

  EXPECT_TRUE(failedWithOneSentence(with({"--without", "cable_pull", "-o", "no.csv"}), "it found time_offset"));
  EXPECT_EQ(with({"--without", "time_offset", "--motion", "fast", "-o", "no.csv"}).exitCode, 2);
}

TEST_F(TwinCommandTest, WritesTheRigForOtherSimulators) {
  simulate("beside",
           {"--motion", "free", "--duration", "15", "--rate", "250", "--seed", "31", "--effect", "lever_arm=30"});
  const Outcome timed = heft({"diagnose", "beside.csv", "--surrogates", "0", "--json", "found.json", "--timing"});
  ASSERT_EQ(timed.exitCode, 0) << timed.err;
  EXPECT_THAT(timed.out, HasSubstr("Testing causes"));
  const auto found = readJson("found.json");
  ASSERT_EQ(found["causes"][0]["cause"], "lever_arm");
  double sum = 0.0;
  for (const auto& stage : found["timing_s"]["stages"]) sum += stage["wall_s"].get<double>();
  EXPECT_GT(sum, 0.9 * found["timing_s"]["total"].get<double>()) << "the stages are all of it";
  const Outcome run = heft({"export-model", "found.json", "--for", "json", "-o", "rig.json"});
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("lever_arm"));
  const auto rig = readJson("rig.json");
  EXPECT_EQ(rig["payload"]["mass_kg"], found["payload_after"]["mass_kg"]);
  for (std::size_t axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(rig["sensor_mount"]["xyz_m"][axis].get<double>() + rig["sensor_as_found"]["xyz_m"][axis].get<double>(),
                found["meta_changes"]["sensor"]["mount"]["xyz_m"][axis].get<double>(), 1e-9);
  EXPECT_EQ(heft({"export-model", "found.json", "--for", "json", "-o", "rig.json"}).exitCode, 0) << "its own file";
  auto edited = rig;
  edited["remark"] = "mine";
  write("rig.json", edited.dump(2));
  EXPECT_TRUE(
      failedWithOneSentence(heft({"export-model", "found.json", "--for", "json", "-o", "rig.json"}), "--force"));
  const Outcome off = heft({"export-model", "found.json", "--for", "json", "--without", "lever_arm"});
  EXPECT_THAT(off.out, HasSubstr("\"causes\": []"));
  for (const char* target : {"mujoco", "gazebo"})
    EXPECT_THAT(heft({"export-model", "found.json", "--for", target}).out, HasSubstr("lever_arm")) << target;

  // What is wrong in it is named, whoever reads it.
  ASSERT_EQ(heft({"estimate", "beside.csv", "--json", "result.json"}).exitCode, 0);
  for (const auto& [pointer, told] :
       {std::pair{"/causes/0/parameters/x/unit", "causes[0].parameters.x.unit is no text"},
        {"/causes/0/title", "causes[0].title is no text"},
        {"/causes/0/text", "causes[0].text is no text"},
        {"/causes/0/when", "causes[0].when is no list"},
        {"/smallest_visible/0/unit", "smallest_visible[0].unit is no text"},
        {"/meta_changes", "meta_changes is no object"},
        {"/model", "model is no object"},
        {"/model/terms/0/cause", "model.terms[0].cause is no text"},
        {"/sensor_noise", "sensor_noise is no object"}}) {
    nlohmann::json odd = found;
    odd[nlohmann::json::json_pointer(pointer)] = nullptr;
    write("odd.json", odd.dump());
    const std::string sentence = std::string("odd.json: ") + told + "; make it again with heft diagnose";
    EXPECT_TRUE(failedWithOneSentence(heft({"export-model", "odd.json", "--for", "json"}), sentence)) << pointer;
    EXPECT_TRUE(failedWithOneSentence(
        heft({"passport", "result.json", "--tool", "a", "--date", "2026-11-29", "--causes", "odd.json"}), sentence))
        << pointer;
  }
  EXPECT_EQ(heft({"export-model", "found.json", "--for", "unity"}).exitCode, 2);
  EXPECT_EQ(heft({"export-model", "found.json"}).exitCode, 2);
  write("mine.xml", "<mujoco/>");
  EXPECT_TRUE(
      failedWithOneSentence(heft({"export-model", "found.json", "--for", "mujoco", "-o", "mine.xml"}), "mine.xml"));
  EXPECT_TRUE(failedWithOneSentence(heft({"export-model", "found.json", "--for", "json", "--without", "cable_pull"}),
                                    "it found lever_arm"));
}

TEST_F(TwinCommandTest, SaysWhatGoesTogether) {
  EXPECT_EQ(heft({"simulate", "-o", "no.csv"}).exitCode, 2);
  EXPECT_EQ(heft({"simulate", "--motion", "free", "--fixed", "-o", "no.csv"}).exitCode, 2);
  EXPECT_EQ(heft({"simulate", "--motion", "free", "--without", "time_offset", "-o", "no.csv"}).exitCode, 2);
  write("other.json", R"({"schema": "heft.estimate/1"})");
  EXPECT_TRUE(failedWithOneSentence(heft({"simulate", "--like", "other.json", "-o", "no.csv"}), "other.json"));
}

}  // namespace
}  // namespace heft::test
