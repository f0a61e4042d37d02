// Light touches that are hidden in simulated recordings are contact, with their force; see no_contact_test.cpp for what
// only looks like it.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/diagnosis/causes/catalogue.h"
#include "core/diagnosis/change_detection/segments.h"
#include "core/diagnosis/correction/corrected.h"
#include "core/diagnosis/pipeline/set_aside.h"
#include "core/robot/robot_model.h"
#include "tests/core/diagnosis/fixture.h"

namespace heft::test {
namespace {

TEST(Diagnose, ALightTouchIsContact) {
  const auto report = diagnosed(aRecording(MotionKind::excitation, 181, {{"contact", "bump", 0.3}}));
  ASSERT_EQ(report.causes.size(), 1u) << said(report);
  EXPECT_EQ(report.causes.front().id, "contact");
  EXPECT_TRUE(canApply(report, report.causes.front()));
}

/// What the load alone leaves in a contact is mostly the drag's: its peak was that, with the noise for its deviation.
TEST(Diagnose, AContactsForceIsWhatTheOtherCausesLeave) {
  for (const double force : {0.5, 2.0}) {
    const auto report =
        diagnosed(aRecording(MotionKind::excitation, 183, {{"viscous_drag", "", 10.0}, {"contact", "bump", force}}));
    const DiagnosedCause* contact = named(report, "contact");
    ASSERT_NE(contact, nullptr) << said(report);
    ASSERT_EQ(contact->parameters.size(), 1u);
    const auto& peak = contact->parameters.front();
    EXPECT_NEAR(peak.value, force, 3.0 * peak.std) << said(report);
    EXPECT_LT(peak.std, 0.3 * force) << said(report);
  }
}

/// What the arm touches in its task stays contact; five seconds before a load changes, beside a drift and a tilt, do
/// not become one, which would leave the mass 17 % off.
TEST(Diagnose, TheTimeBeforeALoadChangesIsNoTouch) {
  SimulateOptions options;
  options.motion = MotionKind::pickAndPlace;
  options.seed = 8801;
  options.duration = 14.0;
  options.effects = {{"payload_change", "", 140.0}, {"bias_drift", "", 0.6}, {"gravity_tilt", "", 1.5}};
  const auto report = diagnosed(simulate(RobotModel::panda(), aTool(), options).value().recording);
  for (const char* id : {"payload_change", "bias_drift", "gravity_tilt", "contact"})
    EXPECT_NE(named(report, id), nullptr) << id << ": " << said(report);
  ASSERT_NE(named(report, "contact"), nullptr);
  for (const auto& [from, to] : named(report, "contact")->when) EXPECT_LT(to - from, 2.0) << said(report);
  EXPECT_NEAR(report.after.payload.mass, aTool().mass, 0.02 * aTool().mass);
}

/// An eighth of a second each, two close to each other.
TEST(Diagnose, ShortTouchesAreContact) {
  Recording recording = aRecording(MotionKind::excitation, 190);
  for (const double at : {2.5, 4.4, 7.0, 7.3})
    for (Eigen::Index i = 0; i < recording.rows(); ++i)
      if (const double u = (recording.time(i) - at) / 0.12; u > 0.0 && u < 1.0) {
        const double push = 0.5 * std::sin(std::numbers::pi * u);
        recording.wrench(i, 1) += push;
        recording.wrench(i, 3) += 0.08 * push;
      }
  const auto report = diagnosed(recording);
  ASSERT_EQ(report.causes.size(), 1u) << said(report);
  EXPECT_EQ(report.causes.front().id, "contact") << said(report);
}

/// One stretch beside which nothing is left, of 0.12 N beside noise of 0.05 N.
TEST(Diagnose, AFaintTouchAloneIsOne) {
  for (const std::uint64_t seed : {401u, 404u, 408u}) {
    const auto report = diagnosed(aRecording(MotionKind::free, seed, {{"contact", "", 0.12}}));
    EXPECT_NE(named(report, "contact"), nullptr) << seed << ": " << said(report);
  }
}

/// A fit that knows of a touch from 4.2 to 5.7 s and leaves 0.5 N of it, back to 4.0 and up to 6.0 s.
struct Held {
  Held() {
    using namespace diagnosis;
    const Recording recording = aRecording(MotionKind::excitation, 410);
    signals = signalsOf(recording, motionOf(recording, &RobotModel::panda(), {}).value(), &RobotModel::panda());
    fit = fitModel(signals, stretchesOf(signals.usable), {});
    fit.residual.setConstant(0.01);
    const auto forms = findCause("contact")->forms(signals);
    Term touch{std::make_shared<const Form>(forms.front()), forms.front().start, {}};
    touch.v(0) = 4.95;
    touch.v(7) = 1.5;
    fit.model.terms.push_back(std::move(touch));
    for (Eigen::Index n = 0; n < signals.blocks(); ++n) {
      const double t = signals.blockTime(n);
      fit.residual.col(n) *= n % 2 == 0 ? 1.0 : -1.0;
      if ((t > 4.0 && t < 4.2) || (t > 5.7 && t < 6.0)) fit.residual(1, n) = 0.5;
    }
  }

  diagnosis::Stretch blocks(double from, double to) const {
    diagnosis::Stretch out{signals.blocks(), 0};
    for (Eigen::Index n = 0; n < signals.blocks(); ++n)
      if (signals.blockTime(n) > from && signals.blockTime(n) < to) out = {std::min(out.from, n), n + 1};
    return out;
  }

