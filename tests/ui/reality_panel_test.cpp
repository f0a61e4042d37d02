#include <gtest/gtest.h>

#include <QApplication>
#include <QFile>
#include <QFileInfo>
#include <QFrame>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QVBoxLayout>
#include <cmath>

#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/report/report.h"
#include "core/recording/csv_reader.h"
#include "core/robot/robot_model.h"
#include "core/simulation/practice.h"
#include "core/simulation/simulate.h"
#include "tests/support/as_driver.h"
#include "tests/ui/fixtures.h"
#include "ui/charts/chart.h"
#include "ui/controller/workspace.h"
#include "ui/reality_cards/cause_card.h"
#include "ui/reality_cards/cause_words.h"
#include "ui/reality_cards/reality_page.h"
#include "ui/reality_panel/difference_pane.h"
#include "ui/reality_panel/difference_traces.h"
#include "ui/reality_panel/practice.h"
#include "ui/reality_panel/reality_panel.h"

// After ui/controller/diagnosis.h, which lets Qt's keyword "signals" be an ordinary word.
#include "core/diagnosis/causes/catalogue.h"
#include "core/diagnosis/wording/words.h"

namespace heft {
namespace {

constexpr int kLong = 120000;  // [ms]

class RealityPanelTest : public testing::Test {
 protected:
  RealityPanelTest() {
    QStandardPaths::setTestModeEnabled(true);
    parts.workspace = &workspace;
    parts.followJobs = [this](JobRunner* runner) { jobs = runner; };
    parts.say = [this](Severity, const QString& text) { said = text; };
    panel = std::make_unique<RealityPanel>(parts);
    panel->resize(440, 900);
    panel->show();
  }
  QString simulated(const char* name, std::vector<EffectRequest> effects, std::uint64_t seed = 5) {
    Payload payload;
    payload.mass = 0.8;
    payload.com = {0.005, -0.01, 0.06};
    payload.inertiaCom = Vector3d(0.0021, 0.0019, 0.0012).asDiagonal();
    SimulateOptions options;
    options.duration = 10.0;
    options.rateHz = 500.0;
    options.seed = seed;
    options.effects = std::move(effects);
    const auto made = simulate(RobotModel::panda(), payload, options);
    EXPECT_TRUE(made.ok());
    const QString path = folder.filePath(name);
    EXPECT_TRUE(writeRecording(made->recording, path.toStdString()).ok());
    return path;
  }
  /// Written as the named driver would have it.
  QString asDriver(const char* name, const char* driver, Recording recording) {
    test::rewriteAs(driver, RobotModel::panda(), 3, recording);
    const QString path = folder.filePath(name);
    EXPECT_TRUE(writeRecording(recording, path.toStdString()).ok());
    return path;
  }
  void open(const QString& path) {
    workspace.open(path);
    settle();
    ASSERT_TRUE(workspace.report());
  }
  /// Estimates and searches have come to rest, and the page shows it.
  void settle() {
    ASSERT_TRUE(QTest::qWaitFor([&] { return !workspace.busy() && !jobs->running(); }, kLong));
    QApplication::processEvents();
  }
  QStringList texts() const {
    QStringList out;
    for (const QLabel* label : panel->findChildren<QLabel*>()) out << label->text();
    return out;
  }
  QPushButton* buttonOf(const char* name, const char* cause) {
    for (auto* button : panel->findChildren<QPushButton*>(name))
      if (button->property("cause").toString() == cause) return button;
    return nullptr;
  }

