#include "ui/wrench_plots/channel_lanes.h"

#include <QEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/charts/chart.h"
#include "ui/models/numbers.h"
#include "ui/theme/theme.h"
#include "ui/timeline/time_axis.h"
#include "ui/timeline/time_mouse.h"
#include "ui/wrench_plots/trace_raster.h"
#include "ui/wrench_plots/wrench_traces.h"

namespace heft {
namespace {

constexpr int kLaneHeight = 74, kChannelGap = 6;  ///< [px]

/// Seven that colour-blind people can tell apart; further joints start over.
QColor channelColour(std::size_t index) {
  const Theme& t = theme();
  const QColor colours[] = {t.axis[0], t.axis[1], t.axis[2], t.markContact, t.text3, t.markFree, t.text};
  return colours[index % std::size(colours)];
}

QString readingText(double value) {
  if (!std::isfinite(value)) return QString(QChar(0x2013));
  const double size = std::abs(value);
  return numberText(value, size >= 100 ? 1 : size >= 1 ? 2 : 4);
}

}  // namespace

ChannelLanes::ChannelLanes(TimeAxis* axis, QWidget* parent)
    : QWidget(parent), axis_(axis), mouse_(new TimeMouse(axis, this)) {
  setObjectName("channelLanes");
  setAccessibleName(tr("Further channels over time"));
  connect(axis_, &TimeAxis::visibleChanged, this, qOverload<>(&QWidget::update));
  connect(mouse_, &TimeMouse::timePicked, this, &ChannelLanes::timePicked);
}

void ChannelLanes::setRecording(std::shared_ptr<const Recording> recording, std::shared_ptr<const RobotModel> robot) {
  recording_ = std::move(recording);
  robot_ = std::move(robot);
  forward_.reset();
  if (!recording_ || !robot_ || recording_->hasPosition() || recording_->hasOrientation() ||
      recording_->q.cols() != robot_->dof())
    robot_.reset();
  channels_ = recording_ ? channelsOf(*recording_, robot_ != nullptr) : std::vector<Channel>();
  time_ = recording_ ? timesOf(*recording_) : std::vector<double>();
  gap_ = recording_ ? longestJoined(*recording_, time_) : 0.0;
  rebuild();
}

void ChannelLanes::setChosen(const QStringList& ids) {
  chosen_ = ids;
  rebuild();
  emit chosenChanged();
}

void ChannelLanes::choose(const QString& id, bool chosen) {
  if (chosen == isChosen(id)) return;
  QStringList now = chosen_;
  chosen ? now.append(id) : static_cast<void>(now.removeAll(id));
  setChosen(now);
}

void ChannelLanes::rebuild() {
  lanes_.clear();
  for (const Channel& channel : channels_) {
    if (!chosen_.contains(channel.id)) continue;
    std::vector<double> values = channelValues(*recording_, channel.id);
    if (values.empty() && robot_) {
      if (!forward_) forward_ = std::make_shared<const Recording>(forwardPoses(*recording_, *robot_));
      values = channelValues(*forward_, channel.id);
    }
    if (values.size() < time_.size()) values.resize(time_.size(), std::nan(""));
    values.resize(time_.size());
    // Columns without a unit have nothing to share a scale for.
    auto lane = std::find_if(lanes_.begin(), lanes_.end(),
                             [&](const Lane& each) { return !channel.unit.isEmpty() && each.unit == channel.unit; });
    if (lane == lanes_.end()) lane = lanes_.insert(lanes_.end(), Lane{channel.unit, {}});
    lane->curves.push_back({channel, MinMaxPyramid(values)});
  }
  setMinimumHeight(lanes() * kLaneHeight * 2 / 3);
  setMaximumHeight(std::max(1, lanes()) * kLaneHeight * 2);
  updateGeometry();
  update();
}

MinMax ChannelLanes::laneRange(int lane) const {
  MinMax range{std::nan(""), std::nan("")};
  const auto begin = std::lower_bound(time_.begin(), time_.end(), axis_->lower()) - time_.begin();
  const auto end = std::upper_bound(time_.begin(), time_.end(), axis_->upper()) - time_.begin();
  for (const Curve& curve : lanes_[static_cast<std::size_t>(lane)].curves) {
    const MinMax one = curve.values.range(static_cast<std::size_t>(begin), static_cast<std::size_t>(end));
    range.lowest = std::fmin(range.lowest, one.lowest);
    range.highest = std::fmax(range.highest, one.highest);
  }
  if (!std::isfinite(range.lowest)) return {-1.0, 1.0};
  const double least = 1e-3 * std::max(1.0, std::abs(range.highest));  // A channel that stands still is a line.
  const double margin = std::max(0.08 * (range.highest - range.lowest), least);
  return {range.lowest - margin, range.highest + margin};
}

QRectF ChannelLanes::areaOf(int lane) const {
  const double high = static_cast<double>(height()) / std::max(1, lanes());
  return QRectF(TimeAxis::kLeft, lane * high + 0.5 * kChannelGap, width() - TimeAxis::kLeft - TimeAxis::kRight,
                high - kChannelGap);
}

double ChannelLanes::valueAt(const Curve& curve, double time) const {
  if (time_.empty() || time < time_.front() || time > time_.back()) return std::nan("");
  const auto at = static_cast<std::size_t>(std::lower_bound(time_.begin(), time_.end(), time) - time_.begin());
  if (at == 0 || time_[at] == time) return curve.values[at];
  // A sample that was taken, not one between two.
  return curve.values[time - time_[at - 1] < time_[at] - time ? at - 1 : at];
}

void ChannelLanes::drawLane(QPainter& painter, int index) const {
  const Theme& t = theme();
  const Lane& lane = lanes_[static_cast<std::size_t>(index)];
  const QRectF area = areaOf(index);
  const MinMax range = laneRange(index);
  const double slope = -area.height() / (range.highest - range.lowest);
  const auto y = [&](double value) { return area.bottom() + slope * (value - range.lowest); };
  painter.setFont(uiFont(type::kTick));
  const std::vector<double> ticks = ticksBetween(range.lowest, range.highest, 3);
  const int decimals =
      ticks.size() > 1 ? std::clamp(static_cast<int>(std::ceil(-std::log10(ticks[1] - ticks[0]) - 1e-9)), 0, 6) : 2;
  double before = area.bottom() + 20;
  for (const double tick : ticks) {
    constexpr double kNumber = 13.0;  // [px]
    if (y(tick) < area.top() + 5 || y(tick) > area.bottom() - 5 || before - y(tick) < kNumber) continue;
    before = y(tick);
    painter.setPen(QPen(std::abs(tick) < 1e-12 ? t.plotZero : t.plotGrid, 1));
    painter.drawLine(QPointF(area.left(), y(tick)), QPointF(area.right(), y(tick)));
    painter.setPen(t.text3);
    painter.drawText(QRectF(area.left() - 56, y(tick) - 8, 50, 16), Qt::AlignRight | Qt::AlignVCenter,
                     numberText(tick, decimals));
  }
  painter.setPen(QPen(t.line, 1));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(area);

  const double ratio = devicePixelRatioF();
  QImage picture((area.size() * ratio).toSize(), QImage::Format_ARGB32_Premultiplied);
  if (picture.isNull()) return;
  picture.fill(Qt::transparent);
  const TraceScale across{0.0 - ratio * (axis_->lower() * area.width() / axis_->span()),
                          ratio * area.width() / axis_->span()};
  const TraceScale up{ratio * (area.height() - slope * range.lowest), ratio * slope};
  for (std::size_t c = 0; c < lane.curves.size(); ++c) {
    TraceColumns columns(picture.width());
    addThinned(
        columns,
        thinned(time_, lane.curves[c].values, gap_, axis_->lower(), axis_->upper(), std::max(50, picture.width())),
        across, up);
    columns.paint(picture, channelColour(c), 1.4 * ratio);
  }
  picture.setDevicePixelRatio(ratio);
  painter.drawImage(area.topLeft(), picture);

  // Names in two columns where they are many; the unit with the first.
  painter.setFont(uiFont(type::kCaption, QFont::DemiBold));
  const int line = painter.fontMetrics().height();
  const int rows = std::max(1, static_cast<int>((area.height() + 2) / line));
  const bool two = static_cast<int>(lane.curves.size()) > rows;
  for (std::size_t c = 0; c < lane.curves.size(); ++c) {
    const int row = static_cast<int>(c) % rows, column = static_cast<int>(c) / rows;
    if (column > 1) break;  // The pointer names them all.
    QString text = lane.curves[c].channel.label;
    if (c == 0 && !lane.unit.isEmpty() && !two) text += QStringLiteral(" [%1]").arg(lane.unit);
    const int wide = two ? 30 : 62;
    painter.setPen(channelColour(c));
    painter.drawText(QRectF(12 + 31 * column, area.top() + row * line, wide, line), Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(text, Qt::ElideRight, wide));
  }
}

void ChannelLanes::drawPointer(QPainter& painter) const {
  const auto pointer = mouse_->pointer();
  if (!pointer) return;
  int lane = 0;
  while (lane < lanes() && !areaOf(lane).contains(*pointer)) ++lane;
  if (lane == lanes()) return;
  const double time = axis_->toTime(pointer->x(), width());
  const Lane& under = lanes_[static_cast<std::size_t>(lane)];
  QStringList rows{timeText(time, axis_->poses())};
  for (const Curve& curve : under.curves)
    rows << QStringLiteral("%1  %2 %3").arg(curve.channel.label, readingText(valueAt(curve, time)), under.unit);
  painter.setFont(uiFont(type::kCaption));
  int wide = 0;
  for (const QString& row : rows) wide = std::max(wide, painter.fontMetrics().horizontalAdvance(row));
  const int line = painter.fontMetrics().height(), high = line * static_cast<int>(rows.size()) + 10;
  QRect box(*pointer + QPoint(14, -high / 2), QSize(wide + 18, high));
  if (box.right() > width() - TimeAxis::kRight) box.moveRight(pointer->x() - 14);
  box.moveTop(std::clamp(box.top(), 2, std::max(2, height() - high - 2)));
  const Theme& t = theme();
  QColor ground = t.panel;
  ground.setAlpha(238);
  painter.setPen(QPen(t.line, 1));
  painter.setBrush(ground);
  painter.drawRoundedRect(box, 6, 6);
  for (int r = 0; r < rows.size(); ++r) {
    painter.setPen(r == 0 ? t.text2 : channelColour(static_cast<std::size_t>(r - 1)));
    painter.drawText(QRect(box.left() + 9, box.top() + 5 + r * line, wide, line), Qt::AlignLeft | Qt::AlignVCenter,
                     rows[r]);
  }
}

void ChannelLanes::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), theme().panel);
  for (int lane = 0; lane < lanes(); ++lane) drawLane(painter, lane);
  if (const auto band = mouse_->band()) {
    QColor fill = theme().text2;
    fill.setAlpha(40);
    painter.fillRect(QRect(band->first, 0, band->second - band->first, height()), fill);
  } else {
    drawPointer(painter);
  }
}

void ChannelLanes::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) update();
}

}  // namespace heft
