#pragma once
// What the numbers of a recording mean where they are not in the plain form that Heft works in: axes, signs, units and
// orders of the wrench, and the direction and order of the pose. Stated in meta and map files, undone by every reader.
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/math/rigid.h"

namespace heft {

constexpr double kStandardGravity = 9.80665;  ///< [m/s2], exact by definition: what one g means.

/// The plain form is what the default values say. A recording in other conventions is w = T(plain): first its columns
/// were mirrored, turned and moved to another point, then its torque's sign was turned, then both were scaled, then
/// force and torque changed places. In formulas, with M = diag(+-1) the mirror and d the offset from S's origin:
/// f' = R M f and tau' = R M tau + a x f', where R = R_BS for base axes, else 1, and a = -R d about another point of
/// the sensor, a = p_BSo_B (in S axes R_BS^T p_BSo_B) about the base's origin. The wrench's sign
/// (RecordingMeta::wrenchSign) commutes with all of it.
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
  double radPerAngle = 1.0;  ///< Of joint angles, their rates and angular velocities: 1, or pi / 180 for degrees.
  double mPerLength = 1.0;   ///< Of positions and their rates: 1, or 0.001 for millimetres.
  double mPerS2PerAcceleration = 1.0;  ///< Of an accelerometer: 1, or 9.80665 where it reads in g.
  PoseDirection pose = PoseDirection::sensorInBase;
  QuaternionOrder quaternionOrder = QuaternionOrder::xyzw;

  bool operator==(const Conventions&) const = default;
  bool plain() const { return *this == Conventions{}; }
  /// True where only the sensor's pose in B brings the wrench to the plain form.
  bool needPose() const { return wrenchAxes == WrenchAxes::base || wrenchPoint.kind == WrenchPoint::Kind::base; }
};

/// What a file states. Only these keys count: others may stand in another file.
struct StatedConventions {
  Conventions values;
  std::set<std::string> keys;  ///< "torque_sign", "pose", ...
  bool operator==(const StatedConventions&) const = default;
};

/// The keys of meta and map files: within their object `sensor`, or at the top.
std::vector<std::string> conventionKeys(bool inSensor);

/// The units that can be stated by name; the first one is SI.
std::span<const Conventions::Unit> forceUnits();
std::span<const Conventions::Unit> torqueUnits();

/// What `root`, a whole meta or map file, states. The error names `file` and the key's path.
Result<StatedConventions> readConventions(const nlohmann::json& root, const std::string& file);

/// `conventions` with what is stated on top.
void takeOver(const StatedConventions& stated, Conventions& conventions);

/// {KEY: VALUE} of all that is not plain.
nlohmann::json toJson(const Conventions& conventions);

/// The same as a patch of a setup file: {"sensor": {KEY: VALUE}, "pose": ...}.
nlohmann::json metaPatch(const Conventions& conventions);

/// A patch of a setup file that says `before` and is to say `after`; null takes a key away.
nlohmann::json metaPatch(const Conventions& before, const Conventions& after);

/// What a map file says: all keys that are stated, plain ones too.
nlohmann::json metaPatch(const StatedConventions& stated);

}  // namespace heft
