#pragma once
// What a map file and --use may name on the left: a column of a recording, a part of it, or a demonstration.
#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace heft {

inline constexpr std::array kParts = {"joints",   "velocities", "position",      "quaternion",
                                      "rotation", "wrench",     "accelerometer", "gyroscope"};
/// A target of "use" that names a part of the file: a demonstration of several.
inline constexpr const char* kDemonstration = "demo";

/// In the language of the program.
std::string partName(std::string_view part);
/// Whether it belongs to one of rotationForms().
bool isRotation(const std::string& column);
/// Which part a column belongs to.
std::string partOf(const std::string& column);
/// An error where `name` is neither column, part nor demonstration; `where`: the file or option that names it.
std::optional<Error> checkTarget(const std::string& name, const std::string& where);

}  // namespace heft
