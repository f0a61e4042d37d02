#include "core/live/recorder.h"

#include <fmt/format.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "core/live/network.h"
#include "core/live/session.h"
#include "core/live/sources.h"
#include "core/recording/csv_reader.h"
#include "tests/core/import/fixtures.h"
#include "tests/support/live_servers.h"

namespace heft {
namespace {

using namespace testing_support;
using LiveRecording = InFolder;

LiveSample sampleAt(double t) {
  LiveSample out;
  out.time = t;
  std::array<double, 7> q{};
  for (int j = 0; j < 7; ++j) q[static_cast<std::size_t>(j)] = jointAt(t, j);
  out.q = q;
  Vector6d wrench;
  for (int a = 0; a < 6; ++a) wrench(a) = wrenchAt(t, a);
  out.wrench = wrench;
  return out;
}

RecordingMeta panda() {
  RecordingMeta meta;
  meta.robot = "panda";
  return meta;
}

TEST_F(LiveRecording, IsAPlainRecordingBitByBit) {
  const auto file = folder_ / "live.csv";
  {
    auto recorder = Recorder::create(file, panda());
    ASSERT_TRUE(recorder.ok()) << recorder.error().message;
    for (int k = 0; k < 500; ++k) EXPECT_TRUE(recorder->add(sampleAt(1000.0 + 0.002 * k)));
    EXPECT_EQ(recorder->rows(), 500u);
  }
  const auto read = readRecording(file);
  ASSERT_TRUE(read.ok()) << read.error().message;
  ASSERT_EQ(read->recording.rows(), 500);
  EXPECT_EQ(read->recording.meta.robot, "panda");
  for (int k = 0; k < 500; ++k) {
    EXPECT_NEAR(read->recording.time(k), 0.002 * k, 1e-9);
    EXPECT_EQ(read->recording.q(k, 3), jointAt(1000.0 + 0.002 * k, 3));
    EXPECT_EQ(read->recording.wrench(k, 2), wrenchAt(1000.0 + 0.002 * k, 2));
  }
}

/// What comes a moment later than the first sample still has its columns: an inertial sensor, and joints after poses.
TEST_F(LiveRecording, TheFirstMomentDecidesNotTheFirstSample) {
  const auto file = folder_ / "felt.csv";
  {
    auto recorder = Recorder::create(file, panda());
    ASSERT_TRUE(recorder.ok()) << recorder.error().message;
    LiveSample pose = sampleAt(999.9);
    pose.q.reset();
    pose.orientation = Quaterniond::Identity();
    EXPECT_TRUE(recorder->add(pose));
    for (int k = 0; k < 100; ++k) {
      LiveSample sample = sampleAt(1000.0 + 0.01 * k);
      if (k > 0 && k != 50) {
        sample.accelerometer = Vector3d(0.1 * k, 2.0, 9.81);
        sample.gyroscope = Vector3d(0.01 * k, 0.0, 0.3);
      }
      EXPECT_TRUE(recorder->add(sample));
    }
  }
  const auto read = readRecording(file);
  ASSERT_TRUE(read.ok()) << read.error().message;
  ASSERT_GE(read->recording.rows(), 98);
  EXPECT_TRUE(read->recording.hasJoints());
  EXPECT_FALSE(read->recording.hasOrientation());
  const std::string text = InFolder::read(file);
  EXPECT_THAT(text, ::testing::HasSubstr("fx,fy,fz,tx,ty,tz,ax,ay,az,imu_wx,imu_wy,imu_wz\n"));
  EXPECT_THAT(text, ::testing::HasSubstr(",4,2,9.81,0.4,0,0.3\n"));
}

/// An inertial sensor that begins after the header was written gets its columns behind the others, and so does a
/// gyroscope after it; no row is lost, and a pose without a place begins with it.
TEST_F(LiveRecording, AnInertialSensorThatBeginsLateHasItsColumns) {
  const auto file = folder_ / "late.csv";
  const auto feltFrom = 100, turnedFrom = 160, all = 400;
  {
    auto recorder = Recorder::create(file, RecordingMeta());
    ASSERT_TRUE(recorder.ok()) << recorder.error().message;
    for (int k = 0; k < all; ++k) {
      LiveSample sample = sampleAt(1000.0 + 0.01 * k);
      sample.q.reset();
      sample.orientation = Quaterniond(std::cos(0.001 * k), std::sin(0.001 * k), 0.0, 0.0);
      if (k >= feltFrom) sample.accelerometer = Vector3d(0.01 * k, 2.0, 9.81);
      if (k >= turnedFrom) sample.gyroscope = Vector3d(0.01 * k, 0.0, 0.3);
      if (k == 50 || k == 130) recorder->flush();
      EXPECT_TRUE(recorder->add(sample));
    }
    EXPECT_TRUE(recorder->flush()) << recorder->problem();
    EXPECT_EQ(recorder->rows(), static_cast<std::uint64_t>(all));
  }
  const std::string text = InFolder::read(file);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), all + 1);
  EXPECT_THAT(text, ::testing::HasSubstr("qx,qy,qz,qw,fx,fy,fz,tx,ty,tz,ax,ay,az,imu_wx,imu_wy,imu_wz\n"));
  const auto read = readRecording(file);
  ASSERT_TRUE(read.ok()) << read.error().message;
  const auto& recording = read->recording;
  ASSERT_TRUE(recording.hasAccelerometer()) << text.substr(0, 200);
  ASSERT_EQ(recording.gyroscope.rows(), recording.rows());
  EXPECT_EQ(recording.rows(), all - turnedFrom);
  EXPECT_NEAR(recording.accelerometer(0, 0), 0.01 * turnedFrom, 1e-12);
  EXPECT_NEAR(recording.gyroscope(0, 0), 0.01 * turnedFrom, 1e-12);
  for (const auto& entry : std::filesystem::directory_iterator(folder_))
    EXPECT_THAT(entry.path().filename().string(), ::testing::StartsWith("late.")) << "nothing is left beside it";
}

