#pragma once
// What a controller was told that it carries, from the fields in which it repeats it.
#include <optional>
#include <vector>

#include "core/import/streams.h"
#include "core/recording/configured_payload.h"

namespace heft {

/// True for fields that configuredPayload() needs: UR's payload, payload_cog and payload_inertia (RTDE), and m_ee,
/// F_x_Cee, I_ee, m_load, ... of Franka's states, in franka_ros2 inertia_ee.inertia.m and so on.
bool tellsConfiguredPayload(const Stream& stream, std::size_t field);

/// From the first stream that tells a mass. A Franka's end effector and load are put together as the controller does
/// where it does not tell the total.
std::optional<ConfiguredPayload> configuredPayload(const std::vector<Stream>& streams);

}  // namespace heft
