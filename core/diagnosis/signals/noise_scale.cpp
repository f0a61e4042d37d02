#include "core/diagnosis/signals/noise_scale.h"

#include <utility>

namespace heft::diagnosis {

NoiseScale::NoiseScale(Blocks times) : times_(std::move(times)) {
  // The next smoother motion may be as far from the truth as this one is from it, hardly farther.
  constexpr std::array<double, 4> kShares{1.0 / 64.0, 1.0 / 16.0, 0.25, 1.0};
  for (std::size_t i = 0; i < kShares.size(); ++i) {
    const Blocks power = (1.0 + kShares[i] * times_.array()).matrix();
    const Blocks by = power.cwiseSqrt().cwiseInverse();
    levels_[i] = {kShares[i], by, by.transpose(), power.array().log().matrix().transpose()};
  }
}

}  // namespace heft::diagnosis
