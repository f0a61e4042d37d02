#include "ui/wrench_plots/wrench_plots.h"

#include <QKeyEvent>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/models/units.h"
#include "ui/theme/theme.h"
#include "ui/timeline/marks_bar.h"
#include "ui/wrench_plots/lane_ticker.h"
#include "ui/wrench_plots/plot_canvas.h"
#include "ui/wrench_plots/trace_plottable.h"

namespace heft {
namespace {

constexpr int kLaneGap = 6;

}  // namespace

struct WrenchPlots::Parts {
  PlotCanvas* canvas = nullptr;
  std::array<QCPAxisRect*, kLanes> rects{};
  std::array<TracePlottable*, kLanes> traces{};
  std::array<QCPItemRect*, kLanes> noise{};
  std::array<QCPItemText*, kLanes> titles{};
  std::array<QCPItemText*, kLanes> units{};
  std::vector<QCPItemRect*> marks;
  QCPItemText* word = nullptr;  ///< Over the highlighted segment
  int points = 0;
};

WrenchPlots::WrenchPlots(TimeAxis* axis, QWidget* parent)
    : QWidget(parent), axis_(axis), traces_(std::make_shared<WrenchTraces>()), parts_(std::make_unique<Parts>()) {
  setObjectName("wrenchPlots");
  setAccessibleName(tr("Force and torque plots"));
  setAccessibleDescription(
      tr("Measured, simulated and difference over time. Arrow keys move the time, plus and minus zoom."));
  setFocusPolicy(Qt::StrongFocus);
  setMinimumHeight(96);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  Parts& p = *parts_;
  p.canvas = new PlotCanvas(axis, this);
  p.canvas->setFocusProxy(this);
  p.canvas->setMinimumSize(100, 90);
  p.canvas->setNoAntialiasingOnDrag(false);
  p.canvas->setPlottingHints(QCP::phCacheLabels | QCP::phImmediateRefresh);
  layout->addWidget(p.canvas);

  p.canvas->plotLayout()->clear();
  p.canvas->plotLayout()->setRowSpacing(kLaneGap);
  p.canvas->addLayer("marks", p.canvas->layer("grid"), QCustomPlot::limBelow);
  for (int lane = 0; lane < kLanes; ++lane) {
    buildLane(lane);
    nameLane(lane);
  }
  connect(axis_, &TimeAxis::visibleChanged, this, &WrenchPlots::refresh);
  p.canvas->setRescale([this] { refresh(); });
  restyle();
}

void WrenchPlots::buildLane(int lane) {
  Parts& p = *parts_;
  auto* rect = new QCPAxisRect(p.canvas, true);
  p.rects[lane] = rect;
  p.canvas->plotLayout()->addElement(lane, 0, rect);
  p.canvas->plotLayout()->setRowStretchFactor(lane, isDifference(lane) ? 0.75 : 1.1);
  rect->setAutoMargins(QCP::msNone);
  rect->setMargins(QMargins(TimeAxis::kLeft, lane == 0 ? 6 : 0, TimeAxis::kRight, lane == kLanes - 1 ? 4 : 0));
  rect->setMinimumSize(40, 14);
  for (auto* line : rect->axes()) {
    line->setVisible(true);
    line->setTicks(line->axisType() == QCPAxis::atLeft);
    line->setTickLabels(line->axisType() == QCPAxis::atLeft);
    line->setTickLength(0, 0);
    line->setSubTickLength(0, 0);
    line->setLayer("axes");
    line->grid()->setLayer("grid");
  }
  // The vertical grid needs ticks, which are invisible with length zero.
  rect->axis(QCPAxis::atBottom)->setTicks(true);
  rect->axis(QCPAxis::atBottom)->ticker()->setTickCount(11);
  QSharedPointer<QCPAxisTicker> ticker(new LaneTicker(rect, firstChannel(lane) == 0 ? 1.0 : torqueUnit().scale));
  ticker->setTickCount(isDifference(lane) ? 2 : 3);
  rect->axis(QCPAxis::atLeft)->setTicker(ticker);
  rect->axis(QCPAxis::atLeft)->setTickLabelPadding(6);

  p.noise[lane] = new QCPItemRect(p.canvas);
  p.noise[lane]->setLayer("marks");
  for (auto* position : {p.noise[lane]->topLeft, p.noise[lane]->bottomRight}) {
    position->setAxisRect(rect);
    position->setAxes(rect->axis(QCPAxis::atBottom), rect->axis(QCPAxis::atLeft));
    position->setTypeX(QCPItemPosition::ptAxisRectRatio);
    position->setTypeY(QCPItemPosition::ptPlotCoords);
  }
  p.noise[lane]->setClipAxisRect(rect);
  p.noise[lane]->setVisible(false);

  p.traces[lane] = new TracePlottable(rect->axis(QCPAxis::atBottom), rect->axis(QCPAxis::atLeft));
}

void WrenchPlots::nameLane(int lane) {
  Parts& p = *parts_;
  const QString titles[kLanes] = {tr("Force"), tr("residual"), tr("Torque"), tr("residual")};
  const QString units[kLanes] = {tr("N"), QString(), torqueUnit().name, QString()};
  const auto addText = [&](const QString& text) {
    auto* item = new QCPItemText(p.canvas);
    item->setText(text);
    item->setClipToAxisRect(false);
    item->setPositionAlignment(Qt::AlignLeft | (isDifference(lane) ? Qt::AlignVCenter : Qt::AlignTop));
    item->position->setAxisRect(p.rects[lane]);
    item->position->setTypeX(QCPItemPosition::ptAbsolute);
    item->position->setTypeY(QCPItemPosition::ptAxisRectRatio);
    item->position->setCoords(isDifference(lane) ? 8 : 12, isDifference(lane) ? 0.5 : 0.0);
    return item;
  };
  p.titles[lane] = addText(titles[lane]);
  if (!isDifference(lane)) {
    p.units[lane] = addText(units[lane]);
    p.units[lane]->position->setParentAnchor(p.titles[lane]->bottomLeft);
    p.units[lane]->position->setType(QCPItemPosition::ptAbsolute);
    p.units[lane]->position->setCoords(0, 1);
  }
}

WrenchPlots::~WrenchPlots() = default;

void WrenchPlots::setTraces(std::shared_ptr<const WrenchTraces> traces) {
  // Values of another recording, or of none, are scaled to their own curves.
  if (!traces || traces->lastTime() != traces_->lastTime()) parts_->canvas->forgetValues();
  traces_ = traces ? std::move(traces) : std::make_shared<WrenchTraces>();
  refresh();
}

void WrenchPlots::setSegments(std::vector<Segment> segments) {
  segments_ = std::move(segments);
  rebuildBackgrounds();
  parts_->canvas->replot(QCustomPlot::rpQueuedReplot);
}

void WrenchPlots::setBrush(std::optional<MarkLabel> brush) { parts_->canvas->setBrush(brush); }

void WrenchPlots::setSecondCursor(double time) { parts_->canvas->setSecond(time); }

void WrenchPlots::setShown(Shown what, bool shown) {
  shown_[static_cast<int>(what)] = shown;
  if (what == Shown::difference) {
    for (const int lane : {1, 3}) {
      parts_->rects[lane]->setVisible(shown);
      parts_->titles[lane]->setVisible(shown);
      parts_->rects[lane]->setMinimumSize(40, shown ? 14 : 0);
      parts_->rects[lane]->setMaximumSize(QWIDGETSIZE_MAX, shown ? QWIDGETSIZE_MAX : 0);
    }
  }
  refresh();
}

bool WrenchPlots::isShown(Shown what) const { return shown_[static_cast<int>(what)]; }

MinMax WrenchPlots::laneRange(int lane) const {
  const QCPRange range = parts_->rects[lane]->axis(QCPAxis::atLeft)->range();
  return {range.lower, range.upper};
}

MinMax WrenchPlots::laneTime(int lane) const {
  const QCPRange range = parts_->rects[lane]->axis(QCPAxis::atBottom)->range();
  return {range.lower, range.upper};
}

int WrenchPlots::pointsDrawn() const { return parts_->points; }

void WrenchPlots::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && parts_ && parts_->canvas) restyle();
}

