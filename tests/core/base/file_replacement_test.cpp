// Files are replaced whole or not at all, through links, and keep who may read them.
#include "core/base/file_replacement.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
#include <random>
#include <thread>
#include <vector>

#include "core/base/json_file.h"

namespace heft {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class FileReplaced : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("heft_replaced_" + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }
  std::string read(const fs::path& file) const { return readTextFile(file).ok() ? *readTextFile(file) : "(none)"; }
  std::ptrdiff_t files() const { return std::distance(fs::directory_iterator(folder_), fs::directory_iterator()); }
  static unsigned modeOf(const fs::path& file) {
    struct stat status {};
    return ::stat(file.c_str(), &status) == 0 ? status.st_mode & 07777u : 0;
  }
  fs::path folder_;
};

TEST_F(FileReplaced, LinksStayAndTheirTargetIsWritten) {
  fs::create_directory(folder_ / "store");
  write("store/real.json", "old");
  fs::create_symlink("store/real.json", folder_ / "near.json");
  fs::create_symlink("near.json", folder_ / "far.json");
  ASSERT_TRUE(writeTextFile(folder_ / "far.json", "new"));
  EXPECT_TRUE(fs::is_symlink(folder_ / "far.json") && fs::is_symlink(folder_ / "near.json"));
  EXPECT_EQ(read(folder_ / "store/real.json"), "new");
  fs::create_symlink("store/later.json", folder_ / "dangling.json");
  ASSERT_TRUE(writeTextFile(folder_ / "dangling.json", "made"));
  EXPECT_EQ(read(folder_ / "store/later.json"), "made");
  EXPECT_TRUE(fs::is_symlink(folder_ / "dangling.json"));
  fs::create_symlink("round.json", folder_ / "round.json");
  const auto round = writeTextFile(folder_ / "round.json", "x");
  ASSERT_FALSE(round);
  EXPECT_THAT(round.error().message, HasSubstr("round.json cannot be written"));
}

TEST_F(FileReplaced, KeepsItsMode) {
  const auto file = write("secret.json", "old");
  for (const unsigned mode : {0600u, 0640u, 0664u, 0755u}) {
    ASSERT_EQ(::chmod(file.c_str(), mode), 0);
    ASSERT_TRUE(writeTextFile(file, "new"));
    EXPECT_EQ(modeOf(file), mode);
  }
  const auto before = ::umask(027);
  EXPECT_TRUE(writeTextFile(folder_ / "fresh.json", "x"));
  ::umask(before);
  EXPECT_EQ(modeOf(folder_ / "fresh.json"), 0640u);
}

TEST_F(FileReplaced, AWriteProtectedOneIsLeft) {
  const auto file = write("protected.json", "old");
  ASSERT_EQ(::chmod(file.c_str(), 0444), 0);
  if (::geteuid() == 0) GTEST_SKIP() << "Root may write to every file.";
  EXPECT_THAT(writeTextFile(file, "new").error().message, HasSubstr("protected.json cannot be written"));
  EXPECT_EQ(read(file), "old");
}

TEST_F(FileReplaced, AFullDiskLeavesTheOldOne) {
  const auto file = write("result.json", "old");
  const auto source = write("large.csv", std::string(200000, 'x'));
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = ::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{50000, before.rlim_max};
  ::setrlimit(RLIMIT_FSIZE, &small);
  const auto written = writeTextFile(file, std::string(100000, 'y'));
  const auto copied = copyFile(source, file);
  const auto made = createTextFile(folder_ / "made.json", std::string(100000, 'y'));
  ::setrlimit(RLIMIT_FSIZE, &before);
  ::signal(SIGXFSZ, handler);
  for (const auto* result : {&written, &copied}) {
    ASSERT_FALSE(*result);
    EXPECT_THAT(result->error().message, HasSubstr("result.json cannot be written: "));
  }
  EXPECT_FALSE(made);
  EXPECT_EQ(read(file), "old");
  EXPECT_EQ(files(), 2) << "nothing half written stays";
  ASSERT_TRUE(copyFile(source, file));
  EXPECT_EQ(read(file), std::string(200000, 'x'));
}

TEST_F(FileReplaced, OfManyThatMakeItOneSucceeds) {
  for (int round = 0; round < 20; ++round) {
    const auto file = folder_ / ("round" + std::to_string(round));
    std::atomic<int> winners{0};
    std::string winner;
    {
      std::vector<std::jthread> threads;
      for (int t = 0; t < 6; ++t)
        threads.emplace_back([&, t] {
          if (createTextFile(file, "by " + std::to_string(t)) && winners++ == 0) winner = "by " + std::to_string(t);
        });
    }
    EXPECT_EQ(winners, 1);
    EXPECT_EQ(read(file), winner);
  }
}

TEST_F(FileReplaced, KilledAtAnyMomentItIsTheOldOrTheNewOne) {
  constexpr std::size_t kSize = 3'000'000;
  const auto file = write("session.heft", std::string(kSize, 'a'));
  std::mt19937 random(54);
  std::uniform_int_distribution<int> moment(0, 40000);
  for (int k = 0; k < 50; ++k) {
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0)
      for (char c = 'a';; c = c == 'z' ? 'a' : static_cast<char>(c + 1))
        if (!writeTextFile(file, std::string(kSize, c))) ::_exit(1);
    ::usleep(static_cast<unsigned>(moment(random)));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    const std::string text = read(file);
    ASSERT_EQ(text.size(), kSize);
    ASSERT_EQ(text.find_first_not_of(text[0]), std::string::npos);
  }
}

}  // namespace
}  // namespace heft
