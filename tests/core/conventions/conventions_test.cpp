// A few fixed recordings of tests/benchmarks/conventions_study, and what holds for any.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "core/conventions/check.h"
#include "core/simulation/effects/effect.h"
#include "core/simulation/simulate.h"
#include "tests/support/as_driver.h"
#include "tests/support/random_tool.h"

namespace heft::conventions {
namespace {

Payload toolOf(std::uint64_t seed) {
  std::mt19937 random(static_cast<std::mt19937::result_type>(seed));
  return test::randomTool(random).payload;
}

Recording guided(const Payload& payload, std::uint64_t seed, const Vector3d& gravity = {0.0, 0.0, -9.81},
                 MotionKind kind = MotionKind::free, std::vector<EffectRequest> effects = {}) {
  SimulateOptions options;
  options.motion = kind;
  options.seed = seed;
  options.duration = 12.0;
  options.rateHz = 250.0;
  options.speed = 0.8;
  options.gravity = gravity;
  options.effects = std::move(effects);
  options.sensor.forceRange.setConstant(1e3);
  options.sensor.torqueRange = 100.0;
  auto simulated = simulate(RobotModel::panda(), payload, options);
  EXPECT_TRUE(simulated.ok());
  simulated->recording.meta.gravity = {0.0, 0.0, -9.81};
  return simulated->recording;
}

Motion motionFrom(const Recording& recording) {
  const RobotModel& robot = RobotModel::panda();
  const bool poses = recording.meta.kind == RecordingKind::poses;
  auto motion = poses ? standingPoses(recording, &robot) : motionOf(recording, &robot, MotionOptions{});
  EXPECT_TRUE(motion.ok());
  return std::move(*motion);
}

Report checkOf(const Recording& recording) {
  const Motion motion = motionFrom(recording);
  return check(questionOf(recording, motion));
}

void expectPayload(const Payload& found, const Payload& truth, const std::string& what) {
  EXPECT_NEAR(found.mass, truth.mass, 0.02 * truth.mass) << what;
  EXPECT_LT((found.com - truth.com).norm(), 0.003) << what;
}

TEST(Conventions, PlainRecordingsAreAsStated) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Payload payload = toolOf(seed);
    for (const MotionKind kind : {MotionKind::free, MotionKind::excitation, MotionKind::pickAndPlace}) {
      const Report report = checkOf(guided(payload, seed, {0.0, 0.0, -9.81}, kind));
      EXPECT_EQ(report.verdict, Verdict::asStated);
      EXPECT_FALSE(report.suggested);
      expectPayload(report.payload, payload, "plain");
    }
    const Report poses = checkOf(test::standingRecording(payload, 24, {0.0, 0.0, -9.81}, 1.0, seed));
    EXPECT_EQ(poses.verdict, Verdict::asStated);
  }
}

/// What a dead channel holds is no misfit; of other conventions nothing is said, but for a sign that cannot be.
TEST(Conventions, SilentChannelsAreNotCounted) {
  const std::vector<std::vector<Eigen::Index>> silenced{{5}, {2}, {3, 5}, {3, 4, 5}, {0, 1}};
  for (const std::uint64_t seed : {6, 7}) {
    const Payload payload = toolOf(seed);
    const Recording plain = guided(payload, seed);
    for (const auto& channels : silenced) {
      Recording recording = plain;
      for (const Eigen::Index c : channels) recording.wrench.col(c).setConstant(0.5);
      const Report report = checkOf(recording);
      EXPECT_EQ(report.verdict, Verdict::asStated);
      EXPECT_TRUE(report.ties.empty());
      EXPECT_LT(report.statedMisfit.worst(), 2.0 * kFits);  // Of fewer channels; counted they leave 0.8
      EXPECT_NEAR(report.payload.mass, payload.mass, 0.02 * payload.mass);
      recording.wrench *= -1.0;
      EXPECT_EQ(checkOf(recording).verdict, Verdict::none);
    }
  }
}

