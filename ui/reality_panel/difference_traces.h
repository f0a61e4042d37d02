#pragma once
// One channel over time in the reality check: measured, simulated without and with the causes, and below the residual
// of each, on one scale, with the sensor's noise. Shares time, zoom and cursor with the plots.
#include <QVector>
#include <QWidget>
#include <array>
#include <vector>

#include "ui/timeline/time_axis.h"

namespace heft {

/// All of one length; NaN where nothing is compared.
struct DifferenceCurves {
  QVector<double> time;                     ///< [s], rising
  QVector<double> measured, without, with;  ///< [unit]
  QVector<double> clean;                    ///< [unit] Of the recording without its fault; may be empty
  double noise = 0.0;                       ///< Half height of the noise band: two deviations of the sensor
  double delay = 0.0;                       ///< [s] How much the readings lag behind the motion; 0: not drawn
  QString channel, unit;                    ///< "force x", "N"
  int decimals = 3;                         ///< Of the numbers at the pointer
  /// 0 measured, 1 without, 2 with, 3 and 4 the residuals of these two, 5 clean, 6 measured − clean
  double value(int curve, int at) const;
};

class TimeMouse;

class DifferenceTraces : public QWidget {
  Q_OBJECT
 public:
  /// `axis` must outlive the widget.
  explicit DifferenceTraces(TimeAxis* axis, QWidget* parent = nullptr);
  void setCurves(DifferenceCurves curves);
  const DifferenceCurves& curves() const { return curves_; }
  void setTime(double time);

  /// Limits of the lower lane [unit]: the same for both curves.
  std::array<double, 2> differenceRange() const;

 signals:
  void timePicked(double time);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  struct Lane {
    QRectF area;
    double low = -1.0, high = 1.0;
    double y(double value) const { return area.bottom() - (value - low) / (high - low) * area.height(); }
  };
  std::array<Lane, 2> lanes() const;
  std::array<double, 2> rangeOf(std::initializer_list<int> curves, double least) const;
  void drawLane(QPainter& painter, const Lane& lane, const QString& title) const;
  void drawCurve(QPainter& painter, const Lane& lane, int curve, const QPen& pen) const;
  void drawDelay(QPainter& painter, const Lane& lane) const;
  void drawPointer(QPainter& painter, const std::array<Lane, 2>& lanes) const;
  int nearest(double time) const;
  std::array<int, 2> visible() const;

  TimeAxis* axis_;
  TimeMouse* mouse_;
  DifferenceCurves curves_;
  double time_ = 0.0;
};

}  // namespace heft