  QTemporaryDir folder;
  Workspace workspace;
  StudioParts parts;
  JobRunner* jobs = nullptr;
  QString said;
  std::unique_ptr<RealityPanel> panel;
};

TEST_F(RealityPanelTest, OtherConventionsComeFirstAndAreReadWithOneClick) {
  auto read = readRecording(simulated("plain.csv", {}).toStdString());
  ASSERT_TRUE(read.ok());
  open(asDriver("base.csv", "base_axes", std::move(read->recording)));
  EXPECT_EQ(workspace.report()->trust, Trust::none);
  panel->diagnose();
  settle();
  ASSERT_TRUE(panel->report());
  QFrame* card = nullptr;
  for (auto* frame : panel->findChildren<QFrame*>())
    if (frame->property("role") == "reading" && frame->property("cause").isValid()) card = frame;
  ASSERT_NE(card, nullptr) << texts().join("|").toStdString();
  EXPECT_TRUE(texts().join("|").contains("given in the robot’s base axes")) << texts().join("\n").toStdString();
  EXPECT_TRUE(texts().join("|").contains("Check in the driver:"));
  const auto* chart = card->findChild<ChartWidget*>();
  ASSERT_NE(chart, nullptr);
  ASSERT_EQ(chart->chart().curves.size(), 2u);
  const auto sizeOf = [](const ChartCurve& curve) {
    double sum = 0.0;
    for (const QPointF& point : curve.points) sum += point.y() * point.y();
    return std::sqrt(sum);
  };
  EXPECT_LT(10.0 * sizeOf(chart->chart().curves[1]), sizeOf(chart->chart().curves[0]));
  QPushButton* readSo = buttonOf("mainButton", "frame_error");
  ASSERT_NE(readSo, nullptr);
  EXPECT_EQ(readSo->text(), "Use these conventions");
  QTest::mouseClick(readSo, Qt::LeftButton);
  settle();
  EXPECT_EQ(workspace.report()->trust, Trust::good);
  EXPECT_NEAR(workspace.report()->payload.mass, 0.8, 0.01);
  EXPECT_NE(workspace.corrections().found.find("\"wrench_axes\":\"base\""), std::string::npos)
      << "the session holds the meta keys";
  workspace.undoStack()->undo();
  settle();
  EXPECT_EQ(workspace.report()->trust, Trust::none);
  EXPECT_TRUE(workspace.corrections().causes.empty());
}

TEST_F(RealityPanelTest, StandingPosesAreDiagnosedToo) {
  Payload payload;
  payload.mass = 1.2;
  payload.com = {0.01, -0.02, 0.07};
  payload.inertiaCom = Vector3d(0.002, 0.002, 0.001).asDiagonal();
  open(asDriver("poses.csv", "base_axes", test::standingRecording(payload, 24, {0.0, 0.0, -9.81}, 1.0, 5)));
  panel->diagnose();
  settle();
  ASSERT_TRUE(panel->report()) << texts().join("|").toStdString();
  EXPECT_TRUE(texts().join("|").contains("base axes")) << texts().join("|").toStdString();
  QPushButton* readSo = buttonOf("mainButton", "frame_error");
  ASSERT_NE(readSo, nullptr);
  QTest::mouseClick(readSo, Qt::LeftButton);
  settle();
  EXPECT_NEAR(workspace.report()->payload.mass, 1.2, 0.05);
}

TEST_F(RealityPanelTest, ACauseIsNamedAppliedUndoneAndSaved) {
  EXPECT_EQ(panel->state().progress, StepState::Progress::later);
  open(simulated("hose.csv", {{"cable_pull", "", 4.0}}));
  panel->diagnose();
  EXPECT_TRUE(jobs->running());
  settle();
  ASSERT_TRUE(panel->report());
  ASSERT_EQ(panel->report()->verdict, Verdict::explained) << panel->report()->sentence;
  EXPECT_TRUE(texts().join("|").contains("pulls the tool towards one point")) << texts().join("|").toStdString();
  EXPECT_EQ(panel->state().light, Light::look);
  const double plain = workspace.report()->payload.mass;
  QPushButton* apply = buttonOf("mainButton", "cable_pull");
  ASSERT_NE(apply, nullptr);
  QTest::mouseClick(apply, Qt::LeftButton);
  settle();
  EXPECT_EQ(workspace.corrections().causes, std::vector<std::string>{"cable_pull"});
  const double with = workspace.report()->payload.mass;
  EXPECT_LT(std::abs(with - 0.8), std::abs(plain - 0.8));
  EXPECT_NEAR(with, panel->report()->after.payload.mass, 1e-9);
  EXPECT_EQ(panel->state().light, Light::measured);

  const QString file = folder.filePath("s.heft");
  ASSERT_TRUE(workspace.save(file));
  workspace.undoStack()->undo();
  settle();
  EXPECT_TRUE(workspace.corrections().causes.empty());
  EXPECT_NEAR(workspace.report()->payload.mass, plain, 1e-12);
  workspace.undoStack()->redo();
  settle();
  QPushButton* back = buttonOf("plainButton", "cable_pull");
  ASSERT_NE(back, nullptr) << "an applied cause can be taken back";
  QTest::mouseClick(back, Qt::LeftButton);
  settle();
  EXPECT_TRUE(workspace.corrections().causes.empty());

  Workspace other;
  other.open(file);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !other.busy() && other.report(); }, kLong));
  EXPECT_NEAR(other.report()->payload.mass, with, 1e-9);
}

