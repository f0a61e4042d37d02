#include "ui/widgets/message_bar.h"

#include <QHBoxLayout>
#include <QLabel>
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
  auto* close = new IconButton("close", tr("Close this message"), this);
  close->setObjectName("messageClose");
  row->addWidget(close, 0, Qt::AlignTop);
  connect(close, &QToolButton::clicked, this, &QWidget::hide);
  hide();
}

void MessageBar::showMessage(Severity severity, const QString& text) {
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
