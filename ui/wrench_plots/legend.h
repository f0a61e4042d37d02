#pragma once
// One entry of the plots' legend, which is also the switch for what it names.
#include <QAbstractButton>

#include "ui/wrench_plots/wrench_plots.h"

namespace heft {

class LegendEntry : public QAbstractButton {
  Q_OBJECT
 public:
  LegendEntry(WrenchPlots::Shown what, const QString& text, QWidget* parent = nullptr);
  /// Stands there instead where the whole text has no room; empty: the text itself.
  void setShortText(const QString& text);
  /// What the whole text needs.
  int wholeWidth() const { return widthWith(text()); }
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  int sampleWidth() const;
  int widthWith(const QString& text) const;
  QString shown() const { return short_.isEmpty() ? text() : short_; }
  WrenchPlots::Shown what_;
  QString short_;
};

}  // namespace heft
