// The lessons that come with the program: what each says is what its recording shows.
#include <gtest/gtest.h>

#include <numbers>

#include "core/base/json_file.h"
#include "core/diagnosis/what_if.h"
#include "core/diagnosis/wording/words.h"
#include "core/estimation/uncertainty.h"
#include "core/motion/motion.h"
#include "core/simulation/lesson.h"
#include "tests/support/random_tool.h"

namespace heft {
namespace {

struct Taught {
  Lesson lesson;
  WhatIf whatIf;
  WhatIfState calm;

  std::size_t knobOf(std::string_view cause) const {
    const auto at = std::ranges::find(whatIf.knobs(), cause, &Knob::cause);
    if (at == whatIf.knobs().end()) throw std::runtime_error("no knob " + std::string(cause));
    return static_cast<std::size_t>(at - whatIf.knobs().begin());
  }
  WhatIfState with(std::string_view cause, double size) const {
    std::vector<double> positions(whatIf.knobs().size(), 0.0);
    positions[knobOf(cause)] = size / whatIf.knobs()[knobOf(cause)].scale;
    return whatIf.at(positions);
  }
  std::string alike(const WhatIfState& state) const {
    return state.lookAlike ? whatIf.knobs()[state.lookAlike->knob].cause : std::string();
  }
};

Taught taught(const char* name) {
  const std::filesystem::path file = std::filesystem::path(HEFT_SOURCE_DIR) / "resources/lessons" / name;
  const auto lesson = parseLesson(readTextFile(file).value(), name);
  if (!lesson) throw std::runtime_error(lesson.error().message);
  const auto made = lessonRecording(*lesson);
  if (!made) throw std::runtime_error(made.error().message);
  auto whatIf = WhatIf::make(made->recording, {std::shared_ptr<void>(), &RobotModel::panda()},
                             {{0.0, lesson->options.duration, MarkLabel::free, ""}});
  if (!whatIf) throw std::runtime_error(whatIf.error().message);
  WhatIfState calm = whatIf->at(std::vector<double>(whatIf->knobs().size(), 0.0));
  return {*lesson, std::move(*whatIf), std::move(calm)};
}

TEST(Lessons, EachIsInBothLanguagesAndItsSlidersExist) {
  int lessons = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(HEFT_SOURCE_DIR) / "resources/lessons")) {
    if (entry.path().extension() != ".json") continue;
    ++lessons;
    const Taught t = taught(entry.path().filename().c_str());
    const auto both = [&](const LessonText& text) { EXPECT_NE(text.in("en"), text.in("de")) << entry.path(); };
    both(t.lesson.title);
    both(t.lesson.question);
    for (const auto& step : t.lesson.steps) {
      both(step.say);
      for (const auto& cause : step.sliders) EXPECT_NO_THROW(t.knobOf(cause)) << entry.path();
      for (const auto& [cause, size] : step.faults) EXPECT_LE(size, t.whatIf.knobs()[t.knobOf(cause)].scale);
    }
    for (const auto& answer : t.lesson.answers) {
      both(answer.say);
      both(answer.because);
    }
  }
  EXPECT_EQ(lessons, 6);
}

TEST(Lessons, GravityWeighsHalfOfALoadThatCameHalfway) {
  const Taught t = taught("1-gravity-weighs.json");
  const WhatIfState state = t.with("payload_change", 100.0);
  const double rise = state.payload.mass - t.calm.payload.mass;
  EXPECT_GT(rise, 0.03);
  EXPECT_LT(rise, 0.06);
  EXPECT_TRUE(state.seen);
}

TEST(Lessons, ATorqueChannelMovesTheCentreAndLeavesTheMass) {
  const Taught t = taught("2-turning-tells-the-centre.json");
  ASSERT_TRUE(t.whatIf.knobs()[t.knobOf("gain_error")].parameter.starts_with("gain_t"));
  const WhatIfState state = t.with("gain_error", 6.0);
  EXPECT_LT(std::abs(state.moved(0)), 1.96);
  EXPECT_GT(state.moved.segment<3>(1).cwiseAbs().maxCoeff(), 10.0);
  EXPECT_GT(state.moved.segment<3>(1).cwiseAbs().maxCoeff(), state.moved.tail<6>().cwiseAbs().maxCoeff());
}

