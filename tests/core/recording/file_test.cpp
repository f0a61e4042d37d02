// Files as they come: none, empty, binary, huge, strangely named.
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "tests/core/recording/sample.h"

namespace heft {
namespace {

using namespace testing_support;
using testing::AllOf;
using testing::HasSubstr;

class RecordingFile : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / ("heft_recording_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::filesystem::path write(const std::filesystem::path& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }
  static std::string failure(const std::filesystem::path& file) {
    const auto result = readRecording(file);
    return result ? "(was read without failure)" : result.error().message;
  }
  std::filesystem::path folder_;
};

TEST_F(RecordingFile, EmptyOrWithoutRows) {
  EXPECT_THAT(failure(write("a.csv", "")), AllOf(HasSubstr("a.csv: "), HasSubstr("empty")));
  EXPECT_THAT(failure(write("b.csv", "\n\r\n  \n")), HasSubstr("blank lines"));
  EXPECT_THAT(failure(write("c.csv", "\xEF\xBB\xBF")), HasSubstr("blank lines"));
  EXPECT_THAT(failure(write("d.csv", "time,qx,qy,qz,qw,fx,fy,fz,tx,ty,tz\n")),
              AllOf(HasSubstr("d.csv:1: "), HasSubstr("no row")));
  EXPECT_THAT(failure(write("e.csv", "time,qx,qy,qz,qw,fx,fy,fz,tx,ty,tz")), HasSubstr("no row"));
}

TEST_F(RecordingFile, BinaryAndOtherFormats) {
  auto text = goodTable(Form::joints).text();
  text[5000] = '\0';
  EXPECT_THAT(failure(write("nul.csv", text)), AllOf(HasSubstr("nul.csv:"), HasSubstr("byte 5001 is zero")));
  // Recordings that Heft opens whole: the remedy leads there and not to another program.
  const std::string sqlite("SQLite format 3\0xxx", 19);
  for (const std::string& bytes : {std::string("#ROSBAG V2.0\nxxx"), std::string("\x89MCAP0\r\nxxx"), sqlite})
    EXPECT_THAT(failure(write("a.csv", bytes)), AllOf(HasSubstr("not CSV"), HasSubstr("as the recording itself"),
                                                      HasSubstr("heft convert IN OUT.csv")));
  EXPECT_THAT(failure(write("a.csv", "#ROSBAG V2.0\nxxx")), HasSubstr("ROS 1 bag"));
  EXPECT_THAT(failure(write("b.csv", "\x89MCAP0\r\n")), HasSubstr("MCAP"));
  EXPECT_THAT(failure(write("c.csv", std::string("PK\x03\x04\0\0", 6))), HasSubstr("ZIP"));
  EXPECT_THAT(failure(write("d.csv", std::string("\xFF\xFEt\0i\0", 6))), HasSubstr("UTF-16"));
  EXPECT_THAT(failure(write("e.csv", "{\"robot\": \"panda\"}")), HasSubstr("JSON"));
  std::mt19937 random(1);
  std::string noise(10000, '\0');
  for (char& byte : noise) byte = static_cast<char>(1 + random() % 255);
  EXPECT_THAT(failure(write("f.csv", noise)), HasSubstr("f.csv"));
}

TEST_F(RecordingFile, MissingFolderDeviceUnreadable) {
  EXPECT_THAT(failure(folder_ / "no.csv"), AllOf(HasSubstr("no.csv"), HasSubstr("no such file")));
  EXPECT_THAT(failure(folder_ / "no" / "such.csv"), HasSubstr("no such file"));
  EXPECT_THAT(failure(folder_), HasSubstr("folder"));
  EXPECT_THAT(failure("/dev/zero"), HasSubstr("device"));
  EXPECT_THAT(failure(""), HasSubstr("no such file"));
  if (std::filesystem::exists("/proc/self/mem")) {
    EXPECT_THAT(failure("/proc/self/mem"), HasSubstr("cannot be read"));
  }
  const auto secret = write("secret.csv", goodTable(Form::joints).text());
  std::filesystem::permissions(secret, std::filesystem::perms::none);
  if (::geteuid() != 0) {
    EXPECT_THAT(failure(secret), HasSubstr("cannot be opened"));
  }
}

TEST_F(RecordingFile, TenGigabytesAreRefused) {
  const auto file = write("huge.csv", goodTable(Form::joints).text());
  std::error_code ec;
  std::filesystem::resize_file(file, std::uintmax_t{10} << 30, ec);  // sparse: takes no space
  if (ec) GTEST_SKIP() << "No sparse files here: " << ec.message();
  EXPECT_THAT(failure(file),
              AllOf(HasSubstr("huge.csv: "), HasSubstr("10240 MB"), HasSubstr("8192 MB"), HasSubstr("Split")));
}

TEST_F(RecordingFile, SevenGigabytesOfNothingAreNotRead) {
  const auto file = write("zeros.csv", goodTable(Form::joints, 5).text());
  std::error_code ec;
  std::filesystem::resize_file(file, std::uintmax_t{7} << 30, ec);
  if (ec) GTEST_SKIP() << "No sparse files here: " << ec.message();
  EXPECT_THAT(failure(file), AllOf(HasSubstr("zeros.csv:"), HasSubstr("binary or damaged")));
}

TEST_F(RecordingFile, MoreNumbersThanMemoryHoldsAreRefusedAtOnce) {
  std::string text = goodTable(Form::orientation, 1).text();
  text += std::string(100'000'000, '\n');
  EXPECT_THAT(failureOf(text), AllOf(HasSubstr("rec.csv: "), HasSubstr("1000 million numbers"), HasSubstr("Split")));
}

TEST_F(RecordingFile, NamesThatAreNotUtf8) {
  const auto file = write("bad\xFF\xFEname.csv", goodTable(Form::joints).text());
  const auto result = readRecording(file);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_THAT(result->recording.file, HasSubstr("bad\uFFFD\uFFFDname.csv"));
  EXPECT_THAT(failure(folder_ / "missing\xFF.csv"), HasSubstr("missing\uFFFD.csv"));
}

TEST_F(RecordingFile, MetaBesideTheFileIsUsed) {
  write("rec.meta.json", R"({"robot": null, "kind": "poses", "sensor": {"wrench_sign": "payload_on_sensor"}})");
  auto table = goodTable(Form::pose, 30);
  const auto result = readRecording(write("rec.csv", table.text()));
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(result->recording.meta.kind, RecordingKind::poses);
  EXPECT_EQ(result->recording.wrench(3, 0), -table.number(3, "fx"));
  EXPECT_EQ(findCode(result->findings, "no_meta"), nullptr);
}

TEST_F(RecordingFile, MetaCanBeNamed) {
  const auto csv = write("rec.csv", goodTable(Form::pose, 30).text());
  write("rec.meta.json", "not read");
  const auto meta = write("other.json", R"({"gravity_m_s2": [0, 0, -9.82]})");
  const auto result = readRecording(csv, {meta});
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(result->recording.meta.gravity.z(), -9.82);
  const auto missing = readRecording(csv, {folder_ / "none.json"});
  ASSERT_FALSE(missing);
  EXPECT_THAT(missing.error().message, HasSubstr("none.json: there is no such file"));
  EXPECT_THAT(failure(csv), HasSubstr("rec.meta.json:1:")) << "a broken setup file is not passed over";
}

TEST_F(RecordingFile, WithoutMetaDefaultsAreSaid) {
  const auto result = readRecording(write("rec.csv", goodTable(Form::pose, 30).text()));
  ASSERT_TRUE(result);
  ASSERT_NE(findCode(result->findings, "no_meta"), nullptr);
  EXPECT_THAT(findCode(result->findings, "no_meta")->text, HasSubstr("rec.meta.json"));
  EXPECT_EQ(metaFileOf("a/rec.csv"), std::filesystem::path("a/rec.meta.json"));
  EXPECT_EQ(metaFileOf("a/rec.v2.csv"), std::filesystem::path("a/rec.v2.meta.json"));
}

}  // namespace
}  // namespace heft
