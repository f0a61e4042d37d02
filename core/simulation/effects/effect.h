#pragma once
// Faults of a rig, each as what happens in the world: a spring to an anchor, a mass on a spring, a late packet, a
// rotated mount. Nothing here knows how a fault would be recognised.
//
// The chain, in its physical order; an effect takes part where it belongs:
//   geometry (where S and "down" really are) -> forces on the tool -> the gauges (rotation, gain, crosstalk) ->
//   filters -> transport (delay) -> zero point (bias, drift) -> noise -> converter (clipping, steps) -> the log's rows.
#include <functional>
#include <memory>

#include "core/motion/motion.h"
#include "core/simulation/effects/truth.h"
#include "core/simulation/random.h"
#include "core/simulation/sensor.h"
#include "core/wrench/regressor.h"

namespace heft {

/// Where the sensor and "down" truly are, while the recording's meta states what was meant.
struct Geometry {
  Isometry3d X_LS = Isometry3d::Identity();  ///< S on the mount's parent link
  Vector3d gravity{0.0, 0.0, -9.81};         ///< g_B [m/s2]
};

/// One moment of the world.
struct Instant {
  double time = 0.0;  ///< [s]
  FrameMotion motion;
  Vector3d gravity = Vector3d::Zero();  ///< g_B [m/s2]
  WrenchState state;                    ///< The same motion in S axes
  VectorXd q;                           ///< [rad]; empty where only the tool's pose is known
};

/// What is known of the scene when an effect's place and time are drawn.
struct EffectScene {
  struct Pose {
    double time = 0.0;
    Isometry3d X_BS = Isometry3d::Identity();
  };
  const RobotModel* robot = nullptr;  ///< May be null where the recording has poses.
  Payload payload;
  SensorModel sensor;
  Vector3d gravity{0.0, 0.0, -9.81};  ///< g_B [m/s2]
  double from = 0.0, to = 0.0;        ///< [s]
  double rateHz = 0.0;
  std::vector<Pose> path;  ///< About 20 a second, in time
};

/// Base of all effects. Every hook does nothing unless overridden. An effect has state: use a new one each recording.
class Effect {
 public:
  virtual ~Effect() = default;

  virtual void alterGeometry(Geometry&) {}
  /// What the sensor exerts on the payload beyond the rigid body's wrench, about S's origin in S axes. Called at
  /// `step` [s] apart, in time.
  virtual Vector6d force(const Instant&, double step);
  /// What the gauges make of the true load. Called in time.
  virtual Vector6d gauge(const Vector6d& load) { return load; }
  /// Analog and digital filters; runs over the signal and over the noise.
  virtual void filter(SampledWrench&, double rateHz);
  /// How old [s] the sample is that arrives at `time`; rows come in time.
  virtual double age(double time);
  virtual void shiftZero(const VectorXd& time, SampledWrench& rows);
  virtual void convert(SampledWrench& rows);
  /// What the log makes of the rows, joints and meta.
  virtual void log(Recording&) {}

  const EffectTruth& truth() const { return truth_; }
  EffectTruth& truth() { return truth_; }

 protected:
  void note(std::string name, double value) { truth_.parameters.push_back({std::move(name), {value}}); }
  void note(std::string name, const Eigen::Ref<const VectorXd>& values);

 private:
  EffectTruth truth_;
};

using Effects = std::vector<std::unique_ptr<Effect>>;

struct EffectSetup {
  const EffectScene& scene;
  double size;
  std::string form;
  RandomStream& random;
};

/// A kind of effect; its order in effectKinds() is the order in the chain.
struct EffectKind {
  std::string id;
  std::string unit;     ///< Of SIZE
  std::string meaning;  ///< What SIZE is, one line
  double typical;       ///< A clear size
  double largest;       ///< More is refused.
  bool either;          ///< SIZE may be negative.
  std::vector<std::string> forms;
  std::function<std::unique_ptr<Effect>(const EffectSetup&)> make;
};

const std::vector<EffectKind>& effectKinds();

/// Null if there is none of this name.
const EffectKind* findEffectKind(std::string_view id);

/// The effects in chain order; requests of size 0 are left out. Same seed, same places and times, whatever the size.
Result<Effects> makeEffects(const std::vector<EffectRequest>& requests, std::uint64_t seed, const EffectScene& scene);

/// simulate() with effects that `source` makes for the scene.
using EffectSource = std::function<Result<Effects>(const EffectScene&)>;
Result<Simulated> simulateWith(const RobotModel& robot, const Payload& payload, const SimulateOptions& options,
                               const EffectSource& source, const Progress& progress = {});

}  // namespace heft
