#pragma once
// Lowest and highest value of any segment of a long series, fast enough to redraw 600,000 samples on every wheel step.
#include <cstddef>
#include <vector>

namespace heft {

struct MinMax {
  double lowest = 0.0, highest = 0.0;
};

/// Keeps the values and, over them, levels of extremes of 16, 64, 256 ... samples, all with seven digits: half the
/// memory, and finer than any screen. NaN counts as absent.
class MinMaxPyramid {
 public:
  /// Samples in a block of the lowest level.
  static constexpr std::size_t kBase = 16;

  MinMaxPyramid() = default;
  explicit MinMaxPyramid(const std::vector<double>& values);

  std::size_t size() const { return values_.size(); }
  double operator[](std::size_t i) const { return values_[i]; }

  /// Extremes of samples [from, to). Both NaN if the segment contains no number.
  MinMax range(std::size_t from, std::size_t to) const;

 private:
  static constexpr std::size_t kFactor = 4;
  struct Extremes {
    float lowest, highest;
  };

  static void include(Extremes& extremes, const Extremes& other);

  std::vector<float> values_;
  std::vector<std::vector<Extremes>> levels_;
};

}  // namespace heft
