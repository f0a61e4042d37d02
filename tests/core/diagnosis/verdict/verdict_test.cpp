// What causes come to, taken together.
#include "core/diagnosis/verdict/verdict.h"

#include <gtest/gtest.h>

#include "core/diagnosis/causes/catalogue.h"
#include "core/robot/robot_model.h"
#include "tests/core/diagnosis/fixture.h"

namespace heft::test {
namespace {

using namespace diagnosis;

/// A zero that jumps after 4 s and a load that becomes 150 g heavier after 8 s, both found.
Hypothesis aJumpAndALoad() {
  Recording recording = aRecording(MotionKind::excitation, 346);
  const Motion motion = motionOf(recording, &RobotModel::panda(), {}).value();
  Vector10d part = Vector10d::Zero();
  part.head<4>() << 0.15, 0.003, 0.0, 0.012;
  for (Eigen::Index i = 0; i < recording.rows(); ++i) {
    const double t = recording.time(i);
    const Eigen::Index k = sampleAt(motion, t);
    if (t > 4.0) recording.wrench(i, 0) += 1.0;
    if (t > 8.0)
      recording.wrench.row(i) +=
          (regressor({motion.specificForce.col(k), motion.omega.col(k), motion.alpha.col(k)}) * part).transpose();
  }
  Hypothesis hypothesis;
  hypothesis.signals = signalsOf(recording, motion, &RobotModel::panda());
  hypothesis.stretches = stretchesOf(hypothesis.signals.usable);
  hypothesis.search.null = fitModel(hypothesis.signals, hypothesis.stretches, Model{});
  Model model;
  for (const auto& [cause, at] : {std::pair{"sensor_bias", 4.0}, {"payload_change", 8.0}}) {
    Form form = findCause(cause)->forms(hypothesis.signals).front();
    form.start(0) = at;
    model.terms.push_back({std::make_shared<const Form>(form), form.start, {}});
  }
  hypothesis.search.final = fitModel(hypothesis.signals, hypothesis.stretches, model);
  return hypothesis;
}

DiagnosedCause fitted(const char* id) {
  DiagnosedCause out;
  out.id = id;
  out.deltaBic = 500.0;
  out.gain.explainedFraction = 0.5;
  return out;
}

TEST(Verdict, TwoCausesOfOneMomentAreNeither) {
  Hypothesis hypothesis = aJumpAndALoad();
  DiagnosisReport report;
  report.causes = {fitted("sensor_bias"), fitted("payload_change")};
  giveVerdict(hypothesis, report.remaining, report);
  EXPECT_EQ(report.verdict, Verdict::explained) << said(report);

  hypothesis.search.final.model.terms[0].v(0) = hypothesis.search.final.model.terms[1].v(0) + 0.04;
  giveVerdict(hypothesis, report.remaining, report);
  EXPECT_EQ(report.verdict, Verdict::unexplained) << said(report);
  EXPECT_EQ(report.remaining.goesWith, "sudden changes");
  EXPECT_EQ(report.causes.size(), 2u);
}

/// The verdict on one term of `cause`, in its form of that number, with some parameters changed and all known to
/// `deviation`.
Verdict verdictOn(const char* cause, std::size_t form, std::initializer_list<std::pair<Eigen::Index, double>> changed,
                  double deviation = 1e-4) {
  Hypothesis hypothesis = aJumpAndALoad();
  Fit& final = hypothesis.search.final;
  const Form one = findCause(cause)->forms(hypothesis.signals).at(form);
  final.model.terms = {{std::make_shared<const Form>(one), one.start, {}}};
  for (const auto& [p, value] : changed) final.model.terms.front().v(p) = value;
  final.covariance = deviation * deviation * MatrixXd::Identity(final.model.size(), final.model.size());
  DiagnosisReport report;
  report.causes = {fitted(cause)};
  giveVerdict(hypothesis, report.remaining, report);
  return report.verdict;
}

TEST(Verdict, AMemoryLargerThanAnyIsSomethingElse) {
  EXPECT_EQ(verdictOn("hysteresis", 0, {{0, 0.07}}), Verdict::explained);
  EXPECT_EQ(verdictOn("hysteresis", 0, {{3, -0.25}}), Verdict::unexplained);
  // How far the load must go back for it is no size.
  EXPECT_EQ(verdictOn("hysteresis", 1, {{0, 0.07}, {1, 0.6}}), Verdict::explained);
}

/// What loses 5 % from the middle of its range on has another gain there, and no end.
TEST(Verdict, AnEndThatHardlyGivesWayIsSomethingElse) {
  EXPECT_EQ(verdictOn("saturation", 0, {{0, 0.9}}), Verdict::explained);
  EXPECT_EQ(verdictOn("saturation", 0, {{0, 0.05}}), Verdict::unexplained);
}

/// A weight that slides takes nothing along and puts nothing down.
TEST(Verdict, ALoadFarFromTheToolIsSomethingElse) {
  EXPECT_EQ(verdictOn("payload_change", 0, {{1, 0.05}, {4, 0.012}}), Verdict::explained);
  EXPECT_EQ(verdictOn("payload_change", 0, {{1, -0.0002}, {2, -0.008}}), Verdict::unexplained);
  // Where the mass is hardly known, it may be what the moment asks for.
  EXPECT_EQ(verdictOn("payload_change", 0, {{1, -0.0002}, {2, -0.008}}, 0.004), Verdict::explained);
}

/// A compass needle is turned, and nothing pulls at it.
TEST(Verdict, APullFarFromTheToolIsSomethingElse) {
  EXPECT_EQ(verdictOn("constant_pull", 1, {{0, 0.5}, {4, 0.2}}), Verdict::explained);
  EXPECT_EQ(verdictOn("constant_pull", 1, {{0, 0.007}, {3, 0.9}, {4, -1.0}, {5, 0.9}}, 0.1), Verdict::unexplained);
}

TEST(Verdict, APartThatMayHaveNoMassIsSomethingElse) {
  EXPECT_EQ(verdictOn("loose_mass", 0, {{0, 0.05}}, 0.005), Verdict::explained);
  EXPECT_EQ(verdictOn("loose_mass", 0, {{0, 0.05}}, 0.03), Verdict::unexplained);
}

/// What other trials of the same form find counts, too: 49 +- 45 g may be nothing.
TEST(Verdict, APartWhoseToldMassMayBeNothingIsNotNamed) {
  for (const auto& [deviation, named] : {std::pair{45.0, 0u}, {26.0, 0u}, {22.0, 1u}}) {
    Hypothesis hypothesis = aJumpAndALoad();
    Fit& final = hypothesis.search.final;
    const Form form = findCause("loose_mass")->forms(hypothesis.signals).front();
    final.model.terms = {{std::make_shared<const Form>(form), form.start, {}}};
    final.model.terms.front().v(0) = 0.049;
    final.covariance = MatrixXd::Identity(final.model.size(), final.model.size()) * 1e-6;
    DiagnosisReport report;
    report.causes = {fitted("loose_mass")};
    report.causes.front().parameters = {{"mass", "g", 49.0, deviation}, {"damping", "", 0.05, 0.01}};
    giveVerdict(hypothesis, report.remaining, report);
    EXPECT_EQ(report.causes.size(), named) << deviation;
    EXPECT_EQ(report.verdict, named > 0 ? Verdict::explained : Verdict::unexplained) << deviation;
  }
}

TEST(Verdict, AFaintTouchBesideACauseMayBeItsRest) {
  const Hypothesis hypothesis = aJumpAndALoad();
  for (const auto& [evidence, verdict] : {std::pair{900.0, Verdict::unexplained},
                                          {3000.0, Verdict::explained},  // Far more than speaks for the other
                                          {1e5, Verdict::explained}}) {
    DiagnosisReport report;
    report.causes = {fitted("cable_pull"), fitted("contact")};
    report.causes.back().deltaBic = evidence;
    report.causes.back().direct = true;
    giveVerdict(hypothesis, report.remaining, report);
    EXPECT_EQ(report.verdict, verdict) << evidence;
    EXPECT_EQ(report.causes.size(), 2u);
  }
}

/// A small thing that remains is no reason to believe four causes at once: the question was not asked then.
TEST(Verdict, FourCausesAreAPatchworkWhateverRemains) {
  const Hypothesis hypothesis = aJumpAndALoad();
  DiagnosisReport report;
  report.causes = {fitted("viscous_drag"), fitted("constant_pull"), fitted("motion_lag"), fitted("coulomb_friction")};
  report.remaining.gain = 30.0;  // Less than three hundredths of what these explain
  giveVerdict(hypothesis, report.remaining, report);
  EXPECT_EQ(report.verdict, Verdict::unexplained) << said(report);
}

/// Beside a stronger cause, what four others explain as well has no name.
TEST(Verdict, AGuessBesideACauseIsNotNamed) {
  const Hypothesis hypothesis = aJumpAndALoad();
  DiagnosisReport report;
  report.causes = {fitted("joint_offset"), fitted("sensor_rotation")};
  report.causes[1].deltaBic = 25.0;
  report.causes[1].alternatives = {"bias_drift", "contact", "gravity_tilt", "crosstalk"};
  giveVerdict(hypothesis, report.remaining, report);
  EXPECT_EQ(report.verdict, Verdict::unexplained) << said(report);
  ASSERT_EQ(report.causes.size(), 1u) << said(report);
  EXPECT_EQ(report.causes.front().id, "joint_offset");
}

/// What explains a little beside a strong cause is mostly what that one's form does not quite have.
TEST(Verdict, ASlightCauseBesideAStrongOneIsNotNamed) {
  const Hypothesis hypothesis = aJumpAndALoad();
  for (const auto& [explains, names] : {std::pair{0.1, 1u}, {0.7, 2u}}) {
    DiagnosisReport report;
    report.causes = {fitted("gain_error"), fitted("viscous_drag")};
    report.causes.front().deltaBic = 5000.0;
    report.causes.back().gain.explainedFraction = explains;
    giveVerdict(hypothesis, report.remaining, report);
    EXPECT_EQ(report.causes.size(), names) << explains;
    EXPECT_EQ(report.causes.front().id, "gain_error") << explains;
    EXPECT_EQ(report.verdict, Verdict::explained) << explains;
  }
}

/// Without positions, what helps to describe an unknown that more speaks for is not found; what was seen in the samples
/// was.
TEST(Verdict, WhatExplainsLessThanTheUnknownIsNotTold) {
  DiagnosisReport report;
  report.verdict = Verdict::unexplained;
  report.remaining.gain = 349.0;
  report.causes = {fitted("time_offset"), fitted("saturation"), fitted("contact")};
  report.causes[0].deltaBic = 400.0;
  report.causes[1].deltaBic = 59.0;
  report.causes[2].deltaBic = 0.0;
  report.causes[2].direct = true;
  dropBesideUnknown(report);
  EXPECT_EQ(report.causes.size(), 3u) << "the position is known";
  report.findings.push_back({Severity::warning, "origin_acceleration_unknown", "", "", {}});
  dropBesideUnknown(report);
  ASSERT_EQ(report.causes.size(), 2u);
  EXPECT_EQ(report.causes[0].id, "time_offset");
  EXPECT_EQ(report.causes[1].id, "contact");
  ASSERT_EQ(report.findings.size(), 2u);
  EXPECT_EQ(report.findings.back().code, "not_told");
  EXPECT_NE(report.findings.back().text.find("Sensor at its limit"), std::string::npos);
  dropBesideUnknown(report);
  EXPECT_EQ(report.findings.size(), 2u);
}

}  // namespace
}  // namespace heft::test
