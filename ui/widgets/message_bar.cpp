#include "ui/widgets/message_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLayout>
#include <QPushButton>
#include <QStringList>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

#include "ui/widgets/basics.h"

namespace heft {
namespace {

constexpr std::size_t kMost = 3;  ///< Messages at once
constexpr int kReadable = 10000;  ///< [ms] How long information is shown,
constexpr int kOffered = 30000;   ///< and how long if it has a button.

}  // namespace

MessageBar::MessageBar(QWidget* parent) : QFrame(parent) {
  setObjectName("messageBars");
  setAccessibleName(tr("Message"));
  rows_ = new QVBoxLayout(this);
  rows_->setContentsMargins(0, 0, 0, 0);
  rows_->setSpacing(0);
  fades_.setSingleShot(true);
  connect(&fades_, &QTimer::timeout, this, [this] {
    const auto messages = messages_;
    for (const Message& message : messages)
      if (!message.stays) close(message.row);
  });
  if (parent) parent->installEventFilter(this);
  hide();
}

void MessageBar::showMessage(Severity severity, const QString& text) { showMessage(severity, text, {}, {}); }

void MessageBar::showMessage(Severity severity, const QString& text, const QString& action,
                             const std::function<void()>& clicked) {
  const auto before = messages_;
  for (const Message& message : before)
    // The same message again, perhaps now with a button; or information already shown.
    if (message.text == text || !message.stays) close(message.row);
  while (messages_.size() >= kMost) close(messages_.front().row);
  Message message{severity, text, nullptr, severity != Severity::info, severity == Severity::info && parentWidget()};
  message.row = addRow(message, action, clicked);
  if (!message.floats) rows_->addWidget(message.row);
  messages_.push_back(message);
  setAccessibleDescription(this->text());
  if (!message.stays) fades_.start(action.isEmpty() ? kReadable : kOffered);
  if (message.floats) return placeFloating();
  show();
}

void MessageBar::placeFloating() {
  constexpr int kWidest = 620, kEdge = 20, kGap = 12;  // [px]
  // Below what stands above the bar, and at the left: the panel at the right is what one reads.
  int top = (isVisible() ? height() : 0) + kGap;
  const QLayout* column = parentWidget()->layout();
  for (int k = 0; column && k < column->count() && column->itemAt(k)->widget() != this; ++k)
    if (const QWidget* above = column->itemAt(k)->widget(); above && above->isVisible()) top += above->height();
  for (const Message& message : messages_) {
    if (!message.floats) continue;
    const int wide = std::min(kWidest, parentWidget()->width() * 11 / 20 - 2 * kEdge);
    const int needed = message.row->heightForWidth(wide), high = needed > 0 ? needed : message.row->sizeHint().height();
    message.row->setGeometry(kEdge, top, wide, high);
    message.row->show();
    message.row->raise();
    top += high + kGap;
  }
}

bool MessageBar::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) placeFloating();
  return QFrame::eventFilter(watched, event);
}

QWidget* MessageBar::addRow(const Message& message, const QString& action, const std::function<void()>& clicked) {
  auto* frame = new QFrame(message.floats ? parentWidget() : this);
  frame->setObjectName(message.floats ? "toast" : "messageBar");
  frame->setAttribute(Qt::WA_StyledBackground);
  frame->setProperty("severity", message.severity == Severity::error     ? "error"
                                 : message.severity == Severity::warning ? "warning"
                                                                         : "info");
  auto* row = new QHBoxLayout(frame);
  row->setContentsMargins(16, 8, 8, 8);
  row->setSpacing(10);
  row->addWidget(new LightIcon(message.severity == Severity::error     ? Light::notPossible
                               : message.severity == Severity::warning ? Light::look
                                                                       : Light::info,
                               20, frame));
  QLabel* label = styledLabel(message.text, "messageText", frame);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  row->addWidget(label, 1);
  auto* button = new QPushButton(action, frame);
  button->setObjectName("messageAction");
  button->setVisible(!action.isEmpty());
  connect(button, &QPushButton::clicked, this, [this, frame, clicked] {
    const auto then = clicked;  // It may show the next message.
    close(frame);
    if (then) then();
  });
  row->addWidget(button);
  auto* shut = new IconButton("close", tr("Close this message"), frame);
  shut->setObjectName("messageClose");
  connect(shut, &QToolButton::clicked, this, [this, frame] { close(frame); });
  row->addWidget(shut);
  return frame;
}

void MessageBar::close(QWidget* row) {
  messages_.erase(
      std::remove_if(messages_.begin(), messages_.end(), [row](const Message& each) { return each.row == row; }),
      messages_.end());
  rows_->removeWidget(row);
  row->hide();
  row->deleteLater();
  if (std::all_of(messages_.begin(), messages_.end(), [](const Message& each) { return each.floats; })) hide();
}

void MessageBar::withdraw(const QString& text) {
  const auto messages = messages_;
  for (const Message& message : messages)
    if (message.text == text) close(message.row);
}

void MessageBar::clear() {
  const auto messages = messages_;
  for (const Message& message : messages) close(message.row);
}

QString MessageBar::text() const {
  QStringList all;
  for (const Message& message : messages_) all << message.text;
  return all.join(QLatin1Char('\n'));
}

}  // namespace heft
