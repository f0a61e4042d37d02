#pragma once
// What the robot's controller was told that it carries, where a recording tells it.
#include <optional>
#include <string>
#include <string_view>

#include "core/payload/inertial_parameters.h"

namespace heft {

/// In the axes of the flange F, all three parts about its origin or the centre of mass as in Payload. The controller
/// means everything beyond the flange: the sensor and its adapters, too, which an estimate does not contain.
struct ConfiguredPayload {
  PartialPayload payload;  ///< com = p_FPcm_F [m], inertia about the centre of mass [kg m2], F axes
  std::string source;      ///< "payload, payload_cog": the fields it was read from
  std::string flange;      ///< How the name ends of the link whose axes F are: "tool0" of a UR, "link8" of a Franka
  bool changed = false;    ///< It was set anew while recording; the value is the one that held longest.
};

/// True for links that are a flange by their name ("panda_link8", "tool0", "flange", also with an arm's prefix), and
/// for no name at all.
bool isFlangeName(std::string_view link);

}  // namespace heft
