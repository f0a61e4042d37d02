#include "ui/widgets/stepper.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QRegularExpression>
#include <QStyle>
#include <QToolButton>
#include <QVariant>
#include <algorithm>
#include <cmath>

#include "ui/widgets/basics.h"

namespace heft {
namespace {

constexpr int kPage = 10;          ///< Steps of Page Up and Down
constexpr int kUnitGap = 3;        ///< [px] Between number and unit.
constexpr int kFieldMargins = 10;  ///< [px] Of a field about its text, and the frame.

QString shortNumber(double value, int decimals) {
  QLocale locale;
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  const double scale = std::pow(10.0, decimals);
  const double rounded = std::round(value * scale) / scale;
  int needed = 0;
  while (needed < decimals &&
         std::abs(rounded * std::pow(10.0, needed) - std::round(rounded * std::pow(10.0, needed))) > 1e-6)
    ++needed;
  const QString text = locale.toString(std::abs(rounded), 'f', needed);
  return rounded < 0 ? QChar(0x2212) + text : text;
}

}  // namespace

std::optional<double> parseMeasure(const QString& text, const QString& unit) {
  static const QRegularExpression form(
      QStringLiteral("^\\s*([-+\u2212]?)\\s*(\\d+(?:[.,]\\d*)?|[.,]\\d+)\\s*([a-zA-Z\u00b0]*)\\s*$"));
  const auto match = form.match(text);
  if (!match.hasMatch()) return std::nullopt;
  bool ok = false;
  double value = match.captured(2).replace(',', '.').toDouble(&ok);
  if (!ok) return std::nullopt;
  if (match.captured(1) == "-" || match.captured(1) == QString(QChar(0x2212))) value = -value;
  const QString said = match.captured(3).toLower();
  if (said.isEmpty() || said == unit.toLower()) return value;
  if (unit == "mm") {
    if (said == "cm") return 10 * value;
    if (said == "m") return 1000 * value;
    if (said == "in") return 25.4 * value;
  }
  if (unit == QString(QChar(0xb0)) && (said == "deg" || said == "grad")) return value;
  return std::nullopt;
}

Stepper::Stepper(const QString& name, const QString& unit, const Range& range, QWidget* parent)
    : QFrame(parent), name_(name), unit_(unit), range_(range) {
  setProperty("role", "stepper");
  setFixedHeight(40);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(1, 1, 1, 1);
  row->setSpacing(0);
  less_ = new IconButton("minus", tr("%1: less").arg(name), this);
  more_ = new IconButton("plus", tr("%1: more").arg(name), this);
  for (QToolButton* button : {less_, more_}) {
    button->setFocusPolicy(Qt::NoFocus);  // The field's arrow keys do the same.
    button->setAutoRepeat(true);
    button->setFixedSize(28, 36);
    button->setIconSize(QSize(16, 16));
  }
  field_ = new QLineEdit(this);
  field_->setMinimumWidth(24);
  field_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  field_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  field_->setAccessibleName(QStringLiteral("%1 [%2]").arg(name, unit));
  field_->setToolTip(tr("%1 in %2. Arrow keys change it, Page Up and Down by ten.").arg(name, unit));
  field_->installEventFilter(this);
  setFocusProxy(field_);
  unitLabel_ = styledLabel(unit, "caption", this);
  unitLabel_->setFixedWidth(unit.size() > 1 ? 26 : 14);
  row->addWidget(less_);
  row->addWidget(field_, 1);
  row->addSpacing(kUnitGap);
  row->addWidget(unitLabel_);
  row->addWidget(more_);
  connect(less_, &QToolButton::pressed, this, &Stepper::begun);
  connect(more_, &QToolButton::pressed, this, &Stepper::begun);
  connect(less_, &QToolButton::clicked, this, [this] { step(-1); });
  connect(more_, &QToolButton::clicked, this, [this] { step(1); });
  connect(field_, &QLineEdit::editingFinished, this, &Stepper::take);
  showValue();
}

void Stepper::setValue(double value) {
  const bool same = std::abs(value - value_) < 1e-9;
  value_ = value;
  // Not while something is being typed that has not been taken yet.
  if (same && field_->isModified()) return;
  mark("wrong", false);
  showValue();
}

QSize Stepper::minimumSizeHint() const {
  QSize least = QFrame::minimumSizeHint();
  if (!unitLabel_->isHidden()) least.rwidth() -= unitLabel_->width() + kUnitGap;
  return least;
}

void Stepper::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  fitUnit();
}

void Stepper::fitUnit() {
  const int number = field_->fontMetrics().horizontalAdvance(field_->text()) + kFieldMargins;
  const int rest = less_->width() + more_->width() + unitLabel_->width() + kUnitGap;
  unitLabel_->setVisible(width() >= number + rest);
}

void Stepper::showValue() {
  field_->setText(shortNumber(value_, range_.decimals));
  field_->setModified(false);
  fitUnit();
}

void Stepper::step(double steps) {
  double from = value_;
  // On from what is typed, if it is a number.
  if (field_->isModified()) from = parseMeasure(field_->text(), unit_).value_or(value_);
  const double wanted = std::clamp(from + steps * range_.step, range_.least, range_.most);
  mark("wrong", false);
  emit refused({});
  if (std::abs(wanted - value_) < 1e-9) return showValue();
  value_ = wanted;
  showValue();
  emit changed(value_);
}

void Stepper::take() {
  if (!field_->isModified()) return;
  const auto typed = parseMeasure(field_->text(), unit_);
  if (!typed || *typed < range_.least || *typed > range_.most) {
    field_->setModified(true);
    const QString range =
        tr("between %1 and %2 %3")
            .arg(shortNumber(range_.least, range_.decimals), shortNumber(range_.most, range_.decimals), unit_);
    return setProblem(typed ? tr("%1 must be %2.").arg(name_, range)
                            : tr("“%1” is not a number: %2 must be %3.").arg(field_->text(), name_, range));
  }
  emit begun();
  mark("wrong", false);
  emit refused({});
  value_ = *typed;
  showValue();
  emit changed(value_);
}

void Stepper::setProblem(const QString& sentence) {
  mark("wrong", !sentence.isEmpty());
  emit refused(sentence);
}

void Stepper::setStrong(bool strong) { mark("strong", strong); }

void Stepper::mark(const char* property, bool on) {
  if (this->property(property).toBool() == on) return;
  setProperty(property, on);
  style()->unpolish(this);
  style()->polish(this);
}

bool Stepper::eventFilter(QObject* watched, QEvent* event) {
  if (watched == field_) {
    if (event->type() == QEvent::FocusIn || event->type() == QEvent::FocusOut)
      mark("focused", event->type() == QEvent::FocusIn);
    if (event->type() == QEvent::KeyPress) {
      auto* key = static_cast<QKeyEvent*>(event);
      const int direction = key->key() == Qt::Key_Up         ? 1
                            : key->key() == Qt::Key_Down     ? -1
                            : key->key() == Qt::Key_PageUp   ? kPage
                            : key->key() == Qt::Key_PageDown ? -kPage
                                                             : 0;
      if (direction != 0) {
        if (!key->isAutoRepeat()) emit begun();
        step(direction);
        return true;
      }
      if (key->key() == Qt::Key_Escape && field_->isModified()) {
        mark("wrong", false);
        emit refused({});
        showValue();
        return true;
      }
    }
  }
  return QFrame::eventFilter(watched, event);
}

}  // namespace heft
