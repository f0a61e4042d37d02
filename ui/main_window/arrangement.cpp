#include "ui/main_window/arrangement.h"

#include <QImage>
#include <QPixmap>
#include <QSplitter>
#include <QStackedWidget>
#include <algorithm>

#include "ui/robot_view/robot_view.h"
#include "ui/wrench_plots/recording_pane.h"

namespace heft {
namespace {

constexpr int kPanelWidth = 440;  ///< [px]

}  // namespace

Arrangement::Arrangement(Playback* playback, QWidget* window)
    : QObject(window), across_(new QSplitter(Qt::Horizontal, window)), down_(new QSplitter(Qt::Vertical, across_)) {
  for (QSplitter* splitter : {across_, down_}) {
    splitter->setChildrenCollapsible(false);
    splitter->setHandleWidth(5);  // Wide enough to be caught; the sheet draws it as one line.
  }
  view_ = new RobotView(down_);
  below_ = new QStackedWidget(down_);
  pane_ = new RecordingPane(playback, below_);
  below_->addWidget(pane_);
  below_->hide();
  panels_ = new QStackedWidget(across_);
  // A wider window makes the picture wider; a higher one makes both higher.
  across_->setStretchFactor(0, 1);
  across_->setStretchFactor(1, 0);
  across_->setSizes({1000, kPanelWidth});
}

void Arrangement::addPanel(StepPanel* panel) {
  panels_->addWidget(panel);
  if (QWidget* own = panel->ownPane()) below_->addWidget(own);
}

void Arrangement::keepSizes(Step step) {
  if (!across_->isVisible() || alone_ != Alone::nothing) return;
  panelWidths_[step] = across_->sizes().value(1, kPanelWidth);
  const QList<int> down = down_->sizes();
  if (down.value(1) > 0) viewShares_[step] = static_cast<double>(down[0]) / (down[0] + down[1]);
}

void Arrangement::show(StepPanel* panel, bool opened) {
  alone_ = Alone::nothing;
  view_->show();
  panels_->show();
  const bool own = panel->below() == StepPanel::Below::own && panel->ownPane();
  below_->setCurrentWidget(own ? panel->ownPane() : pane_);
  below_->setVisible(own || opened);
  pane_->setFolded(panel->below() == StepPanel::Below::marksOnly);
  below_->setMaximumHeight(!own && pane_->folded() ? pane_->foldedHeight() : QWIDGETSIZE_MAX);
  const int panelWidth = panelWidths_.value(panel->step(), kPanelWidth);
  across_->setSizes({across_->width() - panelWidth, panelWidth});
  const int view = static_cast<int>(down_->height() * viewShares_.value(panel->step(), panel->viewShare()));
  down_->setSizes({view, down_->height() - view});
}

bool Arrangement::mayStandAlone(Alone what) const {
  return what != Alone::below || (below_->isVisibleTo(across_->window()) && !pane_->folded());
}

void Arrangement::showAlone(Alone what) {
  alone_ = what;
  panels_->hide();
  view_->setVisible(what == Alone::view);
  below_->setVisible(what == Alone::below);
}

void Arrangement::unfoldPlots() {
  pane_->setFolded(false);
  below_->setMaximumHeight(QWIDGETSIZE_MAX);
  down_->setSizes({down_->height() * 6 / 10, down_->height() * 4 / 10});
}

QImage Arrangement::pictureOf(StepPanel* panel) const {
  // A panel that was not shown yet has no size.
  if (!panel->isVisible()) panel->resize(kPanelWidth, std::max(600, panels_->height()));
  return panel->grab().toImage();
}

}  // namespace heft
