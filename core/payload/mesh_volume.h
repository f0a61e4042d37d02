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

/// What closePieces() found and did.
struct SurfaceReport {
  long openEdges = 0;        ///< Edges without a neighbour, after repair of the orientation.
  long sharedEdges = 0;      ///< Edges with more than two triangles (bodies that touch): harmless by themselves.
  long turnedTriangles = 0;  ///< Triangles turned so that neighbours agree.
  long turnedBodies = 0;     ///< Pieces that were inside-out.
  long bodies = 0;           ///< Pieces and cavities.
  long cavities = 0;         ///< Pieces that bound a hollow inside another piece.
  double holeArea = 0.0;     ///< [m2] that was added to close holes
  double area = 0.0;         ///< [m2] before
};

struct ClosedPieces {
  std::vector<Surface> pieces;  ///< Each closed, pointing outwards, with its cavities.
  SurfaceReport report;
};

/// Takes a surface apart into pieces that hang together by edges of two triangles: the parts of a CAD assembly, even
/// where they touch. Neighbouring triangles are made to agree in orientation, every piece to point outwards (a piece
/// inside another one that points inwards is its cavity), and holes are covered with a fan about their centre, so that
/// volume integrals do not depend on the origin. Loose patches that are open on all sides are closed together as one
/// piece.
ClosedPieces closePieces(Surface surface);

/// Integral of [x;1][x;1]^T over the enclosed volume (sum of signed tetrahedra, exact for a closed surface) [m3 .. m5].
Matrix4d volumeMoments(const Surface& surface);

/// The same over a sheet of this thickness [m] centred on the surface.
Matrix4d sheetMoments(const Surface& surface, double thickness);

/// Points spread evenly over the enclosed volume, found along parallel rays through a fine grid in the principal axes;
/// where the surface winds around a point twice its weight is double (as in volumeMoments). Weights sum to about the
/// volume [m3]. A ray that does not leave as often as it enters is skipped. `rays` is the least number of rays in the
/// bounding box.
WeightedPoints volumePoints(const Surface& surface, const Matrix4d& moments, double rays = 12000);

/// The share of the volume that lies in two or more pieces and is counted again in volumeMoments.
double overlapShare(const Surface& surface, const Matrix4d& moments);

/// Puts the triangles of `other` beside those of `surface`.
void append(Surface& surface, const Surface& other);

/// Points spread evenly over a sheet of this thickness centred on the surface.
WeightedPoints sheetPoints(const Surface& surface, double thickness);

}  // namespace heft
