#pragma once
// Random numbers for intervals: the same on every platform and in every run.
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <utility>

namespace heft {

/// Always the same stream: its bits, what is uniform in (0, 1), and standard normal numbers (Box and Muller 1958).
class NormalDraws {
 public:
  std::uint64_t bits() { return random_(); }
  double uniform() { return (static_cast<double>(bits() >> 11) + 0.5) * 0x1.0p-53; }
  std::pair<double, double> normalPair() {
    const double radius = std::sqrt(-2.0 * std::log(uniform()));
    const double angle = 2.0 * std::numbers::pi * uniform();
    return {radius * std::cos(angle), radius * std::sin(angle)};
  }

 private:
  std::mt19937_64 random_{42};
};

}  // namespace heft
