#include <gtest/gtest.h>

#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QVBoxLayout>

#include "tests/ui/fixtures.h"
#include "ui/results/result_panel.h"
#include "ui/theme/icons.h"
#include "ui/theme/theme.h"
#include "ui/widgets/basics.h"
#include "ui/widgets/message_bar.h"

namespace heft {
namespace {

QStringList textsOf(const QWidget& widget) {
  QStringList texts;
  for (const QLabel* label : widget.findChildren<QLabel*>()) {
    if (!label->text().isEmpty()) texts << label->text();
  }
  return texts;
}

ResultText example() { return describeResult(test::reportOn(test::sineRecording(1000, 100)), {}); }

TEST(ResultPanel, ShowsNumbersWithIntervalsAndWords) {
  ResultPanel panel;
  panel.showResult(example());
  const QStringList texts = textsOf(panel);
  for (const char* wanted : {"Your tool weighs 0.81 kg.", "Mass", "0.812", "± 0.004 kg", "Centre of mass", "45.8",
                             "± 0.6 mm", "Inertia", "16.0", "measured"}) {
    EXPECT_TRUE(texts.contains(QString::fromUtf8(wanted))) << wanted << " not in " << texts.join(" | ").toStdString();
  }
}

TEST(ResultPanel, DetailsAreOneClickBehind) {
  ResultPanel panel;
  panel.showResult(example());
  EXPECT_FALSE(textsOf(panel).contains("Condition number"));
  EXPECT_FALSE(textsOf(panel).contains("Method"));
  panel.setDetailsShown(true);
  EXPECT_TRUE(textsOf(panel).contains("Method"));
  panel.setDetailsShown(false);
  EXPECT_FALSE(textsOf(panel).contains("Method"));
}

TEST(ResultPanel, DetailsChooseAFrameShowCorrelationsAndCanBeCopied) {
  EstimateReport report = test::reportOn(test::sineRecording(1000, 100));
  report.mount.xyz = {0, 0, 0.04};
  ResultText result = describeResult(report, {});
  result.correlation.values(0, 3) = result.correlation.values(3, 0) = -0.97;
  ResultPanel panel;
  panel.resize(440, 900);
  panel.show();
  panel.showResult(result);
  panel.setDetailsShown(true);
  QTest::qWait(50);
  const auto shown = [&] {
    QStringList texts;
    for (const QLabel* label : panel.findChildren<QLabel*>())
      if (label->isVisible()) texts << label->text();
    return texts.join('\n');
  };
  const QString sensor = result.frames.at(0).front().value, flange = result.frames.at(1).front().value;
  ASSERT_NE(sensor, flange);
  EXPECT_TRUE(shown().contains(sensor) && !shown().contains(flange)) << shown().toStdString();
  QTest::mouseClick(panel.findChild<QPushButton*>("frameFlange"), Qt::LeftButton);
  QTest::qWait(50);
  EXPECT_TRUE(shown().contains(flange) && !shown().contains(sensor)) << shown().toStdString();
  panel.showResult(result);
  QTest::qWait(50);
  EXPECT_TRUE(shown().contains(flange)) << "the frame stays chosen with the next estimate";
  auto* matrix = panel.findChild<QWidget*>("correlationView");
  ASSERT_NE(matrix, nullptr);
  EXPECT_TRUE(matrix->isVisible());
  auto* title = panel.findChild<QWidget*>("correlationView")->parentWidget();
  EXPECT_LE(matrix->width(), title->width());
  QTest::mouseClick(panel.findChild<QPushButton*>("copyDetails"), Qt::LeftButton);
  const QString copied = QApplication::clipboard()->text();
  EXPECT_TRUE(copied.contains(sensor) && copied.contains(flange)) << copied.toStdString();
  EXPECT_TRUE(copied.contains(QString::fromUtf8("z\t−0.970"))) << copied.toStdString();
}

TEST(ResultPanel, HasExactlyOneFilledButtonThatSaysWhatHappens) {
  ResultPanel panel;
  QSignalSpy estimateWanted(&panel, &ResultPanel::estimateWanted), exportWanted(&panel, &ResultPanel::exportWanted);
  panel.resize(440, 800);
  panel.showNoResult("Stopped.");
  panel.show();
  auto mains = panel.findChildren<QPushButton*>("mainButton");
  ASSERT_EQ(mains.size(), 1);
  QTest::mouseClick(mains[0], Qt::LeftButton);
  EXPECT_EQ(estimateWanted.count(), 1);
  panel.showResult(example());
  QTest::mouseClick(mains[0], Qt::LeftButton);
  EXPECT_EQ(estimateWanted.count(), 1);
  EXPECT_EQ(exportWanted.count(), 1);
  panel.showWorking("b.csv");
  EXPECT_FALSE(mains[0]->isVisible());
}

TEST(ResultPanel, WarningsAreShownErrorsBeforeTheNumbers) {
  ResultText text = example();
  text.findings = {{Severity::error, "These values are physically impossible", "Use the method map"}};
  ResultPanel panel;
  panel.resize(440, 900);
  panel.showResult(text);
  panel.show();
  QApplication::processEvents();
  int errorTop = -1, massTop = -1;
  for (const QLabel* label : panel.findChildren<QLabel*>()) {
    const int y = label->mapTo(&panel, QPoint(0, 0)).y();
    if (label->text().startsWith("These values are physically impossible")) errorTop = y;
    if (label->text() == "Mass") massTop = y;
  }
  ASSERT_GE(errorTop, 0);
  EXPECT_LT(errorTop, massTop);
}

TEST(ResultPanel, LightsHaveWords) {
  ResultPanel panel;
  panel.showResult(example());
  int lights = 0;
  for (const QWidget* widget : panel.findChildren<QWidget*>()) {
    if (dynamic_cast<const LightIcon*>(widget) == nullptr) continue;
    ++lights;
    EXPECT_FALSE(widget->accessibleName().isEmpty());
  }
  EXPECT_GE(lights, 9);
}

TEST(ResultPanel, FitsItsWidthWithoutBeingCut) {
  ResultPanel panel;
  panel.resize(440, 900);
  panel.showResult(example());
  panel.show();
  QApplication::processEvents();
  for (const QLabel* label : panel.findChildren<QLabel*>()) {
    if (label->wordWrap() || label->text().isEmpty()) continue;
    EXPECT_GE(label->width() + 1, label->sizeHint().width()) << label->text().toStdString();
    EXPECT_LE(label->mapTo(&panel, QPoint(label->width(), 0)).x(), panel.width()) << label->text().toStdString();
  }
}

TEST(MessageBar, InformationFloatsAndMovesNothing) {
  QWidget window;
  auto* column = new QVBoxLayout(&window);
  auto* bar = new MessageBar(&window);
  auto* rest = new QWidget(&window);
  column->addWidget(bar);
  column->addWidget(rest, 1);
  window.resize(900, 500);
  window.show();
  QApplication::processEvents();
  const QRect before = rest->geometry();
  bar->showMessage(Severity::info, "Saved a.csv.");
  QApplication::processEvents();
  auto* toast = window.findChild<QFrame*>("toast");
  ASSERT_TRUE(toast && toast->isVisible());
  EXPECT_EQ(rest->geometry(), before);
  EXPECT_TRUE(window.rect().contains(toast->geometry()));
  EXPECT_EQ(bar->text(), "Saved a.csv.");
  bar->showMessage(Severity::error, "b.csv is no recording.");
  QApplication::processEvents();
  EXPECT_NE(rest->geometry(), before) << "what stays has a place of its own";
  bar->clear();
  QApplication::processEvents();
  EXPECT_EQ(rest->geometry(), before);
}

TEST(MessageBar, ShowsTheSentenceAndCloses) {
  QWidget window;
  auto* bar = new MessageBar(&window);
  window.show();
  EXPECT_FALSE(bar->isVisible());
  bar->showMessage(Severity::error, "rec.csv:3:4: text where a number belongs.");
  EXPECT_TRUE(bar->isVisible());
  EXPECT_EQ(bar->text(), "rec.csv:3:4: text where a number belongs.");
  // Another one does not take its place; the same one is not said twice, and information goes by itself.
  bar->showMessage(Severity::info, "Saved a.csv.");
  bar->showMessage(Severity::error, "rec.csv:3:4: text where a number belongs.");
  bar->showMessage(Severity::warning, "headonly.csv holds no rows.");
  EXPECT_EQ(bar->text(), "rec.csv:3:4: text where a number belongs.\nheadonly.csv holds no rows.");
  QApplication::processEvents();
  for (int k = 0; k < 2; ++k)
    for (auto* close : bar->findChildren<QToolButton*>("messageClose"))
      if (close->isVisible()) {
        QTest::mouseClick(close, Qt::LeftButton);
        break;
      }
  EXPECT_FALSE(bar->isVisible());
}

TEST(Icons, EveryDrawingIsThereAndTakesTheColour) {
  for (const char* name : {"heft",
                           "open",
                           "undo",
                           "redo",
                           "check",
                           "copy",
                           "plus",
                           "minus",
                           "brush",
                           "cursors",
                           "contact",
                           "hand",
                           "back",
                           "table",
                           "folder",
                           "play",
                           "pause",
                           "fit",
                           "tool",
                           "view",
                           "eye",
                           "camera",
                           "bulb",
                           "close",
                           "info",
                           "light_measured",
                           "light_partly",
                           "light_unknown",
                           "light_look",
                           "light_two_causes",
                           "light_not_possible"}) {
    const QImage image = iconPixmap(name, 20, QColor("#123456"), QColor("#FFFFFF"), 2.0).toImage();
    int painted = 0, coloured = 0;
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        const QColor c = image.pixelColor(x, y);
        painted += c.alpha() > 0;
        coloured += c.alpha() == 255 && c.name() == "#123456";
      }
    }
    EXPECT_GT(painted, 60) << name;
    EXPECT_GT(coloured, 5) << name;
  }
}

