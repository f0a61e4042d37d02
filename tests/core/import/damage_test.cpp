// Files that are cut off give what they hold; damaged ones end in a sentence, never in a crash.
#include <sys/resource.h>

#include <algorithm>
#include <random>

#include "tests/core/import/fixtures.h"

namespace heft {
namespace {

using namespace testing_support;

class Damage : public InFolder, public ::testing::WithParamInterface<const char*> {};

TEST_P(Damage, CutOffFilesGiveWhatTheyHold) {
  const std::string name = GetParam();
  const auto bytes = read(fixture(name));
  const auto path =
      write(std::filesystem::path(name).filename(), std::string_view(bytes).substr(0, bytes.size() * 6 / 10));
  const auto result = openRecording(path);
  ASSERT_TRUE(result.ok()) << result.error().message;
  EXPECT_TRUE(hasCode(result->findings, "file_cut_off")) << allTexts(result->findings);
  EXPECT_THAT(allTexts(result->findings), testing::Not(testing::HasSubstr(" 1 chunks")));
  EXPECT_GT(result->recording.rows(), 20);
  EXPECT_LT(result->recording.rows(), 80);
  expectFormula(result->recording);
}

using CutOff = InFolder;

TEST_F(CutOff, BeforeAnythingIsCompleteItSaysThat) {
  // The first chunk, and the archive's only block, end after the cut.
  for (const char* const name : {"zstd.mcap", "lz4.mcap", "ros2_compressed.db3.zstd"}) {
    const auto bytes = read(fixture(name));
    const auto result = openRecording(
        write(std::filesystem::path(name).filename(), std::string_view(bytes).substr(0, bytes.size() / 5)));
    ASSERT_FALSE(result.ok()) << name;
    EXPECT_THAT(result.error().message, testing::HasSubstr("damaged")) << name;
    EXPECT_THAT(result.error().message, testing::Not(testing::HasSubstr("not CSV"))) << name;
  }
}

/// The most memory that this program has held so far.
long peakKiB() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

/// MATLAB 4: the library takes as much memory as the second variable's head says that its name is long (1.9 GB).
TEST_F(CutOff, ADamagedHeadTakesNoMemory) {
  const auto head = [](std::uint32_t name) {
    const std::uint32_t numbers[] = {0, 1, 1, 0, name};
    return std::string(reinterpret_cast<const char*>(numbers), sizeof numbers);
  };
  const std::string first = head(5) + std::string("time\0", 5) + std::string(8, '\0');
  const auto whole = write("whole.mat", first + head(3) + std::string("fx\0", 3) + std::string(8, '\0'));
  EXPECT_TRUE(inspectRecording(whole).ok());
  const auto before = peakKiB();
  const auto result = inspectRecording(write("long_name.mat", first + head(0x75640005) + std::string(51, '\0')));
  ASSERT_FALSE(result.ok());
  EXPECT_THAT(result.error().message, testing::HasSubstr("damaged"));
  EXPECT_LT(peakKiB() - before, 100 << 10);
}

TEST_F(CutOff, OfAMatlabFileWhatComesBeforeADamagedVariableIsRead) {
  // A structure whose packed bytes fail their checksum: the library made millions of cells of it.
  const auto streams =
      inspectRecording(std::filesystem::path(HEFT_SOURCE_DIR) / "tests/fuzz/corpus/matlab/checksum_wrong.mat");
  ASSERT_TRUE(streams.ok());
  const auto& findings = streams.value().findings;
  const auto damage = std::ranges::find(findings, "variable_damaged", &Finding::code);
  ASSERT_NE(damage, findings.end());
  EXPECT_THAT(damage->text, testing::HasSubstr("Variable 2 "));
}

/// Cells, a structure's elements, a field's numbers: the library makes as many as the sizes say, whatever there is.
TEST_F(CutOff, AMatlabVariableThatAsksForMoreThanItHasIsNotRead) {
  for (const char* const kind : {"many_cells", "many_elements", "many_numbers"}) {
    for (const char* const end : {".mat", "_packed.mat"}) {
      SCOPED_TRACE(std::string(kind) + end);
      const auto before = peakKiB();
      const auto streams = inspectRecording(std::filesystem::path(HEFT_SOURCE_DIR) / "tests/fuzz/corpus/matlab" /
                                            (std::string(kind) + end));
      ASSERT_TRUE(streams.ok());
      const auto& findings = streams.value().findings;
      const auto damage = std::ranges::find(findings, "variable_damaged", &Finding::code);
      ASSERT_NE(damage, findings.end());
      EXPECT_THAT(damage->text, testing::HasSubstr("Variable 2 "));
      EXPECT_LT(peakKiB() - before, 100 << 10);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Fixtures, Damage,
                         ::testing::Values("ros1_none.bag", "ros1_lz4.bag", "ros1_bz2.bag", "plain.mcap", "zstd.mcap",
                                           "lz4.mcap", "ros2_bag/ros2_bag_0.db3"),
                         [](const auto& each) {
                           std::string out = each.param;
                           for (char& c : out)
                             if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
                           return out;
                         });

using Fuzz = InFolder;

/// Reads it with everything, and checks that what comes out is sound.
bool survives(const std::filesystem::path& path) {
  (void)inspectRecording(path);
  const auto result = openRecording(path);
  if (!result) {
    EXPECT_EQ(result.error().message.find('\n'), std::string::npos) << result.error().message;
    return false;
  }
  const auto& recording = result->recording;
  EXPECT_TRUE(recording.wrench.allFinite() && recording.time.allFinite() && recording.q.allFinite());
  EXPECT_EQ(recording.wrench.rows(), recording.rows());
  for (Eigen::Index k = 1; k < recording.rows(); ++k) EXPECT_GT(recording.time(k), recording.time(k - 1));
  return true;
}

void mutate(std::string& bytes, std::mt19937& random) {
  const auto count = 1 + random() % 4;
  for (unsigned i = 0; i < count && !bytes.empty(); ++i) {
    // Most of the structure stands at the beginning.
    const auto reach = random() % 2 == 0 ? std::min<std::size_t>(bytes.size(), 2000) : bytes.size();
    const auto at = random() % reach;
    const auto length = std::min<std::size_t>(1 + random() % 16, bytes.size() - at);
    switch (random() % 5) {
      case 0:
        bytes[at] = static_cast<char>(random());
        break;
      case 1:
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << random() % 8));
        break;
      case 2:
        for (std::size_t k = at; k < at + length; ++k) bytes[k] = random() % 2 == 0 ? '\xFF' : '\0';
        break;
      case 3:
        bytes.erase(at, length);
        break;
      default:
        if (random() % 4 == 0) bytes.resize(at);
        break;
    }
  }
}

TEST_F(Fuzz, DamagedContainers) {
  std::mt19937 random(5);
  for (const char* const name : {"ros1_none.bag", "ros1_lz4.bag", "ros1_bz2.bag", "plain.mcap", "zstd.mcap",
                                 "ros2_bag/ros2_bag_0.db3", "ros2_compressed.db3.zstd"}) {
    const auto original = read(fixture(name));
    int read = 0;
    for (int round = 0; round < 60; ++round) {
      auto bytes = original;
      mutate(bytes, random);
      read += survives(write("damaged", bytes)) ? 1 : 0;
    }
    EXPECT_GT(read, 1) << name << ": damaged so much that nothing behind the first check is reached";
  }
}

TEST_F(Fuzz, DamagedHdf5) {
  std::mt19937 random(6);
  const auto original = read(fixture("log.h5"));
  int read = 0;
  for (int round = 0; round < 200; ++round) {
    auto bytes = original;
    mutate(bytes, random);
    read += survives(write("damaged.h5", bytes)) ? 1 : 0;
  }
  EXPECT_GT(read, 10);
}

TEST_F(Fuzz, DamagedArrays) {
  std::mt19937 random(8);
  for (const char* const name : {"log.npz", "table.npy", "log.mat"}) {
    const auto original = read(fixture(name));
    int read = 0;
    for (int round = 0; round < 400; ++round) {
      auto bytes = original;
      mutate(bytes, random);
      read += survives(write("damaged", bytes)) ? 1 : 0;
    }
    EXPECT_GT(read, 10) << name;
  }
}

TEST_F(Fuzz, DamagedText) {
  std::mt19937 random(7);
  std::string table =
      "__time,/a/panda_joint1/position,/a/panda_joint2/position,/ft/force/x,/ft/force/y,/ft/force/z,"
      "/ft/torque/x,/ft/torque/y,/ft/torque/z\n";
  std::string lines;
  for (int k = 0; k < 30; ++k) {
    table += std::to_string(0.01 * k) + (k % 2 == 0 ? ",1,2,,,,,,\n" : ",,,1,2,3,4,5,6\n");
    lines += "{\"time\":" + std::to_string(k) + ",\"O_T_EE\":[1,2],\"q\":[1,2,3,4,5,6,7],\"wrench\":[1,2,3,4,5,6]}\n";
  }
  for (int round = 0; round < 600; ++round) {
    auto bytes = round % 2 == 0 ? table : lines;
    mutate(bytes, random);
    survives(write(round % 2 == 0 ? "damaged.csv" : "damaged.jsonl", bytes));
  }
}

}  // namespace
}  // namespace heft
