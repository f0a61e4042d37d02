#pragma once
// The segment of time that plots and marks show together: what links their zoom and pan. View state, never undone.
#include <QObject>

namespace heft {

class TimeAxis : public QObject {
  Q_OBJECT
 public:
  /// Pixels left and right of the time axis in every widget that shares it.
  static constexpr int kLeft = 112, kRight = 16;

  explicit TimeAxis(QObject* parent = nullptr);

  /// The whole recording [s]; shows all of it. `poses` counts standing poses 1, 2, 3 instead of seconds.
  void setFull(double lower, double upper, bool poses = false);
  double fullLower() const { return fullLower_; }
  double fullUpper() const { return fullUpper_; }
  bool poses() const { return poses_; }

  /// The recording has grown to `upper`; where its end was in view the view goes along, keeping its span.
  void grow(double upper);

  double lower() const { return lower_; }
  double upper() const { return upper_; }
  double span() const { return upper_ - lower_; }
  bool showsAll() const { return lower_ <= fullLower_ && upper_ >= fullUpper_; }

  /// Shows [lower, upper], moved and shortened so that it stays inside the recording and keeps a readable span.
  void show(double lower, double upper);
  void showAll() { show(fullLower_, fullUpper_); }
  /// Factor below 1 zooms in; `about` stays where it is on the screen.
  void zoom(double factor, double about);
  void pan(double seconds);
  /// Turns the page where `time` is out of view.
  void reveal(double time);

  double toX(double time, int width) const;
  double toTime(double x, int width) const;

 signals:
  void fullChanged();
  void visibleChanged();

 private:
  double fullLower_ = 0.0, fullUpper_ = 1.0, lower_ = 0.0, upper_ = 1.0;
  bool poses_ = false;
};

}  // namespace heft
