// Pictures beside the wrench: the file is read around them.
#include <sqlite3.h>

#include "tests/core/import/fixtures.h"

namespace heft {
namespace {

using namespace testing_support;
using Pictures = InFolder;

constexpr int kPictures = 50;
constexpr std::size_t kSmallestPicture = 1'000'000;  // [bytes] of the first; each is larger than the one before
constexpr std::size_t kPictureHead = 8;              // [bytes] "height" and the number of bytes that follow

template <class T>
std::string rawBytes(T value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

std::string withLength(const std::string& value) { return rawBytes(static_cast<std::uint32_t>(value.size())) + value; }

const std::string kPictureDefinition = "uint32 height\nuint8[] data\n";

/// Of picture `i` all but the zeros that follow; with CDR's own head where the format asks for it.
std::string pictureHead(int i, const std::string& encapsulation = {}) {
  return encapsulation + rawBytes(std::uint32_t{480}) + rawBytes(static_cast<std::uint32_t>(kSmallestPicture + i));
}

/// Bytes that this program has read from files so far.
std::size_t bytesRead() {
  std::ifstream in("/proc/self/io");
  std::string name;
  std::size_t count = 0;
  in >> name >> count;
  return count;
}

/// Reads the formula's recording out of `path`, and next to nothing of the pictures.
void expectReadAround(const std::filesystem::path& path) {
  const auto before = bytesRead();
  const auto contents = inspectRecording(path);
  ASSERT_TRUE(contents.ok()) << contents.error().message;
  const auto camera = std::ranges::find(contents->streams, "/camera", &Stream::name);
  ASSERT_NE(camera, contents->streams.end());
  EXPECT_EQ(camera->samples, std::size_t{kPictures});
  EXPECT_THAT(camera->fields, ::testing::ElementsAre("height"));
  const auto read = openRecording(path);
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_FALSE(hasErrors(read->findings)) << allTexts(read->findings);
  expectFormula(read->recording);
  if (before > 0) {  // Not every system counts
    EXPECT_LT(bytesRead() - before, kPictures * kSmallestPicture / 4);
  }
}

/// `begin`, the pictures as holes after what `head` gives for each, and `end`.
std::filesystem::path withHoles(const std::filesystem::path& path, const std::string& begin,
                                const std::function<std::string(int)>& head, const std::string& end) {
  std::ofstream out(path, std::ios::binary);
  out << begin;
  for (int i = 0; i < kPictures; ++i) {
    out << head(i);
    out.seekp(static_cast<std::streamoff>(kSmallestPicture) + i, std::ios::cur);
  }
  out << end;
  out.close();
  if (end.empty())
    std::filesystem::resize_file(path, std::filesystem::file_size(path) + kSmallestPicture + kPictures - 1);
  return path;
}

TEST_F(Pictures, OfARos1BagArePassedOver) {
  const auto fields = [](std::initializer_list<std::string> each) {
    std::string out;
    for (const auto& field : each) out += withLength(field);
    return out;
  };
  const auto connection =
      withLength(fields({std::string("op=\x07"), "conn=" + rawBytes(std::uint32_t{99}), "topic=/camera"})) +
      withLength(fields({"type=some_msgs/Picture", "message_definition=" + kPictureDefinition}));
  const auto messageHead = [&](int i) {
    const auto time = rawBytes(std::uint32_t{1700000000}) + rawBytes(static_cast<std::uint32_t>(1'000'000 * i));
    return withLength(fields({std::string("op=\x02"), "conn=" + rawBytes(std::uint32_t{99}), "time=" + time})) +
           rawBytes(static_cast<std::uint32_t>(kPictureHead + kSmallestPicture + i)) + pictureHead(i);
  };
  std::uint32_t size = static_cast<std::uint32_t>(connection.size());
  for (int i = 0; i < kPictures; ++i) size += static_cast<std::uint32_t>(messageHead(i).size() + kSmallestPicture + i);
  const auto chunk = withLength(fields({std::string("op=\x05"), "compression=none", "size=" + rawBytes(size)}));
  expectReadAround(withHoles(folder_ / "pictures.bag",
                             read(fixture("ros1_none.bag")) + chunk + rawBytes(size) + connection, messageHead, ""));
}

TEST_F(Pictures, OfAnMcapFileArePassedOver) {
  constexpr std::size_t kEnd = 13 + 29 + 8;  // [bytes] DataEnd, footer and magic of the fixture
  const auto whole = read(fixture("plain.mcap"));
  const auto record = [](char op, const std::string& content, std::uint64_t more = 0) {
    return op + rawBytes(content.size() + more) + content;
  };
  const std::uint16_t id = 99;
  const auto head = record(3, rawBytes(id) + withLength("some_msgs/msg/Picture") + withLength("ros2msg") +
                                  withLength(kPictureDefinition)) +
                    record(4, rawBytes(id) + rawBytes(id) + withLength("/camera") + withLength("cdr") + withLength(""));
  const auto messageHead = [&](int i) {
    const auto time = rawBytes(std::uint64_t{1'700'000'000'000'000'000} + 1'000'000 * static_cast<std::uint64_t>(i));
    return record(5,
                  rawBytes(id) + rawBytes(std::uint32_t{0}) + time + time + pictureHead(i, std::string("\0\1\0\0", 4)),
                  kSmallestPicture + static_cast<std::uint64_t>(i));
  };
  expectReadAround(withHoles(folder_ / "pictures.mcap", whole.substr(0, whole.size() - kEnd) + head, messageHead,
                             whole.substr(whole.size() - kEnd)));
}

TEST_F(Pictures, OfADatabaseArePassedOver) {
  const auto path = folder_ / "pictures.db3";
  std::filesystem::copy_file(fixture("ros2_bag/ros2_bag_0.db3"), path);
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(path.c_str(), &database), SQLITE_OK);
  const auto run = [&](const std::string& statement) {
    ASSERT_EQ(sqlite3_exec(database, statement.c_str(), nullptr, nullptr, nullptr), SQLITE_OK)
        << sqlite3_errmsg(database);
  };
  // A type that Heft does not know would not be looked at anyhow.
  run("CREATE TABLE message_definitions(topic_type TEXT, encoding TEXT, encoded_message_definition TEXT)");
  run("INSERT INTO message_definitions VALUES('some_msgs/msg/Picture','ros2msg','" + kPictureDefinition + "')");
  run("INSERT INTO topics VALUES(99,'/camera','some_msgs/msg/Picture','cdr','')");
  sqlite3_stmt* insert = nullptr;
  ASSERT_EQ(sqlite3_prepare_v2(database, "INSERT INTO messages(topic_id,timestamp,data) VALUES(99,?,?)", -1, &insert,
                               nullptr),
            SQLITE_OK);
  run("BEGIN");
  for (int i = 0; i < kPictures; ++i) {
    const auto data =
        pictureHead(i, std::string("\0\1\0\0", 4)) + std::string(kSmallestPicture + static_cast<std::size_t>(i), '\0');
    sqlite3_reset(insert);
    sqlite3_bind_int64(insert, 1, 1'700'000'000'000'000'000 + 1'000'000 * i);
    sqlite3_bind_blob64(insert, 2, data.data(), data.size(), SQLITE_STATIC);
    ASSERT_EQ(sqlite3_step(insert), SQLITE_DONE);
  }
  sqlite3_finalize(insert);
  run("COMMIT");
  sqlite3_close(database);
  expectReadAround(path);
}

}  // namespace
}  // namespace heft
