#pragma once
// What tests of the real window do with pictures.
#include <gtest/gtest.h>

#include <QDir>
#include <QImage>
#include <cstdio>

#include "ui/main_window/main_window.h"

namespace heft {

/// Share of pixels that differ by more than a hair.
inline double difference(const QImage& a, const QImage& b) {
  if (a.size() != b.size()) return 1.0;
  int different = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      const QColor ca = a.pixelColor(x, y), cb = b.pixelColor(x, y);
      different +=
          std::abs(ca.red() - cb.red()) + std::abs(ca.green() - cb.green()) + std::abs(ca.blue() - cb.blue()) > 24;
    }
  }
  return static_cast<double>(different) / (a.width() * a.height());
}

/// At the end of a test: HEFT_TEST_PICTURES=FOLDER keeps the picture of every test as PREFIX_TEST.png, to be looked at;
/// that of a test that failed is always kept.
inline void keepPicture(MainWindow& window, const char* prefix) {
  const QString folder = qEnvironmentVariable("HEFT_TEST_PICTURES");
  if (!testing::Test::HasFailure() && folder.isEmpty()) return;
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  const QDir target = folder.isEmpty() ? QDir::current() : QDir(folder);
  const QString path = target.filePath(QStringLiteral("%1_%2.png").arg(prefix, info->name()));
  window.picture().save(path);
  std::printf("The window as it was: %s\n", qPrintable(path));
}

}  // namespace heft
