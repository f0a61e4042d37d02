#include "ui/models/numbers.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <cmath>

namespace heft {

QString numberText(double value, int decimals) {
  if (!std::isfinite(value)) return QString(QChar(0x2014));
  const double half = 0.5 * std::pow(10.0, -decimals);
  if (std::abs(value) < half) value = 0.0;
  QLocale locale;
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  QString text = locale.toString(std::abs(value), 'f', decimals);
  return value < 0 ? QChar(0x2212) + text : text;
}

QString timeText(double time, bool poses) {
  if (poses) return QCoreApplication::translate("heft", "pose %1").arg(static_cast<int>(std::lround(time)));
  return numberText(time, 2) + QStringLiteral(" s");
}

}  // namespace heft