/// Forces then have another first moment than torques, as with a wrong ratio of their units.
TEST(Conventions, ASensorBesideItsPlaceIsNoUnit) {
  for (const std::uint64_t seed : {1, 2, 3, 4})
    for (const double millimetres : {60.0, 120.0}) {
      const Report report = checkOf(
          guided(toolOf(seed), seed, {0.0, 0.0, -9.81}, MotionKind::free, {{"lever_arm", "offset", millimetres}}));
      EXPECT_EQ(report.verdict, Verdict::asStated) << seed << ": " << report.sentence;
    }
}

TEST(Conventions, EachIsFoundInAMotion) {
  const std::uint64_t seed = 5;
  const Payload payload = toolOf(seed);
  const Recording plain = guided(payload, seed);
  for (const std::string& name : test::driverNames()) {
    Recording recording = plain;
    test::rewriteAs(name, RobotModel::panda(), seed, recording);
    const Report report = checkOf(recording);
    // N cm and kgf cm differ by the scale of the mass alone.
    const bool scale = name == "N_cm" || name == "kgf_cm";
    EXPECT_EQ(report.verdict, scale ? Verdict::ambiguous : Verdict::suggested) << name;
    // A point is known as well as the readings tell, and the centre with it.
    if (name == "tip_point")
      EXPECT_LT((report.payload.com - payload.com).norm(), 3.0 * centreStd(report.payload, report.covariance));
    else if (!scale)
      expectPayload(report.payload, payload, name);
    EXPECT_FALSE(report.sentence.empty()) << name;
    EXPECT_FALSE(report.check.empty()) << name;
  }
}

TEST(Conventions, EachIsFoundInPoses) {
  const std::uint64_t seed = 6;
  const Payload payload = toolOf(seed);
  for (const std::string& name : test::driverNames()) {
    Recording recording = test::standingRecording(payload, 24, {0.0, 0.0, -9.81}, 1.0, seed);
    test::rewriteAs(name, RobotModel::panda(), seed, recording);
    const Report report = checkOf(recording);
    if (name == "torque_sign" || name == "tip_point" || name == "lbf_ft") {
      // Neither can be told from a centre elsewhere.
      EXPECT_TRUE(!report.cautions.empty() || !report.ties.empty()) << name;
    } else if (name == "N_mm" || name == "N_cm" || name == "lbf_in" || name == "kgf_cm") {
      EXPECT_EQ(report.verdict, Verdict::ambiguous) << name;
    } else {
      EXPECT_EQ(report.verdict, Verdict::suggested) << name;
      expectPayload(report.payload, payload, name);
    }
  }
}

TEST(Conventions, BaseOnAWallOrUnderTheCeiling) {
  const Payload payload = toolOf(7);
  for (const Vector3d& gravity : {Vector3d(9.81, 0, 0), Vector3d(0, -9.81, 0), Vector3d(0, 0, 9.81)}) {
    const Report report = checkOf(guided(payload, 7, gravity));
    ASSERT_EQ(report.verdict, Verdict::suggested);
    EXPECT_LT((report.suggested->gravity - gravity).norm(), 1e-6);
    expectPayload(report.payload, payload, "gravity");
  }
}

TEST(Conventions, TwoAtOnce) {
  const Payload payload = toolOf(8);
  const Recording plain = guided(payload, 8);
  for (const char* name : {"base_axes+torque_sign", "lbf_in+torque_first", "mirror_y+base_axes", "base_axes+w_first",
                           "turned_any+torque_first", "N_mm+pose_inverted"}) {
    Recording recording = plain;
    test::rewriteAs(name, RobotModel::panda(), 8, recording);
    const Report report = checkOf(recording);
    EXPECT_EQ(report.verdict, Verdict::suggested) << name;
    expectPayload(report.payload, payload, name);
  }
}

TEST(Conventions, PushesHideNone) {
  const Payload payload = toolOf(9);
  const std::vector<EffectRequest> pushes{
      {"contact", "push", 15.0}, {"contact", "hands", 15.0}, {"contact", "push", 15.0}};
  const Recording plain = guided(payload, 9, {0.0, 0.0, -9.81}, MotionKind::free, pushes);
  EXPECT_EQ(checkOf(plain).verdict, Verdict::asStated);
  for (const char* name : {"base_axes", "torque_sign", "mirror_x", "turned_45"}) {
    Recording recording = plain;
    test::rewriteAs(name, RobotModel::panda(), 9, recording);
    const Report report = checkOf(recording);
    EXPECT_EQ(report.verdict, Verdict::suggested) << name;
    expectPayload(report.payload, payload, name);
  }
}

