#include "ui/robot_view/piece.h"

#include <vtkMatrix4x4.h>
#include <vtkProperty.h>

namespace heft {

Piece::Piece() {
  mapper->SetInputData(vtkSmartPointer<vtkPolyData>::New());
  actor->SetMapper(mapper);
}

void setPose(vtkActor* actor, const Eigen::Matrix4d& pose) {
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) matrix->SetElement(i, j, pose(i, j));
  actor->SetUserMatrix(matrix);
}

void setColour(vtkActor* actor, const QColor& colour) {
  actor->GetProperty()->SetColor(colour.redF(), colour.greenF(), colour.blueF());
}

void makeTranslucent(vtkActor* actor, const QColor& colour, double opacity) {
  setColour(actor, colour);
  actor->GetProperty()->SetOpacity(opacity);
  actor->GetProperty()->SetAmbient(0.35);
  actor->GetProperty()->SetSpecular(0.1);
  actor->GetProperty()->BackfaceCullingOn();
  actor->ForceTranslucentOn();
}

}  // namespace heft
