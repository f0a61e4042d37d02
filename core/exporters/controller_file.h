#pragma once
// What a controller has been told that it carries, read from a file.
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/base/result.h"
#include "core/payload/inertial_parameters.h"

namespace heft {

/// Whether it is a Franka Desk end effector or a Franka tool profile, as controllers keep them: in F axes.
bool isControllerFile(const nlohmann::json& object);

/// Reads a Franka Desk end effector, a Franka tool profile, a result of 'heft estimate' or a bare payload. A result is
/// placed on the flange by its own mount; the others are in F axes as they stand.
/// Fails with one sentence that names `where` if it is none of these, or if a number in it is wrong.
Result<Payload> controllerPayloadFromJson(const nlohmann::json& object, const std::string& where);

}  // namespace heft
