#include "ui/robot_view/tool_shape.h"

#include <vtkProperty.h>

#include "ui/robot_view/solids.h"
#include "ui/theme/theme.h"

namespace heft {
void ToolShape::setBodies(const std::vector<SceneState::ToolBody>& bodies, int selected) {
  selected_ = selected;
  while (bodies_.size() > bodies.size()) {
    for (Piece* piece : {&bodies_.back().faces, &bodies_.back().edges, &bodies_.back().hollow})
      renderer_->RemoveActor(piece->actor);
    bodies_.pop_back();
  }
  while (bodies_.size() < bodies.size()) {
    bodies_.emplace_back();
    for (Piece* piece : {&bodies_.back().faces, &bodies_.back().edges, &bodies_.back().hollow})
      renderer_->AddActor(piece->actor);
  }
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    Body& body = bodies_[i];
    if (body.shape.solid != bodies[i].solid) {
      body.faces.setMesh(toPolyData(bodies[i].solid->faces));
      body.edges.setMesh(toLines(bodies[i].solid->edges));
      body.hollow.setMesh(toLines(bodies[i].solid->hollow));
    }
    body.shape = bodies[i];
  }
  place();
}

void ToolShape::setPose(const Isometry3d& X_BS) {
  X_BS_ = X_BS;
  place();
}

void ToolShape::place() {
  for (Body& body : bodies_) {
    const Eigen::Matrix4d X = (X_BS_ * body.shape.X_SB).matrix();
    for (Piece* piece : {&body.faces, &body.edges, &body.hollow}) heft::setPose(piece->actor, X);
  }
}

void ToolShape::setShown(bool shown) {
  shown_ = shown;
  for (Body& body : bodies_)
    for (Piece* piece : {&body.faces, &body.edges, &body.hollow}) piece->actor->SetVisibility(shown);
}

void ToolShape::restyle(const Theme& t) {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    Body& body = bodies_[i];
    const bool strong = selected_ < 0 || selected_ == static_cast<int>(i);
    makeTranslucent(body.faces.actor, t.tool, strong ? 0.42 : 0.22);
    // Both sides: one sees into the body.
    body.faces.actor->GetProperty()->BackfaceCullingOff();
    body.faces.actor->GetProperty()->SetOpacity(strong ? 0.30 : 0.16);
    for (Piece* piece : {&body.edges, &body.hollow}) {
      setColour(piece->actor, t.dark ? t.axis[2] : QColor("#2B6F97"));
      piece->actor->GetProperty()->LightingOff();
      piece->actor->GetProperty()->SetLineWidth(strong ? 1.6F : 1.0F);
    }
    body.hollow.actor->GetProperty()->SetOpacity(0.45);
  }
  setShown(shown_);
}

}  // namespace heft
