#pragma once
// What a step's panel may use of the window around it. The window fills it in before it makes the panels.
#include <QImage>
#include <QString>
#include <QStringList>
#include <functional>

#include "core/base/findings.h"
#include "ui/steps/step.h"

namespace heft {

class JobRunner;
class Playback;
class RecordingPane;
class RobotView;
class Workspace;

struct StudioParts {
  Workspace* workspace = nullptr;  ///< The domain state and its edits; never null.
  Playback* playback = nullptr;    ///< Which instant is shown; never null.
  RobotView* view = nullptr;       ///< The 3D view; null in tests of a panel alone.
  RecordingPane* plots = nullptr;  ///< Plots and marks bar; null in tests of a panel alone.

  std::function<void(Step)> goTo = [](Step) {};
  /// One sentence in the bar at the top of the window.
  std::function<void(Severity, const QString&)> say = [](Severity, const QString&) {};
  /// The same with a button that does something about it.
  std::function<void(Severity, const QString&, const QString&, std::function<void()>)> offer =
      [](Severity, const QString&, const QString&, const std::function<void()>&) {};
  /// Asks for files and opens them.
  std::function<void()> chooseFiles = [] {};
  std::function<QStringList()> recentFiles = [] { return QStringList(); };
  /// Puts a file among the recent ones.
  std::function<void(const QString&)> remember = [](const QString&) {};
  /// Robot and sensor of the open recording, in a dialog; null where there is none.
  std::function<void()> editRig;
  /// Asks where to and saves a picture; `what` becomes part of its name. Null in tests of a panel alone.
  std::function<void(const QImage&, const QString&)> savePicture;
  /// Leads through the steps with a sample recording; null in tests of a panel alone.
  std::function<void()> startTour;
  bool asks = false;  ///< A user can answer questions; otherwise nothing is asked and everything is kept.
  /// Shows the runner's work in the status line and counts it as the window being busy. The runner must live as long
  /// as the panel.
  std::function<void(JobRunner*)> followJobs = [](JobRunner*) {};
};

}  // namespace heft
