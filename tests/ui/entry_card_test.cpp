// "What does the controller's current entry cost?" in the step Result.
#include <gtest/gtest.h>

#include <QDialogButtonBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QTextStream>
#include <nlohmann/json.hpp>

#include "core/recording/csv_reader.h"
#include "core/robot/robot_model.h"
#include "core/simulation/simulate.h"
#include "tests/ui/fixtures.h"
#include "ui/controller/entry_costs.h"
#include "ui/controller/only_child.h"
#include "ui/controller/workspace.h"
#include "ui/models/entry_text.h"
#include "ui/results/entry_card.h"
#include "ui/results/entry_dialog.h"
#include "ui/results/result_step.h"
#include "ui/timeline/playback.h"

namespace heft {
namespace {

class EntryCardTest : public testing::Test {
 protected:
  EntryCardTest() {
    parts.workspace = &workspace;
    parts.playback = &playback;
    step = std::make_unique<ResultStep>(parts);
    step->resize(440, 900);
    step->show();
    Payload payload;
    payload.mass = 0.8;
    payload.com = {0.005, -0.01, 0.06};
    payload.inertiaCom = Vector3d(0.0021, 0.0019, 0.0012).asDiagonal();
    SimulateOptions options;
    options.motion = MotionKind::excitation;
    options.duration = 6.0;
    auto simulated = simulate(RobotModel::panda(), payload, options);
    EXPECT_TRUE(simulated.ok());
    const QString path = folder.filePath("rec.csv");
    EXPECT_TRUE(writeRecording(simulated->recording, path.toStdString()).ok());
    workspace.open(path);
    settle();
    EXPECT_TRUE(workspace.report());
  }
  void settle() {
    ASSERT_TRUE(QTest::qWaitFor([&] { return !workspace.busy() && !costs()->jobs().running(); }, 60000));
  }
  EntryCosts* costs() { return onlyChild<EntryCosts>(workspace); }
  QString texts() {
    QString all;
    for (const QLabel* label : step->findChildren<QLabel*>())
      if (!label->isHidden()) all += label->text() + "\n";
    return all;
  }
  void tell(const QStringList& words) {
    const auto obeyed = step->obey(words);
    ASSERT_TRUE(obeyed && obeyed->ok()) << (obeyed ? obeyed->error().message : std::string("not its verb"));
    settle();
  }

