#include "ui/wrench_plots/wrench_plots.h"

#include <qcustomplot.h>

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

#include "ui/models/numbers.h"
#include "ui/models/units.h"
#include "ui/theme/theme.h"
#include "ui/timeline/marks_bar.h"
#include "ui/timeline/time_mouse.h"
#include "ui/wrench_plots/trace_plottable.h"

namespace heft {
namespace {

constexpr int kLanes = 4;
constexpr int kLaneGap = 6;

bool isDifference(int lane) { return lane % 2 == 1; }
int firstChannel(int lane) { return lane < 2 ? 0 : 3; }

/// Few ticks with a real minus sign; none so near an edge that its number would run into the next lane's.
class LaneTicker : public QCPAxisTicker {
 public:
  /// `scale`: from the curves' unit to the one that is shown.
  LaneTicker(const QCPAxisRect* lane, double scale) : lane_(lane), scale_(scale) {}

 protected:
  QString getTickLabel(double tick, const QLocale&, QChar, int) override {
    const double above = (tick - range_.lower) / range_.size() * lane_->height();
    if (above < kHalfNumber || above > lane_->height() - kHalfNumber) return {};
    if (std::abs(tick) < 1e-9 * std::max(1.0, mTickStep_)) return QStringLiteral("0");
    const double step = scale_ * std::abs(mTickStep_);
    int decimals = 0;
    while (decimals < 6 && std::abs(std::round(step * std::pow(10, decimals)) - step * std::pow(10, decimals)) > 1e-6) {
      ++decimals;
    }
    return numberText(scale_ * tick, decimals);
  }
  double getTickStep(const QCPRange& range) override {
    range_ = range;
    // About zero with little height, or where the usual step finds no room: one number above and one below it, as far
    // out as a number has room.
    constexpr double kLow = 56.0;  // [px]
    if (range.lower < 0.0 && range.upper > 0.0 && std::abs(range.lower + range.upper) < 1e-6 * range.size() &&
        lane_->height() > 4.0 * kHalfNumber) {
      const double most = (1.0 - 2.0 * (kHalfNumber + 0.5) / lane_->height()) * range.upper * scale_;
      if (lane_->height() >= kLow)
        if (const double usual = QCPAxisTicker::getTickStep(range); usual * scale_ <= most) return mTickStep_ = usual;
      const double decade = std::pow(10.0, std::floor(std::log10(most)));
      constexpr double kApart = 10.0;  // [px] of numbers one above the other
      for (const double round : {8.0, 6.0, 5.0, 4.0, 3.0, 2.0, 1.5, 1.2, 1.0}) {
        const double step = round * decade / scale_;
        if (round * decade <= most && step / range.size() * lane_->height() >= kApart) return mTickStep_ = step;
      }
    }
    mTickStep_ = QCPAxisTicker::getTickStep(range);
    // In a low lane numbers must not touch each other; the next round step above, so that two of them remain.
    constexpr double kNumber = 12.0;  // [px]
    const double least = lane_->height() > 0 ? kNumber / lane_->height() * range.size() : 0.0;
    if (!(mTickStep_ < least)) return mTickStep_;
    const double decade = std::pow(10.0, std::floor(std::log10(least)));
    for (const double round : {1.0, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0}) {
      mTickStep_ = round * decade;
      if (mTickStep_ >= least) break;
    }
    return mTickStep_;
  }

 private:
  static constexpr double kHalfNumber = 4.0;  ///< [px] Half the height of a number: nearer to an edge it is left out
  const QCPAxisRect* lane_;
  double scale_;
  QCPRange range_;
  double mTickStep_ = 1.0;
};

/// QCustomPlot with the mouse as the studio uses it, the same in all lanes.
class PlotCanvas : public QCustomPlot {
 public:
  PlotCanvas(TimeAxis* axis, WrenchPlots* owner) : QCustomPlot(owner), axis_(axis), owner_(owner) {
    setInteractions(QCP::Interactions());
    setMouseTracking(true);
    // The keyboard's frame stands on the canvas, which does not have the focus itself.
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget* before, QWidget* now) {
      if (before == owner_ || now == owner_) update();
    });
  }
  void setBrush(std::optional<MarkLabel> brush) { brush_ = brush; }
  bool freeScale() const { return freeScale_; }
  void setRescale(std::function<void()> rescale) { rescale_ = std::move(rescale); }
  void setSecond(double time) { second_ = time; }
  /// What the user zoomed a lane's values to; nothing: as the curves need.
  std::optional<QCPRange> values(int lane) const { return values_[static_cast<std::size_t>(lane)]; }
  void forgetValues() { values_.fill({}); }

