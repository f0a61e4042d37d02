// "What if …?" in the reality check: sliders, and what follows them.
#include <gtest/gtest.h>

#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include "core/recording/csv_reader.h"
#include "core/robot/robot_model.h"
#include "core/simulation/simulate.h"
#include "ui/controller/workspace.h"
#include "ui/reality_panel/lesson_guide.h"
#include "ui/reality_panel/reality_panel.h"
#include "ui/reality_panel/what_if_knobs.h"
#include "ui/reality_panel/what_if_pane.h"
#include "ui/widgets/basics.h"

namespace heft {
namespace {

class WhatIfTest : public testing::Test {
 protected:
  WhatIfTest() {
    QStandardPaths::setTestModeEnabled(true);
    parts.workspace = &workspace;
    parts.followJobs = [this](JobRunner* runner) { jobs.push_back(runner); };
    panel = std::make_unique<RealityPanel>(parts);
    panel->resize(440, 900);
    panel->show();
    panel->ownPane()->resize(960, 380);
    panel->ownPane()->show();
    workspace.open(written(MotionKind::excitation));
    settle();
  }
  QString written(MotionKind motion) {
    Payload payload;
    payload.mass = 0.8;
    payload.com = {0.005, -0.01, 0.06};
    payload.inertiaCom = Vector3d(0.0021, 0.0019, 0.0012).asDiagonal();
    SimulateOptions options;
    options.motion = motion;
    options.duration = 8.0;
    options.rateHz = 250.0;
    const auto made = simulate(RobotModel::panda(), payload, options);
    EXPECT_TRUE(made.ok());
    const QString path = folder.filePath("rec.csv");
    EXPECT_TRUE(writeRecording(made->recording, path.toStdString()).ok());
    return path;
  }
  void settle() {
    ASSERT_TRUE(QTest::qWaitFor(
        [&] {
          return !workspace.busy() && std::none_of(jobs.begin(), jobs.end(), [](JobRunner* j) { return j->running(); });
        },
        120000));
    QTest::qWait(50);
  }
  void tell(const QStringList& words) {
    const auto obeyed = panel->obey(words);
    ASSERT_TRUE(obeyed && obeyed->ok()) << (obeyed ? obeyed->error().message : std::string("not its verb"));
    settle();
  }
  QSlider* slider(const char* cause) { return panel->findChild<QSlider*>(QString("knob_") + cause); }
  QString verdict() { return panel->ownPane()->findChild<QLabel*>("whatIfVerdict")->text(); }
  QString alike() { return panel->ownPane()->findChild<QLabel*>("whatIfAlike")->text(); }
  QString mass() { return panel->ownPane()->findChildren<QLabel*>("whatIfNumber")[0]->text(); }

