#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QClipboard>
#include <QFile>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <functional>
#include <nlohmann/json.hpp>

#include "core/recording/csv_reader.h"
#include "core/robot/robot_model.h"
#include "core/simulation/simulate.h"
#include "tests/support/as_driver.h"
#include "tests/ui/fixtures.h"
#include "ui/controller/workspace.h"
#include "ui/export_panel/export_panel.h"
#include "ui/export_panel/export_text.h"

namespace heft {
namespace {

class ExportPanelTest : public testing::Test {
 protected:
  ExportPanelTest() {
    parts.workspace = &workspace;
    panel = std::make_unique<ExportPanel>(parts);
    panel->resize(440, 900);
    panel->show();
  }
  /// `change` makes something of the recording before it is written.
  void openSimulated(const std::function<void(Recording&)>& change = {}) {
    Payload payload;
    payload.mass = 0.8;
    payload.com = {0.005, -0.01, 0.06};
    payload.inertiaCom = Vector3d(0.0021, 0.0019, 0.0012).asDiagonal();
    SimulateOptions options;
    options.motion = MotionKind::excitation;
    options.duration = 6.0;
    auto simulated = simulate(RobotModel::panda(), payload, options);
    ASSERT_TRUE(simulated.ok());
    if (change) change(simulated->recording);
    const QString path = folder.filePath("rec.csv");
    ASSERT_TRUE(writeRecording(simulated->recording, path.toStdString()).ok());
    workspace.open(path);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !workspace.busy(); }, 60000));
    ASSERT_TRUE(workspace.report());
  }
  QPushButton* button(const char* name) { return panel->findChild<QPushButton*>(name); }
  QString preview() { return panel->ownPane()->findChild<QPlainTextEdit*>("filePreview")->toPlainText(); }

  QTemporaryDir folder;
  Workspace workspace;
  StudioParts parts;
  std::unique_ptr<ExportPanel> panel;
};

TEST_F(ExportPanelTest, TheFileIsSeenBeforeItIsWrittenAndTheQuestionIsAsked) {
  EXPECT_EQ(panel->state().progress, StepState::Progress::later);
  openSimulated();
  EXPECT_EQ(panel->state().progress, StepState::Progress::ready);
  EXPECT_TRUE(preview().contains("\"mass\""));
  EXPECT_FALSE(button("mainButton")->isEnabled()) << "own tool or extra load must be said first";
  QTest::mouseClick(button("roleOwnTool"), Qt::LeftButton);
  EXPECT_TRUE(button("mainButton")->isEnabled());
  workspace.undoStack()->undo();
  EXPECT_FALSE(button("mainButton")->isEnabled());
}

// Numbers that nothing supports are written only after a second, worded yes, and for this result only.
TEST_F(ExportPanelTest, WhatCannotBeTrustedNeedsASecondYes) {
  openSimulated([](Recording& recording) { test::rewriteAs("base_axes", RobotModel::panda(), 3, recording); });
  ASSERT_EQ(workspace.report()->trust, Trust::none);
  QTest::mouseClick(button("roleOwnTool"), Qt::LeftButton);
  EXPECT_FALSE(button("mainButton")->isEnabled());
  const QString file = folder.filePath("tool.json");
  EXPECT_FALSE(panel->saveTo(file, false).ok());
  EXPECT_FALSE(QFile::exists(file));
  const auto answer = [&](const char* text) {
    ASSERT_NE(button("writeUntrusted"), nullptr);
    QTest::mouseClick(button("writeUntrusted"), Qt::LeftButton);
    auto* box = panel->findChild<QMessageBox*>("confirmUntrusted");
    ASSERT_NE(box, nullptr);
    EXPECT_TRUE(box->informativeText().contains("base axes")) << box->informativeText().toStdString();
    for (QAbstractButton* choice : box->buttons())
      if (choice->text().contains(text)) QTest::mouseClick(choice, Qt::LeftButton);
    QTest::qWait(50);
  };
  answer("Do not write");
  EXPECT_FALSE(button("mainButton")->isEnabled());
  answer("Write it");
  EXPECT_TRUE(button("mainButton")->isEnabled());
  EXPECT_TRUE(panel->saveTo(file, false).ok());
  // Another estimate is another result.
  workspace.estimate();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workspace.busy(); }, 60000));
  EXPECT_FALSE(button("mainButton")->isEnabled());
}

