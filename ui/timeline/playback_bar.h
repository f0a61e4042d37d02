#pragma once
// Play, pause and the slider over the whole recording.
#include <QWidget>

class QLabel;
class QSlider;

namespace heft {

class IconButton;
class Playback;

class PlaybackBar : public QWidget {
  Q_OBJECT
 public:
  /// `playback` must outlive the bar.
  explicit PlaybackBar(Playback* playback, QWidget* parent = nullptr);

  /// Call after the playback's range changed.
  void setRecording(bool present, bool poses);

 private:
  void showTime();
  void showPlaying(bool playing);

  Playback* playback_;
  IconButton* play_;
  QSlider* slider_;
  QLabel* time_;
  bool poses_ = false;
};

}  // namespace heft
