// What stands over the 3D picture in words: labels with their leaders, and the note of the step.
#include <QLineF>
#include <QPolygonF>
#include <algorithm>

#include "ui/models/numbers.h"
#include "ui/robot_view/label_overlay.h"
#include "ui/robot_view/robot_view.h"
#include "ui/robot_view/scene_state.h"
#include "ui/robot_view/view_tools.h"
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
    add(marks_->ghostEnd(), marks_->ghostTitle(), marks_->ghostNote());
    if (editing_) add(anchors.sensor, tr("sensor, tool side"), tr("the shape is mounted here"));
  }
  marks_->addLabels(labels, view);
  std::vector<QRectF> subjects = namedPlaces();
  for (const ViewLabel& label : labels) subjects.push_back(QRectF(label.anchor - QPointF(6, 6), QSizeF(12, 12)));
  note_->place(subjects);
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
  for (const QRectF& place : note_->places()) taken.push_back(place);
  for (const QRectF& place : handles_->labelPlaces(view)) taken.push_back(place);
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
  for (const QRectF& place : marks_->pullPlaces(view)) places.push_back(place);
  return places;
}

QStringList RobotView::labelTexts() const { return overlay_->titles(); }

std::vector<QRectF> RobotView::labelPlaces() const { return overlay_->placed(); }

}  // namespace heft
