#include "ui/theme/theme.h"

#include <QApplication>
#include <QFile>
#include <QFontDatabase>
#include <QPalette>
#include <QProxyStyle>
#include <QStyleFactory>
#include <utility>

#include "ui/theme/icons.h"

static void initialiseResources() { Q_INIT_RESOURCE(heft); }

namespace heft {
namespace {

Theme makeLight() {
  Theme t;
  t.window = "#EEF1F4", t.panel = "#FFFFFF", t.raised = "#F6F8FA", t.line = "#D9DFE5", t.fieldEdge = "#BAC4CD";
  t.text = "#1C2630", t.text2 = "#4C5966", t.text3 = "#5D6A76";
  t.accent = "#8A2F6E", t.accentFill = "#8A2F6E", t.accentTint = "#F9EFF6";
  t.good = "#00775A", t.goodTint = "#E6F4EF";
  t.look = "#E69F00", t.lookText = "#8A5A00", t.lookTint = "#FDF3DF";
  t.bad = "#B84A00", t.badTint = "#FBEBE1", t.quietTint = "#E4E9EE";
  t.noise = "#DDE2E7";
  t.axis = {QColor("#D55E00"), QColor("#009E73"), QColor("#0072B2")};
  t.axisSimulated = {QColor("#8A3D00"), QColor("#00614A"), QColor("#004974")};
  t.markFree = "#8CC8EA", t.markContact = "#E69F00", t.markIgnored = "#B9C1C9";
  t.plotGrid = "#EDF0F3", t.plotZero = "#D9DFE5";
  t.skyTop = "#FAFBFC", t.skyBottom = "#E7EBEF", t.floorLine = "#B7C2CC";
  t.wrench = "#C47F00", t.gravity = "#4C5966", t.tool = "#4F9CC4";
  return t;
}

Theme makeDark() {
  Theme t;
  t.dark = true;
  t.window = "#12161A", t.panel = "#1B2127", t.raised = "#232A31", t.line = "#323B44", t.fieldEdge = "#48535D";
  t.text = "#E8EDF1", t.text2 = "#B3BEC8", t.text3 = "#8E9AA5";
  t.accent = "#E59CCB", t.accentFill = "#A8488A", t.accentTint = "#33232F";
  t.good = "#3CCB9F", t.goodTint = "#1B322C";
  t.look = "#F2B134", t.lookText = "#F2B134", t.lookTint = "#38301D";
  t.bad = "#FF9A5C", t.badTint = "#3A261B", t.quietTint = "#2E363E";
  t.noise = "#333C45";
  t.axis = {QColor("#FF8A4C"), QColor("#2CC79A"), QColor("#6DB7F2")};
  t.axisSimulated = {QColor("#FFD3BA"), QColor("#B5F0DD"), QColor("#CFE6FB")};
  t.markFree = "#2F7299", t.markContact = "#C98A12", t.markIgnored = "#4A545D";
  t.plotGrid = "#262E35", t.plotZero = "#3A444D";
  t.skyTop = "#20272E", t.skyBottom = "#12161A", t.floorLine = "#46525C";
  t.wrench = "#E0A83A", t.gravity = "#A9B4BE", t.tool = "#5AAEE0";
  return t;
}

const Theme* current = nullptr;

/// Fusion without underlined letters in the menus; Alt with the letter works all the same.
class StudioStyle : public QProxyStyle {
 public:
  StudioStyle() : QProxyStyle(QStyleFactory::create("Fusion")) {}
  int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                QStyleHintReturn* data) const override {
    if (hint == SH_UnderlineShortcut) return 0;
    return QProxyStyle::styleHint(hint, option, widget, data);
  }
  /// What Qt's own dialogs show, as the rest of the window is drawn.
  QIcon standardIcon(StandardPixmap which, const QStyleOption* option, const QWidget* widget) const override {
    const Theme& t = theme();
    const auto light = [](const char* name, const QColor& colour) {
      QIcon icon;
      for (const qreal ratio : {1.0, 2.0}) icon.addPixmap(iconPixmap(name, kLarge, colour, theme().panel, ratio));
      return icon;
    };
    switch (which) {
      case SP_MessageBoxQuestion:
        return light("light_unknown", t.accent);
      case SP_MessageBoxInformation:
        return light("info", t.text2);
      case SP_MessageBoxWarning:
        return light("light_look", t.look);
      case SP_MessageBoxCritical:
        return light("light_not_possible", t.bad);
      default:
        break;
    }
    static const std::pair<StandardPixmap, const char*> kDrawn[] = {{SP_ArrowBack, "back"},
                                                                    {SP_ArrowLeft, "back"},
                                                                    {SP_ArrowForward, "forward"},
                                                                    {SP_ArrowRight, "forward"},
                                                                    {SP_FileDialogBack, "back"},
                                                                    {SP_FileDialogToParent, "up"},
                                                                    {SP_ArrowUp, "up"},
                                                                    {SP_FileDialogNewFolder, "plus"},
                                                                    {SP_FileDialogDetailedView, "table"},
                                                                    {SP_FileDialogListView, "list"},
                                                                    {SP_FileDialogContentsView, "list"},
                                                                    {SP_FileDialogInfoView, "info"},
                                                                    {SP_DirIcon, "folder"},
                                                                    {SP_DirClosedIcon, "folder"},
                                                                    {SP_DirOpenIcon, "open"},
                                                                    {SP_DirLinkIcon, "folder"},
                                                                    {SP_DirHomeIcon, "home"},
                                                                    {SP_DesktopIcon, "home"},
                                                                    {SP_ComputerIcon, "drive"},
                                                                    {SP_DriveHDIcon, "drive"},
                                                                    {SP_DriveNetIcon, "drive"},
                                                                    {SP_FileIcon, "file"},
                                                                    {SP_FileLinkIcon, "file"},
                                                                    {SP_DialogCloseButton, "close"}};
    for (const auto& [standard, name] : kDrawn)
      if (standard == which) return themedIcon(name);
    return QProxyStyle::standardIcon(which, option, widget);
  }

