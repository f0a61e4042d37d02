#pragma once
// What the user says the tool looks like: bodies posed on the sensor, as a prior for the inertia.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/findings.h"
#include "core/base/result.h"
#include "core/payload/inertial_parameters.h"

namespace heft {

enum class BodyKind { box, cylinder, tube, sphere, cone, capsule, plate, mesh };
enum class Certainty { rough, good, exact };

/// One homogeneous body. Dimensions in metres, axis z, as in the contract:
/// box x,y,z | cylinder radius,height | tube outer,inner,height (radii) | sphere radius | cone radius,height |
/// capsule radius,length (of the cylindrical part) | plate x,y,thickness. Posed at its geometric centre;
/// the cone at its base centre, apex towards +z; a mesh at its own frame.
struct ShapeBody {
  BodyKind kind = BodyKind::box;
  std::vector<double> dims;         ///< [m]
  std::filesystem::path file;       ///< For a mesh.
  double unit = 1.0;                ///< For a mesh: metres a file unit (0.001 for mm).
  std::optional<double> wall;       ///< Hollow with this wall thickness [m]; absent = solid.
  Isometry3d X_SB = Isometry3d::Identity();
  std::optional<double> mass;       ///< [kg]
  std::optional<double> density;    ///< [kg/m3]
};

struct Shape {
  std::vector<ShapeBody> bodies;
  Certainty certainty = Certainty::rough;
  std::optional<double> totalMass;  ///< [kg], from a scale
};

/// A body as points that carry its volume: all of its moments and its extent follow from them.
struct BodySamples {
  Eigen::Matrix3Xd points;           ///< S axes [m]
  VectorXd weights;                  ///< Volume shares, sum to 1.
  Matrix4d unitPseudoInertia = Matrix4d::Zero();  ///< Exact, of this body with mass 1 kg, about S's origin.
  double volume = 0.0;               ///< [m3]
  std::optional<double> mass;        ///< [kg], from mass or density
};

/// "KIND:DIMS[@POSE]" of the command line.
Result<Shape> parseShape(const std::string& text);
/// The shape file of the contract; relative mesh paths are taken against the file's folder.
Result<Shape> readShapeFile(const std::filesystem::path& file);

/// Exact moments and quadrature points of each body. A mesh that is open, inside-out or probably in the wrong unit gives a
/// finding (or an error where no volume can be had).
Result<std::vector<BodySamples>> sampleShape(const Shape& shape, Findings& findings);

}  // namespace heft
