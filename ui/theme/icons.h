#pragma once
// Icons: our own SVG drawings in one line colour, tinted at run time so that both themes share them.
#include <QColor>
#include <QIcon>
#include <QPixmap>
#include <QString>

namespace heft {

/// The drawing `name` (resources/icons/NAME.svg) at `size` logical pixels; currentColor becomes `colour`, Canvas
/// `ground`.
QPixmap iconPixmap(const QString& name, int size, const QColor& colour, const QColor& ground, qreal devicePixelRatio);

/// In text colour of the current theme, with a paler disabled state.
QIcon themedIcon(const QString& name, int size = 20);

/// The program's own icon in accent colour.
QIcon applicationIcon();

}  // namespace heft