 protected:
  void wheelEvent(QWheelEvent* event) override {
    const int lane = axisRectIndex(event->position().toPoint());
    if (!(event->modifiers() & Qt::ControlModifier) || lane < 0) return TimeMouse::wheel(axis_, event, width());
    const QCPAxis* values = axisRect(lane)->axis(QCPAxis::atLeft);
    const double factor = std::pow(0.8, event->angleDelta().y() / 120.0);
    const double fixed = values->pixelToCoord(event->position().y());
    showValues(lane, fixed + factor * (values->range().lower - fixed),
               fixed + factor * (values->range().upper - fixed));
    event->accept();
  }

  void mousePressEvent(QMouseEvent* event) override {
    owner_->setFocus(Qt::MouseFocusReason);
    pressed_ = event->pos();
    moved_ = false;
    const bool pans = event->button() == Qt::MiddleButton ||
                      (event->button() == Qt::LeftButton && (event->modifiers() & Qt::ShiftModifier));
    mode_ = pans ? Mode::pan : event->button() == Qt::LeftButton ? Mode::band : Mode::none;
    pressedLower_ = axis_->lower();
    const bool grabs = std::abs(axis_->toX(second_, width()) - pressed_.x()) < 5;
    if (event->button() == Qt::LeftButton && std::isfinite(second_) &&
        (grabs || (event->modifiers() & Qt::ControlModifier))) {
      mode_ = Mode::second;
      emit owner_->secondPicked(axis_->toTime(pressed_.x(), width()));
    }
  }

  void contextMenuEvent(QContextMenuEvent* event) override {
    QMenu menu(this);
    menu.addAction(WrenchPlots::tr("Show the whole recording"), axis_, &TimeAxis::showAll);
    menu.addAction(WrenchPlots::tr("Scale the values to the curves"), this, [this] {
      forgetValues();
      if (rescale_) rescale_();
    });
    QAction* free = menu.addAction(WrenchPlots::tr("Scale to the free parts"));
    free->setCheckable(true);
    free->setChecked(freeScale_);
    free->setToolTip(WrenchPlots::tr("A contact may go out of the picture, so that the rest can be seen"));
    connect(free, &QAction::toggled, this, [this](bool on) {
      freeScale_ = on;
      if (rescale_) rescale_();
    });
    menu.addSeparator();
    menu.addAction(WrenchPlots::tr("Copy picture"), this,
                   [this] { QApplication::clipboard()->setImage(owner_->grab().toImage()); });
    menu.exec(event->globalPos());
  }

  void leaveEvent(QEvent* event) override {
    QCustomPlot::leaveEvent(event);
    pointer_ = {-1, -1};
    update();
  }

  void mouseMoveEvent(QMouseEvent* event) override {
    pointer_ = event->buttons() == Qt::NoButton ? event->pos() : QPoint(-1, -1);
    if (event->buttons() == Qt::NoButton) update();
    if (mode_ == Mode::second) return emit owner_->secondPicked(axis_->toTime(event->pos().x(), width()));
    if (mode_ == Mode::none || !(event->buttons() & (Qt::LeftButton | Qt::MiddleButton))) return;
    if ((event->pos() - pressed_).manhattanLength() > 4) moved_ = true;
    if (!moved_) return;
    if (mode_ == Mode::pan) {
      const double seconds = axis_->toTime(pressed_.x(), width()) - axis_->toTime(event->pos().x(), width());
      axis_->show(pressedLower_ + seconds, pressedLower_ + seconds + axis_->span());
      setCursor(Qt::ClosedHandCursor);
    } else {
      band_ = {pressed_.x(), event->pos().x()};
      box_ = brush_ ? std::nullopt : boxTo(event->pos());
      update();
    }
  }

