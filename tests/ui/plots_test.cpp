#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>
#include <cmath>
#include <random>

#include "tests/ui/fixtures.h"
#include "ui/charts/chart.h"
#include "ui/timeline/marks_bar.h"
#include "ui/timeline/playback.h"
#include "ui/wrench_plots/channels.h"
#include "ui/wrench_plots/difference_cursor.h"
#include "ui/wrench_plots/min_max_pyramid.h"
#include "ui/wrench_plots/recording_pane.h"
#include "ui/wrench_plots/trace_raster.h"
#include "ui/wrench_plots/visible_csv.h"
#include "ui/wrench_plots/wrench_plots.h"
#include "ui/wrench_plots/wrench_traces.h"

namespace heft {
namespace {

TEST(MinMaxPyramid, AgreesWithPlainSearchOnEveryKindOfStretch) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  for (const std::size_t n : {1u, 15u, 16u, 33u, 64u, 1000u, 4097u}) {
    std::vector<double> values(n);
    for (double& v : values) v = normal(random);
    if (n > 20) values[17] = std::nan("");
    const MinMaxPyramid pyramid(values);
    std::uniform_int_distribution<std::size_t> place(0, n);
    for (int trial = 0; trial < 300; ++trial) {
      std::size_t from = place(random), to = place(random);
      if (from > to) std::swap(from, to);
      double lowest = std::nan(""), highest = std::nan("");
      for (std::size_t i = from; i < to; ++i) {
        lowest = std::fmin(lowest, values[i]);
        highest = std::fmax(highest, values[i]);
      }
      const MinMax found = pyramid.range(from, to);
      if (std::isnan(lowest)) {
        EXPECT_TRUE(std::isnan(found.lowest)) << n << " [" << from << ", " << to << ")";
      } else {
        EXPECT_EQ(found.lowest, static_cast<float>(lowest)) << n << " [" << from << ", " << to << ")";
        EXPECT_EQ(found.highest, static_cast<float>(highest)) << n << " [" << from << ", " << to << ")";
      }
    }
  }
}

/// An axis of velocities had a zero and no other number.
TEST(Charts, AxesHaveEnoughRoundNumbersToTellAScale) {
  EXPECT_EQ(ticksBetween(-0.52, 0.48, 4), (std::vector{-0.4, -0.2, 0.0, 0.2, 0.4}));
  EXPECT_EQ(ticksBetween(0.0, 20.0, 5), (std::vector{0.0, 5.0, 10.0, 15.0, 20.0}));
  EXPECT_TRUE(ticksBetween(1.0, 1.0, 5).empty());
  for (const int about : {2, 3, 5, 8})
    for (double low = -1.0; low < 1.0; low += 0.037)
      for (double span = 1e-3; span < 1e3; span *= 1.13) {
        const auto ticks = ticksBetween(low, low + span, about);
        EXPECT_LE(std::ssize(ticks), 2 * about + 1) << low << " " << span;
        EXPECT_GE(ticks.size(), about > 2 ? 3u : 2u) << low << " " << span << " " << about;
        EXPECT_GE(ticks.front(), low - 1e-9 * span);
        EXPECT_LE(ticks.back(), low + 1.001 * span);
      }
}

TEST(Channels, SpeedsAndAnglesAreThoseOfTheRecording) {
  Recording recording = test::sineRecording(4000, 500);  // Turns by t about z, and moves at sqrt(5) m/s.
  recording.q.resize(4000, 2);
  for (Eigen::Index n = 0; n < 4000; ++n) recording.q.row(n) << std::sin(recording.time(n)), 0.5;
  recording.extra = {{"current", {}}, {"words", {}}};
  for (int n = 0; n < 4000; ++n) {
    recording.extra[0].cells.push_back(n == 7 ? "nan" : std::to_string(2 * n));
    recording.extra[1].cells.push_back("go");
  }
  QStringList ids;
  for (const Channel& channel : channelsOf(recording)) ids << channel.id;
  for (const char* id : {"q1", "q2", "dq2", "pz", "yaw", "speed", "turning", "force", "torque", "column:current"})
    EXPECT_TRUE(ids.contains(id)) << id;
  EXPECT_FALSE(ids.contains("q3"));
  EXPECT_FALSE(ids.contains("column:words"));
  const double degrees = 180.0 / M_PI;
  const auto q = channelValues(recording, "q1"), dq = channelValues(recording, "dq1"),
             yaw = channelValues(recording, "yaw"), speed = channelValues(recording, "speed"),
             turning = channelValues(recording, "turning"), force = channelValues(recording, "force"),
             current = channelValues(recording, "column:current");
  for (const std::size_t n : {100u, 1700u, 3900u}) {
    const double t = recording.time(static_cast<Eigen::Index>(n));
    EXPECT_NEAR(q[n], degrees * std::sin(t), 1e-9);
    EXPECT_NEAR(dq[n], degrees * std::cos(t), 0.01);
    EXPECT_NEAR(yaw[n], degrees * t, 1e-6);  // On beyond half a turn
    EXPECT_NEAR(speed[n], 1e3 * std::sqrt(5.0), 1e-3);
    EXPECT_NEAR(turning[n], degrees, 1e-3);
    EXPECT_NEAR(force[n], recording.wrench.row(static_cast<Eigen::Index>(n)).head<3>().norm(), 1e-12);
    EXPECT_EQ(current[n], 2.0 * static_cast<double>(n));
  }
  EXPECT_TRUE(std::isnan(current[7]));
  EXPECT_TRUE(channelValues(recording, "q9").empty());
  // What was recorded is not computed.
  recording.dq = MatrixXd::Constant(4000, 2, 0.25);
  EXPECT_NEAR(channelValues(recording, "dq1")[1700], 0.25 * degrees, 1e-12);
}

/// Ready posture of a Panda: by its table of Denavit-Hartenberg parameters the flange is 307 mm ahead, 590 mm up.
TEST(Channels, TheJointsTellWhereTheSensorIs) {
  Recording recording;
  recording.time = VectorXd::LinSpaced(3, 0.0, 0.02);
  recording.q.resize(3, 7);
  for (Eigen::Index n = 0; n < 3; ++n)
    recording.q.row(n) << 0.0, -M_PI / 4, 0.0, -3 * M_PI / 4, 0.0, M_PI / 2, M_PI / 4;
  const Recording there = forwardPoses(recording, RobotModel::panda());
  EXPECT_NEAR(channelValues(there, "px")[1], 306.9, 0.1);
  EXPECT_NEAR(channelValues(there, "py")[1], 0.0, 0.1);
  EXPECT_NEAR(channelValues(there, "pz")[1], 590.3, 0.1);
  EXPECT_NEAR(std::abs(channelValues(there, "roll")[1]), 180.0, 0.01);  // Looks down
  EXPECT_NEAR(channelValues(there, "speed")[1], 0.0, 1e-6);
}

TEST(WrenchTraces, ThinningKeepsEverySpikeAndFewPoints) {
  Recording recording = test::sineRecording(200000, 1000);
  recording.wrench(123457, 1) = 99.0;
  const WrenchTraces traces(recording, nullptr);
  const ThinnedCurve curve = traces.thinned(WrenchTraces::Kind::measured, 1, 0, 200, 800);
  EXPECT_TRUE(curve.crowded);
  EXPECT_LE(curve.x.size(), 800);
  EXPECT_EQ(*std::max_element(curve.high.begin(), curve.high.end()), 99.0);
  EXPECT_EQ(*std::min_element(curve.low.begin(), curve.low.end()), 3.0);
  EXPECT_TRUE(std::is_sorted(curve.x.begin(), curve.x.end()));
}

TEST(WrenchTraces, FewSamplesAreDrawnAsTheyAre) {
  const Recording recording = test::sineRecording(100, 100);
  const WrenchTraces traces(recording, nullptr);
  const ThinnedCurve curve = traces.thinned(WrenchTraces::Kind::measured, 0, 0.2, 0.4, 800);
  EXPECT_FALSE(curve.crowded);
  ASSERT_GE(curve.x.size(), 21);
  EXPECT_LT(curve.x.front(), 0.2);  // One neighbour outside, so that the line reaches the edge.
  EXPECT_GT(curve.x.back(), 0.4);
  // Seven digits are kept.
  for (int i = 0; i < curve.x.size(); ++i) EXPECT_NEAR(curve.low[i], 10 * std::sin(2 * M_PI * curve.x[i]), 1e-6);
}

TEST(WrenchTraces, NothingJoinsWhatWasMeasuredBeforeAndAfterAGap) {
  Recording recording = test::sineRecording(4000, 1000);
  for (Eigen::Index i = 2000; i < 4000; ++i) recording.time(i) += 3.0;
  const WrenchTraces traces(recording, nullptr);
  for (const double zoom : {8.0, 0.01}) {
    const ThinnedCurve curve = traces.thinned(WrenchTraces::Kind::measured, 0, zoom > 1 ? 0.0 : 1.99,
                                              zoom > 1 ? 7.0 : 5.01, zoom > 1 ? 800 : 4000);
    EXPECT_EQ(curve.crowded, zoom > 1);
    int holes = 0;
    for (int i = 0; i < curve.x.size(); ++i) holes += std::isnan(curve.low[i]);
    EXPECT_EQ(holes, 1);
  }
}

/// Ink [px] of each column of a picture.
std::vector<double> inkOf(const TraceColumns& columns, int height, double thickness) {
  QImage picture(columns.width(), height, QImage::Format_ARGB32_Premultiplied);
  picture.fill(Qt::transparent);
  columns.paint(picture, Qt::black, thickness);
  std::vector<double> ink(static_cast<std::size_t>(picture.width()));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < picture.width(); ++x) ink[static_cast<std::size_t>(x)] += qAlpha(picture.pixel(x, y)) / 255.0;
  return ink;
}

