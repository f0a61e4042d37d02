#pragma once
// What the numbers of a recording mean where they are not in the plain form that Heft works in: axes, signs, units and
// orders of the wrench, and the direction and order of the pose. Stated in meta and map files, undone by every reader.
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/math/rigid.h"

namespace heft {

/// The plain form is what the default values say. A recording in other conventions is w = T(plain): first its columns
/// were mirrored, turned and moved to another point, then its torque's sign was turned, then both were scaled, then
/// force and torque changed places.
struct Conventions {
  enum class WrenchAxes { sensor, base };
  enum class TorqueSign { asForce, opposite };
  enum class WrenchOrder { forceFirst, torqueFirst };
  enum class PoseDirection { sensorInBase, baseInSensor };
  enum class QuaternionOrder { xyzw, wxyz };
  /// What the torque is taken about.
  struct WrenchPoint {
    enum class Kind { sensor, base, offset } kind = Kind::sensor;
    Vector3d offset = Vector3d::Zero();  ///< Of Kind::offset: from S's origin, S axes [m].
    bool operator==(const WrenchPoint&) const = default;
  };
  /// A unit as the file states it, and SI units in one of it.
  struct Unit {
    std::string name;  ///< "lbf in"; empty for a number, and for the plain form.
    double si = 1.0;
    bool operator==(const Unit&) const = default;
  };

  WrenchAxes wrenchAxes = WrenchAxes::sensor;
  WrenchPoint wrenchPoint;
  TorqueSign torqueSign = TorqueSign::asForce;
  WrenchOrder wrenchOrder = WrenchOrder::forceFirst;
  std::optional<int> mirroredAxis;  ///< 0, 1, 2: x, y, z of force and torque have the other sign.
  Unit force;
  Unit torque;
  double radPerAngle = 1.0;  ///< Of joint angles and their rates: 1, or pi / 180 for degrees.
  double mPerLength = 1.0;   ///< Of positions and their rates: 1, or 0.001 for millimetres.
  PoseDirection pose = PoseDirection::sensorInBase;
  QuaternionOrder quaternionOrder = QuaternionOrder::xyzw;

  bool operator==(const Conventions&) const = default;
  bool plain() const { return *this == Conventions{}; }
};

}  // namespace heft