  QTemporaryDir folder;
  std::vector<JobRunner*> jobs;
  Workspace workspace;
  StudioParts parts;
  std::unique_ptr<RealityPanel> panel;
};

TEST_F(WhatIfTest, TheNumbersAndTheVerdictFollowTheHandAndComeBack) {
  ASSERT_TRUE(workspace.report());
  EXPECT_FALSE(panel->ownPane()->findChild<WhatIfPane*>()->isVisible());
  tell({"whatif", "on"});
  EXPECT_TRUE(panel->ownPane()->findChild<WhatIfPane*>()->isVisible());
  EXPECT_EQ(panel->below(), StepPanel::Below::own);
  ASSERT_NE(slider("time_offset"), nullptr);
  ASSERT_NE(slider("cable_pull"), nullptr);
  const QString before = mass();
  EXPECT_TRUE(verdict().contains("No fault is on"));
  // A hand on the slider: no job runs, the answer is there at once.
  slider("time_offset")->setValue(60);
  EXPECT_TRUE(std::none_of(jobs.begin(), jobs.end(), [](JobRunner* j) { return j->running(); }));
  EXPECT_TRUE(verdict().contains("Visible: ")) << verdict().toStdString();
  EXPECT_TRUE(alike().contains("low-pass filter") || alike().contains("Nothing else")) << alike().toStdString();
  EXPECT_NE(mass(), before);
  slider("time_offset")->setValue(0);
  EXPECT_EQ(mass(), before);
  EXPECT_TRUE(verdict().contains("No fault is on"));
  EXPECT_TRUE(workspace.undoStack()->count() == 0) << "nothing of the session changes";
}

TEST_F(WhatIfTest, AllOffAndBackLeaveEverythingAsItWas) {
  tell({"whatif", "time_offset", "12", "cable_pull", "2"});
  EXPECT_EQ(slider("time_offset")->value(), 48);
  EXPECT_GT(slider("cable_pull")->value(), 0);
  for (const char* name : {"secondButton", "mainButton"}) {
    auto* button = panel->findChild<QPushButton*>(name);
    ASSERT_NE(button, nullptr) << name;
    QTest::mouseClick(button, Qt::LeftButton);
    settle();
    if (slider("time_offset")) {
      EXPECT_EQ(slider("time_offset")->value(), 0);
    }
  }
  EXPECT_EQ(slider("time_offset"), nullptr);
  EXPECT_FALSE(panel->ownPane()->findChild<WhatIfPane*>()->isVisible());
}

TEST_F(WhatIfTest, TheScriptSaysWhatItCannotTurn) {
  tell({"whatif", "on"});
  for (const QStringList& words : {QStringList{"whatif"},
                                   {"whatif", "time_offset"},
                                   {"whatif", "no_such", "1"},
                                   {"whatif", "time_offset", "-1"},
                                   {"whatif", "time_offset", "1000"}}) {
    const auto obeyed = panel->obey(words);
    // Nothing: the line has none of the forms, which the runner then lists.
    EXPECT_FALSE(obeyed && obeyed->ok()) << words.join(' ').toStdString();
  }
}

TEST_F(WhatIfTest, AnotherRecordingGetsItsOwnKnobs) {
  tell({"whatif", "time_offset", "12"});
  const QString before = verdict();
  workspace.startAfresh();
  settle();
  workspace.open(written(MotionKind::free));
  settle();
  ASSERT_NE(slider("time_offset"), nullptr);
  EXPECT_EQ(slider("time_offset")->value(), 0);
  EXPECT_TRUE(verdict().contains("No fault is on")) << verdict().toStdString();
}

TEST_F(WhatIfTest, ALessonLeadsFromItsRecordingToItsQuestion) {
  EXPECT_EQ(builtInLessons().size(), 6u);
  const auto words = [&] {
    QString all;
    for (const QLabel* label : panel->findChildren<QLabel*>()) all += label->text() + "\n";
    return all;
  };
  tell({"lesson", "5"});
  EXPECT_TRUE(words().contains("Delayed or filtered?")) << words().toStdString();
  EXPECT_TRUE(workspace.opened()->path.contains("lesson-"));
  EXPECT_NEAR(mass().split(' ').first().toDouble(), 0.75, 0.01) << "of the lesson, not of what was open before";
  EXPECT_EQ(slider("time_offset"), nullptr) << "the first step only looks";
  tell({"lesson", "next"});
  ASSERT_NE(slider("time_offset"), nullptr);
  ASSERT_NE(slider("low_pass_lag"), nullptr);
  EXPECT_EQ(slider("cable_pull"), nullptr);
  slider("time_offset")->setValue(60);
  EXPECT_TRUE(alike().contains("low-pass filter")) << alike().toStdString();
  tell({"lesson", "next"});
  ASSERT_NE(panel->findChild<QPushButton*>("lessonAnswer2"), nullptr);
  EXPECT_EQ(slider("time_offset")->value(), 60) << "the question is asked of what stands there";
  panel->findChild<QPushButton*>("lessonAnswer2")->click();
  settle();
  EXPECT_TRUE(words().contains("Look once more."));
  tell({"lesson", "answer", "1"});
  EXPECT_TRUE(words().contains("Right."));
  tell({"lesson", "off"});
  EXPECT_FALSE(words().contains("Delayed or filtered?"));
  const auto wrong = panel->obey({"lesson", "7"});
  EXPECT_TRUE(wrong && !wrong->ok());
}

TEST_F(WhatIfTest, ATeachersLessonIsReadAndAWrongOneIsExplained) {
  const QString path = folder.filePath("mine.json");
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(R"({"schema":"heft.lesson/1","title":"Mine"})");
  file.close();
  const auto refused = panel->obey({"lesson", path});
  ASSERT_TRUE(refused && !refused->ok());
  EXPECT_NE(refused->error().message.find("mine.json: \"recording\""), std::string::npos) << refused->error().message;
  EXPECT_TRUE(panel->obey({"lesson", folder.filePath("none.json")}) && !panel->obey({"lesson", "none.json"})->ok());
}

}  // namespace
}  // namespace heft
