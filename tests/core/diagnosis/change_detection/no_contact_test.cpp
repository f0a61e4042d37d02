// What looks like contact, or like nothing, and is something else.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <tuple>

#include "core/diagnosis/change_detection/knocks.h"
#include "core/diagnosis/change_detection/segment_correlates.h"
#include "core/motion/motion.h"
#include "core/robot/robot_model.h"
#include "core/wrench/regressor.h"
#include "tests/core/diagnosis/fixture.h"

namespace heft::test {
namespace {

/// Adds `amplitude(t)` to force x and a tenth of a metre times it to torque y.
template <class Amplitude>
void push(Recording& recording, const Amplitude& amplitude) {
  for (Eigen::Index i = 0; i < recording.rows(); ++i) {
    recording.wrench(i, 0) += amplitude(recording.time(i));
    recording.wrench(i, 4) += 0.1 * amplitude(recording.time(i));
  }
}

/// A hose of 12 N/m that is slack for half of the way: fixed 0.5 m beside the middle of it, in the world.
TEST(NoContact, ASlackHoseIsOne) {
  Recording recording = aRecording(MotionKind::free, 301);
  const auto motion = motionOf(recording, &RobotModel::panda(), {}).value();
  const Vector3d middle = motion.position.rowwise().mean(), anchor = middle + Vector3d(0.3, -0.4, 0.0);
  std::vector<double> far;
  for (Eigen::Index k = 0; k < motion.size(); ++k) far.push_back((motion.position.col(k) - anchor).norm());
  std::vector<double> sorted = far;
  std::ranges::sort(sorted);
  const double length = sorted[sorted.size() / 2];
  for (Eigen::Index i = 0; i < recording.rows(); ++i) {
    const Eigen::Index k = sampleAt(motion, recording.time(i));
    const double stretch = far[static_cast<std::size_t>(k)] - length;
    if (stretch <= 0.0) continue;
    const Vector3d way = (motion.position.col(k) - anchor).normalized();
    recording.wrench.row(i).head<3>() +=
        (motion.R_BS[static_cast<std::size_t>(k)].transpose() * (12.0 * stretch * way)).transpose();
  }
  const auto report = diagnosed(recording);
  ASSERT_EQ(report.causes.size(), 1u) << said(report);
  const DiagnosedCause* cable = named(report, "cable_pull");
  ASSERT_NE(cable, nullptr) << said(report);
  ASSERT_NE(findParameter(cable->parameters, "anchor_x"), nullptr);
  for (int axis = 0; axis < 3; ++axis) {
    const CauseParameter* at = findParameter(cable->parameters, std::string("anchor_") + "xyz"[axis]);
    EXPECT_NEAR(at->value, 1e3 * anchor(axis), 4.0 * at->std + 5.0) << at->name;
  }
  EXPECT_NEAR(findParameter(cable->parameters, "stiffness")->value, 12.0,
              4.0 * findParameter(cable->parameters, "stiffness")->std);
}

/// A taut rope of rubber on 120 mm of hook: a spring towards one spot would be too soft, and different to each side.
TEST(NoContact, ATautCableHasALength) {
  Recording recording = aRecording(MotionKind::free, 308);
  const auto motion = motionOf(recording, &RobotModel::panda(), {}).value();
  const Vector3d anchor = Vector3d(motion.position.rowwise().mean()) + Vector3d(0.3, 0.5, 0.4);
  for (Eigen::Index i = 0; i < recording.rows(); ++i) {
    const Eigen::Index k = sampleAt(motion, recording.time(i));
    const Vector3d way = motion.position.col(k) - anchor;
    const Vector3d held = 8.0 * (way.norm() - 0.12) * way.normalized();
    recording.wrench.row(i).head<3>() += (motion.R_BS[static_cast<std::size_t>(k)].transpose() * held).transpose();
  }
  const auto report = diagnosed(recording);
  ASSERT_EQ(report.causes.size(), 1u) << said(report);
  const DiagnosedCause* cable = named(report, "cable_pull");
  ASSERT_NE(cable, nullptr) << said(report);
  ASSERT_NE(findParameter(cable->parameters, "length"), nullptr) << said(report);
  EXPECT_NEAR(findParameter(cable->parameters, "length")->value, 120.0,
              4.0 * findParameter(cable->parameters, "length")->std + 2.0);
  EXPECT_NEAR(findParameter(cable->parameters, "stiffness")->value, 8.0,
              4.0 * findParameter(cable->parameters, "stiffness")->std + 0.05);
  for (int axis = 0; axis < 3; ++axis) {
    const CauseParameter* at = findParameter(cable->parameters, std::string("anchor_") + "xyz"[axis]);
    EXPECT_NEAR(at->value, 1e3 * anchor(axis), 4.0 * at->std + 5.0) << at->name;
  }
}

TEST(NoContact, BurstsOfInterferenceAreUnknown) {
  Recording recording = aRecording(MotionKind::free, 302);
  push(recording, [](double t) {
    for (const double from : {3.0, 5.5, 8.5})
      if (t > from && t < from + 0.6) return std::sin(2.0 * std::numbers::pi * 15.0 * t) > 0.0 ? 0.7 : -0.7;
    return 0.0;
  });
  const auto report = diagnosed(recording);
  EXPECT_EQ(report.verdict, Verdict::unexplained) << said(report);
  EXPECT_EQ(report.remaining.goesWith, "noise that comes and goes");
  EXPECT_EQ(named(report, "contact"), nullptr) << said(report);
}

/// The current of a motor disturbs the sensor's cable while it speeds up and slows down; the arm goes from place to
/// place and touches nothing.
TEST(NoContact, AMotorThatDisturbsIsUnknown) {
  Recording recording = aRecording(MotionKind::pickAndPlace, 309);
  const auto motion = motionOf(recording, &RobotModel::panda(), {}).value();
  Vector6d size, noise;
  size << 0.8, 0.5, -1.2, -0.01, -0.02, 0.003;
  noise << 0.04, 0.04, 0.06, 0.002, 0.002, 0.002;
  const Eigen::ArrayXd hard = motion.ddq.row(4).array().abs() / motion.ddq.row(4).array().abs().maxCoeff();
  std::mt19937 random(309);
  std::normal_distribution<double> normal;
  for (Eigen::Index i = 0; i < recording.rows(); ++i) {
    const auto k = sampleAt(motion, recording.time(i));
    const Vector6d load =
        predictWrench(aTool(), {motion.specificForce.col(k), motion.omega.col(k), motion.alpha.col(k)});
    recording.wrench.row(i) =
        (load + hard(k) * size + noise.cwiseProduct(Vector6d::NullaryExpr([&] { return normal(random); }))).transpose();
  }
  const auto report = diagnosed(recording);
  EXPECT_EQ(report.verdict, Verdict::unexplained) << said(report);
  EXPECT_EQ(named(report, "contact"), nullptr) << said(report);
  EXPECT_EQ(report.remaining.goesWith, "the motor of joint 5") << said(report);
}

/// Strain wave gears let two joints lead and lag by 0.007 degrees, 50 times a turn: too fast to look like anything but
/// noise.
TEST(NoContact, GearsThatTurnUnevenlyAreUnknown) {
  Recording recording = aRecording(MotionKind::excitation, 307);
  for (const Eigen::Index joint : {3, 5}) {
    const Eigen::ArrayXd angle = 50.0 * recording.q.col(joint).array();
    recording.q.col(joint).array() += 1.2e-4 * angle.sin();
    if (recording.dq.rows() > 0) recording.dq.col(joint).array() *= 1.0 + 50.0 * 1.2e-4 * angle.cos();
  }
  const auto report = diagnosed(recording);
  EXPECT_EQ(report.verdict, Verdict::unexplained) << said(report);
  EXPECT_EQ(report.remaining.goesWith, "the joint angles, several times a turn") << said(report);
  EXPECT_TRUE(report.causes.empty()) << said(report);
}

/// A part with play knocks at its place whenever the tool has turned far enough. It was clean, or a load that changes
/// by nothing.
TEST(NoContact, APartThatKnocksIsUnknown) {
  Recording recording = aRecording(MotionKind::free, 310);
  push(recording, [](double t) {
    for (const double at : {2.1, 4.3, 6.0, 8.2, 10.4})
      if (t > at && t < at + 0.05)
        return 1.2 * std::exp((at - t) / 0.01) * std::sin(2.0 * std::numbers::pi * 55.0 * (t - at));
    return 0.0;
  });
  const auto report = diagnosed(recording);
  EXPECT_EQ(report.verdict, Verdict::unexplained) << said(report);
  EXPECT_EQ(report.remaining.goesWith, "short knocks") << said(report);
  EXPECT_TRUE(finds(report, "knocks"));
  EXPECT_TRUE(report.causes.empty()) << said(report);
}

/// The sensor's driver tares now and then. Between the first time and the last one nothing fits the rest of the
/// recording: it was a touch of half of it, or a walk.
TEST(NoContact, AZeroTakenAgainAndAgainIsNone) {
  Recording recording = aRecording(MotionKind::free, 316);
  const std::array<double, 3> times{2.9, 5.6, 8.4};
  Eigen::Matrix<double, 3, 6> jumps;
  jumps << 5.0, -7.0, 3.0, 0.3, -0.2, 0.1, -4.0, 6.0, 2.0, -0.1, 0.3, 0.05, 2.0, 3.0, -6.0, 0.2, 0.1, -0.2;
  for (Eigen::Index i = 0; i < recording.rows(); ++i)
    for (Eigen::Index j = 0; j < 3; ++j)
      if (recording.time(i) >= times[static_cast<std::size_t>(j)]) recording.wrench.row(i) += jumps.row(j);
  const auto report = diagnosed(recording);
  ASSERT_EQ(report.causes.size(), 1u) << said(report);
  EXPECT_EQ(report.causes.front().id, "sensor_bias") << said(report);
  for (const auto& [name, truth] : {std::pair{"time", times[0]}, {"time_2", times[1]}, {"time_3", times[2]}}) {
    const auto* at = findParameter(report.causes.front().parameters, name);
    ASSERT_NE(at, nullptr) << name << ": " << said(report);
    EXPECT_NEAR(at->value, truth, 0.02) << name;
  }
  EXPECT_NEAR(report.after.payload.mass, aTool().mass, 0.012) << said(report);
}

/// A loose wire takes one channel to another level for 0.8 s: whatever pushed the tool would turn the sensor, too.
TEST(NoContact, OneChannelThatJumpsIsUnknown) {
  Recording recording = aRecording(MotionKind::free, 317);
  for (Eigen::Index i = 0; i < recording.rows(); ++i)
    if (recording.time(i) > 5.0 && recording.time(i) < 5.8) recording.wrench(i, 1) -= 6.0;
  const auto report = diagnosed(recording);
  EXPECT_EQ(report.verdict, Verdict::unexplained) << said(report);
  EXPECT_EQ(report.remaining.goesWith, "one channel of the sensor alone") << said(report);
  EXPECT_EQ(named(report, "contact"), nullptr) << said(report);
}

/// A motor that spins inside the tool resists being turned: torque omega x h, which no cause of the catalogue makes.
TEST(NoContact, ASpinningRotorIsUnknown) {
  Recording recording = aRecording(MotionKind::pickAndPlace, 303);
  const auto motion = motionOf(recording, &RobotModel::panda(), {}).value();
  const Vector3d h(-0.03, 0.02, 0.05);
  for (Eigen::Index i = 0; i < recording.rows(); ++i) {
    const Eigen::Index k = sampleAt(motion, recording.time(i));
    recording.wrench.row(i).tail<3>() += Vector3d(motion.omega.col(k)).cross(h).transpose();
  }
  const auto report = diagnosed(recording);
  EXPECT_EQ(report.verdict, Verdict::unexplained) << said(report);
  EXPECT_EQ(report.remaining.goesWith, "how fast the tool turns") << said(report);
}

/// A magnet's field brakes what moves in one half of the space, by 6 N s/m: the tool is slowed, not touched.
TEST(NoContact, ABrakeInPartOfTheSpaceIsUnknown) {
  Recording recording = aRecording(MotionKind::free, 306);
  const auto motion = motionOf(recording, &RobotModel::panda(), {}).value();
  const Vector3d normal = Vector3d(0.6, -0.7, 0.3).normalized();
  const double level = normal.dot(motion.position.rowwise().mean()) + 0.03;
  for (Eigen::Index i = 0; i < recording.rows(); ++i) {
    const Eigen::Index k = sampleAt(motion, recording.time(i));
    const double inside = 0.5 * (1.0 + std::tanh((normal.dot(motion.position.col(k)) - level) / 0.005));
    recording.wrench.row(i).head<3>() +=
        (motion.R_BS[static_cast<std::size_t>(k)].transpose() * (6.0 * inside * motion.velocity.col(k))).transpose();
  }
  const auto report = diagnosed(recording);
  EXPECT_EQ(report.verdict, Verdict::unexplained) << said(report);
  EXPECT_EQ(named(report, "contact"), nullptr) << said(report);
}

TEST(NoContact, AFanIsHeardAndSoAreTheMains) {
  const auto with = [](double frequency) {
    Recording recording = aRecording(MotionKind::free, 304);
    push(recording, [&](double t) { return 0.3 * std::sin(2.0 * std::numbers::pi * frequency * t); });
    return diagnosed(recording);
  };
  const auto fan = with(31.0);
  EXPECT_EQ(fan.verdict, Verdict::unexplained) << said(fan);
  EXPECT_EQ(fan.remaining.goesWith, "a rhythm of 31 Hz");
  const auto mains = with(50.0);
  EXPECT_EQ(mains.verdict, Verdict::unexplained) << said(mains);
  EXPECT_EQ(mains.remaining.goesWith, "a rhythm of 50 Hz");
  EXPECT_TRUE(finds(mains, "readings_hum"));
  EXPECT_FALSE(finds(diagnosed(aRecording(MotionKind::free, 304)), "readings_hum"));
}

/// Two gauges at their end bend the torques that they are a part of, too: what is set aside as contact explains
/// nothing, and was contact and nothing else.
TEST(NoContact, GaugesAtTheirEndAreNotSurelyATouch) {
  Recording recording = aRecording(MotionKind::free, 304);
  for (const Eigen::Index c : {0, 2}) {
    const double low = recording.wrench.col(c).minCoeff(), end = low + 0.7 * (recording.wrench.col(c).maxCoeff() - low);
    for (Eigen::Index i = 0; i < recording.rows(); ++i) {
      const double cut = std::max(0.0, recording.wrench(i, c) - end);
      recording.wrench(i, c) -= cut;
      recording.wrench(i, 3 + c) -= 0.03 * cut;
    }
  }
  const auto report = diagnosed(recording);
  EXPECT_NE(named(report, "saturation"), nullptr) << said(report);
  if (const auto* contact = named(report, "contact")) {
    EXPECT_FALSE(contact->alternatives.empty()) << said(report);
    EXPECT_EQ(report.verdict, Verdict::ambiguous) << said(report);
  }
}

/// Somebody pressed "record" while it swung: what it does before it has come to rest is no touch.
TEST(NoContact, AMassThatSwingsFromTheStart) {
  const Recording whole = aRecording(MotionKind::free, 305, {{"loose_mass", "sprung", 120.0}});
  std::vector<Eigen::Index> kept;
  for (Eigen::Index i = 0; i < whole.rows(); ++i)
    if (whole.time(i) > 2.3) kept.push_back(i);
  const auto report = diagnosed(withRows(whole, kept));
  ASSERT_FALSE(report.causes.empty());
  EXPECT_EQ(report.causes.front().id, "loose_mass") << said(report);
  EXPECT_EQ(named(report, "contact"), nullptr) << said(report);
}

/// Two of its angles are seen first; joint 7 could make up for the third.
TEST(NoContact, AllThreeAnglesOfATurnedSensor) {
  Recording recording = aRecording(MotionKind::pickAndPlace, 306);
  const Vector3d turned = Vector3d(-1.0, 1.1, 2.0) * std::numbers::pi / 180.0;
  const Matrix3d R = Eigen::AngleAxisd(turned.norm(), turned.normalized()).toRotationMatrix();
  for (Eigen::Index i = 0; i < recording.rows(); ++i) {
    recording.wrench.row(i).head<3>() =
        (R.transpose() * recording.wrench.row(i).head<3>().transpose()).transpose().eval();
    recording.wrench.row(i).tail<3>() =
        (R.transpose() * recording.wrench.row(i).tail<3>().transpose()).transpose().eval();
  }
  const auto report = diagnosed(recording);
  const DiagnosedCause* rotation = named(report, "sensor_rotation");
  ASSERT_NE(rotation, nullptr) << said(report);
  EXPECT_EQ(named(report, "joint_offset"), nullptr) << said(report);
  for (int axis = 0; axis < 3; ++axis) {
    const CauseParameter* angle = findParameter(rotation->parameters, std::string("r") + "xyz"[axis]);
    ASSERT_NE(angle, nullptr) << said(report);
    EXPECT_NEAR(angle->value, turned(axis) * 180.0 / std::numbers::pi, 4.0 * angle->std) << angle->name;
  }
}

/// Somebody leans on the tool lightly and evenly for two seconds: two jumps of the zero were all that was named.
TEST(NoContact, ATouchThatBeginsAndEndsAtOnceIsNotSurelyTheZero) {
  Recording recording = aRecording(MotionKind::pickAndPlace, 318);
  push(recording, [](double t) { return t > 4.3 && t < 6.3 ? 0.3 : 0.0; });
  const auto report = diagnosed(recording);
  ASSERT_FALSE(report.causes.empty()) << said(report);
  const auto& others = report.causes.front().alternatives;
  EXPECT_TRUE(report.causes.front().id == "contact" || std::ranges::find(others, "contact") != others.end())
      << said(report);
}

/// What turns round from block to block: the end of what a smoothed motion shows.
TEST(NoContact, WhatRingsIsNone) {
  Recording recording = aRecording(MotionKind::free, 311);
  push(recording,
       [](double t) { return t > 6.0 && t < 6.12 ? 0.8 * std::sin(2.0 * std::numbers::pi * 24.0 * (t - 6.0)) : 0.0; });
  const auto report = diagnosed(recording);
  EXPECT_EQ(report.verdict, Verdict::clean) << said(report);
}

/// A valve that opens and closes nine times presses each time in the same way. Any one of these explains less than a
/// walk of the zero.
TEST(NoContact, WhatSwitchesAgainAndAgainIsUnknown) {
  Recording recording = aRecording(MotionKind::pickAndPlace, 312);
  push(recording, [](double t) {
    double out = 0.0;
    for (const double opens : {1.6, 3.4, 5.9, 8.2, 10.1}) out += t > opens && t < opens + 0.9 ? 0.15 : 0.0;
    return out;
  });
  const auto report = diagnosed(recording);
  EXPECT_EQ(report.verdict, Verdict::unexplained) << said(report);
  EXPECT_TRUE(finds(report, "switches")) << said(report);
}

/// An amplifier whose charge leaks away forgets a load within half a minute: that was a zero that walks, and so clean.
/// Where it takes a minute, a walk does as well.
TEST(NoContact, AChargeThatLeaksIsUnknown) {
  Recording recording = aRecording(MotionKind::free, 314);
  constexpr double kForgets = 30.0;  // [s]
  for (Eigen::Index c = 0; c < 6; ++c) {
    double remembered = recording.wrench(0, c);
    for (Eigen::Index i = 1; i < recording.rows(); ++i) {
      remembered += (recording.wrench(i, c) - remembered) * (recording.time(i) - recording.time(i - 1)) / kForgets;
      recording.wrench(i, c) -= remembered;
    }
  }
  const auto report = diagnosed(recording);
  EXPECT_EQ(report.verdict, Verdict::unexplained) << said(report);
  EXPECT_EQ(report.remaining.goesWith, "what the channels read before") << said(report);
}

/// A gauge warms up in seconds and what it sits in takes minutes: it was a walk, and so clean.
TEST(NoContact, ADriftThatIsFastAtFirstIsOne) {
  Recording recording = aRecording(MotionKind::free, 313);
  push(recording, [](double t) { return 0.8 * (1.0 - std::exp(-t / 1.2)) + 0.05 * t; });
  const auto report = diagnosed(recording);
  ASSERT_EQ(report.causes.size(), 1u) << said(report);
  EXPECT_EQ(report.causes.front().id, "bias_drift") << said(report);
  EXPECT_EQ(report.verdict, Verdict::explained) << said(report);
  const auto* constant = findParameter(report.causes.front().parameters, "time_constant");
  ASSERT_NE(constant, nullptr) << said(report);
  EXPECT_NEAR(constant->value, 1.2, 4.0 * constant->std);
}

/// Something is switched on that warms the sensor: it was a walk, and so clean.
TEST(NoContact, ADriftThatBeginsAtSomeMomentIsOne) {
  constexpr double kBegins = 6.0, kSettles = 4.0;  // [s]
  Recording recording = aRecording(MotionKind::excitation, 315);
  push(recording, [](double t) { return t < kBegins ? 0.0 : 0.8 * (1.0 - std::exp(-(t - kBegins) / kSettles)); });
  const auto report = diagnosed(recording);
  ASSERT_EQ(report.causes.size(), 1u) << said(report);
  EXPECT_EQ(report.causes.front().id, "bias_drift") << said(report);
  EXPECT_EQ(report.verdict, Verdict::explained) << said(report);
  for (const auto& [name, truth] : {std::pair{"time", kBegins}, {"time_constant", kSettles}}) {
    const auto* found = findParameter(report.causes.front().parameters, name);
    ASSERT_NE(found, nullptr) << name << ": " << said(report);
    EXPECT_NEAR(found->value, truth, 4.0 * found->std) << name;
  }
}

/// A hose kicks at every stop and rings for half a second: seven touches of the same length were "explained".
TEST(NoContact, WhatSwingsToAndFroIsUnknown) {
  Recording recording = aRecording(MotionKind::free, 319);
  push(recording, [](double t) {
    for (const double at : {1.7, 3.2, 4.9, 6.6, 8.1, 9.8})
      if (t > at && t < at + 1.0)
        return 0.9 * std::exp((at - t) / 0.35) * std::sin(2.0 * std::numbers::pi * 4.0 * (t - at));
    return 0.0;
  });
  const auto report = diagnosed(recording);
  EXPECT_EQ(report.verdict, Verdict::unexplained) << said(report);
  EXPECT_EQ(report.remaining.goesWith, "something that swings to and fro") << said(report);
  EXPECT_EQ(named(report, "contact"), nullptr) << said(report);
}

/// The robot rides on a carriage that nobody recorded: what its starts and stops do acts at the centre of mass.
TEST(NoContact, ABaseThatMovesIsUnknown) {
  Recording recording = aRecording(MotionKind::free, 320);
  const auto motion = motionOf(recording, &RobotModel::panda(), {}).value();
  const Vector3d rail = Vector3d(1.0, 0.3, 0.0).normalized();
  for (Eigen::Index i = 0; i < recording.rows(); ++i) {
    double a = 0.0;  // [m/s2] Of the carriage, along its rail: it starts and stops
    for (const double at : {2.0, 4.6, 7.3})
      for (const auto& [from, to, size] : {std::tuple{at, at + 0.5, 1.2}, {at + 0.9, at + 1.4, -1.2}})
        if (recording.time(i) > from && recording.time(i) < to) a += size;
    const Vector3d force =
        aTool().mass * a *
        (motion.R_BS[static_cast<std::size_t>(sampleAt(motion, recording.time(i)))].transpose() * rail);
    recording.wrench.row(i).head<3>() += force.transpose();
    recording.wrench.row(i).tail<3>() += aTool().com.cross(force).transpose();
  }
  const auto report = diagnosed(recording);
  EXPECT_EQ(report.verdict, Verdict::unexplained) << said(report);
  EXPECT_EQ(report.remaining.goesWith, "the centre of mass, as if the robot's base moved") << said(report);
  EXPECT_EQ(named(report, "contact"), nullptr) << said(report);
}

/// A converter whose steps are not alike: what one channel reads goes up and down with itself. It was noise, and clean.
TEST(NoContact, AConverterThatIsNotStraightIsUnknown) {
  Recording recording = aRecording(MotionKind::free, 321);
  for (Eigen::Index i = 0; i < recording.rows(); ++i)
    recording.wrench(i, 1) += 0.12 * std::sin(2.0 * std::numbers::pi * recording.wrench(i, 1) / 1.7);
  const auto report = diagnosed(recording);
  EXPECT_EQ(report.verdict, Verdict::unexplained) << said(report);
  EXPECT_EQ(report.remaining.goesWith, "what a channel itself reads, in waves") << said(report);
}

/// The zero of two channels is another one for four stretches of time, which begin and end softly: a zero that walks
/// does so on all of them.
TEST(NoContact, AZeroThatMovesOnTwoChannelsAloneIsUnknown) {
  Recording recording = aRecording(MotionKind::free, 322);
  for (Eigen::Index i = 0; i < recording.rows(); ++i)
    for (const auto& [from, to, size] :
         {std::tuple{1.2, 2.9, 0.3}, {3.6, 5.1, -0.25}, {6.0, 8.2, 0.35}, {9.4, 10.6, -0.3}}) {
      const double t = recording.time(i), in = 0.5 * (std::tanh((t - from) / 0.15) - std::tanh((t - to) / 0.15));
      recording.wrench(i, 0) += size * in;
      recording.wrench(i, 1) -= size * in;
    }
  const auto report = diagnosed(recording);
  EXPECT_EQ(report.verdict, Verdict::unexplained) << said(report);
}

/// Fingers that open and close move the centre of mass: it shows on the torques alone.
TEST(NoContact, WhatIsSlowOnTorquesAloneIsUnknown) {
  Recording recording = aRecording(MotionKind::free, 324);
  for (Eigen::Index i = 0; i < recording.rows(); ++i) {
    const double t = recording.time(i), open = std::tanh(4.0 * std::sin(2.0 * std::numbers::pi * t / 3.1)),
                 turned = std::tanh(4.0 * std::sin(2.0 * std::numbers::pi * t / 4.7));
    recording.wrench(i, 3) += 0.012 * open;
    recording.wrench(i, 5) += 0.008 * turned;
  }
  EXPECT_EQ(diagnosed(recording).verdict, Verdict::unexplained) << said(diagnosed(recording));
}

/// A gripper clicks at nine moments, and its flange rings for a tenth of a second.
TEST(NoContact, WhatRingsAgainAndAgainIsUnknown) {
  Recording recording = aRecording(MotionKind::free, 325);
  for (Eigen::Index i = 0; i < recording.rows(); ++i)
    for (const double at : {1.3, 2.4, 3.6, 4.9, 5.8, 7.1, 8.2, 9.3, 10.4}) {
      const double since = recording.time(i) - at;
      if (since <= 0.0 || since > 0.6) continue;
      const double ring = 0.02 * std::exp(-since / 0.1) * std::sin(2.0 * std::numbers::pi * 19.0 * since);
      recording.wrench(i, 3) += 0.5 * ring;
      recording.wrench(i, 4) += ring;
    }
  const auto report = diagnosed(recording);
  EXPECT_EQ(report.verdict, Verdict::unexplained) << said(report);
  EXPECT_EQ(report.remaining.goesWith, "noise that comes and goes") << said(report);
  EXPECT_TRUE(finds(report, "bursts")) << said(report);
  EXPECT_TRUE(report.causes.empty()) << said(report);
}

/// An amplifier changes its range where the load is large, and gives 5 % more force there: no touch pushes through the
/// middle of the sensor again and again, whichever way.
TEST(NoContact, ForcesThatTurnNothingAreUnknown) {
  Recording recording = aRecording(MotionKind::excitation, 326);
  for (Eigen::Index i = 0; i < recording.rows(); ++i)
    for (const double at : {1.6, 3.9, 6.3, 8.8, 10.2})
      if (recording.time(i) > at && recording.time(i) < at + 0.6) recording.wrench.row(i).head<3>() *= 1.05;
  const auto report = diagnosed(recording);
  EXPECT_EQ(report.verdict, Verdict::unexplained) << said(report);
  EXPECT_EQ(report.remaining.goesWith, "the size of the load, on the forces alone") << said(report);
  EXPECT_EQ(named(report, "contact"), nullptr) << said(report);
}

/// An output stage lets each channel change by so much a second and no more: where the load swings fast, the readings
/// come late.
TEST(NoContact, AnOutputThatCannotFollowIsUnknown) {
  Recording recording = aRecording(MotionKind::excitation, 329);
  const auto motion = motionOf(recording, &RobotModel::panda(), {}).value();
  const auto loadAt = [&](Eigen::Index i) -> Vector6d {
    const auto k = sampleAt(motion, recording.time(i));
    return predictWrench(aTool(), {motion.specificForce.col(k), motion.omega.col(k), motion.alpha.col(k)});
  };
  Vector6d most = Vector6d::Zero();
  for (Eigen::Index i = 20; i < recording.rows(); ++i)
    most = most.cwiseMax((loadAt(i) - loadAt(i - 20)).cwiseAbs() / (recording.time(i) - recording.time(i - 20)));
  Vector6d reads = loadAt(0);
  for (Eigen::Index i = 1; i < recording.rows(); ++i) {
    const Vector6d load = loadAt(i), may = 0.65 * most * (recording.time(i) - recording.time(i - 1));
    reads += (load - reads).cwiseMin(may).cwiseMax(-may);
    recording.wrench.row(i) += (reads - load).transpose();
  }
  const auto report = diagnosed(recording);
  EXPECT_EQ(report.verdict, Verdict::unexplained) << said(report);
  EXPECT_EQ(named(report, "contact"), nullptr) << said(report);
}

/// What amplifies the readings feels how fast it is turned, whichever way: what is left where the arm turns fast goes
/// with that, and nobody touched anything there.
TEST(NoContact, WhatGoesWithTurningEitherWayIsNone) {
  Recording recording = aRecording(MotionKind::free, 330);
  const auto motion = motionOf(recording, &RobotModel::panda(), {}).value();
  Vector6d size;
  size << 0.3, -0.2, 0.4, 0.01, -0.02, 0.005;
  const auto turning = [&](double t) { return motion.omega.col(sampleAt(motion, t)).squaredNorm(); };
  for (Eigen::Index i = 0; i < recording.rows(); ++i)
    recording.wrench.row(i) += (turning(recording.time(i)) * size).transpose();
  diagnosis::Signals signals =
      diagnosis::signalsOf(recording, motionOf(recording, &RobotModel::panda(), {}).value(), &RobotModel::panda());
  std::vector<bool> fast(static_cast<std::size_t>(signals.blocks()));
  const double much = 0.4 * motion.omega.colwise().squaredNorm().maxCoeff();
  for (std::size_t n = 0; n < fast.size(); ++n)
    fast[n] = signals.usable[n] && turning(signals.blockTime(static_cast<Eigen::Index>(n))) > much;
  std::vector<diagnosis::Contact> contacts;
  for (const auto& s : diagnosis::stretchesOf(fast)) {
    std::fill(signals.usable.begin() + s.from, signals.usable.begin() + s.to, false);
    contacts.push_back({signals.blockTime(s.from), signals.blockTime(s.to - 1), 100.0, s, {}});
  }
  ASSERT_GE(contacts.size(), 2u);
  const auto fit = diagnosis::fitModel(signals, diagnosis::stretchesOf(signals.usable), {});
  EXPECT_EQ(diagnosis::correlateOf(signals, fit, contacts), "how fast the tool turns");
}

/// Doors slam, and the air pushes at the sealed sensor for a second each time: no noise leaps as far, and that often.
TEST(NoContact, AFewLargeLeapsAreUnknown) {
  Recording recording = aRecording(MotionKind::free, 328);
  for (Eigen::Index i = 0; i < recording.rows(); ++i)
    for (const auto& [at, size] : {std::pair{2.2, 0.6}, {3.6, -0.6}, {6.3, 0.6}, {8.1, 0.6}})
      if (recording.time(i) > at) recording.wrench(i, 2) += size * std::exp((at - recording.time(i)) / 0.7);
  const auto report = diagnosed(recording);
  EXPECT_EQ(report.verdict, Verdict::unexplained) << said(report);
  EXPECT_EQ(report.remaining.goesWith, "sudden changes") << said(report);
  EXPECT_TRUE(finds(report, "switches")) << said(report);
  EXPECT_TRUE(report.causes.empty()) << said(report);
}

/// A hand rests on the tool for two seconds, lightly: it was a pull that begins, and a zero that jumps when it ends.
TEST(NoContact, AHandThatRestsOnTheToolIsATouch) {
  Recording recording = aRecording(MotionKind::free, 323);
  push(recording, [](double t) { return t > 4.2 && t < 6.4 ? 0.28 : 0.0; });
  const auto report = diagnosed(recording);
  ASSERT_EQ(report.causes.size(), 1u) << said(report);
  EXPECT_EQ(report.causes.front().id, "contact") << said(report);
  ASSERT_EQ(report.causes.front().when.size(), 1u);
  EXPECT_NEAR(report.causes.front().when.front().first, 4.2, 0.3);
  EXPECT_NEAR(report.causes.front().when.front().second, 6.4, 0.3);
}

/// A sign is lost for 30 ms: too short to be set aside as a touch, and it was nothing at all.
TEST(NoContact, OneGlitchIsNotClean) {
  const Recording clean = aRecording(MotionKind::excitation, 343);
  Recording recording = clean;
  for (Eigen::Index i = 0; i < recording.rows(); ++i)
    if (recording.time(i) > 6.01 && recording.time(i) < 6.04) recording.wrench(i, 2) *= -1.0;
  const auto report = diagnosed(recording);
  EXPECT_EQ(report.verdict, Verdict::unexplained) << said(report);
  EXPECT_TRUE(report.causes.empty()) << said(report);
  EXPECT_FALSE(finds(diagnosed(clean), "glitch"));
}

/// A welder's pulses in two channels for more than half of the time: loud is what is usual there, so that nothing stood
/// out of it, and the recording was clean.
TEST(Diagnose, NoiseThatSwitchesMostOfTheTime) {
  const auto switches = [](const Recording& recording) {
    const Motion motion = motionOf(recording, &RobotModel::panda(), {}).value();
    const auto signals = diagnosis::signalsOf(recording, motion, &RobotModel::panda());
    const auto stretches = diagnosis::stretchesOf(signals.usable);
    return diagnosis::noiseSwitches(signals, stretches, fitModel(signals, stretches, diagnosis::Model{}));
  };
  Recording recording = aRecording(MotionKind::free, 364);
  EXPECT_FALSE(switches(recording));
  for (Eigen::Index i = 0; i < recording.rows(); ++i) {
    const double t = recording.time(i), phase = 5.3 * t + 0.9 * std::sin(2.1 * t) + 0.5 * std::sin(3.7 * t);
    const bool welds = (t > 1.5 && t < 5.0) || (t > 6.8 && t < 9.0) || t > 10.0;
    if (!welds || phase - std::floor(phase) > 0.3) continue;
    recording.wrench(i, 0) += 0.4;
    recording.wrench(i, 1) += 0.5;
  }
  EXPECT_TRUE(switches(recording));
  const auto report = diagnosed(recording);
  EXPECT_NE(report.verdict, Verdict::clean) << said(report);
}

/// An amplifier that is not the same on both sides of a value jumps whenever its reading passes there: no zero that
/// jumps, however often.
TEST(Diagnose, JumpsThatGoWithTheReadingItself) {
  Recording recording = aRecording(MotionKind::excitation, 365);
  const VectorXd load = recording.wrench.col(0);
  const double level = load.minCoeff() + 0.8 * (load.maxCoeff() - load.minCoeff());
  bool above = load(0) > level;
  for (Eigen::Index i = 0; i < recording.rows(); ++i) {
    const Eigen::Index from = std::max<Eigen::Index>(0, i - 20), to = std::min(recording.rows(), i + 21);
    above = load.segment(from, to - from).mean() > level;
    recording.wrench(i, 0) += above ? 0.6 : 0.0;
  }
  const auto report = diagnosed(recording);
  EXPECT_EQ(report.verdict, Verdict::unexplained) << said(report);
}

}  // namespace
}  // namespace heft::test
