#pragma once
// What would a fault do? The causes of the catalogue as knobs on a recording: each changes the readings as its own
// model says, bias and payload are fitted anew as if nothing were wrong, and what is left over shows whether anybody
// could see it. One step takes a few milliseconds.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/payload/inertial_parameters.h"
#include "core/recording/recording.h"
#include "core/robot/robot_model.h"
#include "core/segmentation/segmentation.h"

namespace heft {

/// The parameter of a cause's simplest form that this motion shows best; position 0: off, 1: some times a realistic
/// size.
struct Knob {
  std::string cause;                    ///< "time_offset"
  std::string parameter, unit;          ///< "delay", "ms"
  double scale = 0.0;                   ///< Shown size at position 1 where it is proportional to the position
  double (*shownAt)(double) = nullptr;  ///< Of the SI value, where it is not
  double full = 0.0;                    ///< SI value at position 1
  double leastSeen = 0.0;               ///< Position from which on this motion shows it; above 1: not at all

  /// Size at a position above 0, in `unit`.
  double shown(double position) const { return shownAt ? shownAt(position * full) : position * scale; }
};

struct WhatIfState {
  Payload payload;
  Payload std;  ///< Wider where more is left over than noise
  /// By how many of its standard deviations without faults each number moved: mass, com, Ixx, Ixy, Ixz, Iyy, Iyz, Izz
  Vector10d moved = Vector10d::Zero();
  VectorXd time;                                    ///< N instants [s], about 50 a second
  Eigen::Matrix<double, 6, Eigen::Dynamic> effect;  ///< What the faults add to the readings [N], [N m]
  Eigen::Matrix<double, 6, Eigen::Dynamic> left;    ///< What bias and payload leave of the readings
  double force = 0, torque = 0;                     ///< Root mean square of `left` a channel [N], [N m]
  bool seen = false;                                ///< More is left over than noise would explain.
  /// The cause, none of those switched on, that would explain most of what is left over.
  struct LookAlike {
    std::size_t knob = 0;
    double position = 0.0;  ///< At which it explains most; may lie outside 0 to 1
    double share = 0.0;     ///< Of what the faults leave over, 0 to 1
  };
  std::optional<LookAlike> lookAlike;  ///< Only where something is seen
};

class WhatIf {
 public:
  /// `segments`: where nothing is touched. Fails for standing poses and where too little free motion is left.
  static Result<WhatIf> make(const Recording& recording, std::shared_ptr<const RobotModel> robot,
                             const std::vector<Segment>& segments, const Progress& progress = {});
  WhatIf(WhatIf&&) noexcept;
  ~WhatIf();

  const std::vector<Knob>& knobs() const;
  /// The faults at these positions, one a knob, together.
  WhatIfState at(const std::vector<double>& positions) const;

 private:
  struct Parts;
  explicit WhatIf(std::unique_ptr<Parts> parts);
  std::unique_ptr<const Parts> parts_;
};

}  // namespace heft
