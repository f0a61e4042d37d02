#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QToolButton>
#include <cmath>

#include "ui/timeline/playback.h"
#include "ui/timeline/playback_bar.h"
#include "ui/timeline/time_axis.h"

namespace heft {
namespace {

TEST(TimeAxis, PixelsAndTimesAreInverse) {
  TimeAxis axis;
  axis.setFull(2, 12);
  axis.show(3, 7);
  for (const double x : {0.0, 92.0, 333.0, 984.0}) EXPECT_NEAR(axis.toX(axis.toTime(x, 1000), 1000), x, 1e-9);
  EXPECT_NEAR(axis.toX(3, 1000), TimeAxis::kLeft, 1e-9);
  EXPECT_NEAR(axis.toX(7, 1000), 1000 - TimeAxis::kRight, 1e-9);
}

TEST(TimeAxis, NeverLeavesTheRecording) {
  TimeAxis axis;
  axis.setFull(0, 10);
  axis.show(-5, 3);
  EXPECT_EQ(axis.lower(), 0);
  EXPECT_NEAR(axis.span(), 8, 1e-12);
  axis.zoom(100, 5);
  EXPECT_TRUE(axis.showsAll());
  for (int i = 0; i < 200; ++i) axis.zoom(0.5, 9.9);
  EXPECT_GT(axis.span(), 0);
  EXPECT_LE(axis.upper(), 10);
  axis.show(std::nan(""), 3);
  EXPECT_LE(axis.upper(), 10);
}

TEST(TimeAxis, AnEmptyRecordingStillHasAnAxis) {
  TimeAxis axis;
  axis.setFull(5, 5);
  EXPECT_GT(axis.span(), 0);
  EXPECT_TRUE(std::isfinite(axis.toX(5, 500)));
}

TEST(Playback, RunsByTheClockAndStopsAtTheEnd) {
  Playback playback;
  playback.setRange(1.0, 1.25);
  EXPECT_EQ(playback.time(), 1.0);
  playback.setPlaying(true);
  EXPECT_TRUE(playback.playing());
  ASSERT_TRUE(QTest::qWaitFor([&] { return !playback.playing(); }, 5000));
  EXPECT_EQ(playback.time(), 1.25);
  playback.toggle();  // From the end it begins again.
  EXPECT_EQ(playback.time(), 1.0);
  playback.setPlaying(false);
}

TEST(Playback, TimeStaysInsideTheRecording) {
  Playback playback;
  playback.setRange(0, 2);
  playback.setTime(7);
  EXPECT_EQ(playback.time(), 2);
  playback.setTime(-7);
  EXPECT_EQ(playback.time(), 0);
  playback.setTime(std::nan(""));
  EXPECT_EQ(playback.time(), 0);
}

TEST(PlaybackBar, SliderAndPlaybackFollowEachOther) {
  Playback playback;
  PlaybackBar bar(&playback);
  playback.setRange(0, 10);
  bar.setRecording(true);
  auto* slider = bar.findChild<QSlider*>("timeSlider");
  ASSERT_NE(slider, nullptr);
  slider->setValue(slider->maximum() / 4);
  EXPECT_NEAR(playback.time(), 2.5, 0.01);
  playback.setTime(5);
  EXPECT_NEAR(slider->value(), slider->maximum() / 2, 2);
  QTest::mouseClick(bar.findChild<QToolButton*>("playButton"), Qt::LeftButton);
  EXPECT_TRUE(playback.playing());
}

}  // namespace
}  // namespace heft