TEST(TraceColumns, ALineIsAsThickAsItsPenWhateverItsSlope) {
  for (const double slope : {0.0, 0.3, 1.0, 4.0}) {
    TraceColumns columns(40);
    columns.addLine(0.0, 10.0, 40.0, 10.0 + 40 * slope);
    const std::vector<double> ink = inkOf(columns, 220, 1.5);
    // Cut upright, a line is thicker by its slope; a third of a pixel is nothing that one sees.
    for (int x = 5; x < 35; ++x)
      EXPECT_NEAR(ink[static_cast<std::size_t>(x)], 1.5 * std::hypot(1.0, slope), 0.1 + 0.33 * slope) << slope;
  }
}

TEST(TraceColumns, AStepIsSeenFromTopToBottomAndNotBeyond) {
  TraceColumns columns(20);
  columns.addLine(2.0, 20.0, 10.5, 20.0);
  columns.addLine(10.5, 20.0, 10.5, 80.0);
  columns.addLine(10.5, 80.0, 18.0, 80.0);
  const std::vector<double> ink = inkOf(columns, 100, 1.5);
  double upright = 0.0;
  for (int x = 9; x <= 11; ++x) upright += ink[static_cast<std::size_t>(x)];
  EXPECT_NEAR(upright, 1.5 * 60.0, 0.33 * 60.0);
  EXPECT_NEAR(ink[5], 1.5, 0.1);
  EXPECT_EQ(ink[0], 0.0);
  EXPECT_EQ(ink[19], 0.0);
}