  std::vector<diagnosis::Stretch> with(double gain, double explained,
                                       const std::vector<diagnosis::Stretch>& holes) const {
    return diagnosis::holesWithTouches(signals, {fit, false, last, gain, explained}, holes);
  }

  diagnosis::Signals signals;
  diagnosis::Fit fit;
  const char* last = "contact";
};

void expectHole(const Held& held, const std::vector<diagnosis::Stretch>& holes, double from, double to) {
  ASSERT_EQ(holes.size(), 1u);
  EXPECT_NEAR(held.signals.blockTime(holes[0].from), from, 0.03);
  EXPECT_NEAR(held.signals.blockTime(holes[0].to - 1), to, 0.03);
}

TEST(HolesWithTouches, APlainOneIsSetAsideAsFarAsItGoes) {
  const Held held;
  expectHole(held, held.with(5000.0, 9000.0, {}), 4.0, 6.0);
}

TEST(HolesWithTouches, WhatMayBeAnythingElsesRestIsLeft) {
  const Held held;
  EXPECT_TRUE(held.with(900.0, 950.0, {}).empty());
  EXPECT_TRUE(held.with(1500.0, 20000.0, {}).empty());
}

TEST(HolesWithTouches, WhatWasFoundLastMustBeOne) {
  Held held;
  held.last = "cable_pull";
  EXPECT_TRUE(held.with(5000.0, 9000.0, {}).empty());
}

TEST(HolesWithTouches, WhatGoesOnFromContactNeedNotBePlain) {
  const Held held;
  expectHole(held, held.with(500.0, 20000.0, {held.blocks(5.5, 7.0)}), 4.0, 7.0);
  EXPECT_TRUE(held.with(100.0, 20000.0, {held.blocks(5.5, 7.0)}).empty());
  EXPECT_TRUE(held.with(500.0, 20000.0, {held.blocks(7.0, 8.0)}).empty());
}

TEST(HolesWithTouches, WhatTakesALongTimeIsNoTouch) {
  Held held;
  held.fit.model.terms.front().v(7) = 4.5;
  EXPECT_TRUE(held.with(5000.0, 9000.0, {}).empty());
}

/// What smoothing leaves is told by what it took, however hard the tool was pushed elsewhere: a touch of 0.5 N beside
/// one of 20 N was nothing at all.
TEST(ContactsIn, AWeakTouchBesideAStrongOneIsNotLeftBySmoothing) {
  Held held;
  const Eigen::Index blocks = held.signals.blocks();
  held.fit.model.terms.clear();
  for (Eigen::Index n = 0; n < blocks; ++n) held.fit.residual.col(n).setConstant(n % 2 == 0 ? 0.01 : -0.01);
  const diagnosis::Stretch strong = held.blocks(2.0, 4.0), weak = held.blocks(8.0, 9.5);
  held.fit.residual.row(2).segment(strong.from, strong.to - strong.from).setConstant(20.0);
  held.fit.residual.row(2).segment(weak.from, weak.to - weak.from).setConstant(0.5);
  diagnosis::Wrenches lost = diagnosis::Wrenches::Zero(6, blocks);
  for (const double share : {0.1, 0.9}) {
    lost.row(2).segment(weak.from, weak.to - weak.from).setConstant(share * 0.5);
    // By motion that is smoothed as usual, or less.
    for (const auto way : {&diagnosis::Signals::lost, &diagnosis::Signals::lostFast}) {
      held.signals.lost = held.signals.lostFast = nullptr;
      held.signals.*way = std::make_shared<const std::vector<diagnosis::Wrenches>>(1, lost);
      const auto contacts = diagnosis::contactsIn(held.signals, held.fit, {strong, weak});
      ASSERT_EQ(contacts.size(), 2u) << share;
      EXPECT_FALSE(contacts.front().smoothed) << share;
      EXPECT_EQ(contacts.back().smoothed, share > 0.5) << share;
    }
  }
}

/// Which of a stretch's channels stands out is told by what is usual without contact: a hard push along x hid what
/// swings along x elsewhere behind a little that y keeps.
TEST(ContactsIn, WhatSwingsIsToldBesideAStrongTouchOnTheSameChannel) {
  Held held;
  held.fit.model.terms.clear();
  for (Eigen::Index n = 0; n < held.signals.blocks(); ++n)
    held.fit.residual.col(n).setConstant(n % 2 == 0 ? 0.05 : -0.05);
  const diagnosis::Stretch strong = held.blocks(2.0, 4.0), swing = held.blocks(8.0, 9.5);
  held.fit.residual.row(0).segment(strong.from, strong.to - strong.from).setConstant(60.0);
  held.fit.residual.row(1).segment(swing.from, swing.to - swing.from).setConstant(0.5);
  for (Eigen::Index n = swing.from; n < swing.to; ++n)
    held.fit.residual(0, n) = 3.0 * std::sin(12.0 * (held.signals.blockTime(n) - 8.0));
  const auto contacts = diagnosis::contactsIn(held.signals, held.fit, {strong, swing});
  ASSERT_EQ(contacts.size(), 2u);
  EXPECT_EQ(contacts.front().instead, "");
  EXPECT_EQ(contacts.back().instead, "something that swings to and fro");
}

}  // namespace
}  // namespace heft::test
