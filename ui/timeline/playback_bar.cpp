#include "ui/timeline/playback_bar.h"

#include <QAction>
#include <QActionGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "ui/models/numbers.h"
#include "ui/timeline/playback.h"
#include "ui/timeline/time_axis.h"
#include "ui/widgets/basics.h"

namespace heft {
namespace {
constexpr int kSteps = 10000;
constexpr int kKnob = 14;        ///< [px] As in the style sheet
constexpr double kFrame = 0.02;  ///< [s] One frame of an arm that reports at 50 Hz
}  // namespace

PlaybackBar::PlaybackBar(Playback* playback, QWidget* parent, TimeAxis* axis)
    : QWidget(parent), playback_(playback), axis_(axis) {
  setObjectName("playbackBar");
  setAttribute(Qt::WA_StyledBackground);
  auto* row = new QHBoxLayout(this);
  // The knob's middle stands under the cursor of the plots: the slider reaches half a knob beyond the time axis.
  row->setContentsMargins(6, 0, TimeAxis::kRight - kKnob / 2, 4);
  row->setSpacing(0);
  auto* head = new QWidget(this);
  head->setFixedWidth(TimeAxis::kLeft - 6 - kKnob / 2);
  auto* left = new QHBoxLayout(head);
  left->setContentsMargins(0, 0, 2, 0);
  left->setSpacing(0);
  play_ = new IconButton("play", tr("Play (Space)"), head);
  play_->setObjectName("playButton");
  play_->setFixedWidth(28);
  left->addWidget(play_);
  time_ = styledLabel({}, "playbackTick", head);
  time_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  left->addWidget(time_, 1);
  row->addWidget(head);
  slider_ = new QSlider(Qt::Horizontal, this);
  slider_->setObjectName("timeSlider");
  slider_->setRange(0, kSteps);
  slider_->setAccessibleName(tr("Time in the recording"));
  slider_->setToolTip(tr("Drag to move through the recording"));
  row->addWidget(slider_, 1);
  speed_ = new QToolButton(head);
  speed_->setObjectName("speedButton");
  speed_->setFixedWidth(26);
  speed_->setPopupMode(QToolButton::InstantPopup);
  speed_->setToolTip(tr("Speed, loop and single steps"));
  speed_->setAccessibleName(speed_->toolTip());
  left->insertWidget(1, speed_);
  buildMenu();
  showSpeed();

  connect(play_, &QToolButton::clicked, playback_, &Playback::toggle);
  connect(playback_, &Playback::playingChanged, this, &PlaybackBar::showPlaying);
  connect(playback_, &Playback::timeChanged, this, &PlaybackBar::showTime);
  connect(slider_, &QSlider::valueChanged, this,
          [this](int value) { playback_->setTime(lower() + (upper() - lower()) * value / kSteps); });
  if (axis_) connect(axis_, &TimeAxis::visibleChanged, this, &PlaybackBar::showTime);
  setRecording(false);
}

void PlaybackBar::buildMenu() {
  auto* menu = new QMenu(speed_);
  auto* group = new QActionGroup(menu);
  for (const double factor : {0.1, 0.25, 0.5, 1.0, 2.0, 4.0}) {
    QAction* action = menu->addAction(tr("%1 times").arg(numberText(factor, factor < 1 ? 2 : 0)), this, [this, factor] {
      playback_->setSpeed(factor);
      showSpeed();
    });
    action->setCheckable(true);
    action->setChecked(factor == playback_->speed());
    group->addAction(action);
  }
  menu->addSeparator();
  if (axis_) {
    QAction* loop = menu->addAction(tr("Loop what the plots show"));
    loop->setCheckable(true);
    connect(loop, &QAction::toggled, this,
            [this](bool on) { playback_->setLoop(on ? axis_->lower() : 0.0, on ? axis_->upper() : 0.0); });
    connect(axis_, &TimeAxis::visibleChanged, this, [this] {
      if (playback_->loops()) playback_->setLoop(axis_->lower(), axis_->upper());
    });
    connect(menu, &QMenu::aboutToShow, loop, [this, loop] {
      const QSignalBlocker quiet(loop);
      loop->setChecked(playback_->loops());
    });
  }
  menu->addAction(tr("One step back"), this, [this] { playback_->setTime(playback_->time() - kFrame); })
      ->setShortcut(QKeySequence(Qt::Key_Comma));
  menu->addAction(tr("One step forward"), this, [this] { playback_->setTime(playback_->time() + kFrame); })
      ->setShortcut(QKeySequence(Qt::Key_Period));
  speed_->setMenu(menu);
}

void PlaybackBar::showSpeed() {
  const double speed = playback_->speed();
  speed_->setText(tr("%1×").arg(numberText(speed, speed < 0.2 ? 1 : speed < 1 ? 2 : 0)));
}

void PlaybackBar::setRecording(bool present) {
  play_->setEnabled(present);
  slider_->setEnabled(present);
  slider_->setPageStep(kSteps / 20);
  slider_->setSingleStep(kSteps / 200);
  showTime();
}

double PlaybackBar::lower() const { return axis_ ? std::max(axis_->lower(), playback_->lower()) : playback_->lower(); }
double PlaybackBar::upper() const { return axis_ ? std::min(axis_->upper(), playback_->upper()) : playback_->upper(); }

void PlaybackBar::showTime() {
  const double span = upper() - lower(), share = span > 0 ? (playback_->time() - lower()) / span : 0.0;
  const QSignalBlocker quiet(slider_);
  slider_->setValue(static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * kSteps)));
  if (!slider_->isEnabled()) {
    time_->clear();
  } else if (playback_->poses()) {
    const QString at = numberText(std::round(playback_->time()), 0), last = numberText(playback_->upper(), 0);
    time_->setText(QStringLiteral("%1/%2").arg(at, last));
    time_->setToolTip(tr("pose %1 of %2").arg(at, last));
  } else {
    time_->setText(tr("%1 s").arg(numberText(playback_->time(), playback_->upper() < 100.0 ? 2 : 1)));
    time_->setToolTip(tr("%1 of %2 s").arg(numberText(playback_->time(), 2), numberText(playback_->upper(), 1)));
  }
}

void PlaybackBar::showPlaying(bool playing) {
  play_->setIconName(playing ? "pause" : "play", playing ? tr("Pause (Space)") : tr("Play (Space)"));
}

}  // namespace heft
