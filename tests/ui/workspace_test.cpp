#include <gtest/gtest.h>

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QProcess>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "core/base/json_file.h"
#include "core/recording/csv_reader.h"
#include "core/simulation/simulate.h"
#include "core/simulation/virtual_rig.h"
#include "tests/ui/fixtures.h"
#include "ui/controller/autosave.h"
#include "ui/controller/robot_choice.h"
#include "ui/controller/workspace.h"

namespace heft {
namespace {

constexpr int kPatience = 60000;

/// A recording that a reader accepts: within an arm's reach.
Recording reachable(Eigen::Index rows, double rateHz) {
  Recording recording = test::sineRecording(rows, rateHz);
  recording.position *= 0.05;
  return recording;
}

QString writeSine(const QTemporaryDir& folder, const QString& name) {
  const QString path = folder.filePath(name);
  const auto written = writeRecording(reachable(2000, 200), path.toStdString());
  EXPECT_TRUE(written.ok());
  return path;
}

class WorkspaceTest : public testing::Test {
 protected:
  void open(const QStringList& files) {
    workspace.open(files);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !workspace.busy(); }, kPatience));
    ASSERT_TRUE(workspace.opened());
  }
  const std::vector<Mark>& marks() {
    return workspace.session().recordings[static_cast<std::size_t>(workspace.session().active)].marks;
  }
  QTemporaryDir folder;
  Workspace workspace;
};

TEST_F(WorkspaceTest, SeveralRecordingsAreOpenedAndTheLastIsShown) {
  const QStringList files{writeSine(folder, "a.csv"), writeSine(folder, "b.csv")};
  QSignalSpy failed(&workspace, &Workspace::failed);
  open(files + QStringList{folder.filePath("none.csv")});
  EXPECT_EQ(failed.count(), 1);
  EXPECT_EQ(workspace.session().recordings.size(), 2u);
  EXPECT_EQ(workspace.opened()->path, files[1]);
  workspace.activate(0);
  EXPECT_EQ(workspace.opened()->path, files[0]);
  open({files[1]});  // Opened again: shown, not doubled.
  EXPECT_EQ(workspace.session().recordings.size(), 2u);
  EXPECT_EQ(workspace.opened()->path, files[1]);
}

TEST_F(WorkspaceTest, ARecordingIsClosedAndComesBackWithItsMarks) {
  const QStringList files{writeSine(folder, "a.csv"), writeSine(folder, "b.csv"), writeSine(folder, "c.csv")};
  open(files);
  workspace.activate(1);
  workspace.paint(2, 4, MarkLabel::ignore);
  workspace.close(1);
  EXPECT_EQ(workspace.session().recordings.size(), 2u);
  EXPECT_EQ(workspace.opened()->path, files[2]) << "the next one is shown";
  workspace.close(0);
  EXPECT_EQ(workspace.opened()->path, files[2]) << "closing another one leaves the shown one";
  EXPECT_TRUE(QFileInfo::exists(files[0])) << "the file stays";
  workspace.undoStack()->undo();
  workspace.undoStack()->undo();
  ASSERT_EQ(workspace.session().recordings.size(), 3u);
  EXPECT_EQ(workspace.opened()->path, files[1]);
  EXPECT_EQ(marks().size(), 1u);
  workspace.undoStack()->undo();
  EXPECT_TRUE(marks().empty()) << "the mark of the recording that came back";
  for (int k = 0; k < 3; ++k) workspace.close(0);
  EXPECT_FALSE(workspace.opened());
}

TEST_F(WorkspaceTest, ANameOfARecordingIsKeptInTheSession) {
  open({writeSine(folder, "a.csv")});
  workspace.rename(0, "  gripper, first try ");
  EXPECT_EQ(workspace.nameOf(0), "gripper, first try");
  ASSERT_TRUE(workspace.save(folder.filePath("named.heft")));
  Workspace other;
  other.open(folder.filePath("named.heft"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !other.busy(); }, kPatience));
  EXPECT_EQ(other.nameOf(0), "gripper, first try");
  workspace.undoStack()->undo();
  EXPECT_EQ(workspace.nameOf(0), "a.csv");
  workspace.rename(0, "x");
  workspace.rename(0, "");
  EXPECT_EQ(workspace.nameOf(0), "a.csv");
}

