#pragma once
// Draws a SceneState with VTK: floor, lights, robot, sensor, payload, arrows, path. Belongs to one thread.
#include <memory>

#include "ui/robot_view/orbit_camera.h"
#include "ui/robot_view/scene_state.h"

class vtkRenderer;

namespace heft {

struct Theme;

class Scene3d {
 public:
  explicit Scene3d(vtkRenderer* renderer);
  ~Scene3d();

  /// Brings the scene up to this state, in these colours; costs what differs from the one before.
  void show(const SceneState& state, const Theme& theme);
  void applyCamera(const OrbitCamera& camera);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace heft
