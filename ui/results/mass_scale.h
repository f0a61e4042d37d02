#pragma once
// The line under the mass: estimate, its 95 % interval, and what the user stated.
#include <QWidget>

#include "ui/models/result_text.h"

namespace heft {

class MassScaleWidget : public QWidget {
 public:
  MassScaleWidget(const MassScale& scale, Source source, QWidget* parent = nullptr);
  QSize sizeHint() const override { return {200, 34}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  MassScale scale_;
  Source source_;
};

}  // namespace heft
