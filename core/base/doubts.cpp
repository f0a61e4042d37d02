#include "core/base/doubts.h"

#include <algorithm>
#include <array>
#include <utility>

namespace heft {

unsigned doubtedBy(Severity severity, std::string_view code) {
  // A turn of the sensor leaves the weight as it is.
  constexpr std::array<std::pair<std::string_view, unsigned>, 26> kDoubts{
      {{"misfit", kAllNumbers},
       {"known_disagrees", kAllNumbers},
       {"known_centre_disagrees", kCentre | kInertia},
       {"known_inertia_disagrees", kInertia},
       {"prior_contradicts_data", kAllNumbers},
       {"shape_contradicts_data", kAllNumbers},
       {"held_inside_shape", kAllNumbers},
       {"contact_left_out", kAllNumbers},
       {"not_physical", kInertia},
       {"payload_change", kAllNumbers},
       {"conventions_tie", kAllNumbers},
       {"centre_behind_sensor", kCentre | kInertia},
       {"centre_far", kAllNumbers},
       {"weight_large", kAllNumbers},
       {"solver_not_usable", kAllNumbers},
       {"robot_assumed", kAllNumbers},
       {"no_trust", kAllNumbers},
       {"nearly_tied", kAllNumbers},
       {"sensor_turned", kCentre | kInertia},
       {"force_and_torque", kAllNumbers},
       {"turn_unsure", kCentre | kInertia},
       {"low_trust_of_one", kAllNumbers},
       {"low_trust_with", kAllNumbers},
       {"low_trust_without", kAllNumbers},
       {"different_sensors", kAllNumbers},
       {"different_gravity", kAllNumbers}}};
  if (severity == Severity::info) return kNoNumber;
  const auto* const found = std::ranges::find(kDoubts, code, &std::pair<std::string_view, unsigned>::first);
  return found != kDoubts.end() ? found->second : kNoNumber;
}

}  // namespace heft
