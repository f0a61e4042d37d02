// What a file does not say by itself is asked in the window: which column is what, which robot, which way forces point.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/json_file.h"
#include "core/recording/csv_reader.h"
#include "ui/controller/robot_choice.h"
#include "ui/controller/workspace.h"
#include "ui/import_dialogs/rig_dialog.h"
#include "ui/import_dialogs/sources_dialog.h"

namespace heft {
namespace {

constexpr int kPatience = 120000;

class ImportDialogsTest : public testing::Test {
 protected:
  QString write(const QString& name, const QString& text) {
    QFile file(folder.filePath(name));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text.toUtf8());
    return file.fileName();
  }
  /// Columns that no program would guess: a stamp in microseconds, forces a to f, angles j1 to j7 in degrees.
  QString foreignTable() {
    QString text = "stamp;a;b;c;d;e;f;j1;j2;j3;j4;j5;j6;j7\n";
    text.replace(';', ',');
    for (int k = 0; k < 400; ++k) {
      const double t = 0.01 * k;
      text += QString::number(1000000.0 * (100.0 + t), 'f', 0);
      for (int c = 0; c < 6; ++c) text += QStringLiteral(",%1").arg(5.0 * std::sin(t + c), 0, 'f', 6);
      for (int j = 0; j < 7; ++j)
        text += QStringLiteral(",%1").arg(20.0 * std::sin(0.7 * t + j) - (j == 3 ? 100.0 : 0.0), 0, 'f', 6);
      text += "\n";
    }
    return write("foreign.csv", text);
  }
  static void settle(SourcesDialog& dialog) {
    ASSERT_TRUE(QTest::qWaitFor([&] { return !dialog.looking(); }, kPatience));
  }
  static void choose(SourcesDialog& dialog, const QString& name, const QString& text) {
    auto* box = dialog.findChild<QComboBox*>(name);
    ASSERT_NE(box, nullptr) << name.toStdString();
    const int at = box->findText(text);
    ASSERT_GE(at, 0) << name.toStdString() << " offers no " << text.toStdString();
    box->setCurrentIndex(at);
    emit box->activated(at);
    settle(dialog);
  }

  QTemporaryDir folder;
};

TEST_F(ImportDialogsTest, ATableWithOwnNamesIsReadAsTheUserSays) {
  const QString file = foreignTable();
  Workspace workspace;
  QSignalSpy unreadable(&workspace, &Workspace::unreadable);
  workspace.open(file);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workspace.busy(); }, kPatience));
  ASSERT_EQ(unreadable.size(), 1);
  EXPECT_EQ(unreadable[0][0].toString(), file);
  EXPECT_EQ(unreadable[0][2].value<ReadCure>(), ReadCure::sources);
  EXPECT_FALSE(workspace.opened());

  SourcesDialog dialog(file);
  settle(dialog);
  EXPECT_FALSE(dialog.complete());
  EXPECT_FALSE(dialog.findChild<QPushButton*>("readSo")->isEnabled());
  EXPECT_FALSE(dialog.findChild<QLabel*>("sourcesState")->text().isEmpty());
  choose(dialog, "source_time", "stamp");
  choose(dialog, "unit_time", "µs");
  const char* const wrench[] = {"fx", "fy", "fz", "tx", "ty", "tz"};
  for (int c = 0; c < 6; ++c)
    choose(dialog, QStringLiteral("column_%1").arg(QLatin1String(wrench[c])), QString(QChar('a' + c)));
  EXPECT_TRUE(dialog.complete()) << "j1 to j7 are joints by their names";
  for (int j = 1; j <= 7; ++j) choose(dialog, QStringLiteral("column_q%1").arg(j), QStringLiteral("j%1").arg(j));
  EXPECT_TRUE(dialog.complete()) << dialog.findChild<QLabel*>("sourcesState")->text().toStdString();
  choose(dialog, "unit_joints", "degrees");
  ASSERT_TRUE(dialog.complete());
  dialog.accept();
  EXPECT_EQ(dialog.result(), QDialog::Accepted);

  workspace.open(file);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workspace.busy() && workspace.opened(); }, kPatience));
  const Recording& recording = workspace.opened()->recording;
  EXPECT_NEAR(recording.duration(), 3.99, 1e-6);
  EXPECT_NEAR(recording.rateHz(), 100.0, 1e-3);
  EXPECT_NEAR(recording.wrench(0, 1), 5.0 * std::sin(1.0), 1e-5);
  EXPECT_NEAR(recording.q(0, 1), 20.0 * std::sin(1.0) * M_PI / 180, 1e-6);
  EXPECT_EQ(recording.meta.robot, "panda");

  // It comes back with what was said, and the guess takes the file away again.
  SourcesDialog again(file);
  settle(again);
  EXPECT_TRUE(again.complete());
  EXPECT_EQ(again.findChild<QComboBox*>("column_fy")->currentText(), "b");
  EXPECT_EQ(again.findChild<QComboBox*>("unit_joints")->currentText(), "degrees");
  EXPECT_EQ(again.findChild<QComboBox*>("source_time")->currentText(), "stamp");
  again.findChild<QPushButton*>("heftsGuess")->click();
  settle(again);
  EXPECT_FALSE(again.complete());
  EXPECT_TRUE(again.keep().ok());
  EXPECT_FALSE(QFile::exists(folder.filePath("foreign.map.json")));
}

