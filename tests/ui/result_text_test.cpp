#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/ui/fixtures.h"
#include "ui/models/numbers.h"
#include "ui/models/result_text.h"
#include "ui/models/units.h"

namespace heft {
namespace {

TEST(NumberText, HasARealMinusAndFixedDecimals) {
  EXPECT_EQ(numberText(-0.5, 1), QString::fromUtf8("−0.5"));
  EXPECT_EQ(numberText(45.8, 1), "45.8");
  EXPECT_EQ(numberText(12345.6, 0), "12346");
  EXPECT_EQ(numberText(-0.04, 1), "0.0");
  EXPECT_EQ(numberText(std::nan(""), 1), QString::fromUtf8("—"));
}

TEST(DecimalsFor, FollowsTheUncertainty) {
  EXPECT_EQ(decimalsFor(0.004, 4), 3);
  EXPECT_EQ(decimalsFor(0.6, 2), 1);
  EXPECT_EQ(decimalsFor(1.3, 3), 1);
  EXPECT_EQ(decimalsFor(0.0151, 4), 3);
  EXPECT_EQ(decimalsFor(70, 3), 0);
  EXPECT_EQ(decimalsFor(1e-9, 4), 4);
  EXPECT_EQ(decimalsFor(0, 3), 3);
}

TEST(DescribeResult, SaysItInWordsFirst) {
  const Recording recording = test::sineRecording(1000, 100);
  const ResultText text = describeResult(test::reportOn(recording), {});
  EXPECT_EQ(text.question, "Your tool weighs 0.81 kg.");
  EXPECT_EQ(text.answer, "Mass, centre of mass and inertia: all measured.");
  EXPECT_EQ(text.mass.value, "0.812");
  EXPECT_EQ(text.mass.plusMinus, QString::fromUtf8("± 0.004 kg"));
  ASSERT_EQ(text.com.size(), 3u);
  EXPECT_EQ(text.com[0].value, "1.4");
  EXPECT_EQ(text.com[1].value, QString::fromUtf8("−0.5"));
  EXPECT_EQ(text.com[2].value, "45.8");
  EXPECT_EQ(text.com[2].plusMinus, QString::fromUtf8("± 0.6 mm"));
  ASSERT_EQ(text.inertia.size(), 6u);
  EXPECT_EQ(text.inertia[0].value, "16.0");
  EXPECT_EQ(text.inertiaUnit, QString::fromUtf8("kg cm²"));
}

TEST(DescribeResult, SaysWhatIsNotKnown) {
  const Recording recording = test::sineRecording(1000, 100);
  EstimateReport report = test::reportOn(recording);
  for (auto& row : report.identifiability.inertia) row.fill(Source::none);
  report.identifiability.weakDirections = {"turn the tool faster about its long axis"};
  report.findings = {{Severity::info, "weak_direction", "turn the tool faster about its long axis", "", {}},
                     {Severity::info, "note", "a note", "", {}},
                     {Severity::warning, "rows_repeat", "a third of the rows repeat", "look", {}}};
  const ResultText text = describeResult(report, {});
  EXPECT_EQ(text.answer, "Mass and centre are measured; inertia is not fully determined by this motion.");
  EXPECT_EQ(text.advice, "Turn the tool faster about its long axis");
  // The three products share one row; the advice is not said twice; the gravest finding comes first.
  ASSERT_EQ(text.inertia.size(), 4u);
  EXPECT_EQ(text.inertia[3].name, "Ixy, Ixz, Iyz");
  ASSERT_EQ(text.findings.size(), 2u);
  EXPECT_EQ(text.findings[0].severity, Severity::warning);
  EXPECT_FALSE(text.doubtful);
  report.identifiability.mass = Source::none;
  EXPECT_EQ(describeResult(report, {}).question, "This motion does not determine the mass.");
}

TEST(DescribeResult, AHopelessIntervalIsADash) {
  const Recording recording = test::sineRecording(1000, 100);
  EstimateReport report = test::reportOn(recording);
  report.identifiability.inertia[1][1] = Source::none;
  report.interval95.inertiaCom[1][1] = {-1.0, 1.0};
  const ResultText text = describeResult(report, {});
  EXPECT_EQ(text.inertia[0].value, "16.0");
  EXPECT_EQ(text.inertia[1].value, QString::fromUtf8("—"));
  EXPECT_TRUE(text.inertia[1].plusMinus.isEmpty());
  EXPECT_TRUE(text.inertia[1].tip.contains("95 %"));
}

TEST(DescribeResult, AMisfitComesBeforePraise) {
  const Recording recording = test::sineRecording(1000, 100);
  EstimateReport report = test::reportOn(recording);
  report.findings = {{Severity::warning, "misfit", "the model misses the force by 0.4 N", "look", {}}};
  const ResultText text = describeResult(report, {});
  EXPECT_TRUE(text.doubtful);
  EXPECT_TRUE(text.findings.at(0).doubt);
  EXPECT_FALSE(text.answer.contains("measured"));
}

TEST(DescribeResult, WhatIsDoubtedIsNotCalledMeasured) {
  const Recording recording = test::sineRecording(1000, 100);
  EstimateReport report = test::reportOn(recording);
  report.identifiability.mass = Source::data;
  report.identifiability.inertia[0][0] = Source::doubted;
  const ResultText text = describeResult(report, {});
  EXPECT_EQ(sourceWord(text.mass.source), "measured");
  EXPECT_EQ(sourceWord(text.inertia.at(0).source), "doubtful");
  // So is what a cause that was found would move out of its interval.
  OpenQuestion open;
  open.causes << "late";
  open.moved(0) = 3.0;
  EXPECT_EQ(sourceWord(describeResult(report, {}, open).mass.source), "doubtful");
}

TEST(DescribeResult, ComparesWithWhatIsStated) {
  const Recording recording = test::sineRecording(1000, 100);
  PartialPayload stated;
  stated.mass = 0.815;
  const ResultText text = describeResult(test::reportOn(recording), {stated});
  EXPECT_EQ(text.massNote, "you entered 0.815 kg, 0.4 % off");
  EXPECT_GT(text.massScale.stated, text.massScale.value);
  EXPECT_LT(text.massScale.from, text.massScale.value);
  EXPECT_GT(text.massScale.to, text.massScale.value);
}

TEST(DescribeResult, SpeaksTheUnitsThatAreChosen) {
  const Recording recording = test::sineRecording(1000, 100);
  PartialPayload stated;
  stated.mass = 0.815;
  setUnits({true, true, true, false});
  const ResultText text = describeResult(test::reportOn(recording), {stated});
  setUnits({});
  EXPECT_EQ(text.question, "Your tool weighs 812 g.");
  EXPECT_EQ(text.mass.value, "812");
  EXPECT_EQ(text.mass.plusMinus, QString::fromUtf8("± 4 g"));
  EXPECT_EQ(text.massNote, "you entered 815 g, 0.4 % off");
  EXPECT_NEAR(text.com[2].value.toDouble() * 25.4, 1e3 * test::reportOn(recording).payload.com.z(), 0.5);
  EXPECT_TRUE(text.com[2].plusMinus.endsWith(" in"));
  QString details;
  for (const DetailText& detail : text.details) details += detail.name + detail.value + '\n';
  EXPECT_TRUE(details.contains("N mm")) << details.toStdString();
  QString frame;
  for (const DetailText& detail : text.frames.at(0)) frame += detail.name + detail.value + '\n';
  EXPECT_TRUE(frame.contains("Principal moments")) << frame.toStdString();
}

TEST(DescribeResult, TheSharesAgreeWithWhereTheNumbersComeFrom) {
  EstimateReport report = test::reportOn(test::sineRecording(1000, 100));
  report.evidence.hasPrior = true;
  report.identifiability.inertiaShare = 0.99;  // Of the vague prior; what the shape gave is another question.
  report.std.inertiaCom = Matrix3d::Constant(1e-4);
  report.evidence.dataStd << 0.002, 0.0003, 0.0003, 0.0004, 2e-4, 2e-4, 2e-4, 4e-4, 2e-4, std::nan("");
  const ResultText text = describeResult(report, {});
  ASSERT_EQ(text.shares.size(), 3u);
  EXPECT_EQ(text.shares[0].words, "100 % data");
  EXPECT_EQ(text.shares[1].words, "100 % data");
  // A half, a quarter and nothing of the three deviations: (1/4 + 1/16 + 0) / 3.
  EXPECT_NEAR(text.shares[2].data, 0.3125 / 3.0, 1e-9);
  EXPECT_EQ(text.shares[2].words, "90 % your shape");
}

TEST(DescribeResult, StatesDetailsInTheFrameOfSensorOrFlange) {
  EstimateReport report = test::reportOn(test::sineRecording(1000, 100));
  report.mount.xyz = {0, 0, 0.04};
  report.mount.rpy = {0, 0, 1.5707963267948966};
  report.payload.com = {0.01, 0.0, 0.05};
  report.payload.inertiaCom = Vector3d(0.003, 0.002, 0.001).asDiagonal();
  const ResultText text = describeResult(report, {});
  ASSERT_EQ(text.frames.size(), 2u);
  const auto value = [&](std::size_t frame, const char* name) {
    for (const DetailText& row : text.frames[frame])
      if (row.name == name) return row.value.toStdString();
    return std::string();
  };
  EXPECT_EQ(value(0, "Centre of mass"), "10.0  0.0  50.0 mm");
  EXPECT_EQ(value(1, "Centre of mass"), "0.0  10.0  90.0 mm");
  EXPECT_EQ(value(0, "Inertia about the centre").substr(0, 19), "30.00  20.00  10.00");
  EXPECT_EQ(value(1, "Inertia about the centre").substr(0, 19), "20.00  30.00  10.00");
  // m (y2 + z2) = 0.812 kg * 25 cm2 more about the sensor's x.
  EXPECT_EQ(value(0, "Inertia about the origin").substr(0, 5),
            numberText(30.0 + 25.0 * report.payload.mass, 2).toStdString());
}

TEST(DescribeResult, SaysTheDifferenceByChannel) {
  const Recording recording = test::sineRecording(1000, 100);
  const ResultText text = describeResult(test::reportOn(recording), {});
  const auto row = std::find_if(text.details.begin(), text.details.end(),
                                [](const auto& d) { return d.name == "Force by channel"; });
  ASSERT_NE(row, text.details.end());
  // The made-up simulation misses x by 0.25 N and nothing else.
  EXPECT_TRUE(row->value.startsWith("0.250  0.000  0.000 N")) << row->value.toStdString();
}

TEST(DescribeResult, SurvivesEmptyAndInfiniteNumbers) {
  EXPECT_FALSE(describeResult(EstimateReport{}, {}).question.isEmpty());
  const Recording recording = test::sineRecording(1000, 100);
  EstimateReport report = test::reportOn(recording);
  report.interval95.mass = {-INFINITY, INFINITY};
  report.interval95.com[1] = {-INFINITY, INFINITY};
  report.payload.inertiaCom(0, 0) = std::nan("");
  const ResultText text = describeResult(report, {});
  EXPECT_TRUE(text.mass.plusMinus.contains(QString::fromUtf8("—")));
}

}  // namespace
}  // namespace heft