TEST_F(RealityPanelTest, ACleanRecordingIsSaidToFitAndTheNextStepIsExport) {
  open(simulated("clean.csv", {}));
  panel->diagnose();
  settle();
  ASSERT_TRUE(panel->report());
  EXPECT_EQ(panel->report()->verdict, Verdict::clean);
  EXPECT_TRUE(texts().contains("The remaining error is sensor noise."));
  EXPECT_EQ(panel->state().progress, StepState::Progress::done);
  const auto mains = panel->findChildren<QPushButton*>("mainButton");
  ASSERT_EQ(mains.size(), 1);
  EXPECT_EQ(mains[0]->text(), "Continue to Export");
  const auto refused = panel->obey({"apply", "cable_pull"});
  ASSERT_TRUE(refused.has_value());
  EXPECT_FALSE(refused->ok());
}

TEST_F(RealityPanelTest, ASearchSaysWhatItDoesAndHowLongItHasTaken) {
  open(simulated("long.csv", {}));
  panel->diagnose();
  const auto stage = [&] {
    const auto* label = panel->findChild<QLabel*>("searchStage");
    return label ? label->text() : QString();
  };
  EXPECT_TRUE(stage().contains("0 s")) << stage().toStdString();
  // An idle machine may be done before the next look at the clock, so no later stage is asked for.
  jobs->cancel();
  settle();
}

TEST_F(RealityPanelTest, StopsWhenAsked) {
  panel->hide();  // Shown, it would look by itself as soon as a recording is there.
  open(simulated("late.csv", {{"time_offset", "", 15.0}}));
  ASSERT_FALSE(panel->report());
  panel->show();
  panel->diagnose();
  for (auto* button : panel->findChildren<QPushButton*>("secondButton"))
    if (button->isVisible()) QTest::mouseClick(button, Qt::LeftButton);
  settle();
  EXPECT_FALSE(panel->report());
  EXPECT_TRUE(texts().contains("The search was stopped."));
}

// Each of two readings has its weight, and neither is taken by one click.
TEST_F(RealityPanelTest, OfReadingsThatFitAlikeAPersonStatesOne) {
  auto read = readRecording(simulated("plain.csv", {}).toStdString());
  ASSERT_TRUE(read.ok());
  open(asDriver("kgf.csv", "kgf_cm", std::move(read->recording)));
  panel->diagnose();
  settle();
  ASSERT_TRUE(panel->report() && panel->report()->mistake);
  EXPECT_TRUE(panel->report()->mistake->tied);
  const QString all = texts().join("|");
  EXPECT_TRUE(all.contains("(0.80 kg)")) << all.toStdString();
  EXPECT_TRUE(all.contains("Heft does not guess")) << all.toStdString();
  const QPushButton* stateIt = buttonOf("mainButton", "frame_error");
  ASSERT_NE(stateIt, nullptr);
  EXPECT_EQ(stateIt->text(), "Set it in Robot and sensor …");
  EXPECT_EQ(buttonOf("acceptButton", "frame_error"), nullptr);
  EXPECT_FALSE(all.contains("your result changes"));
}

TEST_F(RealityPanelTest, AWrongSignAsksForAnotherMetaFileAndNothingIsReplacedSilently) {
  const QString path = simulated("sign.csv", {{"frame_error", "wrench-sign", 1.0}});
  open(path);
  panel->diagnose();
  settle();
  ASSERT_TRUE(panel->report());
  ASSERT_TRUE(panel->report()->mistake) << panel->report()->sentence;
  const QString file = folder.filePath("better.meta.json");
  const auto written = panel->obey({"meta", file});
  ASSERT_TRUE(written && written->ok()) << (written ? written->error().message : "");
  QFile meta(file);
  ASSERT_TRUE(meta.open(QIODevice::ReadOnly));
  EXPECT_TRUE(meta.readAll().contains("payload_on_sensor"));
  EXPECT_FALSE(panel->obey({"meta", file})->ok());
  EXPECT_TRUE(panel->obey({"meta", file, "replace"})->ok());
}