TEST_F(ImportDialogsTest, TheWrenchMayStandInAnotherFile) {
  QString arm = "time,q1,q2,q3,q4,q5,q6,q7\n", sensor = "time,fx,fy,fz,tx,ty,tz\n";
  for (int k = 0; k < 300; ++k) {
    const double t = 0.01 * k;
    arm += QString::number(t);
    for (int j = 0; j < 7; ++j) arm += QStringLiteral(",%1").arg(0.3 * std::sin(t + j) - (j == 3 ? 1.5 : 0.0));
    sensor += QString::number(t);
    for (int c = 0; c < 6; ++c) sensor += QStringLiteral(",%1").arg(std::cos(2 * t + c));
    arm += "\n";
    sensor += "\n";
  }
  const QString file = write("arm.csv", arm);
  write("sensor.csv", sensor);
  MappingWishes wishes;
  wishes.join.emplace_back(folder.filePath("sensor.csv").toStdString());
  ASSERT_TRUE(writeTextFile(mapFileOf(file.toStdString()), mapText(wishes, folder.path().toStdString())).ok());
  const auto text = readTextFile(mapFileOf(file.toStdString()));
  ASSERT_TRUE(text.ok());
  EXPECT_EQ(text->find(folder.path().toStdString()), std::string::npos)
      << "a file beside it is named without its folder";
  SourcesDialog dialog(file);
  settle(dialog);
  EXPECT_TRUE(dialog.complete()) << dialog.findChild<QLabel*>("sourcesState")->text().toStdString();
  EXPECT_EQ(dialog.wishes().join.size(), 1u);
  EXPECT_TRUE(dialog.findChild<QComboBox*>("source_wrench")->currentText().contains("sensor.csv"));
}

TEST_F(ImportDialogsTest, ABrokenMapFileIsSaidAndCanBeTakenAway) {
  const QString file = foreignTable();
  write("foreign.map.json", "{\"use\": 7}");
  SourcesDialog dialog(file);
  settle(dialog);
  EXPECT_FALSE(dialog.complete());
  EXPECT_TRUE(dialog.findChild<QLabel*>("sourcesState")->text().contains("foreign.map.json"));
  auto* guess = dialog.findChild<QPushButton*>("heftsGuess");
  ASSERT_TRUE(guess->isEnabled());
  guess->click();
  settle(dialog);
  EXPECT_FALSE(dialog.findChild<QLabel*>("sourcesState")->text().contains("map.json"));
}