TEST(Conventions, CausesAreNone) {
  const Payload payload = toolOf(10);
  const std::vector<EffectRequest> causes{
      {"gravity_tilt", "tilt", 5.0}, {"sensor_rotation", "any-axis", 5.0}, {"lever_arm", "offset", 40.0},
      {"gain_error", "axis", 20.0},  {"cable_pull", "linear", 6.0},        {"time_offset", "constant", 20.0},
      {"bias_drift", "", 1.0},       {"viscous_drag", "linear", 2.0},      {"payload_change", "step", 120.0}};
  for (EffectRequest cause : causes) {
    if (cause.form.empty()) cause.form = findEffectKind(cause.id)->forms.front();
    const Report report = checkOf(guided(payload, 10, {0.0, 0.0, -9.81}, MotionKind::free, {cause}));
    EXPECT_EQ(report.verdict, Verdict::asStated) << cause.id;
    EXPECT_FALSE(report.suggested) << cause.id;
  }
}

// A torque about another point and a sensor beside its place are the same readings: it is the point where the sensor
// would put the centre into the arm, and a cause for the diagnosis otherwise.
TEST(Conventions, ACentreInTheArmDecidesBetweenAPointAndAPlace) {
  const Payload payload = toolOf(13);
  const Recording plain = guided(payload, 13);
  for (const double beyond : {0.03, -0.03}) {
    Recording recording = plain;
    const Vector3d point(0.0, 0.0, payload.com.z() + beyond);
    for (Eigen::Index k = 0; k < recording.rows(); ++k) {
      const Vector3d force = recording.wrench.row(k).head<3>().transpose();
      recording.wrench.row(k).tail<3>() -= point.cross(force).transpose();
    }
    const Report report = checkOf(recording);
    EXPECT_EQ(report.verdict, beyond > 0.0 ? Verdict::suggested : Verdict::asStated) << beyond;
    if (beyond < 0.0) continue;
    EXPECT_LT((report.suggested->conventions.wrenchPoint.offset - point).norm(), 0.01);
    EXPECT_GT(report.fromFree.diagonal().segment<3>(1).minCoeff(), 0.0);
  }
}

// What the suggestion says, applied in memory, makes a recording that is as stated.
TEST(Conventions, AppliedInMemory) {
  const Payload payload = toolOf(11);
  const Recording plain = guided(payload, 11);
  for (const std::string& name : test::driverNames()) {
    if (name == "N_cm" || name == "kgf_cm") continue;
    Recording recording = plain;
    test::rewriteAs(name, RobotModel::panda(), 11, recording);
    const Motion motion = motionFrom(recording);
    Question q = questionOf(recording, motion);
    const Report report = check(q);
    ASSERT_TRUE(report.suggested) << name;
    const Motion right = readSo(motion, q.stated, *report.suggested, q.posesInFile);
    Question again = q;
    again.motion = &right;
    again.stated = *report.suggested;
    const Report then = check(again);
    EXPECT_EQ(then.verdict, Verdict::asStated) << name << ": " << then.sentence;
    expectPayload(then.payload, payload, name);
  }
}

