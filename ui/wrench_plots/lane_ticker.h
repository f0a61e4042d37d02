#pragma once
// The numbers at the left of a lane.
#include <qcustomplot.h>

namespace heft {

/// Few ticks with a real minus sign; none so near an edge that its number would run into the next lane's.
class LaneTicker : public QCPAxisTicker {
 public:
  /// `scale`: from the curves' unit to the one that is shown.
  LaneTicker(const QCPAxisRect* lane, double scale) : lane_(lane), scale_(scale) {}

 protected:
  QString getTickLabel(double tick, const QLocale&, QChar, int) override;
  double getTickStep(const QCPRange& range) override;

 private:
  static constexpr double kHalfNumber = 4.0;  ///< [px] Half the height of a number: nearer to an edge it is left out
  const QCPAxisRect* lane_;
  double scale_;
  QCPRange range_;
  double mTickStep_ = 1.0;
};

}  // namespace heft
