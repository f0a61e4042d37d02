#pragma once
// Random but physical payloads, motions and rotations with fixed seeds.
#include <random>

#include "core/payload/inertial_parameters.h"

namespace heft::test {

inline Vector3d randomVector(std::mt19937& random, double size = 1.0) {
  std::uniform_real_distribution<double> uniform(-size, size);
  return {uniform(random), uniform(random), uniform(random)};
}

inline Matrix3d randomRotation(std::mt19937& random) { return rotationFromVector(randomVector(random, 3.0)); }

/// A cloud of point masses, so that the inertia is that of something that can exist.
inline Payload randomPayload(std::mt19937& random) {
  std::uniform_real_distribution<double> mass(0.01, 0.2);
  const Vector3d centre = randomVector(random, 0.1);
  Payload payload;
  for (int i = 0; i < 8; ++i) {
    Payload point;
    point.mass = mass(random);
    point.com = centre + randomVector(random, 0.08);
    payload = i == 0 ? point : composed(payload, point);
  }
  return payload;
}

}  // namespace heft::test
