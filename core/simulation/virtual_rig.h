#pragma once
// A guided arm with a tool and a simulated sensor, sample by sample: everything can be tried without a robot.
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/simulation/guided_arm.h"

namespace heft {

struct VirtualRigOptions {
  Payload payload;
  SensorModel sensor;
  SensorMount mount{"panda_link8", {0.0, 0.0, 0.04}, {0.0, 0.0, 0.0}};
  Vector3d gravity{0.0, 0.0, -9.81};  ///< g_B [m/s2]
  double rateHz = 1000.0;
  std::uint64_t seed = 1;                ///< Of noise and bias
  double positionNoise = 1e-5;           ///< encoder noise on q, standard deviation [rad]
  double velocityQuantum = 1e-3;         ///< step of the reported dq [rad/s]; 0: exact
  std::string robotReference = "panda";  ///< What the meta names as robot
};

/// What sensor and controller report at one instant.
struct VirtualSample {
  double time = 0.0;                   ///< [s] since the beginning
  VectorXd q, dq;                      ///< [rad], [rad/s]
  Vector6d wrench = Vector6d::Zero();  ///< F_PSo_S with bias and noise
};

class VirtualRig {
 public:
  /// `robot` must outlive this. Fails for an unphysical payload, an unknown mount link and a senseless rate.
  static Result<VirtualRig> create(const RobotModel& robot, const VirtualRigOptions& options);
  VirtualRig(VirtualRig&&) noexcept;
  VirtualRig& operator=(VirtualRig&&) noexcept;
  ~VirtualRig();

  GuidedArm& arm();
  const GuidedArm& arm() const;
  const VirtualRigOptions& options() const;
  /// One sampling step on.
  const VirtualSample& next();
  /// Another tool from the next sample on; the sensor stays what it is. Fails for an unphysical payload.
  Result<bool> changeTool(const Payload& payload);
  /// As the recording's meta says it; the payload is not in it.
  RecordingMeta meta() const { return metaFor(options()); }
  static RecordingMeta metaFor(const VirtualRigOptions& options);

 private:
  struct Impl;
  explicit VirtualRig(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// A tool like those that people screw to an arm: two boxes of random size and mass, 0.25 to 1.6 kg, in front of the
/// sensor. The same for the same seed.
Payload practiceTool(std::uint64_t seed);

}  // namespace heft
