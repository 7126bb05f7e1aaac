// Random numbers that are the same on every machine: the standard fixes the generator, not the distributions.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace diefill::process {

class Random {
 public:
  explicit Random(std::uint64_t seed) : generator_(seed) {}
  /// One of many streams of a seed, such as one for every grain.
  Random(std::uint64_t seed, std::uint64_t stream) : generator_(mixed(seed + mixed(stream))) {}
  /// Uniform in [-1, 1).
  double symmetric() { return static_cast<double>(generator_() >> 11) * 0x1p-52 - 1; }
  /// Three numbers, each normally distributed about 0 with deviation 1 (Box and Muller).
  Eigen::Vector3d normal_vector() {
    Eigen::Vector3d numbers;
    for (Eigen::Index k = 0; k < 3; ++k) {
      const double uniform = 0.5 * (1 - symmetric());  // in (0, 1]
      numbers[k] = std::sqrt(-2 * std::log(uniform)) * std::cos(std::numbers::pi * symmetric());
    }
    return numbers;
  }
  /// Uniform on the unit sphere of N dimensions, by rejection from the cube.
  template <int N>
  Eigen::Matrix<double, N, 1> direction() {
    for (;;) {
      Eigen::Matrix<double, N, 1> point;
      for (int k = 0; k < N; ++k) point[k] = symmetric();
      const double length = point.norm();
      if (length > 0.1 && length <= 1) return point / length;
    }
  }

 private:
  /// Finaliser of SplitMix64 (Steele et al. 2014): neighbouring numbers become unlike.
  static std::uint64_t mixed(std::uint64_t number) {
    number += 0x9e3779b97f4a7c15ULL;
    number = (number ^ (number >> 30)) * 0xbf58476d1ce4e5b9ULL;
    number = (number ^ (number >> 27)) * 0x94d049bb133111ebULL;
    return number ^ (number >> 31);
  }

  std::mt19937_64 generator_;
};

}  // namespace diefill::process
