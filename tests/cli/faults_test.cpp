// What Heft promises when disk, terminal, network or another program fail (docs: What Heft promises).
#include <fcntl.h>
#include <gmock/gmock.h>
#include <pty.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>
#include <functional>
#include <random>
#include <thread>

#include "tests/cli/process.h"

namespace heft::test {
namespace {

using testing::HasSubstr;
using FaultsTest = CliTest;
using std::chrono::milliseconds;

bool within(milliseconds longest, const std::function<bool()>& done) {
  const auto end = std::chrono::steady_clock::now() + longest;
  while (std::chrono::steady_clock::now() < end) {
    if (done()) return true;
    std::this_thread::sleep_for(milliseconds(5));
  }
  return done();
}

/// Rows after the header; -1 if the last line is cut off.
std::ptrdiff_t wholeRows(const std::string& csv) {
  if (csv.empty()) return 0;
  return csv.back() == '\n' ? std::ranges::count(csv, '\n') - 1 : -1;
}

TEST_F(FaultsTest, AFullDiskLeavesTheOldResultAndIsSaid) {
  simulate("rec");
  ASSERT_EQ(heft({"estimate", "rec.csv", "--json", "result.json"}).exitCode, 0);
  const std::string old = read("result.json");
  Running full({"estimate", "rec.csv", "--no-bias", "--json", "result.json"}, path("."), "full", {.fileSize = 1000});
  const Outcome run = full.wait();
  EXPECT_EQ(run.exitCode, 1);
  EXPECT_THAT(run.err, HasSubstr("result.json cannot be written"));
  EXPECT_EQ(read("result.json"), old);
  EXPECT_EQ(heft({"estimate", "rec.csv", "--json", "/dev/full"}).exitCode, 1);
  EXPECT_EQ(heft({"simulate", "--motion", "free", "-o", "no_such_folder/rec.csv"}).exitCode, 1);
}

TEST_F(FaultsTest, LinksAndModesOfResultsStay) {
  simulate("rec");
  write("real.json", "{}");
  ASSERT_EQ(::chmod(path("real.json").c_str(), 0600), 0);
  std::filesystem::create_symlink("real.json", path("link.json"));
  ASSERT_EQ(heft({"estimate", "rec.csv", "--json", "link.json", "--force"}).exitCode, 0);
  EXPECT_TRUE(std::filesystem::is_symlink(path("link.json")));
  EXPECT_EQ(readJson("real.json")["schema"], "heft.estimate/1");
  struct stat status {};
  ASSERT_EQ(::stat(path("real.json").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 07777u, 0600u);
}

TEST_F(FaultsTest, SimulateKeepsAMetaFileThatAPersonChanged) {
  simulate("rec");
  const Outcome again = heft({"simulate", "--motion", "free", "--seed", "9", "--duration", "2", "-o", "rec.csv"});
  EXPECT_EQ(again.exitCode, 0) << "what it made it can make again: " << again.err;
  for (const bool withCsv : {true, false}) {
    auto meta = readJson("rec.meta.json");
    meta["sensor"]["mount"]["xyz_m"] = {0.0, 0.0, 0.0517};
    write("rec.meta.json", meta.dump(1));
    if (!withCsv) std::filesystem::remove(path("rec.csv"));
    const std::string csv = withCsv ? read("rec.csv") : "";
    EXPECT_TRUE(failedWithOneSentence(heft({"simulate", "--motion", "free", "--duration", "2", "-o", "rec.csv"}),
                                      "rec.meta.json already exists and was not overwritten"));
    EXPECT_EQ(read("rec.meta.json"), meta.dump(1));
    EXPECT_EQ(withCsv ? read("rec.csv") : "", csv);
    EXPECT_EQ(heft({"simulate", "--motion", "free", "--duration", "2", "-o", "rec.csv", "--force"}).exitCode, 0);
  }
}

TEST_F(FaultsTest, ALiveStartWithoutSamplesLeavesNothingInTheWay) {
  write("m.json", R"({"robot": "panda"})");
  for (int k = 0; k < 2; ++k) {
    const Outcome run = heft({"live", "udp:19881", "--record", "two.csv", "--meta", "m.json", "--duration", "0.3"});
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_THAT(run.err, HasSubstr("No complete sample arrived"));
    EXPECT_FALSE(exists("two.csv") || exists("two.meta.json"));
  }
  // What a killed program left is empty and nobody's.
  Running killed({"live", "udp:19881", "--record", "two.csv", "--meta", "m.json"}, path("."), "killed");
  ASSERT_TRUE(within(milliseconds(5000), [&] { return exists("two.csv"); }));
  killed.signal(SIGKILL);
  killed.wait();
  ASSERT_TRUE(exists("two.csv"));
  write("m.json", R"({"robot": "panda", "note": "another rig"})");
  const Outcome run = heft({"live", "virtual:3", "--record", "two.csv", "--meta", "m.json", "--duration", "2"});
  EXPECT_EQ(run.exitCode, 0) << run.err;
  EXPECT_GT(wholeRows(read("two.csv")), 100);
}

TEST_F(FaultsTest, OfTwoProgramsOnOneFileTheLoserLeavesTheWinnersMeta) {
  write("m1.json", R"({"robot": "panda", "note": "FIRST"})");
  write("m2.json", R"({"robot": "panda", "note": "SECOND"})");
  for (int k = 0; k < 15; ++k) {
    const auto arguments = [&](const char* seed, const char* meta) {
      return std::vector<std::string>{"live", seed, "--record", "race.csv", "--meta", meta, "--duration", "0.4"};
    };
    Running first(arguments("virtual:1", "m1.json"), path("."), "first");
    Running second(arguments("virtual:2", "m2.json"), path("."), "second");
    const Outcome one = first.wait(), two = second.wait();
    const bool firstLost = one.err.find("exists") != std::string::npos;
    const bool secondLost = two.err.find("exists") != std::string::npos;
    ASSERT_NE(firstLost, secondLost) << one.err << two.err;
    EXPECT_THAT(read("race.meta.json"), HasSubstr(firstLost ? "SECOND" : "FIRST"));
    std::filesystem::remove(path("race.csv"));
    std::filesystem::remove(path("race.meta.json"));
  }
}

TEST_F(FaultsTest, WhenTheRecordingsDiskIsFullTheEstimateGoesOn) {
  Running live({"live", "virtual:5", "--record", "full.csv", "--json", "-", "--duration", "4"}, path("."), "live",
               {.fileSize = 200'000});
  const Outcome run = live.wait();
  EXPECT_EQ(run.exitCode, 1);
  EXPECT_THAT(run.err, HasSubstr("full.csv can no longer be written"));
  EXPECT_THAT(run.err, HasSubstr("The estimate goes on."));
  const auto result = nlohmann::json::parse(run.out);
  EXPECT_GT(result["recording"]["samples"].get<int>(), 2500) << "samples that came after the disk was full, too";
  EXPECT_GT(std::ranges::count(read("full.csv"), '\n'), 100);
}

TEST_F(FaultsTest, AClosedTerminalEndsWithWhatCameEstimated) {
  int terminal = -1, program = -1;
  if (::openpty(&terminal, &program, nullptr, nullptr, nullptr) != 0)
    GTEST_SKIP() << "No terminal can be made here: " << std::strerror(errno);
  ::fcntl(terminal, F_SETFD, FD_CLOEXEC);
  Running live({"live", "virtual:5", "--record", "kept.csv", "--json", "kept.json"}, path("."), "live",
               {.terminal = program});
  ::close(program);
  ASSERT_TRUE(within(milliseconds(20000), [&] { return exists("kept.csv") && wholeRows(read("kept.csv")) > 1500; }));
  ::close(terminal);  // The kernel sends SIGHUP, and nothing can be printed any more.
  ASSERT_TRUE(within(milliseconds(20000), [&] { return exists("kept.json"); }));
  live.wait();
  const auto result = readJson("kept.json");
  EXPECT_GT(result["recording"]["samples"].get<int>(), 1500);
  EXPECT_EQ(result["live"]["recorded"].get<std::ptrdiff_t>(), wholeRows(read("kept.csv")));
}

TEST_F(FaultsTest, CtrlCEndsWithWhatCameEstimated) {
  Running live({"live", "virtual:5", "--record", "kept.csv", "--json", "kept.json"}, path("."), "live");
  ASSERT_TRUE(within(milliseconds(20000), [&] { return exists("kept.csv") && wholeRows(read("kept.csv")) > 1500; }));
  live.signal(SIGINT);
  const Outcome run = live.wait();
  EXPECT_EQ(run.exitCode, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("Mass"));
  EXPECT_GT(readJson("kept.json")["recording"]["samples"].get<int>(), 1500);
  EXPECT_EQ(readJson("kept.json")["live"]["recorded"].get<std::ptrdiff_t>(), wholeRows(read("kept.csv")));
}

TEST_F(FaultsTest, AVanishedFolderStillPrintsTheResult) {
  std::filesystem::create_directory(path("gone"));
  Running live({"live", "virtual:5", "--record", "gone/rec.csv", "--json", "gone/result.json", "--duration", "2"},
               path("."), "live");
  ASSERT_TRUE(within(milliseconds(10000), [&] { return exists("gone/rec.csv"); }));
  std::this_thread::sleep_for(milliseconds(600));
  std::filesystem::remove_all(path("gone"));
  const Outcome run = live.wait();
  EXPECT_EQ(run.exitCode, 1);
  EXPECT_THAT(run.err, HasSubstr("rec.csv was deleted while it was being written. The estimate goes on."));
  EXPECT_THAT(run.err, HasSubstr("heft: gone/rec.csv was deleted while it was being written."));
  EXPECT_THAT(run.err, HasSubstr("heft: gone/result.json cannot be written"));
  EXPECT_THAT(run.out, HasSubstr("Mass"));
}

TEST_F(FaultsTest, AReadOnlyPlaceIsSaidAndNothingIsLost) {
  simulate("rec");
  std::filesystem::create_directory(path("fixed"));
  if (::geteuid() == 0) {  // Permissions do not stop root; the kernel's own files do.
    EXPECT_TRUE(failedWithOneSentence(heft({"estimate", "rec.csv", "--json", "/proc/heft.json"}), "cannot be written"));
    return;
  }
  ASSERT_EQ(::chmod(path("fixed").c_str(), 0555), 0);
  EXPECT_TRUE(
      failedWithOneSentence(heft({"estimate", "rec.csv", "--json", "fixed/r.json"}), "r.json cannot be written"));
  EXPECT_EQ(heft({"live", "virtual:1", "--record", "fixed/r.csv", "--duration", "1"}).exitCode, 1);
  ::chmod(path("fixed").c_str(), 0755);
}

TEST_F(FaultsTest, ARecordingKilledAtAnyMomentCanBeRead) {
  std::mt19937 random(5454);
  std::uniform_int_distribution<int> moment(0, 900);
  int readable = 0;
  for (int k = 0; k < 50; ++k) {
    const std::string name = "r" + std::to_string(k);
    Running live({"live", "virtual:" + std::to_string(k), "--record", name + ".csv"}, path("."), name);
    std::this_thread::sleep_for(milliseconds(moment(random)));
    live.signal(SIGKILL);
    live.wait();
    if (!exists(name + ".csv")) continue;  // It was killed before it began.
    const std::string csv = read(name + ".csv");
    EXPECT_GE(wholeRows(csv), 0) << name << " ends in the middle of a row";
    if (wholeRows(csv) < 2) continue;
    ASSERT_TRUE(exists(name + ".meta.json")) << "the setup file is there before the first row";
    EXPECT_EQ(readJson(name + ".meta.json")["robot"], "panda");
    EXPECT_EQ(heft({"convert", name + ".csv", "--list"}).exitCode, 0);
    ++readable;
  }
  EXPECT_GT(readable, 15);
}

TEST_F(FaultsTest, EstimatesKilledAtAnyMomentLeaveAWholeResult) {
  simulate("rec");
  ASSERT_EQ(heft({"estimate", "rec.csv", "--json", "result.json"}).exitCode, 0);
  std::mt19937 random(545454);
  std::uniform_int_distribution<int> moment(0, 120);
  for (int k = 0; k < 50; ++k) {
    Running estimate({"estimate", "rec.csv", k % 2 == 0 ? "--no-bias" : "--method=ls", "--json", "result.json"},
                     path("."), "killed");
    std::this_thread::sleep_for(milliseconds(moment(random)));
    estimate.signal(SIGKILL);
    estimate.wait();
    ASSERT_EQ(readJson("result.json")["schema"], "heft.estimate/1");
  }
}

}  // namespace
}  // namespace heft::test
