#pragma once
// A pane that stands under the 3D view, with its title on top.
#include <QString>

class QHBoxLayout;
class QVBoxLayout;
class QWidget;

namespace heft {

struct PaneHeader {
  QVBoxLayout* column;  ///< Of the pane; the header stands first in it.
  QWidget* header;
  QHBoxLayout* row;  ///< Of the header, the title first; spacing is the caller's.
};

/// Gives an empty `pane` the look of a plot area and a header `height` pixels high.
PaneHeader dressAsPane(QWidget* pane, const QString& title, int height = 36);

}  // namespace heft
