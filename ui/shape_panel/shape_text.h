#pragma once
// What the step Shape says, and what it understands.
#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/payload/tool_sketch.h"
#include "core/workspace/session.h"

namespace heft {

QString pictureName(ToolPicture picture);  ///< "Gripper"
QString lengthName(Length length);         ///< "width"
QString millimetres(double metres);        ///< "64 mm", "0.5 mm"
QString kilograms(double mass);            ///< "0.812 kg"

QString tipForMove(int axis);  ///< -1: freely
QString tipForTurn(int axis);
QString tipForBody(int index);

/// "Box, 60 × 40 × 120 mm", "tool.stl".
QString bodyTitle(const ShapeBody& body);
/// The line in the bar of steps: "box, 60 × 40 × 120 mm", "gripper-like, 2 boxes".
QString shapeLine(const ShapeChoice& choice);
/// The picture that was picked; without one, it follows from the shape.
ToolPicture pictureOf(const ShapeChoice& choice);

/// "Good: each length is right to about 4 %, like a ruler reading."
QString certaintyNote(Certainty certainty, bool mesh);

struct Material {
  QString id;  ///< For scripts and object names.
  QString name;
  double density;  ///< [kg/m3]
};
const std::vector<Material>& materials();
/// Index into materials(); -1 for another density.
int materialOf(double density);

/// A weight as typed, in kg: "812 g", "0,812 kg", or a bare number in the unit given. Nothing if it is none.
std::optional<double> parseWeight(const QString& text, bool grams);

/// What is wrong with a shape, in the user's words; empty if nothing is.
QString shapeProblem(const Shape& shape);

/// The words of a script after "shape": PICTURE [SIZES ...] [at X,Y,Z[,ROLL,PITCH,YAW]] [wall MM] [weighs KG] [of
/// MATERIAL] [rough|good|exact], lengths in mm as in the panel (diameters, whole lengths), angles in degrees, the place
/// that of the body's middle; "mesh FILE [mm|cm|m]" leaves the mesh to be loaded. `now` keeps what is not said.
Result<ShapeChoice> shapeFromWords(const QStringList& words, const ShapeChoice& now);

}  // namespace heft