  QTemporaryDir folder;
  Workspace workspace;
  Playback playback;
  StudioParts parts;
  std::unique_ptr<ResultStep> step;
};

TEST_F(EntryCardTest, AsksFirstAndSaysWhatAWrongEntryCosts) {
  EXPECT_TRUE(texts().contains("Enter the payload that the controller is set to"));
  tell({"controller", "0.5", "at", "0,0,100"});
  ASSERT_TRUE(costs()->cost());
  EXPECT_NEAR(costs()->cost()->weight, 0.3 * 9.81, 0.1);
  EXPECT_TRUE(texts().contains("phantom")) << texts().toStdString();
  EXPECT_TRUE(texts().contains("With a stiffness of 3000 N/m it sinks by 1.0 mm")) << texts().toStdString();
  EXPECT_TRUE(texts().contains("A push along it stops the arm at"));
  workspace.undoStack()->undo();
  settle();
  EXPECT_FALSE(costs()->cost());
  EXPECT_TRUE(texts().contains("Enter the payload that the controller is set to"));
  workspace.undoStack()->redo();
  settle();
  EXPECT_TRUE(costs()->cost());
}

TEST_F(EntryCardTest, TheRightFileIsRightAndALightThresholdStopsTheArm) {
  const Payload onFlange = transformed(workspace.report()->payload,
                                       poseFromXyzRpy(workspace.report()->mount.xyz, workspace.report()->mount.rpy));
  const QString file = folder.filePath("right.json");
  QFile out(file);
  ASSERT_TRUE(out.open(QIODevice::WriteOnly));
  out.write(QByteArray::fromStdString(toJson(onFlange).dump()));
  out.close();
  tell({"controller", file});
  ASSERT_TRUE(costs()->cost());
  EXPECT_FALSE(costs()->cost()->differs);
  EXPECT_TRUE(texts().contains("The entry agrees with this recording."));
  EXPECT_TRUE(texts().contains("Set as in right.json."));
  ControllerChoice choice = workspace.session().controller;
  choice.told = {0.0, {}, {}};
  choice.collisionForce = 5.0;
  workspace.setController(choice, "threshold");
  settle();
  EXPECT_TRUE(texts().contains("the arm stops although nothing touches it")) << texts().toStdString();
}

TEST_F(EntryCardTest, AnotherFormatOfTheExportCostsNothingNew) {
  tell({"controller", "0.5"});
  const auto cost = costs()->cost();
  ExportChoice choice = workspace.session().exporting;
  choice.format = "ur";
  workspace.setExport(choice, "format");
  settle();
  EXPECT_EQ(costs()->cost(), cost);
  Payload part;
  part.mass = 0.2;
  part.inertiaCom = 1e-4 * Matrix3d::Identity();
  choice.mounted = {{"Sensor", part, true}};
  workspace.setExport(choice, "part");
  settle();
  EXPECT_NEAR(costs()->cost()->weight - cost->weight, 0.2 * 9.81, 1e-6);
}

TEST_F(EntryCardTest, WhatTheRecordingTellsNeedsNotBeTyped) {
  const Recording recording = workspace.opened()->recording;
  const QString path = folder.filePath("log.csv");
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  QTextStream out(&file);
  out << "state.time";
  for (int i = 0; i < 7; ++i) out << ",state.q[" << i << "]";
  for (const char* name : {"force.x", "force.y", "force.z", "torque.x", "torque.y", "torque.z"})
    out << ",wrench." << name;
  out << ",state.m_total,state.F_x_Ctotal[0],state.F_x_Ctotal[1],state.F_x_Ctotal[2]\n";
  out.setRealNumberPrecision(12);
  for (Eigen::Index k = 0; k < recording.rows(); ++k) {
    out << recording.time(k);
    for (int i = 0; i < 7; ++i) out << ',' << recording.q(k, i);
    for (int c = 0; c < 6; ++c) out << ',' << recording.wrench(k, c);
    out << ",0.6,0,0,0.1\n";
  }
  out.flush();
  file.close();
  ASSERT_TRUE(QFile::copy(folder.filePath("rec.meta.json"), folder.filePath("log.meta.json")));
  workspace.open(path);
  settle();
  ASSERT_TRUE(workspace.report());
  ASSERT_TRUE(costs()->cost()) << costs()->failure().toStdString();
  EXPECT_TRUE(costs()->entry()->byRecording);
  EXPECT_NEAR(costs()->cost()->weight, 0.2 * 9.81, 0.1);
  EXPECT_TRUE(texts().contains("Set as in the recording (m_total).")) << texts().toStdString();
  // What somebody typed counts more, and taking it back leads to the recording's again.
  tell({"controller", "0.8"});
  EXPECT_FALSE(costs()->entry()->byRecording);
  tell({"controller", "off"});
  EXPECT_TRUE(costs()->entry()->byRecording);
}

TEST_F(EntryCardTest, WhatTheScriptCannotReadIsSaid) {
  for (const QStringList& words : {QStringList{"controller"},
                                   {"controller", "-1"},
                                   {"controller", "0.5", "at", "0,0"},
                                   {"controller", "a.json"}}) {
    const auto obeyed = step->obey(words);
    // Nothing: the line has none of the forms, which the runner then lists.
    EXPECT_FALSE(obeyed && obeyed->ok()) << words.join(' ').toStdString();
  }
  EXPECT_FALSE(workspace.session().controller.told.mass);
}

TEST_F(EntryCardTest, TheArrowIsThePhantomAtTheInstantShown) {
  tell({"controller", "0.5"});
  const EntryCost& cost = *costs()->cost();
  const Eigen::Index k = cost.time.size() / 2;
  const auto mark = phantomMark(cost, workspace.report()->payload.com, cost.time(k));
  ASSERT_TRUE(mark);
  EXPECT_NEAR(mark->vector.norm(), cost.phantom.col(k).head<3>().norm(), 1e-9);
  EXPECT_TRUE(mark->at.isApprox(workspace.report()->payload.com));
  EXPECT_TRUE(phantomMark(cost, {}, 1e9)) << "after the end the last one stands";
}

TEST(EntryDialog, TakesAZeroWeightAndRefusesHalfAnEntry) {
  EntryDialog dialog({}, {});
  auto* ok = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
  auto* mass = dialog.findChild<QLineEdit*>("knownMass");
  dialog.findChildren<QLineEdit*>("knownCom")[0]->setText("1");
  ok->click();
  EXPECT_EQ(dialog.result(), QDialog::Rejected);
  dialog.findChildren<QLineEdit*>("knownCom")[0]->clear();
  mass->setText("0");
  dialog.findChild<QLineEdit*>("limitForce")->setText("-3");
  ok->click();
  EXPECT_EQ(dialog.result(), QDialog::Rejected);
  dialog.findChild<QLineEdit*>("limitForce")->setText("25");
  ok->click();
  ASSERT_EQ(dialog.result(), QDialog::Accepted);
  EXPECT_EQ(dialog.choice().told.mass, 0.0);
  EXPECT_EQ(dialog.choice().collisionForce, 25.0);
}

TEST(EntryText, TheConsequenceNamesBothDirections) {
  EntryCost cost;
  cost.told.mass = 1.0;
  cost.actual.mass = 0.8;
  cost.differs = true;
  cost.force = 2.0;
  cost.forceShare = 0.2;
  cost.weight = -1.962;
  cost.sag = cost.weight / 1000.0;
  const EntryText text = describeEntry(cost, {10.0, 10.0, 1000.0});
  EXPECT_EQ(text.headline, "The controller sees a phantom force of up to 2.0 N.");
  EXPECT_TRUE(text.consequence.contains("at 8.0 N instead of 10 N, a push against it only at 12 N"))
      << text.consequence.toStdString();
  EXPECT_TRUE(text.consequence.contains("N/m it rises by 2.0 mm"));
  EXPECT_EQ(text.grade, EntryText::Grade::costs);
}

}  // namespace
}  // namespace heft
