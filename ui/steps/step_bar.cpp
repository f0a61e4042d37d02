#include "ui/steps/step_bar.h"

#include <QHBoxLayout>
#include <QPainter>

#include "ui/theme/icons.h"
#include "ui/theme/theme.h"

namespace heft {

StepButton::StepButton(Step step, int number, QWidget* parent) : QAbstractButton(parent), step_(step), number_(number) {
  setObjectName(QStringLiteral("step_") + QString::fromUtf8(stepId(step).data()));
  setFocusPolicy(Qt::TabFocus);
  setCursor(Qt::PointingHandCursor);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setText(stepName(step));
}

void StepButton::show(const StepState& state, Place place) {
  state_ = state;
  place_ = place;
  const bool light = state.progress == StepState::Progress::done || state.light == Light::look;
  const QString word = place == Place::now    ? tr("shown now")
                       : light                ? lightWord(state.light)
                       : place == Place::next ? tr("next")
                                              : tr("later");
  setAccessibleName(tr("Step %1, %2").arg(number_).arg(stepName(step_)));
  setAccessibleDescription(QStringLiteral("%1. %2").arg(state.line, word));
  setToolTip(tr("%1 (Alt+%2)").arg(stepName(step_)).arg(number_));
  update();
}

void StepButton::paintEvent(QPaintEvent*) {
  const Theme& t = theme();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const bool now = place_ == Place::now, next = place_ == Place::next;
  painter.fillRect(rect(), now ? t.accentTint : underMouse() ? t.raised : t.panel);
  painter.fillRect(QRect(0, height() - 1, width(), 1), t.line);
  painter.fillRect(QRect(width() - 1, 0, 1, height()), t.line);
  if (now) painter.fillRect(QRect(0, height() - 3, width(), 3), t.accent);

  // Where the bar is narrow, words take the room of the margins.
  const bool narrow = width() < 200;
  constexpr int kIcon = 22;
  const int iconLeft = narrow ? 10 : 18;
  const QRectF circle(iconLeft, (height() - kIcon) / 2.0, kIcon, kIcon);
  const bool done = state_.progress == StepState::Progress::done;
  const bool asks = state_.light == Light::look && state_.progress == StepState::Progress::ready;
  if (done || asks) {
    painter.drawPixmap(circle.topLeft(), lightPixmap(state_.light, kIcon, devicePixelRatioF()));
  } else {
    painter.setPen(now ? QPen(Qt::NoPen) : QPen(next ? t.accent : t.fieldEdge, next ? 1.8 : 1.3));
    painter.setBrush(now ? QBrush(t.accentFill) : QBrush(Qt::NoBrush));
    painter.drawEllipse(circle.adjusted(0.5, 0.5, -0.5, -0.5));
    painter.setFont(uiFont(type::kSection, QFont::DemiBold));
    painter.setPen(now ? QColor(Qt::white) : next ? t.accent : t.text3);
    painter.drawText(circle, Qt::AlignCenter, QString::number(number_));
  }

  const int left = iconLeft + kIcon + (narrow ? 8 : 12);
  const QRect text(left, 0, width() - left - (narrow ? 4 : 8), height());
  const QFont nameFont = uiFont(15, QFont::DemiBold), lineFont = uiFont(type::kCaption);
  const bool quiet = !done && !now && !next && !asks;
  painter.setFont(nameFont);
  painter.setPen(quiet ? t.text2 : t.text);
  painter.drawText(text.adjusted(0, 12, 0, 0), Qt::AlignLeft | Qt::AlignTop,
                   QFontMetrics(nameFont).elidedText(stepName(step_), Qt::ElideRight, text.width()));
  painter.setFont(lineFont);
  painter.setPen(next && !done && !asks ? t.accent : quiet ? t.text3 : t.text2);
  painter.drawText(text.adjusted(0, 33, 0, 0), Qt::AlignLeft | Qt::AlignTop,
                   QFontMetrics(lineFont).elidedText(state_.line, Qt::ElideRight, text.width()));
  if (hasFocus()) {
    painter.setPen(QPen(t.accent, 2));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(QRectF(rect()).adjusted(2, 2, -3, -4), 4, 4);
  }
}

StepBar::StepBar(QWidget* parent) : QWidget(parent) {
  setObjectName("stepBar");
  setAccessibleName(tr("Steps"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
}

void StepBar::addStep(Step step) {
  auto* button = new StepButton(step, static_cast<int>(step) + 1, this);
  layout()->addWidget(button);
  buttons_[step] = button;
  connect(button, &QAbstractButton::clicked, this, [this, step] { emit stepWanted(step); });
  refresh();
}

void StepBar::setState(Step step, const StepState& state) {
  states_[step] = state;
  refresh();
}

void StepBar::setNow(Step step) {
  now_ = step;
  refresh();
}

void StepBar::refresh() {
  // Next is the first step after the present one that could be done and is not.
  std::optional<Step> next;
  for (const Step step : buttons_.keys()) {
    if (step > now_ && states_[step].progress == StepState::Progress::ready) {
      next = step;
      break;
    }
  }
  for (auto it = buttons_.constBegin(); it != buttons_.constEnd(); ++it) {
    it.value()->show(states_[it.key()], it.key() == now_   ? StepButton::Place::now
                                        : it.key() == next ? StepButton::Place::next
                                                           : StepButton::Place::other);
  }
}

}  // namespace heft