TEST(Theme, TextIsReadableOnEveryGround) {
  const auto luminance = [](const QColor& c) {
    const auto channel = [](double v) { return v <= 0.03928 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
    return 0.2126 * channel(c.redF()) + 0.7152 * channel(c.greenF()) + 0.0722 * channel(c.blueF());
  };
  const auto contrast = [&](const QColor& a, const QColor& b) {
    const double la = luminance(a), lb = luminance(b);
    return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
  };
  for (const ThemeKind kind : {ThemeKind::light, ThemeKind::dark}) {
    const Theme& t = themeOf(kind);
    for (const QColor& ground : {t.window, t.panel, t.raised, t.accentTint, t.lookTint, t.badTint}) {
      EXPECT_GE(contrast(t.text, ground), 7.0) << ground.name().toStdString();
      EXPECT_GE(contrast(t.text2, ground), 4.5) << ground.name().toStdString();
    }
    EXPECT_GE(contrast(t.text3, t.panel), 4.5);
    EXPECT_GE(contrast(t.good, t.goodTint), 4.5);
    EXPECT_GE(contrast(t.lookText, t.lookTint), 4.5);
    EXPECT_GE(contrast(t.text2, t.quietTint), 4.5);
    EXPECT_GE(contrast(Qt::white, t.accentFill), 4.5);
  }
}

}  // namespace
}  // namespace heft
