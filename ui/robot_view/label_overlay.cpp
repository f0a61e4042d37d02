#include "ui/robot_view/label_overlay.h"

#include <QPainter>
#include <algorithm>

#include "ui/theme/theme.h"

namespace heft {
namespace {
constexpr double kPadding = 8;
}

LabelOverlay::LabelOverlay(QWidget* parent) : QWidget(parent) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  setFocusPolicy(Qt::NoFocus);
}

void LabelOverlay::setLabels(std::vector<ViewLabel> labels, LabelRoom room) {
  labels_ = std::move(labels);
  std::sort(labels_.begin(), labels_.end(),
            [](const ViewLabel& a, const ViewLabel& b) { return a.anchor.y() < b.anchor.y(); });
  const QFontMetricsF title(uiFont(type::kCaption, QFont::DemiBold)), note(uiFont(type::kCaption));
  std::vector<LabelToPlace> wanted;
  for (const ViewLabel& label : labels_) {
    const double w = std::max(title.horizontalAdvance(label.title), note.horizontalAdvance(label.note)) + 2 * kPadding;
    const double h = (label.note.isEmpty() ? title.height() : title.height() + note.height()) + kPadding;
    wanted.push_back({label.anchor, QSizeF(w, h)});
  }
  room.picture = QSizeF(size());
  places_ = placeLabels(wanted, room, side_);
  update();
}

QStringList LabelOverlay::titles() const {
  QStringList out;
  for (const ViewLabel& label : labels_) out << label.title;
  return out;
}

void LabelOverlay::setAxisLetters(const std::array<QPointF, 3>& ends, bool shown) {
  axisEnds_ = ends;
  axesShown_ = shown;
  update();
}

void LabelOverlay::paintEvent(QPaintEvent*) {
  const Theme& t = theme();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (underlay_) underlay_(painter);
  for (std::size_t i = 0; i < places_.size(); ++i) {
    painter.setPen(QPen(t.text2, 1));
    painter.drawLine(labels_[i].anchor, leaderEnd(places_[i], labels_[i].anchor));
    painter.setPen(Qt::NoPen);
    painter.setBrush(t.text);
    painter.drawEllipse(labels_[i].anchor, 2.6, 2.6);
  }
  for (std::size_t i = 0; i < places_.size(); ++i) {
    painter.setPen(QPen(t.line, 1));
    painter.setBrush(t.panel);
    painter.drawRoundedRect(places_[i], 4, 4);
    const QRectF inner = places_[i].adjusted(kPadding, kPadding / 2, -kPadding, -kPadding / 2);
    painter.setFont(uiFont(type::kCaption, QFont::DemiBold));
    painter.setPen(t.text);
    painter.drawText(inner, Qt::AlignLeft | (labels_[i].note.isEmpty() ? Qt::AlignVCenter : Qt::AlignTop),
                     labels_[i].title);
    if (labels_[i].note.isEmpty()) continue;
    painter.setFont(uiFont(type::kCaption));
    painter.setPen(t.text2);
    painter.drawText(inner, Qt::AlignLeft | Qt::AlignBottom, labels_[i].note);
  }
  if (!axesShown_) return;
  painter.setFont(uiFont(type::kTick, QFont::Bold));
  for (int a = 0; a < 3; ++a) {
    painter.setPen(QPen(t.axis[a], 1.8));
    painter.setBrush(t.panel);
    painter.drawEllipse(axisEnds_[a], 8, 8);
    painter.setPen(t.text);
    painter.drawText(QRectF(axisEnds_[a] - QPointF(8, 9), QSizeF(16, 17)), Qt::AlignCenter, QString(QChar("xyz"[a])));
  }
}

}  // namespace heft
