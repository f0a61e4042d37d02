// What stands over the 3D picture in words: labels with their leaders, and the note of the step.
#include <QLabel>
#include <QLineF>
#include <QPolygonF>
#include <algorithm>

#include "ui/models/numbers.h"
#include "ui/robot_view/gap_mark.h"
#include "ui/robot_view/label_overlay.h"
#include "ui/robot_view/robot_view.h"
#include "ui/robot_view/scene_state.h"
#include "ui/robot_view/viewport.h"

namespace heft {

void RobotView::updateLabels() {
  overlay_->setGeometry(viewport_->rect());
  const SceneState::Anchors& anchors = viewport_->anchors();
  const HandleSet::View view = viewport_->shownView();
  std::vector<ViewLabel> labels;
  const auto add = [&](const std::optional<Vector3d>& point, const QString& title, const QString& note = {}) {
    if (!point) return;
    const QPointF pixel = view.pixelOf(*point);
    if (viewport_->rect().contains(pixel.toPoint())) labels.push_back({pixel, title, note});
  };
  if (labelsShown_) {
    // While the arm moves the coach's label is the one to be read.
    if (!kept_) add(anchors.wrench, tr("force and torque"));
    if (const auto& look = scene_.payload)
      add(anchors.centre, tr("Centre of mass"),
          !look->centreKnown             ? tr("not known from this motion")
          : look->region.minCoeff() <= 0 ? tr("known to better than 0.2 mm")
          : look->enlargement > 1        ? tr("95 % region, drawn %1× larger").arg(numberText(look->enlargement, 0))
                                         : tr("95 % region"));
    if (!kept_) add(anchors.box, tr("equal-inertia box"));
    add(anchors.gravity, tr("gravity"));
    if (!ghostTitle_.isEmpty()) add(ghostEnd_, ghostTitle_, ghostNote_);
    if (editing_) add(anchors.sensor, tr("sensor, tool side"), tr("the shape is mounted here"));
  }
  if (gap_) add(0.5 * (gap_->onFirst + gap_->onSecond), gapTitle(*gap_), gapNote(*gap_));
  for (const CauseMark& cause : causes_)
    labels.push_back({causePixel(cause, X_BS_, scene_.down, view), cause.title, cause.note});
  if (pull_) labels.push_back({pullPixel(*pull_, X_BS_.translation(), view), pull_->title, pull_->note});
  std::vector<QRectF> subjects = namedPlaces();
  for (const ViewLabel& label : labels) subjects.push_back(QRectF(label.anchor - QPointF(6, 6), QSizeF(12, 12)));
  placeNote(subjects);
  std::array<QPointF, 3> ends;
  bool axesShown = labelsShown_;
  for (int a = 0; a < 3; ++a) {
    axesShown = axesShown && anchors.axes[a].has_value();
    if (anchors.axes[a]) ends[a] = view.pixelOf(*anchors.axes[a]);
  }
  overlay_->setAxisLetters(ends, axesShown);
  LabelRoom room;
  std::vector<QRectF>& taken = room.taken;
  taken = {QRectF(tools_->geometry())};
  if (note_->isVisibleTo(viewport_)) taken.push_back(notePlace());
  if (stepTools_ && stepTools_->isVisibleTo(viewport_)) taken.push_back(QRectF(stepTools_->geometry()));
  for (const PlacedDimension& each : placeDimensions(dimensions_, X_BS_, view)) taken.push_back(each.label);
  if (axesShown)
    for (const QPointF& end : ends) room.letters.push_back(QRectF(end - QPointF(9, 9), QSizeF(18, 18)));
  room.subjects = std::move(subjects);
  room.arm = linkPlaces();
  overlay_->setLabels(std::move(labels), std::move(room));
}

std::vector<QRectF> RobotView::linkPlaces() const {
  std::vector<QRectF> places;
  if (!scene_.look) return places;
  constexpr double kThick = 0.06;  // [m] Half of a link
  const HandleSet::View view = viewport_->shownView();
  for (std::size_t k = 0; k + 1 < scene_.X_BL.size(); ++k) {
    const Vector3d from = scene_.X_BL[k].translation(), to = scene_.X_BL[k + 1].translation();
    const double thick = QLineF(view.pixelOf(from), view.pixelOf(from + kThick * Vector3d::UnitZ())).length();
    places.push_back(QRectF(view.pixelOf(from), view.pixelOf(to)).normalized().adjusted(-thick, -thick, thick, thick));
  }
  return places;
}

std::vector<QRectF> RobotView::namedPlaces() const {
  const HandleSet::View view = viewport_->shownView();
  std::vector<QRectF> places;
  for (const std::vector<Vector3d>& piece : scene_.namedPieces()) {
    QPolygonF outline;
    for (const Vector3d& point : piece) outline << view.pixelOf(point);
    places.push_back(outline.boundingRect().adjusted(-4, -4, 4, 4));
  }
  if (pull_) {
    const QPointF from = view.pixelOf(X_BS_.translation()), to = pullPixel(*pull_, X_BS_.translation(), view);
    constexpr int kLengths = 6;
    for (int k = 0; k < kLengths; ++k)
      places.push_back(QRectF(from + (to - from) * k / kLengths, from + (to - from) * (k + 1) / kLengths)
                           .normalized()
                           .adjusted(-8, -8, 8, 8));
  }
  return places;
}

void RobotView::placeNote(const std::vector<QRectF>& subjects) {
  const double least = stepTools_ ? stepTools_->geometry().bottom() + 10 : 14;
  note_->setWordWrap(false);
  const QSize line = note_->sizeHint();
  note_->setWordWrap(true);
  const int narrow = std::min(line.width(), 240);
  const QSize lines(narrow, note_->heightForWidth(narrow));
  const auto placeOf = [&](int way) {
    const QSize size = way % 2 == 0 ? line : lines;
    const double y = way < 2 ? least : viewport_->height() - size.height() - 14;
    return QRectF(QPointF(16, y), QSizeF(size));
  };
  const auto covers = [&](int way, double margin) {
    const QRectF place = placeOf(way).adjusted(-margin, -margin, margin, margin);
    return std::any_of(subjects.begin(), subjects.end(), [&](const QRectF& each) { return each.intersects(place); });
  };
  // In one line, in several; at the top, at the bottom. It goes back only where there is clearly room.
  int way = 0;
  while (way < 4 && covers(way, way < noteWay_ ? 24 : 0)) ++way;
  noteWay_ = way < 4 ? way : 1;
  note_->setWordWrap(noteWay_ % 2 == 1);
  note_->setGeometry(placeOf(noteWay_).toRect());
}

QStringList RobotView::labelTexts() const { return overlay_->titles(); }

std::vector<QRectF> RobotView::labelPlaces() const { return overlay_->placed(); }

QRectF RobotView::notePlace() const { return note_->isHidden() ? QRectF() : QRectF(note_->geometry()); }

}  // namespace heft
