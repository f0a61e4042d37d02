#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>
#include <cmath>
#include <random>

#include "tests/ui/fixtures.h"
#include "ui/timeline/marks_bar.h"
#include "ui/timeline/playback.h"
#include "ui/wrench_plots/min_max_pyramid.h"
#include "ui/wrench_plots/recording_pane.h"
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
        EXPECT_EQ(found.lowest, lowest) << n << " [" << from << ", " << to << ")";
        EXPECT_EQ(found.highest, highest) << n << " [" << from << ", " << to << ")";
      }
    }
  }
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
  for (int i = 0; i < curve.x.size(); ++i) EXPECT_NEAR(curve.low[i], 10 * std::sin(2 * M_PI * curve.x[i]), 1e-12);
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
    pane.setRecording(&recording);
    pane.setReport(&recording, &report);
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
