// Runs the widget tests with a QApplication that needs no display.
#include <gtest/gtest.h>

#include <QApplication>
#include <QLocale>

#include "ui/theme/theme.h"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  qputenv("QT_QPA_PLATFORM", "offscreen");
  QApplication application(argc, argv);
  QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates));
  heft::applyTheme(application, heft::ThemeKind::light);
  return RUN_ALL_TESTS();
}
