#include "ui/studio/studio.h"

#include <QApplication>
#include <QDir>
#include <QLibraryInfo>
#include <QLocale>
#include <QSettings>
#include <QVariant>

#include "core/base/remedy.h"
#include "core/base/said_again.h"
#include "core/base/say.h"
#include "ui/controller/autosave.h"
#include "ui/main_window/main_window.h"
#include "ui/studio/window_remedies.h"
#include "ui/timeline/playback.h"
#include "ui/timeline/time_axis.h"
#include "ui/wrench_plots/recording_pane.h"

static void initialiseTexts() { Q_INIT_RESOURCE(translations); }

namespace heft {
namespace {

QString themeName(ThemeKind kind) { return kind == ThemeKind::dark ? QStringLiteral("dark") : QStringLiteral("light"); }

}  // namespace

QStringList Studio::languages() { return {QStringLiteral("en"), QStringLiteral("de")}; }

Studio::Studio(QApplication& application, const StudioOptions& options) : application_(application), options_(options) {
  initialiseTexts();
  setRemedyWords(windowRemedy);
  constexpr std::size_t kRemembered = 5000;  // Far more than one session keeps of what core found
  rememberSentences(kRemembered);
  QString theme = options_.theme, language = options_.language;
  if (!options_.offscreen) {
    const QSettings settings;
    if (theme.isEmpty()) theme = settings.value("window/theme").toString();
    if (language.isEmpty()) language = settings.value("window/language").toString();
    if (language.isEmpty()) language = QLocale::system().name().left(2);
    heft::setUnits({settings.value("units/grams").toBool(), settings.value("units/inches").toBool(),
                    settings.value("units/newton_millimetres").toBool(), settings.value("units/radians").toBool()});
  }
  applyTheme(application_, theme == "dark" ? ThemeKind::dark : ThemeKind::light);
  useTexts(languages().contains(language) ? language : QStringLiteral("en"));
  // Scripts leave the user's documents alone.
  setRecordedFolder(options_.offscreen ? earlierRecordedFolder() : QSettings().value("files/recordings").toString());
  if (!options_.offscreen) autosave_ = std::make_unique<Autosave>(&workspace_, stateFolder());
  buildWindow();
}

Studio::~Studio() {
  setTranslator({});
  rememberSentences(0);
  setRemedyWords({});
}

void Studio::useTexts(const QString& language) {
  for (const auto& translator : translators_) QApplication::removeTranslator(translator.get());
  translators_.clear();
  language_ = language;
  // English has its own file, too: it holds the plurals.
  for (const QString& file :
       {QStringLiteral(":/translations/heft_%1.qm").arg(language),
        QLibraryInfo::location(QLibraryInfo::TranslationsPath) + QStringLiteral("/qtbase_%1.qm").arg(language)}) {
    auto translator = std::make_unique<QTranslator>();
    if (!translator->load(file)) continue;
    QApplication::installTranslator(translator.get());
    translators_.push_back(std::move(translator));
  }
  QLocale::setDefault(language == "de" ? QLocale(QLocale::German, QLocale::Germany)
                                       : QLocale(QLocale::English, QLocale::UnitedStates));
  // Core speaks the same language: its texts stand under this heading (packaging/update-texts.sh).
  if (language == "en") return setTranslator({});
  setTranslator(
      // A text that is the same in both languages counts, too: its numbers differ.
      [](const char* pattern) { return QCoreApplication::translate("heft", pattern).toStdString(); },
      QLocale().decimalPoint().toLatin1());
}

void Studio::buildWindow() {
  window_ = std::make_unique<MainWindow>(&workspace_, !options_.offscreen);
  MainWindow* window = window_.get();
  window->setLanguages(languages(), language_);
  connect(window, &MainWindow::themeWanted, this, &Studio::setTheme);
  // The window that asks is replaced: after it has returned from its menu.
  connect(
      window, &MainWindow::unitsWanted, this, [this](const UnitChoice& units) { setUnits(units); },
      Qt::QueuedConnection);
  connect(
      window, &MainWindow::languageWanted, this, [this](const QString& language) { setLanguage(language); },
      Qt::QueuedConnection);
  if (options_.offscreen) {
    window->setWindowFlag(Qt::FramelessWindowHint);
    window->setGeometry(QRect(QPoint(0, 0), options_.size));
  }
  if (autosave_) window->useAutosave(autosave_.get());
}

void Studio::setTheme(ThemeKind kind) {
  applyTheme(application_, kind);
  if (!options_.offscreen) QSettings().setValue("window/theme", themeName(kind));
}

bool Studio::setLanguage(const QString& language) {
  if (!languages().contains(language)) return false;
  if (language == language_) return true;
  if (!options_.offscreen) QSettings().setValue("window/language", language);
  rebuildWindow([this, &language] { useTexts(language); });
  // What core found out is said anew.
  workspace_.estimate();
  return true;
}

void Studio::setUnits(const UnitChoice& units) {
  if (units == heft::units()) return;
  if (!options_.offscreen) {
    QSettings settings;
    settings.setValue("units/grams", units.grams);
    settings.setValue("units/inches", units.inches);
    settings.setValue("units/newton_millimetres", units.newtonMillimetres);
    settings.setValue("units/radians", units.radians);
  }
  rebuildWindow([&units] { heft::setUnits(units); });
}

void Studio::rebuildWindow(const std::function<void()>& change) {
  // What was only a matter of looking goes along to the new window.
  const QByteArray geometry = window_->saveGeometry();
  const bool shown = window_->isVisible(), details = window_->detailsShown();
  const Step step = window_->step();
  const double time = window_->playback()->time();
  const double from = window_->recordingPane()->timeAxis()->lower(), to = window_->recordingPane()->timeAxis()->upper();
  change();
  buildWindow();
  if (!options_.offscreen) window_->restoreGeometry(geometry);
  if (shown) window_->show();
  window_->showStep(step);
  window_->showDetails(details);
  window_->playback()->setTime(time);
  window_->recordingPane()->timeAxis()->show(from, to);
}

void Studio::setSize(QSize size) {
  options_.size = size;
  window_->setGeometry(QRect(QPoint(0, 0), size));
}

void Studio::endBySystem() {
  window_->keepUnderWay();
  if (autosave_) autosave_->leaveForNextStart();
  QApplication::quit();
}

void Studio::show() { window_->show(); }

}  // namespace heft