TEST(TraceColumns, DashesKeepTheirShareAndPicturesTheirColour) {
  TraceColumns columns(400);
  columns.addLine(0.0, 5.0, 400.0, 5.0);
  columns.dash(6.0, 4.0);
  const std::vector<double> ink = inkOf(columns, 10, 1.0);
  double sum = 0.0;
  for (const double each : ink) sum += each;
  EXPECT_NEAR(sum, 0.6 * 400, 60) << "with round ends";
  EXPECT_GT(std::count(ink.begin(), ink.end(), 0.0), 60);
  TraceColumns bar(4);
  bar.addBar(0.0, 4.0, 2.0, 8.0);
  QImage picture(4, 10, QImage::Format_ARGB32_Premultiplied);
  picture.fill(Qt::transparent);
  bar.paint(picture, QColor(200, 40, 10, 128), 1.0);
  EXPECT_NEAR(picture.pixelColor(2, 5).red(), 200, 3);
  EXPECT_NEAR(picture.pixelColor(2, 5).alpha(), 128, 2);
  EXPECT_EQ(picture.pixelColor(2, 0).alpha(), 0);
}

TEST(WrenchTraces, DifferenceLaneIsScaledToFreeParts) {
  const Recording recording = test::sineRecording(4000, 1000);
  EstimateReport report = test::reportOn(recording);
  for (Eigen::Index i = 1600; i < 2000; ++i) report.series.simulated(i, 0) -= 50;  // The contact.
  const WrenchTraces traces(recording, &report);
  EXPECT_GT(traces.differenceLimit(0), 0.25);
  EXPECT_LT(traces.differenceLimit(0), 1.0);
  EXPECT_DOUBLE_EQ(traces.noiseBand(0), 0.1);
  EXPECT_DOUBLE_EQ(traces.noiseBand(3), 0.004);
}

