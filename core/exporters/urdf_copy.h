#pragma once
// The payload in a copy of a robot's own URDF.
#include <string>

#include "core/exporters/flange.h"

namespace heft {

/// `urdf` with the payload as the inertial of `link`, and every other byte as it was: an <inertial> that the link has
/// already is replaced, with a finding that says what it weighed. The payload is turned into the link's axes where the
/// URDF has the link that the sensor is mounted on; else the link is taken for the flange, with a finding. `file` names
/// the URDF in messages. Fails where it is no URDF, has no such link, or lets the link move against the sensor.
Result<std::string> payloadIntoUrdf(const std::string& urdf, const std::string& file, const std::string& link,
                                    const FlangePayload& payload, Findings& findings);

}  // namespace heft
