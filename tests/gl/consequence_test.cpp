// What a wrong entry at the controller costs, and whether a right one can be proved: in the real window.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QLabel>
#include <QSlider>

#include "tests/gl/window_fixture.h"
#include "ui/charts/chart.h"
#include "ui/reality_panel/what_if_pane.h"

namespace heft {
namespace {

class ConsequenceTest : public RealWindowTest {
 protected:
  ConsequenceTest() : RealWindowTest("consequence") {}

  QString simulated(const char* name, std::uint64_t seed) {
    Payload tool;
    tool.mass = 0.8;
    tool.com = {0.005, -0.01, 0.06};
    tool.inertiaCom = Vector3d(0.0021, 0.0019, 0.0012).asDiagonal();
    SimulateOptions options;
    options.motion = MotionKind::free;
    options.duration = 10.0;
    options.rateHz = 250.0;
    options.seed = seed;
    const QString made = writeSimulated(folder, tool, options);
    const QString path = folder.filePath(QString(name) + ".csv"), meta = folder.filePath(QString(name) + ".meta.json");
    EXPECT_TRUE(QFile::rename(made, path));
    EXPECT_TRUE(QFile::rename(folder.filePath("simulated.meta.json"), meta));
    return path;
  }
  void tell(Step step, const QStringList& words) {
    const auto obeyed = window.panel(step)->obey(words);
    ASSERT_TRUE(obeyed && obeyed->ok()) << (obeyed ? obeyed->error().message : std::string("not its verb"));
    settle();
  }
};

TEST_F(ConsequenceTest, ThePhantomIsDrawnOnTheArmWhileResultIsShown) {
  open(simulated("rec", 4));
  window.showStep(Step::result);
  tell(Step::result, {"controller", "0.4"});
  ASSERT_EQ(window.robotView()->marks().causes().size(), 1u);
  EXPECT_TRUE(window.robotView()->labelTexts().contains("Phantom force"))
      << window.robotView()->labelTexts().join(", ").toStdString();
  EXPECT_TRUE(texts(Step::result).contains("phantom"));
  const Vector3d before = window.robotView()->marks().causes()[0].vector;
  window.playback()->setTime(5.0);
  settle();
  EXPECT_FALSE(window.robotView()->marks().causes()[0].vector.isApprox(before, 1e-3)) << "it follows the instant shown";
  window.showStep(Step::exportFile);
  settle();
  EXPECT_TRUE(window.robotView()->marks().causes().empty());
  window.showStep(Step::result);
  settle();
  EXPECT_EQ(window.robotView()->marks().causes().size(), 1u);
  // What is mounted besides the tool belongs to the entry, and undo takes the entry back.
  workspace.undoStack()->undo();
  settle();
  EXPECT_TRUE(window.robotView()->marks().causes().empty());
}

TEST_F(ConsequenceTest, NumbersAreProvedOnWhatComesIn) {
  const QString other = simulated("other", 5);
  open(simulated("rec", 4));
  tell(Step::record, {"live", "replay", other});
  window.showStep(Step::exportFile);
  settle();
  QAbstractButton* live = nullptr;
  for (auto* button : window.panel(Step::exportFile)->findChildren<QAbstractButton*>("linkButton"))
    if (button->property("role") == "proveLive" && button->isEnabled()) live = button;
  ASSERT_NE(live, nullptr);
  live->click();
  settle();
  EXPECT_TRUE(texts(Step::exportFile).contains("PASS")) << texts(Step::exportFile).toStdString();
  tell(Step::record, {"live", "discard"});
  for (auto* button : window.panel(Step::exportFile)->findChildren<QAbstractButton*>("linkButton"))
    EXPECT_FALSE(button->property("role") == "proveLive" && button->isVisible());
}

TEST_F(ConsequenceTest, AFaultIsTurnedByKeyAndTheCurvesBelowTheArmFollow) {
  open(simulated("rec", 4));
  window.showStep(Step::realityCheck);
  tell(Step::realityCheck, {"whatif", "on"});
  auto* pane = window.panel(Step::realityCheck)->ownPane()->findChild<WhatIfPane*>();
  ASSERT_TRUE(pane && pane->isVisible());
  auto* slider = window.panel(Step::realityCheck)->findChild<QSlider*>("knob_time_offset");
  ASSERT_TRUE(slider && slider->isVisible());
  auto* chart = pane->findChildren<ChartWidget*>()[0];
  const QVector<QPointF> calm = chart->chart().curves[0].points;
  slider->setFocus();
  for (int i = 0; i < 5; ++i) QTest::keyClick(slider, Qt::Key_PageUp);
  EXPECT_EQ(slider->value(), 50);
  EXPECT_NE(chart->chart().curves[0].points, calm);
  EXPECT_TRUE(pane->findChild<QLabel*>("whatIfVerdict")->text().contains("Visible: "));
  // Closing the pane leads back to the cards.
  pane->findChild<QAbstractButton*>("closeWhatIf")->click();
  settle();
  EXPECT_FALSE(pane->isVisible());
  EXPECT_EQ(window.panel(Step::realityCheck)->findChild<QSlider*>("knob_time_offset"), nullptr);
}

}  // namespace
}  // namespace heft
