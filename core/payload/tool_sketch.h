#pragma once
// A tool as a person with a ruler tells it: a picture, lengths from side to side, and bodies that begin where the
// sensor ends. All of it becomes a Shape.
#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "core/payload/shape.h"

namespace heft {

/// What a tool may look like; most are one body.
enum class ToolPicture { box, cylinder, tube, sphere, cone, capsule, plate, gripper, several, mesh };

inline constexpr std::array kToolPictures{
    ToolPicture::box,     ToolPicture::cylinder, ToolPicture::tube,    ToolPicture::sphere,  ToolPicture::cone,
    ToolPicture::capsule, ToolPicture::plate,    ToolPicture::gripper, ToolPicture::several, ToolPicture::mesh};

std::string_view toString(ToolPicture picture);  ///< "gripper"
std::optional<ToolPicture> toolPictureFromString(std::string_view text);
/// Of a picture that is one primitive body.
std::optional<BodyKind> bodyKindOf(ToolPicture picture);
/// What picture a shape is, where nobody picked one.
ToolPicture pictureOf(const Shape& shape);

/// A length that can be measured from side to side.
enum class Length { width, depth, height, thickness, diameter, outerDiameter, innerDiameter, wholeLength };
struct Measure {
  Length length;
  int axis;      ///< Of the body along which it is measured, 0 to 2; -1: inside.
  double value;  ///< [m]
};
std::vector<Measure> measuresOf(const ShapeBody& body);

/// The body with one of its measures (by index) changed to `value` [m]. `hold` says what stays where it is along the
/// measure's axis: -1 the low end, 0 the middle, 1 the high end; round bodies keep their axis.
ShapeBody resized(const ShapeBody& body, std::size_t measure, double value, int hold);
/// The same for a body of a tool: lengths along z keep the end towards the sensor, others the middle, and the fingers
/// of a gripper stay at the end of its body.
Shape resized(const Shape& shape, ToolPicture picture, std::size_t body, std::size_t measure, double value);

/// Space that a body takes in its own frame [m]; empty for a mesh that is not loaded.
Eigen::AlignedBox3d extentOf(const ShapeBody& body);
/// And the whole tool, S axes.
Eigen::AlignedBox3d extentOf(const Shape& shape);

/// Bodies for a picture, beginning at S's origin and reaching along z; `size` [m] is what they should fill (width,
/// depth, height). Nothing for a mesh. `several` begins with a box and a cylinder at its end.
std::vector<ShapeBody> sketch(ToolPicture picture, std::optional<Vector3d> size = std::nullopt);
/// One more body of this kind at the far end of the others.
ShapeBody nextBody(BodyKind kind, const Shape& shape);

/// The unit that makes a tool of a mesh whose longest side is this in the file's numbers: 0.001, 0.01 or 1 m.
double likelyUnit(double longestInFile);

/// Of the material [m3]; nothing for a mesh or impossible numbers.
std::optional<double> materialVolume(const ShapeBody& body);

/// Thickest wall that leaves a hollow [m]; nothing where the body cannot be hollow (a tube) or has no limit (a mesh).
std::optional<double> wallLimit(const ShapeBody& body);

}  // namespace heft
