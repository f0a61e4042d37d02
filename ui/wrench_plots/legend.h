#pragma once
// One entry of the plots' legend, which is also the switch for what it names.
#include <QAbstractButton>

#include "ui/wrench_plots/wrench_plots.h"

namespace heft {

class LegendEntry : public QAbstractButton {
  Q_OBJECT
 public:
  LegendEntry(WrenchPlots::Shown what, const QString& text, QWidget* parent = nullptr);
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  int sampleWidth() const;
  WrenchPlots::Shown what_;
};

}  // namespace heft
