#pragma once
// The lower edge of a dialog with fields.
#include <QString>
#include <functional>

class QDialog;
class QDialogButtonBox;

namespace heft {

/// OK, named `accept`, and Cancel. The dialog closes as accepted where `read` finds nothing wrong.
QDialogButtonBox* dialogButtons(QDialog* dialog, const QString& accept, std::function<bool()> read);

}  // namespace heft