TEST_F(WorkspaceTest, RecordingsOfOneToolGiveOneResult) {
  SimulateOptions options;
  options.duration = 6.0;
  options.rateHz = 200.0;
  Payload tool;
  tool.mass = 0.8;
  tool.com = {0.005, -0.01, 0.06};
  tool.inertiaCom = Vector3d(0.0021, 0.0019, 0.0012).asDiagonal();
  QStringList files;
  const auto write = [&](const Payload& payload) {
    options.seed = 11 + static_cast<std::uint64_t>(files.size());
    files << folder.filePath(QStringLiteral("part%1.csv").arg(files.size()));
    const auto made = simulate(RobotModel::panda(), payload, options);
    ASSERT_TRUE(made.ok());
    ASSERT_TRUE(writeRecording(made->recording, files.back().toStdString()).ok());
  };
  write(tool);
  write(tool);
  open(files);
  ASSERT_TRUE(workspace.report());
  const double alone = workspace.report()->std.mass;
  workspace.setJoined(true);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workspace.busy(); }, kPatience));
  ASSERT_TRUE(workspace.reportAt(0) && workspace.reportAt(1));
  EXPECT_DOUBLE_EQ(workspace.reportAt(0)->payload.mass, workspace.reportAt(1)->payload.mass);
  EXPECT_LT(workspace.report()->std.mass, alone);
  EXPECT_NEAR(workspace.report()->payload.mass, 0.8, 0.01);
  const auto says = [&](int k, const char* code) {
    const auto& findings = workspace.reportAt(k)->findings;
    return std::any_of(findings.begin(), findings.end(), [&](const Finding& f) { return f.code == code; });
  };
  EXPECT_TRUE(says(0, "joined") && says(1, "joined"));
  // A third of another tool is left out, and every recording says so.
  tool.mass = 1.3;
  write(tool);
  open({files[2]});
  EXPECT_TRUE(says(2, "not_joined"));
  EXPECT_NEAR(workspace.reportAt(2)->payload.mass, 1.3, 0.02);
  EXPECT_TRUE(says(0, "different_tool") && says(1, "different_tool"));
  EXPECT_NEAR(workspace.reportAt(0)->payload.mass, 0.8, 0.01);
  // Without it the others are joined still; each by itself again after undoing.
  workspace.close(2);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workspace.busy(); }, kPatience));
  EXPECT_FALSE(says(0, "different_tool"));
  workspace.undoStack()->undo();
  workspace.undoStack()->undo();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workspace.busy(); }, kPatience));
  workspace.activate(0);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workspace.busy(); }, kPatience));
  EXPECT_FALSE(says(0, "joined"));
}

TEST_F(WorkspaceTest, PaintingIsUndoneAndEstimatesAgain) {
  open({writeSine(folder, "a.csv")});
  const auto before = workspace.report();
  workspace.paint(2, 4, MarkLabel::ignore);
  EXPECT_EQ(marks().size(), 1u);
  EXPECT_TRUE(workspace.busy());
  EXPECT_TRUE(workspace.outdated());
  bool shown = false;
  for (const Segment& segment : workspace.segments())
    shown = shown || (segment.label == MarkLabel::ignore && segment.from == 2 && segment.to == 4);
  EXPECT_TRUE(shown) << "painting is seen before the next estimate";
  EXPECT_EQ(workspace.undoStack()->undoText(), "mark as ignored");
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workspace.busy(); }, kPatience));
  EXPECT_FALSE(workspace.outdated());
  EXPECT_NE(workspace.report(), before);
  workspace.undoStack()->undo();
  EXPECT_TRUE(marks().empty());
  workspace.undoStack()->redo();
  EXPECT_EQ(marks().size(), 1u);
}

TEST_F(WorkspaceTest, ADragIsOneStep) {
  open({writeSine(folder, "a.csv")});
  ShapeChoice shape;
  shape.answer = ShapeChoice::Answer::given;
  ShapeBody body;
  body.dims = {0.1, 0.1, 0.1};
  const int key = workspace.newMergeKey();
  for (int k = 1; k <= 5; ++k) {
    body.dims[0] = 0.1 + 0.01 * k;
    shape.shape.bodies = {body};
    workspace.setShape(shape, "size", key);
  }
  EXPECT_EQ(workspace.undoStack()->count(), 1);
  EXPECT_NEAR(workspace.session().shape.shape.bodies[0].dims[0], 0.15, 1e-12);
  workspace.setShape(shape, "size", workspace.newMergeKey());
  EXPECT_EQ(workspace.undoStack()->count(), 2);
  workspace.undoStack()->undo();
  workspace.undoStack()->undo();
  EXPECT_EQ(workspace.session().shape.answer, ShapeChoice::Answer::notGiven);
}

