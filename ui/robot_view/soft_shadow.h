#pragma once
// The shadow that the arm throws on the floor: points of its surface splatted on a small grid and blurred, the more the
// higher they are. Cheap enough for software rendering, where a shadow map is not.
#include <cstdint>
#include <vector>

#include "core/math/rigid.h"

namespace heft {

class SoftShadow {
 public:
  static constexpr int kCells = 128;
  static constexpr double kExtent = 2.6;  ///< Edge of the square floor patch about the base [m].

  void clear();
  /// A point of the arm's surface, B axes [m]; z is the height above the floor.
  void add(const Vector3d& point);
  /// Darkness of every cell, row by row from (-x, -y); 0 none, 255 full.
  const std::vector<std::uint8_t>& finish();

 private:
  static constexpr int kLayers = 3;
  std::vector<float> layers_[kLayers];
  std::vector<std::uint8_t> result_;
};

}  // namespace heft
