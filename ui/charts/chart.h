#pragma once
// Small plots that are painted once: on a card, in a pane, in a report. Curves over linear or logarithmic axes, a band
// about zero for the noise. The large plots of a recording are in ui/wrench_plots.
#include <QImage>
#include <QPointF>
#include <QString>
#include <QVector>
#include <QWidget>
#include <optional>
#include <vector>

#include "ui/theme/theme.h"

namespace heft {

struct ChartCurve {
  enum class Colour { before, after, text, x, y, z, dots };
  QString name;  ///< For the legend; empty: not in it.
  Colour colour = Colour::text;
  QVector<QPointF> points;  ///< A point that is not finite interrupts the line.
  bool dashed = false;
};

struct Chart {
  QString xTitle, yTitle;  ///< With units: "Time [s]"
  std::vector<ChartCurve> curves;
  double band = 0.0;            ///< Half height of the noise band about zero; with logY: its level above the bottom.
  QVector<QPointF> floor = {};  ///< The same where the band is not level: its upper edge, left to right; logY
  QString xUnit;                ///< Behind the last tick, where there is no room for xTitle: "s"
  bool logX = false, logY = false;
  double yLow = 0.0, yHigh = 0.0;  ///< Shown at least, so that several charts have one scale; alike: as the curves ask
  std::optional<QPointF> marker = {};  ///< One point with a ring round it
  QString nothing;                     ///< Stands there if there are no points.
};

/// Round numbers from `low` to `high`: at most `about`, unless that leaves fewer than three; never more than
/// 2 `about` + 1.
std::vector<double> ticksBetween(double low, double high, int about);

/// Where a point of the chart was drawn, in the painter's pixels.
struct ChartPlace {
  QRectF plot;
  double xLow = 0.0, xHigh = 1.0, yLow = 0.0, yHigh = 1.0;  ///< Logarithms where the axis is logarithmic
};
ChartPlace drawChart(QPainter& painter, const QRectF& area, const Chart& chart, const Theme& theme, bool legend);
/// For reports: `size` in points at twice the resolution.
QImage chartImage(const Chart& chart, QSize size, const Theme& theme);

class ChartWidget : public QWidget {
  Q_OBJECT
 public:
  explicit ChartWidget(QWidget* parent = nullptr);
  /// `legend`: names over the plot.
  void setChart(Chart chart, bool legend);
  const Chart& chart() const { return chart_; }

 signals:
  /// A click near a dot: its index in the curve's points.
  void dotPicked(int index);

 protected:
  void mouseReleaseEvent(QMouseEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  Chart chart_;
  bool legend_ = true;
  ChartPlace place_;
};

}  // namespace heft