TEST_F(WorkspaceTest, ASessionComesBackWithRecordingsAndMarks) {
  const QStringList files{writeSine(folder, "a.csv"), writeSine(folder, "b.csv")};
  open(files);
  workspace.activate(0);
  workspace.paint(1, 2, MarkLabel::contact);
  EXPECT_TRUE(workspace.modified());
  const QString session = folder.filePath("work.heft");
  ASSERT_TRUE(workspace.save(session));
  EXPECT_FALSE(workspace.modified());
  Workspace other;
  other.open(session);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !other.busy() && other.opened(); }, kPatience));
  EXPECT_EQ(other.opened()->path, files[0]);
  EXPECT_EQ(other.session().recordings.size(), 2u);
  ASSERT_EQ(other.session().recordings[0].marks.size(), 1u);
  EXPECT_EQ(other.session().recordings[0].marks[0].label, MarkLabel::contact);
  EXPECT_TRUE(other.report());
  EXPECT_FALSE(other.modified());
}

TEST_F(WorkspaceTest, ANewSessionStaysEmptyThoughAFileWasBeingRead) {
  workspace.open(writeSine(folder, "a.csv"));
  workspace.startAfresh();
  QTest::qWait(500);
  EXPECT_FALSE(workspace.opened());
  EXPECT_TRUE(workspace.session().recordings.empty());
  EXPECT_FALSE(workspace.busy());
  open({folder.filePath("a.csv")});
  EXPECT_TRUE(workspace.report());
}

TEST_F(WorkspaceTest, ASessionOfANewerHeftLeavesEverythingInPlace) {
  open({writeSine(folder, "a.csv")});
  const QString newer = folder.filePath("newer.heft");
  QFile file(newer);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("{\"schema\": \"heft.session/99\"}");
  file.close();
  QSignalSpy failed(&workspace, &Workspace::failed);
  workspace.open(newer);
  ASSERT_EQ(failed.count(), 1);
  EXPECT_TRUE(failed.at(0).at(0).toString().contains("newer Heft"));
  EXPECT_TRUE(workspace.opened());
}

TEST_F(WorkspaceTest, RecordingsMadeHereGetAFreeName) {
  const QString made = folder.filePath("made");
  workspace.addRecording(reachable(1000, 100), made, "virtual");
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workspace.busy(); }, kPatience));
  workspace.addRecording(reachable(1000, 100), made, "virtual");
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workspace.busy(); }, kPatience));
  EXPECT_TRUE(QFile::exists(made + "/virtual.csv"));
  EXPECT_TRUE(QFile::exists(made + "/virtual-2.csv"));
  EXPECT_EQ(workspace.session().recordings.size(), 2u);
}

TEST_F(WorkspaceTest, AnotherRobotIsNamedInTheMetaFileAndOnlyIfItFits) {
  const QString file = folder.filePath("robot.csv");
  SimulateOptions options;
  options.duration = 4.0;
  const auto simulated = simulate(RobotModel::panda(), practiceTool(1), options);
  ASSERT_TRUE(simulated.ok() && writeRecording(simulated->recording, file.toStdString()).ok());
  workspace.open(file);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workspace.busy() && workspace.opened(); }, kPatience));
  const auto before = readTextFile(metaFileBeside(workspace.opened()->path).toStdString());
  const auto write = [&](const char* name, int joints, const char* last) {
    QString text = QStringLiteral("<robot name=\"own\"><link name=\"l0\"/>");
    for (int j = 1; j <= joints; ++j)
      text += QStringLiteral(
                  "<link name=\"%1\"/><joint name=\"j%2\" type=\"revolute\"><parent link=\"%3\"/><child link=\"%1\"/>"
                  "<origin xyz=\"0 0 0.1\" rpy=\"0 %4 0\"/><axis xyz=\"0 0 1\"/>"
                  "<limit lower=\"-3\" upper=\"3\" effort=\"50\" velocity=\"2\"/></joint>")
                  .arg(j == joints ? QString(last) : QStringLiteral("l%1").arg(j))
                  .arg(j)
                  .arg(QStringLiteral("l%1").arg(j - 1))
                  .arg(0.3 * j);
    QFile urdf(folder.filePath(name));
    EXPECT_TRUE(urdf.open(QIODevice::WriteOnly));
    urdf.write((text + "</robot>").toUtf8());
    return folder.filePath(name);
  };
  for (const QString& wrong :
       {write("six.urdf", 6, "panda_link8"), write("nowhere.urdf", 7, "tip"), folder.filePath("none.urdf")}) {
    const auto named = nameRobot(*workspace.opened(), wrong);
    ASSERT_FALSE(named.ok()) << wrong.toStdString();
    EXPECT_FALSE(named.error().message.empty());
  }
  const auto still = readTextFile(metaFileBeside(workspace.opened()->path).toStdString());
  EXPECT_EQ(still ? *still : "", before ? *before : "") << "nothing was written";
  ASSERT_TRUE(nameRobot(*workspace.opened(), write("own.urdf", 7, "panda_link8")).ok());
  workspace.open(file);
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return !workspace.busy() && workspace.opened()->robot && workspace.opened()->robot->name() == "own"; },
      kPatience));
  EXPECT_EQ(workspace.session().recordings.size(), 1u);
}