TEST(WrenchTraces, StandingPosesAreCounted) {
  Recording recording = test::sineRecording(24, 1);
  recording.meta.kind = RecordingKind::poses;
  recording.time.setConstant(0);
  const WrenchTraces traces(recording, nullptr);
  EXPECT_EQ(traces.firstTime(), 1);
  EXPECT_EQ(traces.lastTime(), 24);
}

class PlotsTest : public testing::Test {
 protected:
  PlotsTest() : pane(&playback) {
    recording = test::sineRecording(10000, 1000);
    report = test::reportOn(recording);
    pane.resize(1000, 400);
    pane.show();
    pane.setRecording(std::make_shared<const Recording>(recording), std::make_shared<const EstimateReport>(report));
    pane.setSegments(report.segments, {});
    EXPECT_TRUE(QTest::qWaitFor([this] { return !pane.jobs()->running(); }, 60000));
    QApplication::processEvents();
  }
  QWidget* canvas() { return pane.plots()->findChild<QWidget*>(QString(), Qt::FindDirectChildrenOnly); }

  Recording recording;
  EstimateReport report;
  Playback playback;
  RecordingPane pane;
};

TEST_F(PlotsTest, ShowsTheWholeRecordingInAllLanes) {
  for (int lane = 0; lane < 4; ++lane) {
    EXPECT_NEAR(pane.plots()->laneTime(lane).lowest, 0, 1e-9);
    EXPECT_NEAR(pane.plots()->laneTime(lane).highest, 9.999, 1e-9);
  }
  EXPECT_LT(pane.plots()->laneRange(0).lowest, -10);
  EXPECT_GT(pane.plots()->laneRange(0).highest, 10);
  EXPECT_NEAR(pane.plots()->laneRange(1).highest, pane.plots()->laneRange(1).lowest * -1, 1e-12);
}

TEST_F(PlotsTest, AStretchThatIsSpokenOfIsFramedWithSomethingOnBothSides) {
  pane.highlight(4.0, 6.0, "held-out segment");
  EXPECT_NEAR(pane.timeAxis()->lower(), 3.2, 1e-9);
  EXPECT_NEAR(pane.timeAxis()->upper(), 6.8, 1e-9);
  QApplication::processEvents();
  const QImage framed = pane.plots()->grab().toImage();
  pane.highlight(0.0, 0.0, {});
  EXPECT_NEAR(pane.timeAxis()->lower(), 3.2, 1e-9) << "only the frame goes";
  QApplication::processEvents();
  EXPECT_NE(framed, pane.plots()->grab().toImage());
}

TEST_F(PlotsTest, WheelZoomsAllLanesAndMarksAboutThePointer) {
  const double before = pane.timeAxis()->span();
  const QPoint pointer(600, 60);
  const double under = pane.timeAxis()->toTime(pointer.x(), canvas()->width());
  QWheelEvent wheel(pointer, canvas()->mapToGlobal(pointer), QPoint(), QPoint(0, 240), Qt::NoButton, Qt::NoModifier,
                    Qt::NoScrollPhase, false);
  QApplication::sendEvent(canvas(), &wheel);
  EXPECT_NEAR(pane.timeAxis()->span(), before * 0.64, 0.02 * before);
  EXPECT_NEAR(pane.timeAxis()->toTime(pointer.x(), canvas()->width()), under, 1e-6);
  for (int lane = 1; lane < 4; ++lane) {
    EXPECT_EQ(pane.plots()->laneTime(lane).lowest, pane.plots()->laneTime(0).lowest);
    EXPECT_EQ(pane.plots()->laneTime(lane).highest, pane.plots()->laneTime(0).highest);
  }
}

