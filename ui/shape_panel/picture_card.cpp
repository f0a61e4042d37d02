#include "ui/shape_panel/picture_card.h"

#include <QPainter>
#include <QPainterPath>

#include "ui/theme/icons.h"
#include "ui/theme/theme.h"

namespace heft {
namespace {

/// Three shades and an edge of the tool's blue.
struct Shades {
  QColor top, front, side, edge;
};

Shades shades() {
  const Theme& t = theme();
  const auto mixed = [&](double share) {
    const QColor a = t.tool, b = t.panel;
    return QColor::fromRgbF(share * a.redF() + (1 - share) * b.redF(), share * a.greenF() + (1 - share) * b.greenF(),
                            share * a.blueF() + (1 - share) * b.blueF());
  };
  return {mixed(0.28), mixed(0.42), mixed(0.60), t.dark ? t.axis[2] : QColor("#2B6F97")};
}

/// Draws in a square of 40 by 40.
class Drawing {
 public:
  Drawing(QPainter& painter) : p_(painter), s_(shades()) {
    p_.setPen(QPen(s_.edge, 1.3, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  }
  void fill(const QColor& colour, const QPainterPath& path) {
    p_.setBrush(colour);
    p_.drawPath(path);
  }
  /// Front face at (x, y) of w by h, depth going up to the right.
  void box(double x, double y, double w, double h, double dx, double dy) {
    poly(s_.front, {{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}});
    poly(s_.top, {{x, y}, {x + dx, y - dy}, {x + w + dx, y - dy}, {x + w, y}});
    poly(s_.side, {{x + w, y}, {x + w + dx, y - dy}, {x + w + dx, y + h - dy}, {x + w, y + h}});
  }
  void cylinder(double cx, double top, double bottom, double r, double flat, bool hole = false) {
    QPainterPath wall;
    wall.moveTo(cx - r, top);
    wall.lineTo(cx - r, bottom);
    wall.arcTo(QRectF(cx - r, bottom - flat, 2 * r, 2 * flat), 180, 180);
    wall.lineTo(cx + r, top);
    wall.closeSubpath();
    fill(s_.front, wall);
    p_.setBrush(s_.top);
    p_.drawEllipse(QPointF(cx, top), r, flat);
    if (!hole) return;
    p_.setBrush(s_.side);
    p_.drawEllipse(QPointF(cx, top), 0.55 * r, 0.55 * flat);
  }
  void ball(double cx, double cy, double r) {
    p_.setBrush(s_.front);
    p_.drawEllipse(QPointF(cx, cy), r, r);
    p_.setBrush(Qt::NoBrush);
    p_.drawArc(QRectF(cx - r, cy - 0.32 * r, 2 * r, 0.64 * r), 180 * 16, 180 * 16);
  }
  void cone() {
    QPainterPath wall;
    wall.moveTo(20, 3);
    wall.lineTo(8, 32);
    wall.arcTo(QRectF(8, 28, 24, 8), 180, 180);
    wall.closeSubpath();
    fill(s_.front, wall);
    dashed();
    p_.drawArc(QRectF(8, 28, 24, 8), 0, 180 * 16);
  }
  void capsule() {
    QPainterPath wall;
    wall.addRoundedRect(QRectF(11, 2, 18, 36), 9, 9);
    fill(s_.front, wall);
    p_.drawArc(QRectF(11, 8, 18, 6), 180 * 16, 180 * 16);
    p_.drawArc(QRectF(11, 26, 18, 6), 180 * 16, 180 * 16);
  }
  void plate() { box(2, 24, 26, 4, 10, 10); }
  void mesh() {
    const QPointF c(20, 19);
    const QPointF rim[] = {{20, 2}, {35, 10}, {36, 26}, {22, 37}, {6, 30}, {4, 12}};
    const QColor tones[] = {s_.top, s_.front, s_.side, s_.front, s_.side, s_.top};
    for (int i = 0; i < 6; ++i) poly(tones[i], {rim[i], rim[(i + 1) % 6], c});
  }
  void poly(const QColor& colour, const QVector<QPointF>& points) {
    p_.setBrush(colour);
    p_.drawPolygon(QPolygonF(points));
  }

 private:
  void dashed() {
    QPen pen = p_.pen();
    pen.setStyle(Qt::DashLine);
    pen.setWidthF(1.0);
    p_.setPen(pen);
    p_.setBrush(Qt::NoBrush);
  }
  QPainter& p_;
  Shades s_;
};

void paintCard(QPainter& painter, const QAbstractButton& card, bool dashed) {
  const Theme& t = theme();
  painter.setRenderHint(QPainter::Antialiasing);
  const bool chosen = card.isChecked(), strong = chosen || card.hasFocus();
  QPen edge(strong ? t.accent : card.underMouse() ? t.text3 : dashed ? t.fieldEdge : t.line, strong ? 2 : 1);
  if (dashed && !strong) edge.setStyle(Qt::DashLine);
  painter.setPen(edge);
  painter.setBrush(chosen ? t.accentTint : card.underMouse() ? t.raised : t.panel);
  painter.drawRoundedRect(QRectF(card.rect()).adjusted(1, 1, -1, -1), 7, 7);
  if (!chosen) return;
  if (card.hasFocus()) {
    painter.setPen(QPen(t.accent, 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(QRectF(card.rect()).adjusted(4.5, 4.5, -4.5, -4.5), 4, 4);
  }
  const QPointF badge(card.width() - 14, 14);
  painter.setPen(Qt::NoPen);
  painter.setBrush(t.accentFill);
  painter.drawEllipse(badge, 7.5, 7.5);
  painter.drawPixmap(badge - QPointF(6, 6), iconPixmap("tick", 12, Qt::white, t.accentFill, card.devicePixelRatioF()));
}

void prepare(QAbstractButton* card, const QString& name) {
  card->setText(name);
  card->setAccessibleName(name);
  card->setCheckable(true);
  card->setFocusPolicy(Qt::TabFocus);
  card->setCursor(Qt::PointingHandCursor);
  card->setAttribute(Qt::WA_Hover);
  card->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

}  // namespace

void paintToolPicture(QPainter& painter, ToolPicture picture, const QRectF& place) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  const double scale = std::min(place.width(), place.height()) / 40.0;
  painter.translate(place.center() - QPointF(20, 20) * scale);
  painter.scale(scale, scale);
  Drawing draw(painter);
  switch (picture) {
    case ToolPicture::box:
      draw.box(4, 14, 23, 18, 9, 7);
      break;
    case ToolPicture::cylinder:
      draw.cylinder(20, 9, 31, 11, 5);
      break;
    case ToolPicture::tube:
      draw.cylinder(20, 9, 31, 11, 5, true);
      break;
    case ToolPicture::sphere:
      draw.ball(20, 20, 15);
      break;
    case ToolPicture::cone:
      draw.cone();
      break;
    case ToolPicture::capsule:
      draw.capsule();
      break;
    case ToolPicture::plate:
      draw.plate();
      break;
    case ToolPicture::gripper:
      draw.box(13, 25, 9, 12, 5, 4);
      draw.box(4, 9, 23, 14, 9, 6);
      break;
    case ToolPicture::several:
      draw.ball(27, 13, 9);
      draw.box(3, 17, 12, 10, 4, 4);
      draw.box(3, 27, 24, 10, 5, 4);
      break;
    case ToolPicture::mesh:
      draw.mesh();
      break;
  }
  painter.restore();
}

PictureCard::PictureCard(ToolPicture picture, const QString& name, QWidget* parent)
    : QAbstractButton(parent), picture_(picture) {
  prepare(this, name);
}

void PictureCard::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  paintCard(painter, *this, false);
  paintToolPicture(painter, picture_, QRectF(0, 9, width(), 32));
  painter.setFont(uiFont(type::kSection, isChecked() ? QFont::DemiBold : QFont::Medium));
  painter.setPen(theme().text);
  const QRect text(4, 44, width() - 8, height() - 48);
  painter.drawText(text, Qt::AlignCenter, painter.fontMetrics().elidedText(this->text(), Qt::ElideRight, text.width()));
}

NoPictureCard::NoPictureCard(const QString& name, const QString& detail, QWidget* parent)
    : QAbstractButton(parent), detail_(detail) {
  prepare(this, name);
  setAccessibleDescription(detail);
}

void NoPictureCard::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  paintCard(painter, *this, true);
  const Theme& t = theme();
  const QRect text = rect().adjusted(8, 10, -8, -10);
  painter.setFont(uiFont(type::kSection, QFont::DemiBold));
  painter.setPen(t.text);
  painter.drawText(QRect(text.left(), text.top(), text.width(), text.height() / 2), Qt::AlignCenter, this->text());
  painter.setFont(uiFont(type::kCaption));
  painter.setPen(t.text2);
  painter.drawText(QRect(text.left(), text.center().y(), text.width(), text.height() / 2 + 1),
                   Qt::AlignCenter | Qt::TextWordWrap, detail_);
}

}  // namespace heft
