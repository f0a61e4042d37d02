#include "ui/widgets/choice_card.h"

#include <QPainter>

#include "ui/theme/theme.h"

namespace heft {

ChoiceCard::ChoiceCard(const QString& name, const QString& detail, QWidget* parent)
    : QAbstractButton(parent), detail_(detail) {
  setText(name);
  setCheckable(true);
  setFocusPolicy(Qt::TabFocus);
  setCursor(Qt::PointingHandCursor);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(name);
  setAccessibleDescription(detail);
}

void ChoiceCard::paintEvent(QPaintEvent*) {
  const Theme& t = theme();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const bool chosen = isChecked();
  painter.setPen(QPen(chosen || hasFocus() ? t.accent
                      : underMouse()       ? t.fieldEdge
                                           : t.line,
                      chosen || hasFocus() ? 2 : 1));
  painter.setBrush(chosen ? t.accentTint : t.panel);
  painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 7, 7);
  // The chosen one has an outline anyway: an inner line shows that it has the keyboard focus.
  if (chosen && hasFocus()) {
    painter.setPen(QPen(t.accent, 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(QRectF(rect()).adjusted(4.5, 4.5, -4.5, -4.5), 4, 4);
  }
  const QRect text = rect().adjusted(11, 8, -6, -7);
  const QFont nameFont = uiFont(type::kSection, QFont::DemiBold), detailFont = uiFont(type::kCaption);
  painter.setFont(nameFont);
  painter.setPen(t.text);
  painter.drawText(text, Qt::AlignLeft | Qt::AlignTop,
                   QFontMetrics(nameFont).elidedText(QAbstractButton::text(), Qt::ElideRight, text.width()));
  painter.setFont(detailFont);
  painter.setPen(t.text2);
  painter.drawText(text, Qt::AlignLeft | Qt::AlignBottom,
                   QFontMetrics(detailFont).elidedText(detail_, Qt::ElideRight, text.width()));
}

}  // namespace heft
