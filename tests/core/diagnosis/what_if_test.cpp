// Causes as knobs: what a fault does to the estimate, and whether anybody could see it.
#include "core/diagnosis/what_if.h"

#include <gtest/gtest.h>

#include "core/diagnosis/wording/words.h"
#include "core/estimation/segment_recording.h"
#include "tests/core/diagnosis/fixture.h"

namespace heft {
namespace {

std::shared_ptr<const RobotModel> panda() { return {std::shared_ptr<void>(), &RobotModel::panda()}; }

WhatIf knobsOn(const Recording& recording) {
  const std::vector<Segment> all{{recording.time(0), recording.time(recording.rows() - 1), MarkLabel::free, ""}};
  auto made = WhatIf::make(recording, panda(), all);
  if (!made) throw std::runtime_error(made.error().message);
  return std::move(*made);
}

std::size_t knobOf(const WhatIf& whatIf, std::string_view cause) {
  const auto& knobs = whatIf.knobs();
  const auto at = std::ranges::find(knobs, cause, &Knob::cause);
  if (at == knobs.end()) throw std::runtime_error("no knob " + std::string(cause));
  return static_cast<std::size_t>(at - knobs.begin());
}

WhatIfState with(const WhatIf& whatIf, std::size_t knob, double position) {
  std::vector<double> positions(whatIf.knobs().size(), 0.0);
  positions[knob] = position;
  return whatIf.at(positions);
}

TEST(WhatIf, WithoutFaultsItIsTheEstimateAndNothingIsSeen) {
  const Recording recording = test::aRecording(MotionKind::excitation, 41);
  const WhatIf whatIf = knobsOn(recording);
  const WhatIfState calm = whatIf.at(std::vector<double>(whatIf.knobs().size(), 0.0));
  EXPECT_FALSE(calm.seen);
  EXPECT_FALSE(calm.lookAlike);
  EXPECT_LT(calm.moved.cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_NEAR(calm.payload.mass, test::aTool().mass, 4.0 * calm.std.mass + 1e-3);
  EXPECT_TRUE(calm.effect.isZero(0.0));
}

TEST(WhatIf, EveryCauseOfTheCatalogueHasOneKnobWithWordsAndAReach) {
  const WhatIf whatIf = knobsOn(test::aRecording(MotionKind::excitation, 42));
  EXPECT_GE(whatIf.knobs().size(), 15u);
  for (const Knob& knob : whatIf.knobs()) {
    EXPECT_EQ(std::ranges::count(whatIf.knobs(), knob.cause, &Knob::cause), 1) << knob.cause;
    EXPECT_NE(causeTitle(knob.cause), knob.cause);
    EXPECT_TRUE(std::isfinite(knob.shown(1.0)) && std::isfinite(knob.shown(0.1))) << knob.cause;
    EXPECT_GT(knob.leastSeen, 0.0) << knob.cause;
  }
  // The one that its name speaks of, whatever else it has.
  for (const auto& [cause, parameter] : {std::pair{"time_offset", "delay"}, std::pair{"cable_pull", "stiffness"},
                                         std::pair{"payload_change", "mass"}, std::pair{"loose_mass", "mass"}})
    EXPECT_EQ(whatIf.knobs()[knobOf(whatIf, cause)].parameter, parameter);
  EXPECT_NEAR(whatIf.knobs()[knobOf(whatIf, "time_offset")].shown(1.0), 25.0, 1e-9);
  EXPECT_NEAR(whatIf.knobs()[knobOf(whatIf, "cable_pull")].shown(1.0), 5.0, 1e-9);
  // The first joint turns about gravity, which no sensor feels: the knob is of one that shows.
  EXPECT_LT(whatIf.knobs()[knobOf(whatIf, "joint_offset")].leastSeen, 1.0);
}

/// The same readings, `rows` rows late.
Recording late(const Recording& recording, Eigen::Index rows) {
  Recording out = recording;
  const Eigen::Index kept = recording.rows() - rows;
  out.wrench.bottomRows(kept) = recording.wrench.topRows(kept);
  return out;
}

TEST(WhatIf, TheDelayedEstimateIsThatOfDelayedReadings) {
  const Recording recording = test::aRecording(MotionKind::excitation, 43);
  const Eigen::Index rows = std::lround(0.012 * recording.rateHz());
  const WhatIf clean = knobsOn(recording), delayed = knobsOn(late(recording, rows));
  const std::size_t knob = knobOf(clean, "time_offset");
  const WhatIfState told = with(clean, knob, 12.0 / clean.knobs()[knob].shown(1.0));
  const WhatIfState real = delayed.at(std::vector<double>(delayed.knobs().size(), 0.0));
  EXPECT_TRUE(told.seen);
  const double error = std::abs(real.payload.inertiaCom.trace() - test::aTool().inertiaCom.trace());
  EXPECT_NEAR(told.payload.mass, real.payload.mass, 0.004);
  EXPECT_NEAR(told.payload.inertiaCom.trace(), real.payload.inertiaCom.trace(), 0.35 * error + 5e-5);
  EXPECT_NEAR(told.force / real.force, 1.0, 0.1);
  EXPECT_NEAR(told.torque / real.torque, 1.0, 0.1);
}

TEST(WhatIf, NamesTheLookAlikeAndHowMuchOfItFits) {
  const WhatIf whatIf = knobsOn(test::aRecording(MotionKind::free, 44));
  const WhatIfState state = with(whatIf, knobOf(whatIf, "time_offset"), 0.6);
  ASSERT_TRUE(state.lookAlike);
  const std::string other = whatIf.knobs()[state.lookAlike->knob].cause;
  EXPECT_TRUE(other == "low_pass_lag" || other == "motion_lag") << other;
  // A filter loses height besides; the smaller both are, the less that shows.
  EXPECT_GT(state.lookAlike->share, 0.8);
  const WhatIfState less = with(whatIf, knobOf(whatIf, "time_offset"), 0.2);
  ASSERT_TRUE(less.lookAlike);
  EXPECT_GT(less.lookAlike->share, state.lookAlike->share);
  // The other follows the hand, whichever of the two comes nearer.
  const auto sizeOf = [&](const WhatIfState& each) {
    return whatIf.knobs()[each.lookAlike->knob].shown(each.lookAlike->position);
  };
  EXPECT_NEAR(sizeOf(less) / sizeOf(state), 0.2 / 0.6, 0.1);
  // What a cause leaves, it explains itself: two knobs of which one is the other's look-alike are never on at once.
  EXPECT_NE(state.lookAlike->knob, knobOf(whatIf, "time_offset"));
}

TEST(WhatIf, FromTheLeastSizeOnSomethingIsSeen) {
  const WhatIf whatIf = knobsOn(test::aRecording(MotionKind::excitation, 45));
  for (const char* cause : {"time_offset", "viscous_drag", "cable_pull"}) {
    const std::size_t k = knobOf(whatIf, cause);
    const double least = whatIf.knobs()[k].leastSeen;
    ASSERT_LT(least, 1.0) << cause;
    EXPECT_FALSE(with(whatIf, k, 0.6 * least).seen) << cause;
    EXPECT_TRUE(with(whatIf, k, std::min(1.0, 1.6 * least)).seen) << cause;
  }
}

TEST(WhatIf, WhatAMotionCannotTellMovesNothingThatCouldBeSeen) {
  Recording still = test::aRecording(MotionKind::excitation, 46);
  const Eigen::RowVectorXd q = still.q.row(still.rows() / 2);
  for (Eigen::Index k = 0; k < still.rows(); ++k) still.q.row(k) = q;
  still.dq.setZero();
  RandomStream random(46, RandomPurpose::white);
  for (Eigen::Index k = 0; k < still.rows(); ++k)
    for (int c = 0; c < 6; ++c) still.wrench(k, c) = (c == 2 ? -7.0 : 0.0) + (c < 3 ? 0.02 : 0.001) * random.normal();
  const WhatIf whatIf = knobsOn(still);
  const std::size_t k = knobOf(whatIf, "time_offset");
  EXPECT_GT(whatIf.knobs()[k].leastSeen, 1.0);
  EXPECT_FALSE(with(whatIf, k, 1.0).seen);
}

TEST(WhatIf, RefusesPosesAndContactThroughout) {
  Recording recording = test::aRecording(MotionKind::excitation, 47);
  const std::vector<Segment> touched{{0.0, 100.0, MarkLabel::contact, ""}};
  EXPECT_FALSE(WhatIf::make(recording, panda(), touched));
  recording.meta.kind = RecordingKind::poses;
  const auto poses = WhatIf::make(recording, panda(), {});
  ASSERT_FALSE(poses);
  EXPECT_NE(poses.error().message.find("poses"), std::string::npos);
}

}  // namespace
}  // namespace heft
