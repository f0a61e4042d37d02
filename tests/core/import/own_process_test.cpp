// Readers whose library may crash run in a process of their own: what comes back, and what comes of a crash or a stop.
#include "core/import/own_process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>

#include "core/base/said_again.h"
#include "core/base/say.h"

namespace heft {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

StreamSet twoStreams() {
  StreamSet set;
  set.file = "log.h5";
  set.kind = FileKind::hdf5;
  set.timeCandidates = {"t", "time"};
  set.findings.push_back(
      {Severity::warning, "link_broken", heft::say("The link /{} is broken.", "a\xff"), "", {"log.h5", 3, 7}});
  Stream& force = set.streams.emplace_back();
  force.name = "force\xfe";
  force.type = "geometry_msgs/Wrench";
  force.file = "log.h5";
  force.samples = 3;
  force.first = -5;
  force.last = 7;
  force.fields = {"x", "y"};
  force.clockless = true;
  force.received = {-5, 1, 7};
  force.stamps = {0, 2, 0};
  force.values = {{1.5, -0.0, 1e300}, {}};
  force.sender = {0, 1, 0};
  force.senders = {"/a", "/b"};
  set.streams.emplace_back().name = "empty";
  return set;
}

TEST(OwnProcess, GivesWhatWasReadThere) {
  const pid_t here = ::getpid();
  const auto set = readInOwnProcess("log.h5",
                                    [&](const Progress&) -> Result<StreamSet> {
                                      if (::getpid() == here) return Error{"not in a process of its own"};
                                      return twoStreams();
                                    },
                                    {});
  ASSERT_TRUE(set.ok()) << set.error().message;
  EXPECT_EQ(set->file, "log.h5");
  EXPECT_EQ(set->kind, FileKind::hdf5);
  EXPECT_THAT(set->timeCandidates, ElementsAre("t", "time"));
  ASSERT_EQ(set->findings.size(), 1u);
  EXPECT_EQ(toLine(set->findings[0]), "warning: log.h5:3:7: The link /a\xff is broken.");
  EXPECT_EQ(set->findings[0].code, "link_broken");
  ASSERT_EQ(set->streams.size(), 2u);
  const Stream& force = set->streams[0];
  EXPECT_EQ(force.name, "force\xfe");
  EXPECT_EQ(force.type, "geometry_msgs/Wrench");
  EXPECT_EQ(force.samples, 3u);
  EXPECT_EQ(force.first, -5);
  EXPECT_EQ(force.last, 7);
  EXPECT_TRUE(force.clockless);
  EXPECT_THAT(force.fields, ElementsAre("x", "y"));
  EXPECT_THAT(force.received, ElementsAre(-5, 1, 7));
  EXPECT_THAT(force.stamps, ElementsAre(0, 2, 0));
  EXPECT_THAT(force.values, ElementsAre(ElementsAre(1.5, -0.0, 1e300), ElementsAre()));
  EXPECT_THAT(force.sender, ElementsAre(0, 1, 0));
  EXPECT_THAT(force.senders, ElementsAre("/a", "/b"));
  EXPECT_EQ(set->streams[1].name, "empty");
}

TEST(OwnProcess, ACrashThereIsAnErrorHere) {
  const auto crash = [](const std::function<void()>& how) {
    return readInOwnProcess("log.h5",
                            [&](const Progress&) -> Result<StreamSet> {
                              how();
                              return twoStreams();
                            },
                            {});
  };
  for (const auto& result : {crash([] { ::raise(SIGSEGV); }), crash([] { std::abort(); }),
                             crash([] { throw std::bad_alloc(); }), crash([] { ::_exit(0); })}) {
    ASSERT_FALSE(result.ok());
    EXPECT_THAT(result.error().message, HasSubstr("log.h5: the file is damaged"));
    EXPECT_FALSE(result.error().cancelled);
  }
}

TEST(OwnProcess, AnErrorComesAsItIs) {
  const auto result = readInOwnProcess(
      "log.h5", [](const Progress&) -> Result<StreamSet> { return Error{heft::say("no dataset of this kind.")}; }, {});
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().message, "no dataset of this kind.");
}

TEST(OwnProcess, ProgressComesAndAStopEndsItAtOnce) {
  std::stop_source stop;
  std::vector<std::string> told;
  Progress progress;
  progress.stop = stop.get_token();
  progress.report = [&](double fraction, std::string_view what) {
    told.push_back(std::string(what) + (fraction == 0.25 ? " 25 %" : ""));
    stop.request_stop();
  };
  const auto result = readInOwnProcess(
      "log.h5",
      [](const Progress& own) -> Result<StreamSet> {
        own(0.25, "Reading");
        for (;;) std::this_thread::sleep_for(std::chrono::hours(1));
      },
      progress);
  ASSERT_FALSE(result.ok());
  EXPECT_TRUE(result.error().cancelled);
  EXPECT_THAT(told, ElementsAre("Reading 25 %"));
}

/// Its sentences are remembered here, for a window whose language changes.
TEST(OwnProcess, SaysItsSentencesInTheLanguageOfNow) {
  rememberSentences(100);
  setTranslator(
      [](const char* text) {
        return std::string(text) == "The link /{} is broken." ? "Der Verweis /{} führt ins Leere." : "";
      },
      ',');
  const auto set = readInOwnProcess("log.h5", [](const Progress&) -> Result<StreamSet> { return twoStreams(); }, {});
  setTranslator({});
  ASSERT_TRUE(set.ok());
  const std::string said = set->findings[0].text;
  EXPECT_EQ(said, "Der Verweis /a\xff führt ins Leere.");
  EXPECT_EQ(sayAgain(said), "The link /a\xff is broken.");
  rememberSentences(0);
}

}  // namespace
}  // namespace heft
