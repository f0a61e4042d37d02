#include "ui/timeline/marks_bar.h"

#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "ui/models/numbers.h"
#include "ui/theme/icons.h"
#include "ui/theme/theme.h"

namespace heft {
namespace {

constexpr int kBarTop = 4, kBarHeight = 22, kEdgeReach = 5;

/// Text on a mark: dark on the light theme's pale colours; on the dark theme only the amber one is bright.
QColor markTextColour(MarkLabel label) {
  if (!theme().dark) return label == MarkLabel::free ? QColor("#0D4A6E") : QColor("#2B2410");
  return label == MarkLabel::contact ? QColor("#1F1803") : theme().text;
}

/// 1, 2 or 5 times a power of ten, so that about `wanted` ticks fit the span.
double tickStep(double span, double wanted, bool whole) {
  const double raw = span / std::max(1.0, wanted);
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  const double lead = raw / power;
  const double step = (lead <= 1 ? 1 : lead <= 2 ? 2 : lead <= 5 ? 5 : 10) * power;
  return whole ? std::max(1.0, std::round(step)) : step;
}

}  // namespace

const QColor& markColour(MarkLabel label) {
  const Theme& t = theme();
  return label == MarkLabel::free ? t.markFree : label == MarkLabel::contact ? t.markContact : t.markIgnored;
}

QString markWord(MarkLabel label) {
  switch (label) {
    case MarkLabel::free:
      return MarksBar::tr("free");
    case MarkLabel::contact:
      return MarksBar::tr("contact");
    case MarkLabel::ignore:
      return MarksBar::tr("ignored");
  }
  return {};
}

MarksBar::MarksBar(TimeAxis* axis, QWidget* parent) : QWidget(parent), axis_(axis) {
  setObjectName("marksBar");
  setAccessibleName(tr("Marks"));
  setAccessibleDescription(tr("Segments of the recording: free, contact or ignored"));
  setMouseTracking(true);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setFixedHeight(sizeHint().height());
  connect(axis_, &TimeAxis::visibleChanged, this, [this] { update(); });
}

void MarksBar::setSegments(std::vector<Segment> segments, std::vector<bool> suggested) {
  segments_ = std::move(segments);
  suggested_ = std::move(suggested);
  suggested_.resize(segments_.size(), false);
  edge_ = -1;
  update();
}

void MarksBar::setBrush(std::optional<MarkLabel> brush) {
  brush_ = brush;
  if (!brush_) {
    pressed_.reset();
    keyStroke_.reset();
    edge_ = -1;
    unsetCursor();
  }
  setFocusPolicy(brush_ ? Qt::StrongFocus : Qt::NoFocus);
  update();
}

void MarksBar::setSelected(std::optional<std::pair<double, double>> stretch) {
  selected_ = stretch;
  update();
}

void MarksBar::setTime(double time) {
  time_ = time;
  if (keyStroke_) update();
}

int MarksBar::edgeAt(int x) const {
  for (std::size_t i = 0; i + 1 < segments_.size(); ++i) {
    if (std::abs(segments_[i].to - segments_[i + 1].from) > 0.02) continue;
    if (segments_[i].label == segments_[i + 1].label) continue;
    if (std::abs(axis_->toX(segments_[i].to, width()) - x) <= kEdgeReach) return static_cast<int>(i);
  }
  return -1;
}

std::optional<MarksBar::Stroke> MarksBar::stroke() const {
  if (edge_ >= 0) {
    const Segment& left = segments_[static_cast<std::size_t>(edge_)];
    const Segment& right = segments_[static_cast<std::size_t>(edge_) + 1];
    const double was = left.to;
    return pointer_ < was ? Stroke{pointer_, was, right.label} : Stroke{was, pointer_, left.label};
  }
  if (!brush_) return std::nullopt;
  if (pressed_) return Stroke{std::min(*pressed_, pointer_), std::max(*pressed_, pointer_), *brush_};
  if (keyStroke_) return Stroke{std::min(*keyStroke_, time_), std::max(*keyStroke_, time_), *brush_};
  return std::nullopt;
}

void MarksBar::finishStroke() {
  const auto done = stroke();
  pressed_.reset();
  keyStroke_.reset();
  edge_ = -1;
  update();
  if (done && done->to - done->from > 1e-3) emit painted(done->from, done->to, done->label);
}

const Segment* MarksBar::segmentAt(const QPoint& point) const {
  if (point.y() < kBarTop || point.y() > kBarTop + kBarHeight) return nullptr;
  if (point.x() < TimeAxis::kLeft || point.x() > width() - TimeAxis::kRight) return nullptr;
  const double time = axis_->toTime(point.x(), width());
  for (const Segment& segment : segments_) {
    if (time >= segment.from && time <= segment.to) return &segment;
  }
  return nullptr;
}

QString MarksBar::describe(const Segment& segment) {
  QString text = QStringLiteral("%1, %2 – %3 s")
                     .arg(markWord(segment.label), numberText(segment.from, 1), numberText(segment.to, 1));
  if (!segment.reason.empty()) text += QStringLiteral(": ") + QString::fromStdString(segment.reason);
  return text;
}

void MarksBar::paintEvent(QPaintEvent*) {
  const Theme& t = theme();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), t.panel);
  painter.setFont(uiFont(type::kSection, QFont::DemiBold));
  painter.setPen(t.text);
  painter.drawText(QRect(12, kBarTop, TimeAxis::kLeft - 16, kBarHeight), Qt::AlignLeft | Qt::AlignVCenter, tr("Marks"));

  const QRectF bar(TimeAxis::kLeft, kBarTop, width() - TimeAxis::kLeft - TimeAxis::kRight, kBarHeight);
  painter.setPen(Qt::NoPen);
  painter.setBrush(t.raised);
  painter.drawRoundedRect(bar, 3, 3);
  if (segments_.empty() && axis_->poses()) {
    painter.setFont(uiFont(type::kCaption));
    painter.setPen(t.text2);
    painter.drawText(bar, Qt::AlignCenter, tr("standing poses, all used"));
  }
  painter.save();
  painter.setClipRect(bar);
  painter.setFont(uiFont(type::kCaption, QFont::DemiBold));
  for (std::size_t i = 0; i < segments_.size(); ++i) paintSegment(painter, bar, i);
  if (const auto now = stroke()) {
    const double left = axis_->toX(now->from, width()), right = axis_->toX(now->to, width());
    painter.setPen(QPen(t.accent, 2));
    painter.setBrush(markColour(now->label));
    painter.drawRoundedRect(QRectF(left, bar.top() + 1, std::max(2.0, right - left), bar.height() - 2), 3, 3);
  }
  painter.restore();
  if (selected_) {
    const double left = std::max(bar.left(), axis_->toX(selected_->first, width()));
    const double right = std::min(bar.right(), axis_->toX(selected_->second, width()));
    if (right > left) {
      painter.setPen(QPen(t.accent, 2));
      painter.setBrush(Qt::NoBrush);
      painter.drawRoundedRect(QRectF(left - 1, bar.top() - 2, right - left + 2, bar.height() + 4), 5, 5);
      painter.setBrush(t.panel);
      for (const double x : {left, right})
        painter.drawRoundedRect(QRectF(x - 4, bar.top() + 3, 7, bar.height() - 6), 3, 3);
    }
  }
  if (hasFocus()) {
    painter.setPen(QPen(t.accent, 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(QRectF(bar).adjusted(-3, -3, 3, 3), 5, 5);
  }
  paintTicks(painter, bar);
}

void MarksBar::paintSegment(QPainter& painter, const QRectF& bar, std::size_t index) const {
  const Segment& segment = segments_[index];
  const Theme& t = theme();
  const double left = std::max(axis_->toX(segment.from, width()), bar.left() - 8);
  const double right = std::min(axis_->toX(segment.to, width()), bar.right() + 8);
  if (right < bar.left() || left > bar.right()) return;
  // A gap of one pixel between neighbours; a sliver stays visible.
  const QRectF block(left + 0.5, bar.top(), std::max(1.0, right - left - 1.0), bar.height());
  const QColor& colour = markColour(segment.label);
  const bool suggested = suggested_[index];
  if (suggested) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(t.panel);
    painter.drawRoundedRect(block, 3, 3);
    painter.setBrush(QBrush(colour, Qt::BDiagPattern));
    painter.drawRoundedRect(block, 3, 3);
    QColor tint = colour;
    tint.setAlpha(90);
    painter.setBrush(tint);
    QPen edge(t.text, 1.2);
    edge.setDashPattern({3.0, 2.0});
    painter.setPen(edge);
    painter.drawRoundedRect(block.adjusted(0.6, 0.6, -0.6, -0.6), 3, 3);
  } else {
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawRoundedRect(block, 3, 3);
  }
  paintWord(painter, block.intersected(bar), segment.label, suggested);
}

