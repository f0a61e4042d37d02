#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/online/feed.h"

namespace heft {
namespace {

using test::estimatorFor;
using test::feed;
using test::onlineTool;
using test::simulated;

Payload heavier() { return test::boxPayload(1.1, {0.08, 0.10, 0.16}, {0.01, 0.01, 0.08}); }

/// The same motion and sensor with one tool, another from `change`, and the first again from `back` [s].
Recording twoTools(unsigned seed, double duration, double change, double back) {
  Recording a = simulated(MotionKind::free, onlineTool(), seed, duration);
  const Recording b = simulated(MotionKind::free, heavier(), seed, duration);
  for (Eigen::Index k = 0; k < a.rows(); ++k)
    if (a.time(k) >= change && a.time(k) < back) a.wrench.row(k) = b.wrench.row(k);
  return a;
}

bool has(const OnlineState& state, std::string_view code) {
  return std::any_of(state.findings.begin(), state.findings.end(), [&](const Finding& f) { return f.code == code; });
}

TEST(ToolChange, IsSaidAndTheNewToolIsEstimated) {
  for (const unsigned seed : {21u, 22u}) {
    const Recording recording = twoTools(seed, 16.0, 7.0, 1e9);
    OnlineEstimator online = estimatorFor(recording);
    feed(online, recording, 0, 6900);
    EXPECT_FALSE(online.state().toolChanged.has_value());
    EXPECT_NEAR(online.state().payload.mass, onlineTool().mass, 0.02);
    feed(online, recording, 6900);
    const OnlineState& state = online.state();
    ASSERT_TRUE(state.toolChanged.has_value()) << seed;
    EXPECT_NEAR(*state.toolChanged, 7.0, 0.3) << seed;
    EXPECT_TRUE(has(state, "tool_changed"));
    EXPECT_EQ(state.tools, 2);
    EXPECT_NEAR(state.payload.mass, heavier().mass, 0.02) << seed;
    EXPECT_LT((state.payload.com - heavier().com).norm(), 0.004) << seed;
  }
}

TEST(ToolChange, TheFirstToolIsRecognisedWhenItComesBack) {
  const Recording recording = twoTools(24, 18.0, 6.0, 12.0);
  OnlineEstimator online = estimatorFor(recording);
  feed(online, recording, 0, 11900);
  EXPECT_NEAR(online.state().payload.mass, heavier().mass, 0.02);
  feed(online, recording, 11900);
  const OnlineState& state = online.state();
  EXPECT_TRUE(has(state, "tool_back"));
  EXPECT_EQ(state.tools, 2);
  EXPECT_NEAR(state.payload.mass, onlineTool().mass, 0.02);
  EXPECT_GT(state.usedDuration, 9.0);
}

TEST(ToolChange, PushesAreNone) {
  for (const unsigned seed : {31u, 32u}) {
    Recording recording = simulated(MotionKind::pickAndPlace, onlineTool(), seed);
    // A hand that leans on the tool for three seconds, never quite the same.
    for (Eigen::Index k = 12000; k < 15000; ++k) {
      recording.wrench(k, 0) += 3.0 + std::sin(0.004 * static_cast<double>(k));
      recording.wrench(k, 4) += 0.2;
    }
    OnlineEstimator online = estimatorFor(recording);
    feed(online, recording);
    EXPECT_FALSE(online.state().toolChanged.has_value()) << seed;
    EXPECT_LT(std::abs(online.state().payload.mass - onlineTool().mass), 0.02) << seed;
  }
}

}  // namespace
}  // namespace heft
