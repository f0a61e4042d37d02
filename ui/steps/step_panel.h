#pragma once
// A step of the studio: the panel at the right and what it wants of the window while it is shown.
//
// A new step is one folder with a subclass, and one line in ui/main_window/panels.cpp. The window owns the panel, asks
// it for its state and switches to it; the panel edits the session through parts().workspace only.
#include <QWidget>
#include <functional>
#include <optional>

#include "core/base/result.h"
#include "ui/steps/script_help.h"
#include "ui/steps/step.h"
#include "ui/steps/studio_parts.h"
#include "ui/widgets/panel_page.h"

class QKeyEvent;
class QMenu;

namespace heft {

/// Menus that a panel may add actions to.
struct StudioMenus {
  QMenu *file, *edit, *view, *tools, *practice, *help;
};

class StepPanel : public QWidget {
  Q_OBJECT
 public:
  /// Takes `page`, which fills the panel; a new empty one without it.
  explicit StepPanel(const StudioParts& parts, PanelPage* page = nullptr, QWidget* parent = nullptr);

  virtual Step step() const = 0;
  /// Cheap; asked whenever something changed.
  virtual StepState state() const = 0;

  /// The step is shown now, or no longer: the place to put handles, ghosts and painting into the shared view, and to
  /// take them out again.
  virtual void entered() {}
  virtual void left() {}
  virtual void setDetailsShown(bool) {}

  /// What stands under the 3D view: plots and marks; the marks bar alone; or the panel's own widget.
  enum class Below { plots, marksOnly, own };
  virtual Below below() const { return Below::plots; }
  /// Share of the height that the 3D view gets at first; the user's splitter counts afterwards.
  virtual double viewShare() const { return 0.52; }
  /// With Below::own: a widget that the window places and the panel owns.
  virtual QWidget* ownPane() { return nullptr; }

  /// What may be done here, for the line at the bottom: "Drag an edge to adjust it · Ctrl+Z to undo".
  virtual QString hint() const { return {}; }
  /// What is under way in this step, in place of the open recording's facts; empty: nothing.
  virtual QString facts() const { return {}; }

  /// The session or the program is to be closed: keeps what is under way, or lets the user go on with it (false).
  virtual bool mayEnd() { return true; }
  /// The program must exit now: saves what is under way without asking.
  virtual void keepUnderWay() {}

  /// A key that no control wanted while this step is shown; true if it was used.
  virtual bool keyPressed(QKeyEvent*) { return false; }

  /// Adds actions once, while the window is being built.
  virtual void addActions(const StudioMenus&) {}

  /// Carries out a line of a script (words[0] is the verb). Nothing if it has none of the forms that the class's
  /// scriptForms() lists; an error says what is wrong with it. The script goes on when the window has nothing under way
  /// any more.
  virtual std::optional<Result<bool>> obey(const QStringList& words) {
    Q_UNUSED(words);
    return std::nullopt;
  }

 signals:
  /// state() has changed.
  void stateChanged();
  /// below() has changed.
  void arrangementChanged();

 protected:
  const StudioParts& parts() const { return parts_; }
  Workspace& workspace() const { return *parts_.workspace; }
  PanelPage* page() const { return page_; }

 private:
  StudioParts parts_;
  PanelPage* page_;
};

}  // namespace heft