// What was stated and undone is put in again before others are tried: the suggestion replaces it.
TEST(Conventions, WronglyStated) {
  const Payload payload = toolOf(12);
  const Recording plain = guided(payload, 12);
  const Motion motion = motionFrom(plain);
  Reading file;  // The file is plain, but stated as base axes, torque first, in pounds.
  Reading stated;
  stated.conventions.wrenchAxes = Conventions::WrenchAxes::base;
  stated.conventions.wrenchOrder = Conventions::WrenchOrder::torqueFirst;
  stated.conventions.force = {"lbf", 4.4482216152605};
  stated.conventions.torque = {"lbf in", 0.112984829};
  const Motion read = readSo(motion, file, stated, false);
  Question q = questionOf(plain, read);
  q.stated = stated;
  const Report report = check(q);
  ASSERT_EQ(report.verdict, Verdict::suggested);
  EXPECT_EQ(report.suggested->conventions.wrenchAxes, Conventions::WrenchAxes::sensor);
  EXPECT_EQ(report.suggested->conventions.wrenchOrder, Conventions::WrenchOrder::forceFirst);
  EXPECT_DOUBLE_EQ(report.suggested->conventions.force.si, 1.0);
  const auto patch = metaPatch(stated, *report.suggested, plain.meta.mount, true);
  EXPECT_EQ(patch["sensor"]["wrench_axes"], "sensor");
  EXPECT_EQ(patch["sensor"]["wrench_order"], "force_first");
  EXPECT_EQ(patch["sensor"]["force_unit"], "N");
  EXPECT_EQ(patch["sensor"]["torque_unit"], "N m");
  expectPayload(report.payload, payload, "wrongly stated");
  // Rightly stated, nothing is to be said.
  Recording pounds = plain;
  test::rewriteAs("base_axes+lbf_in", RobotModel::panda(), 12, pounds);
  const Motion asRead = motionFrom(pounds);
  Reading right = stated;
  right.conventions.wrenchOrder = Conventions::WrenchOrder::forceFirst;
  const Motion undone = readSo(asRead, file, right, false);
  Question other = questionOf(pounds, undone);
  other.stated = right;
  EXPECT_EQ(check(other).verdict, Verdict::asStated);
}

