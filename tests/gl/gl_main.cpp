// Runs the window tests under a private X server; without Xvfb they cannot run and say so.
#include <gtest/gtest.h>

#include <QApplication>
#include <QLocale>
#include <QStandardPaths>
#include <clocale>
#include <cstdio>

#include "ui/offscreen/private_display.h"
#include "ui/robot_view/graphics_setup.h"
#include "ui/theme/theme.h"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  auto display = heft::PrivateDisplay::start(1600, 1000);
  if (!display) {
    std::printf("EVERY TEST SKIPPED: %s\n", display.error().message.c_str());
    return 0;
  }
  QStandardPaths::setTestModeEnabled(true);
  heft::prepareGraphics();
  QApplication application(argc, argv);
  std::setlocale(LC_NUMERIC, "C");
  QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates));
  heft::applyTheme(application, heft::ThemeKind::light);
  return RUN_ALL_TESTS();
}
