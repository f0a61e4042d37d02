#include "core/base/doubts.h"

#include <algorithm>
#include <array>

namespace heft {

bool doubtsNumbers(Severity severity, std::string_view code) {
  constexpr std::array<std::string_view, 20> kDoubts{"misfit",
                                                     "known_disagrees",
                                                     "prior_contradicts_data",
                                                     "shape_contradicts_data",
                                                     "held_inside_shape",
                                                     "contact_left_out",
                                                     "not_physical",
                                                     "payload_change",
                                                     "conventions_tie",
                                                     "centre_behind_sensor",
                                                     "centre_far",
                                                     "weight_large",
                                                     "solver_not_usable",
                                                     "robot_assumed",
                                                     "no_trust",
                                                     "nearly_tied",
                                                     "sensor_turned",
                                                     "force_and_torque",
                                                     "turn_unsure",
                                                     "low_trust_of_one"};
  return severity != Severity::info && std::ranges::find(kDoubts, code) != kDoubts.end();
}

}  // namespace heft
