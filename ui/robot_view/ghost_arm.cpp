#include "ui/robot_view/ghost_arm.h"

#include <vtkProperty.h>

#include <algorithm>
#include <cmath>

#include "ui/robot_view/solids.h"
#include "ui/theme/theme.h"

namespace heft {

GhostArm::GhostArm(vtkRenderer* renderer) : renderer_(renderer) {
  tube_.actor->VisibilityOff();
  renderer_->AddActor(tube_.actor);
}

void GhostArm::setParts(const std::vector<Part>& parts) {
  for (Link& link : links_) renderer_->RemoveActor(link.piece.actor);
  links_.clear();
  for (const Part& part : parts) {
    links_.push_back({part.link, part.X_LV, {}});
    links_.back().piece.setMesh(part.mesh);
    links_.back().piece.actor->VisibilityOff();
    renderer_->AddActor(links_.back().piece.actor);
  }
}

void GhostArm::setPoses(const std::vector<Isometry3d>& X_BL, const std::vector<Isometry3d>& arm) {
  const auto apart = [&](std::size_t link) {
    if (link >= arm.size()) return true;
    const Isometry3d X = arm[link].inverse() * X_BL[link];
    return X.translation().norm() > 0.012 || std::acos(std::clamp((X.linear().trace() - 1) / 2, -1.0, 1.0)) > 0.06;
  };
  for (Link& link : links_) {
    const bool shown = link.link < static_cast<int>(X_BL.size()) && apart(static_cast<std::size_t>(link.link));
    link.piece.actor->SetVisibility(shown);
    if (shown) setPose(link.piece.actor, X_BL[static_cast<std::size_t>(link.link)].matrix() * link.X_LV);
  }
}

void GhostArm::setWay(const std::vector<Vector3d>& way) {
  tube_.actor->SetVisibility(way.size() > 1);
  if (way.size() < 2) return;
  tube_.setMesh(makeBentArrow(way, 0.0042));
}

void GhostArm::restyle(const Theme& theme) {
  for (Link& link : links_) makeTranslucent(link.piece.actor, theme.accent, 0.22);
  setColour(tube_.actor, theme.accent);
}

}  // namespace heft
