// Light touches that are hidden in simulated recordings are contact, with their force; see no_contact_test.cpp for what
// only looks like it.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/diagnosis/corrected.h"
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

}  // namespace
}  // namespace heft::test
