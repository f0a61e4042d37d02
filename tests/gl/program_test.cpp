// heft-studio from outside, as a script or a person in a terminal meets it.
#include <gtest/gtest.h>

#include <QFile>
#include <QImage>
#include <QProcess>
#include <QTemporaryDir>
#include <set>

#include "core/recording/csv_reader.h"
#include "core/simulation/simulate.h"

namespace heft {
namespace {

struct Outcome {
  int code;
  QString out, err;
};

/// Runs the program without any display.
Outcome run(const QStringList& arguments, const QString& path = {}) {
  QProcess process;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM", "XAUTHORITY"}) environment.remove(name);
  if (!path.isNull()) environment.insert("PATH", path);
  process.setProcessEnvironment(environment);
  process.start(HEFT_STUDIO_BINARY, arguments);
  EXPECT_TRUE(process.waitForFinished(120000));
  EXPECT_EQ(process.exitStatus(), QProcess::NormalExit) << arguments.join(' ').toStdString();
  return {process.exitCode(), QString::fromUtf8(process.readAllStandardOutput()),
          QString::fromUtf8(process.readAllStandardError())};
}

QString writeSimulated(const QTemporaryDir& folder, std::vector<EffectRequest> effects = {}, double seconds = 5.0) {
  Payload payload;
  payload.mass = 0.5;
  payload.com = {0, 0, 0.05};
  payload.inertiaCom = Vector3d(0.001, 0.001, 0.0006).asDiagonal();
  SimulateOptions options;
  options.duration = seconds;
  options.effects = std::move(effects);
  const auto simulated = simulate(RobotModel::panda(), payload, options);
  EXPECT_TRUE(simulated.ok());
  const QString path = folder.filePath("rec.csv");
  EXPECT_TRUE(writeRecording(simulated->recording, path.toStdString()).ok());
  return path;
}

TEST(Program, HelpAndVersionNeedNoDisplay) {
  const Outcome help = run({"--help"});
  EXPECT_EQ(help.code, 0);
  EXPECT_TRUE(help.out.contains("--offscreen"));
  EXPECT_TRUE(help.err.isEmpty()) << help.err.toStdString();
  const Outcome version = run({"--version"});
  EXPECT_EQ(version.code, 0);
  EXPECT_TRUE(version.out.startsWith("heft-studio " HEFT_VERSION "\nrevision ")) << version.out.toStdString();
}

TEST(Program, WrongUsageIsTwo) {
  EXPECT_EQ(run({"--no-such-option"}).code, 2);
  EXPECT_EQ(run({"--offscreen"}).code, 2);
  EXPECT_EQ(run({"--offscreen", "a.csv", "-o", "b.png", "--size", "big"}).code, 2);
  EXPECT_EQ(run({"a.csv", "-o", "b.png"}).code, 2);
  EXPECT_EQ(run({"--theme", "pink"}).code, 2);
}

TEST(Program, WithoutAScreenItSaysSo) {
  const Outcome outcome = run({});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_TRUE(outcome.err.contains("--offscreen")) << outcome.err.toStdString();
  EXPECT_EQ(outcome.err.trimmed().count('\n'), 0);
}

TEST(Program, WithoutXvfbItNamesThePackage) {
  const Outcome outcome = run({"--offscreen", "a.csv", "-o", "b.png"}, "/nonexistent");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_TRUE(outcome.err.contains("package xvfb")) << outcome.err.toStdString();
}

TEST(Program, OffscreenDrawsTheWindow) {
  QTemporaryDir folder;
  const QString recording = writeSimulated(folder);
  const QString picture = folder.filePath("window.png");
  const Outcome outcome =
      run({"--offscreen", recording, "-o", picture, "--size", "1280x800", "--theme", "dark", "--time", "2.5"});
  EXPECT_EQ(outcome.code, 0) << outcome.err.toStdString();
  const QImage image(picture);
  ASSERT_EQ(image.size(), QSize(1280, 800));
  // The left upper part is the 3D view: with only a background in it there are few colours.
  std::set<QRgb> colours;
  for (int y = 60; y < 380; ++y)
    for (int x = 20; x < 800; ++x) colours.insert(image.pixel(x, y));
  EXPECT_GT(colours.size(), 1500u);
}

TEST(Program, OffscreenWithABadFileIsOneSentence) {
  QTemporaryDir folder;
  const QString bad = folder.filePath("bad.csv");
  QFile file(bad);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("time,fx\n0,hello\n");
  file.close();
  const Outcome outcome = run({"--offscreen", bad, "-o", folder.filePath("x.png")});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_TRUE(outcome.err.contains("bad.csv")) << outcome.err.toStdString();
  EXPECT_EQ(outcome.err.trimmed().count('\n'), 0) << outcome.err.toStdString();
  EXPECT_FALSE(QFile::exists(folder.filePath("x.png")));
  EXPECT_EQ(run({"--offscreen", folder.filePath("none.csv"), "-o", folder.filePath("x.png")}).code, 1);
  EXPECT_EQ(run({"--offscreen", writeSimulated(folder), "-o", "/nonexistent/x.png"}).code, 1);
}

TEST(Program, AScriptGoesFromTheRecordingToThePayloadFile) {
  QTemporaryDir folder;
  const QString recording = writeSimulated(folder), payload = folder.filePath("tool.json"),
                session = folder.filePath("work.heft"), picture = folder.filePath("mark.png");
  QFile script(folder.filePath("walk.txt"));
  ASSERT_TRUE(script.open(QIODevice::WriteOnly));
  script.write(QStringLiteral("# from a recording to the payload file\n"
                              "open \"%1\"\nstep mark\nmark 1 1.5 ignore\npicture \"%2\"\nundo\naccept\n"
                              "step result\ntheme dark\nsize 1280x800\nlanguage de\nstep export\nclick roleOwnTool\n"
                              "export franka-desk \"%3\"\nsave \"%4\"\n")
                   .arg(recording, picture, payload, session)
                   .toUtf8());
  script.close();
  const Outcome outcome = run({"--offscreen", "--script", script.fileName()});
  EXPECT_EQ(outcome.code, 0) << outcome.err.toStdString();
  QFile written(payload);
  ASSERT_TRUE(written.open(QIODevice::ReadOnly));
  EXPECT_TRUE(written.readAll().contains("\"mass\""));
  EXPECT_EQ(QImage(picture).size(), QSize(1440, 900));
  EXPECT_TRUE(QFile::exists(session));
  // The same again replaces nothing.
  const Outcome again = run({"--offscreen", "--script", script.fileName()});
  EXPECT_EQ(again.code, 1);
  EXPECT_TRUE(again.err.contains("walk.txt:")) << again.err.toStdString();
  EXPECT_TRUE(again.err.contains("exists") || again.err.contains("gibt es schon")) << again.err.toStdString();
}

TEST(Program, AScriptFindsACauseAppliesItAndWritesTheReport) {
  QTemporaryDir folder;
  const QString recording = writeSimulated(folder, {{"cable_pull", "", 6.0}}, 10.0);
  QFile script(folder.filePath("check.txt"));
  ASSERT_TRUE(script.open(QIODevice::WriteOnly));
  script.write(QStringLiteral("open \"%1\"\nstep reality-check\npicture \"%2/cards.png\"\nlook motion position_x\n"
                              "picture \"%2/motion.png\" window\nlook plots\napply cable_pull\nmanual\n"
                              "picture \"%2/manual.png\" panel\nmanual\nreport \"%2/r.html\"\nreport \"%2/r.pdf\"\n"
                              "step export\nclick roleOwnTool\nexport franka-desk \"%2/tool.json\"\n")
                   .arg(recording, folder.path())
                   .toUtf8());
  script.close();
  const Outcome outcome = run({"--offscreen", "--script", script.fileName()});
  EXPECT_EQ(outcome.code, 0) << outcome.err.toStdString();
  QFile report(folder.filePath("r.html"));
  ASSERT_TRUE(report.open(QIODevice::ReadOnly));
  EXPECT_TRUE(report.readAll().contains("(applied)"));
  EXPECT_TRUE(QFile::exists(folder.filePath("r.pdf")));
  EXPECT_TRUE(QFile::exists(folder.filePath("tool.json")));
  const QImage cards(folder.filePath("cards.png")), motion(folder.filePath("motion.png")),
      manual(folder.filePath("manual.png"));
  EXPECT_EQ(cards.size(), QSize(1440, 900));
  EXPECT_NE(cards, motion);
  std::set<QRgb> colours;
  for (int y = 0; y < manual.height(); ++y)
    for (int x = 0; x < manual.width(); ++x) colours.insert(manual.pixel(x, y));
  EXPECT_GT(colours.size(), 60u) << "the manual has text and a picture of the window";
}

TEST(Program, AScriptThatIsWrongNamesTheLine) {
  QTemporaryDir folder;
  QFile script(folder.filePath("walk.txt"));
  ASSERT_TRUE(script.open(QIODevice::WriteOnly));
  script.write("step record\ndance\n");
  script.close();
  const Outcome outcome = run({"--offscreen", "--script", script.fileName()});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_TRUE(outcome.err.contains("walk.txt:2:")) << outcome.err.toStdString();
  EXPECT_EQ(run({"--script", script.fileName()}).code, 2);
  EXPECT_EQ(run({"--offscreen", "--script", folder.filePath("none.txt")}).code, 1);
}

}  // namespace
}  // namespace heft
