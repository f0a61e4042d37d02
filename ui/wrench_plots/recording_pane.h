#pragma once
// Everything under the 3D view: legend, plots, marks, playback, with the time cursor over them.
#include <QWidget>
#include <memory>
#include <vector>

#include "core/estimation/estimate.h"
#include "ui/timeline/time_axis.h"
#include "ui/wrench_plots/wrench_traces.h"

namespace heft {

class MarksBar;
class Playback;
class PlaybackBar;
class TimeCursor;
class WrenchPlots;

class RecordingPane : public QWidget {
  Q_OBJECT
 public:
  explicit RecordingPane(Playback* playback, QWidget* parent = nullptr);

  /// A new recording: shows all of it from its beginning.
  void setRecording(const Recording* recording);
  /// The estimate on that recording, or null while there is none.
  void setReport(const Recording* recording, const EstimateReport* report);

  /// Folded, only the marks bar stands there, under a line that unfolds it.
  void setFolded(bool folded);
  bool folded() const { return folded_; }
  int foldedHeight() const;

  TimeAxis* timeAxis() { return &axis_; }
  WrenchPlots* plots() { return plots_; }
  MarksBar* marks() { return marks_; }

 signals:
  void pictureWanted();
  /// The user asked for the plots while they were folded.
  void unfoldWanted();

 private:
  TimeAxis axis_;
  Playback* playback_;
  WrenchPlots* plots_;
  MarksBar* marks_;
  PlaybackBar* bar_;
  TimeCursor* cursor_;
  QWidget* header_;
  QWidget* foldedHeader_;
  bool folded_ = false;
};

}  // namespace heft
