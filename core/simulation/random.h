#pragma once
// Random numbers that are the same on every platform: the standard library leaves its distributions open.
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace heft {

/// What a stream of random numbers is for. Each purpose (and channel) has its own stream, so that changing one option
/// does not reshuffle the others.
enum class RandomPurpose : std::uint64_t { motion = 1, tremor, contact, bias, white, coloured, encoder, walk, effect };

/// xoshiro256++ (Blackman and Vigna 2019), seeded through splitmix64; normal deviates by Marsaglia's polar method.
/// Each draw is a statement of its own, or one of a list in braces: arguments of a call and terms of a sum are worked
/// out in an order that compilers choose, and a seed would mean something else with each.
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, RandomPurpose purpose, std::uint64_t channel = 0) {
    std::uint64_t x = mix(mix(mix(seed) ^ static_cast<std::uint64_t>(purpose)) ^ channel);
    for (auto& word : state_) {
      x += 0x9e3779b97f4a7c15ull;
      word = mix(x);
    }
  }

  std::uint64_t bits() {
    const std::uint64_t result = std::rotl(state_[0] + state_[3], 23) + state_[0];
    const std::uint64_t shifted = state_[1] << 17;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= shifted;
    state_[3] = std::rotl(state_[3], 45);
    return result;
  }

  /// In [0, 1), 53 bits.
  double uniform() { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }
  double uniform(double from, double to) { return from + (to - from) * uniform(); }
  bool chance(double probability) { return uniform() < probability; }

  /// Mean 0, standard deviation 1.
  double normal() {
    if (hasSpare_) {
      hasSpare_ = false;
      return spare_;
    }
    double u, v, s;
    do {
      u = uniform(-1.0, 1.0);
      v = uniform(-1.0, 1.0);
      s = u * u + v * v;
    } while (s >= 1.0 || s == 0.0);
    const double factor = std::sqrt(-2.0 * std::log(s) / s);
    spare_ = v * factor;
    hasSpare_ = true;
    return u * factor;
  }

 private:
  static std::uint64_t mix(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
    return (x ^ (x >> 31)) + 0x9e3779b97f4a7c15ull;
  }

  std::array<std::uint64_t, 4> state_{};
  double spare_ = 0.0;
  bool hasSpare_ = false;
};

}  // namespace heft