TEST_F(LiveRecording, NeverReplacesAFile) {
  write("live.csv", "mine");
  EXPECT_FALSE(Recorder::create(folder_ / "live.csv", panda()).ok());
  EXPECT_EQ(read(folder_ / "live.csv"), "mine");
  EXPECT_FALSE(Recorder::create(folder_ / "no_such_folder" / "live.csv", panda()).ok());
}

TEST_F(LiveRecording, AFullDiskIsSaidAndWhatIsThereCanBeRead) {
  const auto file = folder_ / "live.csv";
  auto recorder = Recorder::create(file, panda());
  ASSERT_TRUE(recorder.ok()) << recorder.error().message;
  // The system lets this process write no further: for the recorder the same as a disk without room.
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = ::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{20000, before.rlim_max};
  ::setrlimit(RLIMIT_FSIZE, &small);
  for (int k = 0; k < 500; ++k) recorder->add(sampleAt(1000.0 + 0.002 * k));
  const bool whole = recorder->flush();
  ::setrlimit(RLIMIT_FSIZE, &before);
  ::signal(SIGXFSZ, handler);
  EXPECT_FALSE(whole);
  EXPECT_NE(recorder->problem().find("can no longer be written"), std::string::npos) << recorder->problem();
  EXPECT_NE(recorder->problem().find("live.csv"), std::string::npos) << recorder->problem();
  EXPECT_FALSE(recorder->add(sampleAt(1001.0)));
  const auto read = readRecording(file);
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_GT(read->recording.rows(), 20);
}

