#include "ui/wrench_plots/recording_pane.h"

#include <QApplication>
#include <QClipboard>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QVBoxLayout>
#include <limits>

#include "ui/models/glossary.h"
#include "ui/timeline/marks_bar.h"
#include "ui/timeline/overview_strip.h"
#include "ui/timeline/playback.h"
#include "ui/timeline/playback_bar.h"
#include "ui/timeline/time_cursor.h"
#include "ui/widgets/basics.h"
#include "ui/widgets/pane_header.h"
#include "ui/wrench_plots/channel_lanes.h"
#include "ui/wrench_plots/difference_cursor.h"
#include "ui/wrench_plots/legend.h"
#include "ui/wrench_plots/visible_csv.h"
#include "ui/wrench_plots/wrench_plots.h"

namespace heft {
namespace {

/// An entry of the legend that says less where the header has no room for all of its parts.
class LegendFitter : public QObject {
 public:
  LegendFitter(LegendEntry* entry, const QString& shortText, QWidget* header)
      : QObject(header), entry_(entry), short_(shortText), header_(header) {}

 protected:
  bool eventFilter(QObject*, QEvent* event) override {
    // A button of the header was shown or hidden, or the header was resized.
    if (event->type() == QEvent::Resize || event->type() == QEvent::LayoutRequest) {
      const int others = header_->layout()->sizeHint().width() - entry_->sizeHint().width();
      entry_->setShortText(others + entry_->wholeWidth() > header_->width() ? short_ : QString());
    }
    return false;
  }

 private:
  LegendEntry* entry_;
  QString short_;
  QWidget* header_;
};

/// A title that makes room for what can be clicked.
class TitleFitter : public QObject {
 public:
  TitleFitter(QWidget* title, QWidget* header) : QObject(header), title_(title), header_(header) {
    header->installEventFilter(this);
  }

 protected:
  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() == QEvent::Resize) {
      const int others =
          header_->layout()->minimumSize().width() - (title_->isHidden() ? 0 : title_->sizeHint().width());
      title_->setVisible(others + title_->sizeHint().width() <= header_->width());
    }
    return false;
  }

 private:
  QWidget* title_;
  QWidget* header_;
};

}  // namespace

RecordingPane::RecordingPane(Playback* playback, QWidget* parent) : QWidget(parent), playback_(playback) {
  const PaneHeader top = dressAsPane(this, tr("Force and torque at the sensor"));
  QVBoxLayout* column = top.column;
  header_ = top.header;
  top.row->setSpacing(2);
  top.row->addSpacing(8);
  auto* body = new QWidget(this);
  auto* bodyColumn = new QVBoxLayout(body);
  bodyColumn->setContentsMargins(0, 0, 0, 0);
  bodyColumn->setSpacing(0);
  plots_ = new WrenchPlots(&axis_, body);
  bodyColumn->addWidget(plots_, 3);
  channels_ = new ChannelLanes(&axis_, body);
  bodyColumn->addWidget(channels_, 2);
  marks_ = new MarksBar(&axis_, body);
  bodyColumn->addWidget(marks_);
  constexpr int kTicksHeight = 24;
  difference_ = new DifferenceCursor(&axis_, body, kTicksHeight);
  cursor_ = new TimeCursor(&axis_, body, kTicksHeight);
  addLegend(top.row);
  if (auto* title = header_->findChild<QLabel*>("plotTitle")) new TitleFitter(title, header_);
  top.row->addStretch(1);
  addButtons(top.row);
  makeFoldedHeader();
  column->addWidget(foldedHeader_);
  column->addWidget(body, 1);
  overview_ = new OverviewStrip(&axis_, this);
  column->addWidget(overview_);
  bar_ = new PlaybackBar(playback, this, &axis_);
  column->addWidget(bar_);
  connectParts();
  showParts();
}

void RecordingPane::addLegend(QHBoxLayout* row) {
  using Shown = WrenchPlots::Shown;
  const std::pair<Shown, QString> entries[] = {{Shown::x, tr("x")},
                                               {Shown::y, tr("y")},
                                               {Shown::z, tr("z")},
                                               {Shown::measured, tr("measured")},
                                               {Shown::simulated, tr("simulated")},
                                               {Shown::difference, tr("residual (grey: noise)")}};
  for (const auto& [what, text] : entries) {
    auto* entry = new LegendEntry(what, text, header_);
    entry->setObjectName(QStringLiteral("legend%1").arg(static_cast<int>(what)));
    connect(entry, &QAbstractButton::toggled, plots_, [this, shown = what](bool on) { plots_->setShown(shown, on); });
    if (what == Shown::difference) entry->setToolTip(glossaryTip("residual"));
    row->addWidget(entry);
    if (what == Shown::z) row->addSpacing(10);
    if (what == Shown::difference) header_->installEventFilter(new LegendFitter(entry, tr("residual"), header_));
  }
}

