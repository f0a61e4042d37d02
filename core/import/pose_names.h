#pragma once
// Poses whose rotation is no quaternion, by the names of their fields: UR's rotation vector, KUKA's A, B, C, FANUC's W,
// P, R, roll, pitch and yaw, libfranka's O_T_EE and matrices of 4 x 4.
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "core/import/field_name.h"

namespace heft {

/// Fields of one family by their index.
using Family = std::map<int, std::size_t>;

struct SpelledPose {
  enum class Turn { none, vector, abc, rollPitchYaw, matrix };
  Family place;  ///< x, y, z; may be empty.
  Family turn;   ///< As many as the form has numbers, in the order of rotationForms().
  Turn form = Turn::none;
  int score = 7;
  std::string why;                     ///< Empty: the names alone.
  bool millimetresAndDegrees = false;  ///< Where the names state no units.
};

/// Every such pose among the fields of a stream.
std::vector<SpelledPose> spelledPoses(const std::vector<FieldName>& names);

}  // namespace heft
