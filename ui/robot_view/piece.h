#pragma once
// One thing drawn by VTK whose mesh, pose and colour may be replaced.
#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkSmartPointer.h>
#include <QColor>

#include "core/math/rigid.h"

namespace heft {

struct Piece {
  vtkSmartPointer<vtkPolyDataMapper> mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  vtkSmartPointer<vtkActor> actor = vtkSmartPointer<vtkActor>::New();

  Piece();
  void setMesh(vtkPolyData* mesh) { mapper->SetInputData(mesh); }
};

void setPose(vtkActor* actor, const Eigen::Matrix4d& pose);
void setColour(vtkActor* actor, const QColor& colour);
/// Translucent, only its near side: seen through both sides at once a shape would be a tangle.
void makeTranslucent(vtkActor* actor, const QColor& colour, double opacity);

}  // namespace heft
