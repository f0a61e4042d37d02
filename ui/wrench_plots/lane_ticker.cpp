#include "ui/wrench_plots/lane_ticker.h"

#include <algorithm>
#include <cmath>

#include "ui/models/numbers.h"

namespace heft {

QString LaneTicker::getTickLabel(double tick, const QLocale&, QChar, int) {
  const double above = (tick - range_.lower) / range_.size() * lane_->height();
  if (above < kHalfNumber || above > lane_->height() - kHalfNumber) return {};
  if (std::abs(tick) < 1e-9 * std::max(1.0, mTickStep_)) return QStringLiteral("0");
  const double step = scale_ * std::abs(mTickStep_);
  int decimals = 0;
  while (decimals < 6 && std::abs(std::round(step * std::pow(10, decimals)) - step * std::pow(10, decimals)) > 1e-6) {
    ++decimals;
  }
  return numberText(scale_ * tick, decimals);
}

double LaneTicker::getTickStep(const QCPRange& range) {
  range_ = range;
  // About zero with little height, or where the usual step finds no room: one number above and one below it, as far
  // out as a number has room.
  constexpr double kLow = 56.0;  // [px]
  if (range.lower < 0.0 && range.upper > 0.0 && std::abs(range.lower + range.upper) < 1e-6 * range.size() &&
      lane_->height() > 4.0 * kHalfNumber) {
    const double most = (1.0 - 2.0 * (kHalfNumber + 0.5) / lane_->height()) * range.upper * scale_;
    if (lane_->height() >= kLow)
      if (const double usual = QCPAxisTicker::getTickStep(range); usual * scale_ <= most) return mTickStep_ = usual;
    const double decade = std::pow(10.0, std::floor(std::log10(most)));
    constexpr double kApart = 10.0;  // [px] of numbers one above the other
    for (const double round : {8.0, 6.0, 5.0, 4.0, 3.0, 2.0, 1.5, 1.2, 1.0}) {
      const double step = round * decade / scale_;
      if (round * decade <= most && step / range.size() * lane_->height() >= kApart) return mTickStep_ = step;
    }
  }
  mTickStep_ = QCPAxisTicker::getTickStep(range);
  // In a low lane numbers must not touch each other; the next round step above, so that two of them remain.
  constexpr double kNumber = 12.0;  // [px]
  const double least = lane_->height() > 0 ? kNumber / lane_->height() * range.size() : 0.0;
  if (!(mTickStep_ < least)) return mTickStep_;
  const double decade = std::pow(10.0, std::floor(std::log10(least)));
  for (const double round : {1.0, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0}) {
    mTickStep_ = round * decade;
    if (mTickStep_ >= least) break;
  }
  return mTickStep_;
}

}  // namespace heft