  void mouseReleaseEvent(QMouseEvent* event) override {
    const Mode mode = mode_;
    mode_ = Mode::none;
    unsetCursor();
    band_ = {0, 0};
    const auto box = std::exchange(box_, std::nullopt);
    update();
    if (mode == Mode::none || mode == Mode::second) return;
    const double from = axis_->toTime(pressed_.x(), width()), to = axis_->toTime(event->pos().x(), width());
    if (!moved_) {
      emit owner_->timePicked(to);
    } else if (mode == Mode::band && brush_) {
      emit owner_->stroked(std::min(from, to), std::max(from, to));
    } else if (mode == Mode::band) {
      if (box) {
        const QCPAxis* values = axisRect(box->lane)->axis(QCPAxis::atLeft);
        showValues(box->lane, values->pixelToCoord(box->bottom), values->pixelToCoord(box->top));
      }
      axis_->show(std::min(from, to), std::max(from, to));
    }
  }

  void mouseDoubleClickEvent(QMouseEvent*) override {
    forgetValues();
    axis_->showAll();
    if (rescale_) rescale_();
  }

  void paintEvent(QPaintEvent* event) override {
    QCustomPlot::paintEvent(event);
    QPainter painter(this);
    if (owner_->hasFocus()) {
      painter.setPen(QPen(theme().accent, 2));
      painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
    if (band_.first == band_.second) return paintValues(painter);
    QColor fill = brush_ ? markColour(*brush_) : theme().text2;
    fill.setAlpha(brush_ ? 110 : 40);
    QRectF area(std::min(band_.first, band_.second), 0, std::abs(band_.second - band_.first), height());
    if (box_) area = QRectF(QPointF(area.left(), box_->top), QPointF(area.right(), box_->bottom));
    painter.fillRect(area, fill);
    painter.setPen(theme().text2);
    if (box_) painter.drawRect(area);
    painter.drawLine(area.topLeft(), area.bottomLeft());
    painter.drawLine(area.topRight(), area.bottomRight());
  }

 private:
  /// Under the pointer: the time, and what the lane's curves read there.
  void paintValues(QPainter& painter) const {
    const int lane = axisRectIndex(pointer_);
    const auto& traces = *owner_->traces();
    if (lane < 0 || traces.empty() || pointer_.x() < TimeAxis::kLeft || pointer_.x() > width() - TimeAxis::kRight)
      return;
    const double time = axis_->toTime(pointer_.x(), width());
    const int first = firstChannel(lane);
    const ShownUnit unit = first == 0 ? ShownUnit{QStringLiteral("N"), 1.0, 0} : torqueUnit();
    const int decimals = (first == 0 ? 2 : 3) + unit.decimals;
    QStringList rows{timeText(time, traces.poses())};
    for (int c = 0; c < 3; ++c) {
      const auto read = [&](WrenchTraces::Kind kind) {
        const double value = traces.valueAt(kind, first + c, time);
        return std::isfinite(value) ? numberText(unit.scale * value, decimals) : QString(QChar(0x2013));
      };
      const QString name = QString(QChar('x' + c));
      rows << (isDifference(lane) ? QStringLiteral("%1  %2").arg(name, read(WrenchTraces::Kind::difference))
               : traces.hasSimulated()
                   ? QStringLiteral("%1  %2  (%3)")
                         .arg(name, read(WrenchTraces::Kind::measured), read(WrenchTraces::Kind::simulated))
                   : QStringLiteral("%1  %2").arg(name, read(WrenchTraces::Kind::measured)));
    }
    painter.setFont(uiFont(type::kCaption));
    const QFontMetrics metrics(painter.font());
    int wide = 0;
    for (const QString& row : rows) wide = std::max(wide, metrics.horizontalAdvance(row));
    const int line = metrics.height(), high = line * static_cast<int>(rows.size()) + 10;
    QRect box(pointer_ + QPoint(14, -high / 2), QSize(wide + 18, high));
    if (box.right() > width() - TimeAxis::kRight) box.moveRight(pointer_.x() - 14);
    box.moveTop(std::clamp(box.top(), 2, std::max(2, height() - high - 2)));
    const Theme& t = theme();
    QColor ground = t.panel;
    ground.setAlpha(235);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(t.line, 1));
    painter.setBrush(ground);
    painter.drawRoundedRect(box, 6, 6);
    for (int r = 0; r < rows.size(); ++r) {
      painter.setPen(r == 0 ? t.text2 : t.axis[static_cast<std::size_t>(r - 1)]);
      painter.drawText(QRect(box.left() + 9, box.top() + 5 + r * line, wide, line), Qt::AlignLeft | Qt::AlignVCenter,
                       rows[r]);
    }
  }
  int axisRectIndex(const QPoint& at) const {
    for (int lane = 0; lane < axisRectCount(); ++lane)
      if (axisRect(lane)->visible() && axisRect(lane)->rect().contains(at)) return lane;
    return -1;
  }

