#pragma once
// Poses whose rotation is no quaternion, by the names of their fields: UR's rotation vector, KUKA's A, B, C, FANUC's W,
// P, R, roll, pitch and yaw, libfranka's O_T_EE and matrices of 4 x 4.
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/import/field_name.h"

namespace heft {

/// Fields of one family by their index.
using Family = std::map<int, std::size_t>;

struct SpelledPose {
  enum class Turn { none, vector, abc, rollPitchYaw, matrix, quaternion };
  Family place;  ///< x, y, z; may be empty.
  Family turn;   ///< As many as the form has numbers, in the order of rotationForms().
  Turn form = Turn::none;
  int score = 7;
  std::string why;                     ///< Empty: the names alone.
  bool millimetresAndDegrees = false;  ///< Where the names state no units.
};

/// ABB's "X, Y, Z, Q1, Q2, Q3, Q4" where `fields` are called Q1 to Q4 (`family`): four numbers of length one beside a
/// place are a quaternion, its real part first, and no joints. Told by the values; nothing without them.
std::optional<SpelledPose> abbPose(const std::vector<FieldName>& names, const std::vector<std::vector<double>>& values,
                                   const Words& family, const Family& fields);

/// Every such pose among the fields of a stream.
std::vector<SpelledPose> spelledPoses(const std::vector<FieldName>& names);

}  // namespace heft
