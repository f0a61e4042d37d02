#include "ui/robot_view/view_marks.h"

#include <QPainter>

#include "ui/robot_view/gap_mark.h"
#include "ui/robot_view/label_overlay.h"
#include "ui/robot_view/viewport.h"

namespace heft {

void ViewMarks::showGhost(const std::optional<VectorXd>& joints) {
  std::vector<Isometry3d> X_BL;
  if (joints && robot_ && joints->size() == robot_->dof()) robot_->linkPoses(*joints, X_BL);
  viewport_->scene().ghost = X_BL;
  viewport_->requestFrame();
}

void ViewMarks::showGhostWay(const std::vector<Vector3d>& way) {
  viewport_->scene().ghostWay = way.empty() ? nullptr : std::make_shared<const std::vector<Vector3d>>(way);
  ghostEnd_ = way.empty() ? std::nullopt : std::optional(way.back());
  viewport_->requestFrame();
}

void ViewMarks::setGhostLabel(const QString& title, const QString& note) {
  ghostTitle_ = title;
  ghostNote_ = note;
  viewport_->requestFrame();
}

void ViewMarks::showRoom(const Room& room) {
  viewport_->scene().room =
      room.obstacles.empty() ? nullptr : std::make_shared<const std::vector<ToolSolid>>(roomSolids(room));
  viewport_->requestFrame();
}

void ViewMarks::showHulls(const std::vector<HullSurface>& hulls) {
  viewport_->scene().hulls = hulls.empty() ? nullptr : std::make_shared<const std::vector<HullEdges>>(hullEdges(hulls));
  viewport_->requestFrame();
}

void ViewMarks::showGap(const std::optional<Nearest>& gap) {
  gap_ = gap && !gap->first.empty() ? gap : std::nullopt;
  viewport_->requestFrame();
}

void ViewMarks::showPull(const std::optional<PullMark>& pull) {
  pull_ = pull;
  viewport_->requestFrame();
}

void ViewMarks::showCauses(std::vector<CauseMark> causes) {
  causes_ = std::move(causes);
  viewport_->requestFrame();
}

void ViewMarks::clear() {
  pull_.reset();
  gap_.reset();
  causes_.clear();
  viewport_->scene().ghost.clear();
  viewport_->scene().ghostWay.reset();
}

std::optional<Vector3d> ViewMarks::ghostEnd() const { return ghostTitle_.isEmpty() ? std::nullopt : ghostEnd_; }

void ViewMarks::paint(QPainter& painter, const HandleSet::View& view) const {
  const SceneState& scene = viewport_->scene();
  if (pull_) paintPull(painter, *pull_, scene.X_BS.translation(), view);
  for (const CauseMark& cause : causes_) paintCause(painter, cause, scene.X_BS, scene.down, view);
  if (gap_) paintGap(painter, *gap_, view);
}

void ViewMarks::addLabels(std::vector<ViewLabel>& labels, const HandleSet::View& view) const {
  const SceneState& scene = viewport_->scene();
  if (gap_) {
    const QPointF middle = view.pixelOf(0.5 * (gap_->onFirst + gap_->onSecond));
    if (viewport_->rect().contains(middle.toPoint())) labels.push_back({middle, gapTitle(*gap_), gapNote(*gap_)});
  }
  for (const CauseMark& cause : causes_)
    labels.push_back({causePixel(cause, scene.X_BS, scene.down, view), cause.title, cause.note});
  if (pull_) labels.push_back({pullPixel(*pull_, scene.X_BS.translation(), view), pull_->title, pull_->note});
}

std::vector<QRectF> ViewMarks::pullPlaces(const HandleSet::View& view) const {
  std::vector<QRectF> places;
  if (!pull_) return places;
  const Vector3d tool = viewport_->scene().X_BS.translation();
  const QPointF from = view.pixelOf(tool), to = pullPixel(*pull_, tool, view);
  constexpr int kLengths = 6;
  for (int k = 0; k < kLengths; ++k)
    places.push_back(QRectF(from + (to - from) * k / kLengths, from + (to - from) * (k + 1) / kLengths)
                         .normalized()
                         .adjusted(-8, -8, 8, 8));
  return places;
}

}  // namespace heft
