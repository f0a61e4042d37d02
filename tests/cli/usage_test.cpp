// Help, version, and what a typing error is answered with.
#include <gmock/gmock.h>

#include "tests/cli/process.h"

namespace heft::test {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

using UsageTest = CliTest;

const std::vector<std::string> kCommands{"estimate", "simulate", "export",   "convert",    "reproduce",
                                         "live",     "segment",  "diagnose", "compensate", "prove",
                                         "passport", "coach",    "excite"};

TEST_F(UsageTest, HelpGoesToStdoutAndEndsWell) {
  for (const auto& flag : {"--help", "-h"}) {
    const Outcome run = heft({flag});
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_THAT(run.err, IsEmpty());
    for (const auto& command : kCommands) EXPECT_THAT(run.out, HasSubstr("  " + command + " "));
  }
}

TEST_F(UsageTest, EveryCommandHasHelpWithExamplesThatNameIt) {
  for (const auto& command : kCommands) {
    const Outcome run = heft({command, "--help"});
    EXPECT_EQ(run.exitCode, 0) << command;
    EXPECT_THAT(run.err, IsEmpty());
    EXPECT_THAT(run.out, HasSubstr("Examples:\n  heft " + command + " "));
    EXPECT_THAT(run.out, HasSubstr("--json")) << command;
  }
}

TEST_F(UsageTest, HelpNamesEveryMethodAndFormat) {
  const std::string estimate = heft({"estimate", "--help"}).out;
  for (const auto& method : {"map", "ls"}) EXPECT_THAT(estimate, HasSubstr(method));
  const std::string formats = heft({"export", "--help"}).out;
  for (const auto& format : {"franka-desk", "libfranka", "urdf", "json"}) EXPECT_THAT(formats, HasSubstr(format));
}

TEST_F(UsageTest, VersionIsTheProjects) {
  const Outcome run = heft({"--version"});
  EXPECT_EQ(run.exitCode, 0);
  EXPECT_TRUE(run.out.starts_with("heft " HEFT_VERSION "\nrevision ")) << run.out;
  EXPECT_THAT(run.err, IsEmpty());
}

TEST_F(UsageTest, NothingAtAllShowsHelpOnStderr) {
  const Outcome run = heft({});
  EXPECT_EQ(run.exitCode, 2);
  EXPECT_THAT(run.out, IsEmpty());
  EXPECT_THAT(run.err, HasSubstr("estimate"));
}

struct Mistake {
  std::vector<std::string> arguments;
  std::string answer;
};

class MistakeTest : public CliTest, public testing::WithParamInterface<Mistake> {};

TEST_P(MistakeTest, EndsWithTwoAndAHint) {
  write("rec.csv", "time,q1\n");
  const Outcome run = heft(GetParam().arguments);
  EXPECT_EQ(run.exitCode, 2) << run.err;
  EXPECT_THAT(run.out, IsEmpty());
  EXPECT_THAT(run.err, StartsWith("heft"));
  EXPECT_THAT(run.err, HasSubstr(GetParam().answer));
  EXPECT_THAT(run.err, EndsWith(" --help'.\n"));
  EXPECT_EQ(read("rec.csv"), "time,q1\n");
}

INSTANTIATE_TEST_SUITE_P(
    All, MistakeTest,
    testing::Values(
        Mistake{{"estimat", "rec.csv"}, "Did you mean 'estimate'?"}, Mistake{{"exprot"}, "Did you mean 'export'?"},
        Mistake{{"weigh"}, "The commands are"}, Mistake{{"estimate"}, "RECORDING is required."},
        Mistake{{"estimate", "rec.csv", "--methd", "ls"}, "Did you mean '--method'?"},
        Mistake{{"estimate", "rec.csv", "--trimm=0.1"}, "Did you mean '--trim'?"},
        Mistake{{"estimate", "rec.csv", "--zzzzzz"}, "no option --zzzzzz"},
        Mistake{{"segment", "rec.csv", "second.csv"}, "one argument too many"},
        Mistake{{"estimate", "rec.csv", "--method", "mpa"}, "Did you mean 'map'?"},
        Mistake{{"estimate", "rec.csv", "--method"}, "--method needs a value."},
        Mistake{{"estimate", "rec.csv", "--parameters", "fulll"}, "Did you mean 'full'?"},
        Mistake{{"estimate", "rec.csv", "--segments", "automatic"}, "auto, marks, all"},
        Mistake{{"estimate", "rec.csv", "--smoothing", "lowpass"}, "Did you mean 'low-pass'?"},
        Mistake{{"estimate", "rec.csv", "--trim", "0.6"}, "between 0 and 0.45"},
        Mistake{{"estimate", "rec.csv", "--trim", "nan"}, "--trim"},
        Mistake{{"estimate", "rec.csv", "--trim", "0,1"}, "--trim expects a number with a decimal point, not '0,1'"},
        Mistake{{"estimate", "rec.csv", "--cutoff", "-1"}, "--cutoff"},
        Mistake{{"estimate", "rec.csv", "--sg-order", "7", "--sg-window", "7"}, "--sg-window"},
        Mistake{{"estimate", "rec.csv", "--shape", "sphere:0.1", "--shape-file", "s.json"}, "exclude each other"},
        Mistake{{"estimate", "rec.csv", "--shape", "cube:0.1"}, "cube"},
        Mistake{{"estimate", "rec.csv", "-o", "-"}, "file name"},
        Mistake{{"estimate", "rec.csv", "-o", "t.json", "--format", "franka-dsk"}, "Did you mean 'franka-desk'?"},
        Mistake{{"simulate", "--motion", "exitation", "-o", "r.csv"}, "Did you mean 'excitation'?"},
        Mistake{{"simulate", "--motion", "free"}, "--output"},
        Mistake{{"simulate", "--motion", "free", "-o", "r.txt"}, ".csv"},
        Mistake{{"simulate", "--motion", "free", "-o", "-"}, "two files"},
        Mistake{{"simulate", "--motion", "free", "-o", "r.csv", "--seed", "-1"}, "--seed"},
        Mistake{{"simulate", "--motion", "free", "-o", "r.csv", "--rate", "inf"}, "--rate"},
        Mistake{{"simulate", "--motion", "free", "-o", "r.csv", "--effect", "cable_pul=3"}, "no effect 'cable_pul'"},
        Mistake{{"simulate", "--motion", "free", "-o", "r.csv", "--effect", "cable_pull"}, "ID=SIZE"},
        Mistake{{"simulate", "--motion", "free", "-o", "r.csv", "--effect", "cable_pull=-1"}, "0 to"},
        Mistake{{"simulate", "--motion", "free", "-o", "r.csv", "--duration", "1e9"}, "--duration"},
        Mistake{{"simulate", "--motion", "free", "-o", "r.csv", "--xyz", "0,0"}, "three numbers"},
        Mistake{{"simulate", "--motion", "free", "-o", "r.csv", "--xyz", "0,0,0,04"}, "three numbers"},
        Mistake{{"export", "rec.csv"}, "--format"},
        Mistake{{"export", "rec.csv", "--format", "urdff"}, "Did you mean 'urdf'?"},
        Mistake{{"export", "rec.csv", "--format", "urdf", "--json", "-"}, "stdout"},
        Mistake{{"export", "rec.csv", "--format", "urdf", "--rpy", "0,0,nan"}, "three numbers"},
        Mistake{{"reproduce", "--format", "markdwn"}, "Did you mean 'markdown'?"},
        Mistake{{"reproduce", "--seed", "-1"}, "--seed"}, Mistake{{"reproduce", "--recordings", "0"}, "--recordings"},
        Mistake{{"convert", "rec.csv"}, "OUT"}, Mistake{{"convert", "rec.csv", "rec.csv"}, "same file"},
        Mistake{{"convert", "rec.csv", "./rec.csv", "--force"}, "same file"},
        Mistake{{"convert", "rec.csv", "out"}, ".csv"}));

TEST_F(UsageTest, NegativeNumbersAreValuesNotOptions) {
  const Outcome run = heft({"simulate", "--motion", "free", "-o", "r.csv", "--duration", "2", "--rate", "100", "--xyz",
                            "-0.01,0,0.05", "--rpy", "-0.1,0,0"});
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const auto mount = readJson("r.meta.json")["sensor"]["mount"];
  EXPECT_EQ(mount["xyz_m"], nlohmann::json({-0.01, 0.0, 0.05}));
  EXPECT_EQ(mount["rpy_rad"], nlohmann::json({-0.1, 0.0, 0.0}));
}

}  // namespace
}  // namespace heft::test
