#pragma once
// A test in the real window, with a folder of its own for files and for what the program keeps.
#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <QTest>

#include "core/recording/csv_reader.h"
#include "core/simulation/simulate.h"
#include "tests/gl/pictures.h"
#include "ui/controller/autosave.h"
#include "ui/controller/workspace.h"
#include "ui/main_window/main_window.h"
#include "ui/robot_view/robot_view.h"

namespace heft {

/// Where the recording that the simulation made was written to; empty where that failed, which fails the test.
inline QString writeSimulated(const QTemporaryDir& folder, const Payload& tool, const SimulateOptions& options) {
  const auto simulated = simulate(RobotModel::panda(), tool, options);
  EXPECT_TRUE(simulated.ok()) << (simulated.ok() ? std::string() : simulated.error().message);
  if (!simulated) return {};
  const QString path = folder.filePath("simulated.csv");
  EXPECT_TRUE(writeRecording(simulated->recording, path.toStdString()).ok());
  return path;
}

class RealWindowTest : public testing::Test {
 protected:
  /// `name` begins those of the pictures.
  explicit RealWindowTest(const char* name) : window(&workspace, false), name_(name) {
    qputenv("XDG_STATE_HOME", folder.path().toUtf8());
    setRecordedFolder(folder.filePath("recordings"));
    window.resize(1440, 900);
    window.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&window));
    settle();
  }
  ~RealWindowTest() override {
    qunsetenv("XDG_STATE_HOME");
    setRecordedFolder({});
  }
  void TearDown() override { keepPicture(window, name_); }

  /// Until no job runs, and a little longer, for what is drawn after it.
  void settle(int more = 100) {
    ASSERT_TRUE(QTest::qWaitFor([&] { return window.settled(); }, 120000));
    QTest::qWait(more);
  }
  void open(const QString& recording) {
    workspace.open(recording);
    settle();
    ASSERT_TRUE(workspace.opened());
    ASSERT_TRUE(workspace.report());
  }
  /// All labels of a step's panel that are seen, a line each.
  QString texts(Step step) {
    QString all;
    for (const QLabel* label : window.panel(step)->findChildren<QLabel*>())
      if (label->isVisible()) all += label->text() + "\n";
    return all;
  }
  QImage viewPicture() {
    window.robotView()->renderNow();
    return window.robotView()->grab().toImage().convertToFormat(QImage::Format_RGB32);
  }

  QTemporaryDir folder;
  Workspace workspace;
  MainWindow window;

 private:
  const char* name_;
};

}  // namespace heft