/// What the test below starts and kills; by itself it does nothing.
TEST(AutosaveVictim, DISABLED_WorksUntilItIsKilled) {
  const QString state = qEnvironmentVariable("HEFT_TEST_STATE"), file = qEnvironmentVariable("HEFT_TEST_FILE");
  ASSERT_FALSE(state.isEmpty());
  Workspace workspace;
  Autosave autosave(&workspace, state, 50);
  workspace.open(file);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workspace.busy(); }, kPatience));
  workspace.paint(3, 5, MarkLabel::contact);
  workspace.setStep("mark");
  QTest::qWait(300);
  std::printf("painted\n");
  std::fflush(stdout);
  QTest::qWait(60000);
}

TEST(Autosave, NothingIsLostByAKill) {
  QTemporaryDir folder;
  const QString state = folder.filePath("state");
  QProcess victim;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert("HEFT_TEST_STATE", state);
  environment.insert("HEFT_TEST_FILE", writeSine(folder, "a.csv"));
  victim.setProcessEnvironment(environment);
  victim.start(QCoreApplication::applicationFilePath(),
               {"--gtest_also_run_disabled_tests", "--gtest_filter=AutosaveVictim.*"});
  QByteArray said;
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        said += victim.readAllStandardOutput();
        return said.contains("painted\n");
      },
      kPatience))
      << said.toStdString();
  {
    Workspace workspace;
    Autosave autosave(&workspace, state, 50);
    EXPECT_TRUE(autosave.leftBehind().isEmpty()) << "a session of a living program is not taken from it";
  }
  victim.kill();  // SIGKILL
  ASSERT_TRUE(victim.waitForFinished());
  Workspace workspace;
  Autosave autosave(&workspace, state, 50);
  ASSERT_EQ(autosave.leftBehind().size(), 1);
  const auto recovered = autosave.recover();
  ASSERT_TRUE(recovered.opened && recovered.unreadable.isEmpty());
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workspace.busy() && workspace.opened(); }, kPatience));
  EXPECT_EQ(workspace.opened()->path, folder.filePath("a.csv"));
  ASSERT_EQ(workspace.session().recordings[0].marks.size(), 1u);
  EXPECT_EQ(workspace.session().recordings[0].marks[0].from, 3);
  EXPECT_EQ(workspace.session().step, "mark");
  EXPECT_TRUE(autosave.leftBehind().isEmpty()) << "it is now this program's own";
  EXPECT_TRUE(QFile::exists(autosave.file())) << "and a second kill loses nothing either";
  EXPECT_TRUE(workspace.modified() && !workspace.undoStack()->isClean()) << "it stands in no file yet: closing asks";
  ASSERT_TRUE(workspace.save(folder.filePath("kept.heft")));
  EXPECT_FALSE(workspace.modified());
}