void RecordingPane::addButtons(QHBoxLayout* row) {
  measure_ = new IconButton("cursors", tr("Measure between two cursors (Ctrl+click sets the second)"), header_);
  measure_->setObjectName("measureButton");
  measure_->setCheckable(true);
  row->addWidget(measure_);
  channelButton_ = new IconButton("channels", tr("Further channels: joints, pose, speeds"), header_);
  channelButton_->setObjectName("channelButton");
  channelButton_->setPopupMode(QToolButton::InstantPopup);
  channelButton_->setMenu(new QMenu(channelButton_));
  row->addWidget(channelButton_);
  auto* all = new IconButton("whole", tr("Show the whole recording (0)"), header_);
  all->setObjectName("showAllButton");
  row->addWidget(all);
  auto* alone = new IconButton("fit", tr("Maximise the plots, or restore them (F11)"), header_);
  alone->setObjectName("aloneButton");  // The window listens to it.
  row->addWidget(alone);
  connect(all, &QToolButton::clicked, &axis_, &TimeAxis::showAll);
  auto* more = new IconButton("more", tr("Picture of the plots, table of the visible segment"), header_);
  more->setObjectName("plotsMoreButton");
  more->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(more);
  menu->addAction(tr("Copy picture"), this, [this] { QApplication::clipboard()->setImage(grab().toImage()); });
  menu->addAction(tr("Save a picture of the plots"), this, &RecordingPane::pictureWanted);
  menu->addAction(tr("Export visible range as CSV"), this, &RecordingPane::csvWanted);
  more->setMenu(menu);
  row->addWidget(more);
  // Beside the legend there is little room on a small screen.
  constexpr int kNarrow = 28;  // [px]
  for (auto* button : {measure_, channelButton_, all, alone, more}) button->setFixedWidth(kNarrow);
}

void RecordingPane::makeFoldedHeader() {
  foldedHeader_ = new QWidget(this);
  foldedHeader_->setObjectName("plotHeader");
  foldedHeader_->setAttribute(Qt::WA_StyledBackground);
  foldedHeader_->setFixedHeight(36);
  auto* foldedRow = new QHBoxLayout(foldedHeader_);
  foldedRow->setContentsMargins(12, 0, 12, 0);
  foldedRow->addWidget(styledLabel(tr("Recording"), "plotTitle", foldedHeader_));
  foldedRow->addStretch(1);
  auto* unfold = new QPushButton(tr("Show force and torque"), foldedHeader_);
  unfold->setObjectName("linkButton");
  connect(unfold, &QPushButton::clicked, this, &RecordingPane::unfoldWanted);
  foldedRow->addWidget(unfold);
  foldedHeader_->hide();
}

void RecordingPane::connectParts() {
  connect(plots_, &WrenchPlots::timePicked, playback_, &Playback::setTime);
  connect(marks_, &MarksBar::timePicked, playback_, &Playback::setTime);
  connect(channels_, &ChannelLanes::timePicked, playback_, &Playback::setTime);
  connect(playback_, &Playback::timeChanged, overview_, &OverviewStrip::setTime);
  // What plays goes on in view.
  connect(playback_, &Playback::timeChanged, this, [this](double time) {
    if (playback_->playing()) axis_.reveal(time);
  });
  connect(channels_, &ChannelLanes::chosenChanged, this, &RecordingPane::showParts);
  connect(&axis_, &TimeAxis::visibleChanged, this, &RecordingPane::showParts);
  connect(channelButton_->menu(), &QMenu::aboutToShow, this, &RecordingPane::fillChannelMenu);
  connect(playback_, &Playback::timeChanged, cursor_, &TimeCursor::setTime);
  connect(playback_, &Playback::timeChanged, marks_, &MarksBar::setTime);
  connect(marks_, &MarksBar::painted, this, &RecordingPane::painted);
  connect(marks_, &MarksBar::brushPicked, this, &RecordingPane::brushPicked);
  connect(plots_, &WrenchPlots::stroked, this, [this](double from, double to) {
    if (brush_) emit painted(from, to, *brush_);
  });
  connect(measure_, &QToolButton::toggled, this, &RecordingPane::setMeasuring);
  connect(playback_, &Playback::timeChanged, difference_, &DifferenceCursor::setFirst);
  connect(plots_, &WrenchPlots::secondPicked, this, [this](double time) {
    difference_->setSecond(time);
    plots_->setSecondCursor(difference_->second());
  });
}

void RecordingPane::fillChannelMenu() {
  QMenu* menu = channelButton_->menu();
  menu->clear();
  QMenu* group = nullptr;
  for (const Channel& channel : channels_->channels()) {
    if (!group || group->title() != channel.group) {
      group = menu->addMenu(channel.group);
      QAction* every = group->addAction(tr("All of these"), this, [this, name = channel.group] {
        QStringList now;
        for (const Channel& each : channels_->channels())
          if (each.group == name || channels_->isChosen(each.id)) now << each.id;
        channels_->setChosen(now);
      });
      every->setObjectName(QStringLiteral("channelsAll"));
      group->addSeparator();
    }
    QAction* action = group->addAction(
        channel.unit.isEmpty() ? channel.label : QStringLiteral("%1 [%2]").arg(channel.label, channel.unit));
    action->setCheckable(true);
    action->setChecked(channels_->isChosen(channel.id));
    connect(action, &QAction::toggled, this, [this, id = channel.id](bool on) { channels_->choose(id, on); });
  }
  menu->addSeparator();
  menu->addAction(tr("None"), this, [this] { channels_->setChosen({}); });
}