/// "contact?", or where there is no room for it "contact" or its icon: never the colour alone.
void MarksBar::paintWord(QPainter& painter, const QRectF& shown, MarkLabel label, bool suggested) const {
  constexpr int kIcon = 14, kAround = 8;  // [px]
  const QString word = markWord(label);
  const auto wide = [&](const QString& text) { return painter.fontMetrics().horizontalAdvance(text); };
  QString text = suggested ? word + QLatin1Char('?') : word;
  bool icon = false;
  if (wide(text) + kAround > shown.width() && suggested) text = word;
  if (wide(text) + kAround > shown.width() && label != MarkLabel::free) {
    icon = true;
    text = suggested ? QStringLiteral("?") : QString();
    if (kIcon + wide(text) + kAround > shown.width()) text.clear();
  }
  const double needed = (icon ? kIcon : 0) + wide(text);
  if (needed + 4 > shown.width() || needed <= 0) return;
  const QColor colour = suggested ? theme().text : markTextColour(label);
  if (suggested) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme().panel);
    painter.drawRoundedRect(
        QRectF(shown.center().x() - needed / 2 - 3, shown.top() + 3, needed + 6, shown.height() - 6), 3, 3);
  }
  const QRectF place(shown.center().x() - needed / 2, shown.top(), needed, shown.height());
  if (icon)
    painter.drawPixmap(QRectF(place.left(), place.center().y() - kIcon / 2.0, kIcon, kIcon).toRect(),
                       iconPixmap(label == MarkLabel::contact ? "contact" : "hand", kIcon, colour, theme().panel,
                                  devicePixelRatioF()));
  painter.setPen(colour);
  painter.drawText(place, Qt::AlignRight | Qt::AlignVCenter, text);
}

