#include "ui/widgets/message_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QVariant>

#include "ui/widgets/basics.h"

namespace heft {

MessageBar::MessageBar(QWidget* parent) : QFrame(parent) {
  setObjectName("messageBar");
  setAccessibleName(tr("Message"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(16, 8, 8, 8);
  row->setSpacing(10);
  icon_ = new LightIcon(Light::info, 20, this);
  row->addWidget(icon_, 0, Qt::AlignTop);
  text_ = styledLabel({}, "messageText", this);
  text_->setWordWrap(true);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  row->addWidget(text_, 1);
  action_ = new QPushButton(this);
  action_->setObjectName("messageAction");
  connect(action_, &QPushButton::clicked, this, [this] {
    const auto clicked = clicked_;  // It may show the next message.
    hide();
    if (clicked) clicked();
  });
  row->addWidget(action_, 0, Qt::AlignTop);
  auto* close = new IconButton("close", tr("Close this message"), this);
  close->setObjectName("messageClose");
  row->addWidget(close, 0, Qt::AlignTop);
  connect(close, &QToolButton::clicked, this, &QWidget::hide);
  hide();
}

void MessageBar::showMessage(Severity severity, const QString& text) { showMessage(severity, text, {}, {}); }

void MessageBar::showMessage(Severity severity, const QString& text, const QString& action,
                             std::function<void()> clicked) {
  action_->setText(action);
  action_->setVisible(!action.isEmpty());
  clicked_ = std::move(clicked);
  icon_->setLight(severity == Severity::error     ? Light::notPossible
                  : severity == Severity::warning ? Light::look
                                                  : Light::info);
  setProperty("severity", severity == Severity::error ? "error" : severity == Severity::warning ? "warning" : "info");
  style()->unpolish(this);
  style()->polish(this);
  text_->setText(text);
  setAccessibleDescription(text);
  show();
}

QString MessageBar::text() const { return text_->text(); }

}  // namespace heft