void RecordingPane::setBrush(std::optional<MarkLabel> brush, bool inPlots) {
  brush_ = brush;
  marks_->setBrush(brush);
  plots_->setBrush(inPlots ? brush : std::nullopt);
}

void RecordingPane::highlight(double from, double to, const QString& word) {
  plots_->setHighlight(from, to, word);
  if (to > from) axis_.show(from - 0.4 * (to - from), to + 0.4 * (to - from));
}

void RecordingPane::setMeasuring(bool on) {
  measure_->setChecked(on);
  if (on == difference_->isVisibleTo(this)) return;
  difference_->setVisible(on);
  if (on) {
    difference_->setFirst(playback_->time());
    difference_->setSecond(axis_.lower() + 0.75 * axis_.span());
  }
  plots_->setSecondCursor(on ? difference_->second() : std::numeric_limits<double>::quiet_NaN());
}

std::string RecordingPane::visibleText() const { return visibleCsv(*plots_->traces(), axis_.lower(), axis_.upper()); }

void RecordingPane::setFolded(bool folded) {
  folded_ = folded;
  header_->setVisible(!folded);
  foldedHeader_->setVisible(folded);
  plots_->setVisible(!folded);
  bar_->setVisible(!folded);
  showParts();
}

/// Those that are there only while they have something to show.
void RecordingPane::showParts() {
  channels_->setVisible(!folded_ && channels_->lanes() > 0);
  overview_->setVisible(!folded_ && !live_ && !axis_.showsAll());
}

int RecordingPane::foldedHeight() const { return foldedHeader_->height() + marks_->height() + 12; }

void RecordingPane::setRecording(std::shared_ptr<const Recording> recording,
                                 std::shared_ptr<const EstimateReport> report,
                                 std::shared_ptr<const RobotModel> robot) {
  if (live_) bar_->setVisible(!folded_);
  live_ = false;
  recording_ = std::move(recording);
  const bool present = recording_ && recording_->rows() > 0;
  const bool poses = present && recording_->meta.kind == RecordingKind::poses;
  const double first = poses ? 1.0 : present ? recording_->time(0) : 0.0;
  const double last = poses     ? static_cast<double>(recording_->rows())
                      : present ? recording_->time(recording_->rows() - 1)
                                : 1.0;
  playback_->setRange(first, last, poses);
  axis_.setFull(first, last, poses);
  setTraces(nullptr);
  channels_->setRecording(recording_, std::move(robot));
  channelButton_->setEnabled(!channels_->channels().empty());
  showParts();
  setSegments({}, {});
  plots_->setHighlight(0.0, 0.0, {});
  cursor_->setTime(playback_->time());
  cursor_->setShown(present);
  setMeasuring(false);
  bar_->setRecording(present);
  setReport(std::move(report));
}

void RecordingPane::setReport(std::shared_ptr<const EstimateReport> report) {
  if (!recording_) return jobs_.cancel();
  using Traces = std::shared_ptr<const WrenchTraces>;
  jobs_.start(
      tr("Drawing the curves"),
      [recording = recording_, report = std::move(report)](const Progress&) -> Result<Traces> {
        return std::make_shared<const WrenchTraces>(*recording, report.get());
      },
      [this](Result<Traces> traces) {
        if (traces && recording_ && !live_) setTraces(std::move(traces).value());
      });
}

void RecordingPane::setTraces(std::shared_ptr<const WrenchTraces> traces) {
  plots_->setTraces(std::move(traces));
  difference_->setTraces(plots_->traces());
}

void RecordingPane::showLive(std::shared_ptr<const WrenchTraces> traces, const std::vector<Segment>& touched,
                             double now) {
  constexpr double kWindow = 30.0, kAhead = 3.0;  // [s]
  if (!live_) {
    live_ = true;
    bar_->hide();
    axis_.setFull(0.0, kWindow);
    cursor_->setShown(true);
  }
  // Free in between: what the marks bar shows as it will be proposed.
  std::vector<Segment> segments;
  std::vector<bool> suggested;
  double at = 0.0;
  const auto addFree = [&](double to) {
    if (to - at < 0.02) return;
    Segment segment;
    segment.from = at;
    segment.to = to;
    segments.push_back(segment);
    suggested.push_back(false);
  };
  for (const Segment& touch : touched) {
    addFree(touch.from);
    segments.push_back(touch);
    suggested.push_back(true);
    at = touch.to;
  }
  addFree(now);
  setTraces(std::move(traces));
  axis_.grow(now + kAhead);
  setSegments(segments, suggested);
  cursor_->setTime(now);
}

void RecordingPane::setSegments(const std::vector<Segment>& segments, const std::vector<bool>& suggested) {
  plots_->setSegments(segments);
  marks_->setSegments(segments, suggested);
  overview_->setSegments(segments);
}

}  // namespace heft
