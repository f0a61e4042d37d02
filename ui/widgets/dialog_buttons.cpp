#include "ui/widgets/dialog_buttons.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QPushButton>
#include <utility>

namespace heft {

QDialogButtonBox* dialogButtons(QDialog* dialog, const QString& accept, std::function<bool()> read) {
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, dialog);
  buttons->button(QDialogButtonBox::Ok)->setText(accept);
  QObject::connect(buttons, &QDialogButtonBox::accepted, dialog, [dialog, read = std::move(read)] {
    if (read()) dialog->accept();
  });
  QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
  return buttons;
}

}  // namespace heft
