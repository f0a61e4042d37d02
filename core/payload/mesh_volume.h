#pragma once
// From the triangles of a CAD file to a body with a volume: welding, repair, volume integrals and points inside.
#include <array>
#include <string>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/payload/quadrature.h"

namespace heft {

/// Triangles on shared vertices. Counter-clockwise seen from outside once it has been repaired.
struct Surface {
  std::vector<Vector3d> vertices;  ///< [m]
  std::vector<std::array<int, 3>> triangles;
};

/// All parts of a mesh as one surface, scaled by `unit`; equal vertices are joined, triangles that became lines are
/// dropped. Vertices with a component that is not finite are dropped with their triangles; `dropped` counts these
/// triangles.
Surface weld(const Mesh& mesh, double unit, long* dropped = nullptr);

/// Joins vertices on open edges that lie closer together than `tolerance` [m].
void closeSeams(Surface& surface, double tolerance);

/// What repair() found and did.
struct SurfaceReport {
  long openEdges = 0;        ///< Edges without a neighbour, after repair of the orientation.
  long sharedEdges = 0;      ///< Edges with more than two triangles (bodies that touch): harmless by themselves.
  long turnedTriangles = 0;  ///< Triangles turned so that neighbours agree.
  long turnedBodies = 0;     ///< Separate closed bodies that were inside-out.
  long bodies = 0;           ///< Separate closed or open pieces.
  long cavities = 0;         ///< Pieces that bound a hollow inside another piece.
  double holeArea = 0.0;     ///< [m2] that was added to close holes
  double area = 0.0;         ///< [m2] before
};

/// Makes neighbouring triangles agree in orientation, every separate piece point outwards (a piece inside another one
/// that points inwards is a cavity and stays) and fills holes with a fan about their centre, so that volume integrals
/// do not depend on the origin. A surface that is closed and right is left alone.
SurfaceReport repair(Surface& surface);

/// Integral of [x;1][x;1]^T over the enclosed volume (sum of signed tetrahedra, exact for a closed surface) [m3 .. m5].
Matrix4d volumeMoments(const Surface& surface);

/// The same over a sheet of this thickness [m] centred on the surface.
Matrix4d sheetMoments(const Surface& surface, double thickness);

/// Points spread evenly over the enclosed volume, found along parallel rays through a fine grid in the principal axes;
/// where pieces overlap the weight is that of the overlap (as in volumeMoments). `overlap` is the share counted again.
/// Weights sum to about the volume [m3]. A ray that does not leave as often as it enters is skipped.
WeightedPoints volumePoints(const Surface& surface, const Matrix4d& moments, double* overlap = nullptr);

/// Points spread evenly over a sheet of this thickness centred on the surface.
WeightedPoints sheetPoints(const Surface& surface, double thickness);

}  // namespace heft
