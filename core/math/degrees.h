#pragma once
// Angles as people write them.
#include <numbers>

namespace heft {

constexpr double kRadPerDegree = std::numbers::pi / 180.0;

}  // namespace heft
