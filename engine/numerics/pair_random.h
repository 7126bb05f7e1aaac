// Random numbers that belong to a pair of particles and a time step: a counter goes in, bits come out, and no
// state is kept. The number of a pair does not depend on the order of computation or the thread.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace diefill::engine {

/// Philox4x32-10 (Salmon et al. 2011, Parallel random numbers: as easy as 1, 2, 3): 128 random bits of a
/// counter of 128 bits under a key of 64.
inline std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter,
                                           std::array<std::uint32_t, 2> key) {
  constexpr std::uint64_t kFirst = 0xD2511F53, kSecond = 0xCD9E8D57;
  constexpr std::uint32_t kFirstKey = 0x9E3779B9, kSecondKey = 0xBB67AE85;
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t a = kFirst * counter[0], b = kSecond * counter[2];
    counter = {static_cast<std::uint32_t>(b >> 32U) ^ counter[1] ^ key[0], static_cast<std::uint32_t>(b),
               static_cast<std::uint32_t>(a >> 32U) ^ counter[3] ^ key[1], static_cast<std::uint32_t>(a)};
    key[0] += kFirstKey;
    key[1] += kSecondKey;
  }
  return counter;
}

/// The random numbers of one time step.
class PairRandom {
 public:
  PairRandom(std::uint64_t seed, std::uint64_t step)
      : key_{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32U)},
        step_{static_cast<std::uint32_t>(step), static_cast<std::uint32_t>(step >> 32U)} {}

  /// Gaussian number of mean 0 and variance 1 of the particles numbered i and j, the same for j and i: zeta
  /// of Bierwisch 2009, Eq. A.3, by the transform of Box and Muller. Numbers are below 2^32.
  double gaussian(std::uint64_t i, std::uint64_t j) const {
    const auto low = static_cast<std::uint32_t>(i < j ? i : j);
    const auto high = static_cast<std::uint32_t>(i < j ? j : i);
    const auto bits = philox({low, high, step_[0], step_[1]}, key_);
    constexpr double kUnit = 1.0 / 4294967296.0;
    const double radius = (bits[0] + 0.5) * kUnit, turn = bits[1] * kUnit;
    return std::sqrt(-2 * std::log(radius)) * std::cos(2 * std::numbers::pi * turn);
  }

 private:
  std::array<std::uint32_t, 2> key_, step_;
};

}  // namespace diefill::engine