TEST_F(RealityPanelTest, APracticeRecordingHidesItsFaultUntilAGuess) {
  std::uint64_t seed = 1;
  while (practiceEffect(seed).id != "time_offset") ++seed;
  ASSERT_TRUE(panel->obey({"practice", QString::number(seed)})->ok());
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return workspace.opened() && workspace.report() && !workspace.busy() && !jobs->running(); }, kLong));
  QApplication::processEvents();
  EXPECT_EQ(practiceSeed(workspace.opened()->path), seed);
  EXPECT_TRUE(texts().contains("What is wrong with this recording?"));
  EXPECT_FALSE(texts().join("|").contains("arrive"));
  // A hint does not name it, and one wrong guess is free.
  QTest::mouseClick(panel->findChild<QPushButton*>("hintWanted"), Qt::LeftButton);
  settle();
  EXPECT_TRUE(texts().contains(looksOf("time_offset")));
  EXPECT_FALSE(panel->findChild<QPushButton*>("giveUp"));
  // What it would be without the fault stands beside it: they differ by far more than noise, and not everywhere.
  auto* traces = panel->ownPane()->findChild<DifferenceTraces*>();
  ASSERT_NE(traces, nullptr);
  EXPECT_TRUE(traces->curves().clean.isEmpty());
  QTest::mouseClick(panel->findChild<QPushButton*>("showTwin"), Qt::LeftButton);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !traces->curves().clean.isEmpty(); }, kLong));
  settle();
  const DifferenceCurves& curves = traces->curves();
  ASSERT_EQ(curves.clean.size(), curves.time.size());
  double most = 0.0, least = 1e9;
  for (int n = 0; n < curves.time.size(); ++n) {
    most = std::max(most, std::abs(curves.value(6, n)));
    least = std::min(least, std::abs(curves.value(6, n)));
  }
  EXPECT_GT(most, 3.0 * curves.noise);
  EXPECT_LT(least, curves.noise);
  EXPECT_EQ(panel->findChild<QPushButton*>("showTwin")->text(), "Hide the clean twin");
  QTest::mouseClick(panel->findChild<QPushButton*>("showTwin"), Qt::LeftButton);
  settle();
  EXPECT_TRUE(traces->curves().clean.isEmpty());
  QTest::mouseClick(panel->findChild<QPushButton*>("guess_cable_pull"), Qt::LeftButton);
  settle();
  EXPECT_FALSE(texts().join("|").contains("Hidden was"));
  EXPECT_FALSE(panel->findChild<QPushButton*>("guess_cable_pull")->isEnabled());
  QTest::mouseClick(panel->findChild<QPushButton*>("giveUp"), Qt::LeftButton);
  settle();
  EXPECT_TRUE(texts().contains("Not quite"));
  EXPECT_TRUE(texts().contains("Solved at the first try: 0 of 1. With a hint or at the second try: 0."));
  EXPECT_TRUE(texts().join("|").contains("The hidden fault was: Force readings late (delay)"));
  // Opened once more it is a riddle again.
  ASSERT_TRUE(panel->obey({"practice", QString::number(seed)})->ok());
  settle();
  ASSERT_TRUE(QTest::qWaitFor([&] { return panel->findChild<QPushButton*>("guess_time_offset") != nullptr; }, kLong));
  settle();
  QTest::mouseClick(panel->findChild<QPushButton*>("guess_time_offset"), Qt::LeftButton);
  settle();
  EXPECT_TRUE(texts().contains("Right"));
  EXPECT_TRUE(texts().contains("Solved at the first try: 1 of 2. With a hint or at the second try: 0."));
}

