#pragma once
// Where the mass of a shape can be: points that bound every distribution of mass inside it.
#include "core/payload/shape.h"

namespace heft {

/// Points of the shape, S axes [m]: those of `samples` and, of each body, corners, points of its rims or of its hull.
/// The pseudo-inertias sum mu_k [x_k; 1][x_k; 1]^T with mu_k >= 0 are an inner approximation of all that mass inside
/// the shape can have (arXiv 2411.07079). `samples` are those of sampleShape(shape).
Eigen::Matrix3Xd boundPoints(const Shape& shape, const std::vector<BodySamples>& samples);

}  // namespace heft
