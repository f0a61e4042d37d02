#pragma once
// Lanes below force and torque for any other channel of the recording: joints, pose, speeds. Channels of one unit share
// a lane, whose scale follows what is visible.
#include <QStringList>
#include <QWidget>
#include <memory>
#include <vector>

#include "ui/wrench_plots/channels.h"
#include "ui/wrench_plots/min_max_pyramid.h"

namespace heft {

class TimeAxis;
class TimeMouse;

class ChannelLanes : public QWidget {
  Q_OBJECT
 public:
  /// `axis` must outlive it. Nothing to show while lanes() is 0.
  explicit ChannelLanes(TimeAxis* axis, QWidget* parent = nullptr);

  /// Null: none. The choice is kept as far as this recording has the channels. With a robot the pose follows from the
  /// joints, where the recording does not.
  void setRecording(std::shared_ptr<const Recording> recording, std::shared_ptr<const RobotModel> robot = nullptr);
  const std::vector<Channel>& channels() const { return channels_; }
  /// IDs; those that the recording does not have are left out.
  void setChosen(const QStringList& ids);
  void choose(const QString& id, bool chosen);
  bool isChosen(const QString& id) const { return chosen_.contains(id); }

  int lanes() const { return static_cast<int>(lanes_.size()); }
  /// For tests: the limits of a lane.
  MinMax laneRange(int lane) const;

 signals:
  void timePicked(double time);
  void chosenChanged();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  struct Curve {
    Channel channel;
    MinMaxPyramid values;
  };
  struct Lane {
    QString unit;
    std::vector<Curve> curves;
  };
  void rebuild();
  QRectF areaOf(int lane) const;
  void drawLane(QPainter& painter, int lane) const;
  void drawPointer(QPainter& painter) const;
  double valueAt(const Curve& curve, double time) const;

  TimeAxis* axis_;
  TimeMouse* mouse_;
  std::shared_ptr<const Recording> recording_;
  std::shared_ptr<const RobotModel> robot_;   ///< Null if the joints do not give a pose.
  std::shared_ptr<const Recording> forward_;  ///< forwardPoses(), made when it is first asked for.
  std::vector<Channel> channels_;
  QStringList chosen_;
  std::vector<double> time_;
  double gap_ = 0.0;
  std::vector<Lane> lanes_;
};

}  // namespace heft
