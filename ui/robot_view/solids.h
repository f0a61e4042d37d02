#pragma once
// Small solids as VTK meshes with normals: arrows, arcs, balls, and meshes from core.
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <vector>

#include "core/math/rigid.h"
#include "core/mesh/mesh.h"

namespace heft {

vtkSmartPointer<vtkPolyData> toPolyData(const MeshPart& part);
/// Polylines.
vtkSmartPointer<vtkPolyData> toLines(const std::vector<std::vector<Vector3d>>& edges);

/// Straight arrow; its head is shortened where the arrow is short. Empty if shorter than a hair.
vtkSmartPointer<vtkPolyData> makeArrow(const Vector3d& from, const Vector3d& to, double radius);

/// Arrow along a polyline, for instance an arc.
vtkSmartPointer<vtkPolyData> makeBentArrow(const std::vector<Vector3d>& way, double radius);

/// Tube along a polyline with a colour a point (RGB scalars named "colours").
vtkSmartPointer<vtkPolyData> makeTube(const std::vector<Vector3d>& way,
                                      const std::vector<std::array<unsigned char, 3>>& colours, double radius,
                                      int sides);

/// Ball with black and white octants, as on crash-test dummies: marks a centre of mass.
vtkSmartPointer<vtkPolyData> makeCentreBall(double radius);

/// Unit ball, and its three great circles as lines.
vtkSmartPointer<vtkPolyData> makeUnitBall();
vtkSmartPointer<vtkPolyData> makeUnitCircles();

/// Edges of a box about the origin, dashed with dashes of about `dash` [m].
vtkSmartPointer<vtkPolyData> makeDashedBox(const Vector3d& edges, double dash);

/// Disc-shaped body along z from z0 to z1 with slightly rounded rims.
vtkSmartPointer<vtkPolyData> makePuck(double radius, double z0, double z1);

/// Box and cylinder of URDF visuals: cylinder along z, both centred.
vtkSmartPointer<vtkPolyData> makeBox(const Vector3d& edges);

}  // namespace heft