TEST_F(ImportDialogsTest, RobotAndSensorGoIntoTheMetaFileAndNothingElseChanges) {
  QString text = "time,q1,q2,q3,q4,q5,q6,fx,fy,fz,tx,ty,tz\n";
  for (int k = 0; k < 200; ++k) {
    text += QString::number(0.01 * k);
    for (int c = 0; c < 12; ++c) text += QStringLiteral(",%1").arg(0.2 * std::sin(0.02 * k + c));
    text += "\n";
  }
  const QString file = write("six.csv", text);
  write("six.meta.json",
        "{\"note\": \"kept\", \"sensor\": {\"mount\": {\"parent\": \"tool0\", \"xyz_m\": [0, 0, 0.0123456789]}}}");
  Workspace workspace;
  QSignalSpy unreadable(&workspace, &Workspace::unreadable);
  workspace.open(file);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workspace.busy(); }, kPatience));
  ASSERT_EQ(unreadable.size(), 1);
  EXPECT_EQ(unreadable[0][2].value<ReadCure>(), ReadCure::rig);

  QString urdf = "<robot name=\"six\"><link name=\"base\"/>";
  for (int j = 1; j <= 6; ++j)
    urdf += QStringLiteral(
                "<link name=\"%1\"/><joint name=\"j%2\" type=\"revolute\"><parent link=\"%3\"/><child link=\"%1\"/>"
                "<origin xyz=\"0 0 0.2\" rpy=\"0 0.3 0\"/><axis xyz=\"0 0 1\"/>"
                "<limit lower=\"-3\" upper=\"3\" effort=\"50\" velocity=\"2\"/></joint>")
                .arg(j == 6 ? QString("tool0") : QStringLiteral("l%1").arg(j))
                .arg(j)
                .arg(j == 1 ? QString("base") : QStringLiteral("l%1").arg(j - 1));
  const QString robot = write("six.urdf", urdf + "</robot>");
  const auto before = rigOf(file, nullptr);
  ASSERT_TRUE(before.ok());
  RigDialog dialog(file, *before, [&](const RecordingMeta& after) {
    const auto written = writeRig(file, nullptr, *before, after);
    return written ? QString() : QString::fromStdString(written.error().message);
  });
  auto* choice = dialog.findChild<QComboBox*>("rigRobot");
  choice->setCurrentIndex(1);
  dialog.findChild<QLineEdit*>("rigUrdf")->setText(folder.filePath("none.urdf"));
  dialog.accept();
  EXPECT_NE(dialog.result(), QDialog::Accepted);
  EXPECT_FALSE(dialog.findChild<QLabel*>("rigProblem")->text().isEmpty());
  dialog.findChild<QLineEdit*>("rigUrdf")->setText(robot);
  emit dialog.findChild<QLineEdit*>("rigUrdf")->editingFinished();
  EXPECT_EQ(dialog.findChild<QComboBox*>("rigLink")->currentText(), "tool0");
  EXPECT_GE(dialog.findChild<QComboBox*>("rigLink")->count(), 7);
  dialog.findChild<QComboBox*>("rigSign")->setCurrentIndex(1);
  dialog.accept();
  ASSERT_EQ(dialog.result(), QDialog::Accepted) << dialog.findChild<QLabel*>("rigProblem")->text().toStdString();

  const auto meta = readJsonFile(folder.filePath("six.meta.json").toStdString());
  ASSERT_TRUE(meta.ok());
  EXPECT_EQ((*meta)["note"], "kept");
  EXPECT_EQ((*meta)["sensor"]["mount"]["xyz_m"][2].get<double>(), 0.0123456789)
      << "what was not touched keeps its digits";
  EXPECT_EQ((*meta)["sensor"]["wrench_sign"], "payload_on_sensor");
  EXPECT_FALSE(meta->contains("gravity_m_s2"));
  workspace.open(file);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workspace.busy() && workspace.opened(); }, kPatience));
  EXPECT_EQ(workspace.opened()->robot->name(), "six");
  // In memory a wrench is always the sensor's on the tool.
  EXPECT_NEAR(workspace.opened()->recording.wrench(0, 0), -0.2 * std::sin(6.0), 1e-5);
}

