// Whatever a setup file states about the numbers: every command does what it does with the plain recording.
#include <gmock/gmock.h>

#include "core/recording/csv_reader.h"
#include "tests/cli/process.h"
#include "tests/support/in_conventions.h"

namespace heft::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing_support::MotionForm;
using testing_support::numbersIn;
using testing_support::PlainMotion;
using testing_support::withRig;

const json kBaseAxes = {{"sensor",
                         {{"wrench_sign", "payload_on_sensor"},
                          {"wrench_axes", "base"},
                          {"wrench_point", "base"},
                          {"wrench_order", "torque_first"},
                          {"torque_unit", "lbf in"},
                          {"force_unit", "lbf"}}},
                        {"angle_unit", "deg"}};
const json kOddPoses = {{"sensor",
                         {{"wrench_axes", "base"},
                          {"wrench_point", {0.0, 0.02, 0.1}},
                          {"mirrored_axis", "x"},
                          {"torque_sign", "opposite"},
                          {"torque_unit", "N mm"}}},
                        {"pose", "base_in_sensor"},
                        {"quaternion_order", "wxyz"},
                        {"length_unit", "mm"}};

class ConventionsTest : public CliTest {
 protected:
  /// plain.csv and NAME.csv, the same motion in other conventions.
  void make(const std::string& name, const json& conventions, MotionForm form) {
    if (!exists("rec.csv")) simulate("rec");
    auto read = readRecording(path("rec.csv"));
    ASSERT_TRUE(read) << read.error().message;
    const PlainMotion motion(std::move(read->recording));
    for (const auto& [file, meta] : {std::pair(std::string("plain"), json::object()), std::pair(name, conventions)}) {
      write(file + ".csv", numbersIn(meta, motion, form).csv());
      json whole = withRig(meta, motion.recording.meta);
      if (form == MotionForm::poses) whole["robot"] = nullptr;
      write(file + ".meta.json", whole.dump());
    }
  }
  json resultOf(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--json", "-"});
    const Outcome run = heft(arguments);
    EXPECT_EQ(run.exitCode, 0) << run.err;
    return run.exitCode == 0 ? json::parse(run.out) : json();
  }
  static void expectNear(const json& a, const json& b, double tolerance) {
    const json one = a.flatten(), other = b.flatten();
    ASSERT_EQ(one.size(), other.size());
    for (const auto& [key, value] : one.items()) {
      if (!value.is_number()) continue;
      EXPECT_NEAR(value.get<double>(), other[key].get<double>(), tolerance * (1.0 + std::abs(value.get<double>())))
          << key;
    }
  }
};

TEST_F(ConventionsTest, EveryCommandObeys) {
  for (const auto& [conventions, form] :
       {std::pair(kBaseAxes, MotionForm::joints), std::pair(kOddPoses, MotionForm::poses)}) {
    make("odd", conventions, form);
    const json estimate = resultOf({"estimate", "odd.csv"});
    const json plain = resultOf({"estimate", "plain.csv"});
    expectNear(plain["payload"], estimate["payload"], 1e-6);
    expectNear(plain["bias"], estimate["bias"], 1e-6);
    expectNear(resultOf({"segment", "plain.csv"})["segments"], resultOf({"segment", "odd.csv"})["segments"], 1e-6);
    write("found.json", plain.dump());
    ASSERT_EQ(heft({"compensate", "plain.csv", "found.json", "-o", "a.csv"}).exitCode, 0);
    ASSERT_EQ(heft({"compensate", "odd.csv", "found.json", "-o", "b.csv"}).exitCode, 0);
    const auto a = readRecording(path("a.csv")), b = readRecording(path("b.csv"));
    ASSERT_TRUE(a && b);
    EXPECT_LT((a->recording.wrench - b->recording.wrench).cwiseAbs().maxCoeff(), 1e-4) << "six digits are written";
    const json found = resultOf({"diagnose", "odd.csv"});
    EXPECT_EQ(found["verdict"], resultOf({"diagnose", "plain.csv"})["verdict"]);
    for (const char* name : {"a.csv", "b.csv", "found.json"}) std::filesystem::remove(path(name));
  }
}

TEST_F(ConventionsTest, ConvertTakesThemOut) {
  make("odd", kBaseAxes, MotionForm::joints);
  const Outcome run = heft({"convert", "odd.csv", "straight.csv", "--json", "check.json"});
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("wrench_axes base"));
  const auto straight = readRecording(path("straight.csv")), plain = readRecording(path("plain.csv"));
  ASSERT_TRUE(straight && plain);
  EXPECT_LT((straight->recording.wrench - plain->recording.wrench).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT((straight->recording.q - plain->recording.q).cwiseAbs().maxCoeff(), 1e-12);
  const json meta = readJson("straight.meta.json");
  EXPECT_EQ(meta["sensor"].size(), 2u) << meta;  // mount and wrench_sign
  EXPECT_EQ(meta["sensor"]["wrench_sign"], "sensor_on_payload");
  EXPECT_FALSE(meta.contains("angle_unit"));
  EXPECT_EQ(readJson("check.json")["conventions_taken_out"]["torque_unit"], "lbf in");
  ASSERT_EQ(heft({"convert", "straight.csv", "twice.csv"}).exitCode, 0);
  EXPECT_EQ(read("straight.csv"), read("twice.csv"));
}