 private:
  static constexpr int kLarge = 32;  ///< [px] Of a message box
};

/// The style sheet names colours by token (@panel); longer names first, so that @accentTint is not read as @accent.
QString filledStyleSheet(const Theme& t) {
  QFile file(":/styles/heft.qss");
  if (!file.open(QIODevice::ReadOnly)) return {};
  QString sheet = QString::fromUtf8(file.readAll());
  const std::pair<const char*, QColor> tokens[] = {{"@accentFill", t.accentFill},
                                                   {"@accentTint", t.accentTint},
                                                   {"@accent", t.accent},
                                                   {"@fieldEdge", t.fieldEdge},
                                                   {"@window", t.window},
                                                   {"@panel", t.panel},
                                                   {"@raised", t.raised},
                                                   {"@line", t.line},
                                                   {"@text2", t.text2},
                                                   {"@text3", t.text3},
                                                   {"@text", t.text},
                                                   {"@goodTint", t.goodTint},
                                                   {"@good", t.good},
                                                   {"@lookTint", t.lookTint},
                                                   {"@lookText", t.lookText},
                                                   {"@look", t.look},
                                                   {"@badTint", t.badTint},
                                                   {"@bad", t.bad},
                                                   {"@quietTint", t.quietTint}};
  for (const auto& [name, colour] : tokens) sheet.replace(QLatin1String(name), colour.name());
  // Qt 5 divides a numeric font-weight by eight to reach its own scale of 0 to 99; Qt 6 takes it as it stands.
  const int weightScale = QT_VERSION_MAJOR < 6 ? 8 : 1;
  const std::pair<const char*, int> weights[] = {
      {"@regular", QFont::Normal}, {"@medium", QFont::Medium}, {"@semibold", QFont::DemiBold}, {"@bold", QFont::Bold}};
  for (const auto& [name, weight] : weights) sheet.replace(QLatin1String(name), QString::number(weight * weightScale));
  return sheet;
}

QPalette paletteOf(const Theme& t) {
  QPalette palette;
  palette.setColor(QPalette::Window, t.panel);
  palette.setColor(QPalette::WindowText, t.text);
  palette.setColor(QPalette::Base, t.panel);
  palette.setColor(QPalette::AlternateBase, t.raised);
  palette.setColor(QPalette::Text, t.text);
  palette.setColor(QPalette::Button, t.panel);
  palette.setColor(QPalette::ButtonText, t.text);
  palette.setColor(QPalette::ToolTipBase, t.text);
  palette.setColor(QPalette::ToolTipText, t.panel);
  palette.setColor(QPalette::Highlight, t.accentFill);
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::Link, t.accent);
  for (auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    palette.setColor(QPalette::Disabled, role, t.text3);
  }
  return palette;
}

}  // namespace

const Theme& themeOf(ThemeKind kind) {
  static const Theme light = makeLight();
  static const Theme dark = makeDark();
  return kind == ThemeKind::dark ? dark : light;
}

const Theme& theme() { return current ? *current : themeOf(ThemeKind::light); }

void applyTheme(QApplication& application, ThemeKind kind) {
  initialiseResources();
  current = &themeOf(kind);
  application.setStyle(new StudioStyle);
  application.setFont(uiFont(type::kBody));
  application.setPalette(paletteOf(*current));
  application.setStyleSheet(filledStyleSheet(*current));
}

QFont uiFont(int pixelSize, QFont::Weight weight) {
  static const QString family = [] {
    const QStringList families = QFontDatabase().families();
    for (const char* wanted : {"Inter", "Noto Sans", "DejaVu Sans"}) {
      if (families.contains(QLatin1String(wanted))) return QString(QLatin1String(wanted));
    }
    return QFontDatabase::systemFont(QFontDatabase::GeneralFont).family();
  }();
  QFont font(family);
  font.setPixelSize(pixelSize);
  font.setWeight(weight);
  return font;
}

}  // namespace heft
