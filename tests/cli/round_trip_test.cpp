// The main job, end to end: simulate, estimate, export, with a truth to compare against.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <sstream>

#include "core/payload/inertial_parameters.h"
#include "tests/cli/process.h"

namespace heft::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;

class RoundTripTest : public CliTest {
 protected:
  Payload payloadIn(const std::string& file) const {
    auto payload = payloadFromJson(readJson(file), file);
    EXPECT_TRUE(payload.ok());
    return *payload;
  }
};

TEST_F(RoundTripTest, SimulateEstimateExport) {
  simulate("rec", {"--seed", "5"});
  const Outcome run = heft({"estimate", "rec.csv", "--json", "result.json"});
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("kg"));
  EXPECT_THAT(run.err, IsEmpty());

  const Payload truth = payloadIn("rec.truth.json"), estimate = payloadIn("result.json");
  EXPECT_NEAR(estimate.mass, truth.mass, 0.002 * truth.mass);
  EXPECT_LT((estimate.com - truth.com).norm(), 0.01 * truth.com.norm());
  EXPECT_LT((estimate.inertiaCom - truth.inertiaCom).norm(), 0.10 * truth.inertiaCom.norm())
      << estimate.inertiaCom << "\n\n"
      << truth.inertiaCom;
  const json bias = readJson("rec.truth.json")["bias"], found = readJson("result.json")["bias"];
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(found["force_n"][i].get<double>(), bias["force_n"][i].get<double>(), 0.05);
    EXPECT_NEAR(found["torque_nm"][i].get<double>(), bias["torque_nm"][i].get<double>(), 0.005);
  }

  ASSERT_EQ(heft({"export", "result.json", "--format", "json", "-o", "tool.json"}).exitCode, 0);
  const Payload flange = payloadIn("tool.json");
  // The simulator's own mount; the file is rounded to what a controller can use.
  EXPECT_LT((flange.com - estimate.com - Vector3d(0, 0, 0.04)).norm(), 2e-6);
  EXPECT_LT((flange.inertiaCom - estimate.inertiaCom).norm(), 3e-8);
}

TEST_F(RoundTripTest, EstimateWritesTheSamePayloadFileAsExport) {
  simulate("rec");
  ASSERT_EQ(
      heft({"estimate", "rec.csv", "--json", "result.json", "-o", "direct.json", "--format", "franka-desk"}).exitCode,
      0);
  ASSERT_EQ(heft({"export", "result.json", "--format", "franka-desk", "-o", "tool.json"}).exitCode, 0);
  EXPECT_EQ(readJson("direct.json"), readJson("tool.json"));
}

TEST_F(RoundTripTest, SimulationIsDeterministicAndSeeded) {
  for (const std::string motion : {"excitation", "pick-and-place", "free"}) {
    simulate("a", {"--motion", motion, "--seed", "3", "--duration", "8", "--rate", "200"});
    simulate("b", {"--motion", motion, "--seed", "3", "--duration", "8", "--rate", "200"});
    simulate("c", {"--motion", motion, "--seed", "4", "--duration", "8", "--rate", "200"});
    EXPECT_EQ(read("a.csv"), read("b.csv")) << motion;
    EXPECT_EQ(read("a.meta.json"), read("b.meta.json"));
    EXPECT_EQ(read("a.truth.json"), read("b.truth.json"));
    EXPECT_NE(read("a.csv"), read("c.csv"));
  }
}

TEST_F(RoundTripTest, EstimateIsDeterministicApartFromItsClock) {
  simulate("rec", {"--motion", "free"});
  ASSERT_EQ(heft({"estimate", "rec.csv", "--json", "first.json"}).exitCode, 0);
  const Outcome run = heft({"estimate", "rec.csv", "--json", "-"});
  ASSERT_EQ(run.exitCode, 0);
  json first = readJson("first.json"), second = json::parse(run.out);  // so - writes JSON and nothing else
  EXPECT_EQ(first.erase("checksum"), 1u);
  first.erase("timing_s");
  second.erase("timing_s");
  EXPECT_EQ(first, second);
}

