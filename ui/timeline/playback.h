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
  bool poses() const { return poses_; }
  bool playing() const { return timer_.isActive(); }
  double speed() const { return speed_; }
  bool loops() const { return loopTo_ > loopFrom_; }

  /// So many times as fast as it happened.
  void setSpeed(double factor) { speed_ = factor; }
  /// Loops over this segment; an empty one: plays to the end, once.
  void setLoop(double from, double to);

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
  double lower_ = 0.0, upper_ = 0.0, time_ = 0.0, speed_ = 1.0, loopFrom_ = 0.0, loopTo_ = 0.0;
  bool poses_ = false;
};

}  // namespace heft