TEST_F(ExportPanelTest, ALongPageScrollsInsteadOfBeingSqueezed) {
  panel->resize(440, 400);
  openSimulated();
  QTest::qWait(50);
  for (const QWidget* widget : panel->findChildren<QWidget*>()) {
    if (!widget->isVisible() || widget->objectName() == "divider") continue;
    EXPECT_GE(widget->height(), std::min(widget->minimumSizeHint().height(), 30)) << widget->objectName().toStdString();
  }
  const auto* card = panel->findChild<QAbstractButton*>("format_ur");
  ASSERT_NE(card, nullptr);
  EXPECT_EQ(card->height(), card->sizeHint().height());
}

TEST_F(ExportPanelTest, WhatIsMountedIsAddedExactly) {
  openSimulated();
  const double alone = nlohmann::json::parse(preview().toStdString())["mass"].get<double>();
  ExportChoice choice = workspace.session().exporting;
  choice.mounted = {{"Sensor body", compactPart(0.26, {0, 0, 0.02}), true}};
  workspace.setExport(choice, "add");
  const double together = nlohmann::json::parse(preview().toStdString())["mass"].get<double>();
  EXPECT_NEAR(together - alone, 0.26, 2e-5);
}

TEST_F(ExportPanelTest, EveryFormatHasAPreviewAndAName) {
  openSimulated();
  for (const ExportFormat& format : exportFormats()) {
    EXPECT_FALSE(formatName(format).detail.isEmpty()) << format.id;
    ExportChoice choice = workspace.session().exporting;
    choice.format = format.id;
    workspace.setExport(choice, "format");
    EXPECT_FALSE(preview().isEmpty()) << format.id;
  }
}

TEST_F(ExportPanelTest, NothingIsReplacedSilently) {
  openSimulated();
  const QString path = folder.filePath("tool.json");
  EXPECT_TRUE(panel->obey({"export", "franka-desk", path})->ok());
  EXPECT_EQ(panel->state().progress, StepState::Progress::done);
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::ReadWrite | QIODevice::Truncate));
  file.write("mine");
  file.close();
  const auto refused = panel->obey({"export", "franka-desk", path});
  ASSERT_FALSE(refused->ok());
  EXPECT_NE(refused->error().message.find("already exists"), std::string::npos);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  EXPECT_EQ(file.readAll(), "mine");
  EXPECT_TRUE(panel->obey({"export", "franka-desk", path, "replace"})->ok());
  EXPECT_FALSE(panel->obey({"export", "no-such", path})->ok());
}

TEST(ExportText, RolesThatDoNotFitTheFileAreSaid) {
  using Role = ExportChoice::Role;
  EXPECT_TRUE(roleAdvice("franka-desk", Role::ownTool).isEmpty());
  EXPECT_FALSE(roleAdvice("franka-desk", Role::extraLoad).isEmpty());
  EXPECT_FALSE(roleAdvice("libfranka", Role::ownTool).isEmpty());
  EXPECT_TRUE(roleAdvice("libfranka", Role::extraLoad).isEmpty());
}

TEST(ExportText, NumbersThatTheMotionDidNotTellAreTintedAndWarnedOf) {
  EstimateReport report = test::reportOn(test::sineRecording(1000, 100));
  const QStringList lines = QString("{\n\"mass\": 1,\n\"inertia\": [1, 0, 0,\n  0, 1, 0,\n  0, 0, 1]\n}").split('\n');
  EXPECT_TRUE(doubtfulLines(lines, report).empty());
  report.identifiability.inertia[0][0] = Source::prior;
  EXPECT_EQ(doubtfulLines(lines, report), (std::vector<int>{2, 3, 4}));
  ExportChoice choice;
  choice.role = ExportChoice::Role::ownTool;
  const ExportFormat* format = findExportFormat("franka-desk");
  const auto checks = checksBeforeSaving(report, report.payload, {}, choice, *format);
  ASSERT_FALSE(checks.empty());
  EXPECT_TRUE(checks.front().text.contains("your shape"));
}

TEST(ExportText, ACompactPartIsABodyThatCanExist) {
  EXPECT_TRUE(checkPhysical(compactPart(0.26, {0, 0, 0.02})).physical);
  EXPECT_NEAR(compactPart(0.26, {0, 0, 0.02}).inertiaCom(0, 0), 0.4 * 0.26 * std::pow(0.0284, 2), 2e-6);
}

}  // namespace
}  // namespace heft
