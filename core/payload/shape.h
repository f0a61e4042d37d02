#pragma once
// What the user says the tool looks like: bodies posed on the sensor, as a prior for the inertia.
#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/findings.h"
#include "core/base/result.h"
#include "core/mesh/mesh.h"
#include "core/payload/inertial_parameters.h"

namespace heft {

enum class BodyKind { box, cylinder, tube, sphere, cone, capsule, plate, mesh };
enum class Certainty { rough, good, exact };

std::string_view toString(BodyKind kind);        ///< "box"
std::string_view toString(Certainty certainty);  ///< "rough"
std::optional<BodyKind> bodyKindFromString(std::string_view text);
std::optional<Certainty> certaintyFromString(std::string_view text);

/// What the dimensions of a kind are called, in order, for messages and input forms; empty for a mesh.
std::vector<std::string_view> dimensionNames(BodyKind kind);

/// One homogeneous body. Dimensions in metres, axis z, as in the contract:
/// box x,y,z | cylinder radius,height | tube outer,inner,height (radii) | sphere radius | cone radius,height |
/// capsule radius,length (of the cylindrical part) | plate x,y,thickness. Posed at its geometric centre;
/// the cone at its base centre, apex towards +z; a mesh at its own frame.
struct ShapeBody {
  BodyKind kind = BodyKind::box;
  std::vector<double> dims;          ///< [m]
  std::filesystem::path file;        ///< For a mesh.
  std::shared_ptr<const Mesh> mesh;  ///< Already loaded; if set, `file` only names it in messages.
  double unit = 1.0;                 ///< For a mesh: metres a file unit (0.001 for mm).
  std::optional<double> wall;  ///< Hollow: closed all round with this wall thickness [m], measured inwards; for a mesh
                               ///< a sheet of this thickness along its surface. Absent = solid.
  Isometry3d X_SB = Isometry3d::Identity();
  std::optional<double> mass;     ///< [kg]
  std::optional<double> density;  ///< [kg/m3]
};

struct Shape {
  std::vector<ShapeBody> bodies;
  Certainty certainty = Certainty::rough;
  std::optional<double> totalMass;  ///< [kg], from a scale
};

/// A body as points that carry its volume: all of its moments and its extent follow from them.
struct BodySamples {
  Eigen::Matrix3Xd points;  ///< S axes [m], about a thousand
  VectorXd weights;         ///< Volume shares, positive, sum to 1. First and second moments are the exact ones.
  Eigen::VectorXi piece;    ///< Of each point: which separate part of a CAD assembly it is in, from 0.
  Matrix4d unitPseudoInertia = Matrix4d::Zero();  ///< Exact, of this body with mass 1 kg, about S's origin.
  double volume = 0.0;                            ///< [m3], of the material
  std::optional<double> mass;                     ///< [kg], from mass or density
};

/// "KIND:DIMS[:wall=T][@POSE]" of the command line; POSE is x,y,z[,roll,pitch,yaw].
Result<Shape> parseShape(const std::string& text);

/// The shape file of the contract; relative mesh paths are taken against the file's folder. Beyond the contract a body
/// may have "wall_m"; "unit" of a mesh is m, cm, mm or in (default m).
Result<Shape> readShapeFile(const std::filesystem::path& file);

/// The same from JSON that is already parsed; `where` names it in messages.
Result<Shape> shapeFromJson(const nlohmann::json& object, const std::string& where,
                            const std::filesystem::path& folder);

/// "certainty" of an object: "rough", "good" or "exact"; nothing if the key is not there.
Result<std::optional<Certainty>> certaintyFromJson(const nlohmann::json& object, const std::string& where);

/// What shapeFromJson reads. Mesh paths are written as they are.
nlohmann::json toJson(const Shape& shape);

/// The first thing that is wrong with the numbers of a shape, as one sentence; empty if nothing is. Meshes are not
/// opened.
std::string whyInvalid(const Shape& shape);

/// Exact moments and quadrature points of each body, in the order of the bodies; the same input gives the same points.
/// A mesh that is open, inside-out or probably in the wrong unit gives a finding (or an error where no volume can be
/// had).
Result<std::vector<BodySamples>> sampleShape(const Shape& shape, Findings& findings);

}  // namespace heft
