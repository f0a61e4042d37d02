#include "ui/timeline/playback_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>
#include <cmath>

#include "ui/models/numbers.h"
#include "ui/timeline/playback.h"
#include "ui/timeline/time_axis.h"
#include "ui/widgets/basics.h"

namespace heft {
namespace {
constexpr int kSteps = 10000;
}

PlaybackBar::PlaybackBar(Playback* playback, QWidget* parent) : QWidget(parent), playback_(playback) {
  setObjectName("playbackBar");
  setAttribute(Qt::WA_StyledBackground);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(12, 2, TimeAxis::kRight, 6);
  row->setSpacing(8);
  play_ = new IconButton("play", tr("Play (Space)"), this);
  play_->setObjectName("playButton");
  row->addWidget(play_);
  row->addSpacing(TimeAxis::kLeft - 12 - play_->sizeHint().width() - 2 * row->spacing());
  slider_ = new QSlider(Qt::Horizontal, this);
  slider_->setObjectName("timeSlider");
  slider_->setRange(0, kSteps);
  slider_->setAccessibleName(tr("Time in the recording"));
  slider_->setToolTip(tr("Drag to move through the recording"));
  row->addWidget(slider_, 1);
  time_ = styledLabel({}, "playbackTime", this);
  time_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  // Fixed, since Qt 5 has no tabular figures and the slider must not move with every digit.
  time_->setFixedWidth(112);
  row->addWidget(time_);

  connect(play_, &QToolButton::clicked, playback_, &Playback::toggle);
  connect(playback_, &Playback::playingChanged, this, &PlaybackBar::showPlaying);
  connect(playback_, &Playback::timeChanged, this, &PlaybackBar::showTime);
  connect(slider_, &QSlider::valueChanged, this, [this](int value) {
    const double span = playback_->upper() - playback_->lower();
    playback_->setTime(playback_->lower() + span * value / kSteps);
  });
  setRecording(false, false);
}

void PlaybackBar::setRecording(bool present, bool poses) {
  poses_ = poses;
  play_->setEnabled(present);
  slider_->setEnabled(present);
  slider_->setPageStep(kSteps / 20);
  slider_->setSingleStep(kSteps / 200);
  showTime();
}

void PlaybackBar::showTime() {
  const double span = playback_->upper() - playback_->lower();
  const QSignalBlocker quiet(slider_);
  slider_->setValue(span > 0 ? static_cast<int>(std::lround((playback_->time() - playback_->lower()) / span * kSteps))
                             : 0);
  if (!slider_->isEnabled()) {
    time_->clear();
  } else if (poses_) {
    time_->setText(tr("%1 of %2").arg(timeText(playback_->time(), true), numberText(playback_->upper(), 0)));
  } else {
    time_->setText(tr("%1 of %2 s").arg(numberText(playback_->time(), 2), numberText(playback_->upper(), 1)));
  }
}

void PlaybackBar::showPlaying(bool playing) {
  play_->setIconName(playing ? "pause" : "play", playing ? tr("Pause (Space)") : tr("Play (Space)"));
}

}  // namespace heft
