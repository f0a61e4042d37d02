#include "ui/robot_view/ghost_arm.h"

#include <vtkProperty.h>

#include "ui/robot_view/solids.h"
#include "ui/theme/theme.h"

namespace heft {

GhostArm::GhostArm(vtkRenderer* renderer) : renderer_(renderer) {
  tube_.actor->VisibilityOff();
  tube_.mapper->SetColorModeToDirectScalars();
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
  restyle();
}

void GhostArm::setPoses(const std::vector<Isometry3d>& X_BL) {
  for (Link& link : links_) {
    const bool shown = link.link < static_cast<int>(X_BL.size());
    link.piece.actor->SetVisibility(shown);
    if (shown) setPose(link.piece.actor, X_BL[static_cast<std::size_t>(link.link)].matrix() * link.X_LV);
  }
}

void GhostArm::setWay(const std::vector<Vector3d>& way) {
  way_ = way;
  tube_.actor->SetVisibility(way.size() > 1);
  if (way.size() < 2) return;
  const QColor c = theme().accent;
  const std::array<unsigned char, 3> colour{static_cast<unsigned char>(c.red()), static_cast<unsigned char>(c.green()),
                                            static_cast<unsigned char>(c.blue())};
  tube_.setMesh(makeTube(way, std::vector(way.size(), colour), 0.0028, 8));
}

void GhostArm::restyle() {
  for (Link& link : links_) makeTranslucent(link.piece.actor, theme().accent, 0.22);
  setWay(way_);
}

}  // namespace heft
