#pragma once
// Which instant of the recording is shown, and letting it run.
#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace heft {

class Playback : public QObject {
  Q_OBJECT
 public:
  explicit Playback(QObject* parent = nullptr);

  /// Stops and goes to the beginning. With `poses` it advances two poses a second.
  void setRange(double lower, double upper, bool poses = false);
  double lower() const { return lower_; }
  double upper() const { return upper_; }
  double time() const { return time_; }
  bool playing() const { return timer_.isActive(); }

 public slots:
  void setTime(double time);
  void setPlaying(bool playing);
  void toggle() { setPlaying(!playing()); }

 signals:
  void timeChanged(double time);
  void playingChanged(bool playing);

 private:
  void advance();

  QTimer timer_;
  QElapsedTimer clock_;
  double lower_ = 0.0, upper_ = 0.0, time_ = 0.0, rate_ = 1.0;
};

}  // namespace heft
