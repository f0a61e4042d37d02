#pragma once
// Who has how much of the window: 3D view, what stands below it, and the steps' panels beside both. Each step keeps its
// own shares.
#include <QMap>
#include <QWidget>

#include "ui/steps/step_panel.h"

class QSplitter;
class QStackedWidget;

namespace heft {

class Playback;
class RecordingPane;
class RobotView;

class Arrangement : public QObject {
  Q_OBJECT
 public:
  /// Makes view, plots and stacks under `window`; widget() is to be put into its layout.
  Arrangement(Playback* playback, QWidget* window);

  QSplitter* widget() const { return across_; }
  RobotView* view() const { return view_; }
  RecordingPane* plots() const { return pane_; }
  /// What stands below the view: plots, or a panel's own pane.
  QStackedWidget* below() const { return below_; }
  QStackedWidget* panels() const { return panels_; }

  void addPanel(StepPanel* panel);
  /// Gives the parts the sizes that this panel's step had. `opened`: there is something for the plots to show.
  void show(StepPanel* panel, bool opened);
  /// Before another step is shown.
  void keepSizes(Step step);
  /// One pane without the rest, by hiding the others; show() brings all of them back.
  enum class Alone { nothing, view, below };
  bool mayStandAlone(Alone what) const;
  void showAlone(Alone what);
  Alone alone() const { return alone_; }
  void unfoldPlots();
  /// A panel as it looks, whether it was shown or not.
  QImage pictureOf(StepPanel* panel) const;

 private:
  QSplitter* across_;
  QSplitter* down_;
  RobotView* view_;
  QStackedWidget* below_;
  RecordingPane* pane_;
  QStackedWidget* panels_;
  Alone alone_ = Alone::nothing;
  QMap<Step, int> panelWidths_;    ///< Each step keeps its own, whatever the window's width is by then;
  QMap<Step, double> viewShares_;  ///< and the 3D view's share of the height.
};

}  // namespace heft
