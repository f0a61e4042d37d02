#pragma once
// Qt's own file dialog, where the desktop has none, in the studio's drawings and with the folders that its users need
// at its side.
#include <QStringList>
#include <functional>

namespace heft {

/// For the whole application, once; it needs a QApplication. `folders` are asked for whenever a dialog is opened; those
/// that do not exist are left out.
void dressFileDialogs(std::function<QStringList()> folders);

}  // namespace heft
