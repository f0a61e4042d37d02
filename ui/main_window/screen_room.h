#pragma once
// A window that fits the screen, its frame included.
#include <QSize>

class QWidget;

namespace heft {

/// What a window may take before its frame is known [px].
QSize roomOnScreen();
/// Once the frame is known: smaller and elsewhere, where it would go over the edge.
void keepOnScreen(QWidget* window);

}  // namespace heft
