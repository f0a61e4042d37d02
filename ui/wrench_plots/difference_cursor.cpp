#include "ui/wrench_plots/difference_cursor.h"

#include <QEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/models/numbers.h"
#include "ui/models/units.h"
#include "ui/theme/theme.h"

namespace heft {

namespace {

constexpr std::size_t kMostSamples = 2000;  ///< Of a long segment every n-th, since this is drawn with every move.

/// Between two instants: the mean of what was measured, and the root mean square of the residual.
struct Between {
  double mean = std::nan(""), residual = std::nan("");
};
Between between(const WrenchTraces& traces, int channel, const std::vector<double>& times) {
  const std::size_t step = times.size() / kMostSamples + 1;
  double sum = 0.0, squares = 0.0;
  int measured = 0, compared = 0;
  for (std::size_t k = 0; k < times.size(); k += step) {
    const double value = traces.valueAt(WrenchTraces::Kind::measured, channel, times[k]);
    const double left = traces.valueAt(WrenchTraces::Kind::difference, channel, times[k]);
    if (std::isfinite(value)) sum += value, ++measured;
    if (std::isfinite(left)) squares += left * left, ++compared;
  }
  Between out;
  if (measured > 0) out.mean = sum / measured;
  if (compared > 0) out.residual = std::sqrt(squares / compared);
  return out;
}

QString orNothing(double value, int decimals) {
  return std::isfinite(value) ? numberText(value, decimals) : QStringLiteral("–");
}

}  // namespace

std::vector<QStringList> cursorTable(const WrenchTraces& traces, double first, double second) {
  std::vector<QStringList> rows;
  const std::vector<double> times = traces.timesWithin(std::min(first, second), std::max(first, second));
  rows.push_back({QString(), DifferenceCursor::tr("A"), DifferenceCursor::tr("B"), DifferenceCursor::tr("B − A"),
                  DifferenceCursor::tr("mean"), DifferenceCursor::tr("RMS residual")});
  const int timeDecimals = traces.poses() ? 0 : 3;
  const QString rate = traces.poses() || first == second
                           ? QString()
                           : DifferenceCursor::tr("1/Δt %1 Hz").arg(numberText(1.0 / std::abs(second - first), 2));
  rows.push_back({traces.poses() ? DifferenceCursor::tr("pose") : DifferenceCursor::tr("time [s]"),
                  numberText(first, timeDecimals), numberText(second, timeDecimals),
                  numberText(second - first, timeDecimals), QString(), rate});
  static constexpr const char* kNames[6] = {"Fx", "Fy", "Fz", "Tx", "Ty", "Tz"};
  const ShownUnit torque = torqueUnit();
  for (int c = 0; c < 6; ++c) {
    const ShownUnit unit = c < 3 ? ShownUnit{QStringLiteral("N"), 1.0, 0} : torque;
    const int decimals = (c < 3 ? 2 : 3) + unit.decimals;
    const double a = unit.scale * traces.valueAt(WrenchTraces::Kind::measured, c, first);
    const double b = unit.scale * traces.valueAt(WrenchTraces::Kind::measured, c, second);
    const Between all = between(traces, c, times);
    rows.push_back({QStringLiteral("%1 [%2]").arg(QLatin1String(kNames[c]), unit.name), numberText(a, decimals),
                    numberText(b, decimals), numberText(b - a, decimals), orNothing(unit.scale * all.mean, decimals),
                    orNothing(unit.scale * all.residual, decimals + 1)});
  }
  return rows;
}

DifferenceCursor::DifferenceCursor(TimeAxis* axis, QWidget* parent, int bottomInset)
    : QWidget(parent), axis_(axis), bottomInset_(bottomInset), traces_(std::make_shared<WrenchTraces>()) {
  setObjectName("differenceCursor");
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  setFocusPolicy(Qt::NoFocus);
  parent->installEventFilter(this);
  setGeometry(parent->rect());
  hide();
  connect(axis_, &TimeAxis::visibleChanged, this, [this] { update(); });
}

void DifferenceCursor::setTraces(std::shared_ptr<const WrenchTraces> traces) {
  traces_ = traces ? std::move(traces) : std::make_shared<WrenchTraces>();
  update();
}

void DifferenceCursor::setFirst(double time) {
  first_ = time;
  update();
}

void DifferenceCursor::setSecond(double time) {
  second_ = std::clamp(time, axis_->fullLower(), axis_->fullUpper());
  update();
}

bool DifferenceCursor::eventFilter(QObject* watched, QEvent* event) {
  if (watched == parentWidget() && event->type() == QEvent::Resize) {
    setGeometry(parentWidget()->rect());
    raise();
  }
  return QWidget::eventFilter(watched, event);
}

void DifferenceCursor::paintEvent(QPaintEvent*) {
  if (traces_->empty()) return;
  const Theme& t = theme();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double first = std::round(axis_->toX(first_, width())) + 0.5;
  const double second = std::round(axis_->toX(second_, width())) + 0.5;
  const bool visible = second_ >= axis_->lower() && second_ <= axis_->upper();
  QColor between = t.text2;
  between.setAlpha(22);
  painter.save();
  painter.setClipRect(QRect(TimeAxis::kLeft, 0, width() - TimeAxis::kLeft - TimeAxis::kRight, height() - bottomInset_));
  painter.fillRect(QRectF(std::min(first, second), 0, std::abs(second - first), height()), between);
  painter.restore();
  painter.setFont(uiFont(type::kCaption, QFont::DemiBold));
  const auto flag = [&](double x, const QString& text) {
    const QRectF box(x - 9, height() - bottomInset_ - 22, 18, 18);
    painter.setPen(Qt::NoPen);
    painter.setBrush(t.text);
    painter.drawRoundedRect(box, 4, 4);
    painter.setPen(t.panel);
    painter.drawText(box, Qt::AlignCenter, text);
  };
  if (visible) {
    QPen pen(t.text, 1.4);
    pen.setDashPattern({4.0, 3.0});
    painter.setPen(pen);
    painter.drawLine(QPointF(second, 2), QPointF(second, height() - bottomInset_));
    flag(second, tr("B"));
  }
  if (first_ >= axis_->lower() && first_ <= axis_->upper()) flag(first, tr("A"));

  const std::vector<QStringList> rows = cursorTable(*traces_, first_, second_);
  constexpr int kRow = 17, kName = 64, kCell = 62, kLastCell = 92, kPad = 8;
  constexpr double kMostOfWidth = 0.5;  // Where the plots are narrow, only the cursors.
  const int small = kName + 3 * kCell + 2 * kPad, whole = small + kCell + kLastCell;
  const bool all = whole < kMostOfWidth * width();
  const int wide = all ? whole : small, columns = all ? 6 : 4, high = kRow * static_cast<int>(rows.size()) + 2 * kPad;
  // On the side where neither line stands.
  const double middle = (TimeAxis::kLeft + width()) / 2.0;
  const bool left = first > middle && second > middle;
  const QRectF box(left ? TimeAxis::kLeft + 8 : width() - TimeAxis::kRight - wide - 8, 28, wide, high);
  painter.setPen(QPen(t.line, 1));
  QColor ground = t.panel;
  ground.setAlpha(240);
  painter.setBrush(ground);
  painter.drawRoundedRect(box, 6, 6);
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const double top = box.top() + kPad + kRow * static_cast<double>(r);
    for (int c = 0; c < columns; ++c) {
      painter.setFont(uiFont(type::kCaption, r == 0 || c == 3 ? QFont::DemiBold : QFont::Normal));
      painter.setPen(c == 0 ? t.text2 : t.text);
      const QRectF cell(box.left() + kPad + (c == 0 ? 0 : kName + (c - 1) * kCell), top,
                        c == 0   ? kName
                        : c == 5 ? kLastCell
                                 : kCell,
                        kRow);
      painter.drawText(cell, (c == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter, rows[r][c]);
    }
  }
}

}  // namespace heft
