#include "ui/reality_cards/card_parts.h"

#include <QPainter>
#include <algorithm>

#include "ui/models/glossary.h"
#include "ui/theme/icons.h"
#include "ui/theme/theme.h"

namespace heft {
namespace {

class GainBars : public QWidget {
 public:
  GainBars(const UnseenError& unseen, QWidget* parent)
      : QWidget(parent), unseen_(unseen), before_(unseen.before), after_(unseen.after), noise_(unseen.noise) {
    setFixedHeight(46);
    setAccessibleName(CardWords::tr("Held-out error %1 before, %2 after, noise floor %3")
                          .arg(unseen.text(before_), unseen.text(after_), unseen.text(noise_)));
    setToolTip(CardWords::tr("Root mean square of the residual on segments that were not used for fitting.") +
               QStringLiteral("\n") + glossaryTip("held_out"));
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter p(this);
    p.setRenderHint(QPainter::Antialiasing);
    const Theme& t = theme();
    p.setFont(uiFont(type::kCaption));
    const QFontMetrics metrics(p.font());
    const QString words[] = {CardWords::tr("before"), CardWords::tr("after")};
    const int left = std::max(metrics.horizontalAdvance(words[0]), metrics.horizontalAdvance(words[1])) + 10;
    QFont bold = uiFont(type::kCaption, QFont::DemiBold);
    const double most = std::max({before_, after_, noise_, 1e-12}), full = width() - left - 90.0;
    const double values[] = {before_, after_};
    for (int i = 0; i < 2; ++i) {
      const double y = 4 + 22 * i;
      p.setFont(uiFont(type::kCaption));
      p.setPen(t.text2);
      p.drawText(QRectF(0, y - 2, left, 18), Qt::AlignVCenter | Qt::AlignLeft, words[i]);
      p.setPen(Qt::NoPen);
      p.setBrush(i == 0 ? t.text3 : t.accent);
      const double length = std::max(3.0, full * values[i] / most);
      p.drawRoundedRect(QRectF(left, y, length, 14), 3, 3);
      p.setPen(t.text);
      p.setFont(bold);
      p.drawText(QRectF(left + length + 8, y - 2, 90, 18), Qt::AlignVCenter | Qt::AlignLeft, unseen_.text(values[i]));
      p.setBrush(Qt::NoBrush);
    }
    QPen dash(t.text, 1.3);
    dash.setDashPattern({2.5, 2.0});
    p.setPen(dash);
    const double x = left + full * noise_ / most;
    p.drawLine(QPointF(x, 0), QPointF(x, height()));
  }

 private:
  UnseenError unseen_;
  double before_, after_, noise_;
};

}  // namespace

QWidget* makeVerdictTag(const QString& text, Light light, bool accent, QWidget* parent) {
  auto* tag = new QFrame(parent);
  tag->setObjectName(accent                      ? "verdictAccent"
                     : light == Light::measured  ? "verdictGood"
                     : light == Light::twoCauses ? "verdictLook"
                                                 : "verdictQuiet");
  auto* row = new QHBoxLayout(tag);
  row->setContentsMargins(7, 2, 8, 2);
  row->setSpacing(6);
  if (accent) {
    auto* icon = new QLabel(tag);
    icon->setPixmap(iconPixmap("check", 14, theme().accent, theme().accentTint, 2.0));
    row->addWidget(icon);
  } else {
    row->addWidget(new LightIcon(light, 14, tag));
  }
  row->addWidget(styledLabel(text, "verdictWord", tag));
  tag->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  tag->setAccessibleName(text);
  return tag;
}

QHBoxLayout* tagRow(QWidget* tag, const QString& right, const QString& tip, QWidget* parent) {
  auto* row = new QHBoxLayout;
  row->addWidget(tag);
  row->addStretch(1);
  // May break: other languages need more room.
  QLabel* word = wrappedLabel(right, "caption", parent);
  word->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  word->setToolTip(tip);
  row->addWidget(word, 3);
  return row;
}

QPushButton* makeButton(const QString& text, const char* name, QWidget* parent) {
  auto* button = new QPushButton(text, parent);
  button->setObjectName(name);
  return button;
}

QLabel* boldFirst(const QString& bold, const QString& rest, QWidget* parent) {
  QLabel* label = wrappedLabel({}, "caption", parent);
  label->setTextFormat(Qt::RichText);
  label->setText(QStringLiteral("<b>%1</b> %2").arg(bold.toHtmlEscaped(), rest.toHtmlEscaped()));
  return label;
}

QWidget* makeGainBars(const UnseenError& unseen, QWidget* parent) { return new GainBars(unseen, parent); }

}  // namespace heft
