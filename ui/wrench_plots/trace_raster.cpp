#include "ui/wrench_plots/trace_raster.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace heft {
namespace {

/// A slice with nothing in it reaches from below everything up to above everything.
constexpr float kFar = std::numeric_limits<float>::infinity();

}  // namespace

TraceColumns::TraceColumns(int width)
    : top_(static_cast<std::size_t>(std::max(0, width)) * kPerPixel, kFar), bottom_(top_.size(), -kFar) {}

void TraceColumns::include(int slice, double top, double bottom) {
  const auto i = static_cast<std::size_t>(slice);
  top_[i] = std::min(top_[i], static_cast<float>(top));
  bottom_[i] = std::max(bottom_[i], static_cast<float>(bottom));
}

void TraceColumns::addLine(double x0, double y0, double x1, double y1) {
  const int slices = static_cast<int>(top_.size());
  x0 *= kPerPixel;
  x1 *= kPerPixel;
  if (!(x1 >= 0.0) || !(x0 < slices) || !std::isfinite(y0) || !std::isfinite(y1)) return;
  const double slope = x1 > x0 ? (y1 - y0) / (x1 - x0) : 0.0;
  const int first = std::max(0, static_cast<int>(std::floor(x0)));
  const int last = std::min(slices - 1, static_cast<int>(std::floor(std::min(x1, 1e9))));
  for (int s = first; s <= last; ++s) {
    // Where it enters the slice, and where it leaves.
    const double in = s <= x0 ? y0 : y0 + slope * (s - x0), out = s + 1 >= x1 ? y1 : y0 + slope * (s + 1 - x0);
    include(s, std::min(in, out), std::max(in, out));
  }
}

void TraceColumns::addBar(double x0, double x1, double top, double bottom) {
  if (!std::isfinite(top) || !std::isfinite(bottom)) return;
  const int first = std::max(0, static_cast<int>(std::lround(x0 * kPerPixel)));
  const int last = std::min(static_cast<int>(top_.size()), static_cast<int>(std::lround(x1 * kPerPixel)));
  for (int s = first; s < last; ++s) include(s, top, bottom);
}

void TraceColumns::dash(double on, double off) {
  double length = 0.0;
  float before = kFar;
  for (std::size_t i = 0; i < top_.size(); ++i) {
    if (top_[i] > bottom_[i]) {
      before = kFar;
      continue;
    }
    const float middle = 0.5f * (top_[i] + bottom_[i]);
    const double rise = before == kFar ? 0.0 : std::min<double>(on + off, std::abs(middle - before));
    before = middle;
    length += std::sqrt(1.0 / (kPerPixel * kPerPixel) + rise * rise);
    while (length > on + off) length -= on + off;
    if (length > on) top_[i] = kFar, bottom_[i] = -kFar;
  }
}

void TraceColumns::paint(QImage& picture, const QColor& colour, double thickness) const {
  const int height = picture.height(), slices = static_cast<int>(top_.size());
  const double radius = std::max(0.5, 0.5 * thickness);
  // A round brush: its height at each neighbouring slice.
  std::vector<float> top(top_.size(), kFar), bottom(top_.size(), -kFar);
  const int reach = static_cast<int>(std::floor(radius * kPerPixel));
  for (int k = -reach; k <= reach; ++k) {
    const auto more = static_cast<float>(
        std::sqrt(std::max(0.0, radius * radius - static_cast<double>(k * k) / (kPerPixel * kPerPixel))));
    const int from = std::max(0, -k), to = slices - std::max(0, k);
    const float *above = top_.data(), *below = bottom_.data();
    float *highest = top.data(), *lowest = bottom.data();
    for (int s = from; s < to; ++s) {
      highest[s] = std::min(highest[s], above[s + k] - more);
      lowest[s] = std::max(lowest[s], below[s + k] + more);
    }
  }
  constexpr int kFull = 256;  // Of opacity
  const auto opaque = static_cast<float>(kFull * colour.alphaF() / kPerPixel);
  const int red = colour.red(), green = colour.green(), blue = colour.blue();
  std::vector<float> covered(static_cast<std::size_t>(height), 0.0f);  // By the slices of one column
  const auto lower = static_cast<float>(height);
  uchar* bits = picture.bits();
  const qsizetype stride = picture.bytesPerLine();
  for (int column = 0; column < std::min(width(), picture.width()); ++column) {
    int from = height, to = -1;
    for (int s = column * kPerPixel; s < (column + 1) * kPerPixel; ++s) {
      const float begin = std::max(top[static_cast<std::size_t>(s)], 0.0f),
                  end = std::min(bottom[static_cast<std::size_t>(s)], lower);
      if (!(end > begin)) continue;
      const int first = static_cast<int>(begin), last = std::min(height - 1, static_cast<int>(end));
      from = std::min(from, first);
      to = std::max(to, last);
      if (first == last) {
        covered[static_cast<std::size_t>(first)] += end - begin;
        continue;
      }
      covered[static_cast<std::size_t>(first)] += static_cast<float>(first + 1) - begin;
      for (int y = first + 1; y < last; ++y) covered[static_cast<std::size_t>(y)] += 1.0f;
      covered[static_cast<std::size_t>(last)] += end - static_cast<float>(last);
    }
    for (int y = from; y <= to; ++y) {
      const float rounded = covered[static_cast<std::size_t>(y)] * opaque + 0.5f;  // Never negative
      const int share = std::min(kFull, static_cast<int>(rounded));
      covered[static_cast<std::size_t>(y)] = 0.0f;
      auto* pixel = reinterpret_cast<QRgb*>(bits + y * stride) + column;
      const auto over = [share](int under, int ink) {
        return (under * (kFull - share) + ink * share + kFull / 2) / kFull;
      };
      *pixel = qRgba(over(qRed(*pixel), red), over(qGreen(*pixel), green), over(qBlue(*pixel), blue),
                     over(qAlpha(*pixel), 255));
    }
  }
}

void addThinned(TraceColumns& columns, const ThinnedCurve& curve, const TraceScale& x, const TraceScale& y) {
  constexpr double kFlat = 1.5;  // [px] Lower than this, what a column reaches is a line.
  for (int i = 0; i < curve.x.size(); ++i) {
    const double at = x(curve.x[i]), low = y(curve.low[i]), high = y(curve.high[i]);
    // A gap in the numbers is a gap in the line.
    if (!std::isfinite(low) || !std::isfinite(high)) continue;
    if (i > 0 && std::isfinite(curve.low[i - 1]))
      columns.addLine(x(curve.x[i - 1]), 0.5 * (y(curve.low[i - 1]) + y(curve.high[i - 1])), at, 0.5 * (low + high));
    if (curve.crowded && low - high > kFlat) {
      // Half way to the neighbours.
      const double half = 0.5 * x.slope * curve.step;
      columns.addBar(at - half, at + half, high, low);
    }
  }
}

}  // namespace heft
