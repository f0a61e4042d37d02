#include "ui/robot_view/stage.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

#include "ui/robot_view/soft_shadow.h"
#include "ui/theme/theme.h"

namespace heft {
namespace {

constexpr double kGridStep = 0.1, kGridReach = 1.6, kGridFade = 1.5;  // [m]

vtkSmartPointer<vtkLight> makeLight(double x, double y, double z) {
  auto light = vtkSmartPointer<vtkLight>::New();
  // Bound to the camera, so that the arm is well lit from every side.
  light->SetLightTypeToCameraLight();
  light->SetPosition(x, y, z);
  light->SetFocalPoint(0, 0, 0);
  light->SetPositional(false);
  return light;
}

}  // namespace

Stage::Stage(vtkRenderer* renderer) : renderer_(renderer) {
  renderer_->SetAutomaticLightCreation(false);
  renderer_->RemoveAllLights();
  key_ = makeLight(-0.8, 1.1, 1.0);
  fill_ = makeLight(1.2, 0.1, 0.8);
  rim_ = makeLight(0.5, 0.9, -1.0);
  for (auto* light : {key_.Get(), fill_.Get(), rim_.Get()}) renderer_->AddLight(light);

  shadowImage_ = vtkSmartPointer<vtkImageData>::New();
  shadowImage_->SetDimensions(SoftShadow::kCells, SoftShadow::kCells, 1);
  shadowImage_->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  std::fill_n(static_cast<unsigned char*>(shadowImage_->GetScalarPointer()),
              SoftShadow::kCells * SoftShadow::kCells * 4, 0);
  shadowTexture_ = vtkSmartPointer<vtkTexture>::New();
  shadowTexture_->SetInputData(shadowImage_);
  shadowTexture_->InterpolateOn();
  shadowTexture_->SetColorModeToDirectScalars();

  const double h = SoftShadow::kExtent / 2;
  auto points = vtkSmartPointer<vtkPoints>::New();
  auto coordinates = vtkSmartPointer<vtkFloatArray>::New();
  coordinates->SetNumberOfComponents(2);
  const double corners[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  for (const auto& corner : corners) {
    points->InsertNextPoint(corner[0] * h, corner[1] * h, -0.001);
    coordinates->InsertNextTuple2((corner[0] + 1) / 2, (corner[1] + 1) / 2);
  }
  auto quad = vtkSmartPointer<vtkCellArray>::New();
  const vtkIdType ids[4] = {0, 1, 2, 3};
  quad->InsertNextCell(4, ids);
  auto floor = vtkSmartPointer<vtkPolyData>::New();
  floor->SetPoints(points);
  floor->SetPolys(quad);
  floor->GetPointData()->SetTCoords(coordinates);
  auto floorMapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  floorMapper->SetInputData(floor);
  shadow_ = vtkSmartPointer<vtkActor>::New();
  shadow_->SetMapper(floorMapper);
  shadow_->SetTexture(shadowTexture_);
  shadow_->GetProperty()->LightingOff();
  shadow_->ForceTranslucentOn();
  shadow_->PickableOff();
  renderer_->AddActor(shadow_);

  // Every line is cut at the crossings, so that each point can fade by its own distance.
  gridLines_ = vtkSmartPointer<vtkPolyData>::New();
  auto gridPoints = vtkSmartPointer<vtkPoints>::New();
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  const int reach = static_cast<int>(std::lround(kGridReach / kGridStep));
  for (const bool alongX : {true, false}) {
    for (int line = -reach; line <= reach; ++line) {
      for (int i = -reach; i <= reach; ++i) {
        const double u = i * kGridStep, v = line * kGridStep;
        const vtkIdType id = alongX ? gridPoints->InsertNextPoint(u, v, 0) : gridPoints->InsertNextPoint(v, u, 0);
        if (i == -reach) continue;
        if (std::hypot(u - kGridStep / 2, v) > kGridFade) continue;
        const vtkIdType pair[2] = {id - 1, id};
        cells->InsertNextCell(2, pair);
      }
    }
  }
  gridLines_->SetPoints(gridPoints);
  gridLines_->SetLines(cells);
  auto gridMapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  gridMapper->SetInputData(gridLines_);
  grid_ = vtkSmartPointer<vtkActor>::New();
  grid_->SetMapper(gridMapper);
  grid_->GetProperty()->LightingOff();
  grid_->GetProperty()->SetLineWidth(1.0F);
  grid_->ForceTranslucentOn();
  grid_->PickableOff();
  renderer_->AddActor(grid_);
}

void Stage::lightToo(vtkRenderer* other) {
  other->SetAutomaticLightCreation(false);
  other->RemoveAllLights();
  for (auto* light : {key_.Get(), fill_.Get(), rim_.Get()}) other->AddLight(light);
}

void Stage::restyle(const Theme& t) {
  dark_ = t.dark;
  renderer_->GradientBackgroundOn();
  renderer_->SetBackground(t.skyBottom.redF(), t.skyBottom.greenF(), t.skyBottom.blueF());
  renderer_->SetBackground2(t.skyTop.redF(), t.skyTop.greenF(), t.skyTop.blueF());
  const double dim = t.dark ? 0.62 : 1.0;
  key_->SetColor(1.0, 0.985, 0.96);
  key_->SetIntensity(0.80 * dim);
  fill_->SetColor(0.93, 0.96, 1.0);
  fill_->SetIntensity(0.40 * dim);
  rim_->SetColor(1.0, 1.0, 1.0);
  rim_->SetIntensity(0.38 * dim);

  auto colours = vtkSmartPointer<vtkUnsignedCharArray>::New();
  colours->SetNumberOfComponents(4);
  for (vtkIdType i = 0; i < gridLines_->GetNumberOfPoints(); ++i) {
    double p[3];
    gridLines_->GetPoint(i, p);
    const double share = std::clamp(1.0 - std::hypot(p[0], p[1]) / kGridFade, 0.0, 1.0);
    colours->InsertNextTuple4(t.floorLine.red(), t.floorLine.green(), t.floorLine.blue(),
                              (t.dark ? 150 : 170) * share * share * (3 - 2 * share));
  }
  gridLines_->GetPointData()->SetScalars(colours);
  gridLines_->Modified();
}

void Stage::setGridShown(bool shown) { grid_->SetVisibility(shown); }

void Stage::setShadow(const std::vector<std::uint8_t>& darkness) {
  auto* pixel = static_cast<unsigned char*>(shadowImage_->GetScalarPointer());
  for (const std::uint8_t value : darkness) {
    pixel[0] = dark_ ? 0 : 58;
    pixel[1] = dark_ ? 0 : 72;
    pixel[2] = dark_ ? 0 : 88;
    pixel[3] = static_cast<unsigned char>(value * (dark_ ? 0.9 : 0.62));
    pixel += 4;
  }
  shadowImage_->Modified();
}

}  // namespace heft
