// The contract's JSON, the text, the page, and the extended model outside the search.
#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>

#include "core/diagnosis/correction/check_on_other.h"
#include "core/diagnosis/correction/model_json.h"
#include "core/diagnosis/report/html_report.h"
#include "core/diagnosis/report/report.h"
#include "tests/core/diagnosis/fixture.h"

namespace heft::test {
namespace {

struct Made {
  Recording recording = aRecording(MotionKind::free, 71, {{"time_offset", "", 15.0}});
  DiagnosisReport report = diagnosed(recording);
};

const Made& made() {
  static const Made kMade;
  return kMade;
}

TEST(DiagnosisReport, HasTheContractsKeys) {
  const nlohmann::json j = toJson(made().report);
  EXPECT_EQ(j["schema"], "heft.diagnose/1");
  for (const char* key : {"force_rms_n", "torque_rms_nm", "noise_force_rms_n", "noise_torque_rms_nm"})
    EXPECT_TRUE(j["baseline"][key].is_number()) << key;
  ASSERT_FALSE(j["causes"].empty());
  const auto& cause = j["causes"][0];
  EXPECT_EQ(cause["cause"], "time_offset");
  EXPECT_NEAR(cause["parameters"]["delay"]["value"].get<double>(), 15.0, 1.0);
  EXPECT_EQ(cause["parameters"]["delay"]["unit"], "ms");
  for (const char* key : {"delta_bic", "p_value"}) EXPECT_TRUE(cause["evidence"][key].is_number()) << key;
  for (const char* key : {"force_rms_before_n", "force_rms_after_n", "torque_rms_before_nm", "torque_rms_after_nm",
                          "explained_fraction", "blocks_better", "blocks"})
    EXPECT_TRUE(cause["gain"][key].is_number()) << key;
  EXPECT_TRUE(cause["when"].is_array() && cause["alternatives"].is_array() && cause["tell_apart"].is_string());
  for (const char* payload : {"payload_before", "payload_after"})
    for (const char* key : {"mass_kg", "com_m", "inertia_com_kgm2", "std"})
      EXPECT_TRUE(j[payload].contains(key)) << key;
  EXPECT_TRUE(j["findings"].is_array());
}

TEST(DiagnosisReport, TextAndPageNameTheCause) {
  EXPECT_NE(toText(made().report).find("time_offset"), std::string::npos);
  const auto witnesses = diagnosis::witnesses(made().recording, &RobotModel::panda()).value();
  const std::string page = toHtml(made().report, witnesses);
  EXPECT_NE(page.find("<svg"), std::string::npos);
  EXPECT_NE(page.find("Force readings late (delay)"), std::string::npos);
  EXPECT_EQ(page.find("http"), std::string::npos) << "A page on its own fetches nothing.";
  EXPECT_EQ(page.find("nan"), std::string::npos);
  for (const char* part : {"Force residual spectrum", "Torque residual spectrum", "Where the residual is",
                           "sign of the velocity, x", "<circle", "in standard deviations"})
    EXPECT_NE(page.find(part), std::string::npos) << part;
  EXPECT_EQ(toHtml(made().report, {}).find("<circle"), std::string::npos);
}

/// Names as a person reads them, not the file's.
TEST(DiagnosisReport, PageSaysWhatElseWasNoticed) {
  DiagnosisReport report = made().report;
  report.findings.push_back({Severity::info, "zero_wanders", "The zero <wanders>.", "Let it warm up.", {}});
  report.causes.front().alternatives = {"motion_lag"};
  report.check = {"other.csv", {0.5, 0.05}, {0.1, 0.01}, 50.0, false, {"motion_lag"}, {"bias_drift"}};
  const std::string page = toHtml(report, {});
  for (const char* part : {"The zero &lt;wanders&gt;. Let it warm up.", "other.csv: 0.500 &rarr; 0.100 N",
                           "Holds on other.csv, too: &quot;Accelerations late (motion lag)&quot;.",
                           "belongs to one recording: &quot;Sensor zero drifts (bias drift)&quot;",
                           "Accelerations late (motion lag)", "Robot base tilted"})
    EXPECT_NE(page.find(part), std::string::npos) << part;
  for (const char* part : {"motion_lag", "gravity_tilt", "Unknown:"})
    EXPECT_EQ(page.find(part), std::string::npos) << part;
  report.verdict = Verdict::unexplained;
  report.remaining = {"the size of the load", 50.0, 0.25, 0.0, 0.0};
  EXPECT_NE(toHtml(report, {}).find("25.0 % of the remaining difference is related to the size of the load"),
            std::string::npos);
}

TEST(DiagnosisReport, ATermThatTheTitleHoldsIsNotSaidTwice) {
  DiagnosisReport report = made().report;
  report.causes.resize(1);
  EXPECT_NE(toText(report).find("1. Force readings late (delay) (time_offset)\n"), std::string::npos);
  report.causes[0].id = "quantisation";
  report.causes[0].title = "Coarse readings (quantisation)";
  EXPECT_NE(toText(report).find("1. Coarse readings (quantisation)\n"), std::string::npos) << toText(report);
}

TEST(DiagnosisReport, SaysByHowMuchThePayloadMoves) {
  DiagnosisReport report = made().report;
  report.before.payload.mass = 1.0;
  report.before.std.mass = 0.01;
  report.after.payload.mass = 0.95;
  report.before.std.com.y() = 0.0;
  const Vector10d moved = payloadShift(report);
  EXPECT_NEAR(moved(0), 5.0, 1e-9);
  EXPECT_EQ(moved(2), 0.0) << "Of a deviation that is unknown";
  EXPECT_NEAR(toJson(report)["payload_shift_sigmas"]["mass"].get<double>(), 5.0, 1e-9);
  EXPECT_NE(toText(report).find("5.0 sigma (mass)"), std::string::npos);
}

TEST(DiagnosisReport, ModelSurvivesItsFile) {
  const auto& m = made();
  const auto again = modelFromJson(toJson(m.report)["model"], m.recording, &RobotModel::panda());
  ASSERT_TRUE(again.ok()) << again.error().message;
  const auto a = effectOf(m.report.model, m.recording, &RobotModel::panda());
  const auto b = effectOf(*again, m.recording, &RobotModel::panda());
  ASSERT_TRUE(a.ok() && b.ok());
  EXPECT_LT((*a - *b).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_GT(a->cwiseAbs().maxCoeff(), 0.05);
  const auto none = effectOf(m.report.model, m.recording, &RobotModel::panda(), {"cable_pull"});
  EXPECT_LT(none->cwiseAbs().maxCoeff(), 1e-12);
  for (const char* broken : {"[]", "{}", R"({"bias_and_parameters": [1], "terms": []})", R"({"terms": 3})"})
    EXPECT_FALSE(modelFromJson(nlohmann::json::parse(broken), m.recording, &RobotModel::panda()).ok());
}

TEST(DiagnosisReport, ChecksOnAnotherRecordingOfTheSameRig) {
  const Recording other = aRecording(MotionKind::excitation, 72, {{"time_offset", "", 15.0}});
  const auto check = checkOn(made().report, other, &RobotModel::panda());
  ASSERT_TRUE(check.ok()) << check.error().message;
  EXPECT_LT(check->after.torque, 0.8 * check->before.torque);
  EXPECT_TRUE(check->holds());
  EXPECT_EQ(check->checked, std::vector<std::string>{"time_offset"});
  // On a rig without the fault it makes things worse, and says so.
  const auto wrong = checkOn(made().report, aRecording(MotionKind::excitation, 73), &RobotModel::panda());
  ASSERT_TRUE(wrong.ok());
  EXPECT_GT(wrong->after.torque, wrong->before.torque);
  EXPECT_FALSE(wrong->holds());
  EXPECT_TRUE(checkText(*wrong).starts_with("Makes") && checkText(*wrong).find("worse") != std::string::npos)
      << checkText(*wrong);
}

/// The same mistake in both files. Forces with the wrong sign leave no more than right ones, but for a mass below zero.
TEST(DiagnosisReport, ChecksAMistakeOfSignsOnAnotherRecording) {
  const auto gravity = [](Recording& r) { r.meta.gravity = -r.meta.gravity; };
  const auto wrench = [](Recording& r) { r.wrench = -r.wrench; };
  for (const auto& mixUp : {std::function<void(Recording&)>(gravity), {wrench}}) {
    Recording one = aRecording(MotionKind::excitation, 74), other = aRecording(MotionKind::excitation, 75);
    mixUp(one);
    mixUp(other);
    const auto report = diagnosed(one);
    ASSERT_TRUE(report.mistake) << said(report);
    const auto check = checkOn(report, other, &RobotModel::panda());
    ASSERT_TRUE(check.ok()) << check.error().message;
    EXPECT_TRUE(check->holds());
    EXPECT_EQ(check->checked, std::vector<std::string>{"frame_error"});
  }
}

}  // namespace
}  // namespace heft::test
