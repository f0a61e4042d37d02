// Proof and passport at the end of the step Export.
#include <gtest/gtest.h>

#include <QFile>
#include <QLabel>
#include <QTemporaryDir>
#include <QTest>
#include <nlohmann/json.hpp>

#include "core/base/json_file.h"
#include "core/base/said_again.h"
#include "core/base/say.h"
#include "core/compensation/passport_page.h"
#include "core/recording/csv_reader.h"
#include "core/robot/robot_model.h"
#include "core/simulation/simulate.h"
#include "tests/ui/fixtures.h"
#include "ui/controller/workspace.h"
#include "ui/export_panel/export_panel.h"
#include "ui/models/proof_text.h"
#include "ui/report/paper.h"
#include "ui/report/passport_files.h"
#include "ui/report/session_report.h"

namespace heft {
namespace {

using nlohmann::json;

class ProofCardTest : public testing::Test {
 protected:
  ProofCardTest() {
    parts.workspace = &workspace;
    parts.followJobs = [this](JobRunner* runner) { jobs = runner; };
    parts.say = [this](Severity, const QString& text) { said = text; };
    panel = std::make_unique<ExportPanel>(parts);
    panel->resize(440, 900);
    panel->show();
    right = written("right.csv", 0.8, 5);
    wrong = written("wrong.csv", 0.9, 6);
    workspace.open(written("rec.csv", 0.8, 4));
    settle();
    EXPECT_TRUE(workspace.report());
  }
  QString written(const QString& name, double mass, unsigned seed) {
    Payload payload;
    payload.mass = mass;
    payload.com = {0.005, -0.01, 0.06};
    payload.inertiaCom = mass / 0.8 * Matrix3d(Vector3d(0.0021, 0.0019, 0.0012).asDiagonal());
    SimulateOptions options;
    options.motion = MotionKind::free;
    options.duration = 10.0;
    options.rateHz = 250.0;
    options.seed = seed;
    auto simulated = simulate(RobotModel::panda(), payload, options);
    EXPECT_TRUE(simulated.ok());
    const QString path = folder.filePath(name);
    EXPECT_TRUE(writeRecording(simulated->recording, path.toStdString()).ok());
    return path;
  }
  void settle() {
    ASSERT_TRUE(QTest::qWaitFor([&] { return !workspace.busy() && !jobs->running(); }, 60000));
  }
  Result<bool> tell(const QStringList& words) {
    const auto obeyed = panel->obey(words);
    EXPECT_TRUE(obeyed) << words.join(' ').toStdString();
    settle();
    return obeyed ? *obeyed : Result<bool>(Error{"not its verb"});
  }
  QString texts() {
    QString all;
    for (const QLabel* label : panel->findChildren<QLabel*>())
      if (!label->isHidden()) all += label->text() + "\n";
    return all;
  }
  QString fromFile(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
  }

