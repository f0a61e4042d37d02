#pragma once
// Draws curves that only go to the right, smoothly, a column of pixels at a time: a general painter strokes outlines of
// thousands of corners, which takes a hundred times as long. Free of QCustomPlot.
#include <QColor>
#include <QImage>
#include <vector>

#include "ui/wrench_plots/wrench_traces.h"

namespace heft {

/// Values to pixels of a picture.
struct TraceScale {
  double offset, slope;
  double operator()(double value) const { return offset + slope * value; }
};

/// What a curve reaches in equal slices of the picture's width, kPerPixel of them a pixel; from top (small) to bottom,
/// in pixels from the upper edge.
class TraceColumns {
 public:
  static constexpr int kPerPixel = 4;

  explicit TraceColumns(int width);

  /// A straight line from one point to another that is not left of it.
  void addLine(double x0, double y0, double x1, double y1);
  /// All between two heights, from one x to another: where several samples share a pixel.
  void addBar(double x0, double x1, double top, double bottom);
  /// Cuts gaps into it: `on` pixels of its length are drawn, then `off` are not.
  void dash(double on, double off);

  int width() const { return static_cast<int>(top_.size()) / kPerPixel; }
  /// Draws it `thickness` pixels thick over the picture, which is as wide and premultiplied.
  void paint(QImage& picture, const QColor& colour, double thickness) const;

 private:
  void include(int slice, double top, double bottom);

  std::vector<float> top_, bottom_;
};

/// A thinned curve as lines, and as bars where several samples share a column; gaps stay gaps.
void addThinned(TraceColumns& columns, const ThinnedCurve& curve, const TraceScale& x, const TraceScale& y);

}  // namespace heft
