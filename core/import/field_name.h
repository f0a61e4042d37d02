#pragma once
// Names of columns, datasets and fields as many programs spell them: their words, and the unit that they state.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace heft {

using Words = std::vector<std::string>;

/// "position[panda_joint1]" gives position, panda, joint, 1; "forceX" gives force, x. Lower case.
Words wordsOf(std::string_view name);

struct FieldName {
  Words words;       ///< Without the unit.
  std::string unit;  ///< As in unitSi(): "deg", "nmm"; empty where the name states none.
};

/// "Fx (N)" is fx in n, "q1_deg" is q, 1 in deg, "Time [ms]" is time in ms. What stands in brackets and is no unit
/// ("q1 (filtered)", "position[elbow]") belongs to the words.
FieldName readFieldName(std::string_view name);

/// Which of a message's transforms a field belongs to: "tool0" of "transforms[tool0].transform.rotation.x", "0" where
/// it is not said which. Empty for any other field.
std::string transformOf(std::string_view field);

enum class Quantity { time, angle, angularRate, length, force, torque, acceleration };

/// SI units in one of `unit`; nothing if it is no unit of that quantity.
std::optional<double> unitSi(std::string_view unit, Quantity quantity);

}  // namespace heft
