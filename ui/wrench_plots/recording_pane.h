#pragma once
// Everything under the 3D view: legend, plots, marks, playback, with the time cursor over them.
#include <QWidget>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/estimation/estimate.h"
#include "core/robot/robot_model.h"
#include "ui/jobs/job_runner.h"
#include "ui/timeline/time_axis.h"
#include "ui/wrench_plots/wrench_traces.h"

class QHBoxLayout;

namespace heft {

class ChannelLanes;
class DifferenceCursor;
class IconButton;
class MarksBar;
class OverviewStrip;
class Playback;
class PlaybackBar;
class TimeCursor;
class WrenchPlots;

class RecordingPane : public QWidget {
  Q_OBJECT
 public:
  explicit RecordingPane(Playback* playback, QWidget* parent = nullptr);

  /// A new recording, or none, with the estimate on it, or null: shows all of it from its beginning. The curves follow
  /// as soon as they are made, which takes a moment for a long recording. The robot gives the pose where there are
  /// joints.
  void setRecording(std::shared_ptr<const Recording> recording, std::shared_ptr<const EstimateReport> report,
                    std::shared_ptr<const RobotModel> robot = nullptr);
  /// What has come so far of something live, up to `now` [s]; the view goes along. Ends with setRecording().
  void showLive(std::shared_ptr<const WrenchTraces> traces, const std::vector<Segment>& touched, double now);
  /// Another estimate on that recording, or null if there is none.
  void setReport(std::shared_ptr<const EstimateReport> report);
  /// Makes the curves.
  JobRunner* jobs() { return &jobs_; }
  /// What plots and marks bar tint; `suggested` ones are drawn as proposals.
  void setSegments(const std::vector<Segment>& segments, const std::vector<bool>& suggested);

  /// Zooms to a segment with some margin and frames it under this word; an empty one removes the frame.
  void highlight(double from, double to, const QString& word);

  /// With a brush the marks bar is painted by dragging and, if so chosen, the plots. Nothing: no painting.
  void setBrush(std::optional<MarkLabel> brush, bool inPlots = false);

  /// Folded, only the marks bar stands there, under a line that unfolds it.
  void setFolded(bool folded);
  bool folded() const { return folded_; }
  int foldedHeight() const;

  /// The second cursor with the table of values, on or off.
  void setMeasuring(bool on);
  DifferenceCursor* differenceCursor() { return difference_; }
  /// The visible range, as CSV.
  std::string visibleText() const;

  TimeAxis* timeAxis() { return &axis_; }
  WrenchPlots* plots() { return plots_; }
  MarksBar* marks() { return marks_; }
  ChannelLanes* channels() { return channels_; }

 signals:
  void pictureWanted();
  void csvWanted();
  /// A segment was painted, by mouse or keyboard.
  void painted(double from, double to, heft::MarkLabel label);
  /// The user chose another brush by its key.
  void brushPicked(heft::MarkLabel label);
  /// The user asked for the plots while they were folded.
  void unfoldWanted();

 private:
  void addLegend(QHBoxLayout* row);
  void addButtons(QHBoxLayout* row);
  void makeFoldedHeader();
  void connectParts();
  void setTraces(std::shared_ptr<const WrenchTraces> traces);
  void fillChannelMenu();
  void showParts();

  TimeAxis axis_;
  Playback* playback_;
  WrenchPlots* plots_;
  ChannelLanes* channels_;
  MarksBar* marks_;
  OverviewStrip* overview_;
  PlaybackBar* bar_;
  TimeCursor* cursor_;
  QWidget* header_;
  QWidget* foldedHeader_;
  IconButton* measure_;
  IconButton* channelButton_;
  DifferenceCursor* difference_;
  std::optional<MarkLabel> brush_;
  bool folded_ = false;
  bool live_ = false;
  std::shared_ptr<const Recording> recording_;
  JobRunner jobs_;
};

}  // namespace heft
