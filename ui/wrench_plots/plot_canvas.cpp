#include "ui/wrench_plots/plot_canvas.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/models/numbers.h"
#include "ui/models/units.h"
#include "ui/theme/theme.h"
#include "ui/timeline/marks_bar.h"
#include "ui/timeline/time_mouse.h"
#include "ui/wrench_plots/wrench_plots.h"

namespace heft {

PlotCanvas::PlotCanvas(TimeAxis* axis, WrenchPlots* owner) : QCustomPlot(owner), axis_(axis), owner_(owner) {
  setInteractions(QCP::Interactions());
  setMouseTracking(true);
  // The keyboard's frame stands on the canvas, which does not have the focus itself.
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget* before, QWidget* now) {
    if (before == owner_ || now == owner_) update();
  });
}

void PlotCanvas::wheelEvent(QWheelEvent* event) {
  const int lane = axisRectIndex(event->position().toPoint());
  if (!(event->modifiers() & Qt::ControlModifier) || lane < 0) return TimeMouse::wheel(axis_, event, width());
  const QCPAxis* values = axisRect(lane)->axis(QCPAxis::atLeft);
  const double factor = std::pow(0.8, event->angleDelta().y() / 120.0);
  const double fixed = values->pixelToCoord(event->position().y());
  showValues(lane, fixed + factor * (values->range().lower - fixed), fixed + factor * (values->range().upper - fixed));
  event->accept();
}

void PlotCanvas::mousePressEvent(QMouseEvent* event) {
  owner_->setFocus(Qt::MouseFocusReason);
  pressed_ = event->pos();
  moved_ = false;
  const bool pans = event->button() == Qt::MiddleButton ||
                    (event->button() == Qt::LeftButton && (event->modifiers() & Qt::ShiftModifier));
  mode_ = pans ? Mode::pan : event->button() == Qt::LeftButton ? Mode::band : Mode::none;
  pressedLower_ = axis_->lower();
  const bool grabs = std::abs(axis_->toX(second_, width()) - pressed_.x()) < 5;
  if (event->button() == Qt::LeftButton && std::isfinite(second_) &&
      (grabs || (event->modifiers() & Qt::ControlModifier))) {
    mode_ = Mode::second;
    emit owner_->secondPicked(axis_->toTime(pressed_.x(), width()));
  }
}

void PlotCanvas::contextMenuEvent(QContextMenuEvent* event) {
  QMenu menu(this);
  menu.addAction(WrenchPlots::tr("Show the whole recording"), axis_, &TimeAxis::showAll);
  menu.addAction(WrenchPlots::tr("Scale the values to the curves"), this, [this] {
    forgetValues();
    if (rescale_) rescale_();
  });
  QAction* free = menu.addAction(WrenchPlots::tr("Scale to the free parts"));
  free->setCheckable(true);
  free->setChecked(freeScale_);
  free->setToolTip(WrenchPlots::tr("A contact may go out of the picture, so that the rest can be seen"));
  connect(free, &QAction::toggled, this, [this](bool on) {
    freeScale_ = on;
    if (rescale_) rescale_();
  });
  menu.addSeparator();
  menu.addAction(WrenchPlots::tr("Copy picture"), this,
                 [this] { QApplication::clipboard()->setImage(owner_->grab().toImage()); });
  menu.exec(event->globalPos());
}

void PlotCanvas::leaveEvent(QEvent* event) {
  QCustomPlot::leaveEvent(event);
  pointer_ = {-1, -1};
  update();
}

void PlotCanvas::mouseMoveEvent(QMouseEvent* event) {
  pointer_ = event->buttons() == Qt::NoButton ? event->pos() : QPoint(-1, -1);
  if (event->buttons() == Qt::NoButton) update();
  if (mode_ == Mode::second) return emit owner_->secondPicked(axis_->toTime(event->pos().x(), width()));
  if (mode_ == Mode::none || !(event->buttons() & (Qt::LeftButton | Qt::MiddleButton))) return;
  if ((event->pos() - pressed_).manhattanLength() > 4) moved_ = true;
  if (!moved_) return;
  if (mode_ == Mode::pan) {
    const double seconds = axis_->toTime(pressed_.x(), width()) - axis_->toTime(event->pos().x(), width());
    axis_->show(pressedLower_ + seconds, pressedLower_ + seconds + axis_->span());
    setCursor(Qt::ClosedHandCursor);
  } else {
    band_ = {pressed_.x(), event->pos().x()};
    box_ = brush_ ? std::nullopt : boxTo(event->pos());
    update();
  }
}

void PlotCanvas::mouseReleaseEvent(QMouseEvent* event) {
  const Mode mode = mode_;
  mode_ = Mode::none;
  unsetCursor();
  band_ = {0, 0};
  const auto box = std::exchange(box_, std::nullopt);
  update();
  if (mode == Mode::none || mode == Mode::second) return;
  const double from = axis_->toTime(pressed_.x(), width()), to = axis_->toTime(event->pos().x(), width());
  if (!moved_) {
    emit owner_->timePicked(to);
  } else if (mode == Mode::band && brush_) {
    emit owner_->stroked(std::min(from, to), std::max(from, to));
  } else if (mode == Mode::band) {
    if (box) {
      const QCPAxis* values = axisRect(box->lane)->axis(QCPAxis::atLeft);
      showValues(box->lane, values->pixelToCoord(box->bottom), values->pixelToCoord(box->top));
    }
    axis_->show(std::min(from, to), std::max(from, to));
  }
}