TEST_F(RealityPanelTest, TheReportHoldsEverythingAsPageAndAsPdf) {
  EXPECT_FALSE(panel->obey({"report", folder.filePath("none.html")})->ok());
  open(simulated("hose.csv", {{"cable_pull", "", 4.0}}));
  panel->diagnose();
  settle();
  const QString page = folder.filePath("r.html"), pdf = folder.filePath("r.pdf");
  ASSERT_TRUE(panel->obey({"report", page})->ok());
  ASSERT_TRUE(panel->obey({"report", pdf})->ok());
  QFile html(page), paper(pdf);
  ASSERT_TRUE(html.open(QIODevice::ReadOnly) && paper.open(QIODevice::ReadOnly));
  const QByteArray text = html.readAll();
  EXPECT_TRUE(text.contains("hose.csv"));
  EXPECT_TRUE(text.contains("Cable or hose pulls"));
  EXPECT_GE(text.count("data:image/png;base64,"), 6);
  EXPECT_TRUE(text.contains("<br>")) << "a line for each principal moment";
  EXPECT_FALSE(text.contains("http://") || text.contains("https://"));
  const QByteArray start = paper.readAll();
  EXPECT_TRUE(start.startsWith("%PDF"));
  EXPECT_GT(start.size(), 40000) << "pictures are in it";
  EXPECT_FALSE(panel->obey({"report", page})->ok()) << "nothing is replaced silently";
  EXPECT_FALSE(panel->obey({"report", folder.filePath("r.doc")})->ok());
}

TEST_F(RealityPanelTest, TheDifferenceIsLookedAtFromThreeSides) {
  open(simulated("hose.csv", {{"cable_pull", "", 4.0}}));
  panel->diagnose();
  settle();
  auto* pane = panel->ownPane()->findChild<DifferencePane*>();
  EXPECT_EQ(panel->below(), StepPanel::Below::own) << "without a click";
  EXPECT_GT(pane->traces()->curves().time.size(), 100);
  EXPECT_NEAR(pane->traces()->curves().noise, 2.0 * panel->report()->noise.force, 1e-12);
  ASSERT_TRUE(panel->obey({"look", "motion", "position_x"})->ok());
  ASSERT_EQ(pane->charts().size(), 2u);
  EXPECT_EQ(pane->charts()[0].yHigh, pane->charts()[1].yHigh) << "one scale for without and with";
  EXPECT_GT(pane->charts()[0].curves[0].points.size(), 50);
  ASSERT_TRUE(panel->obey({"look", "frequency"})->ok());
  EXPECT_GT(pane->charts()[0].floor.size(), 10);
  EXPECT_FALSE(panel->obey({"look", "motion", "colour"})->ok());
  ASSERT_TRUE(panel->obey({"look", "plots"})->ok());
  EXPECT_EQ(panel->below(), StepPanel::Below::plots);
}

TEST_F(RealityPanelTest, ChecksOnAnotherOpenRecording) {
  open(simulated("b.csv", {{"time_offset", "", 15.0}}, 6));
  open(simulated("a.csv", {{"time_offset", "", 15.0}}, 7));
  panel->diagnose();
  settle();
  ASSERT_TRUE(panel->obey({"check", folder.filePath("b.csv")})->ok());
  settle();
  ASSERT_TRUE(panel->report()->check);
  EXPECT_LT(panel->report()->check->after.torque, panel->report()->check->before.torque);
  EXPECT_FALSE(panel->obey({"check", folder.filePath("c.csv")})->ok());
}

TEST(CauseWords, EveryCauseHasAllItsWords) {
  std::vector<std::string> ids{"contact", "saturation", "spikes", "dropouts", "frame_error"};
  for (const std::string& id : causeIds()) ids.push_back(id);
  for (const auto& id : ids) {
    if (id == diagnosis::ids::wandering) continue;
    EXPECT_NE(titleOf(id), QString::fromStdString(id));
    EXPECT_FALSE(checkOf(id).isEmpty()) << id;
    EXPECT_FALSE(decidesOf(id).isEmpty()) << id;
    EXPECT_FALSE(looksOf(id).isEmpty()) << id;
  }
  for (const auto& id : practiceKinds()) EXPECT_FALSE(looksOf(id).isEmpty()) << id;
}

