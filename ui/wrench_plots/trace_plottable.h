#pragma once
// A curve for QCustomPlot that draws what WrenchTraces thinned: an envelope where samples crowd, a line where they do
// not. QCPGraph strokes the whole polyline as one path, which takes most of a second for six noisy channels at full
// width.
#include <qcustomplot.h>

#include "ui/wrench_plots/wrench_traces.h"

namespace heft {

class TracePlottable : public QCPAbstractPlottable {
 public:
  TracePlottable(QCPAxis* keyAxis, QCPAxis* valueAxis);

  void setCurve(ThinnedCurve curve) { curve_ = std::move(curve); }
  void setDashed(bool dashed) { dashed_ = dashed; }
  /// Draws every sample as a dot, too.
  void setDots(bool dots) { dots_ = dots; }

  double selectTest(const QPointF&, bool, QVariant* = nullptr) const override { return -1; }
  QCPRange getKeyRange(bool& found, QCP::SignDomain) const override;
  QCPRange getValueRange(bool& found, QCP::SignDomain, const QCPRange&) const override;

 protected:
  void draw(QCPPainter* painter) override;
  void drawLegendIcon(QCPPainter*, const QRectF&) const override {}

 private:
  void drawEnvelope(QCPPainter* painter) const;
  void drawLine(QCPPainter* painter, const QVector<QPointF>& points) const;
  void drawDashes(QCPPainter* painter, const QVector<QPointF>& points) const;

  ThinnedCurve curve_;
  bool dashed_ = false;
  bool dots_ = false;
};

}  // namespace heft
