// heft coach and heft excite.
#include <gmock/gmock.h>

#include <sstream>

#include "core/robot/robot_model.h"
#include "tests/cli/process.h"

namespace heft::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

using CoachTest = CliTest;

TEST_F(CoachTest, ProposesAMotionWithItsGain) {
  simulate("rec", {"--duration", "5", "--rate", "250", "--speed", "0.2"});
  const Outcome run = heft({"coach", "rec.csv", "--want", "inertia", "--json", "advice.json", "-o", "motion.csv"});
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("inertia ± "));
  EXPECT_THAT(run.out, HasSubstr(" -> "));
  EXPECT_THAT(run.out, HasSubstr("ISO/TS 15066"));
  const json advice = readJson("advice.json");
  EXPECT_EQ(advice["schema"], "heft.coach/1");
  EXPECT_EQ(advice["about"], "inertia");
  EXPECT_LT(advice["interval95_after"]["inertia_relative"], advice["interval95_before"]["inertia_relative"]);
  EXPECT_EQ(advice["advice"]["target_q_rad"].size(), 7u);
  EXPECT_LE(advice["advice"]["tcp_speed_m_s"], 0.25);
  EXPECT_THAT(read("motion.csv"), HasSubstr("time,q1,q2"));
  EXPECT_EQ(heft({"coach", "rec.csv", "--want", "colour"}).exitCode, 2);
}

TEST_F(CoachTest, PosesHaveLightsAndANextPose) {
  simulate("rec", {"--duration", "20", "--rate", "50", "--motion", "excitation"});
  // Every hundredth row as a standing pose.
  std::istringstream lines(read("rec.csv"));
  std::string text, line;
  std::getline(lines, line);
  text = line + "\n";
  for (int row = 0; std::getline(lines, line); ++row)
    if (row % 100 == 50) text += line + "\n";
  write("poses.csv", text);
  json meta = readJson("rec.meta.json");
  meta["kind"] = "poses";
  write("poses.meta.json", meta.dump());
  const Outcome run = heft({"coach", "poses.csv", "--json", "poses.json"});
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("Next pose"));
  const json result = readJson("poses.json");
  EXPECT_EQ(result["poses"].size(), 10u);
  EXPECT_EQ(result["next"]["q_rad"].size(), 7u);
}

TEST_F(CoachTest, KeepsClearOfARoomAndSaysWhatIsInTheWay) {
  simulate("rec", {"--duration", "5", "--rate", "250", "--speed", "0.2"});
  write("room.json", R"({"schema": "heft.room/1", "obstacles": [
      {"name": "table", "plane": {"point_m": [0, 0, -0.1], "normal": [0, 0, 1]}}]})");
  const std::vector<std::string> coach{
      "coach", "rec.csv", "--room", "room.json", "--shape", "box:0.06,0.06,0.16@0,0,0.08", "--json", "advice.json"};
  const Outcome run = heft(coach);
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("20 mm clear of each other and of the 1 obstacle in room.json"));
  EXPECT_EQ(readJson("advice.json")["clearance"]["obstacles"], 1);
  EXPECT_EQ(heft({"excite", "rec.csv", "--room", "room.json", "-o", "replay.csv", "--rate", "100"}).exitCode, 0);

  // The whole arm stands in it.
  write("room.json", R"({"schema": "heft.room/1", "obstacles": [{"name": "block", "box": {"size_m": [4, 4, 4]}}]})");
  EXPECT_TRUE(failedWithOneSentence(heft(coach), "block"));
  EXPECT_TRUE(failedWithOneSentence(heft({"excite", "rec.csv", "--room", "room.json", "-o", "more.csv"}), "block"));
  const std::vector<std::string> simulated{"simulate", "--motion", "free",      "--duration", "3",         "--rate",
                                           "250",      "--room",   "room.json", "-o",         "inside.csv"};
  EXPECT_TRUE(failedWithOneSentence(heft(simulated), "block"));
  write("room.json", R"({"schema": "heft.room/1", "obstacles": [{"name": "table", "plane": {"point_m": [0, 0]}}]})");
  EXPECT_TRUE(failedWithOneSentence(heft(coach), "room.json"));
  EXPECT_TRUE(failedWithOneSentence(heft({"coach", "rec.csv", "--room", "none.json"}), "none.json"));
  EXPECT_EQ(heft({"coach", "rec.csv", "--shape", "box:0.1,0.1,0.1", "--shape-file", "tool.json"}).exitCode, 2);
}

