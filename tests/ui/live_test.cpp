#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLineEdit>
#include <QProcess>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "core/recording/csv_reader.h"
#include "ui/controller/autosave.h"
#include "ui/controller/unfinished.h"
#include "ui/controller/workspace.h"
#include "ui/live/live_run.h"
#include "ui/live/live_words.h"
#include "ui/record_panel/record_panel.h"
#include "ui/record_panel/source_form.h"
#include "ui/timeline/time_axis.h"
#include "ui/widgets/stepper.h"
#include "ui/wrench_plots/live_history.h"

namespace heft {
namespace {

constexpr int kLivePatience = 120000;  ///< [ms] A bound against hanging only.

TEST(LiveHistory, AnHourIsBoundedAndItsPeaksStay) {
  LiveHistory history;
  std::size_t afterTenMinutes = 0;
  for (int k = 0; k < 3'600'000; ++k) {
    const double t = k * 1e-3;
    Vector6d wrench = Vector6d::Constant(std::sin(t));
    if (k == 1'234'567) wrench(2) = 77.0;
    history.addMeasured(t, wrench);
    if (k % 20 == 0) history.addSimulated(t, wrench, Vector6d::Zero());
    if (k == 600'000) afterTenMinutes = history.stretches();
  }
  EXPECT_LT(history.stretches(), 20'000u);
  EXPECT_LT(history.stretches(), afterTenMinutes + 5000);
  const auto traces = history.traces();
  EXPECT_NEAR(traces->firstTime(), 0.0, 1e-9);
  EXPECT_NEAR(traces->lastTime(), 3599.999, 0.02);
  EXPECT_EQ(traces->visibleRange(0, 1200, 1300).highest, 77.0);
  EXPECT_NEAR(traces->visibleRange(0, 1240, 1300).highest, 1.0, 1e-3);
  // The newest minute is as fine as a screen can show.
  EXPECT_GT(traces->timesWithin(3590, 3600).size(), 1500u);
}

TEST(TimeAxis, GrowingGoesAlongOnlyWhereTheEndIsInView) {
  TimeAxis axis;
  axis.setFull(0, 30);
  axis.grow(31);
  EXPECT_DOUBLE_EQ(axis.lower(), 1);
  EXPECT_DOUBLE_EQ(axis.upper(), 31);
  axis.show(5, 10);
  axis.grow(40);
  EXPECT_DOUBLE_EQ(axis.lower(), 5);
  EXPECT_DOUBLE_EQ(axis.upper(), 10);
  EXPECT_DOUBLE_EQ(axis.fullUpper(), 40);
}

LiveSample liveSample(const VirtualSample& sample) {
  LiveSample out;
  out.time = 1000.0 + sample.time;
  out.q.emplace();
  for (std::size_t j = 0; j < 7; ++j) (*out.q)[j] = sample.q(static_cast<Eigen::Index>(j));
  out.wrench = sample.wrench;
  return out;
}

LearnerSetup virtualSetup(bool poses = false) {
  LearnerSetup setup;
  setup.meta = VirtualRig::metaFor({});
  setup.robot = std::shared_ptr<const RobotModel>(std::shared_ptr<void>(), &RobotModel::panda());
  setup.poses = poses;
  return setup;
}

VirtualRig rigWith(std::uint64_t tool) {
  VirtualRigOptions options;
  options.seed = tool;
  options.payload = practiceTool(tool);
  return VirtualRig::create(RobotModel::panda(), options).value();
}

TEST(LiveLearner, FindsTheHiddenToolAndShowsWhatItExpects) {
  for (const std::uint64_t tool : {5u, 6u}) {
    auto learner = *LiveLearner::create(virtualSetup());
    VirtualRig rig = rigWith(tool);
    rig.arm().wander();
    for (int k = 0; k < 20'000; ++k) learner->add(liveSample(rig.next()));
    const LiveView view = learner->view();
    ASSERT_TRUE(view.state.estimated);
    EXPECT_NEAR(view.rateHz, 1000.0, 1.0);
    EXPECT_NEAR(view.time, 19.999, 1e-6);
    const Payload& truth = rig.options().payload;
    const auto& interval = view.state.interval95;
    // Seven intervals of 95 % on two tools: allow them half their width more.
    const auto inside = [](double x, const auto& i, double width) {
      return x > i.lower - 0.5 * width && x < i.upper + 0.5 * width;
    };
    EXPECT_TRUE(inside(truth.mass, interval.mass, interval.mass.upper - interval.mass.lower))
        << truth.mass << " " << interval.mass.lower << " " << interval.mass.upper;
    for (int a = 0; a < 3; ++a) {
      const auto& c = interval.com[a];
      EXPECT_TRUE(inside(truth.com(a), c, c.upper - c.lower)) << truth.com(a) << " " << c.lower << " " << c.upper;
      const auto& i = interval.inertiaCom[a][a];
      EXPECT_TRUE(inside(truth.inertiaCom(a, a), i, i.upper - i.lower))
          << truth.inertiaCom(a, a) << " " << i.lower << " " << i.upper;
    }
    EXPECT_LT(interval.mass.upper - interval.mass.lower, 0.05 * truth.mass) << "20 s tell the mass well";
    ASSERT_GT(view.known.size(), 10u);
    EXPECT_LT(view.known.back().mass, view.known.front().mass) << "tightens";
    EXPECT_TRUE(view.touched.empty()) << "nothing touched it";
    ASSERT_TRUE(view.traces->hasSimulated());
    const double measured = view.traces->valueAt(WrenchTraces::Kind::measured, 2, 15.0);
    const double simulated = view.traces->valueAt(WrenchTraces::Kind::simulated, 2, 15.0);
    EXPECT_NEAR(measured, simulated, 0.5);
    EXPECT_LE(view.path.size(), 1500u);
  }
}

TEST(LiveLearner, NoticesAPushAndAnotherTool) {
  auto learner = *LiveLearner::create(virtualSetup());
  VirtualRig rig = rigWith(5);
  rig.arm().wander();
  for (int k = 0; k < 12'000; ++k) learner->add(liveSample(rig.next()));
  for (int k = 0; k < 700; ++k) {
    LiveSample pushed = liveSample(rig.next());
    (*pushed.wrench)(0) += 8.0;
    learner->add(pushed);
  }
  for (int k = 0; k < 4'000; ++k) learner->add(liveSample(rig.next()));
  const LiveView view = learner->view();
  ASSERT_FALSE(view.touched.empty());
  EXPECT_NEAR(view.touched.front().from, 12.0, 0.5);
  // Over at 12.7 s; that nothing touches any more is believed after two quiet seconds.
  EXPECT_LT(view.touched.back().to, 15.0);
  EXPECT_EQ(view.state.tools, 1);
  Payload other = practiceTool(5);
  other.mass += 0.8;
  ASSERT_TRUE(rig.changeTool(other).ok());
  for (int k = 0; k < 12'000; ++k) learner->add(liveSample(rig.next()));
  EXPECT_EQ(learner->view().state.tools, 2);
  EXPECT_NEAR(learner->view().state.payload.mass, other.mass, 0.05);
}

TEST(LiveLearner, StandingPosesAreTakenByThemselvesAndTellTheMass) {
  auto learner = *LiveLearner::create(virtualSetup(true));
  VirtualRig rig = rigWith(9);
  std::size_t poses = 0;
  for (int pose = 0; pose < 8; ++pose) {
    for (int k = 0; k < 15'000 && learner->view().poses.size() == poses; k += 500)
      for (int i = 0; i < 500; ++i) learner->add(liveSample(rig.next()));
    const LiveView view = learner->view();
    ASSERT_EQ(view.poses.size(), poses + 1) << "pose " << pose;
    poses = view.poses.size();
    if (!view.next) break;
    rig.arm().goTo(view.next->q);
  }
  const LiveView view = learner->view();
  ASSERT_TRUE(view.poseResult.known);
  EXPECT_NEAR(view.poseResult.mass, practiceTool(9).mass, 4 * view.poseResult.massStd + 0.01);
  const Recording kept = recordingOf(view.poses, virtualSetup().meta);
  EXPECT_EQ(kept.meta.kind, RecordingKind::poses);
  EXPECT_GE(kept.rows(), 6);
  EXPECT_EQ(kept.q.cols(), 7);
  learner->removePose(0);
  EXPECT_EQ(learner->view().poses.size(), poses - 1);
}

class LiveRunTest : public testing::Test {
 protected:
  LiveSetup setup(std::uint64_t tool = 2) {
    VirtualRigOptions options;
    options.seed = tool;
    options.payload = practiceTool(tool);
    LiveSetup out;
    auto source = VirtualSource::create(RobotModel::panda(), options, VirtualSource::Pace::stepped);
    out.virtualArm = source->get();
    out.sources.push_back(std::move(*source));
    out.meta = VirtualRig::metaFor(options);
    out.folder = folder.filePath("recordings");
    out.name = "run";
    return out;
  }
  void settle() {
    ASSERT_TRUE(QTest::qWaitFor(
        [&] {
          for (JobRunner* runner : run.runners())
            if (runner->running()) return false;
          return true;
        },
        kLivePatience));
  }
  QTemporaryDir folder;
  LiveRun run;
};

TEST_F(LiveRunTest, RecordsLearnsCoachesAndMakesTheAdvisedMotion) {
  ASSERT_TRUE(run.start(setup(), false).ok());
  run.pass(3.0);
  settle();
  EXPECT_NEAR(run.view().time, 2.999, 1e-6);
  ASSERT_TRUE(run.advice());
  EXPECT_FALSE(coachSentence(*run.advice()).isEmpty());
  const VectorXd before = *run.view().q;
  ASSERT_TRUE(run.makeAdvised());
  run.pass(3.0);
  settle();
  EXPECT_GT((*run.view().q - before).cwiseAbs().maxCoeff(), 0.02);
  const auto status = run.status();
  EXPECT_EQ(status.recorded, 6000u);
  EXPECT_EQ(countersText(status), "no samples lost");
  const QString file = run.stop();
  EXPECT_TRUE(file.endsWith("run.csv"));
  const auto read = readRecording(file.toStdString());
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->recording.rows(), 6000);
  EXPECT_FALSE(run.running());
  // A name that is taken is never written over.
  ASSERT_TRUE(run.start(setup(), false).ok());
  run.pass(0.5);
  settle();
  EXPECT_TRUE(run.stop().endsWith("run-2.csv"));
}

TEST_F(LiveRunTest, FollowingTheCoachTellsTheToolSoon) {
  ASSERT_TRUE(run.start(setup(8), false).ok());
  for (int round = 0; round < 5; ++round) {
    run.pass(7.0);
    settle();
    run.makeAdvised();
  }
  ASSERT_TRUE(run.view().state.estimated);
  const auto texts = knownTexts(run.view().state);
  EXPECT_EQ(texts[0].light, Light::measured) << texts[0].words.toStdString();
  EXPECT_NE(texts[1].light, Light::unknown) << texts[1].words.toStdString();
  EXPECT_NEAR(run.view().state.payload.mass, practiceTool(8).mass, 0.02);
  run.discard();
  EXPECT_TRUE(QDir(folder.filePath("recordings")).isEmpty());
}

TEST_F(LiveRunTest, AReplayComesWholeAndEndsByItself) {
  ASSERT_TRUE(run.start(setup(), false).ok());
  run.pass(2.0);
  settle();
  const QString first = run.stop();
  LiveSetup replay;
  replay.sources.push_back(makeLiveSource("replay:" + first.toStdString() + "?speed=10").value());
  replay.folder = folder.filePath("recordings");
  replay.name = "again";
  ASSERT_TRUE(run.start(std::move(replay), true).ok());
  ASSERT_TRUE(QTest::qWaitFor([&] { return run.finished() && run.view().time > 1.99; }, kLivePatience));
  const QString second = run.stop();
  const auto a = readRecording(first.toStdString()), b = readRecording(second.toStdString());
  ASSERT_TRUE(a.ok() && b.ok());
  EXPECT_EQ(b->recording.q, a->recording.q);
  EXPECT_EQ(b->recording.meta.robot, "panda") << "what the joints told is written down";
}

TEST_F(LiveRunTest, WhatCannotBeginLeavesNothingBehind) {
  LiveSetup broken;
  broken.sources.push_back(makeLiveSource("replay:/no/such/file.csv").value());
  broken.folder = folder.filePath("recordings");
  broken.name = "x";
  EXPECT_FALSE(run.start(std::move(broken), true).ok());
  EXPECT_FALSE(run.running());
  EXPECT_TRUE(QDir(folder.filePath("recordings")).isEmpty());
}

/// What the test below starts and kills; by itself it does nothing.
TEST(RecordingVictim, DISABLED_RecordsUntilItIsKilled) {
  const QString folder = qEnvironmentVariable("HEFT_TEST_STATE");
  ASSERT_FALSE(folder.isEmpty());
  VirtualRigOptions options;
  options.payload = practiceTool(2);
  LiveSetup setup;
  auto source = VirtualSource::create(RobotModel::panda(), options, VirtualSource::Pace::stepped);
  setup.virtualArm = source->get();
  setup.sources.push_back(std::move(*source));
  setup.meta = VirtualRig::metaFor(options);
  setup.folder = folder;
  setup.name = "run";
  LiveRun run;
  ASSERT_TRUE(run.start(std::move(setup), true).ok());
  ASSERT_TRUE(QTest::qWaitFor([&] { return run.status().recorded > 2500; }, kLivePatience));
  std::printf("recorded %d\n", static_cast<int>(run.status().recorded));
  std::fflush(stdout);
  QTest::qWait(60000);
}

TEST(UnfinishedRecording, AKillLosesASecondAtMostAndTheNextStartFindsIt) {
  QTemporaryDir folder;
  QProcess victim;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert("HEFT_TEST_STATE", folder.path());
  victim.setProcessEnvironment(environment);
  victim.start(QCoreApplication::applicationFilePath(),
               {"--gtest_also_run_disabled_tests", "--gtest_filter=RecordingVictim.*"});
  QByteArray said;
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        said += victim.readAllStandardOutput();
        return said.contains("recorded ") && said.endsWith('\n');
      },
      kLivePatience))
      << said.toStdString();
  EXPECT_TRUE(unfinishedRecordings(folder.path()).isEmpty()) << "a living program's recording is its own";
  victim.kill();  // SIGKILL
  ASSERT_TRUE(victim.waitForFinished());
  const int recorded = said.mid(said.indexOf("recorded ") + 9).trimmed().toInt();
  ASSERT_GT(recorded, 2500);
  const QStringList found = unfinishedRecordings(folder.path());
  ASSERT_EQ(found, QStringList{folder.filePath("run.csv")});
  EXPECT_EQ(unfinishedRecordings(folder.path()), found) << "offered until somebody decides";
  const auto read = readRecording(found.first().toStdString());
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_GE(read->recording.rows(), recorded - 1000);
  EXPECT_EQ(read->recording.meta.robot, "panda");
  forgetUnfinished(found.first());
  EXPECT_TRUE(unfinishedRecordings(folder.path()).isEmpty());
  EXPECT_TRUE(QFile::exists(found.first()));
}

TEST(UnfinishedRecording, NothingIsOfferedAfterANormalEndAndEmptyOnesGo) {
  QTemporaryDir folder;
  const QString csv = folder.filePath("a.csv");
  {
    const UnderWay making(csv);
    EXPECT_FALSE(QDir(folder.path()).isEmpty());
  }
  EXPECT_TRUE(QDir(folder.path()).isEmpty());
  for (const char* name : {"b.csv", "b.csv.unfinished"}) {
    QFile file(folder.filePath(name));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  }
  EXPECT_TRUE(unfinishedRecordings(folder.path()).isEmpty());
  EXPECT_TRUE(QDir(folder.path()).isEmpty());
}

TEST(SourceForm, AsksInPlainWordsAndSaysWhatIsMissing) {
  SourceForm form;
  form.show();
  EXPECT_FALSE(form.addresses().ok()) << "a sensor has no usual address";
  form.findChild<QLineEdit*>("sourceAddress")->setText(" 10.0.0.7 ");
  ASSERT_TRUE(form.addresses().ok());
  EXPECT_EQ(*form.addresses(), (std::vector<std::string>{"rdt:10.0.0.7", "foxglove:localhost"}));
  form.setKind(SourceForm::Kind::jsonUdp);
  form.findChildren<QLineEdit*>("sourceAddress").back()->setText("9999");
  EXPECT_EQ(*form.addresses(), (std::vector<std::string>{"udp:9999"}));
  form.setKind(SourceForm::Kind::netFt);
  EXPECT_EQ(form.addresses()->front(), "rdt:10.0.0.7") << "what was typed in stays";
  // Where the sensor sits is asked, not assumed.
  EXPECT_FALSE(form.meta().ok());
  QTest::mouseClick(form.findChildren<QPushButton*>("mountBelow").back(), Qt::LeftButton);
  form.findChildren<Stepper*>("mountDistance").back()->setValue(40);
  ASSERT_TRUE(form.meta().ok());
  EXPECT_FALSE(form.mountAssumed());
  QTest::mouseClick(form.findChildren<QPushButton*>("mountUnsure").back(), Qt::LeftButton);
  EXPECT_TRUE(form.meta().ok());
  EXPECT_TRUE(form.mountAssumed()) << "to be asked again after the recording";
}

TEST(LivePanel, TheVirtualArmIsRecordedAndTheResultHoldsTheHiddenTool) {
  const QTemporaryDir state;
  qputenv("XDG_STATE_HOME", state.path().toUtf8());
  setRecordedFolder(state.filePath("recordings"));
  Workspace workspace;
  StudioParts parts;
  parts.workspace = &workspace;
  RecordPanel panel(parts);
  panel.resize(440, 900);
  panel.show();
  QTest::mouseClick(panel.findChild<QPushButton*>("wayVirtual"), Qt::LeftButton);
  EXPECT_EQ(panel.findChildren<QPushButton*>("mainButton").size(), 1);
  ASSERT_TRUE(panel.obey({"live", "virtual", "12", "3"})->ok());
  EXPECT_TRUE(panel.run()->running());
  ASSERT_TRUE(QTest::qWaitFor([&] { return panel.run()->view().time > 11.99; }, kLivePatience));
  EXPECT_EQ(panel.state().line, "12.0 s, recording");
  QTest::qWait(100);
  auto* stop = panel.findChild<QPushButton*>("mainButton");
  ASSERT_TRUE(stop->isEnabled());
  QTest::mouseClick(stop, Qt::LeftButton);
  EXPECT_FALSE(panel.run()->running());
  ASSERT_TRUE(QTest::qWaitFor([&] { return workspace.report() != nullptr; }, kLivePatience));
  const auto& report = *workspace.report();
  const double width = report.interval95.mass.upper - report.interval95.mass.lower;
  EXPECT_GT(practiceTool(3).mass, report.interval95.mass.lower - width);
  EXPECT_LT(practiceTool(3).mass, report.interval95.mass.upper + width);
  EXPECT_TRUE(workspace.opened()->recording.meta.knownPayload.mass) << "shown beside the result";
  EXPECT_FALSE(panel.obey({"live", "pass", "1"})->ok());
  EXPECT_FALSE(panel.obey({"live", "dance"})->ok());
  EXPECT_FALSE(panel.obey({"mark", "0", "1"}));
  qunsetenv("XDG_STATE_HOME");
  setRecordedFolder({});
}

TEST(LivePanel, TheRecordingGoesOnWhenTheWindowIsReplacedForAnotherLanguage) {
  const QTemporaryDir state;
  qputenv("XDG_STATE_HOME", state.path().toUtf8());
  setRecordedFolder(state.filePath("recordings"));
  {
    Workspace workspace;
    StudioParts parts;
    parts.workspace = &workspace;
    auto before = std::make_unique<RecordPanel>(parts);
    EXPECT_EQ(before->facts(), "");
    ASSERT_TRUE(before->obey({"live", "virtual", "3", "3"})->ok());
    ASSERT_TRUE(QTest::qWaitFor([&] { return before->run()->view().time > 2.99; }, kLivePatience));
    const QString file = before->run()->file();
    RecordPanel after(parts);
    before.reset();
    ASSERT_TRUE(after.run()->running());
    EXPECT_EQ(after.run()->file(), file);
    EXPECT_EQ(after.state().line, "3.0 s, recording");
    EXPECT_EQ(after.facts(), "Virtual arm, recording");
    EXPECT_NE(after.findChild<QPushButton*>("wanderButton"), nullptr) << "the board of the run, not the choice of ways";
    ASSERT_TRUE(after.obey({"live", "pass", "9"})->ok());
    ASSERT_TRUE(QTest::qWaitFor([&] { return after.run()->view().time > 11.99; }, kLivePatience));
    // Another way begins anew with the same hidden tool.
    const std::uint64_t tool = after.run()->origin().tool;
    QTest::mouseClick(after.findChild<QPushButton*>("posesButton"), Qt::LeftButton);
    EXPECT_TRUE(after.run()->poses());
    EXPECT_EQ(after.run()->origin().tool, tool);
    EXPECT_TRUE(QFileInfo::exists(file)) << "what came is kept";
  }
  qunsetenv("XDG_STATE_HOME");
  setRecordedFolder({});
}

TEST(LivePanel, StandingPosesBecomeARecordingOfPoses) {
  const QTemporaryDir state;
  qputenv("XDG_STATE_HOME", state.path().toUtf8());
  setRecordedFolder(state.filePath("recordings"));
  Workspace workspace;
  StudioParts parts;
  parts.workspace = &workspace;
  RecordPanel panel(parts);
  ASSERT_TRUE(panel.obey({"live", "poses", "2", "4"})->ok());
  const auto settled = [&] {
    for (JobRunner* runner : panel.run()->runners())
      if (runner->running()) return false;
    return true;
  };
  for (int pose = 0; pose < 8; ++pose) {
    ASSERT_TRUE(QTest::qWaitFor(settled, kLivePatience));
    if (!panel.obey({"live", "show"})->ok()) break;
    ASSERT_TRUE(panel.obey({"live", "pass", "9"})->ok());
  }
  ASSERT_TRUE(QTest::qWaitFor(settled, kLivePatience));
  EXPECT_GE(panel.run()->view().poses.size(), 6u);
  ASSERT_TRUE(panel.obey({"live", "stop"})->ok());
  ASSERT_TRUE(QTest::qWaitFor([&] { return workspace.report() != nullptr; }, kLivePatience));
  EXPECT_EQ(workspace.opened()->recording.meta.kind, RecordingKind::poses);
  EXPECT_NEAR(workspace.report()->payload.mass, practiceTool(4).mass, 0.05);
  qunsetenv("XDG_STATE_HOME");
  setRecordedFolder({});
}

}  // namespace
}  // namespace heft
