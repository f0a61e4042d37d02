// Causes taken out one at a time, and the difference looked at from several sides.
#include "core/diagnosis/correction/corrected.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numbers>

#include "core/diagnosis/correction/check_on_other.h"
#include "core/diagnosis/correction/model_json.h"
#include "core/diagnosis/report/report.h"
#include "core/diagnosis/wording/views.h"
#include "core/wrench/regressor.h"
#include "tests/core/diagnosis/fixture.h"

namespace heft::test {
namespace {

struct Pulled {
  Recording recording = aRecording(MotionKind::free, 81, {{"cable_pull", "", 4.0}});
  DiagnosisReport report = diagnosed(recording);
  nlohmann::json found = toJson(report);
};

const Pulled& pulled() {
  static const Pulled kPulled;
  return kPulled;
}

TEST(Corrected, PayloadAndPredictionUseTheCause) {
  const auto& p = pulled();
  ASSERT_FALSE(p.report.causes.empty());
  EXPECT_EQ(p.report.causes[0].id, "cable_pull");
  EXPECT_TRUE(canApply(p.report, p.report.causes[0]));
  const EstimateOptions options;
  const auto plain = estimateWith(p.recording, &RobotModel::panda(), options, p.found, {});
  const auto with = estimateWith(p.recording, &RobotModel::panda(), options, p.found, {"cable_pull"});
  ASSERT_TRUE(plain.ok());
  ASSERT_TRUE(with.ok()) << with.error().message;
  EXPECT_LT(std::abs(with->payload.mass - 0.75), 0.2 * std::abs(plain->payload.mass - 0.75));
  EXPECT_NEAR(with->payload.mass, p.report.after.payload.mass, 1e-9);
  EXPECT_GE(with->std.mass, 0.999 * p.report.after.std.mass);
  // The simulated wrench comes closer to what was measured, and that still is what was recorded.
  const auto misfit = [](const EstimateReport& r) { return (r.series.measured - r.series.simulated).norm(); };
  EXPECT_LT(misfit(*with), 0.5 * misfit(*plain));
  EXPECT_LT((with->series.measured - plain->series.measured).cwiseAbs().maxCoeff(), 0.05);
}

TEST(Corrected, WhatWasNotFoundCannotBeApplied) {
  const auto& p = pulled();
  EXPECT_FALSE(corrected(p.recording, &RobotModel::panda(), p.found, {"time_offset"}).ok());
  EXPECT_FALSE(corrected(p.recording, &RobotModel::panda(), nlohmann::json::array(), {"cable_pull"}).ok());
  auto broken = p.found;
  broken.erase("model");
  EXPECT_FALSE(corrected(p.recording, &RobotModel::panda(), broken, {"cable_pull"}).ok());
}

TEST(Corrected, OlderFormsAreReadAndStrangeOnesStayOut) {
  const auto& p = pulled();
  auto found = p.found;
  // Compilers disagree whether braces around one element make an array.
  const auto arrayOf = [](nlohmann::json element) { return nlohmann::json::array({std::move(element)}); };
  found["model"]["terms"] = arrayOf(
      {{"cause", "coulomb_friction"}, {"form", "giving way"}, {"choice", arrayOf(4)}, {"values_si", {0.3, 0.01}}});
  found["causes"] = arrayOf({{"cause", "coulomb_friction"}});
  // Friction that gives way acted at the sensor's origin before it had a place.
  const auto model = modelFromJson(found["model"], p.recording, &RobotModel::panda());
  ASSERT_TRUE(model.ok()) << model.error().message;
  ASSERT_EQ(model->terms.size(), 1u);
  EXPECT_DOUBLE_EQ(model->terms[0].v(0), 0.3);
  EXPECT_EQ(model->terms[0].v.tail(model->terms[0].v.size() - 2).norm(), 0.0);

  // Nobody knows this one any more: the estimate is what it is without it, and says so in one sentence.
  for (const char* broken : {R"({"cause":"coulomb_friction","choice":[99],"values_si":[1]})",
                             R"({"cause":"aether_wind","choice":[],"values_si":[1]})"}) {
    found["model"]["terms"] = arrayOf(nlohmann::json::parse(broken));
    const std::string id = found["model"]["terms"][0]["cause"];
    found["causes"] = arrayOf({{"cause", id}});
    EXPECT_FALSE(corrected(p.recording, &RobotModel::panda(), found, {id}).ok());
    const auto with = estimateWith(p.recording, &RobotModel::panda(), {}, found, {id});
    const auto plain = estimate(p.recording, &RobotModel::panda(), {});
    ASSERT_TRUE(with.ok() && plain.ok());
    EXPECT_EQ(with->payload.mass, plain->payload.mass);
    EXPECT_EQ(std::count_if(with->findings.begin(), with->findings.end(),
                            [](const auto& f) { return f.code == "causes_unknown"; }),
              1);
    EXPECT_EQ(std::count_if(with->findings.begin(), with->findings.end(),
                            [](const auto& f) { return f.code == "causes_taken_out"; }),
              0);
  }
}

TEST(Corrected, AWrongSignIsTurnedRoundAndAContactMarked) {
  Recording recording = aRecording(MotionKind::excitation, 82);
  recording.wrench = -recording.wrench;
  const DiagnosisReport report = diagnosed(recording);
  ASSERT_TRUE(report.mistake.has_value());
  ASSERT_TRUE(canApply(report, report.causes.front()));
  auto found = toJson(report);
  const auto out = corrected(recording, &RobotModel::panda(), found, {report.causes.front().id});
  ASSERT_TRUE(out.ok()) << out.error().message;
  EXPECT_LT((out->wrench + recording.wrench).cwiseAbs().maxCoeff(), 1e-12);
  found["causes"].push_back({{"cause", "contact"}, {"direct", true}, {"when", {{2.0, 3.0}}}});
  const auto marked = corrected(recording, &RobotModel::panda(), found, {"contact"});
  ASSERT_TRUE(marked.ok());
  ASSERT_EQ(marked->meta.marks.size(), recording.meta.marks.size() + 1);
  EXPECT_EQ(marked->meta.marks.back().label, MarkLabel::contact);
}

/// [rad]
Vector3d turnOf(const DiagnosedCause& cause) {
  Vector3d out;
  for (Eigen::Index i = 0; i < 3; ++i) out(i) = findParameter(cause.parameters, std::string("r") + "xyz"[i])->value;
  return out * std::numbers::pi / 180.0;
}

/// A sensor that is mounted turned by a quarter: beside joints the setup file says how it is mounted, and is to be
/// corrected; where the recording states the sensor's poses, nothing in that file would change anything.
TEST(Corrected, AMetaFileIsNotBlamedForPosesThatWereRecorded) {
  Recording joints = aRecording(MotionKind::free, 83);
  const Matrix3d turn = rotationFromVector({0.0, 0.0, std::numbers::pi / 2.0});
  joints.wrench.leftCols<3>() = (joints.wrench.leftCols<3>() * turn).eval();
  joints.wrench.rightCols<3>() = (joints.wrench.rightCols<3>() * turn).eval();
  for (const bool ofPoses : {false, true}) {
    const Recording recording = ofPoses ? asPoses(joints) : joints;
    const auto report = diagnosed(recording);
    const auto wrong = std::ranges::find_if(report.causes, mountIsWrong);
    ASSERT_NE(wrong, report.causes.end()) << said(report);
    EXPECT_NEAR(report.after.payload.mass, aTool().mass, 0.01);
    // To a fraction of a degree, not as far as weight and acceleration alone tell.
    EXPECT_LT((rotationFromVector(turnOf(*wrong)) * turn.transpose() - Matrix3d::Identity()).norm(), 0.01);
    EXPECT_EQ(report.metaChanges().empty(), ofPoses);
    EXPECT_EQ(wrong->check.find("recorded poses") != std::string::npos, ofPoses) << wrong->check;
    // Put right in the numbers it can be either way.
    EXPECT_TRUE(canApply(report, *wrong));
    const auto applied = corrected(recording, &RobotModel::panda(), toJson(report), {wrong->id});
    ASSERT_TRUE(applied.ok());
    const auto again = diagnosed(*applied);
    EXPECT_TRUE(again.causes.empty()) << said(again);
  }
}

/// The setup file of a robot on a floor, for one that hangs on a wall: that was a steady pull of a load and a half.
TEST(Corrected, ARobotOnAWallHasAnotherGravity) {
  Recording recording = aRecording(MotionKind::free, 84);
  const Vector3d down = recording.meta.gravity;
  recording.meta.gravity = {-9.81, 0.0, 0.0};
  const auto report = diagnosed(recording);
  ASSERT_EQ(report.causes.size(), 1u) << said(report);
  EXPECT_EQ(report.causes[0].id, "frame_error");
  EXPECT_EQ(report.causes[0].alternatives, std::vector<std::string>{"gravity_tilt"});
  EXPECT_NEAR(report.after.payload.mass, 0.75, 0.005) << said(report);
  ASSERT_TRUE(canApply(report, report.causes[0]));
  const auto out = corrected(recording, &RobotModel::panda(), toJson(report), {"frame_error"});
  ASSERT_TRUE(out.ok()) << out.error().message;
  EXPECT_TRUE(out->meta.gravity.isApprox(down, 1e-6)) << out->meta.gravity.transpose();
}

/// The same where the tool also touches something at each place: that was a steady pull beside the touches.
TEST(Corrected, TouchesHideNoOtherGravity) {
  Recording recording = aRecording(MotionKind::pickAndPlace, 2);
  recording.meta.marks.clear();
  recording.meta.gravity = {9.81, 0.0, 0.0};
  const auto report = diagnosed(recording);
  ASSERT_FALSE(report.causes.empty()) << said(report);
  EXPECT_EQ(report.causes.front().id, "frame_error") << said(report);
  EXPECT_EQ(named(report, "constant_pull"), nullptr) << said(report);
  EXPECT_NEAR(report.after.payload.mass, 0.75, 0.02) << said(report);
}

/// Nor a sensor that is mounted turned by half, nor swapped columns, and the touches are found beside them: with these,
/// what was no touch looked like one, and the sign of all forces was changed, or a loose mass was found.
TEST(Corrected, TouchesHideNoMistake) {
  for (const char* form : {"mount-180", "swapped-xy"}) {
    Recording recording = aRecording(MotionKind::pickAndPlace, 508, {{"frame_error", form, 1.0}});
    recording.meta.marks.clear();
    const auto report = diagnosed(recording);
    EXPECT_EQ(report.verdict, Verdict::explained) << form << ": " << said(report);
    ASSERT_EQ(report.causes.size(), 2u) << form << ": " << said(report);
    EXPECT_EQ(report.causes.front().id, "frame_error") << form << ": " << said(report);
    EXPECT_EQ(report.causes.back().id, "contact") << form << ": " << said(report);
    ASSERT_TRUE(report.mistake) << form;
    EXPECT_TRUE(report.mistake->has(conventions::Change::turned)) << form;
    EXPECT_NEAR(report.after.payload.mass, aTool().mass, 0.01) << form;
  }
}

/// A balancer that carries half of the tool leaves less weight than the tool resists being accelerated with: no
/// mistake.
TEST(Corrected, ABalancerIsNoOtherGravity) {
  Recording recording = aRecording(MotionKind::free, 85);
  const auto motion = motionOf(recording, &RobotModel::panda(), {}).value();
  for (Eigen::Index i = 0; i < recording.rows(); ++i)
    recording.wrench.row(i).head<3>() -=
        (motion.R_BS[static_cast<std::size_t>(sampleAt(motion, recording.time(i)))].transpose() *
         Vector3d(9.0, 0.0, 4.0))
            .transpose();
  const auto report = diagnosed(recording);
  EXPECT_EQ(named(report, "frame_error"), nullptr) << said(report);
  EXPECT_NE(named(report, "constant_pull"), nullptr) << said(report);
}

TEST(Views, TheStretchShowsTheCauseAndThePullGoesWithThePlace) {
  const auto& p = pulled();
  const auto& cause = p.report.causes[0];
  const auto stretch = diagnosis::tellingStretch(p.report.series, cause.before, cause.after, 3.0);
  EXPECT_NEAR(stretch.to - stretch.from, 3.0, 0.1);
  double was = 0, is = 0;
  for (Eigen::Index n = 0; n < p.report.series.time.size(); ++n)
    if (p.report.series.time(n) >= stretch.from && p.report.series.time(n) <= stretch.to) {
      was += std::pow(cause.before(stretch.channel, n), 2);
      is += std::pow(cause.after(stretch.channel, n), 2);
    }
  EXPECT_GT(was, 9.0 * is);
  const auto witnesses = diagnosis::witnesses(p.recording, &RobotModel::panda());
  ASSERT_TRUE(witnesses.ok());
  double place = 0, speed = 0;
  for (const auto& w : *witnesses) {
    ASSERT_EQ(w.value.size(), p.report.series.time.size()) << w.id;
    for (int c = 0; c < 3; ++c) {
      const double r = std::abs(diagnosis::correlation(p.report.series, w.value, cause.before.row(c).transpose()));
      EXPECT_LE(r, 1.0 + 1e-9);
      if (w.id.starts_with("position")) place = std::max(place, r);
      if (w.id.starts_with("velocity_")) speed = std::max(speed, r);
    }
  }
  EXPECT_GT(place, speed);
}

TEST(Views, TheSpectrumFallsToTheFloor) {
  const auto spectrum = diagnosis::spectrumOf(pulled().report.series, false);
  ASSERT_GT(spectrum.frequency.size(), 20);
  EXPECT_GT(spectrum.floor, 0.0);
  EXPECT_GT(spectrum.before(0), 10.0 * spectrum.after(0));
  // A pull is slow: the fast end is noise with and without it.
  const auto last = spectrum.after.size() - 2;
  EXPECT_LT(spectrum.before(last), 0.1 * spectrum.before(0));
  EXPECT_NEAR(spectrum.after(last), spectrum.floor, spectrum.floor);
}

TEST(Views, TheNoiseOfTheVerdictLiesUnderTheSpectrum) {
  const auto& series = pulled().report.series;
  const auto spectrum = diagnosis::spectrumOf(series, false);
  const VectorXd level = diagnosis::noiseLevel(series, false, spectrum.frequency);
  ASSERT_EQ(level.size(), spectrum.after.size());
  // Of what the cause leaves, at every frequency; of the pull itself not.
  double ratio = 0.0;
  for (Eigen::Index k = 0; k + 1 < level.size(); ++k) ratio += std::log(spectrum.after(k) / level(k));
  EXPECT_NEAR(ratio / static_cast<double>(level.size() - 1), 0.0, 0.25);
  EXPECT_GT(spectrum.before(0), 5.0 * level(0));
}

/// A part is taken up between two readings: when is known to about a reading, and a stretch that is left out with that
/// moment in it is predicted all the same. It was "6.5 +- 1.0 s", and gained a third of what it does.
TEST(Corrected, WhatHappensAtOnceHasItsTimeAndItsGain) {
  Recording recording = aRecording(MotionKind::free, 85);
  const auto motion = motionOf(recording, &RobotModel::panda(), {}).value();
  Payload part;
  part.mass = 0.25;
  part.com = {0.02, -0.01, 0.12};
  part.inertiaCom = Vector3d(2e-5, 2e-5, 2e-5).asDiagonal();
  for (Eigen::Index i = 0; i < recording.rows(); ++i)
    if (recording.time(i) > 6.4617) {
      const auto k = sampleAt(motion, recording.time(i));
      recording.wrench.row(i) +=
          predictWrench(part, {motion.specificForce.col(k), motion.omega.col(k), motion.alpha.col(k)}).transpose();
    }
  const auto report = diagnosed(recording);
  const DiagnosedCause* load = named(report, "payload_change");
  ASSERT_NE(load, nullptr) << said(report);
  const CauseParameter* time = findParameter(load->parameters, "time");
  EXPECT_NEAR(time->value, 6.4617, 3.0 * time->std);
  EXPECT_LT(time->std, 0.02);
  const CauseParameter* lasts = findParameter(load->parameters, "duration");
  ASSERT_NE(lasts, nullptr);
  EXPECT_LT(lasts->std, 0.1);
  EXPECT_LT(load->gain.forceAfter, 1.15 * report.noise.force);
  EXPECT_LT(load->gain.torqueAfter, 1.15 * report.noise.torque);
  EXPECT_EQ(load->gain.blocksBetter, load->gain.blocks);
}

/// All at once, as for the forces of a demonstration: on the recording itself, and on another of the same rig, where
/// what happened at one moment did not.
TEST(Corrected, ByAllThatWasFound) {
  const auto& p = pulled();
  auto found = p.found;
  found["causes"].push_back({{"cause", "contact"}, {"direct", true}, {"when", {{2.0, 3.0}}}});
  const auto own = correctedByAll(p.recording, &RobotModel::panda(), found, "found.json");
  ASSERT_TRUE(own.ok()) << own.error().message;
  EXPECT_EQ(own->meta.marks.size(), p.recording.meta.marks.size() + 1);
  const auto one = corrected(p.recording, &RobotModel::panda(), p.found, {"cable_pull"});
  EXPECT_LT((own->wrench - one->wrench).cwiseAbs().maxCoeff(), 1e-12);
  Recording other = aRecording(MotionKind::free, 82, {{"cable_pull", "", 4.0}});
  other.file = "another.csv";
  const auto corrected = correctedByAll(other, &RobotModel::panda(), found, "found.json");
  ASSERT_TRUE(corrected.ok()) << corrected.error().message;
  EXPECT_EQ(corrected->meta.marks.size(), other.meta.marks.size());
  EXPECT_GT((corrected->wrench - other.wrench).norm(), 0.1 * std::sqrt(static_cast<double>(other.rows())));
  for (const nlohmann::json& strange : {nlohmann::json::array(), nlohmann::json{{"schema", "heft.estimate/1"}}}) {
    const auto refused = correctedByAll(other, &RobotModel::panda(), strange, "other.json");
    ASSERT_FALSE(refused.ok());
    EXPECT_NE(refused.error().message.find("other.json is not a result of heft diagnose"), std::string::npos);
  }
}

/// Another recording's zero drifts another way, or not at all.
TEST(Corrected, ADriftStaysInTheRecordingThatItWasFoundIn) {
  const Recording recording = aRecording(MotionKind::excitation, 83, {{"bias_drift", "", 0.8}});
  const auto report = diagnosed(recording);
  ASSERT_NE(named(report, "bias_drift"), nullptr) << said(report);
  Recording other = aRecording(MotionKind::free, 84);
  other.file = "another.csv";
  const auto corrected = correctedByAll(other, &RobotModel::panda(), toJson(report), "found.json");
  ASSERT_TRUE(corrected.ok()) << corrected.error().message;
  EXPECT_EQ((corrected->wrench - other.wrench).norm(), 0.0);
  const auto check = checkOn(report, other, &RobotModel::panda());
  ASSERT_TRUE(check.ok());
  EXPECT_TRUE(check->checked.empty());
  EXPECT_EQ(check->ofOneMoment, std::vector<std::string>{"bias_drift"});
  EXPECT_NE(checkText(*check).find("belongs to its own recording"), std::string::npos) << checkText(*check);
}

}  // namespace
}  // namespace heft::test