void WrenchPlots::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  refresh();
}

void WrenchPlots::keyPressEvent(QKeyEvent* event) {
  const double middle = (axis_->lower() + axis_->upper()) / 2.0;
  switch (event->key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      axis_->zoom(0.7, middle);
      return;
    case Qt::Key_Minus:
      axis_->zoom(1.0 / 0.7, middle);
      return;
    case Qt::Key_0:
      axis_->showAll();
      return;
    default:
      QWidget::keyPressEvent(event);  // The window moves the time by the arrow keys.
  }
}

void WrenchPlots::restyle() {
  const Theme& t = theme();
  Parts& p = *parts_;
  p.canvas->setBackground(QBrush(t.panel));
  for (int lane = 0; lane < kLanes; ++lane) {
    for (auto* line : p.rects[lane]->axes()) {
      line->setBasePen(QPen(t.line, 1));
      line->setTickPen(Qt::NoPen);
      line->setSubTickPen(Qt::NoPen);
      line->setTickLabelFont(uiFont(type::kTick));
      line->setTickLabelColor(t.text3);
      line->grid()->setPen(QPen(t.plotGrid, 1));
      line->grid()->setZeroLinePen(QPen(t.plotZero, 1));
      line->grid()->setVisible(line->axisType() == QCPAxis::atLeft || line->axisType() == QCPAxis::atBottom);
      if (line->axisType() == QCPAxis::atBottom) line->grid()->setZeroLinePen(QPen(t.plotGrid, 1));
    }
    p.noise[lane]->setPen(Qt::NoPen);
    p.noise[lane]->setBrush(t.noise);
    p.titles[lane]->setFont(isDifference(lane) ? uiFont(type::kCaption) : uiFont(type::kSection, QFont::DemiBold));
    p.titles[lane]->setColor(isDifference(lane) ? t.text3 : t.text);
    if (p.units[lane]) {
      p.units[lane]->setFont(uiFont(type::kCaption));
      p.units[lane]->setColor(t.text3);
    }
  }
  rebuildBackgrounds();
  refresh();
}

