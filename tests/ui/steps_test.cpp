#include <gtest/gtest.h>

#include <QPushButton>
#include <QTest>

#include "ui/controller/workspace.h"
#include "ui/record_panel/record_panel.h"
#include "ui/steps/step_bar.h"
#include "ui/timeline/playback.h"

namespace heft {
namespace {

using P = StepState::Progress;

TEST(Steps, IdsLeadBackToTheStep) {
  for (const Step step : kAllSteps) {
    EXPECT_EQ(stepFromId(stepId(step)), step);
    EXPECT_FALSE(stepName(step).isEmpty());
  }
  EXPECT_FALSE(stepFromId("payload"));
}

TEST(StepBar, TellsDoneNowAndNext) {
  StepBar bar;
  for (const Step step : {Step::record, Step::mark, Step::result}) bar.addStep(step);
  bar.setState(Step::record, {P::done, Light::measured, "24.0 s recorded"});
  bar.setState(Step::mark, {P::ready, Light::look, "2 suggestions to check"});
  bar.setState(Step::result, {P::later, Light::measured, "waits for marks"});
  bar.setNow(Step::record);
  EXPECT_EQ(bar.button(Step::record)->place(), StepButton::Place::now);
  EXPECT_EQ(bar.button(Step::mark)->place(), StepButton::Place::next);
  EXPECT_EQ(bar.button(Step::result)->place(), StepButton::Place::other);
  EXPECT_TRUE(bar.button(Step::mark)->accessibleDescription().contains("look here"));
  bar.setNow(Step::mark);
  EXPECT_EQ(bar.button(Step::result)->place(), StepButton::Place::other);
}

TEST(StepBar, AClickAsksForTheStepAndLaterOnesAreClickableToo) {
  StepBar bar;
  bar.resize(900, 62);
  for (const Step step : {Step::record, Step::mark, Step::result}) bar.addStep(step);
  bar.show();
  std::vector<Step> wanted;
  QObject::connect(&bar, &StepBar::stepWanted, &bar, [&](Step step) { wanted.push_back(step); });
  QTest::mouseClick(bar.button(Step::result), Qt::LeftButton);
  EXPECT_EQ(wanted, std::vector{Step::result});
}

TEST(RecordPanel, BeginsWithOneThingToDoAndTheRecentFiles) {
  Workspace workspace;
  StudioParts parts;
  parts.workspace = &workspace;
  int chosen = 0;
  parts.chooseFiles = [&] { ++chosen; };
  parts.recentFiles = [] { return QStringList{"/a/b.csv", "/a/c.csv"}; };
  RecordPanel panel(parts);
  panel.resize(440, 800);
  panel.show();
  const auto mains = panel.findChildren<QPushButton*>("mainButton");
  ASSERT_EQ(mains.size(), 1);
  QTest::mouseClick(mains[0], Qt::LeftButton);
  EXPECT_EQ(chosen, 1);
  const auto links = panel.findChildren<QPushButton*>("linkButton");
  ASSERT_EQ(links.size(), 2);
  EXPECT_TRUE(links[1]->text().startsWith("c.csv")) << "then its folder and day";
  EXPECT_EQ(panel.state().progress, P::ready);
}

}  // namespace
}  // namespace heft