void MarksBar::paintTicks(QPainter& painter, const QRectF& bar) const {
  const Theme& t = theme();
  painter.setFont(uiFont(type::kTick));
  painter.setPen(t.text3);
  const double step = tickStep(axis_->span(), bar.width() / 75.0, axis_->poses());
  const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
  bool first = true;
  // The last sample is a little before a round number.
  const double reach = axis_->upper() + std::max(1e-9 * step, 0.004 * axis_->span());
  for (double tick = std::ceil(axis_->lower() / step - 1e-9) * step; tick <= reach; tick += step) {
    const double x = axis_->toX(tick, width());
    QString text = numberText(tick, decimals);
    if (first) text = axis_->poses() ? tr("pose %1").arg(text) : text + QStringLiteral(" s");
    first = false;
    const double half = painter.fontMetrics().horizontalAdvance(text) / 2.0 + 2;
    const double centre = std::min(x, width() - half - 2);
    painter.drawText(QRectF(centre - half, kBarTop + kBarHeight + 4, 2 * half, 16), Qt::AlignCenter, text);
  }
}

void MarksBar::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  pointer_ = axis_->toTime(event->pos().x(), width());
  if (brush_) {
    edge_ = edgeAt(event->pos().x());
    if (edge_ < 0) pressed_ = pointer_;
    keyStroke_.reset();
  }
  emit timePicked(pointer_);
}

void MarksBar::mouseMoveEvent(QMouseEvent* event) {
  if (brush_ && !event->buttons()) setCursor(edgeAt(event->pos().x()) >= 0 ? Qt::SplitHCursor : Qt::CrossCursor);
  if (!(event->buttons() & Qt::LeftButton)) return;
  pointer_ = std::clamp(axis_->toTime(event->pos().x(), width()), axis_->fullLower(), axis_->fullUpper());
  if (pressed_ || edge_ >= 0) update();
  emit timePicked(pointer_);
}

void MarksBar::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || (!pressed_ && edge_ < 0)) return;
  // A click without a drag picks a time and paints nothing.
  const double began = pressed_ ? *pressed_ : edge_ >= 0 ? segments_[static_cast<std::size_t>(edge_)].to : pointer_;
  if (std::abs(axis_->toX(began, width()) - axis_->toX(pointer_, width())) < 3) {
    pressed_.reset();
    edge_ = -1;
    return update();
  }
  finishStroke();
}

void MarksBar::contextMenuEvent(QContextMenuEvent* event) {
  const Segment* under = segmentAt(event->pos());
  if (!under) return;
  const Segment segment = *under;
  QMenu menu(this);
  menu.setObjectName("marksMenu");
  menu.addAction(tr("Zoom to this segment"), axis_, [this, segment] {
    const double room = 0.1 * (segment.to - segment.from);
    axis_->show(segment.from - room, segment.to + room);
  });
  if (brush_) {
    menu.addSeparator();
    for (const MarkLabel label : {MarkLabel::free, MarkLabel::contact, MarkLabel::ignore}) {
      QAction* action = menu.addAction(tr("Mark as %1").arg(markWord(label)), this,
                                       [this, segment, label] { emit painted(segment.from, segment.to, label); });
      action->setCheckable(true);
      action->setChecked(label == segment.label);
    }
  }
  menu.exec(event->globalPos());
}

void MarksBar::keyPressEvent(QKeyEvent* event) {
  if (!brush_) return QWidget::keyPressEvent(event);
  switch (event->key()) {
    case Qt::Key_1:
    case Qt::Key_2:
    case Qt::Key_3:
      emit brushPicked(static_cast<MarkLabel>(event->key() - Qt::Key_1));
      return;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (keyStroke_) {
        finishStroke();
      } else {
        keyStroke_ = time_;
        update();
      }
      return;
    case Qt::Key_Escape:
      keyStroke_.reset();
      update();
      return;
    default:
      QWidget::keyPressEvent(event);  // The window moves the time by the arrow keys.
  }
}

void MarksBar::focusOutEvent(QFocusEvent* event) {
  QWidget::focusOutEvent(event);
  keyStroke_.reset();
  update();
}

bool MarksBar::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    if (const Segment* segment = segmentAt(help->pos())) {
      QToolTip::showText(help->globalPos(), describe(*segment), this);
    } else {
      QToolTip::hideText();
    }
    return true;
  }
  return QWidget::event(event);
}

}  // namespace heft
