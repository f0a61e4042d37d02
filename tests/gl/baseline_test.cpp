// Each step of the window against a small picture of how it looked: a change of looks is seen and, where it is meant,
// kept with HEFT_RENEW_PICTURES=1 build/release/bin/test_gl --gtest_filter='Looks*'.
#include <QPainter>
#include <QPushButton>
#include <cstdlib>

#include "tests/gl/window_fixture.h"

namespace heft {
namespace {

/// Sizes of the stored pictures: letters are grey there, so that other fonts and renderers pass.
constexpr QSize kSmall(160, 100);
constexpr int kBlock = 5;  ///< [px] of a small picture: 45 px of the window
constexpr double kMostBlock =
    26;  ///< Of 255: mean of a block in one colour; a cleared main button changes one by over 60
constexpr double kMostMean = 3;  ///< Of 255: over the whole picture

QImage small(const QImage& picture) {
  return picture.scaled(kSmall, Qt::IgnoreAspectRatio, Qt::SmoothTransformation).convertToFormat(QImage::Format_RGB32);
}

struct Distance {
  double mean = 0.0, block = 0.0;
  QPoint where;
  bool alike() const { return mean <= kMostMean && block <= kMostBlock; }
};

Distance distance(const QImage& a, const QImage& b) {
  Distance out;
  const int across = kSmall.width() / kBlock, down = kSmall.height() / kBlock;
  for (int by = 0; by < down; ++by)
    for (int bx = 0; bx < across; ++bx) {
      double red = 0, green = 0, blue = 0;
      for (int y = by * kBlock; y < (by + 1) * kBlock; ++y)
        for (int x = bx * kBlock; x < (bx + 1) * kBlock; ++x) {
          const QColor ca = a.pixelColor(x, y), cb = b.pixelColor(x, y);
          red += ca.red() - cb.red();
          green += ca.green() - cb.green();
          blue += ca.blue() - cb.blue();
        }
      const double off = std::max({std::abs(red), std::abs(green), std::abs(blue)}) / (kBlock * kBlock);
      out.mean += off / (across * down);
      if (off > out.block) out.block = off, out.where = {bx * kBlock, by * kBlock};
    }
  return out;
}

class Looks : public RealWindowTest {
 protected:
  Looks() : RealWindowTest("looks") {}
  void compare(const char* name) {
    QTest::qWait(350);  // Plots and 3D draw themselves smoothly once nothing moves.
    QImage now = small(window.picture());
    const QString path = QStringLiteral(HEFT_PICTURE_FOLDER "/%1.png").arg(name);
    if (qEnvironmentVariableIsSet("HEFT_RENEW_PICTURES")) {
      ASSERT_TRUE(now.save(path)) << qPrintable(path);
      return;
    }
    const QImage before(path);
    ASSERT_EQ(before.size(), kSmall) << qPrintable(path);
    Distance d = distance(now, before.convertToFormat(QImage::Format_RGB32));
    for (int more = 0; more < 10 && !d.alike(); ++more) {  // A busy machine takes longer.
      QTest::qWait(350);
      now = small(window.picture());
      d = distance(now, before.convertToFormat(QImage::Format_RGB32));
    }
    EXPECT_TRUE(d.alike()) << name << ": mean " << d.mean << ", block " << d.block << " at " << 9 * d.where.x() << ", "
                           << 9 * d.where.y() << " of the window";
  }
};

TEST_F(Looks, EachStepAsBefore) {
  compare("start");
  Payload tool;
  tool.mass = 0.8;
  tool.com = {0.005, -0.01, 0.06};
  tool.inertiaCom = Vector3d(0.0021, 0.0019, 0.0012).asDiagonal();
  SimulateOptions options;
  options.motion = MotionKind::excitation;
  options.duration = 8.0;
  options.seed = 11;
  options.effects = {{"time_offset", "", 15.0}};
  open(writeSimulated(folder, tool, options));
  for (const Step step : kAllSteps) {
    window.showStep(step);
    settle();
    if (step == Step::realityCheck) {
      ASSERT_TRUE(window.panel(step)->obey({"diagnose"}).value_or(false).ok());
      settle();
    }
    compare(std::string(stepId(step)).c_str());
  }
}

/// Such a test is worth what it can see.
TEST_F(Looks, AMissingButtonIsSeen) {
  settle(400);
  QImage picture = window.picture();
  auto* button = window.panel(Step::record)->findChild<QPushButton*>("mainButton");
  ASSERT_NE(button, nullptr);
  const QImage before = small(picture);
  EXPECT_TRUE(distance(before, small(window.picture())).alike());
  QPainter painter(&picture);
  const double ratio = picture.width() / static_cast<double>(window.width());
  const QPoint at = button->mapTo(&window, QPoint());
  painter.fillRect(QRectF(ratio * at.x(), ratio * at.y(), ratio * button->width(), ratio * button->height()),
                   Qt::white);
  painter.end();
  EXPECT_GT(distance(before, small(picture)).block, 2 * kMostBlock);
}

}  // namespace
}  // namespace heft
