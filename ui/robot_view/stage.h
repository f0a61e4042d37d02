#pragma once
// The room: background, three lights, fading floor grid, soft shadow.
#include <vtkActor.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTexture.h>

#include <cstdint>
#include <vector>

namespace heft {

struct Theme;

class Stage {
 public:
  explicit Stage(vtkRenderer* renderer);
  /// Lights another renderer of the same camera just as this one.
  void lightToo(vtkRenderer* other);
  void restyle(const Theme& theme);
  void setGridShown(bool shown);
  /// Darkness of SoftShadow::kCells squared cells.
  void setShadow(const std::vector<std::uint8_t>& darkness);

 private:
  vtkRenderer* renderer_;
  bool dark_ = false;
  vtkSmartPointer<vtkActor> grid_, shadow_;
  vtkSmartPointer<vtkPolyData> gridLines_;
  vtkSmartPointer<vtkImageData> shadowImage_;
  vtkSmartPointer<vtkTexture> shadowTexture_;
  vtkSmartPointer<vtkLight> key_, fill_, rim_;
};

}  // namespace heft
