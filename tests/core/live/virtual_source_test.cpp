#include <gtest/gtest.h>

#include <filesystem>

#include "core/live/session.h"
#include "core/live/virtual_source.h"
#include "core/recording/csv_reader.h"

namespace heft {
namespace {

std::unique_ptr<VirtualSource> stepped() {
  VirtualRigOptions options;
  options.payload = practiceTool(3);
  auto source = VirtualSource::create(RobotModel::panda(), options, VirtualSource::Pace::stepped);
  EXPECT_TRUE(source.ok());
  return std::move(*source);
}

TEST(VirtualSource, TimePassesOnlyWhenItIsStepped) {
  auto source = stepped();
  std::vector<LiveSample> got;
  source->advance(1.0);
  EXPECT_TRUE(got.empty()) << "not started";
  ASSERT_TRUE(source->start([&](const LiveSample& sample) { got.push_back(sample); }).ok());
  for (int k = 0; k < 100; ++k) source->advance(0.0163);
  ASSERT_EQ(got.size(), 1630u);
  EXPECT_NEAR(got.back().time - got.front().time, 1.629, 1e-9);
  EXPECT_TRUE(got[7].q && got[7].dq && got[7].wrench);
  EXPECT_NEAR(source->elapsed(), 1.629, 1e-9);
  source->stop();
  source->advance(1.0);
  EXPECT_EQ(got.size(), 1630u);
}

TEST(VirtualSource, IsRecordedAndWhatIsPausedIsLeftOut) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "heft_virtual_source";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  LiveSession session;
  auto owned = stepped();
  VirtualSource& source = *owned;
  session.addSource(std::move(owned));
  ASSERT_TRUE(session.record(folder / "a.csv", VirtualRig::metaFor({})).ok());
  ASSERT_TRUE(session.start().ok());
  source.guide([](GuidedArm& arm) { arm.wander(); });
  source.advance(1.0);
  session.setPaused(true);
  source.advance(1.0);
  session.setPaused(false);
  source.advance(1.0);
  session.stop();
  EXPECT_EQ(session.endRecording(), 2000u);
  const auto read = readRecording(folder / "a.csv");
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_EQ(read->recording.rows(), 2000);
  EXPECT_NEAR(read->recording.time(1000) - read->recording.time(999), 1.001, 1e-6);
  EXPECT_EQ(read->recording.meta.robot, "panda");
}

TEST(VirtualSource, IsFoundByItsAddress) {
  EXPECT_TRUE(makeLiveSource("virtual:7").ok());
  EXPECT_TRUE(makeLiveSource("virtual").ok());
  EXPECT_FALSE(makeLiveSource("virtual:seven").ok());
}

}  // namespace
}  // namespace heft
