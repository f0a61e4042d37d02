#include "ui/results/share_rows.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "ui/theme/theme.h"

namespace heft {

DataShareBar::DataShareBar(double share, QWidget* parent) : QWidget(parent), share_(std::clamp(share, 0.0, 1.0)) {
  setFixedHeight(8);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void DataShareBar::paintEvent(QPaintEvent*) {
  const Theme& t = theme();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QPainterPath shape;
  shape.addRoundedRect(rect(), 4, 4);
  painter.setClipPath(shape);
  painter.fillRect(rect(), t.look);
  painter.fillRect(QRectF(0, 0, share_ * width(), height()), t.good);
}

}  // namespace heft
