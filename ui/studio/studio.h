#pragma once
// The program around the window: workspace, autosave, theme and language. Changing the language builds the window anew
// around the same workspace, so that no widget needs to know how to translate itself.
#include <QObject>
#include <QSize>
#include <QStringList>
#include <QTranslator>
#include <functional>
#include <memory>
#include <vector>

#include "ui/controller/workspace.h"
#include "ui/models/units.h"
#include "ui/theme/theme.h"

class QApplication;

namespace heft {

class Autosave;
class MainWindow;

struct StudioOptions {
  bool offscreen = false;  ///< Frameless, remembers nothing, never autosaves.
  QSize size{1440, 900};   ///< With offscreen.
  QString theme;           ///< "light", "dark", or empty: as last time.
  QString language;        ///< "en", "de", or empty: as last time, else the system's.
};

class Studio : public QObject {
  Q_OBJECT
 public:
  Studio(QApplication& application, const StudioOptions& options);
  ~Studio() override;

  Workspace& workspace() { return workspace_; }
  MainWindow& window() { return *window_; }
  void setTheme(ThemeKind kind);
  /// False if there are no texts in that language.
  bool setLanguage(const QString& language);
  QString language() const { return language_; }
  /// Of the numbers on the screen; remembered like theme and language.
  void setUnits(const UnitChoice& units);
  void setSize(QSize size);
  /// Somebody logs out: recordings and what is open are kept for the next start.
  void endBySystem();
  void show();

  /// Codes of the languages that there are texts for.
  static QStringList languages();

 private:
  void useTexts(const QString& language);
  void buildWindow();
  /// The same window with other words or units: step, time and zoom stay.
  void rebuildWindow(const std::function<void()>& change);

  QApplication& application_;
  StudioOptions options_;
  QString language_;
  std::vector<std::unique_ptr<QTranslator>> translators_;
  Workspace workspace_;
  std::unique_ptr<Autosave> autosave_;
  std::unique_ptr<MainWindow> window_;
};

}  // namespace heft
