// Net F/T and JSON over UDP, byte by byte.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>
#include <thread>
#include <vector>

#include "core/live/network.h"
#include "core/live/rdt_protocol.h"
#include "core/live/sources.h"
#include "tests/core/live/collected.h"

namespace heft {
namespace {

using namespace testing_support;

RdtSettings settingsFor(const FakeNetFt& sensor) {
  RdtSettings settings;
  settings.host = "127.0.0.1";
  settings.port = sensor.port();
  settings.countsPerNewton = 1000.0;
  settings.countsPerNewtonMetre = 100000.0;
  return settings;
}

const std::string kStart("\x12\x34\0\x02\0\0\0\0", 8);
const std::string kStop("\x12\x34\0\0\0\0\0\0", 8);

TEST(NetFt, CountsBecomeNewtonsAndLossesAreCounted) {
  FakeNetFt sensor;
  Collected collected;
  const auto source = makeRdtSource(settingsFor(sensor));
  ASSERT_TRUE(source->start(collected.sink()).ok());
  ASSERT_TRUE(eventually([&] { return !sensor.requests().empty(); }));
  EXPECT_EQ(sensor.requests()[0], kStart);
  const std::vector<std::int32_t> counts = {1500, -2500, 0, 100000, -50000, 1};
  // Over the wrap of 32 bits; 2 is lost, 1 comes twice, 0xFFFFFFFF again and 3 come late; one is cut off.
  for (const std::uint32_t number : {0xFFFFFFFEu, 0xFFFFFFFFu, 0u, 1u, 1u, 0xFFFFFFFFu, 4u, 3u, 5u})
    sensor.send(rdtRecord(number, number == 5 ? 0x80010000u : 0u, counts));
  sensor.send(rdtRecord(6, 0, counts).substr(0, 35));
  sensor.send("");
  sensor.send(rdtRecord(7, 0, {7, 7, 7, 7, 7, 7}));
  ASSERT_TRUE(collected.reach(7));
  const auto status = source->status();
  EXPECT_EQ(status.samples, 7u);
  EXPECT_EQ(status.lost, 2u);  // 2, and 6, which came cut off
  EXPECT_EQ(status.reordered, 3u);
  EXPECT_EQ(status.malformed, 2u);
  EXPECT_EQ(status.flagged, 1u);
  EXPECT_EQ(status.state, LinkState::live);
  const auto samples = collected.samples();
  for (std::size_t k = 0; k + 1 < samples.size(); ++k) EXPECT_LT(samples[k].time, samples[k + 1].time);
  EXPECT_FALSE(samples[0].hasMotion());
  EXPECT_NEAR((*samples[0].wrench - (Vector6d() << 1.5, -2.5, 0.0, 1.0, -0.5, 1e-5).finished()).norm(), 0.0, 1e-12);
  source->stop();
  ASSERT_TRUE(eventually([&] { return sensor.requests().back() == kStop; }));
  // Nothing that changes the sensor was ever sent.
  for (const auto& request : sensor.requests()) EXPECT_TRUE(request == kStart || request == kStop);
}

TEST(NetFt, BoxesThatSendSeveralRecordsAPacketAreRead) {
  FakeNetFt sensor;
  Collected collected;
  const auto source = makeRdtSource(settingsFor(sensor));
  ASSERT_TRUE(source->start(collected.sink()).ok());
  ASSERT_TRUE(eventually([&] { return !sensor.requests().empty(); }));
  std::string packet;
  for (std::uint32_t number = 1; number <= 5; ++number) packet += rdtRecord(number, 0, {1000, 0, 0, 0, 0, 0});
  sensor.send(packet);
  sensor.send(packet.substr(0, 170));
  ASSERT_TRUE(collected.reach(5));
  ASSERT_TRUE(eventually([&] { return source->status().malformed == 1; }));
  EXPECT_EQ(source->status().samples, 5u);
  EXPECT_EQ(source->status().lost, 0u);
}

TEST(NetFt, ASilentSensorIsAskedAgain) {
  FakeNetFt sensor;
  Collected collected;
  const auto source = makeRdtSource(settingsFor(sensor));
  ASSERT_TRUE(source->start(collected.sink()).ok());
  ASSERT_TRUE(eventually([&] { return !sensor.requests().empty(); }));
  sensor.send(rdtRecord(50, 0, {1, 1, 1, 1, 1, 1}));
  ASSERT_TRUE(collected.reach(1));
  ASSERT_TRUE(eventually([&] { return sensor.requests().size() >= 2; }));
  EXPECT_EQ(sensor.requests()[1], kStart);
  EXPECT_EQ(source->status().disconnects, 1u);
  EXPECT_FALSE(source->status().text.empty());
  sensor.send(rdtRecord(3, 0, {1, 1, 1, 1, 1, 1}));  // it was switched off and on meanwhile
  ASSERT_TRUE(collected.reach(2));
  EXPECT_EQ(source->status().lost, 0u);
  EXPECT_TRUE(eventually([&] { return source->status().state == LinkState::live; }));
}

TEST(NetFt, StatesItsCountsOverHttp) {
  FakeNetFt sensor;
  const FakeWebPage page(
      "<netft><cfgcpf>2000</cfgcpf><cfgcpt>500</cfgcpt><scfgfu>N</scfgfu><scfgtu>N-m</scfgtu></netft>");
  Collected collected;
  auto settings = settingsFor(sensor);
  settings.countsPerNewton = settings.countsPerNewtonMetre = 0.0;
  settings.httpPort = page.port();
  const auto source = makeRdtSource(settings);
  ASSERT_TRUE(source->start(collected.sink()).ok());
  ASSERT_TRUE(eventually([&] { return !sensor.requests().empty(); }));
  sensor.send(rdtRecord(1, 0, {2000, 0, 0, 500, 0, 0}));
  ASSERT_TRUE(collected.reach(1));
  EXPECT_EQ((*collected.samples()[0].wrench)(0), 1.0);
  EXPECT_EQ((*collected.samples()[0].wrench)(3), 1.0);
}

TEST(NetFt, InOtherUnitsIsNotRead) {
  FakeNetFt sensor;
  const FakeWebPage page("<cfgcpf>2000</cfgcpf><cfgcpt>500</cfgcpt><scfgfu>lbf</scfgfu><scfgtu>lbf-in</scfgtu>");
  Collected collected;
  auto settings = settingsFor(sensor);
  settings.countsPerNewton = settings.countsPerNewtonMetre = 0.0;
  settings.httpPort = page.port();
  const auto source = makeRdtSource(settings);
  ASSERT_TRUE(source->start(collected.sink()).ok());
  ASSERT_TRUE(eventually([&] { return source->status().text.find("lbf") != std::string::npos; }));
  EXPECT_TRUE(sensor.requests().empty());
}

struct JsonLink {
  JsonLink() {
    const auto probe = UdpSocket::listening("127.0.0.1", 0);
    port = probe->port();
  }
  void open() {
    source = makeJsonUdpSource("127.0.0.1", port);
    ASSERT_TRUE(source->start(collected.sink()).ok());
    sender.emplace(UdpSocket::connected("127.0.0.1", port).value());
  }
  std::uint16_t port = 0;
  Collected collected;
  std::unique_ptr<LiveSource> source;
  std::optional<UdpSocket> sender;
};

std::string object(double time, double fx = 1.0) {
  return fmt::format(R"({{"time":{},"q1":0.1,"q2":0.2,"q3":0.3,"q4":0.4,"q5":0.5,"q6":0.6,"q7":0.7,)"
                     R"("fx":{},"fy":2,"fz":3,"tx":4,"ty":5,"tz":6}})",
                     time, fx);
}

TEST(UdpSocket, SaysWhenEachArrivedThoughTheyAreReadLater) {
  auto socket = UdpSocket::listening("127.0.0.1", 0).value();
  auto sender = UdpSocket::connected("127.0.0.1", socket.port()).value();
  std::vector<double> before, after;
  for (int k = 0; k < 4; ++k) {
    before.push_back(hostNow());
    sender.send("x");
    after.push_back(hostNow());
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
  }
  for (std::size_t k = 0; k < before.size(); ++k) {
    ASSERT_TRUE(socket.receive(1.0));
    EXPECT_GT(socket.arrival(), before[k] - 1e-3);
    EXPECT_LT(socket.arrival(), after[k] + 1e-3);
  }
  EXPECT_FALSE(socket.receive(0.02));
}

TEST(JsonUdp, ObjectsBecomeSamples) {
  JsonLink link;
  link.open();
  for (int k = 0; k < 15; ++k) link.sender->send(object(100.0 + 0.01 * k, k));
  link.sender->send("not json");
  link.sender->send(R"({"a": 1})");
  link.sender->send(object(100.05));
  link.sender->send(object(100.20, 20.0));
  ASSERT_TRUE(link.collected.reach(6));
  ASSERT_TRUE(eventually([&] { return link.source->status().samples == 6; }));  // ten teach the clock
  const auto status = link.source->status();
  EXPECT_EQ(status.malformed, 2u);
  EXPECT_EQ(status.reordered, 1u);
  const auto samples = link.collected.samples();
  EXPECT_EQ((*samples[0].wrench)(0), 10.0);
  EXPECT_EQ((*samples[5].wrench)(0), 20.0);
  ASSERT_TRUE(samples[0].q);
  EXPECT_EQ((*samples[0].q)[6], 0.7);
  EXPECT_NEAR(samples[5].time - samples[0].time, 0.1, 1e-9) << "the sender's own times";
}

TEST(JsonUdp, MotionAndWrenchMayComeInObjectsOfTheirOwn) {
  JsonLink link;
  link.open();
  for (int k = 0; k < 20; ++k) {
    const double time = 100.0 + 0.01 * k;
    link.sender->send(fmt::format(R"({{"time":{},"fx":{},"fy":2,"fz":3,"tx":4,"ty":5,"tz":6}})", time, k));
    link.sender->send(
        fmt::format(R"({{"time":{},"q1":{},"q2":0.2,"q3":0.3,"q4":0.4,"q5":0.5,"q6":0.6,"q7":0.7}})", time, 0.001 * k));
  }
  link.sender->send(R"({"time":100.1,"fx":9,"fy":2,"fz":3,"tx":4,"ty":5,"tz":6})");
  ASSERT_TRUE(eventually([&] { return link.source->status().reordered == 1; })) << "the last one, and no other";
  ASSERT_TRUE(link.collected.reach(10));
  const auto samples = link.collected.samples();
  EXPECT_TRUE(std::any_of(samples.begin(), samples.end(), [](const LiveSample& s) { return s.hasMotion(); }));
  EXPECT_TRUE(std::any_of(samples.begin(), samples.end(), [](const LiveSample& s) { return s.wrench.has_value(); }));
  EXPECT_EQ(link.source->status().reordered, 1u);
}

TEST(JsonUdp, SurvivesAnything) {
  JsonLink link;
  link.open();
  std::mt19937 random(3);
  for (int round = 0; round < 400; ++round) {
    auto bytes = object(round);
    for (unsigned i = 0; i < 1 + random() % 3; ++i) bytes[random() % bytes.size()] = static_cast<char>(random());
    if (random() % 8 == 0) bytes.resize(random() % bytes.size());
    if (random() % 16 == 0) bytes = std::string(random() % 1000, '[');
    link.sender->send(bytes);
    if (round % 50 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  const auto before = link.collected.samples().size();
  for (int k = 0; k < 30; ++k) link.sender->send(object(1e6 + k));
  EXPECT_TRUE(link.collected.reach(before + 5));
  for (const auto& sample : link.collected.samples()) EXPECT_TRUE(!sample.wrench || sample.wrench->allFinite());
}

TEST(NetFt, SurvivesAnything) {
  FakeNetFt sensor;
  Collected collected;
  const auto source = makeRdtSource(settingsFor(sensor));
  ASSERT_TRUE(source->start(collected.sink()).ok());
  ASSERT_TRUE(eventually([&] { return !sensor.requests().empty(); }));
  std::mt19937 random(4);
  for (int round = 0; round < 400; ++round) {
    std::string bytes(random() % 80, '\0');
    if (random() % 2 == 0) bytes.resize(36);
    for (char& c : bytes) c = static_cast<char>(random());
    sensor.send(bytes);
  }
  // Whatever number came last, a sensor that goes on is believed again.
  const auto before = source->status().samples;
  for (std::uint32_t k = 0; k < 300; ++k) sensor.send(rdtRecord(1000 + k, 0, {1, 2, 3, 4, 5, 6}));
  EXPECT_TRUE(eventually([&] { return source->status().samples >= before + 50; }));
}

TEST(MakeSource, KnowsItsAddresses) {
  for (const char* const good : {"rdt:192.168.1.1", "rdt:192.168.1.1:49152?cpf=1000000&cpt=1000000", "udp:9870",
                                 "udp:0.0.0.0:9870", "foxglove:localhost", "foxglove://localhost:8765",
                                 "rosbridge:localhost:9090?wrench=/ft&joints=/joint_states", "replay:a.csv?speed=2"})
    EXPECT_TRUE(makeLiveSource(good).ok()) << good;
  for (const char* const bad : {"", "rdt", "rdt:", "rdt:h:0", "rdt:h:70000", "rdt:h?cpf=1", "rdt:h?cpf=x&cpt=1",
                                "udp:x", "serial:1", "rdt:h?bias=1", "replay:a.csv?speed=0", "foxglove:h?x"})
    EXPECT_FALSE(makeLiveSource(bad).ok()) << bad;
}

TEST(JsonUdp, APortInUseIsAnError) {
  const auto taken = UdpSocket::listening("127.0.0.1", 0);
  Collected collected;
  const auto source = makeJsonUdpSource("127.0.0.1", taken->port());
  const auto started = source->start(collected.sink());
  ASSERT_FALSE(started.ok());
  EXPECT_EQ(source->status().state, LinkState::failed);
}

TEST(JsonUdp, AnAccelerometerComesAlong) {
  const auto port = [] {
    auto socket = UdpSocket::listening("127.0.0.1", 0);
    return socket->port();
  }();
  Collected collected;
  const auto source = makeJsonUdpSource("127.0.0.1", port);
  ASSERT_TRUE(source->start(collected.sink()).ok());
  auto sender = UdpSocket::connected("127.0.0.1", port);
  ASSERT_TRUE(sender.ok());
  for (int k = 0; k < 20; ++k)
    sender->send(fmt::format(R"({{"time":{},"qx":0,"qy":0,"qz":0,"qw":1,"fx":1,"fy":2,"fz":3,"tx":0,"ty":0,"tz":0,)"
                             R"("ax":0.5,"ay":{},"az":9.8,"imu_wx":0.1,"imu_wy":0.2,"imu_wz":0.3}})",
                             0.01 * k, k == 12 ? "null" : "1"));
  ASSERT_TRUE(collected.reach(6));
  for (const auto& sample : collected.samples()) {
    ASSERT_TRUE(sample.orientation && sample.wrench);
    if (!sample.accelerometer) continue;
    EXPECT_EQ(*sample.accelerometer, Vector3d(0.5, 1.0, 9.8));
    EXPECT_EQ(*sample.gyroscope, Vector3d(0.1, 0.2, 0.3));
  }
  EXPECT_TRUE(collected.samples().back().accelerometer);
}

TEST(NetFt, CountsThatNothingCanBeDividedByAreNone) {
  const auto page = [](const std::string& force, const std::string& torque) {
    return "<cfgcpf>" + force + "</cfgcpf><cfgcpt>" + torque + "</cfgcpt>";
  };
  ASSERT_TRUE(rdt::unitsIn(page("1000000", "2e6")).ok());
  EXPECT_EQ(rdt::unitsIn(page("1000000", "2e6"))->countsPerNewtonMetre, 2e6);
  for (const char* const bad : {"0", "-1", "inf", "nan", "1e-320", "1e400", "10 N", ""})
    EXPECT_FALSE(rdt::unitsIn(page("1000000", bad)).ok()) << bad;
}

}  // namespace
}  // namespace heft