  QTemporaryDir folder;
  QString right, wrong, said;
  Workspace workspace;
  JobRunner* jobs = nullptr;
  StudioParts parts;
  std::unique_ptr<ExportPanel> panel;
};

TEST_F(ProofCardTest, ARightPayloadPassesAndIsKept) {
  EXPECT_TRUE(texts().contains("guide the tool in all directions"));
  ASSERT_TRUE(tell({"prove", right}));
  EXPECT_TRUE(texts().contains("PASS")) << texts().toStdString();
  EXPECT_TRUE(texts().contains("Checked on right.csv"));
  // In the session, and in the report on paper.
  const QString session = folder.filePath("work.heft");
  ASSERT_TRUE(workspace.save(session));
  EXPECT_EQ(json::parse(fromFile(session).toStdString())["proof"]["verdict"], "pass");
  const QString report = folder.filePath("report.html");
  ASSERT_TRUE(writeSessionReport({&workspace, nullptr, {}}, report, false));
  EXPECT_TRUE(fromFile(report).contains("PASS"));
  workspace.startAfresh();
  EXPECT_TRUE(workspace.session().proof.empty());
  workspace.open(session);
  settle();
  EXPECT_TRUE(texts().contains("PASS"));
  EXPECT_FALSE(texts().contains("have changed since"));
}

TEST_F(ProofCardTest, AnotherPayloadDoesNotPassAndTheReasonIsSaid) {
  ASSERT_TRUE(tell({"prove", wrong}));
  EXPECT_TRUE(texts().contains("NOT YET")) << texts().toStdString();
  EXPECT_TRUE(texts().contains("The entered mass of")) << texts().toStdString();
}

/// Found in English, kept in a session, shown in German: the reasons are said as if found in German.
TEST_F(ProofCardTest, ReasonsAreSaidInTheLanguageOfNow) {
  rememberSentences(1000);
  ASSERT_TRUE(tell({"prove", wrong}));
  EXPECT_TRUE(texts().contains("The entered mass of 0.")) << texts().toStdString();
  const QString session = folder.filePath("english.heft");
  ASSERT_TRUE(workspace.save(session));
  rememberSentences(0);  // Another start of the program
  setTranslator(
      [](const char* pattern) -> std::string {
        return std::string(pattern).starts_with("The entered mass of")
                   ? "Die eingetragene Masse von {:.3f} kg ist um {:+.3f} kg falsch; erlaubt sind {:.3f} kg."
                   : "";
      },
      ',');
  workspace.startAfresh();
  workspace.open(session);
  settle();
  EXPECT_TRUE(texts().contains("Die eingetragene Masse von 0,")) << texts().toStdString();
  EXPECT_FALSE(texts().contains("The entered mass"));
  setTranslator({});
}

TEST_F(ProofCardTest, OtherNumbersNeedAnotherProof) {
  ASSERT_TRUE(tell({"prove", right}));
  EstimateSettings settings = workspace.session().settings;
  settings.trim = 0.3;
  workspace.setSettings(settings, "trim");
  settle();
  EXPECT_TRUE(texts().contains("The numbers have changed since; prove them again."));
}

TEST_F(ProofCardTest, NumbersAreNotProvedOnTheRecordingThatTheyComeFrom) {
  EXPECT_FALSE(tell({"prove", folder.filePath("rec.csv")}));
  EXPECT_FALSE(tell({"prove", "live"}));
  EXPECT_FALSE(panel->obey({"prove"})) << "has none of its forms";
  EXPECT_TRUE(workspace.session().proof.empty());
  ASSERT_TRUE(tell({"prove", folder.filePath("none.csv")}));
  EXPECT_TRUE(said.contains("none.csv")) << said.toStdString();
}

TEST_F(ProofCardTest, APassportIsOneSheetAndTheNextOneSaysWhatChanged) {
  ASSERT_TRUE(tell({"prove", right}));
  const QString first = folder.filePath("gripper-1.pdf"), firstJson = folder.filePath("gripper-1.json");
  ASSERT_TRUE(tell({"passport", first, "tool", "Gripper 3"}));
  EXPECT_TRUE(fromFile(first).startsWith("%PDF"));
  const json passport = json::parse(fromFile(firstJson).toStdString());
  EXPECT_EQ(passport["schema"], "heft.passport/1");
  EXPECT_EQ(passport["tool"], "Gripper 3");
  EXPECT_EQ(passport["proof"]["verdict"], "pass");
  EXPECT_TRUE(passport["since"].is_null());
  EXPECT_FALSE(tell({"passport", first, "tool", "Gripper 3"})) << "nothing is replaced silently";
  EXPECT_EQ(newestPassport(folder.path(), "Gripper 3", {}), firstJson);
  EXPECT_TRUE(newestPassport(folder.path(), "Gripper 3", firstJson).isEmpty());
  EXPECT_TRUE(newestPassport(folder.path(), "Camera", {}).isEmpty());

  workspace.open(wrong);
  settle();
  EXPECT_FALSE(tell({"passport", folder.filePath("x.pdf"), "tool", "Camera", "since", firstJson}));
  EXPECT_FALSE(QFile::exists(folder.filePath("x.json")));
  ASSERT_TRUE(tell({"passport", folder.filePath("gripper-2"), "tool", "Gripper 3", "since", firstJson}));
  const json second = json::parse(fromFile(folder.filePath("gripper-2.json")).toStdString());
  EXPECT_TRUE(second["since"]["mass_and_centre_changed"]);
  EXPECT_TRUE(second["since"]["numbers"][0]["more_than_chance"]);
  EXPECT_TRUE(second["proof"].is_null()) << "a proof of other numbers is none of these";
  const QString html = QString::fromStdString(passportPage(second));
  EXPECT_TRUE(html.contains("The tool has changed: the difference exceeds the measurement uncertainty."));
  EXPECT_EQ(paper::sheets(html), 1);
}

TEST(ProofText, DamagedSessionsNeverCrash) {
  const std::string good =
      R"({"schema":"heft.prove/1","verdict":"not_yet","reasons":[{"text":"a","remedy":"b"}],"left_rms":{"force_n":[1,2,3]}})";
  const auto text = describeProof(good, nullptr);
  ASSERT_TRUE(text);
  EXPECT_FALSE(text->passed);
  EXPECT_EQ(text->reasons.front().remedy, "b");
  unsigned state = 12345;
  const auto next = [&] { return state = state * 1664525u + 1013904223u; };
  for (int trial = 0; trial < 2000; ++trial) {
    std::string damaged = good;
    for (int k = 0; k < 3; ++k) damaged[next() % damaged.size()] = static_cast<char>(next() % 256);
    (void)describeProof(damaged, nullptr);
  }
  for (const char* none : {"", "[]", "3", R"({"schema":"heft.estimate/1"})"})
    EXPECT_FALSE(describeProof(none, nullptr));
}

}  // namespace
}  // namespace heft