TEST_F(PlotsTest, RubberBandZoomsAndDoubleClickShowsAll) {
  QTest::mousePress(canvas(), Qt::LeftButton, {}, {300, 50});
  QTest::mouseMove(canvas(), {350, 50});
  QMouseEvent move(QEvent::MouseMove, QPointF(500, 60), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(canvas(), &move);
  const double from = pane.timeAxis()->toTime(300, canvas()->width()),
               to = pane.timeAxis()->toTime(500, canvas()->width());
  QTest::mouseRelease(canvas(), Qt::LeftButton, {}, {500, 60});
  EXPECT_NEAR(pane.timeAxis()->lower(), from, 1e-6);
  EXPECT_NEAR(pane.timeAxis()->upper(), to, 1e-6);
  QTest::mouseDClick(canvas(), Qt::LeftButton, {}, {500, 60});
  EXPECT_TRUE(pane.timeAxis()->showsAll());
}

TEST_F(PlotsTest, MiddleButtonPansAndStopsAtTheEnd) {
  pane.timeAxis()->show(4, 6);
  QTest::mousePress(canvas(), Qt::MiddleButton, {}, {500, 50});
  QMouseEvent move(QEvent::MouseMove, QPointF(400, 50), Qt::NoButton, Qt::MiddleButton, Qt::NoModifier);
  QApplication::sendEvent(canvas(), &move);
  EXPECT_GT(pane.timeAxis()->lower(), 4.1);
  EXPECT_NEAR(pane.timeAxis()->span(), 2, 1e-9);
  QTest::mouseRelease(canvas(), Qt::MiddleButton, {}, {400, 50});
  pane.timeAxis()->pan(100);
  EXPECT_NEAR(pane.timeAxis()->upper(), 9.999, 1e-9);
  EXPECT_NEAR(pane.timeAxis()->span(), 2, 1e-9);
}

TEST_F(PlotsTest, ClickMovesTheTime) {
  QTest::mouseClick(canvas(), Qt::LeftButton, {}, {500, 50});
  EXPECT_NEAR(playback.time(), pane.timeAxis()->toTime(500, canvas()->width()), 1e-9);
}

TEST_F(PlotsTest, LegendSwitchesCurvesOff) {
  const int all = pane.plots()->pointsDrawn();
  auto* simulated = pane.findChild<QAbstractButton*>("legend4");
  ASSERT_NE(simulated, nullptr);
  QTest::mouseClick(simulated, Qt::LeftButton);
  EXPECT_FALSE(pane.plots()->isShown(WrenchPlots::Shown::simulated));
  EXPECT_LT(pane.plots()->pointsDrawn(), all);
  QTest::mouseClick(simulated, Qt::LeftButton);
  EXPECT_EQ(pane.plots()->pointsDrawn(), all);
}

TEST_F(PlotsTest, KeysZoomAndShowAll) {
  QTest::keyClick(pane.plots(), Qt::Key_Plus);
  EXPECT_LT(pane.timeAxis()->span(), 9);
  QTest::keyClick(pane.plots(), Qt::Key_0);
  EXPECT_TRUE(pane.timeAxis()->showsAll());
}

TEST(WrenchTraces, ValuesAreReadBetweenSamples) {
  const Recording recording = test::sineRecording(1000, 100);
  const EstimateReport report = test::reportOn(recording);
  const WrenchTraces traces(recording, &report);
  EXPECT_NEAR(traces.valueAt(WrenchTraces::Kind::measured, 2, 3.005), -5 + 3.005, 1e-6);
  EXPECT_NEAR(traces.valueAt(WrenchTraces::Kind::difference, 0, 3.005), 0.25, 1e-6);
  EXPECT_TRUE(std::isnan(traces.valueAt(WrenchTraces::Kind::measured, 2, 99)));
  const auto rows = cursorTable(traces, 2.0, 5.0);
  ASSERT_EQ(rows.size(), 8u);
  EXPECT_EQ(rows[1][3], "3.000");
  EXPECT_EQ(rows[4][0], "Fz [N]");
  EXPECT_EQ(rows[4][3], "3.00");
  EXPECT_EQ(rows[1][5], QString::fromUtf8("1/Δt 0.33 Hz"));
  EXPECT_EQ(rows[4][4], QString::fromUtf8("−1.50"));
  EXPECT_EQ(rows[2][5], "0.250");
  const auto without = cursorTable(WrenchTraces(recording, nullptr), 2.0, 5.0);
  EXPECT_EQ(without[2][5], QString::fromUtf8("–"));
}

TEST(VisibleCsv, HoldsTheVisibleSamplesOfAllKinds) {
  const Recording recording = test::sineRecording(1000, 100);
  const EstimateReport report = test::reportOn(recording);
  const QStringList lines =
      QString::fromStdString(visibleCsv(WrenchTraces(recording, &report), 1.0, 1.1)).trimmed().split('\n');
  ASSERT_EQ(lines.size(), 12);
  EXPECT_TRUE(lines[0].startsWith("time,fx,fy,fz,tx,ty,tz,fx_simulated"));
  const QStringList cells = lines[1].split(',');
  ASSERT_EQ(cells.size(), 19);
  EXPECT_NEAR(cells[0].toDouble(), 1.0, 1e-9);
  EXPECT_NEAR(cells[3].toDouble(), -4.0, 1e-9);
  EXPECT_NEAR(cells[13].toDouble(), 0.25, 1e-9);
  const QString without = QString::fromStdString(visibleCsv(WrenchTraces(recording, nullptr), 1.0, 1.1));
  EXPECT_EQ(without.split('\n')[1].split(',').size(), 7);
}

TEST_F(PlotsTest, ASecondCursorIsPutDownAndDragged) {
  pane.setMeasuring(true);
  EXPECT_TRUE(pane.differenceCursor()->isVisible());
  QTest::mouseClick(canvas(), Qt::LeftButton, Qt::ControlModifier, {400, 50});
  EXPECT_NEAR(pane.differenceCursor()->second(), pane.timeAxis()->toTime(400, canvas()->width()), 1e-9);
  QTest::mousePress(canvas(), Qt::LeftButton, {}, {402, 50});
  QMouseEvent move(QEvent::MouseMove, QPointF(600, 50), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(canvas(), &move);
  QTest::mouseRelease(canvas(), Qt::LeftButton, {}, {600, 50});
  EXPECT_NEAR(pane.differenceCursor()->second(), pane.timeAxis()->toTime(600, canvas()->width()), 1e-9);
  EXPECT_TRUE(pane.timeAxis()->showsAll());
  pane.setMeasuring(false);
  EXPECT_FALSE(pane.differenceCursor()->isVisible());
}

class PaintTest : public PlotsTest {
 protected:
  PaintTest() {
    pane.setBrush(MarkLabel::ignore);
    QObject::connect(&pane, &RecordingPane::painted, &pane, [this](double from, double to, MarkLabel label) {
      strokes.push_back({from, to, label});
    });
  }
  void drag(QWidget* widget, int from, int to, int y) {
    QTest::mousePress(widget, Qt::LeftButton, {}, {from, y});
    QMouseEvent move(QEvent::MouseMove, QPointF(to, y), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(widget, &move);
    QTest::mouseRelease(widget, Qt::LeftButton, {}, {to, y});
  }
  double timeAt(int x) { return pane.timeAxis()->toTime(x, pane.marks()->width()); }
  std::vector<Mark> strokes;
};

TEST_F(PaintTest, DraggingOverTheBarPaints) {
  drag(pane.marks(), 200, 320, 12);
  ASSERT_EQ(strokes.size(), 1u);
  EXPECT_EQ(strokes[0].label, MarkLabel::ignore);
  EXPECT_NEAR(strokes[0].from, timeAt(200), 1e-9);
  EXPECT_NEAR(strokes[0].to, timeAt(320), 1e-9);
  QTest::mouseClick(pane.marks(), Qt::LeftButton, {}, {250, 12});
  EXPECT_EQ(strokes.size(), 1u) << "a click only picks a time";
}

TEST_F(PaintTest, AnEdgeIsMovedByDragging) {
  const int edge = static_cast<int>(pane.timeAxis()->toX(report.segments[1].from, pane.marks()->width()));
  drag(pane.marks(), edge, edge + 40, 12);
  ASSERT_EQ(strokes.size(), 1u);
  EXPECT_EQ(strokes[0].label, MarkLabel::free) << "the free part before it grows";
  EXPECT_NEAR(strokes[0].from, report.segments[1].from, 1e-9);
  EXPECT_NEAR(strokes[0].to, timeAt(edge + 40), 1e-9);
}

TEST_F(PaintTest, KeysPaintFromEnterToEnter) {
  pane.marks()->setFocus();
  playback.setTime(2.0);
  QTest::keyClick(pane.marks(), Qt::Key_Return);
  playback.setTime(3.5);
  QTest::keyClick(pane.marks(), Qt::Key_Return);
  ASSERT_EQ(strokes.size(), 1u);
  EXPECT_NEAR(strokes[0].from, 2.0, 1e-9);
  EXPECT_NEAR(strokes[0].to, 3.5, 1e-9);
  QTest::keyClick(pane.marks(), Qt::Key_Return);
  playback.setTime(5.0);
  QTest::keyClick(pane.marks(), Qt::Key_Escape);
  QTest::keyClick(pane.marks(), Qt::Key_Return);
  EXPECT_EQ(strokes.size(), 1u) << "Escape gives the stroke up";
}

TEST_F(PaintTest, ThePlotsPaintOnlyWhereThatIsChosen) {
  pane.setBrush(MarkLabel::contact, true);
  drag(canvas(), 300, 500, 50);
  EXPECT_EQ(strokes.size(), 1u);
  EXPECT_TRUE(pane.timeAxis()->showsAll());
  pane.setBrush(MarkLabel::contact);
  drag(canvas(), 300, 500, 50);
  EXPECT_EQ(strokes.size(), 1u);
  EXPECT_FALSE(pane.timeAxis()->showsAll());
}

TEST_F(PlotsTest, MarksBarTellsWhatIsUnderThePointer) {
  MarksBar* marks = pane.marks();
  const int x = static_cast<int>(pane.timeAxis()->toX(4.5, marks->width()));
  const Segment* contact = marks->segmentAt({x, 12});
  ASSERT_NE(contact, nullptr);
  EXPECT_EQ(contact->label, MarkLabel::contact);
  EXPECT_EQ(MarksBar::describe(*contact),
            QString::fromUtf8("contact, 4.0 – 5.0 s: a push that the motion does not explain"));
  EXPECT_EQ(marks->segmentAt({10, 12}), nullptr);
  pane.timeAxis()->show(0, 2);
  EXPECT_EQ(marks->segmentAt({x, 12})->label, MarkLabel::free);
}

TEST_F(PlotsTest, MarksBarPaintsContactInItsColour) {
  const QImage image = pane.marks()->grab().toImage();
  const int x = static_cast<int>(pane.timeAxis()->toX(4.5, pane.marks()->width()));
  const qreal ratio = image.devicePixelRatio();
  EXPECT_EQ(QColor(image.pixel(static_cast<int>(x * ratio) - 30, static_cast<int>(8 * ratio))).name(), "#e69f00");
}

TEST_F(PlotsTest, CurvesArePaintedInTheirColours) {
  QTest::qWait(250);
  const QImage image = pane.plots()->grab().toImage();
  int orange = 0, green = 0, blue = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const QColor c = image.pixelColor(x, y);
      const auto near = [&](const char* name) {
        const QColor wanted(name);
        return std::abs(c.red() - wanted.red()) + std::abs(c.green() - wanted.green()) +
                   std::abs(c.blue() - wanted.blue()) <
               60;
      };
      orange += near("#D55E00");
      green += near("#009E73");
      blue += near("#0072B2");
    }
  }
  EXPECT_GT(orange, 300);
  EXPECT_GT(green, 100);
  EXPECT_GT(blue, 100);
}

}  // namespace
}  // namespace heft