  /// Part of one lane's height that a drag goes over; a drag along the time has none.
  struct Box {
    int lane, top, bottom;  ///< [px]
  };
  std::optional<Box> boxTo(const QPoint& at) const {
    constexpr int kLeast = 16;  // [px] A hand that draws a level line stays below it.
    const int lane = axisRectIndex(pressed_);
    if (lane < 0) return std::nullopt;
    const QRect room = axisRect(lane)->rect();
    if (std::abs(at.y() - pressed_.y()) < std::max(kLeast, room.height() / 3)) return std::nullopt;
    const int end = std::clamp(at.y(), room.top(), room.bottom());
    return Box{lane, std::min(pressed_.y(), end), std::max(pressed_.y(), end)};
  }
  void showValues(int lane, double lower, double upper) {
    if (!(upper > lower)) return;
    values_[static_cast<std::size_t>(lane)] = QCPRange(lower, upper);
    if (rescale_) rescale_();
  }

  enum class Mode { none, band, pan, second };
  QPoint pointer_{-1, -1};
  std::array<std::optional<QCPRange>, kLanes> values_;
  std::optional<Box> box_;
  bool freeScale_ = false;
  std::function<void()> rescale_;
  TimeAxis* axis_;
  WrenchPlots* owner_;
  Mode mode_ = Mode::none;
  QPoint pressed_;
  bool moved_ = false;
  double pressedLower_ = 0.0;
  std::pair<int, int> band_{0, 0};
  std::optional<MarkLabel> brush_;
  double second_ = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace

struct WrenchPlots::Parts {
  PlotCanvas* canvas = nullptr;
  std::array<QCPAxisRect*, kLanes> rects{};
  std::array<TracePlottable*, kLanes> traces{};
  std::array<QCPItemRect*, kLanes> noise{};
  std::array<QCPItemText*, kLanes> titles{};
  std::array<QCPItemText*, kLanes> units{};
  std::vector<QCPItemRect*> marks;
  QCPItemText* word = nullptr;  ///< Over the highlighted stretch
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
  const QString titles[kLanes] = {tr("Force"), tr("residual"), tr("Torque"), tr("residual")};
  const QString units[kLanes] = {tr("N"), QString(), torqueUnit().name, QString()};
  for (int lane = 0; lane < kLanes; ++lane) {
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

    const auto addText = [&](const QString& text) {
      auto* item = new QCPItemText(p.canvas);
      item->setText(text);
      item->setClipToAxisRect(false);
      item->setPositionAlignment(Qt::AlignLeft | (isDifference(lane) ? Qt::AlignVCenter : Qt::AlignTop));
      item->position->setAxisRect(rect);
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
  connect(axis_, &TimeAxis::visibleChanged, this, &WrenchPlots::refresh);
  p.canvas->setRescale([this] { refresh(); });
  restyle();
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
        // Noise of three channels lies on top of each other: each shines through those above.
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
