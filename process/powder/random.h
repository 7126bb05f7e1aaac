// Random numbers that are the same on every machine: the standard fixes the generator, not the distributions.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <random>

namespace diefill::process {

class Random {
 public:
  explicit Random(std::uint64_t seed) : generator_(seed) {}
  /// Uniform in [-1, 1).
  double symmetric() { return static_cast<double>(generator_() >> 11) * 0x1p-52 - 1; }
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
  std::mt19937_64 generator_;
};

}  // namespace diefill::process
