#pragma once
// Under the 3D view in the reality check: what the simulation misses, over time (measured, simulated without and with
// the causes, on the plots' own time axis), by frequency over the noise floor, or against what the robot did.
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "ui/charts/chart.h"
#include "ui/controller/diagnosis.h"

class QComboBox;
class QLabel;
class QPushButton;
class QToolButton;

namespace heft {

class DifferenceTraces;
class OverviewStrip;
class Playback;
class PlaybackBar;
class TimeAxis;

class DifferencePane : public QWidget {
  Q_OBJECT
 public:
  /// `axis` and `playback` are the plots', and must outlive the pane; without them it has an axis of its own.
  explicit DifferencePane(TimeAxis* axis = nullptr, Playback* playback = nullptr, QWidget* parent = nullptr);

  /// `witnesses` may be empty where the motion could not be worked out. `secret`: what the causes explain is not shown.
  void showReport(std::shared_ptr<const DiagnosisReport> report, std::vector<diagnosis::Witness> witnesses,
                  bool secret = false);

  /// Drawn beside the measured curve, until replaced by null. Shown with the next report.
  void setTwin(std::shared_ptr<const Recording> twin);

  enum class View { time, frequency, motion };
  void setView(View view);
  View view() const { return view_; }
  /// 0 to 5: force x ... torque z.
  void setChannel(int channel);
  /// By its ID; false if it does not exist.
  bool setWitness(const QString& id);
  /// One cause alone, on the channel and in the segment where it shows best; an empty ID: all of them together.
  void showCause(const std::string& id);
  /// Whether the shared time axis may be zoomed to where a cause shows: not while another step is shown. Turned on, it
  /// is.
  void setZooms(bool on);

  DifferenceTraces* traces() { return traces_; }
  /// For pictures and reports: of the views by frequency and against the motion.
  std::vector<Chart> charts() const;

 signals:
  void closeWanted();
  void pictureWanted();

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void buildHeader();
  void refresh();
  void showCurves();
  void zoomToTelling();
  void chooseWitness();
  void showTime(double time);
  const DiagnosedCause* cause() const;
  /// Residual without or with what is chosen: all causes, or one.
  diagnosis::Wrenches leftOver(bool after) const;
  /// Of the chosen channel itself: what a delay or a filter shows best against.
  static QString ownRate() { return QStringLiteral("own_rate"); }
  QVector<double> twinCurve(const VectorXd& time, int channel, double scale) const;
  Chart frequencyChart(bool torque) const;
  Chart motionChart(bool after) const;

  std::shared_ptr<const DiagnosisReport> report_;
  std::vector<diagnosis::Witness> witnesses_;
  std::shared_ptr<const Recording> twin_;
  bool secret_ = false;
  bool zooms_ = true;
  View view_ = View::time;
  TimeAxis* axis_;
  Playback* playback_;
  QPushButton* views_[3];
  QToolButton *whole_, *alone_;  ///< In the menu where the header is narrow
  QComboBox* cause_;
  QComboBox* channel_;
  QComboBox* witness_;
  QLabel* says_;
  DifferenceTraces* traces_;
  OverviewStrip* overview_;
  QWidget* charts_;
  ChartWidget* left_;
  ChartWidget* right_;
  PlaybackBar* bar_ = nullptr;
};

}  // namespace heft