TEST_F(ImportDialogsTest, ConventionsAreSetInTheDialogAndObeyed) {
  const auto cell = [](int k, int c) { return 0.2 * std::sin(0.02 * k + c); };
  QString text = "time,qx,qy,qz,qw,px,py,pz,fx,fy,fz,tx,ty,tz\n";
  for (int k = 0; k < 200; ++k) {
    const double half = 0.5 * cell(k, 0);
    // w stands first: (cos, 0, 0, sin) is a turn about z.
    text +=
        QStringLiteral("%1,%2,0,0,%3").arg(0.01 * k).arg(std::cos(half), 0, 'g', 17).arg(std::sin(half), 0, 'g', 17);
    for (int c = 0; c < 9; ++c) text += QStringLiteral(",%1").arg(cell(k, c), 0, 'g', 17);
    text += "\n";
  }
  const QString file = write("odd.csv", text);
  write("odd.meta.json",
        R"({"robot": null, "note": "kept", "length_unit": "mm", "sensor": {"torque_unit": 0.123456789123}})");
  write("odd.map.json", R"({"clock": "received", "sensor": {"torque_unit": "N cm", "torque_sign": "opposite"}})");
  Workspace workspace;
  workspace.open(file);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workspace.busy() && workspace.opened(); }, kPatience));
  const auto opened = workspace.opened();
  EXPECT_EQ(opened->recording.meta.conventions.torque.name, "N cm") << "the map file counts more";
  const RecordingMeta before = opened->recording.meta;
  RigDialog dialog(file, before, [&](const RecordingMeta& after) {
    const auto written = writeRig(file, opened.get(), before, after);
    return written ? QString() : QString::fromStdString(written.error().message);
  });
  EXPECT_EQ(dialog.meta().conventions, before.conventions) << "nothing was touched";
  EXPECT_TRUE(dialog.findChild<QPushButton*>("rigConventions")->isChecked()) << "what is not the usual is shown";
  const auto choose = [&](const char* name, int index) {
    auto* box = dialog.findChild<QComboBox*>(name);
    ASSERT_NE(box, nullptr) << name;
    box->setCurrentIndex(index);
  };
  dialog.show();
  const int unfolded = dialog.height();
  dialog.findChild<QPushButton*>("rigConventions")->click();
  EXPECT_LT(dialog.height(), unfolded - 100);
  dialog.findChild<QPushButton*>("rigConventions")->click();
  EXPECT_EQ(dialog.findChild<QComboBox*>("rigLengths")->currentIndex(), 1);
  choose("rigWrenchAxes", 1);
  choose("rigMirror", 2);
  choose("rigForceUnit", 2);
  choose("rigTorqueUnit", 1);
  choose("rigLengths", 0);
  choose("rigQuaternions", 1);
  dialog.accept();
  ASSERT_EQ(dialog.result(), QDialog::Accepted) << dialog.findChild<QLabel*>("rigProblem")->text().toStdString();
  const auto meta = readJsonFile(folder.filePath("odd.meta.json").toStdString());
  ASSERT_TRUE(meta.ok());
  EXPECT_EQ(*meta, nlohmann::json::parse(R"({"robot": null, "note": "kept", "quaternion_order": "wxyz", "sensor":
    {"wrench_axes": "base", "mirrored_axis": "y", "force_unit": "kgf", "torque_unit": "N mm"}})"));
  const auto map = readJsonFile(folder.filePath("odd.map.json").toStdString());
  EXPECT_EQ(*map, nlohmann::json::parse(R"({"clock": "received", "sensor": {"torque_sign": "opposite"}})"));
  workspace.open(file);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !workspace.busy() && workspace.opened() != opened; }, kPatience));
  const Recording& recording = workspace.opened()->recording;
  // A turn by -angle about z, then y mirrored.
  const double angle = cell(7, 0);
  const double fx = 9.80665 * cell(7, 3), fy = 9.80665 * cell(7, 4);
  EXPECT_NEAR(recording.wrench(7, 0), std::cos(angle) * fx + std::sin(angle) * fy, 1e-9);
  EXPECT_NEAR(recording.wrench(7, 1), -(std::cos(angle) * fy - std::sin(angle) * fx), 1e-9);
  EXPECT_NEAR(recording.wrench(7, 5), -1e-3 * cell(7, 8), 1e-9);
}

}  // namespace
}  // namespace heft
