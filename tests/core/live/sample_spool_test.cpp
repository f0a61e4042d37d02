// Samples on disk come back as they were, also where the disk takes no more.
#include "core/live/sample_spool.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <random>

namespace heft {
namespace {

LiveSample drawn(std::mt19937& random) {
  std::uniform_real_distribution<double> value(-10.0, 10.0);
  const auto maybe = [&] { return random() % 3 != 0; };
  LiveSample out;
  out.time = value(random);
  out.joints = static_cast<int>(1 + random() % 7);
  const auto joints = [&] {
    std::array<double, 7> all{};
    for (int j = 0; j < out.joints; ++j) all[static_cast<std::size_t>(j)] = value(random);
    return all;
  };
  const auto three = [&] { return Vector3d{value(random), value(random), value(random)}; };
  if (maybe()) out.q = joints();
  if (out.q && maybe()) out.dq = joints();
  if (maybe()) out.orientation = Quaterniond{value(random), value(random), value(random), value(random)};
  if (out.orientation && maybe()) out.position = three();
  if (maybe()) out.wrench = Vector6d::Constant(value(random));
  if (maybe()) out.accelerometer = three();
  if (out.accelerometer && maybe()) out.gyroscope = three();
  return out;
}

void expectSame(const LiveSample& a, const LiveSample& b) {
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.joints, b.joints);
  EXPECT_EQ(a.q, b.q);
  EXPECT_EQ(a.dq, b.dq);
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.wrench, b.wrench);
  EXPECT_EQ(a.accelerometer, b.accelerometer);
  EXPECT_EQ(a.gyroscope, b.gyroscope);
  ASSERT_EQ(a.orientation.has_value(), b.orientation.has_value());
  if (a.orientation) {
    EXPECT_EQ(a.orientation->coeffs(), b.orientation->coeffs());
  }
}

void expectAllBack(int count) {
  SampleSpool spool;
  std::mt19937 in(5), again(5);
  for (int i = 0; i < count; ++i) spool.add(drawn(in));
  EXPECT_EQ(spool.size(), static_cast<std::uint64_t>(count));
  for (int pass = 0; pass < 2; ++pass) {
    again.seed(5);
    int back = 0;
    const auto read = spool.forEach([&](const LiveSample& sample) {
      expectSame(sample, drawn(again));
      ++back;
    });
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(back, count);
  }
}

TEST(SampleSpool, GivesBackWhatItTook) {
  expectAllBack(0);
  expectAllBack(3);
  expectAllBack(20'000);
}

TEST(SampleSpool, KeepsInMemoryWhatTheDiskDoesNotTake) {
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto ignored = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit little{700'000, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &little), 0);
  expectAllBack(20'000);
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, ignored);
}

}  // namespace
}  // namespace heft
