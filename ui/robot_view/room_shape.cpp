#include "ui/robot_view/room_shape.h"

#include <vtkProperty.h>

#include "ui/robot_view/solids.h"
#include "ui/theme/theme.h"

namespace heft {

void RoomShape::setRoom(const std::vector<ToolSolid>& solids) {
  for (auto* pieces : {&faces_, &edges_}) {
    for (Piece& piece : *pieces) renderer_->RemoveActor(piece.actor);
    pieces->clear();
  }
  for (const ToolSolid& solid : solids) {
    faces_.emplace_back().setMesh(toPolyData(solid.faces));
    edges_.emplace_back().setMesh(toLines(solid.edges));
    for (Piece* piece : {&faces_.back(), &edges_.back()}) renderer_->AddActor(piece->actor);
  }
}

void RoomShape::setHulls(const std::vector<HullEdges>& hulls) {
  for (Hull& hull : hulls_) renderer_->RemoveActor(hull.edges.actor);
  hulls_.clear();
  for (const HullEdges& hull : hulls) {
    hulls_.push_back({hull.link, {}});
    hulls_.back().edges.setMesh(toLines(hull.edges));
    renderer_->AddActor(hulls_.back().edges.actor);
  }
}

void RoomShape::setPoses(const std::vector<Isometry3d>& X_BL) {
  for (Hull& hull : hulls_) {
    const auto link = static_cast<std::size_t>(hull.link);
    hull.edges.actor->SetVisibility(link < X_BL.size());
    if (link < X_BL.size()) setPose(hull.edges.actor, X_BL[link].matrix());
  }
}

void RoomShape::restyle(const Theme& t) {
  for (Piece& piece : faces_) {
    makeTranslucent(piece.actor, t.text3, 0.16);
    piece.actor->GetProperty()->BackfaceCullingOff();
  }
  for (Piece& piece : edges_) {
    setColour(piece.actor, t.text3);
    piece.actor->GetProperty()->LightingOff();
    piece.actor->GetProperty()->SetLineWidth(1.2F);
  }
  for (Hull& hull : hulls_) {
    setColour(hull.edges.actor, t.accent);
    hull.edges.actor->GetProperty()->LightingOff();
    hull.edges.actor->GetProperty()->SetOpacity(0.6);
    hull.edges.actor->ForceTranslucentOn();
  }
}

}  // namespace heft
