// `heft segment`, `heft compensate` and `heft estimate` with several recordings.
#include <gmock/gmock.h>

#include "tests/cli/process.h"

namespace heft::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class SegmentTest : public CliTest {
 protected:
  void pickAndPlace(const std::string& name) const {
    ASSERT_EQ(heft({"simulate", "--motion", "pick-and-place", "--rate", "250", "--seed", "4", "--truth",
                    name + ".truth.json", "-o", name + ".csv"})
                  .exitCode,
              0);
  }
  void freeMotion(const std::string& name, const std::string& seed, const std::string& payload = "") const {
    std::vector<std::string> arguments{"simulate", "--motion", "free", "--rate", "250",        "--duration",
                                       "8",        "--seed",   seed,   "-o",     name + ".csv"};
    if (!payload.empty()) arguments.insert(arguments.end(), {"--payload", payload});
    ASSERT_EQ(heft(arguments).exitCode, 0);
  }
};

TEST_F(SegmentTest, SegmentsAreTextAndJson) {
  pickAndPlace("rec");
  const Outcome text = heft({"segment", "rec.csv", "--json", "segments.json"});
  EXPECT_EQ(text.exitCode, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr(" s free, "));
  EXPECT_THAT(text.out, HasSubstr("Force not explained by the motion."));
  const json result = readJson("segments.json");
  EXPECT_EQ(result["schema"], "heft.segment/1");
  ASSERT_GT(result["segments"].size(), 2u);
  double end = result["segments"][0]["from_s"];
  for (const auto& segment : result["segments"]) {
    EXPECT_NEAR(segment["from_s"].get<double>(), end, 1e-6);
    end = segment["to_s"];
    EXPECT_TRUE(segment["label"] == "free" || segment["label"] == "contact" || segment["label"] == "ignore");
    for (const char* key : {"kind", "reason"}) EXPECT_TRUE(segment[key].is_string());
    EXPECT_GE(segment["confidence"].get<double>(), 0.0);
    EXPECT_LE(segment["confidence"].get<double>(), 1.0);
  }
  const Outcome alone = heft({"segment", "rec.csv", "--json", "-"});
  EXPECT_EQ(json::parse(alone.out)["segments"], result["segments"]);
  // An estimate sees the same segments.
  EXPECT_EQ(heft({"estimate", "rec.csv", "--json", "result.json"}).exitCode, 0);
  EXPECT_EQ(readJson("result.json")["segments"], result["segments"]);
  EXPECT_EQ(heft({"segment", "rec.csv", "--payload", "result.json", "--robot", "panda"}).exitCode, 0);
}

TEST_F(SegmentTest, SegmentFailsInOneSentence) {
  freeMotion("rec", "1");
  write("bad.json", "{\"payload\": 3}");
  EXPECT_TRUE(failedWithOneSentence(heft({"segment", "rec.csv", "--payload", "bad.json"}), "bad.json"));
  EXPECT_TRUE(failedWithOneSentence(heft({"segment", "no.csv"}), "no.csv"));
  EXPECT_TRUE(failedWithOneSentence(heft({"segment", "rec.csv", "--robot", "no.urdf"}), "no.urdf"));
  EXPECT_EQ(heft({"segment", "rec.csv", "--segments", "magic"}).exitCode, 2);
  write("notes.json", "{}");
  EXPECT_TRUE(failedWithOneSentence(heft({"segment", "rec.csv", "--json", "notes.json"}), "already exists"));
}

TEST_F(SegmentTest, CompensateWritesCsvAndPhases) {
  pickAndPlace("rec");
  ASSERT_EQ(heft({"estimate", "rec.csv", "--json", "result.json"}).exitCode, 0);
  const Outcome run = heft({"compensate", "rec.csv", "result.json", "-o", "contact.csv", "--json", "phases.json"});
  EXPECT_EQ(run.exitCode, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("remain in free motion"));
  EXPECT_THAT(read("contact.csv"), testing::StartsWith("time,q1,q2,q3,q4,q5,q6,q7,fx,fy,fz,tx,ty,tz,phase\n"));
  const json result = readJson("phases.json");
  EXPECT_LT(result["free_motion"]["force_rms_n"].get<double>(), 0.07);
  EXPECT_TRUE(std::any_of(result["phases"].begin(), result["phases"].end(),
                          [](const json& phase) { return phase["phase"] == "approach"; }));
  EXPECT_EQ(heft({"compensate", "rec.csv", "result.json", "-o", "-", "--json", "-"}).exitCode, 2);
  EXPECT_TRUE(failedWithOneSentence(heft({"compensate", "rec.csv", "result.json", "-o", "contact.csv"}), "exists"));
  EXPECT_TRUE(failedWithOneSentence(heft({"compensate", "rec.csv", "rec.meta.json"}), "rec.meta.json"));
}

TEST_F(SegmentTest, SeveralRecordingsAreJoined) {
  freeMotion("a", "1");
  freeMotion("b", "2");
  const Outcome run = heft({"estimate", "a.csv", "b.csv", "--json", "result.json"});
  EXPECT_EQ(run.exitCode, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("2 recordings. Use all of them."));
  const json result = readJson("result.json");
  EXPECT_EQ(result["schema"], "heft.estimate/1");
  EXPECT_THAT(result["recording"]["file"].get<std::string>(), HasSubstr("a.csv"));
  ASSERT_EQ(result["recordings"].size(), 2u);
  EXPECT_THAT(result["recordings"][1]["file"].get<std::string>(), HasSubstr("b.csv"));
  EXPECT_EQ(result["selection"]["use"], json({1, 2}));
  EXPECT_EQ(heft({"estimate", "a.csv", "b.csv", "--compare"}).exitCode, 2);
  EXPECT_EQ(heft({"estimate", "a.csv", "b.csv", "--meta", "a.meta.json"}).exitCode, 2);
  EXPECT_TRUE(failedWithOneSentence(heft({"estimate", "a.csv", "b.csv", "--method", "ls"}), "map"));
  EXPECT_EQ(heft({"export", "result.json", "--format", "franka-desk"}).exitCode, 0);
}

}  // namespace
}  // namespace heft::test
