#pragma once
// Closed forms and points of the primitive bodies, in the body frame of ShapeBody.
#include "core/payload/quadrature.h"
#include "core/payload/shape.h"

namespace heft {

/// Volume, first and second moments as one matrix, integral of [x;1][x;1]^T dV over the material [m3 .. m5].
/// `body` is any kind but mesh and passes whyInvalid.
Matrix4d primitiveMoments(const ShapeBody& body);

/// Points spread evenly over the material of a primitive, with equal weights.
WeightedPoints primitivePoints(const ShapeBody& body);

/// Whether p [m, body frame] lies in the material of a primitive.
bool insidePrimitive(const ShapeBody& body, const Vector3d& p);

/// The cavity of a hollow primitive as a solid body, in the frame of `body` with its own offset in X_SB.
ShapeBody cavityOf(const ShapeBody& body);

/// Half of the smallest thickness: a wall must be thinner than this [m].
double inradius(const ShapeBody& body);

}  // namespace heft
