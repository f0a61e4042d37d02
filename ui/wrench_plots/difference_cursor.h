#pragma once
// A second cursor over the plots and a small table: the values at both and the statistics between them.
#include <QStringList>
#include <QWidget>
#include <memory>
#include <vector>

#include "ui/timeline/time_axis.h"
#include "ui/wrench_plots/wrench_traces.h"

namespace heft {

/// Rows of six texts: what, at the first cursor, at the second, the difference, the mean between them (all measured),
/// and the root mean square of the residual between them.
std::vector<QStringList> cursorTable(const WrenchTraces& traces, double first, double second);

class DifferenceCursor : public QWidget {
  Q_OBJECT
 public:
  /// Covers `parent`, whose children share `axis`; `bottomInset` px at the bottom stay free.
  DifferenceCursor(TimeAxis* axis, QWidget* parent, int bottomInset);

  void setTraces(std::shared_ptr<const WrenchTraces> traces);
  /// The instant shown.
  void setFirst(double time);
  void setSecond(double time);
  double second() const { return second_; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  TimeAxis* axis_;
  int bottomInset_;
  std::shared_ptr<const WrenchTraces> traces_;
  double first_ = 0.0, second_ = 0.0;
};

}  // namespace heft