TEST_F(ConventionsTest, AReplayEstimatesTheSame) {
  make("odd", kBaseAxes, MotionForm::joints);
  ASSERT_EQ(heft({"live", "replay:odd.csv?speed=6", "--json", "live.json", "--record", "live.csv"}).exitCode, 0);
  const double mass = resultOf({"estimate", "plain.csv"})["payload"]["mass_kg"];
  EXPECT_NEAR(readJson("live.json")["payload"]["mass_kg"].get<double>(), mass, 1e-3 * mass);
  EXPECT_NEAR(resultOf({"estimate", "live.csv"})["payload"]["mass_kg"].get<double>(), mass, 1e-3 * mass);
}

TEST_F(ConventionsTest, AReplaySaysAtOnceWhatTheNumbersMeanAndCanObey) {
  simulate("rec", {"--duration", "16", "--rate", "200"});
  make("odd", kBaseAxes, MotionForm::joints);
  json meta = readJson("plain.meta.json");
  meta["angle_unit"] = "deg";
  write("odd.meta.json", meta.dump());
  const Outcome stated = heft({"live", "replay:odd.csv?speed=4", "--json", "stated.json"});
  ASSERT_EQ(stated.exitCode, 0) << stated.err;
  EXPECT_THAT(stated.err, HasSubstr("The force is given in the robot's base axes"));
  EXPECT_THAT(stated.err, HasSubstr("--conventions suggested"));
  EXPECT_THAT(stated.err, HasSubstr("no mass: "));
  EXPECT_EQ(readJson("stated.json")["trust"], "none");
  const Outcome so = heft({"live", "replay:odd.csv?speed=4", "--conventions", "suggested", "--json", "suggested.json"});
  ASSERT_EQ(so.exitCode, 0) << so.err;
  EXPECT_THAT(so.err, HasSubstr("are read so from now on"));
  EXPECT_THAT(so.err, HasSubstr(" kg ["));
  const double mass = resultOf({"estimate", "plain.csv"})["payload"]["mass_kg"];
  EXPECT_NEAR(readJson("suggested.json")["payload"]["mass_kg"].get<double>(), mass, 0.02 * mass);
  EXPECT_EQ(heft({"live", "replay:odd.csv", "--conventions", "guessed"}).exitCode, 2);
}

TEST_F(ConventionsTest, TheListSaysWhatTheNumbersMean) {
  make("odd", kBaseAxes, MotionForm::joints);
  const Outcome right = heft({"convert", "odd.csv", "--list", "--json", "right.json"});
  ASSERT_EQ(right.exitCode, 0) << right.err;
  EXPECT_THAT(right.out, HasSubstr("The readings follow the stated conventions."));
  EXPECT_EQ(readJson("right.json")["conventions"]["verdict"], "as_stated");
  json meta = readJson("plain.meta.json");
  meta["angle_unit"] = "deg";
  write("odd.meta.json", meta.dump());
  const Outcome wrong = heft({"convert", "odd.csv", "--list", "--json", "wrong.json"});
  EXPECT_THAT(wrong.out, HasSubstr("base axes"));
  EXPECT_EQ(readJson("wrong.json")["conventions"]["meta"]["sensor"]["wrench_axes"], "base");
  // Without a wrench there is nothing to ask.
  write("half.csv", "time,q1,q2,q3,q4,q5,q6,q7\n0,0,0,0,0,0,0,0\n0.1,0,0,0,0,0,0,0\n");
  ASSERT_EQ(heft({"convert", "half.csv", "--list", "--json", "half.json"}).exitCode, 0);
  EXPECT_TRUE(readJson("half.json")["conventions"].is_null());
}

TEST_F(ConventionsTest, WhatCannotBeIsRefusedWithOneSentence) {
  make("odd", {{"sensor", {{"wrench_axes", "tool"}}}}, MotionForm::joints);
  EXPECT_TRUE(
      failedWithOneSentence(heft({"estimate", "odd.csv"}), "sensor.wrench_axes: must be \"sensor\" or \"base\""));
}

TEST_F(ConventionsTest, WhatIsNotStatedIsSaidAndCanBeObeyed) {
  make("odd", kBaseAxes, MotionForm::joints);
  // As if nobody had said anything: the same numbers with the plain setup file, but for the unit of the angles.
  json meta = readJson("plain.meta.json");
  meta["angle_unit"] = "deg";
  write("odd.meta.json", meta.dump());
  const json stated = resultOf({"estimate", "odd.csv"});
  EXPECT_EQ(stated["trust"], "none");
  EXPECT_EQ(stated["identifiability"]["mass"], "none");
  EXPECT_TRUE(stated["conventions"]["suggested"].is_object()) << stated["conventions"].dump();
  const Outcome text = heft({"estimate", "odd.csv"});
  EXPECT_THAT(text.out, HasSubstr("--conventions suggested"));
  EXPECT_THAT(text.out, testing::Not(HasSubstr("Your tool weighs")));
  write("odd.json", stated.dump());
  EXPECT_TRUE(failedWithOneSentence(heft({"export", "odd.json", "--format", "ur"}), "are not reliable"));
  const json suggested = resultOf({"estimate", "odd.csv", "--conventions", "suggested"});
  const json plain = resultOf({"estimate", "plain.csv"});
  const double mass = plain["payload"]["mass_kg"];
  EXPECT_NE(suggested["trust"], "none");
  EXPECT_NEAR(suggested["payload"]["mass_kg"].get<double>(), mass, 0.02 * mass);
}

}  // namespace
}  // namespace heft::test
