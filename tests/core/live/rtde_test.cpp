// Universal Robots over RTDE, against a server made after the protocol's description.
#include <cmath>
#include <cstring>
#include <random>

#include "core/live/rtde_protocol.h"
#include "core/live/session.h"
#include "core/live/sources.h"
#include "tests/core/live/collected.h"
#include "tests/support/rtde_server.h"

namespace heft {
namespace {

using namespace testing_support;
using ::testing::HasSubstr;

/// Packages are found wherever the bytes were cut; what is no number is left out and never taken for zero.
TEST(RtdeProtocol, ReadsPackagesInPieces) {
  const std::vector<std::string> outputs = {"timestamp", "actual_q", "actual_qd", "payload"};
  std::string row("\7", 1);
  const auto number = [&](double value) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof(bits));
    for (int shift = 56; shift >= 0; shift -= 8) row += static_cast<char>(bits >> shift & 0xFF);
  };
  number(3.5);
  for (int j = 0; j < 6; ++j) number(0.5 * j);
  for (int j = 0; j < 6; ++j) number(j == 4 ? std::nan("") : 1.0);
  number(1.25);
  const std::string bytes =
      rtde::package(rtde::kTextMessage, std::string("\2hi\0", 4)) + rtde::package(rtde::kData, row);
  for (const std::size_t piece : {1u, 7u, 1000u}) {
    rtde::PackageReader reader;
    std::vector<rtde::Received> found;
    for (std::size_t at = 0; at < bytes.size(); at += piece) {
      reader.add(std::string_view(bytes).substr(at, piece));
      while (auto each = reader.next()) found.push_back(*each);
    }
    ASSERT_EQ(found.size(), 2u) << piece;
    EXPECT_EQ(rtde::textOf(found[0].content), "hi");
    EXPECT_FALSE(rtde::rowOf(found[1].content, {8, outputs})) << "of another recipe";
    EXPECT_FALSE(rtde::rowOf(found[1].content, {7, {"timestamp"}})) << "of another length";
    const auto read = rtde::rowOf(found[1].content, {7, outputs});
    ASSERT_TRUE(read);
    EXPECT_EQ(rtde::stampOf(*read), 3.5);
    EXPECT_EQ(rtde::configuredIn(*read)->payload.mass, 1.25);
    const auto sample = rtde::sampleOf(*read);
    ASSERT_TRUE(sample && sample->q);
    EXPECT_EQ((*sample->q)[5], 2.5);
    EXPECT_FALSE(sample->dq);
    EXPECT_FALSE(sample->wrench);
  }
  rtde::PackageReader lost;
  lost.add(std::string("\0\1V", 3));
  EXPECT_FALSE(lost.next());
  EXPECT_TRUE(lost.broken());
  EXPECT_EQ(rtde::missingIn("\1DOUBLE,VECTOR6D,NOT_FOUND", outputs),
            (std::vector<std::string>{"actual_qd", "payload"}));
}

TEST(Rtde, ReadsJointsWrenchAndPayloadAndWritesNothing) {
  RtdeServer robot({});
  Collected collected;
  const auto source = makeRtdeSource("127.0.0.1", robot.port());
  ASSERT_TRUE(source->start(collected.sink()).ok());
  ASSERT_TRUE(eventually([&] { return robot.started(); }));
  EXPECT_EQ(robot.frequency(), 500.0);
  for (int k = 0; k < 40; ++k)
    if (k != 20 && k != 21) robot.sendRow(3.0 + 0.002 * k, 0.25);
  robot.sendRow(3.0 + 0.002 * 39, 0.25);  // once more
  ASSERT_TRUE(collected.reach(28));       // ten teach the clock
  ASSERT_TRUE(eventually([&] { return source->status().reordered == 1; }));
  const auto status = source->status();
  EXPECT_EQ(status.lost, 2u);
  EXPECT_EQ(status.malformed, 0u);
  EXPECT_TRUE(status.notes.empty());
  const auto sample = collected.samples().back();
  EXPECT_EQ(sample.joints, 6);
  ASSERT_TRUE(sample.q && sample.dq && sample.wrench);
  EXPECT_EQ((*sample.q)[5], 5.25);
  EXPECT_EQ((*sample.dq)[0], 0.25);
  EXPECT_EQ((*sample.wrench)(3), 3.25);
  ASSERT_TRUE(status.configured);
  EXPECT_EQ(*status.configured->payload.mass, 0.25);
  EXPECT_EQ(status.configured->payload.com->z(), 2.25);
  EXPECT_EQ((*status.configured->payload.inertiaCom)(0, 1), 3.25);  // Ixx, Iyy, Izz, Ixy, ...
  EXPECT_EQ((*status.configured->payload.inertiaCom)(2, 2), 2.25);
  source->stop();
  ASSERT_TRUE(eventually([&] { return robot.types().back() == 'P'; }));
  EXPECT_EQ(robot.types(), "VvOSP");  // neither I nor U
}