TEST_F(RoundTripTest, TruthStaysOutOfTheRecording) {
  simulate("rec", {"--motion", "pick-and-place", "--duration", "8", "--rate", "200"});
  const json meta = readJson("rec.meta.json");
  EXPECT_FALSE(meta.contains("known_payload") && !meta["known_payload"].is_null()) << meta;
  EXPECT_TRUE(!meta.contains("marks") || meta["marks"].empty()) << meta;
  EXPECT_EQ(read("rec.csv").find("label"), std::string::npos);
  EXPECT_FALSE(readJson("rec.truth.json")["marks"].empty());
}

TEST_F(RoundTripTest, SimulatesTheGivenPayload) {
  write("payload.json", R"({"mass_kg": 0.5, "com_m": [0.02, 0.01, 0.05],
                            "inertia_com_kgm2": [[0.001, 0, 0], [0, 0.0012, 0], [0, 0, 0.0008]]})");
  simulate("rec", {"--payload", "payload.json", "--duration", "6", "--rate", "250"});
  EXPECT_EQ(payloadIn("rec.truth.json").mass, 0.5);
  ASSERT_EQ(heft({"estimate", "rec.csv", "--json", "result.json"}).exitCode, 0);
  EXPECT_NEAR(payloadIn("result.json").mass, 0.5, 0.005);
}

TEST_F(RoundTripTest, KnownValuesGiveRelativeErrors) {
  simulate("rec");
  ASSERT_EQ(heft({"estimate", "rec.csv", "--known", "rec.truth.json", "--json", "result.json"}).exitCode, 0);
  const json error = readJson("result.json")["relative_error"];
  EXPECT_LT(error["mass"].get<double>(), 0.01) << error;
}

TEST_F(RoundTripTest, MassComKeepsTheKnownInertia) {
  simulate("rec");
  ASSERT_EQ(heft({"estimate", "rec.csv", "--parameters", "mass-com", "--known", "rec.truth.json", "--json", "r.json"})
                .exitCode,
            0);
  const Payload truth = payloadIn("rec.truth.json"), estimate = payloadIn("r.json");
  EXPECT_TRUE(estimate.inertiaCom.isApprox(truth.inertiaCom, 1e-6)) << estimate.inertiaCom;
  EXPECT_NE(estimate.mass, truth.mass);
}

TEST_F(RoundTripTest, OptionsReachTheEstimator) {
  simulate("rec");
  const auto result = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"estimate", "rec.csv", "--json", "-"});
    const Outcome run = heft(arguments);
    EXPECT_EQ(run.exitCode, 0) << run.err;
    return json::parse(run.out);
  };
  const json standard = result({});
  EXPECT_EQ(result({"--method", "ls"})["method"], "ls");
  EXPECT_EQ(result({"--parameters", "mass"})["parameters"], "mass");
  EXPECT_LT(result({"--trim", "0.3"})["recording"]["used_s"], standard["recording"]["used_s"]);
  EXPECT_EQ(result({"--no-bias"})["bias"]["force_n"], json({0.0, 0.0, 0.0}));
  for (const std::vector<std::string>& option :
       std::vector<std::vector<std::string>>{{"--cutoff", "6"},
                                             {"--smoothing", "savitzky-golay"},
                                             {"--smoothing", "savitzky-golay", "--sg-order", "5", "--sg-window", "31"}})
    EXPECT_NE(result(option)["payload"], standard["payload"]) << option.back();
}

TEST_F(RoundTripTest, SevenJointsWithoutAMetaFileAreAPanda) {
  simulate("rec", {"--xyz", "0,0,0", "--duration", "6", "--rate", "250"});
  const json expected = json::parse(heft({"estimate", "rec.csv", "--json", "-"}).out);
  std::filesystem::remove(path("rec.meta.json"));
  const Outcome run = heft({"estimate", "rec.csv", "--json", "-"});
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_EQ(json::parse(run.out)["payload"], expected["payload"]);
  EXPECT_THAT(json::parse(run.out)["findings"].dump(), HasSubstr("Panda"));
}