TEST(Conventions, ReadingBackAndForth) {
  const Payload payload = toolOf(13);
  Recording recording = guided(payload, 13);
  test::logPoses(RobotModel::panda(), recording);
  const Motion motion = motionFrom(recording);
  Reading plain, odd;
  odd.conventions.wrenchAxes = Conventions::WrenchAxes::base;
  odd.conventions.wrenchPoint = {Conventions::WrenchPoint::Kind::offset, {0.01, 0.02, 0.03}};
  odd.conventions.mirroredAxis = 1;
  odd.conventions.torqueSign = Conventions::TorqueSign::opposite;
  odd.conventions.wrenchOrder = Conventions::WrenchOrder::torqueFirst;
  odd.conventions.pose = Conventions::PoseDirection::baseInSensor;
  odd.conventions.quaternionOrder = Conventions::QuaternionOrder::wxyz;
  odd.sign = WrenchSign::payloadOnSensor;
  odd.gravity = {0.0, 9.81, 0.0};
  odd.turn = rotationFromVector({0.3, 0.2, -1.0});
  const Motion back = readSo(readSo(motion, plain, odd, true), odd, plain, true);
  EXPECT_LT((back.wrench - motion.wrench).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((back.position - motion.position).cwiseAbs().maxCoeff(), 1e-9);
  for (std::size_t k = 0; k < motion.R_BS.size(); k += 50)
    EXPECT_LT((back.R_BS[k] - motion.R_BS[k]).cwiseAbs().maxCoeff(), 1e-9);
}

// What the user marked, or a label column says, is not asked; where poses are in the file, they are the motion.
TEST(Conventions, TheQuestionLeavesOutWhatIsMarked) {
  Recording recording = guided(toolOf(15), 15);
  const Motion motion = motionFrom(recording);
  EXPECT_TRUE(questionOf(recording, motion).use.empty());
  EXPECT_FALSE(questionOf(recording, motion).posesInFile);
  recording.meta.marks.push_back({2.0, 4.0, MarkLabel::contact});
  const auto marked = questionOf(recording, motion);
  ASSERT_EQ(marked.use.size(), static_cast<std::size_t>(motion.size()));
  const auto at = [&](double time) {
    return static_cast<std::size_t>(std::lround((time - motion.startTime) * motion.rateHz));
  };
  EXPECT_TRUE(marked.use[at(1.0)]);
  EXPECT_FALSE(marked.use[at(3.0)]);
  EXPECT_TRUE(marked.use[at(5.0)]);
  recording.meta.marks.clear();
  recording.labels.assign(static_cast<std::size_t>(recording.rows()), MarkLabel::free);
  for (Eigen::Index k = 0; k < recording.rows(); ++k)
    if (recording.time(k) > 6.0) recording.labels[static_cast<std::size_t>(k)] = MarkLabel::contact;
  const auto labelled = questionOf(recording, motion);
  EXPECT_TRUE(labelled.use[at(3.0)]);
  EXPECT_FALSE(labelled.use[at(7.0)]);
  Recording both = guided(toolOf(15), 15);
  const MatrixXd q = both.q;
  test::logPoses(RobotModel::panda(), both);
  both.q = q;
  EXPECT_TRUE(questionOf(both, motionFrom(both)).posesInFile);
}

// A sensor turned a little and a gain of the force bend mass and centre and leave hardly a trace: they are said.
TEST(Conventions, ASmallTurnAndAGainAreSaid) {
  const auto said = [](const Recording& recording, const char* code) {
    const Report report = checkOf(recording);
    EXPECT_EQ(report.verdict, Verdict::asStated);
    return std::any_of(report.cautions.begin(), report.cautions.end(),
                       [&](const Finding& caution) { return caution.code == code; });
  };
  const Vector3d down(0.0, 0.0, -9.81);
  for (const std::uint64_t seed : {17, 18, 19}) {
    const Payload payload = toolOf(seed);
    const Recording plain = guided(payload, seed, down, MotionKind::excitation);
    EXPECT_FALSE(said(plain, "sensor_turned")) << seed;
    EXPECT_FALSE(said(plain, "force_and_torque")) << seed;
    const Matrix3d turn = rotationFromVector(Vector3d(0.02, -0.02, 0.02));  // 2 degrees
    Recording turned = plain;
    for (const Eigen::Index from : {0, 3})
      turned.wrench.middleCols<3>(from) = (plain.wrench.middleCols<3>(from) * turn).eval();
    EXPECT_TRUE(said(turned, "sensor_turned")) << seed;
    Recording gained = plain;
    gained.wrench.leftCols<3>() *= 1.1;
    EXPECT_FALSE(said(gained, "sensor_turned")) << seed;
    // Poses show the turn and not the gain.
    const Recording poses = test::standingRecording(payload, 24, down, 1.0, seed);
    EXPECT_FALSE(said(poses, "sensor_turned")) << seed;
    Recording other = poses;
    for (const Eigen::Index from : {0, 3})
      other.wrench.middleCols<3>(from) = (poses.wrench.middleCols<3>(from) * turn).eval();
    EXPECT_TRUE(said(other, "sensor_turned")) << seed;
    other = poses;
    other.wrench.leftCols<3>() *= 1.1;
    EXPECT_FALSE(said(other, "force_and_torque")) << seed;
  }
}

// The force holds m c beside angular accelerations alone: a gain of it shows in a heavy tool that is swung.
TEST(Conventions, AGainOfTheForceIsSaidOfAHeavyTool) {
  Payload payload;
  payload.mass = 2.5;
  payload.com = {0.02, -0.01, 0.12};
  payload.inertiaCom = Vector3d(0.02, 0.02, 0.01).asDiagonal();
  const auto said = [](const Recording& recording) {
    const Report report = checkOf(recording);
    EXPECT_TRUE(report.agreement);
    return std::any_of(report.cautions.begin(), report.cautions.end(),
                       [](const Finding& caution) { return caution.code == "force_and_torque"; });
  };
  for (const std::uint64_t seed : {22, 23}) {
    Recording recording = guided(payload, seed, {0.0, 0.0, -9.81}, MotionKind::excitation);
    EXPECT_FALSE(said(recording)) << seed;
    recording.wrench.leftCols<3>() *= 1.15;
    EXPECT_TRUE(said(recording)) << seed;
    recording.wrench.rightCols<3>() *= 1.15;
    EXPECT_FALSE(said(recording)) << seed << ": both alike are a heavier tool";
  }
}

// All signs of standing poses turned: the driver's sign, before a robot that hangs.
TEST(Conventions, PosesWithTheOtherSignAreThat) {
  for (const std::uint64_t seed : {20, 21}) {
    Recording recording = test::standingRecording(toolOf(seed), 24, {0.0, 0.0, -9.81}, 1.0, seed);
    for (const char* name : {"wrench_sign", "base_axes+wrench_sign"}) {
      Recording other = recording;
      test::rewriteAs(name, RobotModel::panda(), seed, other);
      const Report report = checkOf(other);
      ASSERT_TRUE(report.suggested) << name;
      EXPECT_EQ(report.suggested->sign, WrenchSign::payloadOnSensor) << name;
      EXPECT_EQ(report.suggested->gravity, Vector3d(0.0, 0.0, -9.81)) << name;
    }
  }
}

// Standing poses cannot tell the torque's sign from a centre in the arm, however the sensor is turned: both are told.
TEST(Conventions, TurnedPosesWithTheOtherTorqueSignAreATie) {
  for (const std::uint64_t seed : {22, 23, 24, 25}) {
    const Payload payload = toolOf(seed);
    Recording recording = test::standingRecording(payload, 24, {0.0, 0.0, -9.81}, 1.0, seed);
    test::rewriteAs("turned_any+torque_sign", RobotModel::panda(), seed, recording);
    const Report report = checkOf(recording);
    EXPECT_EQ(report.verdict, Verdict::ambiguous) << seed;
    const auto right = [&](const Payload& found) { return (found.com - payload.com).norm() < 0.003; };
    EXPECT_TRUE(right(report.payload) || std::any_of(report.ties.begin(), report.ties.end(),
                                                     [&](const Alternative& tie) { return right(tie.payload); }))
        << seed;
  }
}

// How the sensor is turned is known as well as the readings tell: a slow motion says so, a brisk one has no need to.
TEST(Conventions, AFreeTurnIsAsSureAsItsReadings) {
  const auto isUnsure = [](const Report& report) {
    return std::any_of(report.cautions.begin(), report.cautions.end(),
                       [](const Finding& caution) { return caution.code == "turn_unsure"; });
  };
  const Payload payload = toolOf(26);
  Recording brisk = guided(payload, 26), slow;
  SimulateOptions options;
  options.motion = MotionKind::free;
  options.seed = 26;
  options.duration = 5.0;
  options.rateHz = 250.0;
  options.speed = 0.1;
  slow = std::move(simulate(RobotModel::panda(), payload, options)->recording);
  for (Recording* recording : {&brisk, &slow}) test::rewriteAs("turned_any", RobotModel::panda(), 26, *recording);
  const Report ofBrisk = checkOf(brisk), ofSlow = checkOf(slow);
  ASSERT_EQ(ofBrisk.verdict, Verdict::suggested);
  ASSERT_EQ(ofSlow.verdict, Verdict::suggested);
  EXPECT_GT(ofBrisk.turnStd, 0.0);
  EXPECT_GT(ofSlow.turnStd, 5.0 * ofBrisk.turnStd);
  EXPECT_FALSE(isUnsure(ofBrisk));
  EXPECT_TRUE(isUnsure(ofSlow));
  // What the turn adds is part of the payload's own covariance, and never more than it.
  for (const Report* report : {&ofBrisk, &ofSlow})
    EXPECT_TRUE((report->covariance.diagonal().array() >= report->fromFree.diagonal().array()).all());
}

// What is left over falls where the reading is right, and stays where it is.
TEST(Conventions, WhatIsLeftOver) {
  const Payload payload = toolOf(16);
  Recording recording = guided(payload, 16);
  const auto sizeOf = [](const LeftOver& left) { return left.left.topRows<3>().norm(); };
  const double plain = sizeOf(leftOver(questionOf(recording, motionFrom(recording))));
  test::rewriteAs("base_axes", RobotModel::panda(), 16, recording);
  const Motion motion = motionFrom(recording);
  const Question question = questionOf(recording, motion);
  const LeftOver stated = leftOver(question);
  EXPECT_GT(sizeOf(stated), 10.0 * plain);
  const Report report = check(question);
  ASSERT_TRUE(report.suggested);
  const Motion right = readSo(motion, question.stated, *report.suggested, false);
  const LeftOver read = leftOver(questionOf(recording, right));
  EXPECT_LT(sizeOf(read), 1.2 * plain);
  EXPECT_EQ(read.time.size(), static_cast<std::size_t>(read.left.cols()));
  EXPECT_NEAR(read.mass, payload.mass, 0.02 * payload.mass);
}

TEST(Conventions, TooLittleSaysNothing) {
  const Report report = checkOf(test::standingRecording(toolOf(14), 4, {0.0, 0.0, -9.81}, 1.0, 14));
  EXPECT_FALSE(report.enough);
  EXPECT_EQ(report.verdict, Verdict::asStated);
}

}  // namespace
}  // namespace heft::conventions