TEST_F(CoachTest, ASimulatedMotionThatMeetsTheRoomIsReplacedByOneThatDoesNot) {
  const auto make = [&](const std::string& name, const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"simulate", "--motion",           "free", "--duration", "20", "--rate", "100",
                                       "--truth",  name + ".truth.json", "-o",   name + ".csv"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return heft(arguments);
  };
  /// How far the flange goes along y [m].
  const auto farthest = [&](const std::string& name) {
    std::istringstream lines(read(name + ".csv"));
    std::string line;
    std::getline(lines, line);
    const int flange = *RobotModel::panda().findLink("panda_link8");
    double y = 0.0;
    while (std::getline(lines, line)) {
      VectorXd q(7);
      std::istringstream cells(line.substr(line.find(',') + 1));
      for (double& angle : q) {
        cells >> angle;
        cells.ignore();
      }
      y = std::max(y, RobotModel::panda().linkPose(q, flange).translation().y());
    }
    return y;
  };
  ASSERT_EQ(make("open", {"--seed", "2"}).exitCode, 0);
  write("room.json", R"({"schema": "heft.room/1", "obstacles": [
      {"name": "wall", "plane": {"point_m": [0, 0.28, 0], "normal": [0, -1, 0]}}]})");
  const Outcome replaced = make("clear", {"--seed", "2", "--room", "room.json"});
  ASSERT_EQ(replaced.exitCode, 0) << replaced.err;
  EXPECT_THAT(replaced.out, HasSubstr("of this seed: the first that stays clear of the room. In motion 1:"));
  EXPECT_LT(farthest("clear"), 0.26);
  EXPECT_NE(farthest("clear"), farthest("open"));
  // What is not the motion stays that of the seed, and the same command makes the same recording.
  EXPECT_EQ(readJson("clear.truth.json")["bias"], readJson("open.truth.json")["bias"]);
  ASSERT_EQ(make("once_more", {"--seed", "2", "--room", "room.json"}).exitCode, 0);
  EXPECT_EQ(read("once_more.csv"), read("clear.csv"));

  write("room.json", R"({"schema": "heft.room/1", "obstacles": []})");
  ASSERT_EQ(make("empty", {"--seed", "2", "--room", "room.json"}).exitCode, 0);
  EXPECT_EQ(read("empty.csv"), read("open.csv"));
}

TEST_F(CoachTest, SimulatedArmsCarryWhatTheirJointsCan) {
  write("heavy.json", R"({"mass_kg": 12, "com_m": [0, 0, 0.1],
      "inertia_com_kgm2": [[0.05, 0, 0], [0, 0.05, 0], [0, 0, 0.05]]})");
  const std::vector<std::string> simulated{"simulate", "--motion",  "free",       "--duration", "3",        "--rate",
                                           "250",      "--payload", "heavy.json", "-o",         "heavy.csv"};
  const Outcome run = heft(simulated);
  EXPECT_EQ(run.exitCode, 1);
  EXPECT_THAT(run.err,
              testing::ContainsRegex("Joint panda_joint[0-9] would need [0-9.]+ N m of the allowed [0-9.]+ N m"));
  EXPECT_THAT(run.err, HasSubstr(" s into the motion"));
}

TEST_F(CoachTest, ARoomIsWrittenFromTouchesAndReadAgain) {
  simulate("pick", {"--motion", "pick-and-place", "--seed", "3", "--duration", "15"});
  const std::vector<std::string> room{"room", "pick.csv", "--shape", "cylinder:0.01,0.15@0,0,0.075", "-o", "room.json"};
  const Outcome run = heft(room);
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("touch"));
  const json written = readJson("room.json");
  EXPECT_EQ(written["schema"], "heft.room/1");
  ASSERT_GE(written["obstacles"].size(), 1u);
  EXPECT_EQ(heft(room).exitCode, 0) << "its own file";
  EXPECT_EQ(heft({"room", "pick.csv", "-o", "room.json"}).exitCode, 2) << "without a shape";
  simulate("free", {"--motion", "free", "--seed", "3", "--duration", "8"});
  EXPECT_TRUE(
      failedWithOneSentence(heft({"room", "free.csv", "--shape", "sphere:0.03", "-o", "none.json"}), "free.csv"));
}

TEST_F(CoachTest, ExcitesAReplay) {
  simulate("rec", {"--duration", "8", "--rate", "250", "--speed", "0.3"});
  const Outcome run = heft({"excite", "rec.csv", "-o", "replay.csv", "--rate", "500", "--json", "replay.json"});
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("after this replay"));
  const json result = readJson("replay.json");
  EXPECT_EQ(result["schema"], "heft.excite/1");
  for (const auto& [name, use] : result["limit_use"].items()) EXPECT_LE(use, 1.0) << name;
  EXPECT_LT(result["interval95_excited"]["inertia_relative"], result["interval95_replayed"]["inertia_relative"]);
  EXPECT_LE(result["deviation_m"], 0.02);
  // A second run would lose the file.
  EXPECT_EQ(heft({"excite", "rec.csv", "-o", "replay.csv", "--rate", "250"}).exitCode, 1);
}

}  // namespace
}  // namespace heft::test