TEST(Autosave, WhatCannotBeReadIsMovedAsideAndNamed) {
  QTemporaryDir folder;
  Workspace earlier;
  earlier.open(writeSine(folder, "a.csv"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !earlier.busy() && earlier.opened(); }, kPatience));
  const QString good = folder.filePath("autosave-999997-0.heft");
  ASSERT_TRUE(earlier.save(good));
  std::string newer = *readTextFile(good.toStdString());
  newer.replace(newer.find("heft.session/1"), 14, "heft.session/2");
  const std::string damaged = newer.substr(0, newer.size() / 2);
  // Newer than the good one, so that both are met first.
  for (const auto& [name, text] : {std::pair{"autosave-999998-0.heft", newer}, {"autosave-999999-0.heft", damaged}}) {
    QFile file(folder.filePath(name));
    ASSERT_TRUE(writeTextFile(file.fileName().toStdString(), text));
    ASSERT_TRUE(file.open(QIODevice::ReadWrite));
    ASSERT_TRUE(file.setFileTime(QDateTime::currentDateTime().addSecs(60), QFileDevice::FileModificationTime));
  }
  Workspace workspace;
  Autosave autosave(&workspace, folder.path(), 50);
  const auto recovered = autosave.recover();
  EXPECT_TRUE(recovered.opened) << "the one that can be read";
  ASSERT_EQ(recovered.unreadable.size(), 2);
  QStringList texts;
  for (const auto& [file, reason] : recovered.unreadable) {
    EXPECT_TRUE(QFileInfo(file).fileName().startsWith("unreadable-autosave-99999")) << file.toStdString();
    EXPECT_FALSE(reason.isEmpty());
    texts << QString::fromStdString(*readTextFile(file.toStdString()));
  }
  EXPECT_TRUE(texts.contains(QString::fromStdString(newer)) && texts.contains(QString::fromStdString(damaged)));
  EXPECT_TRUE(autosave.leftBehind().isEmpty()) << "it is not offered again";
}

TEST(Autosave, AFullDiskIsToldOnceAndTriedAgain) {
  QTemporaryDir folder;
  Workspace workspace;
  Autosave autosave(&workspace, folder.filePath("state"), 20);
  QStringList told;
  QObject::connect(&autosave, &Autosave::failed, [&](const QString& why) { told << why; });
  ASSERT_TRUE(QDir(folder.filePath("state")).removeRecursively());
  ASSERT_TRUE(writeTextFile(folder.filePath("state").toStdString(), "nothing can be written below a file"));
  for (const char* step : {"mark", "shape", "mark"}) {
    workspace.setStep(step);
    autosave.flush();
  }
  ASSERT_EQ(told.size(), 1);
  EXPECT_TRUE(told[0].contains("cannot be written")) << told[0].toStdString();
  ASSERT_TRUE(QFile::remove(folder.filePath("state")));
  autosave.flush();
  EXPECT_TRUE(QFile::exists(autosave.file())) << "and nothing has to change for it";
}

TEST(Autosave, AFolderThatIsMissingAtTheStartIsToldOnceAndTriedAgain) {
  QTemporaryDir folder;
  const QString state = folder.filePath("state");
  ASSERT_TRUE(writeTextFile(state.toStdString(), "a file where the folder should be"));
  Workspace workspace;
  Autosave autosave(&workspace, state + "/heft", 20);
  QStringList told;
  QObject::connect(&autosave, &Autosave::failed, [&](const QString& why) { told << why; });
  for (const char* step : {"mark", "shape", "mark"}) {
    workspace.setStep(step);
    autosave.flush();
  }
  ASSERT_EQ(told.size(), 1);
  EXPECT_TRUE(told[0].contains("cannot be written")) << told[0].toStdString();
  EXPECT_EQ(autosave.problem(), told[0]);
  ASSERT_TRUE(QFile::remove(state));
  autosave.flush();
  EXPECT_TRUE(QFile::exists(autosave.file())) << "and nothing has to change for it";
  EXPECT_TRUE(QFile::exists(lockBeside(autosave.file()))) << "another program shall not take it for a dead one's";
  EXPECT_TRUE(autosave.problem().isEmpty());
  // A folder that somebody deletes takes the lock with it.
  ASSERT_TRUE(QDir(state).removeRecursively());
  workspace.setStep("shape");
  autosave.flush();
  EXPECT_TRUE(QFile::exists(autosave.file()) && QFile::exists(lockBeside(autosave.file())));
  EXPECT_EQ(told.size(), 1);
}

TEST(Autosave, ANormalEndLeavesNothingBehind) {
  QTemporaryDir folder;
  Workspace workspace;
  QString file;
  {
    Autosave autosave(&workspace, folder.path(), 1);
    workspace.setStep("mark");
    autosave.flush();
    file = autosave.file();
    EXPECT_TRUE(QFile::exists(file));
  }
  EXPECT_TRUE(QDir(folder.path()).entryList(QDir::Files).isEmpty());
}

}  // namespace
}  // namespace heft