void PlotCanvas::mouseDoubleClickEvent(QMouseEvent*) {
  forgetValues();
  axis_->showAll();
  if (rescale_) rescale_();
}

void PlotCanvas::paintEvent(QPaintEvent* event) {
  QCustomPlot::paintEvent(event);
  QPainter painter(this);
  if (owner_->hasFocus()) {
    painter.setPen(QPen(theme().accent, 2));
    painter.drawRect(rect().adjusted(1, 1, -1, -1));
  }
  if (band_.first == band_.second) return paintValues(painter);
  QColor fill = brush_ ? markColour(*brush_) : theme().text2;
  fill.setAlpha(brush_ ? 110 : 40);
  QRectF area(std::min(band_.first, band_.second), 0, std::abs(band_.second - band_.first), height());
  if (box_) area = QRectF(QPointF(area.left(), box_->top), QPointF(area.right(), box_->bottom));
  painter.fillRect(area, fill);
  painter.setPen(theme().text2);
  if (box_) painter.drawRect(area);
  painter.drawLine(area.topLeft(), area.bottomLeft());
  painter.drawLine(area.topRight(), area.bottomRight());
}

void PlotCanvas::paintValues(QPainter& painter) const {
  const int lane = axisRectIndex(pointer_);
  const auto& traces = *owner_->traces();
  if (lane < 0 || traces.empty() || pointer_.x() < TimeAxis::kLeft || pointer_.x() > width() - TimeAxis::kRight) return;
  const double time = axis_->toTime(pointer_.x(), width());
  const int first = firstChannel(lane);
  const ShownUnit unit = first == 0 ? ShownUnit{QStringLiteral("N"), 1.0, 0} : torqueUnit();
  const int decimals = (first == 0 ? 2 : 3) + unit.decimals;
  QStringList rows{timeText(time, traces.poses())};
  for (int c = 0; c < 3; ++c) {
    const auto read = [&](WrenchTraces::Kind kind) {
      const double value = traces.valueAt(kind, first + c, time);
      return std::isfinite(value) ? numberText(unit.scale * value, decimals) : QString(QChar(0x2013));
    };
    const QString name = QString(QChar('x' + c));
    rows << (isDifference(lane) ? QStringLiteral("%1  %2").arg(name, read(WrenchTraces::Kind::difference))
             : traces.hasSimulated()
                 ? QStringLiteral("%1  %2  (%3)")
                       .arg(name, read(WrenchTraces::Kind::measured), read(WrenchTraces::Kind::simulated))
                 : QStringLiteral("%1  %2").arg(name, read(WrenchTraces::Kind::measured)));
  }
  painter.setFont(uiFont(type::kCaption));
  const QFontMetrics metrics(painter.font());
  int wide = 0;
  for (const QString& row : rows) wide = std::max(wide, metrics.horizontalAdvance(row));
  const int line = metrics.height(), high = line * static_cast<int>(rows.size()) + 10;
  QRect box(pointer_ + QPoint(14, -high / 2), QSize(wide + 18, high));
  if (box.right() > width() - TimeAxis::kRight) box.moveRight(pointer_.x() - 14);
  box.moveTop(std::clamp(box.top(), 2, std::max(2, height() - high - 2)));
  const Theme& t = theme();
  QColor ground = t.panel;
  ground.setAlpha(235);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(t.line, 1));
  painter.setBrush(ground);
  painter.drawRoundedRect(box, 6, 6);
  for (int r = 0; r < rows.size(); ++r) {
    painter.setPen(r == 0 ? t.text2 : t.axis[static_cast<std::size_t>(r - 1)]);
    painter.drawText(QRect(box.left() + 9, box.top() + 5 + r * line, wide, line), Qt::AlignLeft | Qt::AlignVCenter,
                     rows[r]);
  }
}

int PlotCanvas::axisRectIndex(const QPoint& at) const {
  for (int lane = 0; lane < axisRectCount(); ++lane)
    if (axisRect(lane)->visible() && axisRect(lane)->rect().contains(at)) return lane;
  return -1;
}

std::optional<PlotCanvas::Box> PlotCanvas::boxTo(const QPoint& at) const {
  constexpr int kLeast = 16;  // [px] A hand that draws a level line stays below it.
  const int lane = axisRectIndex(pressed_);
  if (lane < 0) return std::nullopt;
  const QRect room = axisRect(lane)->rect();
  if (std::abs(at.y() - pressed_.y()) < std::max(kLeast, room.height() / 3)) return std::nullopt;
  const int end = std::clamp(at.y(), room.top(), room.bottom());
  return Box{lane, std::min(pressed_.y(), end), std::max(pressed_.y(), end)};
}

void PlotCanvas::showValues(int lane, double lower, double upper) {
  if (!(upper > lower)) return;
  values_[static_cast<std::size_t>(lane)] = QCPRange(lower, upper);
  if (rescale_) rescale_();
}

}  // namespace heft