void WrenchPlots::setHighlight(double from, double to, const QString& word) {
  highlightFrom_ = from;
  highlightTo_ = to;
  highlightWord_ = word;
  rebuildBackgrounds();
  parts_->canvas->replot(QCustomPlot::rpQueuedReplot);
}

void WrenchPlots::rebuildBackgrounds() {
  Parts& p = *parts_;
  for (auto* mark : p.marks) p.canvas->removeItem(mark);
  p.marks.clear();
  if (p.word) p.canvas->removeItem(p.word);
  p.word = nullptr;
  const auto tintLanes = [&p](double from, double to, const QPen& edge, const QColor& tint) {
    for (int lane = 0; lane < kLanes; ++lane) {
      auto* mark = new QCPItemRect(p.canvas);
      mark->setLayer("marks");
      for (auto* position : {mark->topLeft, mark->bottomRight}) {
        position->setAxisRect(p.rects[lane]);
        position->setAxes(p.rects[lane]->axis(QCPAxis::atBottom), p.rects[lane]->axis(QCPAxis::atLeft));
        position->setTypeX(QCPItemPosition::ptPlotCoords);
        position->setTypeY(QCPItemPosition::ptAxisRectRatio);
      }
      mark->topLeft->setCoords(from, 0);
      mark->bottomRight->setCoords(to, 1);
      mark->setClipAxisRect(p.rects[lane]);
      mark->setPen(edge);
      mark->setBrush(tint);
      p.marks.push_back(mark);
    }
  };
  for (const Segment& segment : segments_) {
    if (segment.label == MarkLabel::free) continue;
    QColor tint = markColour(segment.label);
    tint.setAlpha(segment.label == MarkLabel::contact ? (theme().dark ? 45 : 46) : (theme().dark ? 60 : 70));
    tintLanes(segment.from, segment.to, Qt::NoPen, tint);
  }
  if (!(highlightTo_ > highlightFrom_)) return;
  QColor accent = theme().accent;
  accent.setAlpha(theme().dark ? 40 : 22);
  tintLanes(highlightFrom_, highlightTo_, QPen(theme().accent, 1.2, Qt::DashLine), accent);
  p.word = new QCPItemText(p.canvas);
  p.word->setLayer("overlay");  // Over the curves
  p.word->position->setAxisRect(p.rects[0]);
  p.word->position->setAxes(p.rects[0]->axis(QCPAxis::atBottom), p.rects[0]->axis(QCPAxis::atLeft));
  p.word->position->setTypeX(QCPItemPosition::ptPlotCoords);
  p.word->position->setTypeY(QCPItemPosition::ptAxisRectRatio);
  p.word->position->setCoords(highlightFrom_, 0);
  p.word->setPositionAlignment(Qt::AlignLeft | Qt::AlignTop);
  p.word->setPadding(QMargins(5, 1, 5, 1));
  p.word->setClipAxisRect(p.rects[0]);
  p.word->setText(highlightWord_);
  p.word->setFont(uiFont(type::kTick, QFont::DemiBold));
  p.word->setColor(theme().accent);
  p.word->setBrush(theme().panel);
}

