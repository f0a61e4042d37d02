// Messages byte by byte from the specifications.
#include "core/import/message_definition.h"

#include <cstring>

#include "tests/core/import/fixtures.h"

namespace heft {
namespace {

template <class T>
std::string little(T value) {
  std::string out(sizeof(T), '\0');
  std::memcpy(out.data(), &value, sizeof(T));
  return out;
}
std::string text1(const std::string& content) {  // ROS 1
  return little(static_cast<std::uint32_t>(content.size())) + content;
}

double valueOf(const MessageDecoder& decoder, const std::string& name) {
  for (std::size_t i = 0; i < decoder.names().size(); ++i)
    if (decoder.names()[i] == name) return decoder.values()[i];
  ADD_FAILURE() << "no field " << name;
  return 0.0;
}

constexpr const char* kMixed =
    "# a comment\nint8 KIND=3\nHeader header\nbool flag\nuint16[3] small # fixed\nOther[] others\nfloat32 last\n"
    "====================================================================================\n"
    "MSG: std_msgs/Header\nuint32 seq\ntime stamp\nstring frame_id\n"
    "================================================================================\n"
    "MSG: my_msgs/Other\nstring label\nfloat64 value\n";

TEST(Definition, Ros1PacksWithoutGaps) {
  auto decoder = MessageDecoder::make("my_msgs/Mixed", kMixed, MessageEncoding::ros1);
  ASSERT_TRUE(decoder.ok()) << decoder.error().message;
  const std::string bytes = little<std::uint32_t>(9) + little<std::uint32_t>(12) + little<std::uint32_t>(500000000) +
                            text1("base") + little<std::uint8_t>(1) + little<std::uint16_t>(10) +
                            little<std::uint16_t>(20) + little<std::uint16_t>(65535) + little<std::uint32_t>(2) +
                            text1("a") + little(1.5) + text1("") + little(-2.5) + little(0.25f);
  ASSERT_TRUE(decoder->decode(bytes));
  EXPECT_EQ(decoder->stamp(), 12'500'000'000);
  EXPECT_EQ(valueOf(*decoder, "header.seq"), 9.0);
  EXPECT_EQ(valueOf(*decoder, "flag"), 1.0);
  EXPECT_EQ(valueOf(*decoder, "small[2]"), 65535.0);
  EXPECT_EQ(valueOf(*decoder, "others[0].value"), 1.5);
  EXPECT_EQ(valueOf(*decoder, "others[1].value"), -2.5);
  EXPECT_EQ(valueOf(*decoder, "last"), 0.25);
  // Every prefix is too short, and none is read past its end.
  for (std::size_t size = 0; size < bytes.size(); ++size) EXPECT_FALSE(decoder->decode(bytes.substr(0, size))) << size;
}

TEST(Definition, CdrAlignsToTheSizeOfEachValue) {
  const char* const definition =
      "uint8 a\nfloat64 b\nstring<=10 c\nint16 d\nfloat64[<=4] e\nEmpty f\nuint8 g\n"
      "================================================================================\n"
      "MSG: my_msgs/Empty\n";
  auto decoder = MessageDecoder::make("my_msgs/msg/Mixed", definition, MessageEncoding::cdr);
  ASSERT_TRUE(decoder.ok()) << decoder.error().message;
  std::string body = little<std::uint8_t>(7) + std::string(7, '\x55') + little(3.5) + little<std::uint32_t>(3) +
                     std::string("hi\0", 3);                  // 8 + 8 + 4 + 3 = 23
  body += std::string(1, '\x55') + little<std::int16_t>(-4);  // 24, 26
  body += std::string(2, '\x55') + little<std::uint32_t>(1);  // 28, 32
  body += little(8.5);                                        // 40
  body += std::string(1, '\0') + little<std::uint8_t>(200);   // an empty message takes one byte
  for (const char options : {'\0', '\x03'}) {
    ASSERT_TRUE(decoder->decode(std::string("\0\1\0", 3) + options + body));
    EXPECT_EQ(valueOf(*decoder, "a"), 7.0);
    EXPECT_EQ(valueOf(*decoder, "b"), 3.5);
    EXPECT_EQ(valueOf(*decoder, "d"), -4.0);
    EXPECT_EQ(valueOf(*decoder, "e[0]"), 8.5);
    EXPECT_EQ(valueOf(*decoder, "g"), 200.0);
  }
  EXPECT_FALSE(decoder->decode(std::string("\0\2\0\0", 4) + body)) << "parameter lists are another layout";
}

TEST(Definition, LengthsThatCannotBeAreRefused) {
  auto decoder = MessageDecoder::make("my_msgs/List", "float64[] values\n", MessageEncoding::ros1);
  ASSERT_TRUE(decoder.ok());
  EXPECT_FALSE(decoder->decode(little<std::uint32_t>(0xFFFFFFFF) + little(1.0)));
  // Nothing to read, a million times a million: a message must not cost more than its bytes.
  auto nested =
      MessageDecoder::make("my_msgs/A",
                           "B[1000000] b\n================================================================\n"
                           "MSG: my_msgs/B\nC[1000000] c\n"
                           "================================================================\nMSG: my_msgs/C\n",
                           MessageEncoding::ros1);
  ASSERT_TRUE(nested.ok());
  EXPECT_FALSE(nested->decode("abc"));
}

TEST(Definition, SaysWhatItLacks) {
  EXPECT_FALSE(MessageDecoder::make("a/B", "Unknown field\n", MessageEncoding::ros1).ok());
  EXPECT_FALSE(MessageDecoder::make("a/B", "float64[x] field\n", MessageEncoding::ros1).ok());
  EXPECT_FALSE(MessageDecoder::make("a/B", "B inner\n", MessageEncoding::ros1).ok()) << "a type inside itself";
}

TEST(Definition, OtherJointsInALaterMessageChangeTheNames) {
  auto decoder = MessageDecoder::make("sensor_msgs/JointState", builtInDefinition("sensor_msgs/JointState"),
                                      MessageEncoding::ros1);
  ASSERT_TRUE(decoder.ok());
  const auto message = [&](const std::string& a, const std::string& b) {
    // The built-in header is that of ROS 2: two numbers and a text.
    return little<std::int32_t>(1) + little<std::uint32_t>(0) + text1("") + little<std::uint32_t>(2) + text1(a) +
           text1(b) + little<std::uint32_t>(2) + little(1.0) + little(2.0) + little<std::uint32_t>(0) +
           little<std::uint32_t>(0);
  };
  ASSERT_TRUE(decoder->decode(message("j1", "j2")));
  EXPECT_TRUE(decoder->namesChanged());
  EXPECT_EQ(valueOf(*decoder, "position[j2]"), 2.0);
  ASSERT_TRUE(decoder->decode(message("j1", "j2")));
  EXPECT_FALSE(decoder->namesChanged());
  ASSERT_TRUE(decoder->decode(message("j2", "j1")));
  EXPECT_TRUE(decoder->namesChanged());
  EXPECT_EQ(valueOf(*decoder, "position[j2]"), 1.0);
}

TEST(Definition, FrankaRobotStateIsReadToItsJoints) {
  auto decoder = MessageDecoder::make("franka_msgs/msg/FrankaRobotState",
                                      builtInDefinition("franka_msgs/msg/FrankaRobotState"), MessageEncoding::cdr);
  ASSERT_TRUE(decoder.ok()) << decoder.error().message;
  std::string body =
      little<std::int32_t>(5) + little<std::uint32_t>(6) + little<std::uint32_t>(1) + std::string(1, '\0');
  body.resize(16);
  for (int i = 0; i < 26; ++i) body += little(static_cast<double>(i));  // collision indicators
  body += little<std::int32_t>(5) + little<std::uint32_t>(6) + little<std::uint32_t>(1) + std::string(1, '\0');
  body.resize((body.size() + 3) / 4 * 4);
  body += little<std::uint32_t>(1) + little<std::uint32_t>(11) + std::string("fr3_joint1\0", 11);
  body.resize((body.size() + 3) / 4 * 4);
  body += little<std::uint32_t>(1);
  body.resize((body.size() + 7) / 8 * 8);
  body += little(0.75) + little<std::uint32_t>(0) + little<std::uint32_t>(0) + "whatever follows in this version";
  ASSERT_TRUE(decoder->decode(std::string("\0\1\0\0", 4) + body));
  EXPECT_EQ(decoder->stamp(), 5'000'000'006);
  EXPECT_EQ(valueOf(*decoder, "measured_joint_state.position[fr3_joint1]"), 0.75);
}

}  // namespace
}  // namespace heft