TEST(CauseWords, NumbersStandInTheSentence) {
  DiagnosisReport report;
  DiagnosedCause late;
  late.id = "time_offset";
  late.parameters = {{"delay", "ms", 8.13, 0.9}};
  EXPECT_EQ(sentenceOf(late, report), "The force readings arrive 8.1 ± 1.8 ms late.");
  late.parameters[0].value = -8.13;
  EXPECT_TRUE(sentenceOf(late, report).contains("after the force readings")) << sentenceOf(late, report).toStdString();
  DiagnosedCause cross;
  cross.id = "crosstalk";
  cross.parameters = {{"fx_to_ty", "%", 3.0, 0.2}};
  EXPECT_EQ(sentenceOf(cross, report), "3.0 ± 0.4 % of force x shows up in torque y.");
}

TEST(CauseCards, ATieShowsTheMotionThatDecidesAndLeadsToRecordingIt) {
  DiagnosisReport report;
  report.verdict = Verdict::ambiguous;
  DiagnosedCause cause;
  cause.id = "time_offset";
  cause.alternatives = {"low_pass_lag"};
  cause.parameters = {{"delay", "ms", 8.0, 1.0}};
  std::string shown, recorded;
  CardActions actions;
  actions.record = [&](const std::string& id) { recorded = id; };
  QWidget parent;
  {
    const std::unique_ptr<QWidget> without(makeTieCard(report, cause, {}, actions, &parent));
    EXPECT_EQ(without->findChild<QPushButton*>("showMotion"), nullptr) << "no arm that could show it";
  }
  actions.showMotion = [&](const std::string& id) { shown = id; };
  const std::unique_ptr<QWidget> card(makeTieCard(report, cause, {}, actions, &parent));
  QTest::mouseClick(card->findChild<QPushButton*>("showMotion"), Qt::LeftButton);
  EXPECT_EQ(shown, "time_offset");
  EXPECT_EQ(causeMotion(shown), "shake-sideways");
  QTest::mouseClick(card->findChild<QPushButton*>("recordIt"), Qt::LeftButton);
  EXPECT_EQ(recorded, "time_offset");
  cause.id = "gravity_tilt";  // Decided by a heavier tool, not by a motion.
  const std::unique_ptr<QWidget> heavier(makeTieCard(report, cause, {}, actions, &parent));
  EXPECT_EQ(heavier->findChild<QPushButton*>("showMotion"), nullptr);
  EXPECT_NE(heavier->findChild<QPushButton*>("recordIt"), nullptr);
}

TEST(CauseCards, ShowNoPayloadThatIsNotReliable) {
  DiagnosisReport report;
  report.verdict = Verdict::unexplained;
  report.causes.emplace_back();
  report.before.payload.mass = 0.3;
  report.before.std.mass = report.after.std.mass = 0.01;
  report.after.payload.mass = 0.1;
  const auto textOf = [&] {
    QWidget parent;
    addChange(new QVBoxLayout(&parent), &parent, report, 0);
    QString all;
    for (const QLabel* label : parent.findChildren<QLabel*>()) all += label->text() + "\n";
    return all;
  };
  EXPECT_TRUE(textOf().contains("0.1")) << textOf().toStdString();
  EXPECT_EQ(toText(report).find("(not reliable)"), std::string::npos);
  report.after.trust = Trust::none;
  report.after.whyNoTrust = "No rigid payload explains the readings.";
  EXPECT_FALSE(textOf().contains("0.1")) << textOf().toStdString();
  EXPECT_TRUE(textOf().contains("No rigid payload explains the readings."));
  EXPECT_NE(
      toText(report).find("0.1000 ± 0.0196 kg, centre of mass (0.0, 0.0, 0.0) mm (not reliable)\nNo rigid payload"),
      std::string::npos)
      << toText(report);
}

/// Where single readings tell what is wrong, the card of something unknown says that and what to do about it.
TEST(CauseCards, SayWhatSingleReadingsTellOfSomethingUnknown) {
  DiagnosisReport report;
  report.verdict = Verdict::unexplained;
  report.remaining.goesWith = "readings that stick at one value";
  const auto textOf = [&] {
    QWidget parent;
    QString all;
    for (const QLabel* label : makeUnknownCard(report, {}, &parent)->findChildren<QLabel*>())
      all += label->text() + "\n";
    return all;
  };
  EXPECT_TRUE(textOf().contains("record the same motion once more"));
  report.findings.push_back({Severity::warning, "dead_band", "fx reads exactly 0 N.", "Switch off the threshold.", {}});
  EXPECT_TRUE(textOf().contains("fx reads exactly 0 N."));
  EXPECT_TRUE(textOf().contains("Switch off the threshold."));
  EXPECT_FALSE(textOf().contains("record the same motion once more"));
}

