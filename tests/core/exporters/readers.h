#pragma once
// Reads exported files back, written from the formats' descriptions and not from the writers.
#include <cmath>
#include <random>
#include <string>
#include <string_view>

#include "core/exporters/exporter.h"

namespace heft {

/// The payload that a file of that format holds, in SI units and flange axes. Throws std::runtime_error if the file is
/// not as described. FANUC's has no products of inertia.
Payload readBack(std::string_view format, const std::string& text);

/// False for formats that hold no inertia; what readBack() gives of it is zero.
inline bool holdsInertia(std::string_view format) {
  return format != "xarm" && format != "ros2-control" && format != "force-torque-tools" && format != "mc-rtc";
}

/// The payload of the golden files.
inline Payload goldenPayload() {
  Payload payload;
  payload.mass = 0.7534218;
  payload.com = {0.0123456, -0.0045, 0.0678912};
  const Matrix3d R = rotationFromRpy({0.3, -0.2, 0.5});
  const Matrix3d I = R * Vector3d(0.0031, 0.0027, 0.0011).asDiagonal() * R.transpose();
  payload.inertiaCom = 0.5 * (I + I.transpose());
  return payload;
}

inline ExportInput goldenInput() {
  ExportInput input;
  input.payload = goldenPayload();
  input.name = "Gripper & flange \"A\"";
  input.provenance = "Heft 0.0, recording demo.csv -- method map";
  input.uncertainty = "95 %: mass 0.7521 to 0.7547 kg; centre of mass \u00b10.4 mm; inertia \u00b17 %";
  input.X_FE = poseFromXyzRpy({0.0, 0.01, 0.1034}, {0.0, 0.0, -0.7853981633974483});
  return input;
}

/// Bodies of all sorts: clouds, plates (on the border of the triangle inequality), rods, spheres; turned or not.
inline Payload randomPayload(int index) {
  std::mt19937 bits(static_cast<unsigned>(index) + 1u);
  const auto uniform = [&](double from, double to) { return from + (to - from) * (bits() / 4294967296.0); };
  Payload payload;
  payload.mass = std::pow(10.0, uniform(-1.5, 1.2));
  payload.com = {uniform(-0.1, 0.1), uniform(-0.1, 0.1), uniform(-0.05, 0.3)};
  Vector3d size{uniform(0.02, 0.3), uniform(0.02, 0.3), uniform(0.02, 0.3)};
  if (index % 5 == 1) size.z() = 0.0;
  if (index % 5 == 2) size.y() = size.z() = 0.004;
  if (index % 5 == 3) size.y() = size.z() = size.x();
  const Vector3d squares = size.cwiseAbs2() * payload.mass / 12.0;
  const Vector3d moments{squares.y() + squares.z(), squares.x() + squares.z(), squares.x() + squares.y()};
  const Matrix3d R = index % 4 == 0 ? Matrix3d(Matrix3d::Identity())
                                    : rotationFromRpy({uniform(-3.1, 3.1), uniform(-1.5, 1.5), uniform(-3.1, 3.1)});
  const Matrix3d I = R * moments.asDiagonal() * R.transpose();
  payload.inertiaCom = 0.5 * (I + I.transpose());
  return payload;
}

}  // namespace heft