TEST(Rtde, AControllerWithoutRawWrenchGivesJointsAndSaysSo) {
  RtdeServer::Options older;
  older.majorVersion = 3;
  older.unknown = {"ft_raw_wrench", "payload_inertia"};
  RtdeServer robot(older);
  Collected collected;
  const auto source = makeRtdeSource("127.0.0.1", robot.port());
  ASSERT_TRUE(source->start(collected.sink()).ok());
  ASSERT_TRUE(eventually([&] { return robot.started(); }));
  EXPECT_EQ(robot.frequency(), 125.0);
  EXPECT_EQ(robot.types(), "VvOOS");
  for (int k = 0; k < 20; ++k) robot.sendRow(1.0 + 0.008 * k, 1.0);
  ASSERT_TRUE(collected.reach(5));
  EXPECT_FALSE(collected.samples().back().wrench);
  EXPECT_EQ((*collected.samples().back().q)[1], 2.0);
  EXPECT_EQ(source->status().lost, 0u);
  ASSERT_EQ(source->status().notes.size(), 1u);
  EXPECT_THAT(source->status().notes[0], HasSubstr("ft_raw_wrench"));
}

TEST(Rtde, ComesBackAfterABreakAndAfterARestartOfTheController) {
  RtdeServer robot({});
  Collected collected;
  const auto source = makeRtdeSource("127.0.0.1", robot.port());
  ASSERT_TRUE(source->start(collected.sink()).ok());
  for (int round = 0; round < 2; ++round) {
    ASSERT_TRUE(eventually([&] { return robot.connections() == round + 1 && robot.started(); }));
    const auto before = collected.samples().size();
    for (int k = 0; k < 20; ++k) robot.sendRow((round == 0 ? 900.0 : 2.0) + 0.002 * k, 1.0);
    ASSERT_TRUE(collected.reach(before + 8));
    EXPECT_EQ(source->status().state, LinkState::live);
    robot.drop();
    ASSERT_TRUE(eventually([&] { return source->status().disconnects == static_cast<std::uint64_t>(round) + 1; }));
  }
  EXPECT_EQ(source->status().lost, 0u);
}

TEST(Rtde, OtherServersAndOldOnesAreTold) {
  RtdeServer::Options older;
  older.knowsVersion2 = false;
  RtdeServer robot(older);
  Collected collected;
  const auto source = makeRtdeSource("127.0.0.1", robot.port());
  ASSERT_TRUE(source->start(collected.sink()).ok());
  ASSERT_TRUE(eventually([&] { return source->status().text.find("version 2") != std::string::npos; }));
  EXPECT_EQ(source->status().state, LinkState::connecting);
  source->stop();

  RtdeServer::Options noJoints;
  noJoints.unknown = {"actual_q"};
  RtdeServer other(noJoints);
  const auto second = makeRtdeSource("127.0.0.1", other.port());
  ASSERT_TRUE(second->start(collected.sink()).ok());
  ASSERT_TRUE(eventually([&] { return second->status().text.find("actual_q") != std::string::npos; }));
}

TEST(Rtde, SurvivesDamagedPackages) {
  RtdeServer robot({});
  Collected collected;
  const auto source = makeRtdeSource("127.0.0.1", robot.port());
  ASSERT_TRUE(source->start(collected.sink()).ok());
  ASSERT_TRUE(eventually([&] { return robot.started(); }));
  robot.sendText("overload");
  std::mt19937 random(4);
  for (int round = 0; round < 50; ++round) {  // whole packages of random content
    std::string content(random() % 300, '\0');
    for (char& c : content) c = static_cast<char>(random() % 256);
    const auto size = content.size() + 3;
    robot.sendBytes({static_cast<char>(size >> 8), static_cast<char>(size & 0xFF), "UMOSx"[random() % 5]});
    robot.sendBytes(content);
  }
  for (int k = 0; k < 30; ++k) robot.sendRow(5.0 + 0.002 * k, 1.0);
  ASSERT_TRUE(collected.reach(10));
  EXPECT_GT(source->status().malformed, 0u);
  robot.sendBytes(std::string("\0\0\0", 3));  // a size that no package has
  ASSERT_TRUE(eventually([&] { return robot.connections() == 2; }));
}

TEST(LiveSession, SaysWhichOfMotionAndWrenchIsMissing) {
  SessionStatus status;
  EXPECT_THAT(missingPart(status), HasSubstr("Neither"));
  status.wrenches = 5;
  EXPECT_THAT(missingPart(status), HasSubstr("no joint angles"));
  status.motions = 5;
  EXPECT_EQ(missingPart(status), "");
  status.wrenches = 0;
  EXPECT_THAT(missingPart(status), HasSubstr("no wrench"));
}

}  // namespace
}  // namespace heft
