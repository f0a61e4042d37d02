#pragma once
// The colours and sizes of the studio, light and dark: the only place where a colour is written down.
#include <QColor>
#include <QFont>
#include <QString>
#include <array>

class QApplication;

namespace heft {

enum class ThemeKind { light, dark };

struct Theme {
  bool dark = false;
  QColor window, panel, raised, line, fieldEdge;
  QColor text, text2, text3;
  QColor accent, accentFill, accentTint;  ///< What Heft suggests or is selected, nothing else.
  QColor good, goodTint, look, lookText, lookTint, bad, badTint, quietTint;
  QColor noise;                         ///< Band behind the difference lanes
  std::array<QColor, 3> axis;           ///< x, y, z, measured
  std::array<QColor, 3> axisSimulated;  ///< Darker on light, lighter on dark
  QColor markFree, markContact, markIgnored;
  QColor plotGrid, plotZero;
  QColor skyTop, skyBottom, floorLine;  ///< 3D background and grid
  QColor wrench, gravity, tool;         ///< 3D
};

/// The current theme. Painting code asks for it while painting; views that keep colours listen to
/// QEvent::PaletteChange, which applyTheme causes.
const Theme& theme();
const Theme& themeOf(ThemeKind kind);

/// Sets palette, style sheet and font of the whole application.
void applyTheme(QApplication& application, ThemeKind kind);

/// Pixel sizes of the type scale.
namespace type {
inline constexpr int kNumber = 24, kQuestion = 23, kCard = 16, kBody = 14, kSection = 13, kCaption = 12, kTick = 11;
}

/// The interface font at a size of the scale.
QFont uiFont(int pixelSize, QFont::Weight weight = QFont::Normal);

}  // namespace heft
