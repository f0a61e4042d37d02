#pragma once
// Play, pause and the slider over what the plots show.
#include <QWidget>

class QLabel;
class QSlider;
class QToolButton;

namespace heft {

class IconButton;
class Playback;
class TimeAxis;

class PlaybackBar : public QWidget {
  Q_OBJECT
 public:
  /// `playback` must outlive the bar.
  /// With `axis`, which must outlive it too, the segment that the plots show can be looped.
  explicit PlaybackBar(Playback* playback, QWidget* parent = nullptr, TimeAxis* axis = nullptr);

  /// Call after the playback's range changed.
  void setRecording(bool present);

 private:
  void showTime();
  void showSpeed();
  void buildMenu();
  void showPlaying(bool playing);
  /// The range of the slider.
  double lower() const;
  double upper() const;

  Playback* playback_;
  TimeAxis* axis_;
  IconButton* play_;
  QToolButton* speed_;
  QSlider* slider_;
  QLabel* time_;
};

}  // namespace heft