/// A cause of the catalogue that was found at its usual size, in a recording whose every channel it explains.
DiagnosedCause foundAt(const diagnosis::Cause& cause, const diagnosis::Form* form, Eigen::Index blocks) {
  DiagnosedCause out;
  out.id = cause.id();
  out.direct = form == nullptr;
  out.deltaBic = 100.0;
  if (out.direct) return out;
  for (const auto& p : form->parameters) out.parameters.push_back({p.name, p.unit, p.size * p.scale, 0.01});
  out.when = {{1.0, 2.0}};
  out.before = out.after = diagnosis::Wrenches::Zero(6, blocks);
  for (Eigen::Index n = 0; n < blocks; ++n) out.before.col(n).setConstant(std::sin(0.1 * static_cast<double>(n)));
  return out;
}

/// Each cause has a card with its sentence and, where it was fitted, a picture of what it explains.
TEST(CauseCards, EachCauseHasAPicture) {
  constexpr Eigen::Index kBlocks = 500;
  DiagnosisReport report;
  report.series.time = VectorXd::LinSpaced(kBlocks, 0.0, 10.0);
  report.series.measured = report.series.before = report.series.after = diagnosis::Wrenches::Zero(6, kBlocks);
  report.series.judged.assign(static_cast<std::size_t>(kBlocks), true);
  const Recording recording = test::sineRecording(1001, 100);
  const auto motion = motionOf(recording, nullptr, {}).value();
  const diagnosis::Signals sensed = diagnosis::signalsOf(recording, motion, nullptr);
  int pictures = 0;
  for (const auto* list : {&diagnosis::catalogue(), &diagnosis::seenDirectly()})
    for (const auto& cause : *list) {
      if (cause->id() == diagnosis::kRandomWalk) continue;
      const auto forms = cause->forms(sensed);
      const auto form = std::ranges::find_if(forms, [](const auto& f) { return !f.guide; });
      const DiagnosedCause found = foundAt(*cause, form == forms.end() ? nullptr : &*form, kBlocks);
      QWidget parent;
      const QWidget* card = makeCauseCard(report, found, {}, {}, &parent);
      const auto* sentence = card->findChild<QLabel*>();
      EXPECT_NE(sentence, nullptr) << found.id;
      EXPECT_EQ(card->property("cause").toString().toStdString(), found.id);
      const auto* chart = card->findChild<ChartWidget*>();
      EXPECT_EQ(chart != nullptr, !found.direct) << found.id;
      if (chart == nullptr) continue;
      ++pictures;
      ASSERT_EQ(chart->chart().curves.size(), 2u) << found.id;
      const QImage with = chartImage(chart->chart(), {300, 122}, themeOf(ThemeKind::light));
      Chart without = chart->chart();
      for (ChartCurve& curve : without.curves) curve.points.clear();
      EXPECT_NE(with, chartImage(without, {300, 122}, themeOf(ThemeKind::light))) << found.id;
    }
  EXPECT_GT(pictures, 15);
}

/// What has no card is said below them; what the card of something unknown tells is not said twice.
TEST(RealityPage, SaysWhatElseWasNoticed) {
  DiagnosisReport report;
  report.verdict = Verdict::unexplained;
  report.findings.push_back({Severity::warning, "dead_band", "fx reads exactly 0 N.", "Switch off the threshold.", {}});
  report.findings.push_back({Severity::info, "motion_smoothed", "The motion was smoothed to 8 Hz.", {}, {}});
  const auto noticed = [&] {
    QWidget parent;
    auto* column = new QVBoxLayout(&parent);
    addNoticed(column, &parent, report);
    QStringList all;
    for (const QLabel* label : parent.findChildren<QLabel*>())
      if (label->property("role") == "noticed") all << label->text();
    return all;
  };
  EXPECT_EQ(noticed(), QStringList{"The motion was smoothed to 8 Hz."});
  report.verdict = Verdict::explained;
  EXPECT_EQ(noticed().size(), 2);
}

}  // namespace
}  // namespace heft