TEST(Lessons, SlowMotionTellsTheInertiaWorst) {
  const Taught t = taught("3-acceleration-tells-the-inertia.json");
  const Vector10d is = componentsOf(t.calm.payload), std = componentsOf(t.calm.std);
  EXPECT_LT(1.96 * std(0), 0.005 * is(0));
  EXPECT_LT(1.96 * std.segment<3>(1).maxCoeff(), 0.001);
  EXPECT_GT(1.96 * std(4), 0.2 * is(4));
}

TEST(Lessons, ALoadLooksLikeAZeroThatJumpsWhereNothingTurns) {
  const Taught t = taught("4-bias-against-load.json");
  const WhatIfState state = t.with("payload_change", 100.0);
  EXPECT_EQ(t.alike(state), "sensor_bias");
  EXPECT_GT(state.lookAlike->share, 0.8);
}

TEST(Lessons, LateAndFilteredAreAlmostOne) {
  const Taught t = taught("5-late-against-filtered.json");
  const WhatIfState state = t.with("time_offset", 15.0);
  EXPECT_EQ(t.alike(state), "low_pass_lag");
  EXPECT_GT(state.lookAlike->share, 0.95);
}

TEST(Lessons, ASensorRotatedAboutTheLastJointIsItsZero) {
  const Taught t = taught("6-what-no-motion-can-tell.json");
  const WhatIfState state = t.with("sensor_rotation", 3.0);
  EXPECT_EQ(t.alike(state), "joint_offset");
  EXPECT_GT(state.lookAlike->share, 0.99);
  EXPECT_EQ(t.whatIf.knobs()[t.knobOf("joint_offset")].parameter, "q7_offset");
}

/// Not even half a turn of the last joint, which decides against other rivals: what a sensor feels with a wrong zero of
/// that joint is what a sensor feels that is rotated by as much, at every instant.
TEST(Lessons, NoTurnOfTheLastJointTellsItsZeroFromARotatedSensor) {
  const RobotModel& panda = RobotModel::panda();
  SimulateOptions options;
  options.motion = MotionKind::excitation;
  options.duration = 12.0;
  options.rateHz = 200.0;
  options.seed = 9;
  Recording recording =
      simulate(panda, test::boxPayload(0.75, {0.05, 0.06, 0.09}, {0.0, 0.0, 0.06}), options)->recording;
  const double end = recording.time(recording.rows() - 1), offset = 3.0 * std::numbers::pi / 180.0;
  recording.dq.resize(0, 0);
  for (Eigen::Index k = 0; k < recording.rows(); ++k)
    recording.q(k, 6) += std::numbers::pi * std::pow(std::sin(0.5 * std::numbers::pi * recording.time(k) / end), 2);
  Recording wrongZero = recording;
  wrongZero.q.col(6).array() += offset;
  const auto is = motionOf(recording, &panda, {}), seems = motionOf(wrongZero, &panda, {});
  ASSERT_TRUE(is && seems);
  ASSERT_GT(recording.q.col(6).maxCoeff() - recording.q.col(6).minCoeff(), 3.0);
  const Matrix3d turned = Eigen::AngleAxisd(offset, Vector3d::UnitZ()).toRotationMatrix().transpose();
  EXPECT_LT((turned * is->specificForce - seems->specificForce).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((turned * is->omega - seems->omega).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((turned * is->alpha - seems->alpha).cwiseAbs().maxCoeff(), 1e-9);
  for (const char* cause : {"sensor_rotation", "joint_offset"})
    EXPECT_NE(causeDecides(cause).find("No motion distinguishes"), std::string::npos) << cause;
}

}  // namespace
}  // namespace heft
