#include "ui/studio/script_runner.h"

#include <QAbstractButton>
#include <QFileInfo>
#include <QPixmap>
#include <QUndoStack>
#include <algorithm>
#include <tuple>

#include "core/base/json_file.h"
#include "ui/controller/robot_choice.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/panels.h"
#include "ui/models/units.h"
#include "ui/robot_view/robot_view.h"
#include "ui/studio/studio.h"
#include "ui/timeline/time_axis.h"
#include "ui/wrench_plots/channel_lanes.h"
#include "ui/wrench_plots/recording_pane.h"
#include "ui/wrench_plots/wrench_plots.h"

namespace heft {
namespace {

constexpr int kRest = 60;      ///< [ms] between lines: one turn of the event loop lays out what changed.
constexpr int kDrawing = 350;  ///< [ms] before a picture: then plots and 3D have drawn themselves smoothly.

constexpr int kCalmTurns = 6;  ///< Of the event loop before a picture, however slow the machine is

constexpr double kLongestWait = 3600.0;  ///< [s]

std::optional<double> numberIn(const QStringList& words, int index) {
  bool ok = false;
  const double value = words.value(index).toDouble(&ok);
  return ok ? std::optional(value) : std::nullopt;
}

Error wrong(const QString& sentence) { return Error{sentence.toStdString()}; }

}  // namespace

ScriptForms ScriptRunner::forms() {
  ScriptForms all{{"open FILE ...", "recordings, or a session (.heft)"},
                  {"robot FILE", "the robot that was recorded (URDF); goes into the recording's setup file"},
                  {"step NAME", "record, mark, shape, result, reality-check, export"},
                  {"estimate", "estimate again"}};
  const ScriptForms window{
      {"save FILE [replace]", "save the session"},
      {"undo | redo", ""},
      {"time SECONDS | zoom FROM TO", "instant shown, segment in the plots"},
      {"channels ID ... | channels none", "further channels in the plots: q1, dq1, px, roll, speed, force ..."},
      {"alone view|plots|off", "one pane without the rest"},
      {"measure A B | table FILE", "two cursors; the visible segment as CSV"},
      {"camera whole|tool|front|side|top", ""},
      {"details on|off | theme light|dark | language en|de | size WIDTHxHEIGHT", ""},
      {"units kg|g|mm|inch|Nm|Nmm|degrees|radians ...", ""},
      {"manual", "open or close the manual"},
      {"click NAME", "a button by its object name"},
      {"picture FILE [window|view|plots|panel]", ""},
      {"wait SECONDS", ""}};
  for (const ScriptForms& more : {panelScriptForms(), window}) all.insert(all.end(), more.begin(), more.end());
  return all;
}

ScriptRunner::ScriptRunner(Studio* studio, std::vector<ScriptLine> lines, const std::string& name)
    : QObject(studio), studio_(studio), lines_(std::move(lines)), name_(name) {
  poll_.setInterval(20);
  connect(&poll_, &QTimer::timeout, this, &ScriptRunner::turn);
  connect(&studio_->workspace(), &Workspace::failed, this, [this](const QString& sentence) {
    if (failure_.isEmpty()) failure_ = placed(sentence);
  });
}

void ScriptRunner::start(bool goOn) {
  goOn_ = goOn;
  quiet_.start();
  poll_.start();
}

QString ScriptRunner::placed(const QString& sentence) const {
  if (name_.empty() || next_ == 0) return sentence;
  return QStringLiteral("%1:%2: %3").arg(QString::fromStdString(name_)).arg(lines_[next_ - 1].number).arg(sentence);
}

void ScriptRunner::turn() {
  if (!studio_->window().settled()) {
    quiet_.start();
    calm_ = 0;
    return;
  }
  ++calm_;
  if (!failure_.isEmpty() && !(goOn_ && studio_->workspace().opened())) return finish(failure_);
  const bool picture = next_ < lines_.size() && lines_[next_].words[0] == "picture";
  if (quiet_.elapsed() < std::max(wait_, picture ? kDrawing : kRest) || (picture && calm_ < kCalmTurns)) return;
  if (next_ == lines_.size()) return finish(failure_);
  wait_ = 0;
  const QStringList words = lines_[next_++].words;
  const auto obeyed = obey(words);
  if (!obeyed) return finish(placed(QString::fromStdString(obeyed.error().message)));
  quiet_.start();
  calm_ = 0;
}

void ScriptRunner::finish(const QString& failure) {
  poll_.stop();
  emit finished(failure);
}

std::optional<Result<bool>> ScriptRunner::takePicture(const QStringList& words) {
  if (words[0] != "picture") return std::nullopt;
  const QString part = words.value(2, QStringLiteral("window"));
  const QImage image = studio_->window().pictureOf(part);
  if (words.size() < 2 || words.size() > 3 || image.isNull()) return std::nullopt;
  if (!image.save(words[1]))
    return wrong(
        tr("%1 could not be written: check that the folder exists, may be written to, and that the name ends in "
           ".png.")
            .arg(words[1]));
  return true;
}

Result<bool> ScriptRunner::obey(const QStringList& words) {
  const QString& verb = words[0];
  if (const auto seconds = numberIn(words, 1); verb == "wait" && seconds && *seconds >= 0 && *seconds <= kLongestWait) {
    wait_ = static_cast<int>(1000 * *seconds);
    return true;
  }
  for (const auto part : {&ScriptRunner::obeySession, &ScriptRunner::obeyPlots, &ScriptRunner::obeyWindow,
                          &ScriptRunner::obeyLooks, &ScriptRunner::takePicture})
    if (auto obeyed = (this->*part)(words)) return *obeyed;
  for (const Step step : kAllSteps) {
    StepPanel* panel = studio_->window().panel(step);
    if (!panel) continue;
    if (auto obeyed = panel->obey(words)) return *obeyed;
  }
  if (const std::string known = formsOf(forms(), verb.toStdString()); !known.empty())
    return wrong(tr("\"%1\" has none of the forms: %2").arg(words.join(' '), QString::fromStdString(known)));
  return wrong(tr("Unknown command \"%1\"; see heft-studio --help.").arg(verb));
}

std::optional<Result<bool>> ScriptRunner::obeySession(const QStringList& words) {
  const QString& verb = words[0];
  MainWindow& window = studio_->window();
  Workspace& workspace = studio_->workspace();
  if (verb == "open" && words.size() > 1) {
    workspace.open(words.mid(1));
    return true;
  }
  if (verb == "robot" && words.size() == 2) {
    const auto opened = workspace.opened();
    if (!opened) return wrong(tr("robot needs an open recording."));
    if (auto named = nameRobot(*opened, words[1]); !named) return named;
    workspace.open(opened->path);
    return true;
  }
  if (verb == "step") {
    const auto step = stepFromId(words.value(1).toStdString());
    if (!step || !window.panel(*step)) return wrong(tr("There is no step %1.").arg(words.value(1)));
    window.showStep(*step);
    return true;
  }
  if (verb == "estimate" && words.size() == 1) {
    if (!workspace.opened()) return wrong(tr("estimate needs an open recording."));
    workspace.estimate();
    return true;
  }
  if (verb == "save" && words.size() >= 2) {
    if (QFileInfo::exists(words[1]) && words.value(2) != "replace")
      return wrong(tr("%1 already exists and was not overwritten.").arg(words[1]));
    workspace.save(words[1]);
    return true;
  }
  if (verb == "undo") return workspace.undoStack()->undo(), Result<bool>(true);
  if (verb == "redo") return workspace.undoStack()->redo(), Result<bool>(true);
  return std::nullopt;
}

std::optional<Result<bool>> ScriptRunner::obeyPlots(const QStringList& words) {
  const QString& verb = words[0];
  MainWindow& window = studio_->window();
  const auto first = numberIn(words, 1), second = numberIn(words, 2);
  if (verb == "time" && first) return window.playback()->setTime(*first), Result<bool>(true);
  if (verb == "zoom" && first && second)
    return window.recordingPane()->timeAxis()->show(*first, *second), Result<bool>(true);
  if (verb == "channels" && words.size() > 1) {
    ChannelLanes* lanes = window.recordingPane()->channels();
    const QStringList wanted = words[1] == "none" ? QStringList() : words.mid(1);
    for (const QString& id : wanted)
      if (std::none_of(lanes->channels().begin(), lanes->channels().end(),
                       [&](const Channel& c) { return c.id == id; }))
        return wrong(tr("The open recording has no channel %1.").arg(id));
    return lanes->setChosen(wanted), Result<bool>(true);
  }
  if (verb == "measure" && first && second) {
    window.recordingPane()->setMeasuring(true);
    window.playback()->setTime(*first);
    emit window.recordingPane()->plots()->secondPicked(*second);
    return true;
  }
  if (verb == "table" && words.size() == 2) {
    auto written = writeTextFile(words[1].toStdString(), window.recordingPane()->visibleText());
    return written ? Result<bool>(true) : Result<bool>(written.error());
  }
  return std::nullopt;
}

std::optional<Result<bool>> ScriptRunner::obeyWindow(const QStringList& words) {
  const QString& verb = words[0];
  MainWindow& window = studio_->window();
  if (verb == "alone" && words.size() == 2) {
    using Alone = MainWindow::Alone;
    if (words[1] != "view" && words[1] != "plots" && words[1] != "off") return std::nullopt;
    window.showAlone(words[1] == "view" ? Alone::view : words[1] == "plots" ? Alone::below : Alone::nothing);
    return true;
  }
  if (verb == "camera") {
    using Preset = RobotView::Preset;
    const std::pair<const char*, Preset> presets[] = {{"whole", Preset::overview},
                                                      {"tool", Preset::tool},
                                                      {"front", Preset::front},
                                                      {"side", Preset::side},
                                                      {"top", Preset::top}};
    for (const auto& [name, preset] : presets) {
      if (words.value(1) == QLatin1String(name)) return window.robotView()->usePreset(preset), Result<bool>(true);
    }
    return std::nullopt;
  }
  if (verb == "details" && (words.value(1) == "on" || words.value(1) == "off"))
    return window.showDetails(words[1] == "on"), Result<bool>(true);
  if (verb == "manual" && words.size() == 1) return window.showManual(!window.manualShown()), Result<bool>(true);
  if (verb == "click") {
    // Several pages have a button of the same name; the one shown is meant.
    QAbstractButton* button = nullptr;
    for (auto* each : window.findChildren<QAbstractButton*>(words.value(1)))
      if (each->isVisible() && each->isEnabled()) button = each;
    if (!button) return wrong(tr("There is no button %1 that could be clicked now.").arg(words.value(1)));
    return button->click(), Result<bool>(true);
  }
  return std::nullopt;
}

std::optional<Result<bool>> ScriptRunner::obeyLooks(const QStringList& words) {
  const QString& verb = words[0];
  if (verb == "theme" && (words.value(1) == "light" || words.value(1) == "dark"))
    return studio_->setTheme(words[1] == "dark" ? ThemeKind::dark : ThemeKind::light), Result<bool>(true);
  if (verb == "language") {
    if (!studio_->setLanguage(words.value(1))) return std::nullopt;
    return true;
  }
  if (verb == "units" && words.size() > 1) return chooseUnits(words.mid(1));
  if (verb == "size") {
    const auto size = parseSize(words.value(1));
    if (!size) return wrong(tr("size expects WIDTHxHEIGHT between 640x400 and 7680x4320."));
    return studio_->setSize(*size), Result<bool>(true);
  }
  return std::nullopt;
}

std::optional<Result<bool>> ScriptRunner::chooseUnits(const QStringList& words) {
  UnitChoice choice = units();
  const std::tuple<const char*, bool UnitChoice::*, bool> known[] = {{"kg", &UnitChoice::grams, false},
                                                                     {"g", &UnitChoice::grams, true},
                                                                     {"mm", &UnitChoice::inches, false},
                                                                     {"inch", &UnitChoice::inches, true},
                                                                     {"Nm", &UnitChoice::newtonMillimetres, false},
                                                                     {"Nmm", &UnitChoice::newtonMillimetres, true},
                                                                     {"degrees", &UnitChoice::radians, false},
                                                                     {"radians", &UnitChoice::radians, true}};
  for (const QString& word : words) {
    const auto it = std::find_if(std::begin(known), std::end(known),
                                 [&](const auto& each) { return word == QLatin1String(std::get<0>(each)); });
    if (it == std::end(known)) return std::nullopt;
    choice.*std::get<1>(*it) = std::get<2>(*it);
  }
  return studio_->setUnits(choice), Result<bool>(true);
}

}  // namespace heft