TEST_F(LiveRecording, AKilledProgramLosesLessThanASecond) {
  const auto file = folder_ / "live.csv";
  const auto started = folder_ / "started";
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    auto recorder = Recorder::create(file, panda());
    const double begin = hostNow();
    for (int k = 0;; ++k) {
      while (hostNow() < begin + 0.001 * k) ::usleep(200);
      recorder->add(sampleAt(begin + 0.001 * k));
      if (k == 1500) std::ofstream(started.string()) << "x";
    }
  }
  const bool there = eventually([&] { return std::filesystem::exists(started); });
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  ASSERT_TRUE(there);
  const auto result = readRecording(file);
  ASSERT_TRUE(result.ok()) << result.error().message;
  EXPECT_GE(result->recording.rows(), 500) << "1500 ms were recorded when it was killed";
  EXPECT_FALSE(hasCode(result->findings, "line_cut_off"));
}

TEST_F(LiveRecording, OfAReplayIsTheReplayedRecording) {
  std::string text = "time,q1,q2,q3,q4,q5,q6,q7,fx,fy,fz,tx,ty,tz\n";
  for (int k = 0; k < 300; ++k) {
    text += fmt::format("{}", 0.01 * k);
    for (int j = 0; j < 7; ++j) text += fmt::format(",{}", jointAt(0.01 * k, j));
    for (int a = 0; a < 6; ++a) text += fmt::format(",{}", wrenchAt(0.01 * k, a));
    text += "\n";
  }
  const auto original = write("rec.csv", text);
  LiveSession session;
  session.addSource(makeReplaySource(original, 20.0));
  ASSERT_TRUE(session.record(folder_ / "live.csv", panda()).ok());
  ASSERT_TRUE(session.start().ok());
  ASSERT_TRUE(eventually([&] { return session.status().sources[0].state == LinkState::finished; }));
  session.stop();
  EXPECT_EQ(session.endRecording(), 300u);
  std::vector<LiveSample> samples;
  session.takeNew(samples);
  EXPECT_EQ(samples.size(), 300u);
  session.takeNew(samples);
  EXPECT_TRUE(samples.empty());
  EXPECT_EQ(session.status().samples, 300u);
  const auto first = readRecording(original);
  const auto second = readRecording(folder_ / "live.csv");
  ASSERT_TRUE(first.ok() && second.ok());
  EXPECT_EQ(first->recording.q, second->recording.q);
  EXPECT_NEAR((first->recording.time - second->recording.time).cwiseAbs().maxCoeff(), 0.0, 1e-8);
  EXPECT_EQ(first->recording.wrench, second->recording.wrench);
}

TEST_F(LiveRecording, OfTwoDevicesIsJoined) {
  FakeNetFt sensor;
  LiveSession session;
  RdtSettings settings;
  settings.host = "127.0.0.1";
  settings.port = sensor.port();
  settings.countsPerNewton = settings.countsPerNewtonMetre = 1000.0;
  session.addSource(makeRdtSource(settings));
  const auto probe = [] { return UdpSocket::listening("127.0.0.1", 0)->port(); };
  const auto port = probe();
  session.addSource(makeJsonUdpSource("127.0.0.1", port));
  ASSERT_TRUE(session.start().ok());
  ASSERT_TRUE(eventually([&] { return !sensor.requests().empty(); }));
  auto sender = UdpSocket::connected("127.0.0.1", port).value();
  std::uint32_t number = 0;
  ASSERT_TRUE(eventually([&] {
    for (int i = 0; i < 4; ++i) sensor.send(rdtRecord(++number, 0, {1000, 2000, 3000, 0, 0, 0}));
    sender.send(R"({"q1":0.1,"q2":0.2,"q3":0.3,"q4":0.4,"q5":0.5,"q6":0.6,"q7":0.7})");
    return session.status().samples > 20;
  }));
  std::vector<LiveSample> samples;
  session.takeNew(samples);
  EXPECT_EQ((*samples.back().wrench)(1), 2.0);
  EXPECT_EQ((*samples.back().q)[2], 0.3);
}

}  // namespace
}  // namespace heft
