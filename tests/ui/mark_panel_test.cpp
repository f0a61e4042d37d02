#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QUndoStack>
#include <QVariant>
#include <limits>

#include "core/recording/csv_reader.h"
#include "core/robot/robot_model.h"
#include "core/simulation/simulate.h"
#include "ui/controller/workspace.h"
#include "ui/mark_panel/mark_panel.h"
#include "ui/timeline/playback.h"

namespace heft {
namespace {

/// A guided recording in which something pushes for a second.
QString pushedFile(const QTemporaryDir& folder) {
  Payload payload;
  payload.mass = 0.8;
  payload.com = {0.005, -0.01, 0.06};
  payload.inertiaCom = Vector3d(0.0021, 0.0019, 0.0012).asDiagonal();
  SimulateOptions options;
  options.motion = MotionKind::excitation;
  options.duration = 8.0;
  options.seed = 3;
  auto simulated = simulate(RobotModel::panda(), payload, options);
  EXPECT_TRUE(simulated.ok());
  for (Eigen::Index i = 0; i < simulated->recording.rows(); ++i)
    if (simulated->recording.time(i) > 4.0 && simulated->recording.time(i) < 5.0)
      simulated->recording.wrench(i, 0) += 9.0;
  const QString path = folder.filePath("pushed.csv");
  EXPECT_TRUE(writeRecording(simulated->recording, path.toStdString()).ok());
  return path;
}

TEST(MarkText, SaysWhetherEnoughIsLeft) {
  Segment a, b;
  a.from = 0, a.to = 2, a.label = MarkLabel::free;
  b.from = 2, b.to = 9, b.label = MarkLabel::contact;
  const MarkSummary little = summarise({a, b}, {false, true}, 9);
  EXPECT_FALSE(little.enough);
  EXPECT_EQ(little.suggestions, 1);
  EXPECT_DOUBLE_EQ(little.seconds[1], 7);
  EXPECT_EQ(confidenceWord(0.98), "high");
  EXPECT_EQ(stretchText(13, 15.3), QString::fromUtf8("13.0 – 15.3 s"));
}

TEST(MarkPanel, SuggestionsAreDecidedByAClickAndUndone) {
  QTemporaryDir folder;
  Workspace workspace;
  Playback playback;
  StudioParts parts;
  parts.workspace = &workspace;
  parts.playback = &playback;
  Step gone = Step::mark;
  parts.goTo = [&](Step step) { gone = step; };
  MarkPanel panel(parts);
  panel.resize(440, 900);
  panel.show();
  EXPECT_EQ(panel.state().progress, StepState::Progress::later);
  workspace.open(pushedFile(folder));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workspace.busy(); }, 60000));
  ASSERT_TRUE(workspace.report());
  EXPECT_EQ(panel.state().light, Light::look);
  auto* yes = panel.findChild<QPushButton*>("acceptButton");
  ASSERT_NE(yes, nullptr);
  EXPECT_EQ(yes->text(), "Yes, contact");
  EXPECT_TRUE(panel.findChild<QPushButton*>("mainButton")->text().contains("Accept"));
  QTest::mouseClick(yes, Qt::LeftButton);
  EXPECT_EQ(panel.state().light, Light::measured);
  EXPECT_EQ(panel.findChild<QPushButton*>("acceptButton"), nullptr);
  EXPECT_EQ(panel.findChild<QPushButton*>("mainButton")->text(), "Continue");
  workspace.undoStack()->undo();
  EXPECT_EQ(panel.state().light, Light::look);
  QTest::mouseClick(panel.findChild<QPushButton*>("mainButton"), Qt::LeftButton);
  EXPECT_EQ(gone, Step::shape);
  EXPECT_EQ(panel.state().light, Light::measured);
}

TEST(MarkText, EvidenceIsTheResidualInTheSegment) {
  WrenchSeries series;
  series.time = VectorXd::LinSpaced(101, 0.0, 1.0);
  series.simulated.setZero(101, 6);
  series.measured.setZero(101, 6);
  series.measured.middleRows(50, 51).col(0).setConstant(3.0);
  series.measured.middleRows(50, 51).col(1).setConstant(-4.0);
  series.measured.middleRows(50, 51).col(5).setConstant(0.2);
  Segment calm, pushed, outside;
  calm.to = 0.4;
  pushed.from = 0.6, pushed.to = 1.0;
  outside.from = 2.0, outside.to = 3.0;
  EXPECT_EQ(residualText(calm, series), "Residual 0.000 N, 0.0000 N m RMS");
  EXPECT_EQ(residualText(pushed, series), "Residual 5.000 N, 0.2000 N m RMS");
  series.measured(70, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(residualText(pushed, series).contains("5.000 N")) << "missing values are left out";
  EXPECT_TRUE(residualText(outside, series).isEmpty());
  EXPECT_TRUE(residualText(calm, {}).isEmpty());
  Vector6d noise = Vector6d::Zero();
  noise << 0.3, 0, 0.4, 0, 0.005, 0;
  EXPECT_EQ(noiseText(noise), "Sensor noise: 0.500 N, 0.0050 N m");
}

TEST(MarkPanel, BrushesStandAboveTheSuggestionsAndDetailsGiveTheEvidence) {
  QTemporaryDir folder;
  Workspace workspace;
  StudioParts parts;
  parts.workspace = &workspace;
  MarkPanel panel(parts);
  panel.resize(440, 900);
  panel.show();
  workspace.open(pushedFile(folder));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workspace.busy(); }, 60000));
  QTest::qWait(50);
  const auto* brush = panel.findChild<QPushButton*>("brush1");
  const auto* yes = panel.findChild<QPushButton*>("acceptButton");
  ASSERT_TRUE(brush && yes);
  EXPECT_LT(brush->mapTo(&panel, QPoint()).y(), yes->mapTo(&panel, QPoint()).y());
  const auto evidence = [&] {
    QStringList all;
    for (const QLabel* label : panel.findChildren<QLabel*>())
      if (label->property("role") == "evidence" && label->isVisible()) all << label->text();
    return all;
  };
  EXPECT_TRUE(evidence().isEmpty());
  panel.setDetailsShown(true);
  QTest::qWait(50);
  const QStringList all = evidence();
  ASSERT_EQ(all.size(), static_cast<int>(workspace.segments().size()));
  for (const QString& text : all) EXPECT_TRUE(text.contains("Residual ")) << text.toStdString();
  EXPECT_TRUE(all.join('\n').contains("confidence ")) << all.join('\n').toStdString();
}

TEST(MarkPanel, ObeysScriptLines) {
  Workspace workspace;
  StudioParts parts;
  parts.workspace = &workspace;
  MarkPanel panel(parts);
  EXPECT_FALSE(panel.obey({"export", "x"}).has_value());
  EXPECT_FALSE(panel.obey({"mark", "1"}).has_value());
  EXPECT_FALSE(panel.obey({"mark", "1", "2", "blue"}).has_value());
  EXPECT_FALSE(panel.obey({"mark", "2", "1", "free"})->ok());
  EXPECT_NE(panel.obey({"mark", "1", "2", "free"})->error().message.find("open"), std::string::npos);
}

}  // namespace
}  // namespace heft
