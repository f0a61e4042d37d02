#pragma once
// The mouse wheel scrolls; it changes no value under the pointer, in no form and no dialog.

namespace heft {

/// For the whole application, once; it needs a QApplication.
void guardWheel();

}  // namespace heft