TEST_F(RoundTripTest, AnUnknownArmIsAskedFor) {
  simulate("rec");
  std::string text = read("rec.csv");
  text.replace(text.find("q7"), 2, "Q0");  // six joints are nobody's in particular
  write("six.csv", text);
  EXPECT_TRUE(failedWithOneSentence(heft({"estimate", "six.csv"}), "robot"));
}

TEST_F(RoundTripTest, RecordingsOfRealRobotsAreNotSimulatedOver) {
  write("real.csv", "time,q1\n0,0\n");
  EXPECT_TRUE(failedWithOneSentence(heft({"simulate", "--motion", "free", "-o", "real.csv"}), "--force"));
  EXPECT_EQ(read("real.csv"), "time,q1\n0,0\n");
  simulate("rec", {"--duration", "4", "--rate", "100", "--seed", "1"});
  const std::string first = read("rec.csv");
  simulate("rec", {"--duration", "4", "--rate", "100", "--seed", "2"});  // its own can be made again
  EXPECT_NE(read("rec.csv"), first);
}

TEST_F(RoundTripTest, WhatSomebodyPutIntoASimulatedFileIsNotSimulatedOver) {
  const std::vector<std::string> again{"simulate", "--motion", "free",    "--duration", "2",     "--seed",
                                       "2",        "-o",       "rec.csv", "--truth",    "t.json"};
  ASSERT_EQ(heft(again).exitCode, 0);
  const std::string csv = read("rec.csv"), meta = read("rec.meta.json"), truth = read("t.json");
  EXPECT_EQ(heft(again).exitCode, 0);
  write("rec.csv", "time,q1\n0,0\n");
  EXPECT_TRUE(failedWithOneSentence(heft(again), "rec.csv already exists and was not overwritten"));
  EXPECT_EQ(read("rec.csv"), "time,q1\n0,0\n");
  EXPECT_EQ(read("rec.meta.json"), meta);
  write("rec.csv", csv);
  json edited = json::parse(truth);
  edited["remark"] = "mine";
  write("t.json", edited.dump(2));
  EXPECT_TRUE(failedWithOneSentence(heft(again), "t.json already exists and was not overwritten"));
  EXPECT_EQ(readJson("t.json"), edited);
  EXPECT_EQ(read("rec.csv"), csv);
}

TEST_F(RoundTripTest, OtherPeoplesJsonIsNotOverwrittenByAResult) {
  simulate("rec");
  write("notes.json", R"({"mine": true})");
  EXPECT_TRUE(failedWithOneSentence(heft({"estimate", "rec.csv", "--json", "notes.json"}), "--force"));
  EXPECT_EQ(read("notes.json"), R"({"mine": true})");
  ASSERT_EQ(heft({"estimate", "rec.csv", "--json", "result.json"}).exitCode, 0);
  EXPECT_EQ(heft({"estimate", "rec.csv", "--json", "result.json", "--trim", "0.2"}).exitCode, 0);
  // One that a person changed cannot be made again; one that was only laid out anew can.
  json result = readJson("result.json");
  write("result.json", result.dump());
  EXPECT_EQ(heft({"estimate", "rec.csv", "--json", "result.json"}).exitCode, 0);
  for (const auto& [command, file] : {std::pair{"estimate", "edited.json"}, {"segment", "segments.json"}}) {
    ASSERT_EQ(heft({command, "rec.csv", "--json", file}).exitCode, 0);
    result = readJson(file);
    result["remark"] = "weighed: 0.81 kg";
    write(file, result.dump(2));
    EXPECT_TRUE(failedWithOneSentence(heft({command, "rec.csv", "--json", file}), "--force")) << file;
    EXPECT_EQ(readJson(file), result);
  }
  EXPECT_EQ(heft({"estimate", "rec.csv", "--json", "notes.json", "--force"}).exitCode, 0);
}

