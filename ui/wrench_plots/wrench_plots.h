#pragma once
// Four lanes on one time axis: force, its difference, torque, its difference.
#include <QWidget>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "ui/timeline/time_axis.h"
#include "ui/wrench_plots/wrench_traces.h"

namespace heft {

/// Wheel zooms time about the pointer, with Ctrl the lane's values; dragging draws a rubber band and zooms to it, over
/// a good part of a lane's height a box, to which the values are zoomed, too; Shift or the middle button drags the
/// view; a click moves the cursor; a double click shows everything. Keys: arrows move the cursor, + - 0 zoom.
class WrenchPlots : public QWidget {
  Q_OBJECT
 public:
  /// `axis` must outlive the plots.
  explicit WrenchPlots(TimeAxis* axis, QWidget* parent = nullptr);
  ~WrenchPlots() override;

  void setTraces(std::shared_ptr<const WrenchTraces> traces);
  void setSegments(std::vector<Segment> segments);
  const std::shared_ptr<const WrenchTraces>& traces() const { return traces_; }

  /// A segment to point out, framed in the accent colour with a word above it; an empty one removes it.
  void setHighlight(double from, double to, const QString& word);

  /// With a brush dragging paints in its colour and gives stroked() instead of zooming.
  void setBrush(std::optional<MarkLabel> brush);

  /// A second cursor, which is dragged with the mouse and placed by Ctrl+click; NaN: none.
  void setSecondCursor(double time);

  enum class Shown { x, y, z, measured, simulated, difference };
  void setShown(Shown what, bool shown);
  bool isShown(Shown what) const;

  /// For tests: the limits of a lane (0 force, 1 its difference, 2 torque, 3 its difference) and its points drawn.
  MinMax laneRange(int lane) const;
  MinMax laneTime(int lane) const;
  int pointsDrawn() const;

 signals:
  void timePicked(double time);
  /// The second cursor was moved.
  void secondPicked(double time);
  /// A segment was painted, earlier end first.
  void stroked(double from, double to);

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  struct Parts;
  void buildLane(int lane);
  /// Title and unit.
  void nameLane(int lane);
  void restyle();
  void refresh();
  void rebuildBackgrounds();

  TimeAxis* axis_;
  std::shared_ptr<const WrenchTraces> traces_;
  std::vector<Segment> segments_;
  double highlightFrom_ = 0.0, highlightTo_ = 0.0;
  QString highlightWord_;
  std::array<bool, 6> shown_{true, true, true, true, true, true};
  std::unique_ptr<Parts> parts_;
};

}  // namespace heft
