#pragma once
// A lane's curves for QCustomPlot, drawn by TraceColumns: a line where samples are few, all that they reach where they
// crowd.
#include <qcustomplot.h>

#include <vector>

#include "ui/wrench_plots/wrench_traces.h"

namespace heft {

class TraceColumns;

class TracePlottable : public QCPAbstractPlottable {
 public:
  struct Trace {
    ThinnedCurve curve;
    QColor colour;
    double thickness = 1.5;  ///< [px]
    bool dashed = false;
    bool dots = false;  ///< Every sample is a dot, too.
  };
  TracePlottable(QCPAxis* keyAxis, QCPAxis* valueAxis);

  /// The later ones over the earlier.
  void setTraces(std::vector<Trace> traces) { traces_ = std::move(traces); }

  double selectTest(const QPointF&, bool, QVariant* = nullptr) const override { return -1; }
  QCPRange getKeyRange(bool& found, QCP::SignDomain) const override;
  QCPRange getValueRange(bool& found, QCP::SignDomain, const QCPRange&) const override;

 protected:
  void draw(QCPPainter* painter) override;
  void drawLegendIcon(QCPPainter*, const QRectF&) const override {}

 private:
  std::vector<Trace> traces_;
  QImage picture_;  ///< Kept for the next time.
};

}  // namespace heft
