// "Something picked up?" in the step Result.
#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>

#include "core/recording/csv_reader.h"
#include "core/robot/robot_model.h"
#include "core/simulation/simulate.h"
#include "tests/support/random_tool.h"
#include "tests/ui/fixtures.h"
#include "ui/controller/carried_objects.h"
#include "ui/controller/only_child.h"
#include "ui/results/result_step.h"
#include "ui/timeline/playback.h"

namespace heft {
namespace {

const Payload kEmptyGripper = test::boxPayload(0.8, {0.08, 0.10, 0.12}, {0.01, -0.005, 0.06});
const Payload kGraspedBox = test::boxPayload(0.35, {0.05, 0.06, 0.09}, {0.005, 0.01, 0.16});

class ObjectCardTest : public testing::Test {
 protected:
  ObjectCardTest() {
    parts.workspace = &workspace;
    parts.playback = &playback;
    parts.say = [this](Severity, const QString& text) { said = text; };
    step = std::make_unique<ResultStep>(parts);
    step->resize(440, 1600);
    step->show();
    Recording grasp = recorded(kEmptyGripper, 77, 24.0);
    const Recording heavy = recorded(composed(kEmptyGripper, kGraspedBox), 77, 24.0);
    for (Eigen::Index i = 0; i < grasp.rows(); ++i)
      if (grasp.time(i) > 7.0 && grasp.time(i) < 16.0) grasp.wrench.row(i) = heavy.wrench.row(i);
    open(written("grasp.csv", grasp));
  }
  static Recording recorded(const Payload& payload, unsigned seed, double seconds) {
    SimulateOptions options;
    options.motion = MotionKind::free;
    options.duration = seconds;
    options.rateHz = 250.0;
    options.seed = seed;
    auto simulated = simulate(RobotModel::panda(), payload, options);
    EXPECT_TRUE(simulated.ok());
    return simulated->recording;
  }
  QString written(const QString& name, const Recording& recording) {
    const QString path = folder.filePath(name);
    EXPECT_TRUE(writeRecording(recording, path.toStdString()).ok());
    return path;
  }
  void open(const QString& path) {
    workspace.open(path);
    settle();
    ASSERT_TRUE(workspace.report());
  }
  void settle() {
    ASSERT_TRUE(QTest::qWaitFor([&] { return !workspace.busy() && !objects()->jobs().running(); }, 60000));
  }
  CarriedObjects* objects() { return onlyChild<CarriedObjects>(workspace); }
  QString texts() {
    QString all;
    for (const QLabel* label : step->findChildren<QLabel*>())
      if (!label->isHidden()) all += label->text() + "\n";
    return all;
  }
  void press(const char* role) {
    for (auto* button : step->findChildren<QPushButton*>())
      if (button->property("role") == QLatin1String(role)) {
        QTest::mouseClick(button, Qt::LeftButton);
        return settle();
      }
    FAIL() << "no button " << role;
  }
  Result<bool> tell(const QStringList& words) {
    const auto obeyed = step->obey(words);
    settle();
    return obeyed ? *obeyed : Result<bool>(Error{"not its verb"});
  }

  QTemporaryDir folder;
  QString said;
  Workspace workspace;
  Playback playback;
  StudioParts parts;
  std::unique_ptr<ResultStep> step;
};

TEST_F(ObjectCardTest, AButtonWeighsWhatIsPickedUpInTheRecording) {
  EXPECT_TRUE(texts().contains("Something picked up?"));
  press("pickedUp");
  ASSERT_TRUE(objects()->object()) << objects()->failure().toStdString();
  const CarriedObject& found = *objects()->object();
  EXPECT_NEAR(found.object.payload.mass, kGraspedBox.mass, 4.0 * found.object.std.mass);
  EXPECT_TRUE(texts().contains("It weighs 0.3")) << texts().toStdString();
  EXPECT_TRUE(texts().contains("Picked up at 7.")) << texts().toStdString();
  EXPECT_TRUE(texts().contains("Put down at 16.")) << texts().toStdString();
  EXPECT_TRUE(texts().contains("Centre z"));
}

TEST_F(ObjectCardTest, TheAnswerFollowsMarksAndEndsWithTheRecording) {
  press("pickedUp");
  const auto before = objects()->object();
  EstimateSettings settings = workspace.session().settings;
  settings.trim = 0.02;
  workspace.setSettings(settings, "trim");
  settle();
  ASSERT_TRUE(objects()->object());
  EXPECT_NE(objects()->object(), before);
  open(written("other.csv", recorded(kEmptyGripper, 78, 8.0)));
  EXPECT_FALSE(objects()->asked());
  EXPECT_TRUE(texts().contains("Something picked up?"));
  // Nothing is picked up in that one: the reason is said.
  press("pickedUp");
  EXPECT_TRUE(texts().contains("nothing was picked up")) << texts().toStdString();
}

TEST_F(ObjectCardTest, ARecordingWithoutItIsTakenOff) {
  const QString empty = written("empty.csv", recorded(kEmptyGripper, 79, 8.0));
  open(written("with.csv", recorded(composed(kEmptyGripper, kGraspedBox), 80, 8.0)));
  ASSERT_TRUE(tell({"object", "minus", empty}));
  EXPECT_TRUE(texts().contains("It weighs 0.3")) << texts().toStdString();
  EXPECT_TRUE(texts().contains("This recording minus empty.csv"));
  ASSERT_TRUE(tell({"object", "off"}));
  EXPECT_TRUE(texts().contains("Something picked up?"));
  EXPECT_FALSE(tell({"object", "minus", folder.filePath("with.csv")})) << "it is the recording itself";
  EXPECT_FALSE(tell({"object"}));
  ASSERT_TRUE(tell({"object", "minus", folder.filePath("none.csv")}));
  EXPECT_TRUE(texts().contains("none.csv")) << texts().toStdString();
  // The other way round there is no such object.
  open(empty);
  ASSERT_TRUE(tell({"object", "minus", folder.filePath("with.csv")}));
  EXPECT_FALSE(texts().contains("It weighs"));
  EXPECT_TRUE(texts().contains("Swap the two recordings")) << texts().toStdString();
}

}  // namespace
}  // namespace heft
