// Foxglove WebSocket and rosbridge.
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <random>

#include "core/live/sources.h"
#include "tests/core/live/collected.h"

namespace heft {
namespace {

using namespace testing_support;

template <class T>
std::string little(T value) {
  std::string out(sizeof(T), '\0');
  std::memcpy(out.data(), &value, sizeof(T));
  return out;
}

/// CDR of a WrenchStamped whose six numbers are first, first + 1, ...
std::string cdrWrench(std::int32_t seconds, std::uint32_t nanoseconds, double first) {
  std::string body = little(seconds) + little(nanoseconds) + little<std::uint32_t>(3) + std::string("ft\0", 3);
  body.resize(16);
  for (int a = 0; a < 6; ++a) body += little(first + a);
  return std::string("\0\1\0\0", 4) + body;
}

std::string dataMessage(std::uint32_t subscription, const std::string& payload) {
  return std::string(1, '\1') + little(subscription) + little<std::uint64_t>(12345) + payload;
}

const char* const kAdvertise =
    R"({"op":"advertise","channels":[)"
    R"({"id":10,"topic":"/ft","encoding":"cdr","schemaName":"geometry_msgs/msg/WrenchStamped","schema":"","schemaEncoding":"ros2msg"},)"
    R"({"id":11,"topic":"/js","encoding":"json","schemaName":"sensor_msgs/msg/JointState","schema":"{}","schemaEncoding":"jsonschema"},)"
    R"({"id":12,"topic":"/camera","encoding":"cdr","schemaName":"sensor_msgs/msg/Image","schema":"","schemaEncoding":"ros2msg"}]})";

void advertiseAll(FakeBridge& self) {
  self.sendText(R"({"op":"serverInfo","name":"x","capabilities":[]})");
  self.sendText(kAdvertise);
}

TEST(Foxglove, SubscribesReadsAndComesBack) {
  FakeBridge bridge("foxglove.sdk.v1", advertiseAll, {});
  Collected collected;
  const auto source = makeFoxgloveSource("127.0.0.1", bridge.port());
  ASSERT_TRUE(source->start(collected.sink()).ok());
  ASSERT_TRUE(eventually([&] { return !bridge.texts().empty(); }));
  EXPECT_THAT(bridge.offered(), ::testing::HasSubstr("foxglove.websocket.v1"));
  EXPECT_EQ(bridge.texts()[0],
            R"({"op":"subscribe","subscriptions":[{"channelId":10,"id":1},{"channelId":11,"id":2}]})");
  for (int k = 0; k < 20; ++k) {
    bridge.sendBinary(dataMessage(1, cdrWrench(5, 1000000 * (k + 1), k)));
    bridge.sendBinary(dataMessage(
        2, fmt::format(R"({{"header":{{"stamp":{{"sec":5,"nanosec":{}}}}},"name":["j1","j2","j3","j4","j5","j6","j7"],)"
                       R"("position":[1,2,3,4,5,6,{}],"velocity":[],"effort":[]}})",
                       1000000 * (k + 1) + 500000, k)));
  }
  bridge.sendBinary(dataMessage(1, cdrWrench(5, 3000000, 0.0)));          // late
  bridge.sendBinary(dataMessage(1, cdrWrench(6, 0, 0.0).substr(0, 30)));  // cut off
  bridge.sendBinary(dataMessage(9, cdrWrench(6, 0, 0.0)));                // never subscribed to
  bridge.sendText("{broken");
  ASSERT_TRUE(eventually([&] { return source->status().malformed == 3; }));
  ASSERT_TRUE(collected.reach(30));  // ten teach the clock
  EXPECT_EQ(source->status().reordered, 1u);
  EXPECT_THAT(source->status().topics, ::testing::ElementsAre("/ft", "/js"));
  int wrenches = 0;
  for (const auto& sample : collected.samples()) {
    if (sample.wrench) {
      ++wrenches;
      EXPECT_EQ((*sample.wrench)(5) - (*sample.wrench)(0), 5.0);
    } else {
      ASSERT_TRUE(sample.q);
      EXPECT_EQ((*sample.q)[0], 1.0);
    }
  }
  EXPECT_EQ(wrenches, 15);

  bridge.drop();
  ASSERT_TRUE(eventually([&] { return bridge.connections() == 2 && bridge.texts().size() == 2; }));
  EXPECT_EQ(source->status().disconnects, 1u);
  const auto before = collected.samples().size();
  for (int k = 0; k < 15; ++k) bridge.sendBinary(dataMessage(1, cdrWrench(7, 1000000 * (k + 1), k)));
  EXPECT_TRUE(collected.reach(before + 5));
  source->stop();
}

TEST(Foxglove, AFrameThatIsCutIsNoMessageAndTheConnectionComesBack) {
  FakeBridge bridge("foxglove.sdk.v1", advertiseAll, {});
  Collected collected;
  const auto source = makeFoxgloveSource("127.0.0.1", bridge.port());
  ASSERT_TRUE(source->start(collected.sink()).ok());
  std::size_t subscribed = 0;
  int second = 5;
  // Within the header, at its end, within the message, one byte before its end.
  const std::size_t whole = 4 + dataMessage(1, cdrWrench(5, 0, 0.0)).size();
  for (const std::size_t sent : {std::size_t{1}, std::size_t{3}, std::size_t{4}, std::size_t{40}, whole - 1}) {
    ASSERT_TRUE(eventually([&] { return bridge.texts().size() == subscribed + 1; })) << sent;
    ++subscribed;
    const auto before = collected.samples().size();
    for (int k = 0; k < 15; ++k) bridge.sendBinary(dataMessage(1, cdrWrench(second, 1000000 * (k + 1), 10.0)));
    ASSERT_TRUE(collected.reach(before + 5)) << sent;
    bridge.dropInFrame(dataMessage(1, cdrWrench(second, 500000000, -1e3)), sent);
    second += 10;
  }
  ASSERT_TRUE(eventually([&] { return source->status().disconnects == 5; }));
  source->stop();
  for (const auto& sample : collected.samples()) EXPECT_EQ((*sample.wrench)(0), 10.0);
}

const std::vector<std::string> kUr = {"shoulder_pan_joint", "shoulder_lift_joint", "elbow_joint",
                                      "wrist_1_joint",      "wrist_2_joint",       "wrist_3_joint"};

/// JSON of a JointState with those joints; the k-th position is `first` + k.
std::string jointsJson(const std::vector<std::string>& names, double first, int stamp, const std::string& velocities) {
  std::string quoted, positions;
  for (std::size_t k = 0; k < names.size(); ++k) {
    quoted += fmt::format("{}\"{}\"", k > 0 ? "," : "", names[k]);
    positions += fmt::format("{}{}", k > 0 ? "," : "", first + static_cast<double>(k));
  }
  return fmt::format(
      R"({{"header":{{"stamp":{{"sec":5,"nanosec":{}}}}},"name":[{}],"position":[{}],"velocity":[{}],"effort":[]}})",
      1000000 * (stamp + 1), quoted, positions, velocities);
}

const std::vector<std::string> kUrSorted = {"elbow_joint",   "shoulder_lift_joint", "shoulder_pan_joint",
                                            "wrist_1_joint", "wrist_2_joint",       "wrist_3_joint"};

TEST(Foxglove, JointsAreFoundByTheRobotsNamesAndPublishersToldApart) {
  FakeBridge bridge("foxglove.sdk.v1", [](FakeBridge& self) { self.sendText(kAdvertise); }, {});
  Collected collected;
  const auto source = makeFoxgloveSource("127.0.0.1", bridge.port(), kUr);
  ASSERT_TRUE(source->start(collected.sink()).ok());
  ASSERT_TRUE(eventually([&] { return !bridge.texts().empty(); }));
  for (int k = 0; k < 40; ++k) {
    if (k % 2 == 0) bridge.sendBinary(dataMessage(2, jointsJson({"left_finger", "right_finger"}, 70.0, k, "")));
    if (k % 2 == 1) bridge.sendBinary(dataMessage(2, jointsJson(kUrSorted, 10.0, k, "NaN,NaN,NaN,NaN,NaN,NaN")));
  }
  ASSERT_TRUE(collected.reach(10));
  for (const auto& sample : collected.samples()) {
    ASSERT_TRUE(sample.q);
    EXPECT_EQ(sample.joints, 6);
    EXPECT_EQ((*sample.q)[0], 12.0);  // shoulder_pan_joint, which stands third
    EXPECT_EQ((*sample.q)[2], 10.0);
    EXPECT_EQ((*sample.q)[5], 15.0);
    EXPECT_FALSE(sample.dq);
  }
  EXPECT_EQ(source->status().malformed, 0u);
  EXPECT_THAT(source->status().notes, ::testing::UnorderedElementsAre(::testing::HasSubstr("several publishers"),
                                                                      ::testing::HasSubstr("velocities of /js")));
}

TEST(Foxglove, SchemasAreTakenForWhatTheirEncodingSays) {
  FakeBridge bridge(
      "foxglove.sdk.v1",
      [](FakeBridge& self) {
        self.sendText(
            R"({"op":"advertise","channels":[)"
            R"({"id":10,"topic":"/ft","encoding":"cdr","schemaName":"geometry_msgs/msg/WrenchStamped","schema":"module geometry_msgs {","schemaEncoding":"ros2idl"},)"
            R"({"id":11,"topic":"/js","encoding":"protobuf","schemaName":"my.JointState","schema":"AA==","schemaEncoding":"protobuf"},)"
            R"({"id":12,"topic":"/franka","encoding":"cdr","schemaName":"franka_msgs/msg/FrankaState","schema":"struct","schemaEncoding":"omgidl"}]})");
      },
      {});
  Collected collected;
  const auto source = makeFoxgloveSource("127.0.0.1", bridge.port());
  ASSERT_TRUE(source->start(collected.sink()).ok());
  ASSERT_TRUE(eventually([&] { return !bridge.texts().empty(); }));
  EXPECT_EQ(bridge.texts()[0], R"({"op":"subscribe","subscriptions":[{"channelId":10,"id":1}]})");
  for (int k = 0; k < 20; ++k) bridge.sendBinary(dataMessage(1, cdrWrench(5, 1000000 * (k + 1), k)));
  ASSERT_TRUE(collected.reach(5));
  EXPECT_EQ(source->status().malformed, 0u);
  EXPECT_THAT(source->status().notes,
              ::testing::UnorderedElementsAre(::testing::HasSubstr("/js comes as protobuf"),
                                              ::testing::HasSubstr("/franka describes its messages as omgidl")));
}

TEST(Foxglove, AFrankaTellsWhatItWasToldThatItCarries) {
  FakeBridge bridge(
      "foxglove.sdk.v1",
      [](FakeBridge& self) {
        self.sendText(R"({"op":"advertise","channels":[{"id":10,"topic":"/franka","encoding":"json",)"
                      R"("schemaName":"franka_msgs/FrankaState","schema":"{}","schemaEncoding":"jsonschema"}]})");
      },
      {});
  Collected collected;
  const auto source = makeFoxgloveSource("127.0.0.1", bridge.port());
  ASSERT_TRUE(source->start(collected.sink()).ok());
  ASSERT_TRUE(eventually([&] { return !bridge.texts().empty(); }));
  bridge.sendBinary(
      dataMessage(1, R"({"q":[1,2,3,4,5,6,7],"m_ee":0.73,"F_x_Cee":[0,0,0.03],"m_load":0.0,"F_x_Cload":[0,0,0]})"));
  ASSERT_TRUE(eventually([&] { return source->status().configured.has_value(); }));
  EXPECT_EQ(*source->status().configured->payload.mass, 0.73);
  EXPECT_EQ(source->status().configured->payload.com->z(), 0.03);
}

/// JSON of a TFMessage: the tool's turn about z by `angle`, a camera that stands, and one without a child frame, in an
/// order that changes with k.
std::string transformsJson(double angle, int k) {
  const auto one = [&](const std::string& child, double z, double w, double height) {
    return fmt::format(
        R"({{"header":{{"frame_id":"base"}},"child_frame_id":"{}","transform":{{"translation":{{"x":0.1,)"
        R"("y":0.2,"z":{}}},"rotation":{{"x":0,"y":0,"z":{},"w":{}}}}}}})",
        child, height, z, w);
  };
  const auto tool = one("wrist_tool", std::sin(0.5 * angle), std::cos(0.5 * angle), 0.7);
  const auto camera = one("camera_link", 0.0, 1.0, 0.9), nameless = one("", 1.0, 0.0, 0.8);
  return k % 3 == 0   ? fmt::format(R"({{"transforms":[{},{},{}]}})", camera, tool, nameless)
         : k % 3 == 1 ? fmt::format(R"({{"transforms":[{},{}]}})", nameless, tool)
                      : fmt::format(R"({{"transforms":[{}]}})", tool);
}

/// Once the tool's frame is known, nothing of the others.
void expectTheTool(const Collected& collected) {
  const auto samples = collected.samples();
  ASSERT_GT(samples.size(), 10u);
  for (std::size_t k = 3; k < samples.size(); ++k) {
    ASSERT_TRUE(samples[k].orientation && samples[k].position) << k;
    EXPECT_EQ(samples[k].position->z(), 0.7) << k;
    EXPECT_GT(samples[k].orientation->z(), 0.0) << k;
  }
}

const char* const kTransforms =
    R"({"op":"advertise","channels":[)"
    R"({"id":3,"topic":"/tf","encoding":"json","schemaName":"tf2_msgs/msg/TFMessage","schema":"{}","schemaEncoding":"jsonschema"}]})";

TEST(Foxglove, TransformsGiveThePoseWhereThereAreNoJoints) {
  FakeBridge bridge("foxglove.sdk.v1", [](FakeBridge& self) { self.sendText(kTransforms); }, {});
  Collected collected;
  const auto source = makeFoxgloveSource("127.0.0.1", bridge.port());
  ASSERT_TRUE(source->start(collected.sink()).ok());
  ASSERT_TRUE(eventually([&] { return !bridge.texts().empty(); }));
  for (int k = 0; k < 30; ++k)
    bridge.sendBinary(std::string(1, '\1') + little<std::uint32_t>(1) +
                      little<std::uint64_t>(1000000000u + 10000000u * static_cast<unsigned>(k)) +
                      transformsJson(0.5 + 0.01 * k, k));
  ASSERT_TRUE(collected.reach(12));
  expectTheTool(collected);
  EXPECT_EQ(source->status().malformed, 0u);
  EXPECT_THAT(source->status().notes, ::testing::Contains(::testing::HasSubstr("wrist_tool is taken")));
}

TEST(Foxglove, TransformsAreNotAskedForBesideJoints) {
  FakeBridge bridge(
      "foxglove.sdk.v1",
      [](FakeBridge& self) {
        self.sendText(
            R"({"op":"advertise","channels":[)"
            R"({"id":3,"topic":"/tf","encoding":"json","schemaName":"tf2_msgs/msg/TFMessage","schema":"{}","schemaEncoding":"jsonschema"},)"
            R"({"id":4,"topic":"/js","encoding":"json","schemaName":"sensor_msgs/msg/JointState","schema":"{}","schemaEncoding":"jsonschema"}]})");
      },
      {});
  Collected collected;
  const auto source = makeFoxgloveSource("127.0.0.1", bridge.port());
  ASSERT_TRUE(source->start(collected.sink()).ok());
  ASSERT_TRUE(eventually([&] { return !bridge.texts().empty(); }));
  EXPECT_EQ(bridge.texts()[0], R"({"op":"subscribe","subscriptions":[{"channelId":4,"id":1}]})");
}

/// CDR of an Imu whose rates are 1, 2, 3 and whose accelerations `first`, first + 1, first + 2; its orientation is
/// none.
std::string cdrImu(std::int32_t seconds, std::uint32_t nanoseconds, double first) {
  std::string body = little(seconds) + little(nanoseconds) + little<std::uint32_t>(4) + std::string("imu\0", 4);
  for (int i = 0; i < 4; ++i) body += little(0.0);
  for (int i = 0; i < 9; ++i) body += little(-1.0);
  for (int i = 0; i < 3; ++i) body += little(1.0 + i);
  for (int i = 0; i < 9; ++i) body += little(0.0);
  for (int i = 0; i < 3; ++i) body += little(first + i);
  for (int i = 0; i < 9; ++i) body += little(0.0);
  return std::string("\0\1\0\0", 4) + body;
}

TEST(Foxglove, AnInertialSensorIsRead) {
  FakeBridge bridge("foxglove.sdk.v1",
                    [](FakeBridge& self) {
                      self.sendText(R"({"op":"advertise","channels":[{"id":3,"topic":"/tool/imu","encoding":"cdr",)"
                                    R"("schemaName":"sensor_msgs/msg/Imu","schema":"","schemaEncoding":"ros2msg"}]})");
                    },
                    {});
  Collected collected;
  const auto source = makeFoxgloveSource("127.0.0.1", bridge.port());
  ASSERT_TRUE(source->start(collected.sink()).ok());
  ASSERT_TRUE(eventually([&] { return !bridge.texts().empty(); }));
  for (int k = 0; k < 20; ++k) bridge.sendBinary(dataMessage(1, cdrImu(5, 1000000 * (k + 1), 7.0)));
  ASSERT_TRUE(collected.reach(8));
  for (const auto& sample : collected.samples()) {
    EXPECT_FALSE(sample.hasMotion());
    ASSERT_TRUE(sample.accelerometer && sample.gyroscope);
    EXPECT_EQ(*sample.accelerometer, Vector3d(7.0, 8.0, 9.0));
    EXPECT_EQ(*sample.gyroscope, Vector3d(1.0, 2.0, 3.0));
  }
}

TEST(Foxglove, SurvivesDamagedMessages) {
  FakeBridge bridge("foxglove.websocket.v1", [](FakeBridge& self) { self.sendText(kAdvertise); }, {});
  Collected collected;
  const auto source = makeFoxgloveSource("127.0.0.1", bridge.port());
  ASSERT_TRUE(source->start(collected.sink()).ok());
  ASSERT_TRUE(eventually([&] { return !bridge.texts().empty(); }));
  std::mt19937 random(8);
  for (int round = 0; round < 300; ++round) {
    const bool text = random() % 3 == 0;
    std::string bytes =
        text ? kAdvertise : dataMessage(1 + random() % 2, cdrWrench(1, static_cast<std::uint32_t>(round), 1.0));
    for (unsigned i = 0; i < 1 + random() % 4; ++i) bytes[random() % bytes.size()] = static_cast<char>(random() % 127);
    if (random() % 4 == 0) bytes.resize(random() % bytes.size());
    if (text)
      bridge.sendText(bytes);
    else
      bridge.sendBinary(bytes);
  }
  const auto before = collected.samples().size();
  for (int k = 0; k < 40; ++k) bridge.sendBinary(dataMessage(1, cdrWrench(2000000, 1000000 * (k + 1), k)));
  EXPECT_TRUE(collected.reach(before + 10));
}

TEST(Rosbridge, AsksForTopicsAndReadsThem) {
  FakeBridge bridge("", {}, [](FakeBridge& self, const std::string& text) {
    if (text.find("/rosapi/topics") == std::string::npos) return;
    self.sendText(
        R"({"op":"service_response","service":"/rosapi/topics","result":true,"values":{"topics":["/rosout","/ft","/joint_states"],)"
        R"("types":["rosgraph_msgs/Log","geometry_msgs/WrenchStamped","sensor_msgs/JointState"]}})");
  });
  Collected collected;
  const auto source = makeRosbridgeSource("127.0.0.1", bridge.port(), {});
  ASSERT_TRUE(source->start(collected.sink()).ok());
  ASSERT_TRUE(eventually([&] { return bridge.texts().size() == 3; }));
  EXPECT_THAT(bridge.texts()[1], ::testing::HasSubstr(R"("topic":"/ft")"));
  for (int k = 0; k < 20; ++k)
    bridge.sendText(fmt::format(
        R"({{"op":"publish","topic":"/ft","msg":{{"header":{{"stamp":{{"secs":9,"nsecs":{}}},"frame_id":"x"}},"wrench":)"
        R"({{"force":{{"x":1,"y":2,"z":{}}},"torque":{{"x":4,"y":5,"z":6}}}}}}}})",
        1000 * (k + 1), k));
  bridge.sendText(R"({"op":"publish","topic":"/other","msg":{}})");
  bridge.sendText(R"(["no object"])");
  ASSERT_TRUE(collected.reach(10));
  ASSERT_TRUE(eventually([&] { return source->status().malformed == 2; }));
  EXPECT_EQ((*collected.samples()[9].wrench)(2), 19.0);
}

TEST(Rosbridge, NaNAndOtherOrdersOfNamesAreRead) {
  FakeBridge bridge("", {}, {});
  Collected collected;
  const auto source = makeRosbridgeSource("127.0.0.1", bridge.port(), {"/ft", "/joint_states"}, kUr);
  ASSERT_TRUE(source->start(collected.sink()).ok());
  ASSERT_TRUE(eventually([&] { return bridge.texts().size() == 2; }));
  for (int k = 0; k < 20; ++k)
    bridge.sendText(R"({"op":"publish","topic":"/joint_states","msg":)" +
                    jointsJson(kUrSorted, 10.0, k, "NaN,NaN,NaN,NaN,NaN,-Infinity") + "}");
  ASSERT_TRUE(collected.reach(8));
  EXPECT_EQ(source->status().malformed, 0u);
  EXPECT_EQ((*collected.samples()[0].q)[0], 12.0);
  EXPECT_FALSE(collected.samples()[0].dq);
}

TEST(Rosbridge, TransformsAndAnInertialSensorAreRead) {
  FakeBridge bridge("", {}, [](FakeBridge& self, const std::string& text) {
    if (text.find("/rosapi/topics") == std::string::npos) return;
    self.sendText(
        R"({"op":"service_response","service":"/rosapi/topics","result":true,"values":{"topics":["/tf","/hand/imu"],)"
        R"("types":["tf2_msgs/TFMessage","sensor_msgs/Imu"]}})");
  });
  Collected collected;
  const auto source = makeRosbridgeSource("127.0.0.1", bridge.port(), {});
  ASSERT_TRUE(source->start(collected.sink()).ok());
  ASSERT_TRUE(eventually([&] { return bridge.texts().size() == 3; }));
  for (int k = 0; k < 30; ++k)
    bridge.sendText(R"({"op":"publish","topic":"/tf","msg":)" + transformsJson(0.4, k) + "}");
  ASSERT_TRUE(collected.reach(12));
  expectTheTool(collected);
  bridge.sendText(R"({"op":"publish","topic":"/hand/imu","msg":{"orientation":{"x":0,"y":0,"z":0,"w":1},)"
                  R"("angular_velocity":{"x":null,"y":0,"z":0},"linear_acceleration":{"x":1,"y":2,"z":9.5}}})");
  // Some of the transforms may come only now.
  ASSERT_TRUE(eventually([&] { return collected.samples().back().accelerometer.has_value(); }));
  const auto felt = collected.samples().back();
  EXPECT_FALSE(felt.orientation);
  EXPECT_EQ(*felt.accelerometer, Vector3d(1.0, 2.0, 9.5));
  EXPECT_FALSE(felt.gyroscope);  // one of its numbers is none
}

TEST(Rosbridge, SurvivesDamagedMessages) {
  const std::string topics =
      R"({"op":"service_response","service":"/rosapi/topics","result":true,"values":{"topics":["/ft","/joint_states"],)"
      R"("types":["geometry_msgs/WrenchStamped","sensor_msgs/JointState"]}})";
  const auto wrench = [](long secs, int nsecs) {
    return fmt::format(
        R"({{"op":"publish","topic":"/ft","msg":{{"header":{{"stamp":{{"secs":{},"nsecs":{}}},"frame_id":"x"}},)"
        R"("wrench":{{"force":{{"x":1,"y":2,"z":3}},"torque":{{"x":4,"y":5,"z":6}}}}}}}})",
        secs, nsecs);
  };
  const std::string joints =
      R"({"op":"publish","topic":"/joint_states","msg":{"header":{"stamp":{"secs":1,"nsecs":7}},)"
      R"("name":["j1","j2","j3","j4","j5","j6","j7"],"position":[1,2,3,4,5,6,7],"velocity":[],"effort":[]}})";
  FakeBridge bridge("", {}, [&](FakeBridge& self, const std::string& text) {
    if (text.find("/rosapi/topics") != std::string::npos) self.sendText(topics);
  });
  Collected collected;
  const auto source = makeRosbridgeSource("127.0.0.1", bridge.port(), {});
  ASSERT_TRUE(source->start(collected.sink()).ok());
  ASSERT_TRUE(eventually([&] { return bridge.texts().size() == 3; }));
  std::mt19937 random(9);
  for (int round = 0; round < 400; ++round) {
    std::string bytes = random() % 4 == 0 ? topics : random() % 2 == 0 ? joints : wrench(1, round);
    // Often a digit or a bracket for another: still JSON, but not what it should be.
    const std::string other = R"(0123456789-.e[]{}",:tfn)";
    for (unsigned i = 0; i < 1 + random() % 4; ++i)
      bytes[random() % bytes.size()] =
          random() % 2 == 0 ? other[random() % other.size()] : static_cast<char>(random() % 256);
    if (random() % 4 == 0) bytes.resize(random() % bytes.size());
    if (random() % 40 == 0) bytes = std::string(random() % 3000, random() % 2 == 0 ? '[' : '{');
    // WebSocket text must be UTF-8, so other bytes come as binary.
    const bool plain = std::all_of(bytes.begin(), bytes.end(), [](char c) { return c > 0; });
    if (plain)
      bridge.sendText(bytes);
    else
      bridge.sendBinary(bytes);
  }
  const auto before = collected.samples().size();
  for (int k = 0; k < 40; ++k) bridge.sendText(wrench(2000000000, 1000000 * (k + 1)));
  EXPECT_TRUE(collected.reach(before + 10));
  EXPECT_GT(source->status().malformed, 50u);
  EXPECT_EQ(source->status().disconnects, 0u);
  for (const auto& sample : collected.samples()) EXPECT_TRUE(!sample.wrench || sample.wrench->allFinite());
}

TEST(Rosbridge, WhereNothingListensSaysSoAndKeepsTrying) {
  std::uint16_t port = 0;
  {
    const FakeBridge gone("", {}, {});
    port = gone.port();
  }
  Collected collected;
  const auto source = makeRosbridgeSource("127.0.0.1", port, {});
  ASSERT_TRUE(source->start(collected.sink()).ok());
  ASSERT_TRUE(eventually([&] { return !source->status().text.empty(); }));
  EXPECT_EQ(source->status().state, LinkState::connecting);
  source->stop();
  source->stop();
}

}  // namespace
}  // namespace heft
