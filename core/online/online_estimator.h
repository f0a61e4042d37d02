#pragma once
// The estimate while the hand moves: samples go in one by one, a payload with intervals comes out at any time.
//
// The same steps as the batch estimate, in constant memory: samples are smoothed in overlapping windows by the batch's
// own zero-phase filter, which makes them blocks of 20 ms with a delay of about 0.6 s; the blocks are whitened and
// merged into one triangle. Whenever a fifth more blocks have come, the labels (free or contact) and the noise model
// are learned afresh from the blocks kept (the newest 30 s; what is older stays in a triangle of its own). That takes
// some ten milliseconds, so a thread beside does it and what it learned counts 0.2 s later, however fast it was; in
// between the newest blocks are judged by the model learned last.
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/findings.h"
#include "core/base/result.h"
#include "core/estimation/identifiability.h"
#include "core/estimation/linear_problem.h"
#include "core/payload/payload_interval.h"
#include "core/payload/shape.h"
#include "core/payload/stated_payload.h"
#include "core/recording/recording.h"
#include "core/robot/robot_model.h"

namespace heft {

struct OnlineInformation;

/// One instant. Either `q` or `pose` is enough; where both are there, the pose counts.
struct OnlineSample {
  struct Pose {
    std::optional<Vector3d> position;                   ///< p_BSo_B [m]
    Quaterniond orientation = Quaterniond::Identity();  ///< R_BS; need not have unit length
  };
  double time = 0.0;                        ///< [s], rising
  std::optional<std::array<double, 7>> q;   ///< [rad]; the first dof() entries count
  std::optional<std::array<double, 7>> dq;  ///< [rad/s], as the controller reports it
  std::optional<Pose> pose;
  Vector6d wrench = Vector6d::Zero();  ///< F_PSo_S: sensor on payload, force [N], torque [N m]
};

/// How well the motion so far tells a quantity: red, yellow, green.
enum class ExcitationLight { none, coarse, good };
std::string_view toString(ExcitationLight light);  ///< "none", "coarse", "good"

struct Excitation {
  ExcitationLight light = ExcitationLight::none;
  std::string words;  ///< "Mass known to 0.6 %", "Inertia: turn the tool faster"
};

/// What goes on at the newest sample.
enum class Touch {
  unknown,  ///< Too little data, or no data at all for half a second.
  free,
  contact,  ///< Something pushes that the tool's motion does not explain.
};
std::string_view toString(Touch touch);

struct OnlineState {
  double time = 0.0;             ///< Of the newest sample [s]
  std::uint64_t samples = 0;     ///< Taken in since the start
  std::uint64_t dropped = 0;     ///< Not usable: not finite, time not rising, no motion
  double usedDuration = 0.0;     ///< Free motion behind the estimate [s]
  double contactDuration = 0.0;  ///< Left out [s]
  Touch touch = Touch::unknown;
  bool estimated = false;  ///< False until about 1.5 s of free motion: nothing below means anything yet.
  Payload payload, std;
  PayloadInterval interval95;
  Vector6d bias = Vector6d::Zero();  ///< Force [N], torque [N m]
  Identifiability identifiability;
  Excitation mass, com, inertia;
  int tools = 1;                      ///< How many different tools have been seen.
  std::optional<double> toolChanged;  ///< When the present tool replaced another [s]
  double cutoffHz = 0.0;              ///< The motion is smoothed with this.
  Findings findings;                  ///< "tool_changed", "tool_back", "gaps", "samples_dropped", ...
};

struct OnlineOptions {
  bool bias = true;                   ///< Six constant sensor biases are estimated too.
  double cutoffHz = 0.0;              ///< Of the smoothing; 0: 25, 12, 6 or 3 Hz, whichever the data prefer.
  std::optional<Shape> shape;         ///< Prior.
  std::vector<StatedPayload> stated;  ///< Further prior: a scale's mass, CAD numbers.
  bool startAnew = true;              ///< When the tool changed: estimate the new one. Otherwise it counts as contact.
};

/// Not safe to use from several threads at once. Movable.
class OnlineEstimator {
 public:
  /// `meta` gives the sensor's mount and gravity; `robot` (copied) is needed where samples have joints, else null.
  /// Fails if the mount's link is not there, the robot has more than seven joints, or the shape cannot be used.
  static Result<OnlineEstimator> create(const RecordingMeta& meta, const RobotModel* robot,
                                        const OnlineOptions& options = {});
  OnlineEstimator(OnlineEstimator&&) noexcept;
  OnlineEstimator& operator=(OnlineEstimator&&) noexcept;
  ~OnlineEstimator();

  /// Takes a sample in. True about 25 times a second, when state() has news. Bad samples are counted and left out.
  bool add(const OnlineSample& sample);

  /// The end of the data: takes in what the smoothing still held back, and learns once more from everything. Samples
  /// added later are a new stretch.
  void finish();

  /// Forgets everything: another tool, and the user knows it.
  void restart();

  /// Up to date with the last add() that returned true.
  const OnlineState& state() const;

  /// Absent until there is an estimate.
  std::optional<OnlineInformation> information() const;

  /// The free rows behind the estimate without weights or noise model, as one triangle: the linear part of the problem.
  Triangle rows() const;

 private:
  struct Impl;
  explicit OnlineEstimator(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// Row k of a recording as a sample. A recording with more than seven joints keeps its first seven.
OnlineSample sampleOf(const Recording& recording, Eigen::Index row);

}  // namespace heft
