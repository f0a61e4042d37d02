#pragma once
// The canvas that the lanes are drawn on.
#include <qcustomplot.h>

#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

#include "core/recording/recording.h"

namespace heft {

class TimeAxis;
class WrenchPlots;

/// Force, its difference, torque, its difference.
constexpr int kLanes = 4;
constexpr bool isDifference(int lane) { return lane % 2 == 1; }
constexpr int firstChannel(int lane) { return lane < 2 ? 0 : 3; }

/// QCustomPlot with the mouse as the studio uses it, the same in all lanes.
class PlotCanvas : public QCustomPlot {
 public:
  PlotCanvas(TimeAxis* axis, WrenchPlots* owner);
  void setBrush(std::optional<MarkLabel> brush) { brush_ = brush; }
  bool freeScale() const { return freeScale_; }
  void setRescale(std::function<void()> rescale) { rescale_ = std::move(rescale); }
  void setSecond(double time) { second_ = time; }
  /// What the user zoomed a lane's values to; nothing: as the curves need.
  std::optional<QCPRange> values(int lane) const { return values_[static_cast<std::size_t>(lane)]; }
  void forgetValues() { values_.fill({}); }

 protected:
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent*) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  /// Under the pointer: the time, and what the lane's curves read there.
  void paintValues(QPainter& painter) const;
  int axisRectIndex(const QPoint& at) const;

  /// Part of one lane's height that a drag goes over; a drag along the time has none.
  struct Box {
    int lane, top, bottom;  ///< [px]
  };
  std::optional<Box> boxTo(const QPoint& at) const;
  void showValues(int lane, double lower, double upper);

  enum class Mode { none, band, pan, second };
  QPoint pointer_{-1, -1};
  std::array<std::optional<QCPRange>, kLanes> values_;
  std::optional<Box> box_;
  bool freeScale_ = false;
  std::function<void()> rescale_;
  TimeAxis* axis_;
  WrenchPlots* owner_;
  Mode mode_ = Mode::none;
  QPoint pressed_;
  bool moved_ = false;
  double pressedLower_ = 0.0;
  std::pair<int, int> band_{0, 0};
  std::optional<MarkLabel> brush_;
  double second_ = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace heft