void WrenchPlots::refresh() {
  Parts& p = *parts_;
  // The canvas learns its ratio when it is made, before it knows its screen.
  if (p.canvas->bufferDevicePixelRatio() != p.canvas->devicePixelRatioF())
    p.canvas->setBufferDevicePixelRatio(p.canvas->devicePixelRatioF());
  const double from = axis_->lower(), to = axis_->upper();
  const int pixels = std::max(50, width() - TimeAxis::kLeft - TimeAxis::kRight);
  p.points = 0;
  for (int lane = 0; lane < kLanes; ++lane) {
    QCPAxisRect* rect = p.rects[lane];
    for (auto* line : {rect->axis(QCPAxis::atBottom), rect->axis(QCPAxis::atTop)}) line->setRange(from, to);
    constexpr int kTwoLines = 32;  // [px]
    if (p.units[lane]) p.units[lane]->setVisible(rect->height() >= kTwoLines);
    const int first = firstChannel(lane);
    double lower, upper;
    if (isDifference(lane)) {
      upper = traces_->differenceLimit(first);
      lower = -upper;
      const double band = traces_->noiseBand(first);
      p.noise[lane]->setVisible(band > 0 && shown_[static_cast<int>(Shown::difference)]);
      p.noise[lane]->topLeft->setCoords(0, band);
      p.noise[lane]->bottomRight->setCoords(1, -band);
    } else {
      MinMax extremes = traces_->visibleRange(first, from, to);
      if (p.canvas->freeScale()) {
        MinMax free{std::nan(""), std::nan("")};
        for (const Segment& segment : segments_) {
          if (segment.label != MarkLabel::free || segment.to < from || segment.from > to) continue;
          const MinMax part = traces_->visibleRange(first, std::max(from, segment.from), std::min(to, segment.to));
          free.lowest = std::fmin(free.lowest, part.lowest);
          free.highest = std::fmax(free.highest, part.highest);
        }
        if (std::isfinite(free.lowest)) extremes = free;
      }
      lower = std::isfinite(extremes.lowest) ? extremes.lowest : -1.0;
      upper = std::isfinite(extremes.highest) ? extremes.highest : 1.0;
      const double least = first == 0 ? 0.1 : 0.005;
      const double margin = std::max(0.08 * (upper - lower), least / 2);
      lower -= margin;
      upper += margin;
    }
    const QCPRange values = p.canvas->values(lane).value_or(QCPRange(lower, upper));
    for (auto* line : {rect->axis(QCPAxis::atLeft), rect->axis(QCPAxis::atRight)}) line->setRange(values);

    std::vector<TracePlottable::Trace> traces;
    const auto add = [&](WrenchTraces::Kind kind, Shown shownAs, const std::array<QColor, 3>& colours,
                         double thickness) {
      for (int c = 0; c < 3; ++c) {
        if (!isShown(static_cast<Shown>(c)) || !isShown(shownAs)) continue;
        const bool simulated = kind == WrenchTraces::Kind::simulated;
        QColor colour = colours[static_cast<std::size_t>(c)];
        // The noise of three channels overlaps: each is translucent.
        if (kind == WrenchTraces::Kind::difference) colour.setAlphaF(0.62);
        traces.push_back({traces_->thinned(kind, first + c, from, to, pixels), colour, thickness, simulated,
                          traces_->poses() && !simulated});
        p.points += traces.back().curve.x.size();
      }
    };
    if (isDifference(lane)) {
      add(WrenchTraces::Kind::difference, Shown::difference, theme().axis, 1.1);
    } else {
      add(WrenchTraces::Kind::measured, Shown::measured, theme().axis, 1.5);
      add(WrenchTraces::Kind::simulated, Shown::simulated, theme().axisSimulated, 1.4);
    }
    p.traces[static_cast<std::size_t>(lane)]->setTraces(std::move(traces));
  }
  p.canvas->replot(QCustomPlot::rpQueuedReplot);
}

}  // namespace heft
