// What looks like touches, and keeps a law that none does.
#include "core/diagnosis/change_detection/segment_correlates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>

#include "core/diagnosis/causes/catalogue.h"
#include "core/diagnosis/change_detection/hypotheses/segment_hypothesis.h"
#include "core/diagnosis/correction/corrected.h"
#include "core/diagnosis/pipeline/hypothesis.h"
#include "core/diagnosis/pipeline/set_aside.h"
#include "core/motion/motion.h"
#include "core/robot/robot_model.h"
#include "core/wrench/regressor.h"
#include "tests/core/diagnosis/fixture.h"

namespace heft::test {
namespace {

using namespace diagnosis;

/// Adds `wrench(motion, k, t)` to each row, k the motion's sample at its time t [s].
template <class OfSample>
void add(Recording& recording, const OfSample& wrench) {
  const auto motion = motionOf(recording, &RobotModel::panda(), {}).value();
  for (Eigen::Index i = 0; i < recording.rows(); ++i) {
    const double t = recording.time(i);
    recording.wrench.row(i) += Vector6d(wrench(motion, sampleAt(motion, t), t)).transpose();
  }
}

void expectUnknown(const Recording& recording, std::string_view goesWith) {
  const auto report = diagnosed(recording);
  EXPECT_EQ(report.verdict, Verdict::unexplained) << said(report);
  EXPECT_EQ(report.remaining.goesWith, goesWith) << said(report);
  EXPECT_EQ(named(report, "contact"), nullptr) << said(report);
}

/// A plug is loose: for a moment two channels arrive in each other's place.
TEST(TouchLaws, ChannelsThatAreMixedUpAreNone) {
  Recording recording = aRecording(MotionKind::free, 331);
  for (Eigen::Index i = 0; i < recording.rows(); ++i)
    if (recording.time(i) > 4.1 && recording.time(i) < 4.9) std::swap(recording.wrench(i, 3), recording.wrench(i, 4));
  expectUnknown(recording, "channels that are mixed up for a while");
}

/// The amplifier's supply dips, and with it everything that it says.
TEST(TouchLaws, ASupplyThatDipsIsNone) {
  Recording recording = aRecording(MotionKind::excitation, 332);
  for (Eigen::Index i = 0; i < recording.rows(); ++i)
    for (const auto& [from, lasts] : {std::pair{2.0, 0.3}, {4.3, 0.25}, {5.9, 0.4}, {9.1, 0.3}})
      if (recording.time(i) > from && recording.time(i) < from + lasts) recording.wrench.row(i) *= 0.88;
  expectUnknown(recording, "the size of all readings together");
}

/// Somebody leans on the table once: the base gives by two degrees, and gravity pulls another way. That acts at the
/// centre of mass; a hand that pulls the same way an inch beside it is one.
TEST(TouchLaws, ALeaningTableIsNone) {
  const Vector3d change = 9.81 * 2.0 * std::numbers::pi / 180.0 * Vector3d(0.8, -0.6, 0.0);  // [m/s2] Of a - g
  const auto lawFor = [&](const Vector3d& place) {
    Recording recording = aRecording(MotionKind::excitation, 333);
    add(recording, [&](const Motion& motion, Eigen::Index k, double t) {
      const double share = std::clamp(std::min(t - 4.0, 8.5 - t) / 0.8, 0.0, 1.0);
      const Vector3d force = aTool().mass * share * (motion.R_BS[static_cast<std::size_t>(k)].transpose() * change);
      Vector6d out;
      out << force, place.cross(force);
      return out;
    });
    diagnosis::Signals signals =
        diagnosis::signalsOf(recording, motionOf(recording, &RobotModel::panda(), {}).value(), &RobotModel::panda());
    diagnosis::Contact contact{4.0, 8.5, 1e4, {signals.blocks(), 0}, {}};
    for (Eigen::Index n = 0; n < signals.blocks(); ++n)
      if (signals.blockTime(n) > contact.from && signals.blockTime(n) < contact.to) {
        contact.blocks = {std::min(contact.blocks.from, n), n + 1};
        signals.usable[static_cast<std::size_t>(n)] = false;
      }
    const auto fit = diagnosis::fitModel(signals, diagnosis::stretchesOf(signals.usable), {});
    return diagnosis::correlateOf(signals, fit, {contact});
  };
  EXPECT_EQ(lawFor(aTool().com), "the centre of mass, as if the robot's base moved");
  EXPECT_EQ(lawFor(aTool().com + Vector3d(0.0, 0.0, 0.025)), "");
}

/// A valve on the tool switches every 1.3 s, wherever the tool is.
TEST(TouchLaws, WhatComesLikeClockworkIsNone) {
  Recording recording = aRecording(MotionKind::excitation, 334);
  for (Eigen::Index i = 0; i < recording.rows(); ++i)
    if (const double u = std::fmod(recording.time(i) + 0.4, 1.3) / 0.12; u < 1.0) {
      recording.wrench(i, 0) += 1.6 * std::sin(std::numbers::pi * u);
      recording.wrench(i, 4) += 0.13 * std::sin(std::numbers::pi * u);
    }
  expectUnknown(recording, "time alone, as regular as a clock");
}

/// One channel's plug makes bad contact again and again: each time less of it comes through.
TEST(TouchLaws, AChannelThatIsWeakAtTimesIsNone) {
  Recording recording = aRecording(MotionKind::free, 335);
  for (Eigen::Index i = 0; i < recording.rows(); ++i)
    for (const auto& [from, lasts] : {std::pair{1.6, 0.3}, {3.7, 0.25}, {5.2, 0.35}, {8.0, 0.3}, {9.9, 0.2}})
      if (recording.time(i) > from && recording.time(i) < from + lasts) recording.wrench(i, 2) *= 0.8;
  expectUnknown(recording, "one channel of the sensor alone");
}

/// A part of 180 g that is picked up and put down twice is a load, and touches nothing.
TEST(TouchLaws, APartThatIsCarriedIsALoad) {
  Recording recording = aRecording(MotionKind::free, 336);
  Payload part;
  part.mass = 0.18;
  part.com = {-0.03, 0.02, 0.15};
  part.inertiaCom = Vector3d(2e-5, 2e-5, 2e-5).asDiagonal();
  add(recording, [&](const Motion& motion, Eigen::Index k, double t) {
    const auto carried = [t](double from, double to) {
      return std::clamp(std::min(t - from, to - t) / 0.08, 0.0, 1.0);
    };
    return Vector6d(std::max(carried(2.1, 4.3), carried(6.8, 8.6)) *
                    predictWrench(part, {motion.specificForce.col(k), motion.omega.col(k), motion.alpha.col(k)}));
  });
  const auto report = diagnosed(recording);
  EXPECT_EQ(named(report, "contact"), nullptr) << said(report);
  const DiagnosedCause* load = named(report, "payload_change");
  ASSERT_NE(load, nullptr) << said(report);
  EXPECT_EQ(report.verdict, Verdict::explained) << said(report);
  const CauseParameter* mass = findParameter(load->parameters, "mass");
  EXPECT_NEAR(mass->value, 180.0, 3.0 * mass->std + 2.0);
  ASSERT_EQ(load->when.size(), 2u);
  EXPECT_NEAR(load->when[0].first, 2.1, 0.3);
  EXPECT_NEAR(load->when[1].second, 8.6, 0.3);
  EXPECT_TRUE(canApply(report, *load));
}

/// A part of 400 g slides by 2 cm in its holder, and back: the tool weighs the same, somewhere else. One that is picked
/// up does not, and nor does a push.
TEST(TouchLaws, AWeightThatSlidesIsNone) {
  const auto elsewhere = [](const Eigen::Vector4d& load, const Vector3d& push) {
    Recording recording = aRecording(MotionKind::free, 352);
    Vector10d moved = Vector10d::Zero();
    moved.head<4>() = load;
    add(recording, [&](const Motion& motion, Eigen::Index k, double t) {
      const double there = std::clamp(std::min(t - 5.4, 8.2 - t) / 0.08, 0.0, 1.0);
      Vector6d out = regressor({motion.specificForce.col(k), motion.omega.col(k), motion.alpha.col(k)}) * moved;
      out.head<3>() += push;
      out.tail<3>() += Vector3d(0.0, 0.0, 0.1).cross(push);
      return Vector6d(there * out);
    });
    const Motion motion = motionOf(recording, &RobotModel::panda(), {}).value();
    Signals signals = signalsOf(recording, motion, &RobotModel::panda());
    Contact contact{5.4, 8.2, 1e4, {signals.blocks(), 0}, {}};
    for (Eigen::Index n = 0; n < signals.blocks(); ++n)
      if (signals.blockTime(n) > 5.4 && signals.blockTime(n) < 8.2)
        contact.blocks = {std::min(contact.blocks.from, n), n + 1};
    const Signals whole = signals;
    signals.usable = usableOutside(whole, {contact.blocks});
    const Fit fit = fitModel(signals, stretchesOf(signals.usable), Model{});
    const std::vector<Contact> contacts{contact};
    return weightElsewhere({whole, fit, contacts}).has_value();
  };
  EXPECT_TRUE(elsewhere({0.0, 0.002, 0.0, 0.008}, Vector3d::Zero()));
  EXPECT_FALSE(elsewhere({0.18, 0.002, 0.0, 0.008}, Vector3d::Zero()));
  EXPECT_FALSE(elsewhere({0.0, 0.0, 0.0, 0.0}, {1.0, 0.5, -0.3}));
}

/// Chips in a gap carry a quarter of what goes beyond some load. It was a touch.
TEST(TouchLaws, WhatBeginsWithALoadIsNone) {
  Recording recording = aRecording(MotionKind::excitation, 353);
  const auto loads = recording.wrench.col(0);
  std::vector<double> sorted(loads.begin(), loads.end());
  std::ranges::sort(sorted);
  const double limit = sorted[sorted.size() * 9 / 10];
  for (Eigen::Index i = 0; i < recording.rows(); ++i) {
    const double beyond = 0.25 * std::max(0.0, recording.wrench(i, 0) - limit);
    recording.wrench(i, 0) -= beyond;
    recording.wrench(i, 4) -= 0.1 * beyond;
  }
  expectUnknown(recording, "the size of the load");
}

/// Somebody sets the sensor computer's clock for a while: the readings there are of a moment later.
TEST(TouchLaws, AClockThatIsSetIsNone) {
  Recording recording = aRecording(MotionKind::excitation, 338);
  const Recording asItWas = recording;
  const auto later = static_cast<Eigen::Index>(0.14 * recording.rateHz());
  for (Eigen::Index i = 0; i + later + 1 < recording.rows(); ++i)
    if (recording.time(i) > 5.0 && recording.time(i) < 6.0)
      recording.wrench.row(i) = 0.5 * (asItWas.wrench.row(i + later) + asItWas.wrench.row(i + later + 1));
  expectUnknown(recording, "readings of another moment");
}

/// A spindle spins up twice: turning the tool takes a torque then, and no force.
TEST(TouchLaws, ASpindleThatIsTurnedIsNone) {
  Recording recording = aRecording(MotionKind::free, 339);
  add(recording, [](const Motion& motion, Eigen::Index k, double t) {
    const double spins = std::clamp(std::min(t - 3.0, 5.5 - t) / 0.3, 0.0, 1.0) +
                         std::clamp(std::min(t - 8.0, 10.0 - t) / 0.3, 0.0, 1.0);
    Vector6d out = Vector6d::Zero();
    out.tail<3>() = motion.omega.col(k).cross(Vector3d(0.0, 0.05, 0.2)) * spins;
    return out;
  });
  expectUnknown(recording, "torques without a force");
}

/// Doors slam, and the floor shakes the base for a moment while the arm moves smoothly: the motion set no mount
/// ringing, and whether it is one that was struck nobody knows.
TEST(TouchLaws, AFloorThatRingsIsNotSurelyTheMount) {
  Recording recording = aRecording(MotionKind::excitation, 337);
  add(recording, [](const Motion& motion, Eigen::Index k, double t) {
    double a = 0.0;
    for (const double at : {2.4, 5.1, 8.3})
      if (t > at) a += 1.4 * std::exp((at - t) / 0.22) * std::sin(2.0 * std::numbers::pi * 14.5 * (t - at));
    const Vector3d force =
        aTool().mass * a * (motion.R_BS[static_cast<std::size_t>(k)].transpose() * Vector3d(0.6, 0.0, 0.8));
    Vector6d out;
    out << force, aTool().com.cross(force);
    return out;
  });
  const auto report = diagnosed(recording);
  EXPECT_EQ(report.verdict, Verdict::unexplained) << said(report);
  EXPECT_EQ(report.remaining.goesWith, "blows from outside") << said(report);
  EXPECT_TRUE(finds(report, "struck"));
  const DiagnosedCause* rings = named(report, "flexible_mount");
  ASSERT_NE(rings, nullptr) << said(report);
  EXPECT_NEAR(findParameter(rings->parameters, "frequency")->value, 14.5, 0.3);
  EXPECT_EQ(findParameter(rings->parameters, "strikes")->value, 3.0);
  EXPECT_NE(rings->sentence.find("pedestal"), std::string::npos) << rings->sentence;
}

/// A box is switched from N to pounds for a while, and its torques to another unit again.
TEST(TouchLaws, UnitsThatChangeAreNone) {
  Recording recording = aRecording(MotionKind::excitation, 341);
  for (Eigen::Index i = 0; i < recording.rows(); ++i)
    if (recording.time(i) > 5.0 && recording.time(i) < 7.6) {
      recording.wrench.row(i).head<3>() *= 0.2248;
      recording.wrench.row(i).tail<3>() *= 0.7376;
    }
  expectUnknown(recording, "the size of all readings together");
}

/// Somebody knocks at a tool on a soft adapter again and again: most of the time something rings, which is not the
/// usual then. It was noise that comes and goes.
TEST(TouchLaws, BlowsAgainAndAgainDoNotHideTheRinging) {
  constexpr double kFrequency = 33.0, kDamping = 0.025;
  Recording recording = aRecording(MotionKind::excitation, 342);
  const double w = 2.0 * std::numbers::pi * kFrequency;
  add(recording, [&](const Motion&, Eigen::Index, double t) {
    double force = 0.0;
    for (double at = 0.9; at < t; at += 0.9 + 0.15 * std::sin(7.0 * at))
      force += 3.0 * std::exp(-kDamping * w * (t - at)) * std::sin(w * (t - at));
    Vector6d out;
    out << Vector3d(0.5, 0.8, 0.3) * force, aTool().com.cross(Vector3d(0.5, 0.8, 0.3)) * force;
    return out;
  });
  const auto report = diagnosed(recording);
  EXPECT_EQ(report.verdict, Verdict::unexplained) << said(report);
  const DiagnosedCause* rings = named(report, "flexible_mount");
  ASSERT_NE(rings, nullptr) << said(report);
  EXPECT_NEAR(findParameter(rings->parameters, "frequency")->value, kFrequency, 0.5);
  EXPECT_NEAR(findParameter(rings->parameters, "damping")->value, kDamping, 0.005);
  EXPECT_NE(findParameter(rings->parameters, "strikes"), nullptr);
}

/// The zero jumps, and later it is another one once more: that is no touch. A hand that pulls as long is one, and so is
/// the same stretch where no zero jumps elsewhere.
TEST(TouchLaws, AZeroThatIsAnotherOneOnceMoreIsNone) {
  const auto leftAfter = [](bool ofHand, bool jumpsElsewhere) {
    Recording recording = aRecording(MotionKind::excitation, 345);
    add(recording, [&](const Motion& motion, Eigen::Index k, double t) {
      Vector6d out = Vector6d::Zero();
      if (t < 7.0 || t > 11.0) return out;
      out << 1.2, -0.4, 0.9, 0.05, 0.08, -0.02;
      if (ofHand) out.head<3>() = (motion.R_BS[static_cast<std::size_t>(k)].transpose() * out.head<3>()).eval();
      return out;
    });
    diagnosis::Hypothesis hypothesis;
    hypothesis.signals =
        diagnosis::signalsOf(recording, motionOf(recording, &RobotModel::panda(), {}).value(), &RobotModel::panda());
    diagnosis::Contact contact{7.0, 11.0, 1e4, {hypothesis.signals.blocks(), 0}, {}};
    for (Eigen::Index n = 0; n < hypothesis.signals.blocks(); ++n) {
      const double t = hypothesis.signals.blockTime(n);
      if (t > contact.from && t < contact.to) contact.blocks = {std::min(contact.blocks.from, n), n + 1};
      hypothesis.signals.usable[static_cast<std::size_t>(n)] = t < contact.from || t > contact.to;
    }
    diagnosis::Model model;
    if (jumpsElsewhere) {
      const auto forms = diagnosis::findCause("sensor_bias")->forms(hypothesis.signals);
      model.terms.push_back({std::make_shared<const diagnosis::Form>(forms.front()), forms.front().start, {}});
    }
    hypothesis.stretches = diagnosis::stretchesOf(hypothesis.signals.usable);
    hypothesis.search.final = diagnosis::fitModel(hypothesis.signals, hypothesis.stretches, model);
    hypothesis.contacts = {contact};
    diagnosis::setRecurrencesAside(hypothesis);
    EXPECT_EQ(hypothesis.contacts.size() + hypothesis.recurrences.size(), 1u);
    return hypothesis.contacts.size();
  };
  EXPECT_EQ(leftAfter(false, true), 0u);
  EXPECT_EQ(leftAfter(true, true), 1u);
  EXPECT_EQ(leftAfter(false, false), 1u);
}

}  // namespace
}  // namespace heft::test
