#include "ui/widgets/basics.h"

#include <QCoreApplication>
#include <QEvent>
#include <QLineEdit>
#include <QPainter>
#include <QStyle>
#include <QVBoxLayout>
#include <QVariant>

#include "ui/theme/icons.h"
#include "ui/theme/theme.h"

namespace heft {
namespace {

QString lightIconName(Light light) {
  switch (light) {
    case Light::measured:
      return "light_measured";
    case Light::partly:
      return "light_partly";
    case Light::unknown:
      return "light_unknown";
    case Light::look:
      return "light_look";
    case Light::twoCauses:
      return "light_two_causes";
    case Light::notPossible:
      return "light_not_possible";
    case Light::info:
      return "info";
  }
  return {};
}

QColor lightColour(Light light) {
  const Theme& t = theme();
  switch (light) {
    case Light::measured:
      return t.good;
    case Light::partly:
    case Light::look:
    case Light::twoCauses:
      return t.look;
    case Light::notPossible:
      return t.bad;
    case Light::unknown:
    case Light::info:
      break;
  }
  return t.text3;
}

}  // namespace

IconButton::IconButton(const QString& icon, const QString& tip, QWidget* parent) : QToolButton(parent) {
  setFocusPolicy(Qt::TabFocus);
  setIconSize(QSize(20, 20));
  setIconName(icon, tip);
}

void IconButton::setIconName(const QString& icon, const QString& tip) {
  icon_ = icon;
  setIcon(themedIcon(icon_));
  setToolTip(tip);
  setAccessibleName(tip);
}

void IconButton::changeEvent(QEvent* event) {
  QToolButton::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) setIcon(themedIcon(icon_));
}

QString lightWord(Light light) {
  switch (light) {
    case Light::measured:
      return QCoreApplication::translate("heft", "measured");
    case Light::partly:
      return QCoreApplication::translate("heft", "partly measured");
    case Light::unknown:
      return QCoreApplication::translate("heft", "not known");
    case Light::look:
      return QCoreApplication::translate("heft", "look here");
    case Light::twoCauses:
      return QCoreApplication::translate("heft", "two causes");
    case Light::notPossible:
      return QCoreApplication::translate("heft", "not possible");
    case Light::info:
      return QCoreApplication::translate("heft", "note");
  }
  return {};
}

QPixmap lightPixmap(Light light, int size, qreal devicePixelRatio) {
  return iconPixmap(lightIconName(light), size, lightColour(light), theme().panel, devicePixelRatio);
}

LightIcon::LightIcon(Light light, int size, QWidget* parent) : QWidget(parent), light_(light), size_(size) {
  setFixedSize(size, size);
  setLight(light);
}

void LightIcon::setLight(Light light) {
  light_ = light;
  setAccessibleName(lightWord(light));
  update();
}

void LightIcon::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.drawPixmap(0, 0, lightPixmap(light_, size_, devicePixelRatioF()));
}

IconLabel::IconLabel(const QString& icon, int size, QWidget* parent) : QWidget(parent), icon_(icon), size_(size) {
  setFixedSize(size, size);
}

void IconLabel::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.drawPixmap(0, 0, iconPixmap(icon_, size_, theme().text, theme().panel, devicePixelRatioF()));
}

QLabel* styledLabel(const QString& text, const char* style, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setObjectName(style);
  label->setTextFormat(Qt::PlainText);
  return label;
}

QLabel* wrappedLabel(const QString& text, const char* style, QWidget* parent) {
  QLabel* label = styledLabel(text, style, parent);
  label->setWordWrap(true);
  return label;
}

void dimPlaceholder(QLineEdit* field) {
  const auto mark = [field] {
    field->setProperty("empty", field->text().isEmpty());
    field->style()->unpolish(field);
    field->style()->polish(field);
  };
  QObject::connect(field, &QLineEdit::textChanged, field, [field, mark] {
    if (field->property("empty").toBool() != field->text().isEmpty()) mark();
  });
  mark();
}

AxisDot::AxisDot(int axis, QWidget* parent) : QLabel(parent), axis_(axis) {
  setFixedSize(8, 8);
  colour();
}

void AxisDot::changeEvent(QEvent* event) {
  QLabel::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) colour();
}

void AxisDot::colour() {
  const QString sheet = QStringLiteral("background: %1; border-radius: 4px;").arg(theme().axis[axis_].name());
  if (styleSheet() != sheet) setStyleSheet(sheet);
}

Card makeCard(const char* style, QWidget* parent) {
  auto* frame = new QFrame(parent);
  frame->setObjectName(style);
  auto* layout = new QVBoxLayout(frame);
  layout->setContentsMargins(14, 12, 14, 12);
  layout->setSpacing(8);
  return {frame, layout};
}

QLabel* makeTag(const QString& text, Light light, QWidget* parent) {
  const char* style = light == Light::measured                         ? "tagGood"
                      : light == Light::partly || light == Light::look ? "tagLook"
                                                                       : "tagQuiet";
  QLabel* tag = styledLabel(text, style, parent);
  tag->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  return tag;
}

QFrame* makeDivider(QWidget* parent) {
  auto* line = new QFrame(parent);
  line->setObjectName("divider");
  line->setFixedHeight(1);
  return line;
}

}  // namespace heft