TEST_F(RoundTripTest, SimulateSummaryAsJson) {
  const Outcome run =
      heft({"simulate", "--motion", "free", "--duration", "3", "--rate", "100", "-o", "r.csv", "--json", "-"});
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const json summary = json::parse(run.out);
  EXPECT_EQ(summary["schema"], "heft.simulate/1");
  EXPECT_NEAR(summary["recording"]["duration_s"].get<double>(), 3.0, 0.02);
  EXPECT_NEAR(summary["recording"]["samples"].get<double>(), 300, 2);
}

TEST_F(RoundTripTest, HiddenEffectsAreNamedInTheTruthFileOnly) {
  const std::vector<std::string> usual{"--motion", "free", "--duration", "4", "--rate", "200", "--seed", "3"};
  std::vector<std::string> odd = usual;
  odd.insert(odd.end(), {"--effect", "cable_pull/slack=8", "--effect=time_offset=-12"});
  simulate("plain", usual);
  simulate("odd", odd);
  odd.insert(odd.end(), {"-o", "again.csv", "--json", "-"});
  odd.insert(odd.begin(), "simulate");
  const Outcome run = heft(odd);
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_EQ(read("again.csv"), read("odd.csv"));
  EXPECT_NE(read("plain.csv"), read("odd.csv"));
  const auto setup = [&](const char* file) {  // But for the checksum of the CSV
    std::string text = read(file);
    return text.erase(text.rfind(", CSV "), 22);
  };
  EXPECT_EQ(setup("plain.meta.json"), setup("odd.meta.json"));
  for (const std::string& text : {run.out, run.err, read("odd.csv"), read("odd.meta.json")}) {
    EXPECT_THAT(text, testing::Not(testing::HasSubstr("cable")));
    EXPECT_THAT(text, testing::Not(testing::HasSubstr("effect")));
  }
  const json effects = readJson("odd.truth.json")["effects"];
  ASSERT_EQ(effects.size(), 2u);
  EXPECT_EQ(effects[0]["effect"], "cable_pull");
  EXPECT_EQ(effects[0]["form"], "slack");
  EXPECT_EQ(effects[1]["effect"], "time_offset");
  EXPECT_EQ(effects[1]["size"], -12.0);
  EXPECT_EQ(readJson("plain.truth.json")["effects"], json::array());
  const Outcome list = heft({"simulate", "--list-effects"});
  EXPECT_EQ(list.exitCode, 0);
  EXPECT_THAT(list.out, testing::HasSubstr("  loose_mass        g, for instance"));
}

TEST_F(RoundTripTest, AZeroOfAMillionNewtonsIsNoNoise) {
  simulate("rec", {"--duration", "8", "--rate", "500", "--motion", "free", "--seed", "3"});
  std::istringstream rows(read("rec.csv"));
  std::string line, far;
  std::getline(rows, line);
  const auto header = line;
  const auto column =
      std::count(header.begin(), header.begin() + static_cast<std::ptrdiff_t>(header.find(",fx") + 1), ',');
  far = header + "\n";
  while (std::getline(rows, line)) {
    std::istringstream cells(line);
    std::string cell;
    for (std::ptrdiff_t c = 0; std::getline(cells, cell, ','); ++c)
      far += (c > 0 ? "," : "") + (c >= column && c < column + 3 ? fmt::format("{:.9f}", std::stod(cell) + 1e6) : cell);
    far += "\n";
  }
  write("far.csv", far);
  write("far.meta.json", read("rec.meta.json"));
  for (const std::string name : {"rec", "far"})
    ASSERT_EQ(heft({"diagnose", name + ".csv", "--json", name + ".json"}).exitCode, 0);
  const auto near = readJson("rec.json"), moved = readJson("far.json");
  EXPECT_NEAR(moved["baseline"]["noise_force_rms_n"].get<double>(), near["baseline"]["noise_force_rms_n"].get<double>(),
              0.02);
  EXPECT_EQ(moved["verdict"], near["verdict"]);
}

}  // namespace
}  // namespace heft::test
