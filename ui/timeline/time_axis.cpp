#include "ui/timeline/time_axis.h"

#include <algorithm>
#include <cmath>

namespace heft {

TimeAxis::TimeAxis(QObject* parent) : QObject(parent) {}

void TimeAxis::setFull(double lower, double upper, bool poses) {
  if (!(upper > lower)) upper = lower + 1.0;
  fullLower_ = lower;
  fullUpper_ = upper;
  poses_ = poses;
  lower_ = lower;
  upper_ = upper;
  emit fullChanged();
  emit visibleChanged();
}

void TimeAxis::grow(double upper) {
  if (upper <= fullUpper_) return;
  const bool follows = upper_ >= fullUpper_ - 1e-9;
  const double by = upper - fullUpper_;
  fullUpper_ = upper;
  if (follows) lower_ += by, upper_ += by;
  emit fullChanged();
  emit visibleChanged();
}

void TimeAxis::show(double lower, double upper) {
  if (!std::isfinite(lower) || !std::isfinite(upper)) return;
  const double full = fullUpper_ - fullLower_;
  const double wanted = std::clamp(std::abs(upper - lower), std::min(full, 0.01), full);
  const double middle = (lower + upper) / 2.0;
  double from = middle - wanted / 2.0;
  from = std::clamp(from, fullLower_, std::max(fullLower_, fullUpper_ - wanted));
  if (from == lower_ && from + wanted == upper_) return;
  lower_ = from;
  upper_ = std::min(from + wanted, fullUpper_);
  emit visibleChanged();
}

void TimeAxis::zoom(double factor, double about) {
  const double wanted = std::min(span() * factor, fullUpper_ - fullLower_);
  const double share = span() > 0 ? (about - lower_) / span() : 0.5;
  show(about - share * wanted, about + (1.0 - share) * wanted);
}

void TimeAxis::pan(double seconds) { show(lower_ + seconds, upper_ + seconds); }

void TimeAxis::reveal(double time) {
  if (time < lower_ || time > upper_) show(time, time + span());
}

double TimeAxis::toX(double time, int width) const {
  return kLeft + (time - lower_) / (upper_ - lower_) * std::max(1, width - kLeft - kRight);
}

double TimeAxis::toTime(double x, int width) const {
  return lower_ + (x - kLeft) / std::max(1, width - kLeft - kRight) * (upper_ - lower_);
}

}  // namespace heft
